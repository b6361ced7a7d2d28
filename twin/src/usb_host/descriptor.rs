//! Descriptors, read with suspicion: every length and every type is checked.

use super::HostError;

/// Descriptor types (USB 2.0, table 9-5).
pub(super) const DEVICE: u8 = 1;
pub(super) const CONFIGURATION: u8 = 2;
pub(super) const STRING: u8 = 3;
const INTERFACE: u8 = 4;
const ENDPOINT: u8 = 5;

/// Interface classes (CDC 1.2, tables 14 and 18).
const COMMUNICATIONS: u8 = 0x02;
const ABSTRACT_CONTROL: u8 = 0x02;
const CDC_DATA: u8 = 0x0A;
const BULK: u8 = 0x02;

/// Who the device says it is (USB 2.0, table 9-8).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct DeviceDescriptor {
    /// Maker's number.
    pub vendor: u16,
    /// Product's number.
    pub product: u16,
    /// Release of the product, binary coded decimal.
    pub release: u16,
    /// Bytes of a packet of endpoint 0.
    pub control_packet_bytes: u8,
    /// Indices of the strings: maker, product, serial number; 0 for none.
    pub strings: [u8; 3],
}

impl DeviceDescriptor {
    /// Reads the 18 bytes of a device descriptor.
    ///
    /// # Errors
    ///
    /// [`HostError::Descriptor`] with what is wrong.
    pub fn parse(bytes: &[u8]) -> Result<Self, HostError> {
        let wrong = |reason: &str| HostError::Descriptor {
            what: "device descriptor",
            reason: reason.to_owned(),
        };
        let bytes: &[u8; 18] = bytes.try_into().map_err(|_| wrong("not 18 bytes"))?;
        if bytes[..2] != [18, DEVICE] {
            return Err(wrong("wrong length or type"));
        }
        if !matches!(bytes[7], 8 | 16 | 32 | 64) {
            return Err(wrong("endpoint 0 has no legal packet size"));
        }
        let word = |at: usize| u16::from_le_bytes([bytes[at], bytes[at + 1]]);
        Ok(Self {
            vendor: word(8),
            product: word(10),
            release: word(12),
            control_packet_bytes: bytes[7],
            strings: [bytes[14], bytes[15], bytes[16]],
        })
    }
}

/// The serial port of a configuration: a CDC-ACM function.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CdcFunction {
    /// Value that selects the configuration.
    pub configuration: u8,
    /// Number of the interface that takes line coding and control line state.
    pub control_interface: u8,
    /// Number of the bulk endpoint to the device.
    pub out_endpoint: u8,
    /// Number of the bulk endpoint from the device.
    pub in_endpoint: u8,
    /// Bytes of a bulk packet.
    pub packet_bytes: u16,
}

impl CdcFunction {
    /// Finds the first serial port in a whole configuration descriptor.
    ///
    /// # Errors
    ///
    /// [`HostError::Descriptor`] when it is damaged or has none.
    pub fn parse(bytes: &[u8]) -> Result<Self, HostError> {
        let wrong = |reason: String| HostError::Descriptor {
            what: "configuration descriptor",
            reason,
        };
        if bytes.len() < 9 || bytes[..2] != [9, CONFIGURATION] {
            return Err(wrong("wrong length or type".into()));
        }
        if usize::from(u16::from_le_bytes([bytes[2], bytes[3]])) != bytes.len() {
            return Err(wrong("its total length is not its length".into()));
        }
        let mut found = Search::default();
        let mut rest = bytes;
        while let Some(&length) = rest.first() {
            let length = usize::from(length);
            if length < 2 || length > rest.len() {
                let at = bytes.len() - rest.len();
                return Err(wrong(format!(
                    "a descriptor of length {length} at byte {at}"
                )));
            }
            let (descriptor, after) = rest.split_at(length);
            found.look_at(descriptor);
            rest = after;
        }
        found
            .function(bytes[5])
            .ok_or_else(|| wrong("no serial port in it".into()))
    }
}

/// Result of a walk along a configuration.
#[derive(Debug, Default)]
struct Search {
    control_interface: Option<u8>,
    in_data: bool,
    endpoint_out: Option<(u8, u16)>,
    endpoint_in: Option<(u8, u16)>,
}

