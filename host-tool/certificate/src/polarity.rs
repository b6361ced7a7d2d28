//! Polarity of a sensor (ISO 16063-21, Annex B): one decision for a calibration, by the rule of the instrument.
//!
//! The first valid point that was measured decides, against the motion that the sensor is one of, and what it decides holds
//! for all points. Terminal, page, certificate and every format state phases by it. Of a sensor of acceleration the
//! instrument has decided; a point that was measured again in another run, where another point came first, is turned to
//! the decision of the first.

use super::kind::{OfSensor, SensorKind};
use calib_core::point::PointResult;
use calib_core::point_state::PointState;
use calib_core::quantity::{MotionQuantity, Sensitivity};
use calib_output::number::decimal;
use std::f32::consts::{FRAC_PI_2, FRAC_PI_4, PI};

/// Polarity of a sensor, as the points of its calibration tell it in the order they were measured.
#[derive(Clone, Copy, Debug)]
pub struct Polarity {
    kind: SensorKind,
    decided: Option<Decided>,
}

#[derive(Clone, Copy, Debug)]
struct Decided {
    inverted: bool,
    /// Against the motion of the sensor, as measured, rad.
    phase_rad: f32,
}

impl Polarity {
    /// Of a sensor of this kind, of which nothing was measured.
    pub fn new(kind: SensorKind) -> Self {
        Self {
            kind,
            decided: None,
        }
    }

    /// Of a sensor whose polarity is known.
    pub fn decided(kind: SensorKind, inverted: bool) -> Self {
        let phase_rad = if inverted { PI } else { 0.0 };
        let decided = Some(Decided {
            inverted,
            phase_rad,
        });
        Self { kind, decided }
    }

    /// By the points of a run in the order they were measured.
    pub fn of<'p>(kind: SensorKind, points: impl IntoIterator<Item = &'p PointResult>) -> Self {
        let mut polarity = Self::new(kind);
        points.into_iter().for_each(|point| polarity.hear(point));
        polarity
    }

    /// Kind of the sensor.
    pub fn kind(self) -> SensorKind {
        self.kind
    }

    /// Hears of the next point: the first that is valid decides.
    pub fn hear(&mut self, result: &PointResult) {
        if self.decided.is_some() || result.state != PointState::Valid {
            return;
        }
        let phase_rad = self.against_motion_rad(result);
        // A quarter turn tells nothing of a velocity transducer against acceleration, where the instrument decides.
        let inverted = match self.kind.quantity() {
            MotionQuantity::Acceleration => result.inverted,
            _ => phase_rad.abs() > FRAC_PI_2,
        };
        self.decided = Some(Decided {
            inverted,
            phase_rad,
        });
    }

    /// Whether the sensor is inverted.
    pub fn is_inverted(self) -> bool {
        self.decided.is_some_and(|decided| decided.inverted)
    }

    /// The phase that decided, degrees, where it is nearer to a quarter turn than to either polarity: another sign, or
    /// another kind of sensor than was stated, would explain it as well.
    pub(crate) fn doubtful_deg(self) -> Option<f64> {
        let phase_rad = self.decided?.phase_rad;
        let off_rad = (phase_rad.abs() - FRAC_PI_2).abs();
        (off_rad < FRAC_PI_4).then(|| f64::from(phase_rad).to_degrees())
    }

    /// A result of the instrument as the sensor's.
    pub fn split(self, result: &PointResult, frequency_hz: f64) -> OfSensor {
        let magnitude = decimal(result.sensitivity_v_per_ms2);
        let (phase_rad, turned) = match self.kind.quantity() {
            // As stored, to the last bit, where the instrument decided the same.
            MotionQuantity::Acceleration => {
                (result.phase_rad, result.inverted != self.is_inverted())
            }
            _ => (self.against_motion_rad(result), self.is_inverted()),
        };
        OfSensor {
            magnitude: self.kind.of_v_per_ms2(magnitude, frequency_hz),
            phase_deg: turned_back(f64::from(phase_rad).to_degrees(), turned),
        }
    }

    /// The phase that was measured, polarity included, against the motion of the kind.
    fn against_motion_rad(self, result: &PointResult) -> f32 {
        let turned_rad = if result.inverted { PI } else { 0.0 };
        let measured = Sensitivity {
            quantity: MotionQuantity::Acceleration,
            magnitude: result.sensitivity_v_per_ms2,
            phase_rad: result.phase_rad + turned_rad,
        };
        // Turns are the same at every frequency.
        measured.to(self.kind.quantity(), 1.0).phase_rad
    }
}

/// An angle less half a turn where it is to be turned, in (-180, 180].
fn turned_back(phase_deg: f64, turned: bool) -> f64 {
    match turned {
        false => phase_deg,
        true if phase_deg > 0.0 => phase_deg - 180.0,
        true => phase_deg + 180.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use calib_core::point_state::Reason;
    use calib_record::sample::point;

    fn kind(text: &str) -> SensorKind {
        text.parse().expect(text)
    }

    /// As the instrument gives it.
    fn measured(phase_deg: f32, inverted: bool) -> PointResult {
        let mut result = point(160.0);
        (result.phase_rad, result.inverted) = (phase_deg.to_radians(), inverted);
        result
    }

    /// A coil that follows the velocity lies at -90 degrees against acceleration, where polarity is a toss-up.
    #[test]
    fn polarity_is_told_against_the_sensors_own_motion() {
        // The instrument said of +90.1 degrees: inverted, and -89.9.
        for (phase_deg, told, turned, own_deg) in [
            (-89.9, false, false, 0.1),
            (89.9, true, false, -0.1),
            (-89.9, true, true, 0.1),
            (89.9, false, true, -0.1),
        ] {
            let result = measured(phase_deg, told);
            let polarity = Polarity::of(kind("mV/(mm/s)"), [&result]);
            assert_eq!(polarity.is_inverted(), turned, "{phase_deg} {told}");
            let deg = polarity.split(&result, 160.0).phase_deg;
            assert!((deg - own_deg).abs() < 1e-4, "{phase_deg} {told}: {deg}");
            assert_eq!(polarity.doubtful_deg(), None);
        }
    }

    #[test]
    fn the_first_valid_point_decides_and_what_it_decides_holds() {
        let mut refused = measured(180.0, true);
        refused.state = PointState::Refused(Reason::Hum);
        // A lag of 100 degrees at the end of the range, measured again alone: the instrument took it for inverted.
        let (first, again) = (measured(-2.0, false), measured(80.0, true));
        let polarity = Polarity::of(SensorKind::default(), [&refused, &first, &again]);
        assert!(!polarity.is_inverted());
        let deg = polarity.split(&again, 10_000.0).phase_deg;
        assert!((deg + 100.0).abs() < 1e-4, "{deg}");
        assert!(!Polarity::of(SensorKind::default(), [&refused]).is_inverted());
    }

    /// Stated as one of velocity, an accelerometer leads by a quarter turn.
    #[test]
    fn a_phase_beside_both_polarities_is_doubtful() {
        let result = measured(0.2, false);
        let doubtful = |text| Polarity::of(kind(text), [&result]).doubtful_deg();
        assert!((doubtful("mV/(mm/s)").expect("doubtful") - 90.2).abs() < 1e-4);
        assert_eq!((doubtful("mV/g"), doubtful("mV/um")), (None, None));
    }
}
