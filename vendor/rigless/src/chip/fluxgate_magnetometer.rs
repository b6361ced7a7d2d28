// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! A digital fluxgate magnetometer on a serial line: [`Magnetometer`], which streams one packet a
//! second of a hundred samples of the field the world hands it, each axis a feedback count and a
//! residual count, with a block of housekeeping words. It matches Ex-Alta 2's DFGM as its flight
//! software's driver reads it.
//!
//! **Nothing goes to it.** The instrument streams whether anyone listens or not. It ignores every
//! byte the controller sends it.
//!
//! **A packet.** Every multi-byte field is most significant byte first. A reader frames a packet by
//! the line's silence alone: 1248 bytes back to back, a frame each, then the rest of the second
//! quiet, so the gap between packets is far longer than any gap inside one.
//!
//! | Offset | Bytes | Field |
//! |---|---|---|
//! | 0 | 1 | `DLE`, `10` |
//! | 1 | 1 | `STX`, `02` |
//! | 2 | 1 | Packet ID |
//! | 3 | 1 | Packet type |
//! | 4 | 2 | Packet length, 1248 |
//! | 6 | 2 | Sample rate, 100 |
//! | 8 | 4 | PPS offset |
//! | 12 | 24 | Twelve housekeeping words |
//! | 36 | 1200 | A hundred samples of `x`, `y` and `z`, each the feedback count then the residual count as signed sixteen-bit halves |
//! | 1236 | 2 | Board ID |
//! | 1238 | 2 | Sensor ID |
//! | 1240 | 5 | Reserved |
//! | 1245 | 1 | `ETX`, `03` |
//! | 1246 | 2 | CRC |
//!
//! **A sample.** The field on an axis is the feedback count times that axis's feedback scale plus
//! the residual count times its residual scale, in nanotesla. The instrument takes the feedback count
//! nearest the field and the residual count nearest what's left.
//!
//! No public document describes the instrument, so every row cites how Ex-Alta 2's flight software
//! reads it: the functions of `ex2_hal/dfgm/equipment_handler/source/dfgm_handler.c` in AlbertaSat's
//! public `ex2_obc_software`.
//!
//! | Register or section | Behavior | Source | Test |
//! |---|---|---|---|
//! | Stream | One packet a second, on the run's own second, written once the last has gone | `dfgm_rx_task`, which takes 1248 bytes with no gap of 100 ms as a packet, and `dfgm_sciNotification` | `a_packet_comes_once_a_second_and_frames_by_the_silence_between` |
//! | Layout | The fields above at their offsets, big-endian | `dfgm_packet_t`, which `dfgm_rx_task` fills byte by byte | `the_packet_has_its_fields_where_a_driver_reads_them` |
//! | Samples | `x` feedback 1.757421875 nT a count and residual −0.0353, `y` 2.031835938 and −0.0267, `z` 1.934375 and −0.0302. The field reads back to within half a residual count, and a count past sixteen bits holds at its end | `DFGM_convertRawMagData` | `each_sample_reads_back_the_field_through_the_scales`, `a_field_past_the_range_holds_at_its_end` |
//! | Housekeeping | Core 1.5 V, sensor 20 °C, reference and board 20 °C, rails 5 V, reference 1.25 V, input 100 mA, as a driver's scales read them | `DFGM_convertRaw_HK_data` for the scales. The readings are this model's, a bench's | `the_housekeeping_reads_a_bench` |
//! | Input | What the controller sends is dropped | `DFGM_init`, whose transmit semaphore nothing takes, so the driver never sends | `the_packet_has_its_fields_where_a_driver_reads_them` |
//! | Power | When its supply goes the packet in flight goes with it, and the stream starts again from a whole packet when the supply comes back | assumption: no public document says | `power_on_starts_a_whole_packet` |
//! | Snapshot | The field, the packet in flight and when the next is due | not applicable | `a_snapshot_keeps_the_packet_in_flight` |
//!
//! **Left out.**
//!
//! | Behavior | Reason |
//! |---|---|
//! | The CRC | Its algorithm isn't public, so it's written as zero |
//! | Commands | None are public |
//! | The field changing within a packet | Every sample of a packet is the field as the packet was written, since the world changes it between a session's steps and not between samples |
//! | The PPS offset | Nothing on the board carries a pulse per second to the instrument, so it's zero |

