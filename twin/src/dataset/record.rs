//! Records of an oscillator with effects.

use std::fmt::Write as _;
use std::path::Path;

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha12Rng;
use rand_distr::{Distribution, StandardNormal};
use serde::Serialize;

use super::nominal::Quantity;
use crate::effects::ActiveEffect;
use crate::effects::oscillator::OscillatorAction;
use crate::oscillator::{Multisine, Oscillator, simulate};

/// Nominal values of an oscillator's dataset: `rig.toml` of kind `oscillator`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct NominalOscillator {
    /// Gain.
    pub rho: Quantity,
    /// Resonance frequency, Hz.
    pub resonance_hz: Quantity,
    /// Damping.
    pub delta: Quantity,
}

/// How a record is made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RecordOptions {
    /// Seed of everything random.
    pub seed: u64,
    /// Samples.
    pub samples: usize,
    /// Sample rate, Hz.
    pub sample_rate_hz: f64,
    /// Input, r.m.s.
    pub input_rms: f64,
    /// Highest frequency of the input, Hz.
    pub highest_hz: f64,
    /// Noise of the output, r.m.s., relative to the output.
    pub noise_rel: f64,
    /// Whether the input grows from nothing over the record.
    pub growing: bool,
}

impl Default for RecordOptions {
    /// 8192 samples around a resonance of 68 Hz, as of the well-known electronic oscillators.
    fn default() -> Self {
        Self {
            seed: 0,
            samples: 8192,
            sample_rate_hz: 610.351_562_5,
            input_rms: 0.02,
            highest_hz: 200.0,
            noise_rel: 0.003,
            growing: false,
        }
    }
}

/// A sampled record.
#[derive(Clone, Debug, PartialEq)]
pub struct Record {
    /// Sample rate, Hz.
    pub sample_rate_hz: f64,
    /// Input at each sample.
    pub input: Vec<f64>,
    /// Output at each sample.
    pub output: Vec<f64>,
}

impl NominalOscillator {
    /// An oscillator like the well-known electronic ones: 68 Hz, hardly damped.
    pub fn standard() -> Self {
        let omega = std::f64::consts::TAU * 68.0;
        Self {
            rho: Quantity {
                value: omega * omega,
                u: 0.02 * omega * omega,
            },
            resonance_hz: Quantity {
                value: 68.0,
                u: 1.0,
            },
            delta: Quantity {
                value: 0.03,
                u: 0.005,
            },
        }
    }

    /// Records an oscillator that has these values within their uncertainties, and `effects`.
    pub fn record(
        &self,
        effects: &[ActiveEffect<OscillatorAction>],
        options: &RecordOptions,
    ) -> Record {
        let mut random = ChaCha12Rng::seed_from_u64(options.seed);
        let mut truth = |quantity: Quantity| {
            let unit: f64 = StandardNormal.sample(&mut random);
            quantity.value + unit.clamp(-2.5, 2.5) * quantity.u
        };
        let values = [self.rho, self.resonance_hz, self.delta].map(&mut truth);
        let mut oscillator = Oscillator::linear(values[0], values[1], values[2]);
        for effect in effects {
            effect.apply_to(&mut oscillator);
        }
        let rate_hz = options.sample_rate_hz;
        let duration_s = options.samples as f64 / rate_hz;
        // At least ten tones below the resonance, whatever the length of the record.
        let base_hz = (1.0 / duration_s).max(values[1] / 100.0);
        let mut input = Multisine::new(
            base_hz,
            options.highest_hz,
            options.input_rms,
            random.random(),
        );
        let mut settle_s = 20.0 / (std::f64::consts::TAU * values[1] * values[2]);
        if options.growing {
            input = input.growing(duration_s);
            settle_s = 0.0;
        }
        let mut output = simulate(&oscillator, &input, rate_hz, options.samples, settle_s);
        let rms = (output.iter().map(|y| y * y).sum::<f64>() / output.len().max(1) as f64).sqrt();
        for value in &mut output {
            let unit: f64 = StandardNormal.sample(&mut random);
            *value += options.noise_rel * rms * unit;
        }
        Record {
            sample_rate_hz: rate_hz,
            input: input.values(0.0, 1.0 / rate_hz, options.samples),
            output,
        }
    }
}

#[derive(Serialize)]
struct RecordRig {
    kind: &'static str,
    digitiser: RecordDigitiser,
    oscillator: NominalOscillator,
}

#[derive(Serialize)]
struct RecordDigitiser {
    sample_rate_hz: f64,
}

impl Record {
    /// The text of `record.csv`.
    pub fn csv(&self) -> String {
        let mut text = String::from("time_s,input,output\n");
        for (index, (input, output)) in self.input.iter().zip(&self.output).enumerate() {
            let time_s = index as f64 / self.sample_rate_hz;
            // Writing to a string cannot fail.
            let _ = writeln!(text, "{time_s:.9},{input:.9e},{output:.9e}");
        }
        text
    }

    /// Writes the record with its nominal rig as a dataset folder.
    ///
    /// # Errors
    /// Error of the file system.
    pub fn write(&self, directory: &Path, nominal: &NominalOscillator) -> std::io::Result<()> {
        std::fs::create_dir_all(directory)?;
        let rig = RecordRig {
            kind: "oscillator",
            digitiser: RecordDigitiser {
                sample_rate_hz: self.sample_rate_hz,
            },
            oscillator: *nominal,
        };
        let rig = toml::to_string(&rig).map_err(std::io::Error::other)?;
        std::fs::write(directory.join("rig.toml"), rig)?;
        std::fs::write(directory.join("record.csv"), self.csv())
    }
}
