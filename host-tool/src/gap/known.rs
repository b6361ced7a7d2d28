//! Knowledge of a calibrator that has no place in `rig.toml`.
//!
//! The simulation of a dataset has flat transducers and no filters. A response that is known
//! beforehand, such as the high-pass of a conditioner or the hold of the output converter, is no
//! gap: it is taken out of the rows when they are recorded. A value that is known wrongly stays
//! in them and shows.

use super::believed::{Believed, nominal_of};
use crate::{Error, Result};
use calib_twin::dataset::Nominal;
use calib_twin::oracle;
use calib_twin::rig::Rig;
use num_complex::Complex64;
use std::f64::consts::PI;
use std::path::Path;

/// Beliefs about a connected calibrator.
#[derive(Clone, Debug)]
pub struct Known {
    /// Beliefs of the simulation, as the dataset states them.
    pub nominal: Nominal,
    /// Filters and resonances, if a rig file states them.
    rig: Option<Rig>,
}

/// Samples of the shortest measuring block: 0.2 s at 50 kS/s.
const BLOCK_SAMPLES: f64 = 10_000.0;

impl Known {
    /// All that a rig file states but its effects.
    pub fn of(rig: &Rig) -> Self {
        let rig = Rig {
            effects: Vec::new(),
            ..rig.clone()
        };
        let mut nominal = nominal_of(&rig);
        let digitiser = &mut nominal.digitiser;
        digitiser.block_samples = BLOCK_SAMPLES;
        // Rounding to codes is noise as well: a code over the square root of 12.
        let code_v = 2.0 * digitiser.full_scale_v / digitiser.bits.exp2();
        digitiser.noise_v.value = digitiser.noise_v.value.hypot(code_v / 12.0_f64.sqrt());
        Self {
            nominal,
            rig: Some(rig),
        }
    }

    /// From a file that says what the simulation believes of a rig: only a rig file knows filters.
    ///
    /// # Errors
    /// As [`Believed::load`]; [`Error::Input`] for an oscillator.
    pub fn load(path: &Path) -> Result<Self> {
        if let Ok(rig) = Rig::load(path) {
            return Ok(Self::of(&rig));
        }
        match Believed::load(path)? {
            Believed::Calibrator(nominal) => Ok(Self {
                nominal: *nominal,
                rig: None,
            }),
            Believed::Oscillator(_) => Err(Error::input(
                path.display().to_string(),
                "is an oscillator, not a calibrator",
                "give what is believed of the calibrator",
            )),
        }
    }

    /// Mass on the armature, kg; 0 if no rig file states it.
    pub fn payload_kg(&self) -> f64 {
        self.rig.as_ref().map_or(0.0, |rig| rig.exciter.payload_kg)
    }

    /// Known response of the device under test with its conditioner, relative to its gain between
    /// the corners; 1 if nothing is known.
    pub fn dut(&self, frequency_hz: f64) -> Complex64 {
        self.rig.as_ref().map_or(Complex64::ONE, |rig| {
            let gain = rig.dut.sensitivity_v_per_ms2 * rig.dut.conditioner_gain;
            let response = oracle::dut_sensitivity(rig, frequency_hz) / gain;
            Complex64::new(response.re, response.im)
        })
    }

    /// Known response of the reference channel up to the converter, relative to its gain between the
    /// corners; 1 if nothing is known.
    pub fn at_reference(&self, frequency_hz: f64) -> Complex64 {
        self.rig.as_ref().map_or(Complex64::ONE, |rig| {
            let gain = rig.reference.sensitivity_v_per_ms2 * rig.reference.conditioner_gain;
            let response = oracle::reference_sensitivity(rig, frequency_hz) / gain
                * oracle::anti_alias(rig, frequency_hz);
            Complex64::new(response.re, response.im)
        })
    }

    /// Known response of the device's channel.
    pub fn at_dut(&self, frequency_hz: f64) -> Complex64 {
        let filter = self.rig.as_ref().map_or(Complex64::ONE, |rig| {
            let response = oracle::anti_alias(rig, frequency_hz);
            Complex64::new(response.re, response.im)
        });
        self.dut(frequency_hz) * filter
    }

    /// Voltage at the coil over the commanded one: the hold of the converter, and the output filter
    /// if it is known.
    pub fn output(&self, frequency_hz: f64, sample_rate_hz: f64) -> Complex64 {
        if let Some(rig) = &self.rig {
            let response = oracle::output_transfer(rig, frequency_hz);
            return Complex64::new(response.re, response.im);
        }
        let angle = PI * frequency_hz / sample_rate_hz;
        Complex64::from_polar(angle.sin() / angle, -angle)
    }

    /// Corrections taken out of the rows, for people.
    pub fn corrections(&self) -> Vec<String> {
        let Some(rig) = &self.rig else {
            return vec!["hold of the output converter".to_owned()];
        };
        let (dut, converter) = (&rig.dut, &rig.converter);
        vec![
            "hold of the output converter".to_owned(),
            format!(
                "output filter of order {} at {} Hz",
                converter.reconstruction_order, converter.reconstruction_hz
            ),
            format!(
                "device under test: high-pass {} Hz, resonance {} Hz (Q {}), low-pass {} Hz",
                dut.high_pass_hz, dut.resonance_hz, dut.quality_factor, dut.low_pass_hz
            ),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_responses_are_those_of_their_formulas() {
        let known = Known::of(&Rig::standard());
        // A first-order high-pass at 0.16 Hz: 1/sqrt(1 + (0.16/20)^2) and atan(0.16/20); resonance
        // and low-pass change less than (20/38000)^2 and, in phase, 20/100000 * sqrt(2).
        let low = known.dut(20.0);
        assert!((low.norm() - 1.0 / (1.0 + 0.008_f64.powi(2)).sqrt()).abs() < 1e-6);
        assert!((low.arg() - 0.008_f64.atan()).abs() < 4e-4);
        // Hold sinc(0.2); Butterworth of order 8: 1/sqrt(1 + (10/18)^16).
        let hold = (0.2 * PI).sin() / (0.2 * PI);
        let filter = 1.0 / (1.0 + (10.0_f64 / 18.0).powi(16)).sqrt();
        let output = known.output(10_000.0, 50_000.0).norm();
        assert!((output - hold * filter).abs() < 1e-9, "{output}");
    }

    #[test]
    fn without_a_rig_file_only_the_hold_is_known() {
        let known = Known::load(Path::new("standard")).expect("built in");
        assert_eq!(known.dut(9000.0), Complex64::ONE);
        let hold = (0.2 * PI).sin() / (0.2 * PI);
        assert!((known.output(10_000.0, 50_000.0).norm() - hold).abs() < 1e-12);
        assert_eq!(known.corrections().len(), 1);
    }
}
