//! Point lists from the preferred series of ISO 16063-21, 5.1.

use crate::control::limits::check_level;
use crate::point::PointSpec;
use crate::point_state::Reason;
use crate::polarity::wrap;
use crate::preferred::{PREFERRED_HZ, REFERENCE_HZ};
use crate::settings::Settings;
use crate::tone::Tone;
use core::f32::consts::SQRT_2;
use heapless::Vec;

/// Default range of a field calibration, Hz.
const DEFAULT_RANGE_HZ: (f32, f32) = (20.0, 10_000.0);

/// Default level, m/s2 r.m.s.
pub const DEFAULT_LEVEL_RMS_MS2: f32 = 10.0;

/// A list of points; room for the whole preferred series.
pub type PointList = Vec<PointSpec, { PREFERRED_HZ.len() }>;

/// Every preferred frequency of a range at one level, the reference frequency
/// first, the others rising.
///
/// The reference frequency is 160 Hz, or 80 Hz where the range does not reach
/// 160 Hz; a range without either begins with its lowest frequency.
pub fn preferred_points(low_hz: f32, high_hz: f32, acceleration_rms_ms2: f32) -> PointList {
    let inside = |frequency_hz: f32| (low_hz..=high_hz).contains(&frequency_hz);
    let first = REFERENCE_HZ.into_iter().find(|&hz| inside(hz));
    let others = PREFERRED_HZ
        .into_iter()
        .filter(|&hz| inside(hz) && Some(hz) != first);
    let spec = |frequency_hz| PointSpec {
        frequency_hz,
        acceleration_rms_ms2,
    };
    let mut list = PointList::new();
    for point in first.into_iter().chain(others).map(spec) {
        // There is room for the whole series.
        let _ = list.push(point);
    }
    list
}

/// Whether a point can be measured at all, by what is known before anything moves.
///
/// # Errors
/// [`Reason::FrequencyUnavailable`] without a tone of the sample clock or a calibration of the reference there, and
/// those of [`check_level`].
pub fn possible(spec: PointSpec, settings: &Settings, sample_rate_hz: f32) -> Result<(), Reason> {
    let none = Reason::FrequencyUnavailable;
    let tone = Tone::nearest(spec.frequency_hz, sample_rate_hz).ok_or(none)?;
    let frequency_hz = tone.frequency_hz(sample_rate_hz);
    settings.reference.at(frequency_hz).ok_or(none)?;
    let peak_ms2 = SQRT_2 * spec.acceleration_rms_ms2;
    check_level(&settings.limits.under_ceilings(), frequency_hz, peak_ms2)
}

/// A sensitivity relative to that at the reference point (5.3).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deviation {
    /// Relative deviation of the magnitude, 1.
    pub rel: f32,
    /// Deviation in decibels.
    pub db: f32,
    /// Deviation of the phase, rad, in (-pi, pi].
    pub phase_rad: f32,
}

/// Deviation of a magnitude and phase from those at the reference point; `None`
/// unless both magnitudes are positive.
pub fn deviation(
    (magnitude, phase_rad): (f32, f32),
    (reference_magnitude, reference_phase_rad): (f32, f32),
) -> Option<Deviation> {
    let usable = magnitude > 0.0 && reference_magnitude > 0.0;
    usable.then(|| {
        let ratio = magnitude / reference_magnitude;
        Deviation {
            rel: (magnitude - reference_magnitude) / reference_magnitude,
            db: 20.0 * libm::log10f(ratio),
            phase_rad: wrap(phase_rad - reference_phase_rad),
        }
    })
}

/// The list the button starts: 20 Hz to 10 kHz at 10 m/s2.
pub fn default_points() -> PointList {
    let (low_hz, high_hz) = DEFAULT_RANGE_HZ;
    preferred_points(low_hz, high_hz, DEFAULT_LEVEL_RMS_MS2)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::preferred::FEWEST_POINTS;

    #[test]
    fn what_an_instrument_cannot_measure_is_known_before() {
        let settings = Settings::field_calibrator();
        let reason = |frequency_hz, acceleration_rms_ms2| {
            let spec = PointSpec {
                frequency_hz,
                acceleration_rms_ms2,
            };
            possible(spec, &settings, 50_000.0).err()
        };
        assert_eq!(reason(160.0, 10.0), None);
        // Its reference is calibrated from 5 Hz to 10 kHz.
        assert_eq!(reason(4.0, 1.0), Some(Reason::FrequencyUnavailable));
        assert_eq!(reason(12_500.0, 1.0), Some(Reason::FrequencyUnavailable));
        assert_eq!(reason(30_000.0, 1.0), Some(Reason::FrequencyUnavailable));
        // By hand: 212 m/s2 peak of 200; at 20 Hz 100 m/s2 r.m.s. are 1.13 m/s of 1, and 60 m/s2 5.4 mm of 5.
        assert_eq!(reason(1000.0, 150.0), Some(Reason::AccelerationLimit));
        assert_eq!(reason(20.0, 100.0), Some(Reason::VelocityLimit));
        assert_eq!(reason(20.0, 60.0), Some(Reason::DisplacementLimit));
        assert_eq!(reason(20.0, 50.0), None);
        assert_eq!(reason(160.0, f32::NAN), Some(Reason::AccelerationLimit));
    }

    #[test]
    fn the_default_list_begins_at_the_reference_point_and_covers_the_range() {
        let list = default_points();
        let frequencies: std::vec::Vec<f32> = list.iter().map(|p| p.frequency_hz).collect();
        // 20 Hz to 10 kHz are 27 one-third-octave steps: 28 frequencies.
        assert_eq!(frequencies.len(), 28);
        assert_eq!(frequencies[..3], [160.0, 20.0, 25.0]);
        assert_eq!(frequencies[27], 10_000.0);
        assert!(frequencies[1..].is_sorted());
        assert!(list.iter().all(|p| p.acceleration_rms_ms2 == 10.0));
        assert!(list.len() >= FEWEST_POINTS);
    }

    #[test]
    fn the_second_choice_is_taken_where_the_first_is_out_of_range() {
        assert_eq!(preferred_points(5.0, 100.0, 1.0)[0].frequency_hz, 80.0);
        assert_eq!(preferred_points(200.0, 400.0, 1.0)[0].frequency_hz, 200.0);
        assert!(preferred_points(300.0, 310.0, 1.0).is_empty());
    }

    #[test]
    fn deviations_are_stated_in_every_way() {
        // 5 % more is 20 lg 1.05 = 0.42379 dB.
        let deviation = deviation((1.05, -3.0), (1.0, 3.0)).expect("positive");
        assert!((deviation.rel - 0.05).abs() < 1.0e-7);
        assert!((deviation.db - 0.423_785_98).abs() < 1.0e-6);
        assert!((deviation.phase_rad - 0.283_185_3).abs() < 1.0e-6);
        assert_eq!(super::deviation((0.0, 0.0), (1.0, 0.0)), None);
    }
}
