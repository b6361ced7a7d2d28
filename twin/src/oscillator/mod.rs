//! A single oscillator in time: the model of ISO 16063-43 formula (1) with what it leaves out.
//!
//! Integrated by Runge-Kutta steps of fourth order on an input that is known at all times, so
//! neither the input nor the motion is sampled before it is recorded.

mod integrate;
mod multisine;

pub use self::integrate::simulate;
pub use self::multisine::Multisine;

/// An oscillator, effects included; amplitudes in the unit of the output.
///
/// # Equation
/// `x'' + 2 delta w0 x' (1 + d2 |x'|/w0 + d3 (x'/w0)^2) + w0^2 F = rho (a(t - tau) + a0)` with the spring
/// `F = dz(x) + ((1 + r t)^2 - 1) x + k2 x^2 + k3 x^3 + alpha z + xc sign(x')`, where dz leaves out the play and
/// `z' = x' - (|x'| z + x' |z|)/(2 zy)`. The output is `x + x2` through a high-pass and a low-pass,
/// with a trend, clipped.
///
/// # Source
/// ISO 16063-43:2015, 7.1, formula (1) for the linear part.
#[derive(Clone, Debug, PartialEq)]
pub struct Oscillator {
    /// rho, output per input times `w0^2` at rest.
    pub rho: f64,
    /// w0 / 2 pi, Hz.
    pub resonance_hz: f64,
    /// r, growth of the resonance from the first sample on, relative, per s.
    pub resonance_drift_per_s: f64,
    /// delta.
    pub damping: f64,
    /// k2, 1/output.
    pub quadratic_stiffness: f64,
    /// k3, 1/output2.
    pub cubic_stiffness: f64,
    /// d2, 1/output.
    pub quadratic_damping: f64,
    /// d3, 1/output2.
    pub cubic_damping: f64,
    /// xc, output.
    pub friction: f64,
    /// Half width of the play dz, output.
    pub dead_zone: f64,
    /// alpha.
    pub hysteresis: f64,
    /// zy, output.
    pub yield_deflection: f64,
    /// tau, s.
    pub input_delay_s: f64,
    /// The input saturates here; infinite if it does not.
    pub input_threshold: f64,
    /// a0, beside what saturation lets through; input.
    pub input_offset: f64,
    /// Corner of the output's high-pass, Hz; 0 is none.
    pub output_corner_hz: f64,
    /// Corner of the output's low-pass, Hz; infinite is none.
    pub output_lowpass_hz: f64,
    /// Growth of the output's zero from the first sample on, per s.
    pub output_drift_per_s: f64,
    /// The output is clipped here; infinite if it is not.
    pub output_threshold: f64,
    /// Gain of a second mode.
    pub second_gain: f64,
    /// Its frequency, Hz.
    pub second_hz: f64,
    /// Its damping.
    pub second_damping: f64,
}

impl Oscillator {
    /// The linear oscillator.
    pub fn linear(rho: f64, resonance_hz: f64, damping: f64) -> Self {
        Self {
            rho,
            resonance_hz,
            resonance_drift_per_s: 0.0,
            damping,
            quadratic_stiffness: 0.0,
            cubic_stiffness: 0.0,
            quadratic_damping: 0.0,
            cubic_damping: 0.0,
            friction: 0.0,
            dead_zone: 0.0,
            hysteresis: 0.0,
            yield_deflection: 1.0,
            input_delay_s: 0.0,
            input_threshold: f64::INFINITY,
            input_offset: 0.0,
            output_corner_hz: 0.0,
            output_lowpass_hz: f64::INFINITY,
            output_drift_per_s: 0.0,
            output_threshold: f64::INFINITY,
            second_gain: 0.0,
            second_hz: 1.0,
            second_damping: 1.0,
        }
    }
}

#[cfg(test)]
mod tests;
