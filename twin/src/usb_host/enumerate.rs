//! From a plugged cable to a configured device, the way operating systems do it.

use super::descriptor::{self, CdcFunction, DeviceDescriptor};
use super::{HostError, UsbHost, UsbSerial};
use crate::board::usb::{Pipes, Setup};

/// Standard requests (USB 2.0, table 9-4).
const SET_ADDRESS: u8 = 5;
const GET_DESCRIPTOR: u8 = 6;
const SET_CONFIGURATION: u8 = 9;
/// Class requests of a serial port (PSTN 1.2, table 13).
const SET_LINE_CODING: u8 = 0x20;
const SET_CONTROL_LINE_STATE: u8 = 0x22;

const TO_DEVICE: u8 = 0x00;
const FROM_DEVICE: u8 = 0x80;
const CLASS_TO_INTERFACE: u8 = 0x21;
/// English (United States), the language every device has.
const LANGUAGE: u16 = 0x0409;
/// Terminal ready and request to send.
const READY: u16 = 0b11;

/// Address given to the device.
const ADDRESS: u8 = 7;

/// Result of enumeration.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Enumerated {
    /// The device.
    pub device: DeviceDescriptor,
    /// Its serial port.
    pub function: CdcFunction,
    /// Maker, product and serial number, empty where it has none.
    pub names: [String; 3],
}

impl UsbHost {
    /// Resets the bus, asks the device who it is, gives it an address and configures it.
    ///
    /// # Errors
    ///
    /// A transfer fails, or a descriptor is wrong.
    pub fn enumerate(&self) -> Result<Enumerated, HostError> {
        self.reset()?;
        // The first eight bytes tell the packet size of endpoint 0; then the bus is reset again.
        let start = self.descriptor(
            "start of the device descriptor",
            0,
            descriptor::DEVICE,
            0,
            8,
        )?;
        if start.len() != 8 {
            return Err(HostError::Descriptor {
                what: "start of the device descriptor",
                reason: format!("{} bytes instead of 8", start.len()),
            });
        }
        self.reset()?;
        let setup = request(TO_DEVICE, SET_ADDRESS, u16::from(ADDRESS), 0, 0);
        self.control("set address", 0, setup, &[])?;
        let device = self.descriptor("device descriptor", ADDRESS, descriptor::DEVICE, 0, 18)?;
        let device = DeviceDescriptor::parse(&device)?;
        let function = self.configuration()?;
        let mut names = [String::new(), String::new(), String::new()];
        for (name, index) in names.iter_mut().zip(device.strings) {
            if index != 0 {
                *name = self.string(index)?;
            }
        }
        let configuration = u16::from(function.configuration);
        let setup = request(TO_DEVICE, SET_CONFIGURATION, configuration, 0, 0);
        self.control("set configuration", ADDRESS, setup, &[])?;
        Ok(Enumerated {
            device,
            function,
            names,
        })
    }

    /// Opens the serial port of an enumerated device at `baud`, which a device over USB ignores.
    ///
    /// # Errors
    ///
    /// A transfer fails.
    pub fn open_serial(&self, enumerated: &Enumerated, baud: u32) -> Result<UsbSerial, HostError> {
        let function = &enumerated.function;
        let interface = u16::from(function.control_interface);
        // Rate, one stop bit, no parity, eight bits (PSTN 1.2, table 17).
        let mut coding = baud.to_le_bytes().to_vec();
        coding.extend([0, 0, 8]);
        let setup = request(CLASS_TO_INTERFACE, SET_LINE_CODING, 0, interface, 7);
        self.control("set line coding", ADDRESS, setup, &coding)?;
        self.port.open_pipes(Pipes {
            address: ADDRESS,
            out_endpoint: function.out_endpoint,
            in_endpoint: function.in_endpoint,
            packet_bytes: function.packet_bytes,
        });
        self.set_ready(enumerated, true)?;
        Ok(UsbSerial::new(self.emulator.clone(), self.port.clone()))
    }

    /// Raises or drops terminal ready and request to send.
    ///
    /// # Errors
    ///
    /// The transfer fails.
    pub fn set_ready(&self, enumerated: &Enumerated, ready: bool) -> Result<(), HostError> {
        let interface = u16::from(enumerated.function.control_interface);
        let state = if ready { READY } else { 0 };
        let setup = request(
            CLASS_TO_INTERFACE,
            SET_CONTROL_LINE_STATE,
            state,
            interface,
            0,
        );
        self.control("set control line state", ADDRESS, setup, &[])?;
        Ok(())
    }

    /// Asks a device for a descriptor.
    ///
    /// # Errors
    ///
    /// [`HostError::Transfer`] with `what`: an unknown descriptor is a stall.
    pub fn descriptor(
        &self,
        what: &'static str,
        address: u8,
        kind: u8,
        index: u8,
        length: u16,
    ) -> Result<Vec<u8>, HostError> {
        let value = u16::from(kind) << 8 | u16::from(index);
        let language = if kind == descriptor::STRING && index != 0 {
            LANGUAGE
        } else {
            0
        };
        let setup = request(FROM_DEVICE, GET_DESCRIPTOR, value, language, length);
        self.control(what, address, setup, &[])
    }

    fn configuration(&self) -> Result<CdcFunction, HostError> {
        let what = "configuration descriptor";
        let start = self.descriptor(what, ADDRESS, descriptor::CONFIGURATION, 0, 9)?;
        let [_, _, low, high, ..] = *start else {
            return Err(HostError::Descriptor {
                what,
                reason: format!("{} bytes instead of 9", start.len()),
            });
        };
        let length = u16::from_le_bytes([low, high]);
        let whole = self.descriptor(what, ADDRESS, descriptor::CONFIGURATION, 0, length)?;
        CdcFunction::parse(&whole)
    }

    fn string(&self, index: u8) -> Result<String, HostError> {
        let what = "string descriptor";
        let bytes = self.descriptor(what, ADDRESS, descriptor::STRING, index, 255)?;
        descriptor::string(&bytes)
    }
}

/// A setup packet.
fn request(request_type: u8, request: u8, value: u16, index: u16, length: u16) -> Setup {
    Setup {
        request_type,
        request,
        value,
        index,
        length,
    }
}
