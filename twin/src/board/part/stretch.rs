//! A stretch of samples that nobody hears of.
//!
//! While the core sleeps, most samples lead to nothing but a level on the drive, a pair in memory, and
//! counters that go on. A stretch of them is made with every model taken once and the memory read and written in
//! one piece. It ends before a sample that raises a flag, and one sample before the
//! core may look: that one is made the long way and leaves in every register what belongs there.

use rigless::emulator::{AccessKind, Memory};
use rigless::mcu::Mcu;
use rigless::soc::{Layout, Width};
use rigless::time::VirtualNanos;

use super::Part;
use crate::board::adc::Stretch;
use crate::board::dma1::Ring;

/// Most samples of a stretch.
const MOST: usize = 64;
/// Bytes of a pair.
const PAIR_BYTES: usize = 4;

/// Rings that a stretch moves.
struct Rings {
    drive: Ring,
    pairs: Ring,
}

impl Part {
    /// Makes samples from `at` on, all of which have one behind them before `limit`; answers the
    /// instant of the first that is left.
    pub(super) fn stretch(
        &mut self,
        at: VirtualNanos,
        limit: VirtualNanos,
        memory: &mut dyn Memory,
    ) -> VirtualNanos {
        if self.tim6.update_after(1) >= limit || self.ports_used || self.tim3.has_changed() {
            return at;
        }
        let Some(rings) = self.rings() else { return at };
        let mut drive = [0; MOST * PAIR_BYTES];
        let most = rings.drive.items.min(rings.pairs.items).min(MOST as u64) as usize;
        let drive = &mut drive[..most * rings.drive.width.bytes() as usize];
        if most == 0 || memory.read_block(rings.drive.memory_at, drive).is_err() {
            return at;
        }
        self.make(&rings, drive, limit, memory)
    }

    /// The rings of drive and pairs, where both models do nothing at a trigger but move them, and no
    /// access would be refused.
    fn rings(&self) -> Option<Rings> {
        if !self.dma1.is_at_rest() {
            return None;
        }
        let bus = self.bus();
        let slot = |slot: usize| &bus.slots()[slot];
        let at = |nth, offset: u32| slot(nth).peripheral().base + u64::from(offset);
        let (holding, line) = self.dac.streams(slot(self.slots.dac).registers())?;
        let holding = at(self.slots.dac, holding.spec().offset);
        let drive = self.dma1.ring(line, holding)?;
        let (data, line) = Stretch::SOURCE;
        let data = at(self.slots.common, data.spec().offset);
        let pairs = self.dma1.ring(line, data)?;
        let narrow = !drive.to_memory && matches!(drive.width, Width::W16 | Width::W32);
        let words = pairs.to_memory && pairs.width == Width::W32;
        let answered = bus.answers(holding, drive.width, AccessKind::Write)
            && bus.answers(data, pairs.width, AccessKind::Read);
        let apart = self.is_apart(&drive, &pairs);
        (narrow && words && answered && apart).then_some(Rings { drive, pairs })
    }

    /// Both rings lie in memory the core may write, one beside the other.
    fn is_apart(&self, one: &Ring, other: &Ring) -> bool {
        let end = |ring: &Ring| {
            let items = ring.items.min(MOST as u64);
            ring.memory_at + items * u64::from(ring.width.bytes())
        };
        let in_ram = |ring: &Ring| {
            let mut regions = self.bus().memory().iter();
            regions.any(|region| {
                region.kind.is_writable()
                    && region.contains(ring.memory_at)
                    && region.contains(end(ring))
            })
        };
        let apart = end(one) <= other.memory_at || end(other) <= one.memory_at;
        apart && in_ram(one) && in_ram(other)
    }

    /// Makes as many samples as `drive` has items for, and as are due with another behind them before `limit`.
    fn make(
        &mut self,
        rings: &Rings,
        drive: &[u8],
        limit: VirtualNanos,
        memory: &mut dyn Memory,
    ) -> VirtualNanos {
        let bus = self.base.bus_mut();
        let (mut at, mut next) = (self.tim6.update_after(0), self.tim6.update_after(1));
        let stage = self.dac.stage(bus.slots()[self.slots.dac].registers());
        let mut pins = self.pins.analog.lock();
        let registers = bus.slots()[self.slots.common].registers();
        let stretch = self.common.stretch(registers, &pins, at);
        let Some(mut converters) = stretch.filter(|made| at.0 + made.lasts_ns < next.0) else {
            return at;
        };
        if !stage.is_set(&pins) {
            return at;
        }
        let mut flaws = self.pins.flaws.lock();
        let mut pairs = [[0; PAIR_BYTES]; MOST];
        let mut item = rings.drive.item;
        let mut made = 0;
        for fetched in drive.chunks_exact(rings.drive.width.bytes() as usize) {
            if next >= limit {
                break;
            }
            stage.put(self.dac.holding(), &mut flaws, &mut pins, at);
            self.dac.take(item);
            item = value_of(fetched);
            pairs[made] = converters.word(&mut pins, &flaws, at).to_le_bytes();
            made += 1;
            at = next;
            next = self.tim6.update_after(made as u64 + 1);
        }
        drop((pins, flaws, converters));
        let registers = bus.slot_mut(self.slots.tim6).registers_mut();
        self.tim6.pass_updates(made as u64, registers);
        self.dma1.went_round(&rings.drive, made as u64, item);
        self.dma1.went_round(&rings.pairs, made as u64, 0);
        // Refused only where there is no such memory, and there is.
        memory
            .write_block(rings.pairs.memory_at, pairs[..made].as_flattened())
            .ok();
        at
    }
}

/// An item as it lies in memory.
fn value_of(bytes: &[u8]) -> u64 {
    bytes
        .iter()
        .rev()
        .fold(0, |value, byte| value << 8 | u64::from(*byte))
}
