//! The one table of what is known, or assumed, of the part's converters.

/// Basis of a value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Basis {
    /// The part's data sheet, in the public copy docs/errata.md names.
    Sheet(&'static str),
    /// Nobody's: chosen so that it does not flatter.
    Assumed(&'static str),
}

/// A quantity of a converter.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Quantity {
    InputNoise,
    InputBow,
    InputCarry,
    InputOffset,
    InputGain,
    InputRipple,
    InputCrosstalk,
    InputSettling,
    DriveBow,
    DriveCarry,
    DriveOffset,
    DriveGain,
    DriveGlitch,
    DriveSource,
}

/// A line of the table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Entry {
    pub(crate) quantity: Quantity,
    /// The error in words.
    pub what: &'static str,
    /// Its value.
    pub value: f64,
    /// Unit of the value.
    pub unit: &'static str,
    /// Basis of the value.
    pub basis: Basis,
}

const fn line(
    quantity: Quantity,
    what: &'static str,
    value: f64,
    unit: &'static str,
    basis: Basis,
) -> Entry {
    Entry {
        quantity,
        what,
        value,
        unit,
        basis,
    }
}

use Basis::{Assumed, Sheet as OfSheet};

/// Where the sheet has its typical values of a slow channel, single ended, for UFBGA; it says that LQFP
/// may differ, and nobody's account of that package was found.
const TABLE_186: Basis = OfSheet("DS12110 Rev 10, table 186, typical, UFBGA");
const TABLE_188: Basis = OfSheet("DS12110 Rev 10, tables 187 and 188, without buffer");

/// The converters of an STM32H743 at 3.3 V. A code of an input is 1/65 536 of its range, one of the
/// drive 1/4096.
pub const SHEET: [Entry; 14] = [
    line(
        Quantity::InputNoise,
        "input: noise of a conversion, r.m.s.",
        // 65 536 / (sqrt(12) 2^11.5).
        6.53,
        "codes",
        Assumed("11.5 effective bits: the sheet has 12.2 for UFBGA with one converter at work"),
    ),
    line(
        Quantity::InputBow,
        "input: nonlinearity of low order, peak",
        // Of 4 codes either harmonic of a full-scale sine is 1.3 codes or less: -86 dB in all.
        4.0,
        "codes",
        OfSheet("DS12110 Rev 10, table 186: THD 87 dB, UFBGA"),
    ),
    line(
        Quantity::InputCarry,
        "input: step beside the line at mid-scale; smaller ones where smaller bits turn",
        3.0,
        "codes",
        OfSheet("DS12110 Rev 10, table 186: differential +3/-1, integral 10, UFBGA"),
    ),
    line(
        Quantity::InputOffset,
        "input: offset after calibration, at most",
        10.0,
        "codes",
        TABLE_186,
    ),
    line(
        Quantity::InputGain,
        "input: gain error, at most",
        // 15 codes.
        2.3e-4,
        "1",
        TABLE_186,
    ),
    line(
        Quantity::InputRipple,
        "input: ripple of the reference that both see, peak",
        0.5,
        "codes",
        Assumed("25 uV at 1 kHz, the frames of USB, whose clock is the host's"),
    ),
    line(
        Quantity::InputCrosstalk,
        "input: of the other channel's signal",
        1.0e-4,
        "1",
        Assumed("-80 dB while both convert"),
    ),
    line(
        Quantity::InputSettling,
        "input: time constant of the sampling capacitor",
        // To half a code of 16 bits in 172 ns are 11.8 time constants.
        14.6,
        "ns",
        OfSheet("DS12110 Rev 10, table 185: 172 ns at 16 bits, slow channel, 47 ohm"),
    ),
    line(
        Quantity::DriveBow,
        "drive: nonlinearity of low order, peak",
        3.0,
        "codes",
        TABLE_188,
    ),
    line(
        Quantity::DriveCarry,
        "drive: step beside the line at mid-scale",
        2.0,
        "codes",
        TABLE_188,
    ),
    line(
        Quantity::DriveOffset,
        "drive: offset at mid-scale, at most",
        8.0,
        "codes",
        TABLE_188,
    ),
    line(
        Quantity::DriveGain,
        "drive: gain error, at most",
        0.01,
        "1",
        TABLE_188,
    ),
    line(
        Quantity::DriveGlitch,
        "drive: glitch where the largest bit turns, over a sample period",
        0.1,
        "codes",
        Assumed("1 V for 1.6 ns"),
    ),
    line(
        Quantity::DriveSource,
        "drive: output resistance without buffer",
        13_000.0,
        "ohm",
        OfSheet("DS12110 Rev 10, table 187: 10.3 to 16 kOhm"),
    ),
];

/// The table with a factor on what is assumed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Sheet {
    factor: f64,
}

impl Sheet {
    /// `factor` is on what is assumed; 0 leaves nothing, not even of what is known: ideal converters.
    pub(crate) fn new(factor: f64) -> Self {
        Self { factor }
    }

    /// Whether the converters are ideal.
    pub(crate) fn is_ideal(self) -> bool {
        self.factor == 0.0
    }

    /// Value of a quantity.
    pub(crate) fn value(self, quantity: Quantity) -> f64 {
        let entry = SHEET.iter().find(|entry| entry.quantity == quantity);
        entry.map_or(0.0, |entry| match entry.basis {
            _ if self.is_ideal() => 0.0,
            Basis::Assumed(_) => self.factor * entry.value,
            Basis::Sheet(_) => entry.value,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_factor_is_on_what_is_assumed_and_zero_leaves_nothing() {
        let values = |factor| {
            let sheet = Sheet::new(factor);
            [Quantity::InputNoise, Quantity::DriveGain].map(|quantity| sheet.value(quantity))
        };
        assert_eq!(values(1.0), [6.53, 0.01]);
        assert_eq!(values(2.0), [13.06, 0.01]);
        assert_eq!(values(0.0), [0.0, 0.0]);
    }

    #[test]
    fn every_quantity_has_one_line() {
        for (place, entry) in SHEET.iter().enumerate() {
            let first = SHEET
                .iter()
                .position(|other| other.quantity == entry.quantity);
            assert_eq!(first, Some(place), "{}", entry.what);
        }
    }
}
