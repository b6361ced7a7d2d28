//! The parameters of a simulated oscillator: their bounds, and their steps for slopes.

use super::run::Run;
use crate::thresholds;
use calib_effects::oscillator::{HYSTERESIS, INPUT_DELAY, SECOND_MODE};
use std::ops::{Index, IndexMut};

/// A parameter of a simulated oscillator. Forces are in units of w0^2, time in units of 1/w0;
/// displacements in the unit of the output, written x below.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Parameter {
    /// ln of w0 in rad/s.
    LnResonance,
    /// Damping ratio.
    Delta,
    /// x over the input, at rest.
    Gain,
    /// Output at rest.
    Offset,
    /// Displacement at the first sample.
    Displacement,
    /// Velocity at the first sample.
    Velocity,
    /// Force over x^3.
    CubicStiffness,
    /// Force over x^2.
    QuadraticStiffness,
    /// Force over the velocity squared.
    QuadraticDamping,
    /// Force over the velocity cubed.
    CubicDamping,
    /// Force against the velocity.
    CoulombFriction,
    /// Steady force.
    SteadyForce,
    /// Delay of the input, in samples.
    Delay,
    /// One over the input at which it saturates.
    Saturation,
    /// Corner of the output's high-pass, in rad/s.
    HighpassCorner,
    /// Time constant of the output's low-pass, in samples.
    Lag,
    /// Growth of the output's zero in a sample.
    Trend,
    /// One over the output at which it is clipped.
    Clipping,
    /// Growth of w0 in a sample, relative, from the first sample of the file on.
    ResonanceDrift,
    /// Gain of the second mode over that of the first.
    ModeGain,
    /// ln of the frequency of the second mode over w0.
    ModeLnRatio,
    /// Damping ratio of the second mode.
    ModeDamping,
    /// Half width of the play.
    DeadZone,
    /// Share of the spring that yields.
    YieldingShare,
    /// ln of the deflection at which it yields.
    LnYieldDeflection,
    /// State of the high-pass at the first sample.
    HeldBack,
    /// Lead of the low-pass, at the first sample, over where a steady motion leaves it.
    Lagging,
    /// Displacement of the second mode at the first sample.
    ModeDisplacement,
    /// Velocity of the second mode at the first sample.
    ModeVelocity,
}

use Parameter::*;

/// Parameters of the linear oscillator, which every fit moves.
pub(crate) const LINEAR: [Parameter; 6] =
    [LnResonance, Delta, Gain, Offset, Displacement, Velocity];

/// The values of all parameters.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct OscillatorParameters([f64; ModeVelocity as usize + 1]);

impl Index<Parameter> for OscillatorParameters {
    type Output = f64;

    fn index(&self, parameter: Parameter) -> &f64 {
        &self.0[parameter as usize]
    }
}

impl IndexMut<Parameter> for OscillatorParameters {
    fn index_mut(&mut self, parameter: Parameter) -> &mut f64 {
        &mut self.0[parameter as usize]
    }
}

impl OscillatorParameters {
    /// Resonance of the linear oscillator.
    pub(super) fn resonance_hz(&self) -> f64 {
        self[LnResonance].exp() / std::f64::consts::TAU
    }

    /// Sets the motion at the first sample.
    pub(super) fn set_first_state(&mut self, record: &Run) {
        (self[Displacement], self[Velocity]) = record.first_state(self[LnResonance]);
        self[Displacement] -= self[Offset];
    }
}

/// Keeps some of the values where the simulation can follow them; `unit` is the size of the output.
pub(super) fn bound(
    values: &mut OscillatorParameters,
    moved: &[Parameter],
    record: &Run,
    unit: f64,
) {
    // A mode must lie below half the rate at which the force is known, the first one too.
    let half_rate = std::f64::consts::PI / record.interval_s;
    let of = |known: &calib_effects::Parameter| (known.lower, known.upper);
    for &parameter in moved {
        let (lower, upper) = match parameter {
            LnResonance => (half_rate.ln() - thresholds::LOWEST_LN, half_rate.ln()),
            Delta => (1e-5, 2.0),
            // Friction and damping take energy out.
            QuadraticDamping | CubicDamping | CoulombFriction => (0.0, f64::INFINITY),
            Saturation | Clipping => (0.0, f64::INFINITY),
            HighpassCorner => (0.0, half_rate),
            // An output before its input is no delay.
            Delay => (0.0, of(&INPUT_DELAY.parameters[0]).1 / record.interval_s),
            // Less would forget its state within rounding.
            Lag if moved.contains(&Lagging) => (thresholds::LAG_SEEN, record.input.len() as f64),
            Lag => (0.0, record.input.len() as f64),
            ModeLnRatio => (-7.0, half_rate.ln() - values[LnResonance]),
            ModeDamping => of(&SECOND_MODE.parameters[2]),
            DeadZone => (0.0, 10.0 * unit),
            YieldingShare => of(&HYSTERESIS.parameters[0]),
            LnYieldDeflection => ((1e-3 * unit).ln(), (30.0 * unit).ln()),
            _ => (f64::NEG_INFINITY, f64::INFINITY),
        };
        values[parameter] = values[parameter].max(lower).min(upper);
    }
}

/// Change of a value for its slope; `unit` is the size of the output.
pub(super) fn slope_step(values: &OscillatorParameters, parameter: Parameter, unit: f64) -> f64 {
    match parameter {
        LnResonance => 1e-6,
        Delta | ModeGain => 1e-5,
        Gain => 1e-5 * values[Gain].abs().max(1e-12),
        Offset | SteadyForce | Displacement | Velocity | HeldBack | Lagging | ModeDisplacement
        | ModeVelocity | CoulombFriction => 1e-5 * unit,
        CubicStiffness => 1e-3 / (unit * unit),
        QuadraticStiffness => 1e-3 / unit,
        QuadraticDamping => 1e-4 / unit,
        CubicDamping => 1e-4 / (unit * unit),
        Saturation | Clipping => 1e-4 * values[parameter].max(1e-9),
        DeadZone => 1e-4 * unit,
        // Over the samples of a short record as much as an offset.
        Trend => 1e-8 * unit,
        ResonanceDrift => 1e-9,
        HighpassCorner => 2e-6 * values[LnResonance].exp(),
        Delay | Lag | ModeLnRatio | ModeDamping | YieldingShare | LnYieldDeflection => 1e-3,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dataset::Record;

    /// An output cannot come before its input, and the vocabulary knows delays up to a second.
    #[test]
    fn a_delay_stays_within_what_the_vocabulary_knows() {
        let record = Record {
            interval_s: 1e-3,
            before: 0,
            input: vec![1.0; 100],
            output: vec![1.0; 100],
        };
        let run = Run::new(&record, 2);
        let bounded = |delay| {
            let mut values = OscillatorParameters::default();
            values[Delay] = delay;
            bound(&mut values, &[Delay], &run, 1.0);
            values[Delay]
        };
        assert_eq!([-57.0, 0.4, 2e3].map(bounded), [0.0, 0.4, 1e3]);
    }
}
