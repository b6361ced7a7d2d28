//! The flash interface, watched: which operation on the record flash (bank 2) is under way.
//!
//! The emulator's model does the work; an operation of it takes effect as a whole at its end. A supply
//! that fails in between leaves something else: a word of which some bits are programmed, a sector of
//! which some cells are erased. [`FlashWatch`] knows what was under way and how far it was, so that a
//! power cut can leave that behind ([`torn_word`], [`torn_sector`]).
//!
//! A torn word of this part also carries wrong check bits, and a read of it a bus error (RM0433
//! Rev 9, section 4.7.8); the emulated core reads it without.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use rigless::device::{Device, DeviceContext, RegisterFile};
use rigless::snapshot::{self, Reader, Store, Writer};
use rigless::soc::Width;
use rigless::soc::stm32h743::generated::flash::{Register, cr2, sr2};
use rigless::soc::stm32h743::peripherals::flash::Flash;
use rigless::time::{EventId, VirtualNanos};

/// Flash bank 2: records and settings (`memory.x`).
pub const RECORD_FLASH: u64 = 0x0810_0000;
/// Bytes of a sector: what an erase clears.
pub const SECTOR_BYTES: u64 = 128 << 10;
/// Sectors of bank 2.
pub const SECTORS: usize = 8;
/// Bytes of a flash word: what one programming operation writes.
pub const WORD_BYTES: usize = 32;

/// Typical times by `PSIZE` (DS12110 Rev 11, table 140).
const PROGRAM_NS: [u64; 4] = [290_000, 180_000, 130_000, 100_000];
const ERASE_NS: [u64; 4] = [2_000_000_000, 1_800_000_000, 1_100_000_000, 1_000_000_000];

/// An operation on the record flash.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub enum Operation {
    /// One flash word is being programmed.
    Program {
        /// Its address.
        address: u64,
        /// Content to be there.
        data: [u8; WORD_BYTES],
    },
    /// One sector is being erased.
    Erase {
        /// Address of its first byte.
        address: u64,
    },
}

/// An operation under way.
#[derive(Debug, Clone, Copy, serde::Serialize, serde::Deserialize)]
struct Running {
    operation: Operation,
    started: VirtualNanos,
    lasts_ns: u64,
}

/// Which operation to stop in.
#[derive(Debug, Clone, Copy)]
enum Trap {
    Ordinal(u64),
    Erase,
}

impl Trap {
    fn is(self, operation: Operation, ordinal: u64) -> bool {
        match self {
            Self::Ordinal(wanted) => ordinal == wanted,
            Self::Erase => matches!(operation, Operation::Erase { .. }),
        }
    }
}

#[derive(Debug, Default)]
struct State {
    running: Option<Running>,
    started: u64,
    erases: [u64; SECTORS],
    /// The operation to stop in, and how far into it, from 0 to 1.
    trap: Option<(Trap, f64)>,
    sprung: Option<VirtualNanos>,
}

// A trap is the driver's of a run, who sets it again.
rigless::store!(State {
    values: [running, started, erases],
    parts: [],
    built: [trap, sprung],
});

/// A shared view of the record flash's operations.
#[derive(Debug, Clone, Default)]
pub struct FlashWatch(Arc<Mutex<State>>);

impl Store for FlashWatch {
    fn store(&self, to: &mut Writer) -> Result<(), snapshot::Error> {
        self.lock().store(to)
    }

    fn load(&mut self, from: &mut Reader) -> Result<(), snapshot::Error> {
        self.lock().load(from)
    }
}

impl FlashWatch {
    /// Operations started on the record flash since the first power-on.
    #[must_use]
    pub fn operations(&self) -> u64 {
        self.lock().started
    }

    /// Erases started of each sector of the record flash.
    #[must_use]
    pub fn erases(&self) -> [u64; SECTORS] {
        self.lock().erases
    }

    /// The operation under way at `now` and how far it is, from 0 to 1.
    #[must_use]
    pub fn under_way(&self, now: VirtualNanos) -> Option<(Operation, f64)> {
        let running = self.lock().running?;
        let since = now.0.saturating_sub(running.started.0);
        Some((running.operation, since as f64 / running.lasts_ns as f64))
    }

