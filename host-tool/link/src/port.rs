//! Serial ports of this computer, and which of them may be a calibrator.

use schemars::JsonSchema;
use serde::Serialize;
use serialport::SerialPortType;

/// USB vendor of ST Microelectronics: the ST-LINK of the board.
const VENDOR_ST: u16 = 0x0483;

/// A serial port.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Port {
    /// Name to give to `--device`.
    pub name: String,
    /// Maker and product, if it is a USB device.
    pub description: String,
    /// Serial number of the USB device.
    pub usb_serial: Option<String>,
    /// True when it looks like the board.
    pub likely: bool,
}

/// All serial ports, the likely ones first.
pub fn list() -> Vec<Port> {
    // No port list on a computer without serial ports is an empty one.
    let found = serialport::available_ports().unwrap_or_default();
    let mut ports: Vec<Port> = found
        .into_iter()
        .map(|port| describe(port.port_name, port.port_type))
        .collect();
    ports.sort_by(|a, b| b.likely.cmp(&a.likely).then_with(|| a.name.cmp(&b.name)));
    ports
}

fn describe(name: String, kind: SerialPortType) -> Port {
    let (description, usb_serial, likely) = match kind {
        SerialPortType::UsbPort(usb) => {
            let product = usb.product.unwrap_or_default();
            let likely = usb.vid == VENDOR_ST || product.to_lowercase().contains("calib");
            let maker = usb.manufacturer.unwrap_or_default();
            let text = format!("{maker} {product} [{:04x}:{:04x}]", usb.vid, usb.pid);
            (text.trim().to_owned(), usb.serial_number, likely)
        }
        SerialPortType::BluetoothPort => ("Bluetooth".to_owned(), None, false),
        SerialPortType::PciPort => ("built in".to_owned(), None, false),
        SerialPortType::Unknown => (String::new(), None, false),
    };
    Port {
        name,
        description,
        usb_serial,
        likely,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serialport::UsbPortInfo;

    fn usb(vid: u16, product: &str) -> SerialPortType {
        SerialPortType::UsbPort(UsbPortInfo {
            vid,
            pid: 0x374b,
            serial_number: Some("066F".into()),
            manufacturer: Some("STMicroelectronics".into()),
            product: Some(product.into()),
        })
    }

    #[test]
    fn the_debugger_of_the_board_is_likely_and_a_modem_is_not() {
        assert!(describe("p".into(), usb(VENDOR_ST, "STM32 STLink")).likely);
        assert!(describe("p".into(), usb(0x1209, "Field Calibrator")).likely);
        assert!(!describe("p".into(), usb(0x067b, "USB-Serial Controller")).likely);
        assert!(!describe("p".into(), SerialPortType::PciPort).likely);
    }
}