use std::collections::VecDeque;

use crate::chip::Timeline;
use crate::chip::earth::nearest_i16;
use crate::chip::uart::Peer;
use crate::snapshot::store;
use crate::time::{NANOS_PER_SECOND, VirtualNanos};

/// The bytes of a packet.
pub const PACKET: usize = 1248;
/// Samples in a packet, a hundredth of a second apart.
pub const SAMPLES: usize = 100;
/// A packet each second.
const PERIOD: VirtualNanos = VirtualNanos(NANOS_PER_SECOND);

const DLE: u8 = 0x10;
const STX: u8 = 0x02;
const ETX: u8 = 0x03;
/// The packet ID and type, the board and sensor IDs.
// ceiling: no public document gives the instrument's IDs, so they're this model's
const PACKET_ID: u8 = 1;
const PACKET_TYPE: u8 = 1;
const BOARD_ID: u16 = 1;
const SENSOR_ID: u16 = 1;
const SAMPLE_RATE: u16 = 100;
const RESERVED: usize = 5;

/// Each axis's feedback and residual scales, nanotesla a count.
pub const SCALES: [(f64, f64); 3] = [
    (1.757_421_875, -0.0353),
    (2.031_835_938, -0.0267),
    (1.934_375, -0.0302),
];

/// The raw housekeeping words: core 1.5 V at 0.61 mV a count, sensor 20 °C at 0.122 K a count from
/// 0 K, reference and board 20 °C at 0.0313 °C a count from −20.51 °C, both rails 5 V at 3.05 mV a
/// count, reference 1.25 V at 0.61 mV a count, input 100 mA at 0.107 mA a count, and four reserved.
pub const HOUSEKEEPING: [u16; 12] = [2458, 2402, 1294, 1294, 1638, 1638, 2048, 935, 0, 0, 0, 0];

/// A fluxgate magnetometer streaming packets.
#[derive(Debug, serde::Serialize, serde::Deserialize)]
pub struct Magnetometer {
    field: [i32; 3],
    next: VirtualNanos,
    pending: VecDeque<u8>,
}

impl Magnetometer {
    /// An instrument in no field, with its first packet due at the start of the run.
    #[must_use]
    pub fn new() -> Self {
        Self {
            field: [0; 3],
            next: VirtualNanos(0),
            pending: VecDeque::with_capacity(PACKET),
        }
    }

    /// The field along each of the sensor's axes from now on, in nanotesla.
    pub fn set_field(&mut self, nanotesla: [i32; 3]) {
        self.field = nanotesla;
    }

    /// The packet of the field as it stands.
    #[must_use]
    pub fn packet(&self) -> Vec<u8> {
        let mut packet = Vec::with_capacity(PACKET);
        packet.extend([DLE, STX, PACKET_ID, PACKET_TYPE]);
        packet.extend(u16::try_from(PACKET).expect("a short packet").to_be_bytes());
        packet.extend(SAMPLE_RATE.to_be_bytes());
        packet.extend(0_u32.to_be_bytes());
        for word in HOUSEKEEPING {
            packet.extend(word.to_be_bytes());
        }
        let sample: Vec<u8> = self
            .field
            .iter()
            .zip(SCALES)
            .flat_map(|(&field, scales)| counts(field, scales))
            .flat_map(i16::to_be_bytes)
            .collect();
        for _ in 0..SAMPLES {
            packet.extend(&sample);
        }
        packet.extend(BOARD_ID.to_be_bytes());
        packet.extend(SENSOR_ID.to_be_bytes());
        packet.extend([0; RESERVED]);
        packet.push(ETX);
        packet.extend(0_u16.to_be_bytes());
        packet
    }
}

