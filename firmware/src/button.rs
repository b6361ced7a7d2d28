//! The one button: a tap starts the default list, a press stops a run, and a
//! hand that stays on it allows what no host may do alone.
//!
//! | seen | means |
//! |---|---|
//! | up, down | [`Press::Down`]: a run is stopped at once |
//! | up again within [`TAP_PERIODS`] | [`Press::Tap`] |
//! | down for [`FIRM_PERIODS`] to [`HELD_PERIODS`] | [`Button::is_held`] |
//! | down for longer, or since the start | stuck: nothing |
//!
//! A press that was good for something else is no tap ([`Button::consume`]).

/// Time between two looks, ms; a bounce is shorter.
pub const PERIOD_MS: u64 = 20;
/// Longest tap: 1 s.
const TAP_PERIODS: u32 = 50;
/// A hand is on it, and no spark: 40 ms.
const FIRM_PERIODS: u32 = 2;
/// Longest hand: a minute. What stays down longer is stuck.
const HELD_PERIODS: u32 = 3_000;

/// Event a look at the button found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Press {
    /// Nothing new.
    Nothing,
    /// It went down.
    Down,
    /// It was down for a moment.
    Tap,
}

/// The button, looked at every [`PERIOD_MS`].
#[derive(Clone, Copy, Debug)]
pub struct Button {
    /// Looks at which it was down in a row.
    down_periods: u32,
    /// This press has had its effect.
    consumed: bool,
}

impl Button {
    /// The button at the start: one that is down then is stuck.
    pub const fn new(is_down: bool) -> Self {
        Self {
            down_periods: if is_down { u32::MAX } else { 0 },
            consumed: is_down,
        }
    }

    /// Takes a look.
    pub fn look(&mut self, is_down: bool) -> Press {
        let before = self.down_periods;
        self.down_periods = if is_down { before.saturating_add(1) } else { 0 };
        match (before, is_down) {
            (0, true) => {
                self.consumed = false;
                Press::Down
            }
            (1..=TAP_PERIODS, false) if !self.consumed => Press::Tap,
            _ => Press::Nothing,
        }
    }

    /// This press has had its effect: letting go has none.
    pub fn consume(&mut self) {
        self.consumed = true;
    }

    /// Whether a hand holds it down.
    pub fn is_held(&self) -> bool {
        (FIRM_PERIODS..=HELD_PERIODS).contains(&self.down_periods)
    }

    /// Whether a hand has held it down for so many periods.
    pub fn is_held_for(&self, periods: u32) -> bool {
        self.is_held() && self.down_periods >= periods
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn hold(button: &mut Button, periods: u32) {
        for _ in 0..periods {
            button.look(true);
        }
    }

    #[test]
    fn a_tap_is_short_and_known_when_let_go() {
        let mut button = Button::new(false);
        assert_eq!(button.look(false), Press::Nothing);
        assert_eq!(button.look(true), Press::Down);
        hold(&mut button, TAP_PERIODS - 1);
        assert_eq!(button.look(false), Press::Tap);
        hold(&mut button, TAP_PERIODS + 1);
        assert_eq!(button.look(false), Press::Nothing);
    }

    #[test]
    fn a_press_that_had_its_effect_is_no_tap_and_the_next_is() {
        let mut button = Button::new(false);
        button.look(true);
        button.consume();
        assert_eq!(button.look(false), Press::Nothing);
        button.look(true);
        assert_eq!(button.look(false), Press::Tap);
    }

    #[test]
    fn a_hand_holds_from_the_second_look_for_a_minute() {
        let mut button = Button::new(false);
        button.look(true);
        assert!(!button.is_held());
        button.look(true);
        assert!(button.is_held());
        assert!(button.is_held_for(2) && !button.is_held_for(3));
        hold(&mut button, 60_000 / PERIOD_MS as u32 - 2);
        assert!(button.is_held());
        button.look(true);
        assert!(!button.is_held(), "stuck");
        button.look(false);
        hold(&mut button, FIRM_PERIODS);
        assert!(button.is_held());
    }

    #[test]
    fn a_button_stuck_at_the_start_does_nothing_until_it_was_up() {
        let mut button = Button::new(true);
        hold(&mut button, 10);
        assert!(!button.is_held());
        assert_eq!(button.look(false), Press::Nothing);
        assert_eq!(button.look(true), Press::Down);
    }
}
