//! Consecutive measurement with one voltmeter (ISO 16063-21, 4.5 a).
//!
//! Reference, device under test, reference again: a slow drift of the
//! vibration shows as the difference of the two reference readings, and its
//! first order cancels when the device is compared with their mean.

use crate::point_state::Reason;
use crate::requirements::SingleVoltmeter;
use crate::settings::Example;
use num_complex::Complex32;

/// Three readings of one point; complex peak amplitudes in the same unit, at
/// equal intervals. Phases need a common trigger and are ignored without one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Consecutive {
    /// Reference before.
    pub before: Complex32,
    /// Device under test.
    pub dut: Complex32,
    /// Reference after.
    pub after: Complex32,
}

impl Consecutive {
    /// Change of the reference between its readings, relative to their mean.
    pub fn drift_rel(&self) -> f32 {
        let (before, after) = (self.before.norm(), self.after.norm());
        2.0 * (after - before) / (after + before)
    }

    /// Ratio X2/X1 with the drift removed to first order.
    ///
    /// The mean of the two magnitudes, and the direction halfway between the
    /// two phases.
    ///
    /// # Errors
    /// [`Reason::ReferenceDead`] without a reference reading,
    /// [`Reason::AmplitudeUnstable`] when the drift exceeds Table 3.
    pub fn ratio(&self, example: Example) -> Result<Complex32, Reason> {
        let drift = self.drift_rel();
        if !drift.is_finite() {
            return Err(Reason::ReferenceDead);
        }
        if drift.abs() > SingleVoltmeter::of(example).repeat_rel {
            return Err(Reason::AmplitudeUnstable);
        }
        let magnitude = 0.5 * (self.before.norm() + self.after.norm());
        let direction = self.before / self.before.norm() + self.after / self.after.norm();
        let reference = direction * (magnitude / direction.norm());
        let ratio = self.dut / reference;
        if ratio.is_finite() {
            Ok(ratio)
        } else {
            Err(Reason::ReferenceDead)
        }
    }

    /// Half-width of what the drift may have left: half the difference, as
    /// nothing says where in between the device was read.
    pub fn drift_half_width_rel(&self) -> f32 {
        0.5 * self.drift_rel().abs()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn reading(level: f32, sensitivity: f32, phase_rad: f32) -> Complex32 {
        Complex32::from_polar(level * sensitivity, phase_rad)
    }

    #[test]
    fn a_linear_drift_cancels() {
        // Level 10, 10.01, 10.02 with sensitivities 1 and 0.97 at 0.1 rad,
        // common phase creeping by 0.01 rad.
        let readings = Consecutive {
            before: reading(10.0, 1.0, 1.0),
            dut: reading(10.01, 0.97, 1.11),
            after: reading(10.02, 1.0, 1.02),
        };
        let ratio = readings.ratio(Example::Example2).expect("within Table 3");
        assert!((ratio.norm() - 0.97).abs() < 3.0e-7);
        assert!((ratio.arg() - 0.1).abs() < 3.0e-7);
        assert!((readings.drift_half_width_rel() - 0.000_999).abs() < 1.0e-6);
    }

    #[test]
    fn drift_beyond_table_3_refuses() {
        let with_drift = |drift: f32| Consecutive {
            before: reading(10.0, 1.0, 0.0),
            dut: reading(10.0, 0.97, 0.0),
            after: reading(10.0 * (1.0 + drift), 1.0, 0.0),
        };
        let unstable = Err(Reason::AmplitudeUnstable);
        assert!(with_drift(0.0009).ratio(Example::Example1).is_ok());
        assert_eq!(with_drift(0.0011).ratio(Example::Example1), unstable);
        assert!(with_drift(-0.0029).ratio(Example::Example2).is_ok());
        assert_eq!(with_drift(-0.0031).ratio(Example::Example2), unstable);
    }

    #[test]
    fn without_a_reference_there_is_no_ratio() {
        let zero = Complex32::new(0.0, 0.0);
        let readings = Consecutive {
            before: zero,
            dut: zero,
            after: zero,
        };
        assert_eq!(
            readings.ratio(Example::Example2),
            Err(Reason::ReferenceDead)
        );
    }
}
