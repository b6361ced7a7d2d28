//! One endpoint of the core.

use std::collections::VecDeque;

use super::registers::*;

/// Packet sizes the two-bit code of endpoint 0 stands for.
const CONTROL_PACKET: [u32; 4] = [64, 32, 16, 8];

/// State common to both directions.
#[derive(Debug, Clone, Default, serde::Serialize, serde::Deserialize)]
pub(super) struct Endpoint {
    stored: u32,
    nak: bool,
    enabled: bool,
    /// Data toggle of the next packet: false is DATA0.
    pub(super) toggle: bool,
    pub(super) interrupts: u32,
    pub(super) size: u32,
}

impl Endpoint {
    pub(super) fn control(&self, number: usize) -> u32 {
        let flag = |set: bool, bit: u32| if set { bit } else { 0 };
        self.stored
            | flag(self.nak, NAKSTS)
            | flag(self.enabled, EPENA)
            | flag(self.toggle, DPID)
            | flag(number == 0, USBAEP)
    }

    pub(super) fn write_control(&mut self, value: u32) {
        self.stored = value & STORED;
        // Clearing wins over setting: the driver writes one at a time.
        self.nak = (self.nak || value & SNAK != 0) && value & CNAK == 0;
        if value & SD0PID != 0 {
            self.toggle = false;
        }
        if value & SD1PID != 0 {
            self.toggle = true;
        }
        if value & EPDIS != 0 && self.enabled {
            self.enabled = false;
            self.interrupts |= EPDISD;
        } else if value & EPENA != 0 {
            self.enabled = true;
        }
    }

    pub(super) fn is_active(&self, number: usize) -> bool {
        number == 0 || self.stored & USBAEP != 0
    }

    pub(super) fn is_stalled(&self) -> bool {
        self.stored & STALL != 0
    }

    pub(super) fn naks(&self) -> bool {
        self.nak
    }

    pub(super) fn set_nak(&mut self) {
        self.nak = true;
    }

    /// A SETUP packet ends a stall of the control endpoint and starts its data stage with DATA1.
    pub(super) fn setup_received(&mut self) {
        self.stored &= !STALL;
        self.nak = true;
        self.toggle = true;
    }

    pub(super) fn bus_reset(&mut self) {
        self.enabled = false;
        self.nak = true;
        self.toggle = false;
        self.stored &= !(USBAEP | STALL);
    }

    pub(super) fn packet_bytes(&self, number: usize) -> u32 {
        match number {
            0 => CONTROL_PACKET[(self.stored & 0b11) as usize],
            _ => self.stored & 0x7FF,
        }
    }

    /// The transfer is over: flag it, stop.
    pub(super) fn complete(&mut self) {
        self.interrupts |= XFRC;
        self.enabled = false;
    }

    pub(super) fn transfer_bytes(&self) -> u32 {
        self.size & 0x7_FFFF
    }

    pub(super) fn packets(&self) -> u32 {
        (self.size >> 19) & 0x3FF
    }

    /// Counts one packet of `bytes` off the transfer.
    pub(super) fn count_packet(&mut self, bytes: u32) {
        let left = self.transfer_bytes().saturating_sub(bytes);
        let packets = self.packets().saturating_sub(1);
        self.size = (self.size & !0x1FFF_FFFF) | packets << 19 | left;
    }
}

/// An IN endpoint with its transmit FIFO.
#[derive(Debug, Clone, Default, serde::Serialize, serde::Deserialize)]
pub(super) struct InEndpoint {
    pub(super) common: Endpoint,
    pub(super) fifo: VecDeque<u32>,
    /// Words the FIFO holds.
    pub(super) depth: u32,
}

impl InEndpoint {
    pub(super) fn fifo_number(&self) -> u64 {
        u64::from((self.common.stored >> 22) & 0xF)
    }

    pub(super) fn free_words(&self) -> u32 {
        self.depth.saturating_sub(self.fifo.len() as u32)
    }

    /// Bytes of the packet that is complete in the FIFO, if one is to be sent.
    pub(super) fn ready_bytes(&self, number: usize) -> Option<u32> {
        let common = &self.common;
        let bytes = common.transfer_bytes().min(common.packet_bytes(number));
        let there = self.fifo.len() as u32 * 4 >= bytes;
        (common.enabled && !common.nak && common.packets() > 0 && there).then_some(bytes)
    }

    /// The packet of `bytes`, left in place: the host may not have heard it.
    pub(super) fn packet(&self, bytes: u32) -> Vec<u8> {
        let words = self.fifo.iter().flat_map(|word| word.to_le_bytes());
        words.take(bytes as usize).collect()
    }

    /// The host has acknowledged a packet of `bytes`.
    pub(super) fn acknowledged(&mut self, bytes: u32) {
        self.fifo.drain(..bytes.div_ceil(4) as usize);
        self.common.toggle = !self.common.toggle;
        self.common.count_packet(bytes);
        if self.common.packets() == 0 {
            self.common.complete();
        }
    }
}
