//! Linearity from a list of one frequency at several levels.

use calib_core::point::PointResult;

/// Largest deviation between two levels at one frequency.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Linearity {
    /// Frequency, Hz.
    pub(super) frequency_hz: f64,
    /// Difference of the largest and the smallest sensitivity over their mean.
    pub(super) deviation_rel: f64,
}

/// The worst frequency of those measured at more than one level; none when no
/// frequency was. It bounds the voltage linearity (Table 3) from above: the
/// transducers' own non-linearity is in it.
pub(super) fn worst(points: &[&PointResult]) -> Option<Linearity> {
    let found = points.iter().filter_map(|first| {
        let same: Vec<&&PointResult> = points
            .iter()
            .filter(|point| point.spec.frequency_hz == first.spec.frequency_hz)
            .collect();
        let level = first.spec.acceleration_rms_ms2;
        let varied = same
            .iter()
            .any(|point| point.spec.acceleration_rms_ms2 != level);
        let values = || {
            same.iter()
                .map(|point| f64::from(point.sensitivity_v_per_ms2))
        };
        let (low, high) = (
            values().fold(f64::INFINITY, f64::min),
            values().fold(0.0, f64::max),
        );
        varied.then(|| Linearity {
            frequency_hz: f64::from(first.spec.frequency_hz),
            deviation_rel: 2.0 * (high - low) / (high + low),
        })
    });
    found.max_by(|a, b| a.deviation_rel.total_cmp(&b.deviation_rel))
}
