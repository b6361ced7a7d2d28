//! Where a calibrator is, as typed: a serial port or `tcp:HOST:PORT`.

use crate::{LinkError, SerialTransport, TcpTransport, Transport};
use std::fmt;
use std::str::FromStr;

/// Where a calibrator is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Address {
    /// Name of a serial port, such as `/dev/ttyACM0` or `COM3`.
    Serial(String),
    /// Host and port, `HOST:PORT`.
    Tcp(String),
}

impl Address {
    /// Opens the link.
    ///
    /// # Errors
    /// [`LinkError::Open`] with the way out.
    pub fn open(&self) -> Result<Box<dyn Transport>, LinkError> {
        Ok(match self {
            Self::Serial(port) => Box::new(SerialTransport::open(port)?),
            Self::Tcp(peer) => Box::new(TcpTransport::connect(peer)?),
        })
    }
}

impl FromStr for Address {
    type Err = std::convert::Infallible;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        Ok(match text.strip_prefix("tcp:") {
            Some(peer) => Self::Tcp(peer.to_owned()),
            None => Self::Serial(text.to_owned()),
        })
    }
}

impl fmt::Display for Address {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Serial(port) => formatter.write_str(port),
            Self::Tcp(peer) => write!(formatter, "tcp:{peer}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_forms_are_told_apart_and_printed_as_typed() {
        for (text, address) in [
            ("/dev/ttyACM0", Address::Serial("/dev/ttyACM0".into())),
            ("COM3", Address::Serial("COM3".into())),
            ("tcp:localhost:4000", Address::Tcp("localhost:4000".into())),
            ("tcp:[::1]:4000", Address::Tcp("[::1]:4000".into())),
        ] {
            let parsed: Address = text.parse().expect("infallible");
            assert_eq!(parsed, address);
            assert_eq!(parsed.to_string(), text);
        }
    }
}
