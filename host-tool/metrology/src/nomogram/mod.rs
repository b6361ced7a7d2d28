//! Acceleration, velocity and displacement of a sinusoidal vibration.
//!
//! # Equation
//! `v = a / (2 pi f)`, `s = a / (2 pi f)^2`; peak = sqrt(2) r.m.s.,
//! peak-to-peak = 2 peak.
//!
//! # Source
//! ISO 16063-21:2003 Annex C.

mod chart;

pub use chart::{RigLimits, nomogram_chart};

use calib_files::{Error, Result};
use schemars::JsonSchema;
use serde::Serialize;
use std::f64::consts::{SQRT_2, TAU};

/// How an amplitude is stated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measure {
    /// Root mean square.
    Rms,
    /// Peak.
    Peak,
    /// Peak to peak.
    PeakToPeak,
}

impl Measure {
    /// R.m.s. per unit of this measure.
    pub fn to_rms(self) -> f64 {
        match self {
            Self::Rms => 1.0,
            Self::Peak => 1.0 / SQRT_2,
            Self::PeakToPeak => 0.5 / SQRT_2,
        }
    }
}

/// One quantity in its three measures.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Amplitude {
    /// Root mean square.
    pub rms: f64,
    /// Peak.
    pub peak: f64,
    /// Peak to peak.
    pub peak_to_peak: f64,
}

impl Amplitude {
    fn of_rms(rms: f64) -> Self {
        Self {
            rms,
            peak: SQRT_2 * rms,
            peak_to_peak: 2.0 * SQRT_2 * rms,
        }
    }
}

/// A sinusoidal vibration.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Vibration {
    /// Frequency, Hz.
    pub frequency_hz: f64,
    /// Acceleration, m/s2.
    pub acceleration_ms2: Amplitude,
    /// Velocity, m/s.
    pub velocity_ms: Amplitude,
    /// Displacement, m.
    pub displacement_m: Amplitude,
}

/// The quantities that are known; exactly two of them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Known {
    /// Frequency, Hz.
    pub frequency_hz: Option<f64>,
    /// Acceleration, m/s2.
    pub acceleration_ms2: Option<f64>,
    /// Velocity, m/s.
    pub velocity_ms: Option<f64>,
    /// Displacement, m.
    pub displacement_m: Option<f64>,
}

/// Finds the other two of four quantities.
///
/// # Errors
/// Not exactly two quantities, or one that is not above zero.
///
/// # Accuracy
/// A few units of rounding; test `any_two_quantities_give_the_same_vibration`.
pub fn solve(known: &Known, measure: Measure) -> Result<Vibration> {
    let all = [
        known.frequency_hz,
        known.acceleration_ms2,
        known.velocity_ms,
        known.displacement_m,
    ];
    if all.iter().flatten().count() != 2 {
        return Err(usage(
            "two of frequency, acceleration, velocity and displacement are needed",
            "for example --frequency 160 --acceleration 10",
        ));
    }
    if all
        .iter()
        .flatten()
        .any(|value| !value.is_finite() || *value <= 0.0)
    {
        return Err(usage(
            "a quantity is not greater than zero",
            "write positive numbers",
        ));
    }
    let rms = |value: Option<f64>| value.map(|value| value * measure.to_rms());
    let (a, v, s) = (
        rms(known.acceleration_ms2),
        rms(known.velocity_ms),
        rms(known.displacement_m),
    );
    let omega = match (known.frequency_hz, a, v, s) {
        (Some(f), ..) => TAU * f,
        (None, Some(a), Some(v), None) => a / v,
        (None, Some(a), None, Some(s)) => (a / s).sqrt(),
        (None, None, Some(v), Some(s)) => v / s,
        _ => {
            return Err(usage(
                "the frequency does not follow",
                "name two quantities",
            ));
        }
    };
    let velocity = v.unwrap_or_else(|| match (a, s) {
        (Some(a), _) => a / omega,
        (None, Some(s)) => s * omega,
        (None, None) => f64::NAN,
    });
    Ok(Vibration {
        frequency_hz: omega / TAU,
        acceleration_ms2: Amplitude::of_rms(velocity * omega),
        velocity_ms: Amplitude::of_rms(velocity),
        displacement_m: Amplitude::of_rms(velocity / omega),
    })
}

fn usage(problem: &str, hint: &str) -> Error {
    Error::usage(problem, hint)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn any_two_quantities_give_the_same_vibration() {
        // w = 1000 rad/s: 10 m/s2 are 10 mm/s and 10 um.
        let f = 1000.0 / TAU;
        let one = |f, a, v, s| {
            let known = Known {
                frequency_hz: f,
                acceleration_ms2: a,
                velocity_ms: v,
                displacement_m: s,
            };
            solve(&known, Measure::Peak).expect("two quantities")
        };
        for vibration in [
            one(Some(f), Some(10.0), None, None),
            one(Some(f), None, Some(0.01), None),
            one(Some(f), None, None, Some(1e-5)),
            one(None, Some(10.0), Some(0.01), None),
            one(None, Some(10.0), None, Some(1e-5)),
            one(None, None, Some(0.01), Some(1e-5)),
        ] {
            assert!((vibration.frequency_hz / f - 1.0).abs() < 1e-12);
            assert!((vibration.acceleration_ms2.peak / 10.0 - 1.0).abs() < 1e-12);
            assert!((vibration.velocity_ms.rms * SQRT_2 / 0.01 - 1.0).abs() < 1e-12);
            assert!((vibration.displacement_m.peak_to_peak / 2e-5 - 1.0).abs() < 1e-12);
        }
        assert!(solve(&Known::default(), Measure::Rms).is_err());
    }
}
