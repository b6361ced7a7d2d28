//! How far emulated records lie from measured rows.

use super::measured::Row;
use calib_gap::{Distance, Group};
use calib_twin::dataset::{Harmonic, Point};
use std::collections::BTreeMap;
use std::f64::consts::SQRT_2;

/// One row with what the firmware recorded of it without and with an effect.
pub(super) struct Compared<'a> {
    pub(super) measured: &'a Row,
    pub(super) before: &'a Point,
    pub(super) after: &'a Point,
}

/// Relative errors of all rows that have an observable.
type Errors = Vec<f64>;
/// How they are formed.
type Measure = fn(&[(&Row, &Point)]) -> Errors;

/// Distances of every observable that both sides have.
pub(super) fn by_observable(rows: &[Compared<'_>]) -> BTreeMap<Group, Distance> {
    let measures = [
        (Group::Ratio, ratio_errors as Measure),
        (Group::Drive, drive_errors),
        (Group::RefHarmonics, |rows| harmonic_errors(rows, "ref")),
        (Group::DutHarmonics, |rows| harmonic_errors(rows, "dut")),
        (Group::Dc, dc_errors),
    ];
    let before: Vec<_> = rows.iter().map(|r| (r.measured, r.before)).collect();
    let after: Vec<_> = rows.iter().map(|r| (r.measured, r.after)).collect();
    let mut all = BTreeMap::new();
    for (group, measure) in measures {
        let (b, a) = (measure(&before), measure(&after));
        if !b.is_empty() {
            all.insert(
                group,
                Distance {
                    before_rel: rms(&b),
                    after_rel: rms(&a),
                    rows: b.len(),
                },
            );
        }
    }
    all
}

/// Ratio and drive as one figure.
pub(super) fn overall(by_observable: &BTreeMap<Group, Distance>) -> Option<Distance> {
    let both: Vec<&Distance> = [Group::Ratio, Group::Drive]
        .iter()
        .filter_map(|group| by_observable.get(group))
        .collect();
    let rows: usize = both.iter().map(|d| d.rows).sum();
    let pooled = |of: fn(&Distance) -> f64| {
        let squares: f64 = both.iter().map(|d| d.rows as f64 * of(d).powi(2)).sum();
        (squares / rows as f64).sqrt()
    };
    let most = both.iter().map(|d| d.rows).max()?;
    Some(Distance {
        before_rel: pooled(|d| d.before_rel),
        after_rel: pooled(|d| d.after_rel),
        rows: most,
    })
}

fn rms(errors: &[f64]) -> f64 {
    (errors.iter().map(|e| e * e).sum::<f64>() / errors.len() as f64).sqrt()
}

/// Length of the relative error of the complex ratio, a constant gain apart.
fn ratio_errors(rows: &[(&Row, &Point)]) -> Errors {
    let pair = |(measured, emulated): &(&Row, &Point)| {
        let magnitude = measured.ratio()? * emulated.ref_v? / emulated.dut_v?;
        let turn_deg = match measured.get("dut_deg") {
            Some(measured_deg) => measured_deg - emulated.dut_deg?,
            None => 0.0,
        };
        let turn_deg = (turn_deg + 180.0).rem_euclid(360.0) - 180.0;
        Some((magnitude.ln(), turn_deg.to_radians()))
    };
    let pairs: Vec<(f64, f64)> = rows.iter().filter_map(pair).collect();
    let mean = pairs.iter().map(|p| p.0).sum::<f64>() / pairs.len().max(1) as f64;
    pairs.iter().map(|p| (p.0 - mean).hypot(p.1)).collect()
}

/// Relative error of the magnitude of reference over coil voltage.
fn drive_errors(rows: &[(&Row, &Point)]) -> Errors {
    let error = |(measured, emulated): &(&Row, &Point)| {
        let drive = measured.get("ref_v")? / measured.get("coil_v")?;
        Some((drive * emulated.coil_v? / emulated.ref_v?).ln())
    };
    rows.iter().filter_map(error).collect()
}

/// Distance of the relative harmonics 2 to 5 of a channel.
fn harmonic_errors(rows: &[(&Row, &Point)], channel: &str) -> Errors {
    let error = |(measured, emulated): &(&Row, &Point)| {
        let emulated = match channel {
            "ref" => emulated.ref_harmonics?,
            _ => emulated.dut_harmonics?,
        };
        let one = |(n, emulated): (usize, &Harmonic)| {
            let amplitude = measured.get(&format!("{channel}_h{n}"))?;
            // Without a phase the nearest is taken.
            let phase_deg = measured.get(&format!("{channel}_h{n}_deg"));
            let turn = (phase_deg.unwrap_or(emulated.phase_deg) - emulated.phase_deg).to_radians();
            let product = 2.0 * amplitude * emulated.amplitude * turn.cos();
            Some(amplitude.powi(2) + emulated.amplitude.powi(2) - product)
        };
        let squares: Option<Vec<f64>> = (2..).zip(&emulated).map(one).collect();
        Some(squares?.iter().sum::<f64>().max(0.0).sqrt())
    };
    rows.iter().filter_map(error).collect()
}

/// Distance of the means of both channels, over the peak of each.
fn dc_errors(rows: &[(&Row, &Point)]) -> Errors {
    let error = |(measured, emulated): &(&Row, &Point)| {
        let reference = (measured.get("ref_dc_v")? - emulated.ref_dc_v?) / measured.get("ref_v")?;
        let dut = (measured.get("dut_dc_v")? - emulated.dut_dc_v?) / measured.get("dut_v")?;
        Some(reference.hypot(dut) / SQRT_2)
    };
    rows.iter().filter_map(error).collect()
}
