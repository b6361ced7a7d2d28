//! What a person sees and touches on the board: three LEDs and the blue button.

use rigless::device::Level;
use rigless::mcu::Mcu;
use rigless::soc::stm32h743::peripherals::gpio::Pin;
use rigless::time::VirtualNanos;

use super::part::Part;

/// Places of the ports in the part's list.
const GPIOB: usize = 1;
const GPIOC: usize = 2;
const GPIOE: usize = 4;

/// Pins of the LEDs, lit by a high level (UM2407, section 6.5): LD1, LD2 and LD3.
const GREEN: (usize, &str, u8) = (GPIOB, "GPIOB", 0);
const YELLOW: (usize, &str, u8) = (GPIOE, "GPIOE", 1);
const RED: (usize, &str, u8) = (GPIOB, "GPIOB", 14);

/// Pin of the button B1, high while pressed.
const BUTTON: u8 = 13;

/// State of the three LEDs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Leds {
    /// LD1 on PB0.
    pub green: bool,
    /// LD2 on PE1.
    pub yellow: bool,
    /// LD3 on PB14.
    pub red: bool,
}

impl Part {
    /// Which LEDs are lit.
    #[must_use]
    pub fn leds(&self) -> Leds {
        Leds {
            green: self.pin_is_high(GREEN),
            yellow: self.pin_is_high(YELLOW),
            red: self.pin_is_high(RED),
        }
    }

    /// Presses or releases the button at `at`.
    pub fn press_button(&mut self, at: VirtualNanos, pressed: bool) {
        let Some(pin) = Pin::new(BUTTON) else { return };
        self.base.drive_port(at, GPIOC, |port, registers, context| {
            port.drive(pin, Some(Level::from(pressed)), registers, context);
        });
    }

    fn pin_is_high(&self, (port, name, number): (usize, &str, u8)) -> bool {
        let (Some(pin), Some(registers)) = (Pin::new(number), self.bus().registers(name)) else {
            return false;
        };
        self.base.gpio[port].level(pin, registers) == Level::High
    }
}
