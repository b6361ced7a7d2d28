//! The reference's own calibration, as a laboratory would certify it.

use rand::SeedableRng;
use rand_chacha::ChaCha12Rng;
use rand_distr::{Distribution as _, StandardNormal};

use super::reference_sensitivity;
use crate::rig::Rig;

/// One-third-octave frequencies of a reference's certificate, Hz.
///
/// # Source
/// ISO 266 preferred frequencies, 5 Hz to 10 kHz.
pub const ONE_THIRD_OCTAVES_HZ: [f64; 34] = [
    5.0, 6.3, 8.0, 10.0, 12.5, 16.0, 20.0, 25.0, 31.5, 40.0, 50.0, 63.0, 80.0, 100.0, 125.0, 160.0,
    200.0, 250.0, 315.0, 400.0, 500.0, 630.0, 800.0, 1000.0, 1250.0, 1600.0, 2000.0, 2500.0,
    3150.0, 4000.0, 5000.0, 6300.0, 8000.0, 10_000.0,
];

/// One line of the reference's calibration table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CalibrationPoint {
    /// Frequency, Hz.
    pub frequency_hz: f64,
    /// Certified sensitivity of the reference with its conditioner, V/(m/s2).
    pub sensitivity_v_per_ms2: f64,
    /// Certified phase, rad.
    pub phase_rad: f64,
    /// Relative expanded uncertainty of the magnitude, k = 2.
    pub expanded_uncertainty_rel: f64,
    /// Expanded uncertainty of the phase, rad, k = 2.
    pub expanded_uncertainty_phase_rad: f64,
}

/// The certificate of the rig's reference at [`ONE_THIRD_OCTAVES_HZ`].
///
/// Without a seed the table is the truth. With one, each line is off by an error drawn from the
/// certificate's own statement: normal with half the expanded uncertainty, one draw for the
/// magnitude and one for the phase at each frequency.
pub fn reference_calibration(rig: &Rig, error_seed: Option<u64>) -> Vec<CalibrationPoint> {
    calibration_at(rig, &ONE_THIRD_OCTAVES_HZ, error_seed)
}

/// As [`reference_calibration`] at other frequencies.
pub fn calibration_at(
    rig: &Rig,
    frequencies_hz: &[f64],
    error_seed: Option<u64>,
) -> Vec<CalibrationPoint> {
    let mut random = error_seed.map(ChaCha12Rng::seed_from_u64);
    let mut error = |expanded: f64| {
        random.as_mut().map_or(0.0, |random| {
            let unit: f64 = StandardNormal.sample(random);
            unit * expanded / 2.0
        })
    };
    let stated = rig.certificate;
    let line = |&frequency_hz: &f64| {
        let truth = reference_sensitivity(rig, frequency_hz);
        CalibrationPoint {
            frequency_hz,
            sensitivity_v_per_ms2: truth.norm() * (1.0 + error(stated.expanded_uncertainty_rel)),
            phase_rad: truth.arg() + error(stated.expanded_uncertainty_phase_rad),
            expanded_uncertainty_rel: stated.expanded_uncertainty_rel,
            expanded_uncertainty_phase_rad: stated.expanded_uncertainty_phase_rad,
        }
    };
    frequencies_hz.iter().map(line).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_of_the_certificate_have_the_stated_spread() {
        let rig = Rig::standard();
        let truth = reference_calibration(&rig, None);
        let (mut sum, mut square, mut count) = (0.0, 0.0, 0.0);
        for seed in 0..200 {
            for (drawn, true_) in reference_calibration(&rig, Some(seed)).iter().zip(&truth) {
                let error = drawn.sensitivity_v_per_ms2 / true_.sensitivity_v_per_ms2 - 1.0;
                sum += error;
                square += error * error;
                count += 1.0;
            }
        }
        let standard = rig.certificate.expanded_uncertainty_rel / 2.0;
        // Standard error of the mean s/sqrt(n), of the deviation s/sqrt(2n); four of each.
        assert!((sum / count).abs() < 4.0 * standard / f64::sqrt(count));
        assert!((f64::sqrt(square / count) / standard - 1.0).abs() < 4.0 / f64::sqrt(2.0 * count));
    }

    #[test]
    fn a_seed_gives_the_same_certificate_twice() {
        let rig = Rig::standard();
        assert_eq!(
            reference_calibration(&rig, Some(7)),
            reference_calibration(&rig, Some(7))
        );
        assert_ne!(
            reference_calibration(&rig, Some(7)),
            reference_calibration(&rig, Some(8))
        );
    }
}
