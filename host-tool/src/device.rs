//! A calibrator as `--device` names it: an address, `emulated` or `emulated-usb`.

use crate::Result;
use crate::emulated::KeptBoard;
use calib_link::{Address, Transport};
use std::fmt;
use std::str::FromStr;

/// A calibrator, there or emulated.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Device {
    /// One at this address.
    At(Address),
    /// The emulated one of this user, over its serial line.
    Emulated,
    /// The emulated one, over its USB port.
    EmulatedUsb,
}

impl Device {
    /// Opens the link.
    ///
    /// # Errors
    /// [`calib_link::LinkError::Open`], or what keeps the emulated board from
    /// starting, with the way out.
    pub fn open(&self) -> Result<Box<dyn Transport>> {
        Ok(match self {
            Self::At(address) => address.open().map_err(calib_link::Error::from)?,
            Self::Emulated => Box::new(KeptBoard::power_on()?),
            Self::EmulatedUsb => Box::new(KeptBoard::power_on_with_usb()?),
        })
    }
}

impl FromStr for Device {
    type Err = std::convert::Infallible;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        Ok(match text {
            "emulated" => Self::Emulated,
            "emulated-usb" => Self::EmulatedUsb,
            _ => Self::At(text.parse()?),
        })
    }
}

impl fmt::Display for Device {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::At(address) => address.fmt(formatter),
            Self::Emulated => formatter.write_str("emulated"),
            Self::EmulatedUsb => formatter.write_str("emulated-usb"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_forms_are_told_apart_and_printed_as_typed() {
        for (text, device) in [
            ("COM3", Device::At(Address::Serial("COM3".into()))),
            ("tcp:h:1", Device::At(Address::Tcp("h:1".into()))),
            ("emulated", Device::Emulated),
            ("emulated-usb", Device::EmulatedUsb),
        ] {
            let parsed: Device = text.parse().expect("infallible");
            assert_eq!(parsed, device);
            assert_eq!(parsed.to_string(), text);
        }
    }
}
