//! The host's end of the cable: one transaction at a time, in the slots of a full-speed bus.

use std::collections::VecDeque;

use super::controller::Controller;
use super::transfer::{ControlTransfer, Setup, UsbError, asked, heard};

/// A slot: 19 bulk packets of 64 bytes fit in a frame of 1 ms (USB 2.0, table 5-9).
pub(super) const SLOT_NS: u64 = 1_000_000 / 19;

/// Packet size of endpoint 0, the largest at full speed and the one this device has.
const CONTROL_PACKET_BYTES: usize = 64;

/// The bulk pipes of a configured device.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Pipes {
    /// The device's address.
    pub address: u8,
    /// Number of the endpoint to the device.
    pub out_endpoint: u8,
    /// Number of the endpoint from the device.
    pub in_endpoint: u8,
    /// Bytes of a packet.
    pub packet_bytes: u16,
}

/// Something that crossed the bus.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Transferred {
    /// When it was complete, in virtual nanoseconds.
    pub at_ns: u64,
    /// The device's address.
    pub address: u8,
    /// Endpoint with its direction in bit 7.
    pub endpoint: u8,
    /// The setup packet of a control transfer.
    pub setup: Option<Setup>,
    /// The data.
    pub data: Vec<u8>,
    /// How it ended.
    pub outcome: Result<(), UsbError>,
}

/// Request of the host to the bus.
#[derive(Debug, Default)]
pub(super) struct Bus {
    control: Option<(u8, ControlTransfer)>,
    result: Option<Result<Vec<u8>, UsbError>>,
    pipes: Option<Pipes>,
    out_toggle: bool,
    in_toggle: bool,
    pub(super) outgoing: VecDeque<u8>,
    pub(super) incoming: VecDeque<u8>,
    pub(super) reading: bool,
    pub(super) suspended: bool,
    pub(super) pipe_error: Option<UsbError>,
    /// One of so many handshakes of the bulk pipes is lost on the way; 0 for none.
    pub(super) lost_handshake: u32,
    handshakes: u32,
    /// Transactions after which the cable is pulled out.
    pub(super) pull_after: Option<u32>,
    /// Traffic of the bus, when somebody wants to know.
    pub(super) capture: Option<Vec<Transferred>>,
}

impl Bus {
    pub(super) fn start_control(&mut self, address: u8, setup: Setup, data: Vec<u8>) {
        let transfer = ControlTransfer::new(address, setup, data, CONTROL_PACKET_BYTES);
        self.control = Some((address, transfer));
        self.result = None;
    }

    pub(super) fn take_result(&mut self) -> Option<Result<Vec<u8>, UsbError>> {
        self.result.take()
    }

    pub(super) fn open_pipes(&mut self, pipes: Pipes) {
        self.close_pipes();
        self.incoming.clear();
        self.pipes = Some(pipes);
        self.reading = true;
    }

    /// Closes the pipes and forgets what was queued.
    pub(super) fn close_pipes(&mut self) {
        self.pipes = None;
        self.pipe_error = None;
        (self.out_toggle, self.in_toggle) = (false, false);
        self.outgoing.clear();
    }

    /// The cable is out.
    pub(super) fn unplugged(&mut self) {
        self.suspended = false;
        self.pull_after = None;
        self.device_gone();
    }

    /// The device has lost its state: nothing under way will end well.
    pub(super) fn device_gone(&mut self) {
        if self.control.take().is_some() {
            self.result = Some(Err(UsbError::Gone));
        }
        let had_pipes = self.pipes.is_some();
        self.close_pipes();
        self.pipe_error = had_pipes.then_some(UsbError::Gone);
    }

    /// Whether a slot would be used.
    pub(super) fn wants_slot(&self, controller: &Controller) -> bool {
        if self.suspended {
            return false;
        }
        self.control.is_some()
            || self.pipes.is_some_and(|pipes| {
                self.wants_in(&pipes, controller) || self.wants_out(&pipes, controller)
            })
    }

