//! The device core: what the firmware sees of it, and what the bus sees.

use std::collections::VecDeque;

use super::endpoint::{Endpoint, InEndpoint};
use super::registers::*;

/// Nanoseconds of a frame.
const FRAME_NS: u64 = 1_000_000;

/// How a device answers a packet sent to it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Handshake {
    Ack,
    Nak,
    Stall,
    /// Nothing: nobody has this address, or this endpoint is off.
    Silence,
}

/// How a device answers when asked for a packet.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Answer {
    Data(Vec<u8>, bool),
    Nak,
    Stall,
    Silence,
}

/// Registers, FIFOs and endpoints of the core.
#[derive(Debug, Default, serde::Serialize, serde::Deserialize)]
pub(super) struct Controller {
    vbus: bool,
    suspended: bool,
    otg_control: u32,
    otg_interrupts: u32,
    bus_interface: u32,
    usb_configuration: u32,
    /// Flags of `GINTSTS` that stay until cleared.
    latched: u32,
    mask: u32,
    receive_words: u32,
    transmit_fifos: [u32; ENDPOINTS],
    general: u32,
    configuration: u32,
    /// The address answered to. A new one counts once the transfer that brought it has ended: the
    /// driver writes it before the status stage.
    address: u8,
    device_control: u32,
    in_mask: u32,
    out_mask: u32,
    endpoint_mask: u32,
    empty_mask: u32,
    power: u32,
    receive_status: VecDeque<u32>,
    receive_data: VecDeque<u32>,
    ins: [InEndpoint; ENDPOINTS],
    outs: [Endpoint; ENDPOINTS],
}

// What the firmware sees.
impl Controller {
    pub(super) fn read(&mut self, offset: u64, now_ns: u64) -> u32 {
        match offset {
            GOTGCTL => self.otg_control | if self.vbus { BSVLD } else { 0 },
            GOTGINT => self.otg_interrupts,
            GAHBCFG => self.bus_interface,
            GUSBCFG => self.usb_configuration,
            GRSTCTL => AHBIDL,
            GINTSTS => self.flags(),
            GINTMSK => self.mask,
            GRXSTSR => self.receive_status.front().copied().unwrap_or(0),
            GRXSTSP => self.pop_status(),
            GRXFSIZ => self.receive_words,
            DIEPTXF0 => self.transmit_fifos[0],
            DIEPTXF1..=DIEPTXF8 => self.transmit_fifos[1 + ((offset - DIEPTXF1) / 4) as usize],
            GCCFG => self.general,
            CID => CORE_ID,
            DCFG => self.configuration,
            DCTL => self.device_control,
            DSTS => self.status(now_ns),
            DIEPMSK => self.in_mask,
            DOEPMSK => self.out_mask,
            DAINT => self.endpoint_flags(),
            DAINTMSK => self.endpoint_mask,
            DIEPEMPMSK => self.empty_mask,
            IN_ENDPOINTS..OUT_ENDPOINTS => self.read_in(offset - IN_ENDPOINTS),
            OUT_ENDPOINTS..PCGCCTL => self.read_out(offset - OUT_ENDPOINTS),
            PCGCCTL => self.power,
            FIFOS.. => self.receive_data.pop_front().unwrap_or(0),
            _ => 0,
        }
    }

    pub(super) fn write(&mut self, offset: u64, value: u32) {
        match offset {
            GOTGCTL => self.otg_control = value & !BSVLD,
            GOTGINT => self.otg_interrupts &= !value,
            GAHBCFG => self.bus_interface = value,
            GUSBCFG => self.usb_configuration = value,
            GRSTCTL => self.reset(value),
            GINTSTS => self.latched &= !value,
            GINTMSK => self.mask = value,
            GRXFSIZ => self.receive_words = value & 0xFFFF,
            DIEPTXF0 => self.size_fifo(0, value),
            DIEPTXF1..=DIEPTXF8 => self.size_fifo(1 + ((offset - DIEPTXF1) / 4) as usize, value),
            GCCFG => self.general = value,
            DCFG => self.write_configuration(value),
            DCTL => self.write_device_control(value),
            DIEPMSK => self.in_mask = value,
            DOEPMSK => self.out_mask = value,
            DAINTMSK => self.endpoint_mask = value,
            DIEPEMPMSK => self.empty_mask = value,
            IN_ENDPOINTS..OUT_ENDPOINTS => self.write_in(offset - IN_ENDPOINTS, value),
            OUT_ENDPOINTS..PCGCCTL => self.write_out(offset - OUT_ENDPOINTS, value),
            PCGCCTL => self.power = value,
            FIFOS.. => self.push_fifo((offset - FIFOS) / FIFO_STRIDE, value),
            _ => {}
        }
    }

    /// Level of the core's interrupt line.
    pub(super) fn interrupt(&self) -> bool {
        self.bus_interface & GINT != 0 && self.flags() & self.mask != 0
    }

