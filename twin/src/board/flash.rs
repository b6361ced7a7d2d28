//! The flash interface, watched: which operation is under way, and which words are poisoned.
//!
//! The emulator's model does the work; an operation of it takes effect as a whole at its end. A supply
//! that fails in between, or a reset, leaves something else: a word of which some bits are programmed,
//! a sector of which some cells are erased. [`FlashWatch`] knows what was under way and how far it was,
//! so that a cut can leave that behind ([`torn_word`], [`torn_sector`]).
//!
//! A torn word also has check bits that do not fit: it is *poisoned*, as is one programmed twice
//! ([`super::check_bits`]). A core's load of it is a bus fault; [`super::flash_bus`] asks here. Only an
//! erase of its sector that comes to its end heals it. A bank that programs or erases stalls whoever
//! loads from it (RM0433 Rev 9, 4.3.11).

use std::sync::atomic::{AtomicBool, AtomicU8, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use rigless::device::{Device, DeviceContext, RegisterFile};
use rigless::snapshot::{self, Reader, Store, Writer};
use rigless::soc::Width;
use rigless::soc::stm32h743::generated::flash::{Register, cr1, cr2, sr1, sr2};
use rigless::soc::stm32h743::peripherals::flash::{Flash, OptionBytes};
use rigless::time::{EventId, VirtualNanos};

use super::check_bits::{CheckBits, Met};

/// Flash bank 1: boot loader and image (`memory.x`).
pub const CODE_FLASH: u64 = 0x0800_0000;
/// Flash bank 2: records and settings (`memory.x`).
pub const RECORD_FLASH: u64 = 0x0810_0000;
/// First address behind the flash.
const FLASH_END: u64 = 0x0820_0000;
/// Bytes of a sector: what an erase clears.
pub const SECTOR_BYTES: u64 = 128 << 10;
/// Sectors of bank 2.
pub const SECTORS: usize = 8;
/// Bytes of a flash word: what one programming operation writes.
pub const WORD_BYTES: usize = 32;
/// Banks of the part.
const BANKS: usize = 2;

/// Typical times by `PSIZE` (DS12110 Rev 11, table 140).
const PROGRAM_NS: [u64; 4] = [290_000, 180_000, 130_000, 100_000];
const ERASE_NS: [u64; 4] = [2_000_000_000, 1_800_000_000, 1_100_000_000, 1_000_000_000];

/// Option bytes of a board that was set up: as the factory leaves them, with brown-out level 3 in bits 2
/// and 3 of `FLASH_OPTSR_CUR` (RM0433 Rev 9, 4.9.8; docs/hardware.md).
pub(super) const SET_UP: OptionBytes = OptionBytes {
    optsr: OptionBytes::FACTORY.optsr | 3 << 2,
    ..OptionBytes::FACTORY
};

/// Bank of an address of the flash, from 0.
pub(super) fn bank_of(address: u64) -> Option<usize> {
    let inside = (CODE_FLASH..FLASH_END).contains(&address);
    inside.then_some(usize::from(address >= RECORD_FLASH))
}

/// Addresses of a bank.
pub(super) fn bank_range(bank: usize) -> std::ops::Range<u64> {
    [CODE_FLASH..RECORD_FLASH, RECORD_FLASH..FLASH_END][bank].clone()
}

/// The number of a word in its bank.
pub(super) fn nth_word(bank: usize, address: u64) -> u64 {
    (address - bank_range(bank).start) / WORD_BYTES as u64
}

/// The flash word around an address.
pub(super) fn word_of(address: u64) -> u64 {
    address & !(WORD_BYTES as u64 - 1)
}

/// An operation on the flash.
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

impl Operation {
    /// Where it works.
    #[must_use]
    pub fn address(self) -> u64 {
        match self {
            Self::Program { address, .. } | Self::Erase { address } => address,
        }
    }
}

/// An operation that was cut.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct CutOff {
    /// Operation that was under way.
    pub operation: Operation,
    /// How far it was, from 0 to 1.
    pub progress: f64,
    /// When it was cut.
    pub at: VirtualNanos,
}

