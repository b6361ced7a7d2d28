//! Terms of an oscillator beside mass, damping and spring, at one instant.

use super::mode::State;
use super::parameters::{OscillatorParameters, Parameter};

/// Parameters of the forces; without any the motion is that of the linear oscillator.
const FORCES: [Parameter; 9] = [
    Parameter::CubicStiffness,
    Parameter::QuadraticStiffness,
    Parameter::QuadraticDamping,
    Parameter::CubicDamping,
    Parameter::CoulombFriction,
    Parameter::Saturation,
    Parameter::DeadZone,
    Parameter::YieldingShare,
    Parameter::ResonanceDrift,
];

/// The terms of an oscillator, as an acceleration in units of w0^2.
pub(super) struct Terms<'a> {
    pub(super) values: &'a OscillatorParameters,
    yields_at: f64,
    /// Gain of the spring since the first sample of the file, relative.
    stiffer: f64,
    /// Slope of dry friction about rest: as steep as the steps can follow.
    steepness: f64,
    /// Whether there are any.
    pub(super) some: bool,
}

impl<'a> Terms<'a> {
    pub(super) fn new(values: &'a OscillatorParameters, step: f64) -> Self {
        let acts = |parameter: &Parameter| values[*parameter] != 0.0;
        Self {
            values,
            stiffer: 0.0,
            yields_at: values[Parameter::LnYieldDeflection].exp(),
            steepness: 1.0 / (values[Parameter::CoulombFriction] * step).max(1e-9),
            some: FORCES.iter().any(acts),
        }
    }

    /// The terms some samples behind the first of the file.
    pub(super) fn at_sample(&mut self, sample: f64) {
        let grown = self.values[Parameter::ResonanceDrift] * sample;
        self.stiffer = grown * (2.0 + grown);
    }

    /// Part of the input that saturation cuts off.
    pub(super) fn lacking(&self, input: f64) -> f64 {
        let saturation = self.values[Parameter::Saturation];
        if saturation > 0.0 {
            input.clamp(-1.0 / saturation, 1.0 / saturation) - input
        } else {
            0.0
        }
    }

    pub(super) fn at(&self, [x, v]: State, yielding: f64, lacking: f64) -> f64 {
        let of = |parameter: Parameter| self.values[parameter];
        let spring = of(Parameter::QuadraticStiffness) + of(Parameter::CubicStiffness) * x;
        let mut sum =
            -x * (self.stiffer + x * spring) - v * v.abs() * of(Parameter::QuadraticDamping);
        sum += of(Parameter::Gain) * lacking - of(Parameter::CubicDamping) * v * v * v;
        let friction = of(Parameter::CoulombFriction);
        if friction != 0.0 {
            sum -= friction * (v * self.steepness).clamp(-1.0, 1.0);
        }
        let play = of(Parameter::DeadZone);
        if play > 0.0 {
            sum += x.clamp(-play, play);
        }
        sum - of(Parameter::YieldingShare) * yielding
    }

    /// The yielding part of the spring after a way.
    pub(super) fn yielded(&self, before: f64, way: f64) -> f64 {
        if self.values[Parameter::YieldingShare] == 0.0 {
            0.0
        } else {
            yielded(before, way, self.yields_at)
        }
    }
}

/// The yielding part of a spring after a way, if the motion does not turn back on it:
/// z' = x' - (|x'| z + x' |z|)/(2 zy) is straight until z has the sign of x', then exponential.
fn yielded(z: f64, way: f64, yields_at: f64) -> f64 {
    let sign = if way < 0.0 { -1.0 } else { 1.0 };
    let (mut z, mut way) = (sign * z, way.abs());
    if z < 0.0 {
        let straight = way.min(-z);
        (z, way) = (z + straight, way - straight);
    }
    sign * (yields_at - (yields_at - z) * (-way / yields_at).exp())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Euler steps of a hundred-thousandth of the way: their error is of that order.
    #[test]
    fn a_spring_yields_as_its_equation_says() {
        let yields_at = 0.3;
        for (start, way) in [(0.0, 0.5), (-0.2, 0.9), (0.1, -0.7), (0.29, -0.1)] {
            let (mut z, steps) = (start, 100_000);
            let dx: f64 = way / f64::from(steps);
            for _ in 0..steps {
                z += dx - (dx.abs() * z + dx * z.abs()) / (2.0 * yields_at);
            }
            let found = yielded(start, way, yields_at);
            assert!((found - z).abs() < 1e-5, "{start} {way}: {found} {z}");
        }
    }
}
