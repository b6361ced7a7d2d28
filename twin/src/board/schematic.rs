//! The schematic of a board: what is soldered to the part's pins, as the emulator needs it.
//!
//! Data, one file for each board (`firmware/boards/*/schematic.toml`). The firmware never sees it: what
//! the firmware believes of the same board is another file, and one that is wrong shows.

use std::path::{Path, PathBuf};

use rigless::soc::stm32h743::peripherals::usart;
use serde::Deserialize;

use crate::rig::Rig;

/// The board the instrument is made for.
const NUCLEO_H743ZI2: &str = include_str!("../../../firmware/boards/nucleo-h743zi2/schematic.toml");

/// Pins of ADC1 and ADC2 by the channel they lead to (DS12110 Rev 10, table 9): those of both, and
/// those of one.
const BOTH_CONVERTERS: [(&str, u64); 14] = [
    ("PA6", 3),
    ("PC4", 4),
    ("PB1", 5),
    ("PA7", 7),
    ("PC5", 8),
    ("PB0", 9),
    ("PC0", 10),
    ("PC1", 11),
    ("PC2", 12),
    ("PC3", 13),
    ("PA2", 14),
    ("PA3", 15),
    ("PA4", 18),
    ("PA5", 19),
];
const ONE_CONVERTER: [&[(&str, u64)]; 2] = [
    &[("PF11", 2), ("PF12", 6), ("PA0", 16), ("PA1", 17)],
    &[("PF13", 2), ("PF14", 6)],
];

/// Pins of TIM3's first channel (DS12110 Rev 10, tables 10 to 20).
const TIM3_PINS: [&str; 3] = ["PA6", "PB4", "PC6"];

/// Pins of DAC1's channels.
const DAC_PINS: [&str; 2] = ["PA4", "PA5"];

/// Serial ports whose DMA requests are modelled: the first of the part.
const SERIAL_PORTS: usize = 3;

/// A board that is no board.
#[derive(Debug, thiserror::Error)]
pub enum SchematicError {
    /// The file cannot be read.
    #[error("cannot read the schematic {}: {source}", path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
    /// It is no schematic.
    #[error("no schematic: {0}")]
    Malformed(#[from] toml::de::Error),
    /// A pin or port cannot be what it is said to be.
    #[error("`{what}` of the schematic cannot be {pin}")]
    Impossible {
        /// Use of the pin or port.
        what: &'static str,
        /// Its name.
        pin: String,
    },
}

/// A level at a pin.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum Active {
    High,
    Low,
}

/// Revision of the part's silicon.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize)]
pub(super) enum Silicon {
    /// The converters run at the clock they are given (assumed, from DS12110 before revision V).
    Y,
    /// They halve it.
    #[default]
    V,
}

/// A pin of a port.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Pin {
    /// Place of the port in the part's list, A first.
    pub(super) port: usize,
    pub(super) number: u8,
}

/// The schematic of a board, checked.
#[derive(Debug, Clone, PartialEq)]
pub struct Schematic {
    /// Clock at OSC_IN, Hz.
    pub(super) clock_hz: u64,
    /// Green, yellow and red.
    pub(super) lamps: [Pin; 3],
    pub(super) lit: Active,
    pub(super) button: Pin,
    pub(super) pressed: Active,
    /// Reference and device under test.
    pub(super) inputs: [Pin; 2],
    /// Channels of ADC1 and ADC2 that the reference and the device under test lead to.
    pub(super) input_channels: [u64; 2],
    /// Whose square wave the front end adds to both inputs; none where it has no dither.
    pub(super) dither: Option<Pin>,
    pub(super) silicon: Silicon,
    /// Channel of DAC1 that drives the exciter: 0 or 1.
    pub(super) drive_channel: usize,
    /// Place of the serial port in the part's list.
    pub(super) serial: usize,
    pub(super) input_full_scale_peak_v: f64,
    pub(super) drive_full_scale_peak_v: f64,
}

/// The file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    clock_hz: u64,
    green: String,
    yellow: String,
    red: String,
    lit: Active,
    button: String,
    pressed: Active,
    reference: String,
    dut: String,
    dither: Option<String>,
    #[serde(default)]
    silicon: Silicon,
    input_full_scale_peak_v: f64,
    drive: String,
    drive_full_scale_peak_v: f64,
    serial: String,
}

impl Schematic {
    /// The NUCLEO-H743ZI2, for which the shipping image is built.
    #[must_use]
    pub fn nucleo_h743zi2() -> Self {
        match Self::parse(NUCLEO_H743ZI2) {
            Ok(schematic) => schematic,
            Err(error) => unreachable!("a test reads this file: {error}"),
        }
    }

    /// Reads the schematic at `path`.
    ///
    /// # Errors
    ///
    /// [`SchematicError`].
    pub fn read(path: &Path) -> Result<Self, SchematicError> {
        let text = std::fs::read_to_string(path).map_err(|source| SchematicError::Unreadable {
            path: path.to_owned(),
            source,
        })?;
        Self::parse(&text)
    }

