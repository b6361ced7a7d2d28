//! Lamps and button.

use super::selected::PANEL;
use embassy_stm32::Peri;
use embassy_stm32::gpio::{AnyPin, Input, Level, Output, Speed};

/// A lamp.
pub(crate) struct Lamp(Output<'static>);

impl Lamp {
    /// The lamp at `pin`, dark.
    pub(super) fn new(pin: Peri<'static, AnyPin>) -> Self {
        Self(Output::new(pin, level(false), Speed::Low))
    }

    /// Lights the lamp, or darkens it.
    pub(crate) fn set(&mut self, lit: bool) {
        self.0.set_level(level(lit));
    }
}

fn level(lit: bool) -> Level {
    Level::from(lit == (PANEL.lit == Level::High))
}

/// Lamps of the board.
pub(crate) struct Lamps {
    /// Winks: ready. Lit: PASS.
    pub(crate) green: Lamp,
    /// Lit: measuring. Of another colour on some boards.
    pub(crate) yellow: Lamp,
    /// Refused, FAIL with yellow in turn, or a fault.
    pub(crate) red: Lamp,
}

/// The button.
pub(crate) struct PushButton(Input<'static>);

impl PushButton {
    /// The button at `pin`.
    pub(super) fn new(pin: Peri<'static, AnyPin>) -> Self {
        Self(Input::new(pin, PANEL.button_pull))
    }

    /// Whether it is down.
    pub(crate) fn is_down(&self) -> bool {
        self.0.get_level() == PANEL.pressed
    }
}