    /// Asks for a stop at `fraction` (0 to 1) of operation number `ordinal`, counted from 1.
    pub fn set_trap(&self, ordinal: u64, fraction: f64) {
        self.lock().trap = Some((Trap::Ordinal(ordinal), fraction));
    }

    /// Sets the trap for the next erase.
    pub fn set_erase_trap(&self, fraction: f64) {
        self.lock().trap = Some((Trap::Erase, fraction));
    }

    /// The instant the trap asks for a stop at, once its operation has started.
    pub(crate) fn take_sprung(&self) -> Option<VirtualNanos> {
        self.lock().sprung.take()
    }

    /// Forgets what was under way: the supply has failed.
    pub(crate) fn abandon(&self) {
        let mut state = self.lock();
        state.running = None;
        state.trap = None;
    }

    fn begin(&self, operation: Operation, started: VirtualNanos, lasts_ns: u64) {
        let mut state = self.lock();
        state.started += 1;
        if let Operation::Erase { address } = operation {
            state.erases[((address - RECORD_FLASH) / SECTOR_BYTES) as usize] += 1;
        }
        state.running = Some(Running {
            operation,
            started,
            lasts_ns,
        });
        if let Some((_, fraction)) = state
            .trap
            .filter(|(trap, _)| trap.is(operation, state.started))
        {
            state.trap = None;
            let into_ns = (fraction.clamp(0.0, 1.0) * lasts_ns as f64) as u64;
            state.sprung = Some(VirtualNanos(started.0 + into_ns));
        }
    }

    fn lock(&self) -> MutexGuard<'_, State> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// The emulator's flash interface, with a watch on bank 2.
#[derive(Debug)]
pub(super) struct WatchedFlash {
    pub(super) inner: Flash,
    watch: FlashWatch,
    word: u64,
    data: [u8; WORD_BYTES],
}

rigless::store!(WatchedFlash {
    values: [inner, word, data],
    parts: [watch],
    built: [],
});

impl WatchedFlash {
    pub(super) fn new(watch: FlashWatch) -> Self {
        Self {
            inner: Flash::new(),
            watch,
            word: 0,
            data: [0xFF; WORD_BYTES],
        }
    }

    /// Compares what the interface says with what was known: an operation began, or ended.
    fn look(
        &mut self,
        begun: Option<Operation>,
        registers: &RegisterFile,
        context: &DeviceContext<'_>,
    ) {
        let busy = sr2::QW2.is_set(registers.get(Register::Sr2));
        let known = self.watch.lock().running.is_some();
        if known && !busy {
            self.watch.lock().running = None;
        } else if let Some(operation) = begun.filter(|_| busy && !known) {
            let size = cr2::PSIZE2.get(registers.get(Register::Cr2)) as usize;
            let lasts_ns = match operation {
                Operation::Program { .. } => PROGRAM_NS[size],
                Operation::Erase { .. } => ERASE_NS[size],
            };
            self.watch.begin(operation, context.now(), lasts_ns);
            self.data = [0xFF; WORD_BYTES];
        }
    }

    fn gather(&mut self, address: u64, width: Width, value: u64) {
        self.word = address & !(WORD_BYTES as u64 - 1);
        let first = (address - self.word) as usize;
        let bytes = value.to_le_bytes();
        let places = self.data[first..].iter_mut();
        for (place, byte) in places.zip(&bytes[..width.bytes() as usize]) {
            *place = *byte;
        }
    }
}

impl Device for WatchedFlash {
    type Register = Register;

    fn write(
        &mut self,
        register: Register,
        value: u64,
        registers: &mut RegisterFile,
        context: &mut DeviceContext<'_>,
    ) {
        self.inner.write(register, value, registers, context);
        let begun = (register == Register::Cr2 && cr2::START2.is_set(value)).then(|| {
            let sector = cr2::SNB2.get(value);
            Operation::Erase {
                address: RECORD_FLASH + sector * SECTOR_BYTES,
            }
        });
        self.look(begun, registers, context);
    }

    fn write_region(
        &mut self,
        address: u64,
        width: Width,
        value: u64,
        registers: &mut RegisterFile,
        context: &mut DeviceContext<'_>,
    ) -> bool {
        let taken = self
            .inner
            .write_region(address, width, value, registers, context);
        if address >= RECORD_FLASH {
            self.gather(address, width, value);
            let begun = Operation::Program {
                address: self.word,
                data: self.data,
            };
            self.look(Some(begun), registers, context);
        }
        taken
    }

