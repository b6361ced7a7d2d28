//! Change of a sensitivity between two calibrations, with its own uncertainty.

use super::budget::Basis;
use super::mountings::Mountings;
use super::particulars::Particulars;
use calib_core::point::PointResult;
use calib_core::point_state::PointState;
use calib_protocol::record::Record;

/// Relative expanded uncertainty (95.45 %) of the change from one calibration to another at a frequency, without
/// what both share: with one reference in one instrument the reference's calibration, the conditioner's gain and
/// the ratio of the converters. None where a record has no valid point within 1 % of it, or no budget.
///
/// The temperature is that of the record's labels.
///
/// # Source
/// GUM 5.2.2; rows of ISO 16063-21, Table A.1.
pub fn expanded_uncertainty_of_change_rel(
    before: &Record,
    now: &Record,
    frequency_hz: f64,
) -> Option<f64> {
    let nobody = Particulars::default();
    let once = Mountings::ONCE;
    let basis = |record| Basis::new(record, &nobody, &once);
    let (then, own) = (basis(before), basis(now));
    let (then_at, at) = (point(before, frequency_hz)?, point(now, frequency_hz)?);
    let of_ratio = own.of_change(at, &then, then_at)?;
    Some(of_ratio.expanded_rel)
}

/// Relative expanded uncertainty that a certificate of a record states at a frequency, for the chain as it was measured.
/// None where the record has no valid point within 1 % of it, or no budget.
pub fn certified_uncertainty_rel(record: &Record, frequency_hz: f64) -> Option<f64> {
    let (nobody, once) = (Particulars::default(), Mountings::ONCE);
    let stated = Basis::new(record, &nobody, &once).uncertainty(point(record, frequency_hz)?)?;
    Some(stated.expanded_rel)
}

/// The record with U of every valid point as a certificate of it states that.
pub fn with_certified_uncertainty(record: &Record, particulars: &Particulars) -> Record {
    let once = Mountings::ONCE;
    let basis = Basis::new(record, particulars, &once);
    let mut certified = record.clone();
    for point in &mut certified.points {
        let stated = basis
            .uncertainty(point)
            .filter(|_| point.state == PointState::Valid);
        if let Some(stated) = stated {
            point.expanded_uncertainty_rel = stated.expanded_rel as f32;
            point.expanded_uncertainty_phase_rad = stated.expanded_phase_rad as f32;
        }
    }
    certified
}

/// The first valid point of the frequency.
fn point(record: &Record, frequency_hz: f64) -> Option<&PointResult> {
    record.points.iter().find(|point| {
        let near = (f64::from(point.spec.frequency_hz) / frequency_hz - 1.0).abs() <= 0.01;
        near && point.state == PointState::Valid
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use calib_record::sample::{record, text};

    /// In one instrument: rows 8, 10, 11 (0.05, 0.15, and for 1.1 K 0.132 %) and the scatter of 0.015 % count twice. In another,
    /// all of U = 0.666 %.
    #[test]
    fn what_two_calibrations_share_is_not_in_their_difference() {
        let (before, mut now) = (record(&[160.0]), record(&[160.0]));
        let changed = |now: &Record| {
            expanded_uncertainty_of_change_rel(&before, now, 160.0).expect("both have it")
        };
        let rows = (0.05_f64.powi(2) + 0.15_f64.powi(2) + 0.132_f64.powi(2)) / 3.0;
        let u_percent = (2.0 * (rows + 0.015_f64.powi(2))).sqrt();
        assert!((changed(&now) / (0.02 * u_percent) - 1.0).abs() < 1e-3);
        let whole = rows + (0.25_f64.powi(2) + 0.2_f64.powi(2)) / 3.0 + 0.0625 + 0.015_f64.powi(2);
        let apart = 0.02 * (2.0 * whole).sqrt();
        now.settings.reference.certificate = text("NMI 2026-0001");
        assert!((changed(&now) / apart - 1.0).abs() < 1e-3);
        now = record(&[160.0]);
        now.head.instrument_serial = text("CAL-0043");
        assert!((changed(&now) / apart - 1.0).abs() < 1e-3);
        assert_eq!(
            expanded_uncertainty_of_change_rel(&before, &now, 500.0),
            None
        );
    }
}
