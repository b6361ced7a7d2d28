//! The two input pins, which the part's own resistors pull, and the dither's pin, which a timer drives.
//!
//! A converter sees its pin whatever the port does with it beside. In input mode the port may connect
//! a resistor to the rail or to ground, which moves the pin against the source in front of it; in
//! analogue mode both resistors are off (RM0433 Rev 9, section 11.3.12).

use rigless::soc::Bus;
use rigless::soc::stm32h743::generated::gpioa;
use serde::{Deserialize, Serialize};

use super::memory_map;
use super::schematic::{Pin, Schematic};

/// Source in front of an input pin, ohm: the series resistor of docs/hardware.md.
const SOURCE_OHM: f64 = 1_000.0;
/// The part's own resistor, ohm. Assumed: the middle of the 30 to 50 kOhm of its family.
const PULL_OHM: f64 = 40_000.0;
/// `MODER` of an input, and `PUPDR` of either resistor (RM0433 Rev 9, sections 11.4.1 and 11.4.4).
const INPUT: u64 = 0b00;
const UP: u64 = 0b01;
const DOWN: u64 = 0b10;
/// `MODER` of an alternate function, and the number of TIM3's (DS12110 Rev 10, tables 10 to 20).
const ALTERNATE: u64 = 0b10;
const TIM3: u64 = 2;

/// Highest code of an input, which the rail has.
const RAIL_CODE: f64 = 65_535.0;

/// Pull of the port on an input pin.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub(super) enum Pull {
    #[default]
    None,
    Up,
    Down,
}

impl Pull {
    /// Code at the pin where the source alone makes `code`.
    pub(super) fn of(self, code: u16) -> u16 {
        let to = match self {
            Self::None => return code,
            Self::Up => RAIL_CODE,
            Self::Down => 0.0,
        };
        let source = f64::from(code);
        (source + (to - source) * SOURCE_OHM / (SOURCE_OHM + PULL_OHM)).round() as u16
    }
}

/// Pulls of the port on the pins of reference and device under test.
pub(super) fn pulls(bus: &Bus, schematic: &Schematic) -> [Pull; 2] {
    schematic.inputs.map(|pin| pull(bus, pin))
}

/// Whether the port connects the dither's pin to TIM3.
pub(super) fn dither_is_connected(bus: &Bus, schematic: &Schematic) -> bool {
    let Some(pin) = schematic.dither else {
        return false;
    };
    let functions = match pin.number {
        0..8 => gpioa::Register::Afrl,
        _ => gpioa::Register::Afrh,
    };
    let function = port(bus, pin, functions) >> (4 * (pin.number % 8)) & 0xF;
    mode(bus, pin) == ALTERNATE && function == TIM3
}

fn pull(bus: &Bus, pin: Pin) -> Pull {
    if mode(bus, pin) != INPUT {
        return Pull::None;
    }
    match port(bus, pin, gpioa::Register::Pupdr) >> (2 * pin.number) & 0b11 {
        UP => Pull::Up,
        DOWN => Pull::Down,
        _ => Pull::None,
    }
}

fn mode(bus: &Bus, pin: Pin) -> u64 {
    port(bus, pin, gpioa::Register::Moder) >> (2 * pin.number) & 0b11
}

fn port(bus: &Bus, pin: Pin, register: gpioa::Register) -> u64 {
    memory_map::value(bus, register, &pin.instance())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 1.65 V behind 1 kOhm, 40 kOhm to either rail of 3.3 V: 40 mV, 799 codes of 50.4 uV.
    #[test]
    fn a_resistor_moves_mid_scale_by_forty_millivolts() {
        assert_eq!(Pull::None.of(32_768), 32_768);
        assert_eq!(Pull::Up.of(32_768), 32_768 + 799);
        assert_eq!(Pull::Down.of(32_768), 32_768 - 799);
        assert_eq!((Pull::Up.of(65_535), Pull::Down.of(0)), (65_535, 0));
    }
}
