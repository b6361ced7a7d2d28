//! Whether a record comes from an emulated instrument.
//!
//! An instrument's serial number is the unique id of its processor: three words of wafer
//! position, wafer and lot (RM0433 Rev 9, 61.1), in hexadecimal digits. The emulated part has
//! a lot that no real one has. The firmware knows nothing of it: it reads its id and reports it.

/// `TWIN`, the first four letters of the emulated part's lot, as hexadecimal digits.
const LOT: &str = "5457494E";
/// Where the lot begins among the digits: behind four bytes of position and one of the wafer.
const LOT_AT: usize = 10;
/// Digits of a unique id.
const DIGITS: usize = 24;

/// True for the serial number of an emulated instrument.
pub fn is_emulated(instrument_serial: &str) -> bool {
    let lot = instrument_serial.get(LOT_AT..LOT_AT + LOT.len());
    instrument_serial.len() == DIGITS && lot.is_some_and(|lot| lot.eq_ignore_ascii_case(LOT))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_emulated_lot_is_recognised_and_no_other() {
        assert!(is_emulated("23004100075457494E303120"));
        // A lot of ST begins elsewhere in the alphabet, and the letters elsewhere are not the lot.
        for real in [
            "2300410007513036373833",
            "5457494E0000510E33363437",
            "CAL-0042",
            "",
        ] {
            assert!(!is_emulated(real), "{real}");
        }
    }
}