    fn flags(&self) -> u32 {
        let endpoints = self.endpoint_flags() & self.endpoint_mask;
        let flag = |set: bool, bit: u32| if set { bit } else { 0 };
        self.latched
            | NPTXFE
            | flag(self.otg_interrupts != 0, OTGINT)
            | flag(!self.receive_status.is_empty(), RXFLVL)
            | flag(endpoints & 0xFFFF != 0, IEPINT)
            | flag(endpoints >> 16 != 0, OEPINT)
    }

    fn endpoint_flags(&self) -> u32 {
        (0..ENDPOINTS).fold(0, |flags, number| {
            let inward = self.in_flags(number) & (self.in_mask | TXFE) != 0;
            let outward = self.outs[number].interrupts & self.out_mask != 0;
            flags | u32::from(inward) << number | u32::from(outward) << (16 + number)
        })
    }

    fn in_flags(&self, number: usize) -> u32 {
        let endpoint = &self.ins[number];
        let watched = self.empty_mask & (1 << number) != 0;
        let empty = watched && endpoint.fifo.is_empty();
        endpoint.common.interrupts | if empty { TXFE } else { 0 }
    }

    fn status(&self, now_ns: u64) -> u32 {
        let frame = (now_ns / FRAME_NS) as u32 & 0x7FF;
        let suspended = if self.suspended { SUSPSTS } else { 0 };
        frame << 8 | FULL_SPEED | suspended
    }

    fn pop_status(&mut self) -> u32 {
        let Some(status) = self.receive_status.pop_front() else {
            return 0;
        };
        let number = (status & 0xF) as usize;
        match status >> 17 & 0xF {
            SETUP_DONE => self.outs[number].interrupts |= STUP,
            OUT_DONE => self.outs[number].interrupts |= XFRC,
            _ => {}
        }
        status
    }

    fn reset(&mut self, value: u32) {
        if value & CSRST != 0 {
            let vbus = self.vbus;
            *self = Self::default();
            self.vbus = vbus;
        }
        if value & RXFFLSH != 0 {
            self.receive_status.clear();
            self.receive_data.clear();
        }
        if value & TXFFLSH != 0 {
            let number = value >> 6 & 0x1F;
            for endpoint in &mut self.ins {
                if number == ALL_FIFOS || endpoint.fifo_number() == u64::from(number) {
                    endpoint.fifo.clear();
                }
            }
        }
    }

    fn size_fifo(&mut self, number: usize, value: u32) {
        self.transmit_fifos[number] = value;
        self.ins[number].depth = value >> 16;
    }

    fn write_configuration(&mut self, value: u32) {
        self.configuration = value;
        if self.configured_address() == 0 {
            self.address = 0;
        }
    }

    fn configured_address(&self) -> u8 {
        (self.configuration >> 4) as u8 & 0x7F
    }

    fn write_device_control(&mut self, value: u32) {
        if value & RWUSIG != 0 && self.suspended {
            self.suspend(false);
        }
        self.device_control = value;
    }

    fn push_fifo(&mut self, number: u64, word: u32) {
        let found = self.ins.iter_mut().enumerate().find(|(index, endpoint)| {
            endpoint.fifo_number() == number && (number == 0) == (*index == 0)
        });
        if let Some((_, endpoint)) = found {
            endpoint.fifo.push_back(word);
        }
    }

    fn read_in(&self, offset: u64) -> u32 {
        let (number, register) = split(offset);
        let Some(endpoint) = self.ins.get(number) else {
            return 0;
        };
        match register {
            EP_CONTROL => endpoint.common.control(number),
            EP_INTERRUPT => self.in_flags(number),
            EP_SIZE => endpoint.common.size,
            EP_FIFO_STATUS => endpoint.free_words(),
            _ => 0,
        }
    }

    fn write_in(&mut self, offset: u64, value: u32) {
        let (number, register) = split(offset);
        let Some(endpoint) = self.ins.get_mut(number) else {
            return;
        };
        match register {
            EP_CONTROL => endpoint.common.write_control(value),
            EP_INTERRUPT => endpoint.common.interrupts &= !value,
            EP_SIZE => endpoint.common.size = value,
            _ => {}
        }
    }

    fn read_out(&self, offset: u64) -> u32 {
        let (number, register) = split(offset);
        let Some(endpoint) = self.outs.get(number) else {
            return 0;
        };
        match register {
            EP_CONTROL => endpoint.control(number),
            EP_INTERRUPT => endpoint.interrupts,
            EP_SIZE => endpoint.size,
            _ => 0,
        }
    }

    fn write_out(&mut self, offset: u64, value: u32) {
        let (number, register) = split(offset);
        let Some(endpoint) = self.outs.get_mut(number) else {
            return;
        };
        match register {
            EP_CONTROL => endpoint.write_control(value),
            EP_INTERRUPT => endpoint.interrupts &= !value,
            EP_SIZE => endpoint.size = value,
            _ => {}
        }
    }
}

// What the bus sees.
impl Controller {
    pub(super) fn has_vbus(&self) -> bool {
        self.vbus
    }

