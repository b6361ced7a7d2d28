//! Rigs in which every influence quantity of a budget has taken a value.
//!
//! To judge whether a stated uncertainty covers the truth, the rig must be wrong in all the ways the
//! budget admits, by as much as it admits. [`InfluenceDraw`] draws each row from its distribution and
//! lets it act where it belongs:
//!
//! | row of Table A.1 | acts on |
//! |---|---|
//! | 1 reference calibration | the certificate: its error differs from frequency to frequency |
//! | 10 stability of the reference | sensitivity of the reference, since it was calibrated |
//! | 2 to 9, 11 to 17 | gain of the device's channel: what the budget states is a factor |
//! | 9 relative motion, where it grows with the square of the frequency | the certificate, likewise |
//! | 6 transverse motion | the same, as the product of sensitivity, motion and cosine if so stated |
//! | 18 residual effects | nothing: the plant's own noise and resolution |
//!
//! A phase that is the same at all frequencies belongs to no causal channel, so phase errors of
//! all rows are put where they are indistinguishable from it: into the phase the certificate states
//! for the reference.

mod distribution;

use nalgebra::Complex;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha12Rng;

pub use self::distribution::Distribution;
use crate::oracle::{self, CalibrationPoint};
use crate::rig::Rig;

/// Row of Table A.1 that is the stability of the reference.
const REFERENCE_STABILITY_ROW: u8 = 10;
/// Row that is measured, not drawn: residual effects.
const RESIDUAL_ROW: u8 = 18;

/// One influence quantity as a budget states it, relative to the sensitivity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Influence {
    /// Row of ISO 16063-21 Table A.1 and A.2, 2 to 17; others are not drawn, see the module.
    pub row: u8,
    /// Bound of the magnitude, relative.
    pub bound_rel: f64,
    /// Bound of the phase, rad.
    pub bound_phase_rad: f64,
    /// Distribution of both.
    pub distribution: Distribution,
    /// The bounds are those at this frequency, Hz, and grow with its square; they are the same at all
    /// frequencies where there is none.
    pub square_from_hz: Option<f64>,
}

impl Influence {
    /// Contribution at this frequency of an error stated for all frequencies, or for that of the bounds.
    fn share(&self, frequency_hz: f64) -> f64 {
        self.square_from_hz
            .map_or(1.0, |at_hz| (frequency_hz / at_hz).powi(2))
    }
}

/// A rig that is wrong within its budget, and the truth about it.
#[derive(Clone, Debug, PartialEq)]
pub struct InfluenceDraw {
    /// Rig the plant simulates, with all influences at work.
    pub rig: Rig,
    /// Beliefs of the laboratory about the reference, to be set in the instrument.
    pub certificate: Vec<CalibrationPoint>,
    /// The rig without influences, which defines the truth.
    undisturbed: Rig,
}

impl InfluenceDraw {
    /// Draws all `influences` for `rig`, with a certificate at `frequencies_hz` whose errors are
    /// those the rig's own certificate states (row 1), and new noise.
    pub fn new(rig: &Rig, frequencies_hz: &[f64], influences: &[Influence], seed: u64) -> Self {
        let mut random = ChaCha12Rng::seed_from_u64(seed);
        let mut certificate =
            oracle::calibration_at(rig, frequencies_hz, Some(random.random::<u64>()));
        let mut disturbed = rig.clone();
        disturbed.noise_seed = random.random::<u64>() >> 1;
        for influence in influences
            .iter()
            .filter(|influence| influence.row < RESIDUAL_ROW)
        {
            let mut draw = |bound| influence.distribution.draw(bound, &mut random);
            let error_rel = draw(influence.bound_rel);
            let phase_rad = draw(influence.bound_phase_rad);
            let gain = 1.0 + error_rel;
            match influence.row {
                1 => continue,
                _ if influence.square_from_hz.is_some() => {
                    for point in &mut certificate {
                        point.sensitivity_v_per_ms2 *=
                            1.0 + error_rel * influence.share(point.frequency_hz);
                    }
                }
                REFERENCE_STABILITY_ROW => disturbed.reference.sensitivity_v_per_ms2 *= gain,
                _ => disturbed.dut.conditioner_gain *= gain,
            }
            for point in &mut certificate {
                point.phase_rad += phase_rad * influence.share(point.frequency_hz);
            }
        }
        Self {
            rig: disturbed,
            certificate,
            undisturbed: rig.clone(),
        }
    }