impl Search {
    fn look_at(&mut self, descriptor: &[u8]) {
        match *descriptor {
            [9, INTERFACE, number, _, _, class, subclass, ..] => {
                self.in_data = class == CDC_DATA;
                if class == COMMUNICATIONS && subclass == ABSTRACT_CONTROL {
                    self.control_interface.get_or_insert(number);
                }
            }
            [7, ENDPOINT, address, BULK, low, high, _] if self.in_data => {
                let pipe = (address & 0xF, u16::from_le_bytes([low, high]) & 0x7FF);
                let place = match address & 0x80 {
                    0 => &mut self.endpoint_out,
                    _ => &mut self.endpoint_in,
                };
                place.get_or_insert(pipe);
            }
            _ => {}
        }
    }

    fn function(&self, configuration: u8) -> Option<CdcFunction> {
        let (out_endpoint, packet_bytes) = self.endpoint_out?;
        let (in_endpoint, in_bytes) = self.endpoint_in?;
        (packet_bytes == in_bytes && packet_bytes > 0).then_some(CdcFunction {
            configuration,
            control_interface: self.control_interface?,
            out_endpoint,
            in_endpoint,
            packet_bytes,
        })
    }
}

/// The text of a string descriptor (USB 2.0, section 9.6.7).
pub(super) fn string(bytes: &[u8]) -> Result<String, HostError> {
    let wrong = |reason: &str| HostError::Descriptor {
        what: "string descriptor",
        reason: reason.to_owned(),
    };
    if bytes.len() < 2 || usize::from(bytes[0]) != bytes.len() || bytes[1] != STRING {
        return Err(wrong("wrong length or type"));
    }
    let (units, rest) = bytes[2..].as_chunks();
    if !rest.is_empty() {
        return Err(wrong("half a character"));
    }
    let units: Vec<u16> = units.iter().map(|unit| u16::from_le_bytes(*unit)).collect();
    String::from_utf16(&units).map_err(|_| wrong("no UTF-16"))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A CDC-ACM configuration as CDC 1.2 lays it out: two interfaces, three endpoints.
    const SERIAL_PORT: [u8; 67] = [
        9, 2, 67, 0, 2, 1, 0, 0x80, 50, // configuration 1, two interfaces
        9, 4, 0, 0, 1, 2, 2, 0, 0, // interface 0: communications, abstract control
        5, 0x24, 0, 0x10, 1, 4, 0x24, 2, 2, 5, 0x24, 6, 0, 1, 5, 0x24, 1, 0, 1, // functional
        7, 5, 0x81, 3, 8, 0, 255, // interrupt endpoint
        9, 4, 1, 0, 2, 10, 0, 0, 0, // interface 1: data
        7, 5, 0x02, 2, 64, 0, 0, // bulk to the device
        7, 5, 0x83, 2, 64, 0, 0, // bulk from the device
    ];

    #[test]
    fn the_serial_port_is_found_in_its_configuration() {
        let function = CdcFunction::parse(&SERIAL_PORT).unwrap();
        let expected = CdcFunction {
            configuration: 1,
            control_interface: 0,
            out_endpoint: 2,
            in_endpoint: 3,
            packet_bytes: 64,
        };
        assert_eq!(function, expected);
    }

    #[test]
    fn a_configuration_cut_anywhere_or_with_any_zero_length_is_refused() {
        for length in 0..SERIAL_PORT.len() {
            assert!(
                CdcFunction::parse(&SERIAL_PORT[..length]).is_err(),
                "{length}"
            );
        }
        let starts = [9, 18, 23, 27, 32, 37, 44, 53, 60];
        for start in starts {
            let mut broken = SERIAL_PORT;
            broken[start] = 0;
            assert!(CdcFunction::parse(&broken).is_err(), "zero at {start}");
        }
    }

    #[test]
    fn a_string_is_utf16_of_the_length_it_says() {
        assert_eq!(string(&[6, 3, b'C', 0, 0xB5, 0]).unwrap(), "C\u{b5}");
        for wrong in [&[][..], &[4, 3, b'C'], &[3, 3, b'C'], &[4, 3, 0x00, 0xD8]] {
            assert!(string(wrong).is_err(), "{wrong:?}");
        }
    }
}