/// An operation under way.
#[derive(Debug, Clone, Copy, serde::Serialize, serde::Deserialize)]
struct Running {
    operation: Operation,
    started: VirtualNanos,
    lasts_ns: u64,
    /// It programs a word that was not erased.
    overwrites: bool,
}

impl Running {
    fn progress(&self, now: VirtualNanos) -> f64 {
        let since = now.0.saturating_sub(self.started.0);
        since as f64 / self.lasts_ns as f64
    }
}

/// Which operation to stop in.
#[derive(Debug, Clone, Copy)]
enum Trap {
    Ordinal(u64),
    Erase,
    OrdinalOrErase(u64),
    /// By its number among those of the bank of the code.
    Code(u64),
}

impl Trap {
    fn is(self, operation: Operation, ordinal: u64) -> bool {
        let of_code = operation.address() < RECORD_FLASH;
        match self {
            Self::Code(wanted) => of_code && ordinal == wanted,
            _ if of_code => false,
            Self::Ordinal(wanted) => ordinal == wanted,
            Self::Erase => matches!(operation, Operation::Erase { .. }),
            Self::OrdinalOrErase(wanted) => {
                Self::Ordinal(wanted).is(operation, ordinal) || Self::Erase.is(operation, ordinal)
            }
        }
    }
}

#[derive(Debug, Default)]
struct State {
    running: [Option<Running>; BANKS],
    /// Operations begun, of each bank.
    begun: [u64; BANKS],
    erases: [u64; SECTORS],
    check_bits: CheckBits,
    poisoned_loads: u64,
    /// Words and sectors that were torn.
    torn: [u64; 2],
    /// The bank whose operation the core waits for.
    awaited: Option<usize>,
    /// The operation to stop in, and how far into it, from 0 to 1.
    trap: Option<(Trap, f64)>,
    news: News,
}

// A trap is the driver's of a run, who sets it again; news is taken at the stop it is of.
rigless::store!(State {
    values: [
        running,
        begun,
        erases,
        check_bits,
        poisoned_loads,
        torn,
        awaited
    ],
    parts: [],
    built: [trap, news],
});

/// Things the driver of a run must see to, since the models have no hand on the memory.
#[derive(Debug, Clone, Default)]
pub(crate) struct News {
    /// The instant the trap asks for a stop at.
    pub(crate) sprung: Option<VirtualNanos>,
    /// A word whose programming has begun: was it erased?
    pub(crate) begun: Option<u64>,
    /// Operations that were cut: what have they left?
    pub(crate) cut: Vec<CutOff>,
}

/// A shared view of the flash's operations.
#[derive(Debug, Clone, Default)]
pub struct FlashWatch {
    state: Arc<Mutex<State>>,
    /// There is news for the driver.
    has_news: Arc<AtomicBool>,
    /// Other words are poisoned, or other banks busy, than the core's bus was told.
    has_changed: Arc<AtomicBool>,
    /// A bit for each bank at work, and [`AWAITED`]: what the core asks at every stretch.
    at_work: Arc<AtomicU8>,
}

/// Bit of [`FlashWatch`]: the core waits for a bank.
const AWAITED: u8 = 1 << BANKS;

impl Store for FlashWatch {
    fn store(&self, to: &mut Writer) -> Result<(), snapshot::Error> {
        self.lock().store(to)
    }

    fn load(&mut self, from: &mut Reader) -> Result<(), snapshot::Error> {
        let mut state = self.lock();
        state.load(from)?;
        self.publish(&state);
        Ok(())
    }
}

impl FlashWatch {
    /// Operations started on the record flash since the first power-on.
    #[must_use]
    pub fn operations(&self) -> u64 {
        self.lock().begun[1]
    }

    /// Operations started on the flash the code is in since the first power-on.
    #[must_use]
    pub fn code_operations(&self) -> u64 {
        self.lock().begun[0]
    }

