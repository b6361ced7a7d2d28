//! Patterns of the lamps.
//!
//! | shown | green | yellow | red |
//! |---|---|---|---|
//! | ready | winks every two seconds | | |
//! | a run goes on | | lit | |
//! | PASS | lit | | |
//! | FAIL | | takes turns with red, four times a second | takes turns with yellow |
//! | NOT JUDGEABLE | | on for a second, off for a second | |
//! | a point was refused, or the record not stored | | | lit |
//! | degraded | | lit while a run goes on | blinks, counted |
//!
//! They differ in rhythm too, for people who do not tell red from green.

use crate::button::PERIOD_MS;
use calib_core::conformity::Conformity;
use calib_protocol::health::Defects;

/// A blink is dark and lit for so many periods each: a quarter of a second.
const HALF_BLINK: u32 = (250 / PERIOD_MS) as u32;
/// Dark behind the blinks of a defect: a second and a half.
const PAUSE: u32 = (1_500 / PERIOD_MS) as u32;
/// The green lamp winks so often.
const WINK_EVERY: u32 = (2_000 / PERIOD_MS) as u32;
/// How long a wink is.
const WINK: u32 = (100 / PERIOD_MS) as u32;
/// Red and yellow take turns so often: they change eight times a second.
const TURN: u32 = (120 / PERIOD_MS) as u32;
/// Yellow is on or off for so long: a second.
const SLOW: u32 = (1_000 / PERIOD_MS) as u32;

/// States the lamps show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shown {
    /// Nothing happened, or a run of a host whose points are valid: nothing was judged.
    Ready,
    /// A run goes on.
    Running,
    /// Result of the chosen list.
    Judged(Conformity),
    /// A point of a run was refused, or its record could not be stored.
    Refused,
    /// Something does not work; whether a run goes on.
    Degraded(Defects, bool),
}

/// Which lamps are lit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Lit {
    /// The green one.
    pub green: bool,
    /// The yellow one, which is of another colour on some boards.
    pub yellow: bool,
    /// The red one.
    pub red: bool,
}

impl Shown {
    /// Which lamps are lit in this period of [`PERIOD_MS`], counted from any.
    pub fn lit(self, period: u32) -> Lit {
        let dark = Lit::default();
        match self {
            Self::Ready => Lit {
                green: period % WINK_EVERY < WINK,
                ..dark
            },
            Self::Running => Lit {
                yellow: true,
                ..dark
            },
            Self::Judged(Conformity::Pass) => Lit {
                green: true,
                ..dark
            },
            Self::Judged(Conformity::Fail) => {
                let red = (period / TURN).is_multiple_of(2);
                Lit {
                    red,
                    yellow: !red,
                    ..dark
                }
            }
            // Neither: the record says which, and why.
            Self::Judged(
                Conformity::ConditionalPass
                | Conformity::ConditionalFail
                | Conformity::NotJudgeable,
            ) => Lit {
                yellow: (period / SLOW).is_multiple_of(2),
                ..dark
            },
            Self::Refused => Lit { red: true, ..dark },
            Self::Degraded(defects, running) => Lit {
                red: is_red_lit(defects, period),
                yellow: running,
                ..dark
            },
        }
    }
}

/// Whether the red lamp is lit in this period, of an instrument that is degraded.
///
/// Each defect blinks once more than its number, in turn, with a pause behind it. One that only a
/// newer release knows is a lamp that stays lit.
fn is_red_lit(defects: Defects, period: u32) -> bool {
    let blinks = || defects.iter().map(|defect| defect as u32 + 1);
    let lasts = |blinks: u32| 2 * HALF_BLINK * blinks + PAUSE;
    let round: u32 = blinks().map(lasts).sum();
    let Some(mut place) = period.checked_rem(round) else {
        return !defects.is_none();
    };
    for count in blinks() {
        if place < lasts(count) {
            return place < 2 * HALF_BLINK * count && (place / HALF_BLINK).is_multiple_of(2);
        }
        place -= lasts(count);
    }
    false
}

