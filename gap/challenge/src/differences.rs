//! Two measurements of one design, value by value, in standard uncertainties.

use calib_gap::{Channel, Observable, Table};
use calib_twin::dataset::{Harmonic, Point};
use std::collections::HashMap;

/// Relative standard uncertainty of a noise column.
const NOISE_SCATTER: f64 = 0.01;

/// `of` less `from`, over the standard uncertainties of `from`, row by row of `from`; `None` where
/// one of them lacks the value. Amplitudes by their logarithms.
pub(super) fn differences(from: &[Point], of: &[Point]) -> Vec<Table<Option<f64>>> {
    let key = |point: &Point| {
        let time_s = point.time_s.unwrap_or(0.0);
        (time_s.to_bits(), point.frequency_hz.to_bits())
    };
    let there: HashMap<_, _> = of.iter().map(|point| (key(point), point)).collect();
    let row = |point: &Point| match there.get(&key(point)) {
        Some(other) => of_row(point, other),
        None => Table::filled(None),
    };
    from.iter().map(row).collect()
}

fn of_row(from: &Point, of: &Point) -> Table<Option<f64>> {
    let ratio = |p: &Point| p.ratio.or_else(|| Some(p.dut_v? / p.ref_v?));
    let drive = |p: &Point| Some(p.ref_v? / p.coil_v?);
    let current = |p: &Point| Some(p.coil_a? / p.coil_v?);
    let in_deg = |u: Option<f64>| u.map(f64::to_degrees);
    let (u_drive_deg, u_current_deg) = (in_deg(from.u_drive), in_deg(from.u_current));
    let scatter = Some(NOISE_SCATTER);
    let mut values = Table::from_fn(|observable| match observable {
        Observable::Ratio => relative(ratio(from), ratio(of), from.u_ratio),
        Observable::RatioPhase => angle(from.dut_deg, of.dut_deg, from.u_phase_deg),
        Observable::Drive => relative(drive(from), drive(of), from.u_drive),
        Observable::DrivePhase => angle(from.ref_deg, of.ref_deg, u_drive_deg),
        Observable::Current => relative(current(from), current(of), from.u_current),
        Observable::CurrentPhase => angle(from.coil_a_deg, of.coil_a_deg, u_current_deg),
        Observable::RefDc => absolute(from.ref_dc_v, of.ref_dc_v, from.u_dc_v),
        Observable::DutDc => absolute(from.dut_dc_v, of.dut_dc_v, from.u_dc_v),
        Observable::RefNoise => relative(from.ref_noise_v, of.ref_noise_v, scatter),
        Observable::DutNoise => relative(from.dut_noise_v, of.dut_noise_v, scatter),
        _ => None,
    });
    let channels = [
        (Channel::Reference, from.ref_harmonics, of.ref_harmonics),
        (Channel::Dut, from.dut_harmonics, of.dut_harmonics),
    ];
    for (channel, from_all, of_all) in channels {
        let pairs = from_all.iter().flatten().zip(of_all.iter().flatten());
        for (observables, (a, b)) in Observable::harmonics(channel).into_iter().zip(pairs) {
            let both = parts(a).into_iter().zip(parts(b));
            for (observable, (a, b)) in observables.into_iter().zip(both) {
                values[observable] = absolute(Some(a), Some(b), from.u_harmonic);
            }
        }
    }
    values
}

/// Real and imaginary part.
fn parts(harmonic: &Harmonic) -> [f64; 2] {
    let (sin, cos) = harmonic.phase_deg.to_radians().sin_cos();
    [harmonic.amplitude * cos, harmonic.amplitude * sin]
}

fn relative(from: Option<f64>, of: Option<f64>, u: Option<f64>) -> Option<f64> {
    Some((of? / from?).ln() / u?)
}

fn absolute(from: Option<f64>, of: Option<f64>, u: Option<f64>) -> Option<f64> {
    Some((of? - from?) / u?)
}

fn angle(from_deg: Option<f64>, of_deg: Option<f64>, u_deg: Option<f64>) -> Option<f64> {
    let turned_deg = (of_deg? - from_deg? + 180.0).rem_euclid(360.0) - 180.0;
    Some(turned_deg / u_deg?)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point(ref_v: f64, phase_deg: f64, second: f64) -> Point {
        let none = Harmonic {
            amplitude: 0.0,
            phase_deg: 0.0,
        };
        let mut harmonics = [none; 4];
        harmonics[0].amplitude = second;
        Point {
            frequency_hz: 160.0,
            time_s: Some(3.0),
            ref_v: Some(ref_v),
            dut_v: Some(1.0),
            dut_deg: Some(phase_deg),
            dut_harmonics: Some(harmonics),
            u_ratio: Some(1e-3),
            u_phase_deg: Some(0.1),
            u_harmonic: Some(1e-4),
            ..Point::default()
        }
    }

    #[test]
    fn each_value_counts_in_its_own_uncertainty() {
        let (from, of) = (point(1.0, 179.9, 1e-3), point(0.998, -179.8, 1.3e-3));
        let [row] = differences(std::slice::from_ref(&from), &[of])[..] else {
            panic!("one row")
        };
        // ln(1/0.998) = 2.002e-3; 0.3 degrees across the cut; 3e-4.
        let expected = [
            (Observable::Ratio, 2.002),
            (Observable::RatioPhase, 3.0),
            (Observable::DutH2Real, 3.0),
            (Observable::DutH2Imaginary, 0.0),
        ];
        for (at, value) in expected {
            assert!(
                (row[at].expect("measured") - value).abs() < 1e-3,
                "{at:?}: {:?}",
                row[at]
            );
        }
        assert_eq!(row[Observable::Drive], None);
        assert_eq!(row[Observable::RefH2Real], None);
        let elsewhere = Point {
            time_s: Some(4.0),
            ..from.clone()
        };
        assert_eq!(differences(&[from], &[elsewhere]), [Table::filled(None)]);
    }
}