    /// Erases started of each sector of the record flash.
    #[must_use]
    pub fn erases(&self) -> [u64; SECTORS] {
        self.lock().erases
    }

    /// Flash words that are poisoned.
    #[must_use]
    pub fn poisoned_words(&self) -> usize {
        self.lock().check_bits.poisoned()
    }

    /// Loads of the core that met a poisoned word since the first power-on.
    #[must_use]
    pub fn poisoned_loads(&self) -> u64 {
        self.lock().poisoned_loads
    }

    /// Words and sectors torn since the first power-on, by cuts of the supply and by resets.
    #[must_use]
    pub fn torn(&self) -> [u64; 2] {
        self.lock().torn
    }

    /// The operation under way on the record flash at `now` and how far it is, from 0 to 1.
    #[must_use]
    pub fn under_way(&self, now: VirtualNanos) -> Option<(Operation, f64)> {
        let running = self.lock().running[1]?;
        Some((running.operation, running.progress(now)))
    }

    /// The operation under way on either bank; no two of them are worked on at once here.
    #[must_use]
    pub(super) fn any_under_way(&self, now: VirtualNanos) -> Option<(Operation, f64)> {
        let running = self.lock().running;
        let running = running.into_iter().flatten().next()?;
        Some((running.operation, running.progress(now)))
    }

    /// Asks for a stop at `fraction` (0 to 1) of operation number `ordinal`, counted from 1.
    pub fn set_trap(&self, ordinal: u64, fraction: f64) {
        self.lock().trap = Some((Trap::Ordinal(ordinal), fraction));
    }

    /// Asks for a stop at `fraction` (0 to 1) of operation number `ordinal` on the flash the code is in.
    pub fn set_code_trap(&self, ordinal: u64, fraction: f64) {
        self.lock().trap = Some((Trap::Code(ordinal), fraction));
    }

    /// Sets the trap for the next erase.
    pub fn set_erase_trap(&self, fraction: f64) {
        self.lock().trap = Some((Trap::Erase, fraction));
    }

    /// Sets the trap for operation number `ordinal`, or for an erase that comes before it.
    pub fn set_trap_or_erase(&self, ordinal: u64, fraction: f64) {
        self.lock().trap = Some((Trap::OrdinalOrErase(ordinal), fraction));
    }

    /// The erase under way on the record flash: when it began, in virtual time, and how long it takes.
    #[must_use]
    pub fn erase_under_way(&self) -> Option<(Duration, Duration)> {
        let running = self.lock().running[1]?;
        let is_erase = matches!(running.operation, Operation::Erase { .. });
        let [begun, lasts] = [running.started.0, running.lasts_ns].map(Duration::from_nanos);
        is_erase.then_some((begun, lasts))
    }

    /// The check bits as they are.
    pub(crate) fn check_bits(&self) -> CheckBits {
        self.lock().check_bits.clone()
    }

    /// The check bits become those of another flash.
    pub(crate) fn set_check_bits(&self, check_bits: CheckBits) {
        self.lock().check_bits = check_bits;
        self.has_changed.store(true, Ordering::Relaxed);
    }

    /// Check bits of the words in a range no longer fit.
    pub(crate) fn poison(&self, words: impl IntoIterator<Item = u64>) {
        self.lock().check_bits.poison(words);
        self.has_changed.store(true, Ordering::Relaxed);
    }

    /// One bit of the word around `address` no longer fits.
    pub(super) fn weaken(&self, address: u64) {
        self.lock().check_bits.weaken(word_of(address));
        self.has_changed.store(true, Ordering::Relaxed);
    }

    /// The word whose programming has begun was not erased.
    pub(crate) fn note_overwritten(&self, address: u64) {
        let mut state = self.lock();
        let running = state.running.iter_mut().flatten();
        running
            .filter(|running| running.operation.address() == address)
            .for_each(|running| running.overwrites = true);
    }

