//! A signal both inputs share: their pins, pulled up and down by the part's own resistors at once.
//!
//! Some 40 kOhm against the 1 kOhm of the front end move either pin by 40 mV, 800 samples of a 16-bit
//! converter, on whatever is there; the table does not move, and nothing is added to the
//! board. The converters sample their pins whatever the port does beside, so the stream that is
//! looked at is the one that measures. The resistors need the port in input mode (RM0433 Rev 8,
//! 11.3.12); that a converter sees its pin in that mode is assumed from other parts of the family.

use embassy_stm32::gpio::{Flex, Pull};
use embassy_time::{Duration, Timer};

/// Between edges: 35 samples, 14 edges in a block of 10 ms.
const BETWEEN: Duration = Duration::from_micros(700);

/// The pins of both inputs.
pub(super) struct CommonSignal {
    pins: [Flex<'static>; 2],
}

impl CommonSignal {
    /// Both pins, at rest.
    pub(super) fn new(pins: [Flex<'static>; 2]) -> Self {
        let mut signal = Self { pins };
        signal.rest();
        signal
    }

    /// Edges until it is dropped; then [`Self::rest`] is due.
    pub(super) async fn play(&mut self) -> ! {
        loop {
            for pull in [Pull::Up, Pull::Down] {
                for pin in &mut self.pins {
                    pin.set_as_input(pull);
                }
                Timer::after(BETWEEN).await;
            }
        }
    }

    /// Nothing pulls at the pins.
    pub(super) fn rest(&mut self) {
        for pin in &mut self.pins {
            pin.set_as_analog();
        }
    }
}
