//! Traffic of the bus as a capture file: pcap with Linux usbmon packets, which Wireshark decodes.
//!
//! Each transfer becomes a submission and a completion with the 64-byte header of
//! `LINKTYPE_USB_LINUX_MMAPPED` (220). Source: tcpdump.org, link-layer header types, and the kernel's
//! `Documentation/usb/usbmon.rst`.

use std::io::{self, Write};

use crate::board::usb::{Transferred, UsbError};

const LINK_TYPE: u32 = 220;
const HEADER_BYTES: usize = 64;
/// Largest packet recorded whole.
const SNAPSHOT_BYTES: u32 = 1 << 18;

/// Transfer types of usbmon.
const CONTROL: u8 = 2;
const BULK: u8 = 3;
/// Status of a transfer as the kernel gives it: success, and the errors as negative numbers.
const IN_PROGRESS: i32 = -115;
const BROKEN_PIPE: i32 = -32;
const PROTOCOL: i32 = -71;
const TIMED_OUT: i32 = -110;
const SHUT_DOWN: i32 = -108;

/// Writes `transfers` as a capture file.
///
/// # Errors
///
/// Error of `to`.
pub fn write(transfers: &[Transferred], to: &mut impl Write) -> io::Result<()> {
    to.write_all(&0xA1B2_C3D4_u32.to_le_bytes())?;
    for half in [2_u16, 4] {
        to.write_all(&half.to_le_bytes())?;
    }
    for word in [0, 0, SNAPSHOT_BYTES, LINK_TYPE] {
        to.write_all(&word.to_le_bytes())?;
    }
    for (id, transfer) in (1..).zip(transfers) {
        packet(to, id, transfer, b'S')?;
        packet(to, id, transfer, b'C')?;
    }
    Ok(())
}

/// One packet: the submission (`S`) or the completion (`C`) of a transfer.
fn packet(to: &mut impl Write, id: u64, transfer: &Transferred, kind: u8) -> io::Result<()> {
    let inward = transfer.endpoint & 0x80 != 0;
    let submission = kind == b'S';
    // Data travel with the submission to the device, with the completion from it.
    let data: &[u8] = if submission == inward {
        &[]
    } else {
        &transfer.data
    };
    let seconds = (transfer.at_ns / 1_000_000_000) as u32;
    let microseconds = (transfer.at_ns % 1_000_000_000 / 1000) as u32;
    let bytes = (HEADER_BYTES + data.len()) as u32;
    for word in [seconds, microseconds, bytes, bytes] {
        to.write_all(&word.to_le_bytes())?;
    }
    to.write_all(&header(id, transfer, kind, data.len()))?;
    to.write_all(data)
}

fn header(id: u64, transfer: &Transferred, kind: u8, captured: usize) -> [u8; HEADER_BYTES] {
    let submission = kind == b'S';
    let setup = transfer.setup.filter(|_| submission);
    let requested = match transfer.setup {
        Some(setup) => u32::from(setup.length),
        None => transfer.data.len() as u32,
    };
    let length = if submission {
        requested
    } else {
        transfer.data.len() as u32
    };
    let status = if submission {
        IN_PROGRESS
    } else {
        status(transfer.outcome)
    };
    let mut header = [0; HEADER_BYTES];
    let mut put = |at: usize, bytes: &[u8]| header[at..at + bytes.len()].copy_from_slice(bytes);
    put(0, &id.to_le_bytes());
    put(8, &[kind]);
    put(
        9,
        &[if transfer.setup.is_some() {
            CONTROL
        } else {
            BULK
        }],
    );
    put(10, &[transfer.endpoint, transfer.address]);
    put(12, &1_u16.to_le_bytes());
    put(14, &[if setup.is_some() { 0 } else { b'-' }]);
    put(15, &[if captured > 0 { 0 } else { b'=' }]);
    put(16, &(transfer.at_ns / 1_000_000_000).to_le_bytes());
    let microseconds = (transfer.at_ns % 1_000_000_000 / 1000) as u32;
    put(24, &microseconds.to_le_bytes());
    put(28, &status.to_le_bytes());
    put(32, &length.to_le_bytes());
    put(36, &(captured as u32).to_le_bytes());
    if let Some(setup) = setup {
        put(40, &setup.bytes());
    }
    header
}

fn status(outcome: Result<(), UsbError>) -> i32 {
    match outcome {
        Ok(()) => 0,
        Err(UsbError::Stall) => BROKEN_PIPE,
        Err(UsbError::NoAnswer | UsbError::Toggle) => PROTOCOL,
        Err(UsbError::Timeout) => TIMED_OUT,
        Err(UsbError::Gone) => SHUT_DOWN,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::board::usb::Setup;

    #[test]
    fn a_control_transfer_is_a_submission_with_its_setup_and_a_completion_with_its_data() {
        let setup = Setup {
            request_type: 0x80,
            request: 6,
            value: 0x0100,
            index: 0,
            length: 18,
        };
        let transfer = Transferred {
            at_ns: 1_500_000_000,
            address: 7,
            endpoint: 0x80,
            setup: Some(setup),
            data: vec![0xAA; 18],
            outcome: Ok(()),
        };
        let mut file = Vec::new();
        write(&[transfer], &mut file).unwrap();
        // File header 24, each packet 16 + 64, the completion's data 18.
        assert_eq!(file.len(), 24 + 2 * (16 + 64) + 18);
        assert_eq!(file[20..24], 220_u32.to_le_bytes());
        let submission = &file[24 + 16..24 + 80];
        assert_eq!(submission[8..12], [b'S', 2, 0x80, 7]);
        assert_eq!(submission[40..48], setup.bytes());
        let completion = &file[24 + 80 + 16..];
        assert_eq!(completion[8], b'C');
        assert_eq!(completion[28..32], [0; 4], "success");
        assert_eq!(completion[64..], [0xAA; 18]);
    }
}