    /// News for the driver of the run; asked at every stop and access.
    pub(crate) fn take_news(&self) -> Option<News> {
        let has = self.has_news.load(Ordering::Relaxed) && {
            self.has_news.swap(false, Ordering::Relaxed)
        };
        has.then(|| std::mem::take(&mut self.lock().news))
    }

    /// Cuts whatever is under way: the supply has failed, or the part was reset (RM0433 Rev 9, 4.3.14).
    pub(super) fn cut(&self, at: VirtualNanos) {
        let mut state = self.lock();
        let running = std::mem::take(&mut state.running).into_iter().flatten();
        let cut: Vec<CutOff> = running
            .map(|running| CutOff {
                operation: running.operation,
                progress: running.progress(at),
                at,
            })
            .collect();
        for cut in &cut {
            state.torn[usize::from(matches!(cut.operation, Operation::Erase { .. }))] += 1;
        }
        state.news.cut.extend(cut);
        state.trap = None;
        state.awaited = None;
        self.has_news.store(true, Ordering::Relaxed);
        self.publish(&state);
    }

    /// The words whose check bits do not fit, when they or the banks at work are others than at the last call.
    pub(super) fn take_change(&self) -> Option<Vec<u64>> {
        let changed = self.has_changed.load(Ordering::Relaxed) && {
            self.has_changed.swap(false, Ordering::Relaxed)
        };
        changed.then(|| self.lock().check_bits.unfit())
    }

    /// Whether a bank programs or erases.
    pub(super) fn is_busy(&self, bank: usize) -> bool {
        self.at_work.load(Ordering::Relaxed) & 1 << bank != 0
    }

    /// The core has loaded from a bank at work, and waits for it from now on.
    pub(super) fn await_bank(&self, bank: usize) {
        let mut state = self.lock();
        state.awaited = Some(bank);
        self.publish(&state);
    }

    /// Whether the core waits for a bank.
    pub(super) fn is_awaited(&self) -> bool {
        self.at_work.load(Ordering::Relaxed) & AWAITED != 0
    }

    /// Notes a load of the core: the word and what it comes to, where its check bits do not fit.
    pub(super) fn note_load(&self, address: u64) -> Option<(u64, Met)> {
        let mut state = self.lock();
        let word = word_of(address);
        let met = state.check_bits.met(word)?;
        state.poisoned_loads += u64::from(met == Met::Poisoned);
        Some((word, met))
    }

    /// Notes a read of a DMA controller, wherever it went.
    pub(super) fn note_dma_read(&self, address: u64) {
        if bank_of(address).is_some() {
            self.lock().check_bits.read_by_dma(word_of(address));
        }
    }

    /// Reads of misfitting words by DMA controllers since the last call.
    pub(super) fn take_met_by_dma(&self) -> Vec<(u64, Met)> {
        self.lock().check_bits.take_met_by_dma()
    }

    fn begin(&self, operation: Operation, started: VirtualNanos, lasts_ns: u64) {
        let address = operation.address();
        let Some(bank) = bank_of(address) else {
            return;
        };
        let mut state = self.lock();
        state.running[bank] = Some(Running {
            operation,
            started,
            lasts_ns,
            overwrites: false,
        });
        match operation {
            Operation::Program { .. } => state.news.begun = Some(address),
            Operation::Erase { .. } if address >= RECORD_FLASH => {
                state.erases[((address - RECORD_FLASH) / SECTOR_BYTES) as usize] += 1;
            }
            Operation::Erase { .. } => {}
        }
        state.begun[bank] += 1;
        let ordinal = state.begun[bank];
        state.spring(operation, ordinal, started, lasts_ns);
        self.has_news.store(true, Ordering::Relaxed);
        self.publish(&state);
    }

    /// The operation of a bank has come to its end.
    fn finish(&self, bank: usize) {
        let mut state = self.lock();
        let Some(running) = state.running[bank].take() else {
            return;
        };
        if state.awaited == Some(bank) {
            state.awaited = None;
        }
        match running.operation {
            Operation::Erase { address } => {
                let sector = address..address + SECTOR_BYTES;
                state.check_bits.heal(&sector);
            }
            Operation::Program { address, .. } if running.overwrites => {
                state.check_bits.poison([address]);
            }
            Operation::Program { .. } => {}
        }
        self.publish(&state);
    }