    fn wants_in(&self, pipes: &Pipes, controller: &Controller) -> bool {
        self.reading && controller.speaks(usize::from(pipes.in_endpoint))
    }

    fn wants_out(&self, pipes: &Pipes, controller: &Controller) -> bool {
        let bytes = self.outgoing.len().min(usize::from(pipes.packet_bytes));
        bytes > 0 && controller.takes(usize::from(pipes.out_endpoint), bytes)
    }

    /// Uses one slot: a control transfer before bulk, from the device before to it.
    pub(super) fn use_slot(&mut self, controller: &mut Controller, now_ns: u64) {
        if self.suspended {
            return;
        }
        if self.control.is_some() {
            return self.step_control(controller, now_ns);
        }
        let Some(pipes) = self.pipes else { return };
        let moved = if self.wants_in(&pipes, controller) {
            self.receive(&pipes, controller, now_ns)
        } else if self.wants_out(&pipes, controller) {
            self.send(&pipes, controller, now_ns)
        } else {
            Ok(())
        };
        if let Err(error) = moved {
            self.pipe_error = Some(error);
            self.pipes = None;
        }
    }

    fn step_control(&mut self, controller: &mut Controller, now_ns: u64) {
        let Some((address, mut transfer)) = self.control.take() else {
            return;
        };
        match transfer.step(controller, now_ns) {
            None => self.control = Some((address, transfer)),
            Some(outcome) => {
                let inward = if transfer.setup.is_in() { 0x80 } else { 0 };
                if let Some(capture) = &mut self.capture {
                    capture.push(Transferred {
                        at_ns: now_ns,
                        address,
                        endpoint: inward,
                        setup: Some(transfer.setup),
                        data: transfer.data.clone(),
                        outcome,
                    });
                }
                self.result = Some(outcome.map(|()| transfer.data));
            }
        }
    }

    fn receive(
        &mut self,
        pipes: &Pipes,
        controller: &mut Controller,
        now_ns: u64,
    ) -> Result<(), UsbError> {
        let number = usize::from(pipes.in_endpoint);
        if let Some((packet, toggle)) = asked(controller.ask(pipes.address, number))? {
            if !self.handshake_is_lost() {
                controller.acknowledge(number, packet.len());
            }
            // A packet with the toggle of the last one is its repetition: acknowledged and dropped.
            if toggle == self.in_toggle {
                self.in_toggle = !toggle;
                self.incoming.extend(&packet);
                self.note(pipes.address, 0x80 | pipes.in_endpoint, packet, now_ns);
            }
        }
        Ok(())
    }

    fn send(
        &mut self,
        pipes: &Pipes,
        controller: &mut Controller,
        now_ns: u64,
    ) -> Result<(), UsbError> {
        let bytes = self.outgoing.len().min(usize::from(pipes.packet_bytes));
        let packet: Vec<u8> = self.outgoing.iter().copied().take(bytes).collect();
        let number = usize::from(pipes.out_endpoint);
        let taken = heard(controller.out(pipes.address, number, self.out_toggle, &packet))?;
        if taken && !self.handshake_is_lost() {
            self.out_toggle = !self.out_toggle;
            self.outgoing.drain(..bytes);
            self.note(pipes.address, pipes.out_endpoint, packet, now_ns);
        }
        Ok(())
    }

    fn handshake_is_lost(&mut self) -> bool {
        self.handshakes = self.handshakes.wrapping_add(1);
        self.lost_handshake > 0 && self.handshakes.is_multiple_of(self.lost_handshake)
    }

    fn note(&mut self, address: u8, endpoint: u8, data: Vec<u8>, at_ns: u64) {
        if let Some(capture) = &mut self.capture {
            capture.push(Transferred {
                at_ns,
                address,
                endpoint,
                setup: None,
                data,
                outcome: Ok(()),
            });
        }
    }
}
