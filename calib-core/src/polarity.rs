//! Polarity of a transducer (ISO 16063-21, Annex B).
//!
//! Positive motion goes from the mounting surface through the transducer. A
//! transducer whose output falls then is inverted, which is a property of its
//! wiring and not a phase shift of 180 degrees: it is reported apart, and the
//! phase is given relative to the inverted axis.

use core::f32::consts::{FRAC_PI_2, PI, TAU};

/// Brings an angle into (-pi, pi].
pub fn wrap(phase_rad: f32) -> f32 {
    let turned = phase_rad - TAU * libm::roundf(phase_rad / TAU);
    if turned <= -PI { turned + TAU } else { turned }
}

/// Polarity of the device under test within one run.
///
/// One frequency far below resonance and filters decides: there a phase beyond
/// a quarter turn can only be inversion. That is the reference frequency, which
/// is measured first (5.3); at the others the decision holds, so that a true
/// lag of more than 90 degrees at 10 kHz stays a lag.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Polarity {
    decided: Option<bool>,
}

impl Polarity {
    /// Splits a measured phase into phase and inversion; the first call decides
    /// the polarity.
    pub fn split(&mut self, phase_rad: f32) -> (f32, bool) {
        let phase_rad = wrap(phase_rad);
        let inverted = *self.decided.get_or_insert(phase_rad.abs() > FRAC_PI_2);
        if inverted {
            (wrap(phase_rad - PI), true)
        } else {
            (phase_rad, false)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wrapped_angles_are_the_same_angle_in_the_half_open_turn() {
        for step in -100..=100_i8 {
            let angle = f32::from(step) * 0.25;
            let wrapped = wrap(angle);
            assert!(wrapped > -PI && wrapped <= PI, "{angle}");
            let turns = (angle - wrapped) / TAU;
            // Rounding of 25 rad in f32: 1e-6.
            assert!((turns - turns.round()).abs() < 1.0e-6, "{angle}");
        }
        assert_eq!(wrap(-PI), PI);
    }

    #[test]
    fn an_inverted_transducer_is_reported_as_such_and_not_as_phase() {
        let mut polarity = Polarity::default();
        let (phase, inverted) = polarity.split(PI - 0.02);
        assert!(inverted);
        assert!((phase + 0.02).abs() < 1.0e-6);
    }

    #[test]
    fn the_first_point_decides_for_the_run() {
        let mut polarity = Polarity::default();
        assert_eq!(polarity.split(-0.1), (-0.1, false));
        assert_eq!(polarity.split(-1.7), (-1.7, false));
    }
}