#[cfg(test)]
mod tests {
    use super::*;
    use calib_protocol::health::Defect;
    use std::vec::Vec;

    /// Times the lamp goes on in a minute.
    fn blinks(defects: Defects) -> usize {
        let lit: Vec<bool> = (0..60_000 / PERIOD_MS as u32)
            .map(|period| is_red_lit(defects, period))
            .collect();
        lit.windows(2).filter(|pair| pair == &[false, true]).count()
    }

    #[test]
    fn a_defect_is_told_by_how_often_it_blinks() {
        assert_eq!(blinks(Defects::NONE), 0);
        for defect in Defect::ALL {
            let number = defect as u32 + 1;
            let lit: Vec<bool> = (0..2 * HALF_BLINK * number + PAUSE)
                .map(|period| is_red_lit(Defects::NONE.with(defect), period))
                .collect();
            // It begins lit.
            let rises = lit.windows(2).filter(|pair| pair == &[false, true]).count();
            assert_eq!(rises as u32 + 1, number);
            assert!(!lit[lit.len() - PAUSE as usize..].contains(&true));
        }
    }

    #[test]
    fn two_defects_take_turns() {
        let both = Defects::NONE.with(Defect::Archive).with(Defect::Clock);
        // One and four blinks in 5 half seconds and two pauses: 5.5 s.
        assert!((53..=55).contains(&blinks(both)), "{}", blinks(both));
    }

    /// Of a lamp in a minute: the share it is lit for, in percent, and how often it goes on.
    fn rhythm(shown: Shown, lamp: fn(Lit) -> bool) -> (usize, usize) {
        let lit: Vec<bool> = (0..3_000).map(|period| lamp(shown.lit(period))).collect();
        let rises = lit.windows(2).filter(|pair| pair == &[false, true]).count();
        (lit.iter().filter(|lit| **lit).count() / 30, rises)
    }

    /// Everything the lamps can say, but for several defects at once.
    fn all() -> Vec<Shown> {
        let judged = [Conformity::Pass, Conformity::Fail, Conformity::NotJudgeable];
        let mut all = vec![Shown::Ready, Shown::Running, Shown::Refused];
        all.extend(judged.map(Shown::Judged));
        all.extend(Defect::ALL.map(|defect| Shown::Degraded(Defects::NONE.with(defect), false)));
        all
    }

    #[test]
    fn no_two_things_look_alike_and_none_is_dark() {
        let seen = |shown| {
            [
                rhythm(shown, |lit| lit.green),
                rhythm(shown, |lit| lit.yellow),
                rhythm(shown, |lit| lit.red),
            ]
        };
        for (index, shown) in all().into_iter().enumerate() {
            assert_ne!(seen(shown), [(0, 0); 3], "{shown:?}");
            for other in all().into_iter().skip(index + 1) {
                assert_ne!(seen(shown), seen(other), "{shown:?} and {other:?}");
            }
        }
    }

    /// Who sees one lamp alone, be it for a colour or for the sun: PASS is the only one that is lit for good and not
    /// red or yellow, and FAIL changes eight times a second.
    #[test]
    fn pass_and_fail_differ_in_rhythm() {
        let green = |shown| rhythm(shown, |lit| lit.green);
        assert_eq!(green(Shown::Judged(Conformity::Pass)), (100, 0));
        for other in all() {
            let is_pass = other == Shown::Judged(Conformity::Pass);
            assert!(is_pass || green(other).0 <= 5, "{other:?}");
        }
        let fail = rhythm(Shown::Judged(Conformity::Fail), |lit| lit.red);
        assert!((248..=252).contains(&fail.1), "{fail:?}");
    }

    #[test]
    fn what_is_neither_pass_nor_fail_is_shown_as_neither() {
        for conformity in [Conformity::ConditionalPass, Conformity::ConditionalFail] {
            for period in 0..500 {
                let shown = Shown::Judged(conformity).lit(period);
                assert_eq!(shown, Shown::Judged(Conformity::NotJudgeable).lit(period));
            }
        }
    }
}