/// The feedback count nearest `field` and the residual count nearest what it leaves.
fn counts(field: i32, (feedback, residual): (f64, f64)) -> [i16; 2] {
    let field = f64::from(field);
    let coarse = nearest_i16(field / feedback);
    let left = field - f64::from(coarse) * feedback;
    [coarse, nearest_i16(left / residual)]
}

impl Default for Magnetometer {
    fn default() -> Self {
        Self::new()
    }
}

store!(Magnetometer);

impl Peer for Magnetometer {
    fn receive(&mut self, _word: u16, _context: &mut Timeline<'_, '_>) {}

    fn power_changed(&mut self, on: bool, context: &mut Timeline<'_, '_>) {
        self.pending.clear();
        if on {
            self.next = context.now();
        }
    }

    fn transmit(&mut self, now: VirtualNanos) -> Option<u16> {
        if self.pending.is_empty() && now >= self.next {
            let due = now.0 - (now.0 - self.next.0) % PERIOD.0;
            self.pending.extend(self.packet());
            self.next = VirtualNanos(due + PERIOD.0);
        }
        self.pending.pop_front().map(u16::from)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::device::{DeviceContext, Effects};
    use crate::snapshot;
    use crate::soc::Peripheral;

    const PERIPHERAL: Peripheral = Peripheral {
        name: "test",
        base: 0,
        size: 0,
        interrupts: &[],
        registers: &[],
    };

    #[test]
    fn power_on_starts_a_whole_packet() {
        let mut instrument = Magnetometer::new();
        let mut effects = Effects::default();
        let mut switch = |instrument: &mut Magnetometer, now: u64, on: bool| {
            let mut context = DeviceContext::new(VirtualNanos(now), 0, PERIPHERAL, &mut effects);
            instrument.power_changed(on, &mut Timeline::new(&mut context));
        };
        for _ in 0..PACKET / 2 {
            instrument.transmit(VirtualNanos(0));
        }
        switch(&mut instrument, 10, false);
        switch(&mut instrument, 2_500_000_000, true);
        let packet: Vec<u16> =
            std::iter::from_fn(|| instrument.transmit(VirtualNanos(2_500_000_000))).collect();
        let whole: Vec<u16> = instrument
            .packet()
            .iter()
            .map(|&byte| u16::from(byte))
            .collect();
        assert_eq!(packet, whole, "a whole packet from power on");
        assert_eq!(instrument.transmit(VirtualNanos(3_500_000_000 - 1)), None);
        assert_eq!(
            instrument.transmit(VirtualNanos(3_500_000_000)),
            Some(u16::from(DLE)),
            "and the next a second after it"
        );
    }

    #[test]
    fn a_snapshot_keeps_the_packet_in_flight() {
        let mut kept = Magnetometer::new();
        kept.set_field([1, -2, 3]);
        let half = PACKET / 2;
        for _ in 0..half {
            kept.transmit(VirtualNanos(0));
        }
        let bytes = snapshot::stored(&kept).expect("the instrument stores itself");
        let mut restored = Magnetometer::new();
        snapshot::load(&mut restored, snapshot::keep(bytes.clone())).expect("and reads back");
        assert_eq!(snapshot::stored(&restored).expect("stores again"), bytes);
        let rest = |magnetometer: &mut Magnetometer| -> Vec<u16> {
            std::iter::from_fn(|| magnetometer.transmit(VirtualNanos(0))).collect()
        };
        let expected: Vec<u16> = kept.packet()[half..]
            .iter()
            .map(|&byte| u16::from(byte))
            .collect();
        assert_eq!(rest(&mut kept), expected);
        assert_eq!(rest(&mut restored), expected);
        assert_eq!(
            restored.transmit(VirtualNanos(PERIOD.0 - 1)),
            None,
            "and the next is due a second after the first"
        );
        assert_eq!(restored.transmit(PERIOD), Some(u16::from(DLE)));
    }
}
