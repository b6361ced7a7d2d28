//! Limits of the exciter at a frequency.

use crate::point_state::Reason;
use crate::settings::Limits;

/// Angular frequency, rad/s.
fn omega(frequency_hz: f32) -> f32 {
    core::f32::consts::TAU * frequency_hz
}

/// Refuses a level the exciter's limits exclude at this frequency.
///
/// # Equation
/// `v = a / w`, `d = a / w^2`, all peak values of a sine.
///
/// # Errors
/// [`Reason::AccelerationLimit`], [`Reason::VelocityLimit`] or
/// [`Reason::DisplacementLimit`], in this order.
pub fn check_level(limits: &Limits, frequency_hz: f32, peak_ms2: f32) -> Result<(), Reason> {
    let omega = omega(frequency_hz);
    if !(peak_ms2 > 0.0 && peak_ms2 <= limits.acceleration_peak_ms2) {
        Err(Reason::AccelerationLimit)
    } else if peak_ms2 / omega > limits.velocity_peak_ms {
        Err(Reason::VelocityLimit)
    } else if peak_ms2 / (omega * omega) > limits.displacement_peak_m {
        Err(Reason::DisplacementLimit)
    } else {
        Ok(())
    }
}

/// Largest acceleration the limits allow at this frequency, m/s2 peak.
pub fn full_output_peak_ms2(limits: &Limits, frequency_hz: f32) -> f32 {
    let omega = omega(frequency_hz);
    limits
        .acceleration_peak_ms2
        .min(limits.velocity_peak_ms * omega)
        .min(limits.displacement_peak_m * omega * omega)
}

#[cfg(test)]
mod tests {
    use super::*;

    const LIMITS: Limits = Limits {
        drive_peak_v: 10.0,
        acceleration_peak_ms2: 200.0,
        velocity_peak_ms: 1.0,
        displacement_peak_m: 0.005,
    };

    #[test]
    fn each_limit_refuses_its_own_excess() {
        // By hand: 5 mm at 5 Hz are (2 pi 5)^2 * 0.005 = 4.93 m/s2, at 20 Hz
        // 79 m/s2; 1 m/s at 30 Hz is 188 m/s2.
        assert_eq!(check_level(&LIMITS, 5.0, 4.9), Ok(()));
        assert_eq!(
            check_level(&LIMITS, 5.0, 5.0),
            Err(Reason::DisplacementLimit)
        );
        assert_eq!(check_level(&LIMITS, 20.0, 78.0), Ok(()));
        assert_eq!(
            check_level(&LIMITS, 30.0, 190.0),
            Err(Reason::VelocityLimit)
        );
        assert_eq!(
            check_level(&LIMITS, 1000.0, 201.0),
            Err(Reason::AccelerationLimit)
        );
        assert_eq!(
            check_level(&LIMITS, 1000.0, f32::NAN),
            Err(Reason::AccelerationLimit)
        );
    }

    #[test]
    fn full_output_is_the_level_just_allowed() {
        for frequency_hz in [5.0, 20.0, 31.5, 160.0, 10_000.0] {
            let full = full_output_peak_ms2(&LIMITS, frequency_hz);
            assert_eq!(check_level(&LIMITS, frequency_hz, full * 0.9999), Ok(()));
            assert!(check_level(&LIMITS, frequency_hz, full * 1.0001).is_err());
        }
    }
}