    fn parse(text: &str) -> Result<Self, SchematicError> {
        let file: File = toml::from_str(text)?;
        let serial = usart::INSTANCES.iter().take(SERIAL_PORTS);
        let impossible = |what, pin: &str| SchematicError::Impossible {
            what,
            pin: pin.to_owned(),
        };
        let dac_pin = |pin: &str| DAC_PINS.iter().position(|name| *name == pin);
        let input =
            |what, nth, pin: &str| input_channel(nth, pin).ok_or_else(|| impossible(what, pin));
        let gpio = |what, pin: &str| Pin::named(pin).ok_or_else(|| impossible(what, pin));
        Ok(Self {
            clock_hz: file.clock_hz,
            lamps: [
                gpio("green", &file.green)?,
                gpio("yellow", &file.yellow)?,
                gpio("red", &file.red)?,
            ],
            lit: file.lit,
            button: gpio("button", &file.button)?,
            pressed: file.pressed,
            inputs: [gpio("reference", &file.reference)?, gpio("dut", &file.dut)?],
            input_channels: [
                input("reference", 0, &file.reference)?,
                input("dut", 1, &file.dut)?,
            ],
            dither: match &file.dither {
                Some(pin) if TIM3_PINS.contains(&pin.as_str()) => Pin::named(pin),
                Some(pin) => return Err(impossible("dither", pin)),
                None => None,
            },
            silicon: file.silicon,
            drive_channel: dac_pin(&file.drive).ok_or_else(|| impossible("drive", &file.drive))?,
            serial: serial
                .into_iter()
                .position(|name| *name == file.serial)
                .ok_or_else(|| impossible("serial", &file.serial))?,
            input_full_scale_peak_v: file.input_full_scale_peak_v,
            drive_full_scale_peak_v: file.drive_full_scale_peak_v,
        })
    }

    /// Gives `rig` the board's front end: the scales of its inputs and of its drive output.
    pub fn fit(&self, rig: &mut Rig) {
        rig.converter.input_full_scale_peak_v = self.input_full_scale_peak_v;
        rig.amplifier.full_scale_peak_v = self.drive_full_scale_peak_v;
    }

    /// Pins of both inputs and of the dither, or once more of an input where there is none.
    pub(super) fn sampled_pins(&self) -> [Pin; 3] {
        let [reference, dut] = self.inputs;
        [reference, dut, self.dither.unwrap_or(dut)]
    }

    /// Whether the pair of converters runs at half the clock it is given.
    pub(super) fn converters_halve_their_clock(&self) -> bool {
        self.silicon == Silicon::V
    }

    /// Name of the serial port's instance.
    pub(super) fn serial_name(&self) -> &'static str {
        usart::INSTANCES[self.serial]
    }
}

impl Active {
    /// Whether the pin is high while what it stands for is so.
    pub(super) fn is_high(self, so: bool) -> bool {
        so == (self == Self::High)
    }
}

impl Pin {
    fn named(name: &str) -> Option<Self> {
        let port = name.strip_prefix('P')?;
        let letter = port
            .bytes()
            .next()
            .filter(|letter| (b'A'..=b'K').contains(letter))?;
        let number = port.get(1..)?.parse().ok().filter(|number| *number < 16)?;
        Some(Self {
            port: usize::from(letter - b'A'),
            number,
        })
    }

    /// Name of the port's instance.
    pub(super) fn instance(self) -> String {
        format!("GPIO{}", char::from(b'A' + self.port as u8))
    }
}

fn input_channel(nth: usize, pin: &str) -> Option<u64> {
    let mut all = BOTH_CONVERTERS.iter().chain(ONE_CONVERTER[nth]);
    all.find(|(name, _)| *name == pin)
        .map(|&(_, channel)| channel)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_board_of_the_shipping_image_by_its_manual() {
        // UM2407, 6.5 and 6.6; DS12110, table 9.
        let nucleo = Schematic::parse(NUCLEO_H743ZI2).unwrap();
        let pin = |port, number| Pin { port, number };
        assert_eq!(nucleo.lamps, [pin(1, 0), pin(4, 1), pin(1, 14)]);
        assert_eq!((nucleo.button, nucleo.pressed), (pin(2, 13), Active::High));
        assert_eq!(nucleo.input_channels, [15, 10]);
        assert_eq!(nucleo.dither, Some(pin(2, 6)));
        assert_eq!((nucleo.drive_channel, nucleo.serial_name()), (0, "USART3"));
        assert_eq!(nucleo.lamps[1].instance(), "GPIOE");
    }

    #[test]
    fn what_the_part_cannot_do_is_refused_by_name() {
        for (line, other) in [
            ("green = \"PB0\"", "green = \"PL0\""),
            ("red = \"PB14\"", "red = \"PB16\""),
            ("button = \"PC13\"", "button = \"C13\""),
            // A pin without a converter, and one of ADC1 alone.
            ("reference = \"PA3\"", "reference = \"PD8\""),
            ("dut = \"PC0\"", "dut = \"PA0\""),
            ("drive = \"PA4\"", "drive = \"PA3\""),
            ("dither = \"PC6\"", "dither = \"PC7\""),
            ("serial = \"USART3\"", "serial = \"UART5\""),
        ] {
            assert!(NUCLEO_H743ZI2.contains(line), "{line}");
            let error = Schematic::parse(&NUCLEO_H743ZI2.replace(line, other));
            let (what, _) = line.split_once(' ').unwrap();
            let named = format!("`{what}` of the schematic");
            assert!(
                error.unwrap_err().to_string().starts_with(&named),
                "{other}"
            );
        }
        assert!(Schematic::parse("lamps = 3").is_err());
        assert!(Schematic::read(Path::new("/no/such/schematic")).is_err());
    }
}