    /// The true sensitivity of the device under test with its conditioner, V/(m/s2).
    pub fn truth(&self, frequency_hz: f64) -> Complex<f64> {
        oracle::dut_sensitivity(&self.undisturbed, frequency_hz)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Table D.1 without its first row, which is the certificate, and its last.
    const TABLE_D1: [(u8, f64, Distribution); 14] = [
        (2, 0.25, Distribution::Rectangular),
        (3, 0.2, Distribution::Rectangular),
        (3, 0.2, Distribution::Rectangular),
        (4, 0.0024, Distribution::Rectangular),
        (6, 0.539, Distribution::Transverse),
        (7, 0.05, Distribution::Rectangular),
        (8, 0.05, Distribution::Rectangular),
        (9, 0.05, Distribution::Rectangular),
        (10, 0.15, Distribution::Rectangular),
        (11, 0.36, Distribution::Rectangular),
        (13, 0.03, Distribution::Rectangular),
        (14, 0.03, Distribution::Rectangular),
        (16, 0.03, Distribution::Rectangular),
        (17, 0.03, Distribution::Rectangular),
    ];

    fn influences() -> Vec<Influence> {
        let influence = |&(row, percent, distribution): &(u8, f64, Distribution)| Influence {
            row,
            bound_rel: percent / 100.0,
            bound_phase_rad: percent / 100.0,
            distribution,
            square_from_hz: None,
        };
        TABLE_D1.iter().map(influence).collect()
    }

    /// Result of an ideal instrument for a draw: `S = S1 X2 / X1` with the certified S1.
    fn ideal_result(draw: &InfluenceDraw, index: usize) -> Complex<f64> {
        let point = draw.certificate[index];
        let certified = Complex::from_polar(point.sensitivity_v_per_ms2, point.phase_rad);
        let ratio = oracle::dut_sensitivity(&draw.rig, point.frequency_hz)
            / oracle::reference_sensitivity(&draw.rig, point.frequency_hz);
        certified * ratio
    }

    #[test]
    fn the_draws_of_table_d1_have_its_combined_uncertainty() {
        let rig = Rig::standard();
        let frequencies_hz = [160.0, 1000.0];
        let count = 4000;
        let (mut magnitude, mut phase) = (0.0, 0.0);
        let mut covered = 0;
        for seed in 0..count {
            let draw = InfluenceDraw::new(&rig, &frequencies_hz, &influences(), seed);
            let error = ideal_result(&draw, 1) / draw.truth(1000.0);
            magnitude += (error.norm() - 1.0).powi(2) / count as f64;
            phase += error.arg().powi(2) / count as f64;
            covered += u32::from((error.norm() - 1.0).abs() <= 2.0 * 0.00425);
        }
        // 0.425 % with the transverse entry unrounded (the row of residual effects, 0.017 %, changes
        // it by 3e-4 of itself). Standard error of a deviation 1/sqrt(2 n) = 1.1 %; four of them.
        assert!(
            (magnitude.sqrt() / 0.00425 - 1.0).abs() < 0.045,
            "{magnitude}"
        );
        // The phase has the same rows with the certificate's half of 8.7 mrad instead of 0.25 %.
        let rows = 0.00425_f64.powi(2) - 0.0025_f64.powi(2) + 0.00435_f64.powi(2);
        assert!(((phase / rows).sqrt() - 1.0).abs() < 0.045, "{phase}");
        // Nearly normal: 95.4 % with a standard error of 0.33 %.
        let share = f64::from(covered) / count as f64;
        assert!((0.94..0.97).contains(&share), "{share}");
    }

    #[test]
    fn an_error_that_grows_with_the_square_does_so_and_stays_within_its_bound() {
        let rig = Rig::standard();
        let motion = Influence {
            row: 9,
            bound_rel: 0.02,
            bound_phase_rad: 0.02,
            distribution: Distribution::Rectangular,
            square_from_hz: Some(10_000.0),
        };
        for seed in 0..50 {
            let with = InfluenceDraw::new(&rig, &[1000.0, 2000.0], &[motion], seed);
            let without = InfluenceDraw::new(&rig, &[1000.0, 2000.0], &[], seed);
            let error = |index: usize| {
                let (with, without) = (with.certificate[index], without.certificate[index]);
                let rel = with.sensitivity_v_per_ms2 / without.sensitivity_v_per_ms2 - 1.0;
                (rel, with.phase_rad - without.phase_rad)
            };
            let ((low, low_rad), (high, high_rad)) = (error(0), error(1));
            assert!(low.abs() <= 2.0e-4 && low_rad.abs() <= 2.0e-4);
            // 1 + error to 1e-16, of errors of 1e-6 and more.
            assert!((high - 4.0 * low).abs() < 1.0e-12);
            assert!((high_rad - 4.0 * low_rad).abs() < 1.0e-12);
        }
    }

    #[test]
    fn a_certificate_alone_leaves_the_plant_undisturbed() {
        let rig = Rig::standard();
        let draw = InfluenceDraw::new(&rig, &[160.0], &[], 3);
        assert_eq!(draw.rig.dut, rig.dut);
        assert_eq!(draw.rig.reference, rig.reference);
        assert!(
            draw.certificate[0].sensitivity_v_per_ms2
                != oracle::reference_sensitivity(&rig, 160.0).norm()
        );
        assert_ne!(
            draw.rig.noise_seed,
            InfluenceDraw::new(&rig, &[160.0], &[], 4).rig.noise_seed
        );
    }
}
