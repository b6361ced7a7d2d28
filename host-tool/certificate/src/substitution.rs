//! Substitution: a standard and then the device in one channel of one instrument.
//!
//! # Equation
//! `S2 = S1 X2 / X1`: S1 from the standard's own certificate, X2 / X1 the ratio of what the instrument found for
//! device and standard. In that ratio the calibration of the instrument's reference and its drift, the gain and the ratio
//! of the channels (rows 1, 10, 2, 3 of Table A.1) cancel; every other row counts twice, and U of S1 is added.
//!
//! # Source
//! ISO 16063-21:2003, 4.5 and clause 6; GUM 5.2.2.

use super::budget::Basis;
use super::mountings::Mountings;
use super::particulars::Particulars;
use calib_core::point::PointResult;
use calib_core::verdict::Verdict;
use calib_files::{Error, Result};
use calib_protocol::record::Record;
use schemars::JsonSchema;
use serde::Serialize;

/// A frequency of the standard's certificate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StandardPoint {
    /// Frequency, Hz.
    pub frequency_hz: f64,
    /// Sensitivity, V/(m/s2).
    pub sensitivity_v_per_ms2: f64,
    /// Its relative expanded uncertainty, k = 2.
    pub expanded_uncertainty_rel: f64,
}

/// Result of a substitution at one point.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Substituted {
    /// Nominal frequency, Hz.
    pub frequency_hz: f32,
    /// Set acceleration, m/s2 r.m.s.
    pub set_acceleration_rms_ms2: f32,
    /// Sensitivity of the standard by its certificate, V/(m/s2).
    pub standard_v_per_ms2: f64,
    /// Output of the device over that of the standard.
    pub ratio: f64,
    /// Relative expanded uncertainty of that ratio.
    pub expanded_uncertainty_ratio_rel: f64,
    /// Sensitivity of the device, V/(m/s2).
    pub sensitivity_v_per_ms2: f64,
    /// Its relative expanded uncertainty, k = 2.
    pub expanded_uncertainty_rel: f64,
}

/// Results at every point that is valid in both records and stated by the standard's certificate (within 1 %).
///
/// # Errors
/// [`Error::Input`] when the records are not of one instrument and settings, of one device, or share no point with
/// the certificate.
pub fn substitute(
    standard: &Record,
    device: &Record,
    certified: &[StandardPoint],
) -> Result<Vec<Substituted>> {
    belong_together(standard, device)?;
    let (nobody, once) = (Particulars::default(), Mountings::ONCE);
    let bases = [standard, device].map(|record| Basis::new(record, &nobody, &once));
    let results: Vec<Substituted> = device
        .points
        .iter()
        .filter_map(|point| of_point(&bases, standard, point, certified))
        .collect();
    match results.is_empty() {
        false => Ok(results),
        true => Err(Error::input(
            format!("records {} and {}", standard.head.id, device.head.id),
            "have no valid point in common that the certificate of the standard states",
            "measure both at frequencies of its table",
        )),
    }
}

fn of_point(
    [of_standard, of_device]: &[Basis<'_>; 2],
    standard: &Record,
    point: &PointResult,
    certified: &[StandardPoint],
) -> Option<Substituted> {
    let near = |hz: f64| (f64::from(point.spec.frequency_hz) / hz - 1.0).abs() <= 0.01;
    let known = certified.iter().find(|known| near(known.frequency_hz))?;
    let before = standard.points.iter().find(|p| p.spec == point.spec)?;
    let valid = [point, before].iter().all(|p| p.verdict == Verdict::Pass);
    let of_ratio = of_device.of_substitution(point, of_standard, before)?;
    let ratio = f64::from(point.sensitivity_v_per_ms2) / f64::from(before.sensitivity_v_per_ms2);
    (valid && ratio.is_finite()).then(|| Substituted {
        frequency_hz: point.spec.frequency_hz,
        set_acceleration_rms_ms2: point.spec.acceleration_rms_ms2,
        standard_v_per_ms2: known.sensitivity_v_per_ms2,
        ratio,
        expanded_uncertainty_ratio_rel: of_ratio.expanded_rel,
        sensitivity_v_per_ms2: known.sensitivity_v_per_ms2 * ratio,
        expanded_uncertainty_rel: known.expanded_uncertainty_rel.hypot(of_ratio.expanded_rel),
    })
}

fn belong_together(standard: &Record, device: &Record) -> Result<()> {
    let serial = |record: &Record| record.head.labels.dut_serial.trim().to_owned();
    let problem = match () {
        () if standard.head.instrument_serial != device.head.instrument_serial => {
            "were measured with two instruments"
        }
        () if standard.settings != device.settings => "were measured with other settings",
        () if serial(standard) == serial(device) => "are of one device",
        () => return Ok(()),
    };
    Err(Error::input(
        format!("records {} and {}", standard.head.id, device.head.id),
        problem,
        "`calib run --substitute` measures standard and device one after the other",
    ))
}

#[cfg(test)]
mod tests {
    use super::*;
    use calib_record::sample::{record, text};

    const CERTIFIED: [StandardPoint; 1] = [StandardPoint {
        frequency_hz: 160.0,
        sensitivity_v_per_ms2: 0.0102,
        expanded_uncertainty_rel: 0.004,
    }];

    fn pair() -> (Record, Record) {
        let mut standard = record(&[160.0, 1000.0]);
        standard.head.labels.dut_serial = text("CHK-1");
        let mut device = record(&[160.0, 1000.0]);
        device.head.id += 1;
        for point in &mut device.points {
            point.sensitivity_v_per_ms2 *= 0.98;
        }
        (standard, device)
    }

    /// Rows 8 and 11 (0.05 and, for 1.1 K, 0.132 %) and the scatter of 0.015 % twice: U = 0.234 % of the ratio, and 0.4 % of the
    /// standard: 0.464 %. An instrument that reads both 3 % high gives the same.
    #[test]
    fn what_the_instrument_does_to_both_cancels() {
        for gain in [1.0, 1.03] {
            let (mut standard, mut device) = pair();
            for point in standard.points.iter_mut().chain(&mut device.points) {
                point.sensitivity_v_per_ms2 *= gain;
            }
            let found = substitute(&standard, &device, &CERTIFIED).expect("a pair");
            assert_eq!(found.len(), 1, "1 kHz is not certified");
            // f32 of the records.
            assert!((found[0].sensitivity_v_per_ms2 / (0.0102 * 0.98) - 1.0).abs() < 5e-7);
            let rows = (0.05_f64.powi(2) + 0.132_f64.powi(2)) / 3.0 + 0.015_f64.powi(2);
            let ratio = 0.02 * (2.0 * rows).sqrt();
            let stated = found[0].expanded_uncertainty_ratio_rel;
            assert!((stated / ratio - 1.0).abs() < 1e-3, "{stated} {ratio}");
            let whole = found[0].expanded_uncertainty_rel;
            assert!((whole / ratio.hypot(0.004) - 1.0).abs() < 1e-3, "{whole}");
        }
    }

    #[test]
    fn records_that_are_no_pair_are_refused() {
        let refused = |change: fn(&mut Record), words: &str| {
            let (standard, mut device) = pair();
            change(&mut device);
            let error = substitute(&standard, &device, &CERTIFIED).expect_err(words);
            assert!(error.to_string().contains(words), "{error}");
        };
        refused(|r| r.head.instrument_serial.clear(), "two instruments");
        refused(|r| r.settings.blocks += 1, "other settings");
        refused(|r| r.head.labels.dut_serial = text("CHK-1"), "one device");
        refused(|r| r.points.clear(), "no valid point");
    }
}
