//! One measuring channel: motion, response, converter, and what is picked up on the way.

use super::section::Section;

/// A device that lifts off when the table falls away, at a threshold.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Separation {
    /// Acceleration at which it separates, m/s2.
    pub threshold_ms2: f64,
    /// Cut on the side of positive acceleration instead of the negative one.
    pub upper: bool,
    /// Noise of the impacts, r.m.s., over the excess of the peak acceleration.
    pub impact_noise: f64,
}

impl Separation {
    /// The motion of the device for `acceleration_ms2` of the table.
    pub fn motion_ms2(&self, acceleration_ms2: f64) -> f64 {
        if self.upper {
            acceleration_ms2.min(self.threshold_ms2)
        } else {
            acceleration_ms2.max(-self.threshold_ms2)
        }
    }

    /// How far `peak_ms2` lies above the threshold, m/s2, at least 0.
    pub fn excess_ms2(&self, peak_ms2: f64) -> f64 {
        (peak_ms2 - self.threshold_ms2).max(0.0)
    }
}

/// A converter's static characteristic.
///
/// # Equation
/// `y = clip(k tanh((w + c2 w^2 + c3 w^3)/k))` where `w` is the input less its dead zone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Characteristic {
    /// c2, 1/V.
    pub second_per_v: f64,
    /// c3, 1/V2.
    pub third_per_v2: f64,
    /// Half width of the dead zone, V.
    pub dead_zone_v: f64,
    /// Voltage towards which it bends as a hyperbolic tangent, V peak; infinite if it does not.
    pub knee_v: f64,
    /// Saturation, V peak; infinite if there is none.
    pub threshold_v: f64,
}

impl Characteristic {
    /// Output equals input.
    pub const IDEAL: Self = Self {
        second_per_v: 0.0,
        third_per_v2: 0.0,
        dead_zone_v: 0.0,
        knee_v: f64::INFINITY,
        threshold_v: f64::INFINITY,
    };

    /// The output for `input_v`.
    pub fn output_v(&self, input_v: f64) -> f64 {
        let w = input_v - input_v.clamp(-self.dead_zone_v, self.dead_zone_v);
        let bent = w + w * w * (self.second_per_v + self.third_per_v2 * w);
        let soft = if self.knee_v.is_finite() {
            self.knee_v * (bent / self.knee_v).tanh()
        } else {
            bent
        };
        soft.clamp(-self.threshold_v, self.threshold_v)
    }
}

/// Lines at the first three multiples of the mains frequency.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pickup {
    /// V r.m.s. of the lines at 1, 2 and 3 times the mains frequency.
    pub lines_rms_v: [f64; 3],
    /// Frequency of the mains, Hz.
    pub mains_hz: f64,
}

/// A gain that comes to rest as what warms up does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WarmUp {
    /// Relative deviation at the start.
    pub cold_rel: f64,
    /// Time constant, s.
    pub time_constant_s: f64,
}

/// A range of a converter that is taken above a level.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// Peak above which it is taken, V.
    pub threshold_v: f64,
    /// Its gain over that of the range below, less one.
    pub step_rel: f64,
}

/// One measuring channel.
#[derive(Clone, Debug, PartialEq)]
pub struct Channel {
    /// Volts per m/s2 where all sections are 1.
    pub sensitivity_v_per_ms2: f64,
    /// Constant factor on it.
    pub gain: f64,
    /// Relative change of the gain per second.
    pub drift_per_s: f64,
    /// How far the gain is off until it is warm.
    pub warm_up: WarmUp,
    /// From the table to the mounting face of the transducer.
    pub motion: Vec<Section>,
    /// Lift-off.
    pub separation: Option<Separation>,
    /// From the mounting face to the converter.
    pub response: Vec<Section>,
    /// Relative change of the gain per m/s2 r.m.s. of acceleration, s2/m.
    pub level_gain_per_ms2: f64,
    /// Relative second harmonic per m/s2 r.m.s. of acceleration, s2/m.
    pub level_second_per_ms2: f64,
    /// Growth of the delay of this channel's converter per second, 1.
    pub clock_delta: f64,
    /// Mains pickup.
    pub pickup: Pickup,
    /// A coarser range of the converter.
    pub range: Option<Range>,
    /// The converter's characteristic.
    pub converter: Characteristic,
}

impl Channel {
    /// Whether every section has a causal network: a coupling with a constant phase angle has none.
    pub fn is_causal(&self) -> bool {
        let causal = |section: &Section| match section {
            Section::Coupling { quadrature, .. } => *quadrature == 0.0,
            _ => true,
        };
        self.motion.iter().chain(&self.response).all(causal)
    }

    /// Gain at a time over the stated one.
    pub fn gain_at(&self, time_s: f64) -> f64 {
        let still_cold = (-time_s / self.warm_up.time_constant_s).exp();
        (1.0 + self.drift_per_s * time_s) * (1.0 + self.warm_up.cold_rel * still_cold)
    }

    /// Gain of the range that is taken for a peak at the converter.
    pub fn range_gain(&self, peak_v: f64) -> f64 {
        let taken = self.range.filter(|range| peak_v > range.threshold_v);
        1.0 + taken.map_or(0.0, |range| range.step_rel)
    }

    /// A flat channel.
    pub fn flat(sensitivity_v_per_ms2: f64) -> Self {
        Self {
            sensitivity_v_per_ms2,
            gain: 1.0,
            drift_per_s: 0.0,
            warm_up: WarmUp {
                cold_rel: 0.0,
                time_constant_s: 1.0,
            },
            motion: Vec::new(),
            separation: None,
            response: Vec::new(),
            level_gain_per_ms2: 0.0,
            level_second_per_ms2: 0.0,
            clock_delta: 0.0,
            pickup: Pickup::default(),
            range: None,
            converter: Characteristic::IDEAL,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn characteristics_are_those_of_their_names() {
        let dead = Characteristic {
            dead_zone_v: 0.1,
            ..Characteristic::IDEAL
        };
        assert_eq!([dead.output_v(0.05), dead.output_v(-0.05)], [0.0, 0.0]);
        assert!((dead.output_v(1.0) - 0.9).abs() < 1e-15);
        let clipped = Characteristic {
            threshold_v: 0.5,
            ..Characteristic::IDEAL
        };
        assert_eq!(
            [
                clipped.output_v(0.7),
                clipped.output_v(-0.7),
                clipped.output_v(0.4)
            ],
            [0.5, -0.5, 0.4]
        );
        let bent = Characteristic {
            second_per_v: 0.1,
            third_per_v2: 0.01,
            ..Characteristic::IDEAL
        };
        assert!((bent.output_v(2.0) - 2.48).abs() < 1e-14);
        // tanh(1) = (e^2 - 1)/(e^2 + 1).
        let soft = Characteristic {
            knee_v: 2.0,
            ..Characteristic::IDEAL
        };
        let e2 = std::f64::consts::E.powi(2);
        assert!((soft.output_v(-2.0) + 2.0 * (e2 - 1.0) / (e2 + 1.0)).abs() < 1e-14);
        let below = Separation {
            threshold_ms2: 5.0,
            upper: false,
            impact_noise: 0.0,
        };
        assert_eq!([below.motion_ms2(9.0), below.motion_ms2(-9.0)], [9.0, -5.0]);
        assert_eq!([below.excess_ms2(7.0), below.excess_ms2(3.0)], [2.0, 0.0]);
    }
}
