//! Which points a diagnostic run has.

use calib_core::control::full_output_peak_ms2;
use calib_core::point::PointSpec;
use calib_core::preferred::PREFERRED_HZ;
use calib_core::settings::Limits;
use calib_twin::dataset::Exciter;
use std::f32::consts::FRAC_1_SQRT_2;
use std::f64::consts::TAU;

/// Share of the exciter's limits that is used.
const SHARE_OF_LIMITS: f32 = 0.8;
/// Frequencies at which the level is varied, Hz: below, at and above the resonance of the
/// suspension, in the middle of the band, and high.
const LEVEL_FREQUENCIES_HZ: [f32; 6] = [16.0, 40.0, 80.0, 160.0, 1000.0, 5000.0];
/// Levels there, over the usual one; those with least signal last.
const LEVELS: [f32; 5] = [2.0, 5.0, 10.0, 0.5, 0.2];

/// The points of a diagnostic run: one-third octaves from 5 Hz to 10 kHz at `level_ms2` r.m.s., then
/// five levels from a fifth of it to ten times it at six frequencies, all within `limits` and what
/// an exciter as it is believed to be reaches with `payload_kg`.
///
/// A level beyond that is lowered to 80 % of it, once for each frequency.
pub fn diagnostic_points(
    level_ms2: f32,
    limits: &Limits,
    exciter: &Exciter,
    payload_kg: f64,
) -> Vec<PointSpec> {
    let coil = exciter.model(payload_kg);
    let mut points: Vec<PointSpec> = Vec::new();
    let mut add = |frequency_hz: f32, level_ms2: f32| {
        let omega = TAU * f64::from(frequency_hz);
        let [_, travel_m_per_v] = coil.linear_response(omega, 0.0);
        let per_v_ms2 = (travel_m_per_v.norm() * omega * omega) as f32;
        let full = full_output_peak_ms2(limits, frequency_hz).min(limits.drive_peak_v * per_v_ms2);
        let highest = SHARE_OF_LIMITS * FRAC_1_SQRT_2 * full;
        let point = PointSpec {
            frequency_hz,
            acceleration_rms_ms2: level_ms2.min(highest),
        };
        if !points.contains(&point) {
            points.push(point);
        }
    };
    for frequency_hz in PREFERRED_HZ {
        add(frequency_hz, level_ms2);
    }
    for factor in LEVELS {
        for frequency_hz in LEVEL_FREQUENCIES_HZ {
            add(frequency_hz, factor * level_ms2);
        }
    }
    points
}

#[cfg(test)]
mod tests {
    use super::*;
    use calib_core::settings::Settings;
    use calib_twin::dataset::Nominal;

    #[test]
    fn every_point_is_within_the_limits_and_asked_for_once() {
        let limits = Settings::field_calibrator().limits;
        let exciter = Nominal::standard().exciter;
        for level_ms2 in [1.0, 10.0, 100.0] {
            let points = diagnostic_points(level_ms2, &limits, &exciter, 0.02);
            for (at, point) in points.iter().enumerate() {
                let peak_ms2 = point.acceleration_rms_ms2 / FRAC_1_SQRT_2;
                assert!(peak_ms2 < 0.81 * full_output_peak_ms2(&limits, point.frequency_hz));
                assert!(!points[..at].contains(point), "{point:?} twice");
            }
            for frequency_hz in PREFERRED_HZ {
                assert!(points.iter().any(|p| p.frequency_hz == frequency_hz));
            }
        }
        // At 5 Hz, far below the resonance, 10 V through 4 ohm and 7 N/A push 8000 N/m by 2.19 mm:
        // (2 pi 5)^2 * 2.19 mm = 2.16 m/s2 peak; 80 % of it are 1.22 m/s2 r.m.s.
        let lowest = diagnostic_points(10.0, &limits, &exciter, 0.02)[0];
        assert!(
            (lowest.acceleration_rms_ms2 - 1.22).abs() < 0.02,
            "{lowest:?}"
        );
    }
}