    /// Lets the core's bus know what is at work and that words may have changed.
    fn publish(&self, state: &State) {
        let banks = state.running.iter().enumerate();
        let busy = banks.map(|(bank, running)| u8::from(running.is_some()) << bank);
        let awaited = if state.awaited.is_some() { AWAITED } else { 0 };
        self.at_work
            .store(busy.sum::<u8>() | awaited, Ordering::Relaxed);
        self.has_changed.store(true, Ordering::Relaxed);
    }

    fn lock(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl State {
    /// Springs the trap if it is set for this operation.
    fn spring(&mut self, operation: Operation, ordinal: u64, started: VirtualNanos, lasts_ns: u64) {
        let is = |(trap, _): &(Trap, f64)| trap.is(operation, ordinal);
        if let Some((_, fraction)) = self.trap.filter(is) {
            self.trap = None;
            let into_ns = (fraction.clamp(0.0, 1.0) * lasts_ns as f64) as u64;
            self.news.sprung = Some(VirtualNanos(started.0 + into_ns));
        }
    }
}

/// Registers of a bank.
#[derive(Clone, Copy)]
struct Bank {
    status: Register,
    control: Register,
}

const BANK: [Bank; BANKS] = [
    Bank {
        status: Register::Sr1,
        control: Register::Cr1,
    },
    Bank {
        status: Register::Sr2,
        control: Register::Cr2,
    },
];

impl Bank {
    fn is_busy(self, registers: &RegisterFile) -> bool {
        let status = registers.get(self.status);
        match self.status {
            Register::Sr1 => sr1::QW1.is_set(status),
            _ => sr2::QW2.is_set(status),
        }
    }

    /// Place in the tables of times.
    fn parallelism(self, registers: &RegisterFile) -> usize {
        let control = registers.get(self.control);
        match self.control {
            Register::Cr1 => cr1::PSIZE1.get(control) as usize,
            _ => cr2::PSIZE2.get(control) as usize,
        }
    }
}

/// The sector whose erase a write of `value` to `register` starts.
fn sector_started(register: Register, value: u64) -> Option<u64> {
    let sector = match register {
        Register::Cr1 if cr1::START1.is_set(value) => cr1::SNB1.get(value),
        Register::Cr2 if cr2::START2.is_set(value) => SECTORS as u64 + cr2::SNB2.get(value),
        _ => return None,
    };
    Some(CODE_FLASH + sector * SECTOR_BYTES)
}

/// The emulator's flash interface, with a watch on both banks.
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
        for (nth, bank) in BANK.into_iter().enumerate() {
            let busy = bank.is_busy(registers);
            let known = self.watch.is_busy(nth);
            if known && !busy {
                self.watch.finish(nth);
            } else if let Some(operation) = begun
                && bank_of(operation.address()) == Some(nth)
                && busy
                && !known
            {
                let size = bank.parallelism(registers);
                let lasts_ns = match operation {
                    Operation::Program { .. } => PROGRAM_NS[size],
                    Operation::Erase { .. } => ERASE_NS[size],
                };
                self.watch.begin(operation, context.now(), lasts_ns);
                self.data = [0xFF; WORD_BYTES];
            }
        }
    }

    fn gather(&mut self, address: u64, width: Width, value: u64) {
        self.word = word_of(address);
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
        let met = sr2::DBECCERR2.mask() | sr2::SNECCERR2.mask();
        if register == Register::Ccr2 && registers.get(Register::Sr2) & met == 0 {
            registers.set(Register::EccFa2r, 0);
        }
        let begun = sector_started(register, value).map(|address| Operation::Erase { address });
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
        self.gather(address, width, value);
        let begun = Operation::Program {
            address: self.word,
            data: self.data,
        };
        self.look(Some(begun), registers, context);
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
