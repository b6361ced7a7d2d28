//! Front panel of the board: three lamps and a button.

use rigless::device::Level;
use rigless::mcu::Mcu;
use rigless::soc::stm32h743::generated::gpioa;
use rigless::soc::stm32h743::peripherals::gpio;
use rigless::time::VirtualNanos;

use super::part::Part;
use super::schematic::Pin;

/// `MODER` of an output (RM0433 Rev 9, section 11.4.1).
const OUTPUT: u64 = 0b01;

/// State of the three lamps.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Leds {
    /// Winks: ready. Lit: PASS.
    pub green: bool,
    /// Lit: measuring. Slow: NOT JUDGEABLE. Takes turns with red: FAIL.
    pub yellow: bool,
    /// Lit: the last run holds a refused point. Blinks, counted: degraded.
    pub red: bool,
}

impl Part {
    /// Which lamps are lit.
    #[must_use]
    pub fn leds(&self) -> Leds {
        let schematic = self.schematic();
        let [green, yellow, red] = schematic
            .lamps
            .map(|pin| self.is_driven(pin, schematic.lit.is_high(true)));
        Leds { green, yellow, red }
    }

    /// Presses or releases the button at `at`.
    pub fn press_button(&mut self, at: VirtualNanos, pressed: bool) {
        let schematic = self.schematic();
        let (button, high) = (schematic.button, schematic.pressed.is_high(pressed));
        let Some(pin) = gpio::Pin::new(button.number) else {
            return;
        };
        self.base
            .drive_port(at, button.port, |port, registers, context| {
                port.drive(pin, Some(Level::from(high)), registers, context);
            });
    }

    /// Whether the part drives `pin` to that level: an input lights no lamp.
    fn is_driven(&self, pin: Pin, high: bool) -> bool {
        let registers = self.bus().registers(&pin.instance());
        let (Some(number), Some(registers)) = (gpio::Pin::new(pin.number), registers) else {
            return false;
        };
        let mode = registers.get(gpioa::Register::Moder) >> (2 * pin.number) & 0b11;
        let level = self.base.gpio[pin.port].level(number, registers);
        mode == OUTPUT && level == Level::from(high)
    }
}
