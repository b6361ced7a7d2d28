//! A control transfer, transaction by transaction (USB 2.0, section 8.5.3).

use super::controller::{Answer, Controller, Handshake};

/// Times a transaction without an answer is repeated (USB 2.0, section 10.2.6).
const ATTEMPTS: u32 = 3;
/// Longest a device may keep a control transfer waiting (USB 2.0, section 9.2.6.1).
const PATIENCE_NS: u64 = 5_000_000_000;

/// Why a transfer failed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum UsbError {
    /// The device refuses the request.
    #[error("the device stalled the endpoint")]
    Stall,
    /// The device does not answer at all.
    #[error("the device does not answer")]
    NoAnswer,
    /// The device asks to wait, for too long.
    #[error("the device kept the host waiting for five seconds")]
    Timeout,
    /// The device has gone.
    #[error("the device has gone from the bus")]
    Gone,
    /// The device repeats a packet or skips one.
    #[error("the device lost the data toggle")]
    Toggle,
}

/// The eight bytes that start a control transfer (USB 2.0, table 9-2).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Setup {
    /// Direction, type and recipient.
    pub request_type: u8,
    /// The request.
    pub request: u8,
    /// Its value.
    pub value: u16,
    /// Its index: an interface, an endpoint or a language.
    pub index: u16,
    /// Bytes of the data stage.
    pub length: u16,
}

impl Setup {
    /// The packet on the wire.
    #[must_use]
    pub fn bytes(&self) -> [u8; 8] {
        let [value, index, length] = [self.value, self.index, self.length].map(u16::to_le_bytes);
        [
            self.request_type,
            self.request,
            value[0],
            value[1],
            index[0],
            index[1],
            length[0],
            length[1],
        ]
    }

    /// Whether data go from the device to the host.
    #[must_use]
    pub fn is_in(&self) -> bool {
        self.request_type & 0x80 != 0
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum TransferStage {
    Setup,
    Data,
    Status,
}

/// A control transfer under way.
#[derive(Debug)]
pub(super) struct ControlTransfer {
    address: u8,
    pub(super) setup: Setup,
    /// Bytes to be sent, or received.
    pub(super) data: Vec<u8>,
    sent: usize,
    packet_bytes: usize,
    toggle: bool,
    stage: TransferStage,
    silences: u32,
    started_ns: Option<u64>,
}

impl ControlTransfer {
    pub(super) fn new(address: u8, setup: Setup, data: Vec<u8>, packet_bytes: usize) -> Self {
        Self {
            address,
            setup,
            data,
            sent: 0,
            packet_bytes,
            toggle: true,
            stage: TransferStage::Setup,
            silences: 0,
            started_ns: None,
        }
    }

    /// Does one transaction; the outcome once the transfer is over.
    pub(super) fn step(
        &mut self,
        controller: &mut Controller,
        now_ns: u64,
    ) -> Option<Result<(), UsbError>> {
        if now_ns - *self.started_ns.get_or_insert(now_ns) > PATIENCE_NS {
            return Some(Err(UsbError::Timeout));
        }
        let done = match (self.stage, self.setup.is_in()) {
            (TransferStage::Setup, _) => self.start(controller),
            (TransferStage::Data, true) => self.receive(controller),
            (TransferStage::Data, false) => self.send(controller),
            (TransferStage::Status, true) => self.confirm(controller),
            (TransferStage::Status, false) => self.hear_status(controller),
        };
        match done {
            Ok(true) => Some(Ok(())),
            Ok(false) => None,
            Err(UsbError::NoAnswer) if self.silences + 1 < ATTEMPTS => {
                self.silences += 1;
                None
            }
            Err(error) => Some(Err(error)),
        }
    }

    fn start(&mut self, controller: &mut Controller) -> Result<bool, UsbError> {
        heard(controller.setup(self.address, self.setup.bytes()))?;
        self.stage = match self.setup.length {
            0 => TransferStage::Status,
            _ => TransferStage::Data,
        };
        Ok(false)
    }

    fn receive(&mut self, controller: &mut Controller) -> Result<bool, UsbError> {
        let Some((packet, toggle)) = asked(controller.ask(self.address, 0))? else {
            return Ok(false);
        };
        if toggle != self.toggle {
            return Err(UsbError::Toggle);
        }
        controller.acknowledge(0, packet.len());
        self.toggle = !self.toggle;
        self.data.extend(&packet);
        let short = packet.len() < self.packet_bytes;
        if short || self.data.len() >= usize::from(self.setup.length) {
            self.stage = TransferStage::Status;
        }
        Ok(false)
    }

    fn send(&mut self, controller: &mut Controller) -> Result<bool, UsbError> {
        let end = self.data.len().min(self.sent + self.packet_bytes);
        let packet = &self.data[self.sent..end];
        if heard(controller.out(self.address, 0, self.toggle, packet))? {
            self.toggle = !self.toggle;
            self.sent = end;
            if self.sent == self.data.len() {
                self.stage = TransferStage::Status;
            }
        }
        Ok(false)
    }

    /// The status stage of a transfer to the host: an empty packet to the device.
    fn confirm(&mut self, controller: &mut Controller) -> Result<bool, UsbError> {
        heard(controller.out(self.address, 0, true, &[]))
    }

    /// The status stage of a transfer to the device: an empty packet from it.
    fn hear_status(&mut self, controller: &mut Controller) -> Result<bool, UsbError> {
        let Some((packet, _)) = asked(controller.ask(self.address, 0))? else {
            return Ok(false);
        };
        controller.acknowledge(0, packet.len());
        Ok(true)
    }
}

/// Whether a packet was taken; a NAK is to be tried again.
pub(super) fn heard(handshake: Handshake) -> Result<bool, UsbError> {
    match handshake {
        Handshake::Ack => Ok(true),
        Handshake::Nak => Ok(false),
        Handshake::Stall => Err(UsbError::Stall),
        Handshake::Silence => Err(UsbError::NoAnswer),
    }
}

/// Bytes received, if any; a NAK is to be tried again.
pub(super) fn asked(answer: Answer) -> Result<Option<(Vec<u8>, bool)>, UsbError> {
    match answer {
        Answer::Data(packet, toggle) => Ok(Some((packet, toggle))),
        Answer::Nak => Ok(None),
        Answer::Stall => Err(UsbError::Stall),
        Answer::Silence => Err(UsbError::NoAnswer),
    }
}