    fn on_event(
        &mut self,
        event: EventId,
        registers: &mut RegisterFile,
        context: &mut DeviceContext<'_>,
    ) {
        self.inner.on_event(event, registers, context);
        self.look(None, registers, context);
    }

    fn on_access(
        &mut self,
        token: u64,
        value: u64,
        registers: &mut RegisterFile,
        context: &mut DeviceContext<'_>,
    ) {
        self.inner.on_access(token, value, registers, context);
        self.look(None, registers, context);
    }

    fn on_refused(
        &mut self,
        token: u64,
        registers: &mut RegisterFile,
        context: &mut DeviceContext<'_>,
    ) {
        self.inner.on_refused(token, registers, context);
        self.look(None, registers, context);
    }

    fn reset(&mut self) {
        self.inner.reset();
        self.watch.abandon();
    }
}

/// A word whose programming from `old` to `new` was cut at `progress` (0 to 1): each bit that had to
/// be cleared is cleared with that probability. `draw` gives uniform 64-bit numbers.
#[must_use]
pub fn torn_word(
    old: [u8; WORD_BYTES],
    new: [u8; WORD_BYTES],
    progress: f64,
    mut draw: impl FnMut() -> u64,
) -> [u8; WORD_BYTES] {
    let mut torn = old;
    for (place, new) in torn.iter_mut().zip(new) {
        *place &= new | !some_bits(progress, &mut draw);
    }
    torn
}

/// A sector whose erase was cut at `progress` (0 to 1): each bit that was cleared is set again with
/// that probability.
pub fn torn_sector(sector: &mut [u8], progress: f64, mut draw: impl FnMut() -> u64) {
    for place in sector {
        *place |= some_bits(progress, &mut draw);
    }
}

/// Eight bits, each set with probability `progress`.
fn some_bits(progress: f64, draw: &mut impl FnMut() -> u64) -> u8 {
    // Eight bits of resolution: 0 never sets one, 1 sets all.
    let threshold = (progress.clamp(0.0, 1.0) * 256.0) as u64;
    let drawn = draw().to_le_bytes();
    (0..8).fold(0, |bits, place| {
        bits | u8::from(u64::from(drawn[place]) < threshold) << place
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn counter() -> impl FnMut() -> u64 {
        let mut state = 0_u64;
        move || {
            // Weyl sequence of the golden ratio: equidistributed bytes are all that is needed.
            state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
            (state ^ (state >> 31)).wrapping_mul(0x94D0_49BB_1331_11EB)
        }
    }

    #[test]
    fn a_word_cut_at_once_or_at_the_end_is_the_old_or_the_new() {
        let (old, new) = ([0xFF; WORD_BYTES], [0x5A; WORD_BYTES]);
        assert_eq!(torn_word(old, new, 0.0, counter()), old);
        assert_eq!(torn_word(old, new, 1.0, counter()), new);
    }

    #[test]
    fn a_word_cut_half_way_is_neither_and_sets_no_bit() {
        let (old, new) = ([0xFF; WORD_BYTES], [0x00; WORD_BYTES]);
        let torn = torn_word(old, new, 0.5, counter());
        let set: u32 = torn.iter().map(|byte| byte.count_ones()).sum();
        // Binomial with 256 draws at one half: 128 +- 8; five standard deviations.
        assert!((88..=168).contains(&set), "{set} bits left");
        let cleared = [0b1010_1010; WORD_BYTES];
        for byte in torn_word(cleared, new, 0.5, counter()) {
            assert_eq!(byte & !0b1010_1010, 0, "programming never sets a bit");
        }
    }

    #[test]
    fn a_sector_cut_half_way_sets_some_bits_and_clears_none() {
        let mut sector = vec![0x0F; 4096];
        torn_sector(&mut sector, 0.25, counter());
        assert!(sector.iter().all(|byte| byte & 0x0F == 0x0F));
        let set: u32 = sector.iter().map(|byte| (byte >> 4).count_ones()).sum();
        // Binomial with 16384 draws at one quarter: 4096 +- 55; five standard deviations.
        assert!((3819..=4373).contains(&set), "{set} bits set");
    }
}