    /// VBUS comes or goes.
    pub(super) fn vbus(&mut self, present: bool) {
        if present && !self.vbus {
            self.latched |= SRQINT;
        } else if !present && self.vbus {
            self.otg_interrupts |= SEDET;
        }
        self.vbus = present;
        self.suspended &= present;
    }

    /// The pull-up is on: the transceiver runs, and software has not disconnected.
    pub(super) fn connected(&self) -> bool {
        self.vbus && self.general & PWRDWN != 0 && self.device_control & SDIS == 0
    }

    pub(super) fn begin_reset(&mut self) {
        self.suspended = false;
        self.latched |= USBRST;
        self.configuration &= !(0x7F << 4);
        self.address = 0;
        self.receive_status.clear();
        self.receive_data.clear();
        for endpoint in &mut self.ins {
            endpoint.common.bus_reset();
            endpoint.fifo.clear();
        }
        self.outs.iter_mut().for_each(Endpoint::bus_reset);
    }

    pub(super) fn end_reset(&mut self) {
        self.latched |= ENUMDNE;
    }

    pub(super) fn suspend(&mut self, suspended: bool) {
        if suspended != self.suspended {
            self.suspended = suspended;
            self.latched |= if suspended { USBSUSP } else { WKUPINT };
        }
    }

    /// Whether this device listens to `address`.
    fn addressed(&self, address: u8) -> bool {
        self.connected() && address == self.address
    }

    pub(super) fn setup(&mut self, address: u8, packet: [u8; 8]) -> Handshake {
        if !self.addressed(address) {
            return Handshake::Silence;
        }
        self.ins[0].common.setup_received();
        self.outs[0].setup_received();
        self.push_status(0, 8, SETUP_DATA);
        self.push_data(&packet);
        self.push_status(0, 0, SETUP_DONE);
        Handshake::Ack
    }

    pub(super) fn out(
        &mut self,
        address: u8,
        number: usize,
        toggle: bool,
        data: &[u8],
    ) -> Handshake {
        let endpoint = &self.outs[number];
        if !self.addressed(address) || !endpoint.is_active(number) {
            return Handshake::Silence;
        }
        if endpoint.is_stalled() {
            return Handshake::Stall;
        }
        if !self.takes(number, data.len()) {
            return Handshake::Nak;
        }
        if endpoint.toggle != toggle {
            // A repetition of a packet already taken: acknowledged and dropped.
            return Handshake::Ack;
        }
        let endpoint = &mut self.outs[number];
        endpoint.toggle = !toggle;
        endpoint.count_packet(data.len() as u32);
        endpoint.set_nak();
        self.push_status(number, data.len(), OUT_DATA);
        self.push_data(data);
        self.push_status(number, 0, OUT_DONE);
        Handshake::Ack
    }

    /// Whether an OUT endpoint would take a packet of `bytes` now.
    pub(super) fn takes(&self, number: usize, bytes: usize) -> bool {
        let endpoint = &self.outs[number];
        let room = (self.receive_words as usize).saturating_sub(self.receive_data.len());
        // Endpoint 0's packet count is not the driver's to set before its first packet.
        let counted = number == 0 || endpoint.packets() > 0;
        counted && !endpoint.naks() && room >= bytes.div_ceil(4)
    }

    pub(super) fn ask(&mut self, address: u8, number: usize) -> Answer {
        let endpoint = &self.ins[number];
        if !self.addressed(address) || !endpoint.common.is_active(number) {
            return Answer::Silence;
        }
        if endpoint.common.is_stalled() {
            return Answer::Stall;
        }
        match endpoint.ready_bytes(number) {
            Some(bytes) => Answer::Data(endpoint.packet(bytes), endpoint.common.toggle),
            None => Answer::Nak,
        }
    }

    /// Whether an IN endpoint has something else than NAK to say.
    pub(super) fn speaks(&self, number: usize) -> bool {
        let endpoint = &self.ins[number];
        endpoint.common.is_stalled() || endpoint.ready_bytes(number).is_some()
    }

    /// The host has heard the packet of `bytes` from endpoint `number`.
    pub(super) fn acknowledge(&mut self, number: usize, bytes: usize) {
        self.ins[number].acknowledged(bytes as u32);
        if number == 0 && bytes == 0 {
            self.address = self.configured_address();
        }
    }

    fn push_status(&mut self, number: usize, bytes: usize, kind: u32) {
        let status = number as u32 | (bytes as u32) << 4 | kind << 17;
        self.receive_status.push_back(status);
    }

    fn push_data(&mut self, data: &[u8]) {
        for chunk in data.chunks(4) {
            let mut word = [0; 4];
            word[..chunk.len()].copy_from_slice(chunk);
            self.receive_data.push_back(u32::from_le_bytes(word));
        }
    }
}

/// Number of the endpoint and offset in its block.
fn split(offset: u64) -> (usize, u64) {
    let number = (offset / ENDPOINT_STRIDE) as usize;
    (number, offset % ENDPOINT_STRIDE)
}
