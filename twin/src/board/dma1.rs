//! DMA1: eight streams in direct mode, the way this board moves samples and bytes.
//!
//! RM0433 Rev 9, chapter 15. A stream moves one item for each request of its line: to memory, or from
//! memory with the next item fetched ahead (section 15.3.14). Circular mode, both pointers' steps, half
//! and complete flags, transfer errors, interrupts, write protection while enabled (section 15.5.5) and
//! a counter that follows the peripheral's side are here. Left out, and told to the run: the FIFO,
//! memory to memory, double buffer, and a peripheral as flow controller.
//!
//! The emulator's controller can do all of it, but hears requests over a bus on which every
//! peripheral listens: with 100 000 of them a second, half of a run's time. Here a line that stands is
//! seen directly ([`RequestLines`]). Test `both_controllers_move_the_same` compares the two.

use rigless::device::{Device, DeviceContext, Level, RegisterFile, RequestChange};
use rigless::soc::stm32h743::generated::dma1::{Register, s0cr, s0fcr, s0ndtr};
use rigless::soc::stm32h743::peripherals::dma::Span;
use rigless::soc::{Layout, Width};
use serde::{Deserialize, Serialize};

use super::flash::FlashWatch;
use super::request_lines::RequestLines;

/// The instance's name.
pub(super) const NAME: &str = "DMA1";
/// Streams of the controller.
pub(super) const STREAMS: usize = 8;
/// Registers of all streams, and of each.
const COMMON_ROWS: usize = 4;
const STREAM_ROWS: usize = 6;
const CONTROL: usize = 0;
const COUNT: usize = 1;
const PERIPHERAL: usize = 2;
const MEMORY: usize = 3;
const FIFO: usize = 5;
/// Where a stream's flags lie in its status register, and their order there (section 15.5.1).
const FLAGS_AT: [u32; 4] = [0, 6, 16, 22];
const TRANSFER_ERROR: u64 = 1 << 3;
const HALF: u64 = 1 << 4;
const COMPLETE: u64 = 1 << 5;
/// `DMEIE`, `TEIE`, `HTIE` and `TCIE`, one place below the flags they let through.
const ENABLES: u64 = 0b1_1110;
/// `FS` of an empty FIFO.
const EMPTY: u64 = 0b100;
/// Memories the controller does not reach: ITCM and DTCM (section 2.1.6).
const UNREACHABLE: [Span; 2] = [
    Span {
        base: 0,
        bytes: 64 << 10,
    },
    Span {
        base: 0x2000_0000,
        bytes: 128 << 10,
    },
];

/// An access under way for a stream, as the token of its answer tells.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
enum Access {
    Fetch,
    Store,
}

/// A transfer under way, configured when its stream was enabled.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
struct Transfer {
    to_memory: bool,
    circular: bool,
    width: Width,
    peripheral_step: u64,
    memory_step: u64,
    /// Items of a round.
    items: u64,
    to_fetch: u64,
    to_store: u64,
    peripheral_at: u64,
    memory_at: u64,
    /// Fetched and not yet stored.
    item: Option<u64>,
    under_way: Option<Access>,
}

impl Transfer {
    /// Next step, `None` where it waits for its line.
    fn next(&self, requested: bool) -> Option<Access> {
        if self.under_way.is_some() {
            None
        } else if self.item.is_some() {
            let may_store = self.to_memory || requested;
            (self.to_store > 0 && may_store).then_some(Access::Store)
        } else {
            let may_fetch = !self.to_memory || requested;
            (self.to_fetch > 0 && may_fetch).then_some(Access::Fetch)
        }
    }

    fn address(&self, access: Access) -> u64 {
        match (access == Access::Store) == self.to_memory {
            true => self.memory_at,
            false => self.peripheral_at,
        }
    }

    fn step(&mut self, access: Access) {
        match (access == Access::Store) == self.to_memory {
            true => self.memory_at += self.memory_step,
            false => self.peripheral_at += self.peripheral_step,
        }
    }

    /// Items the peripheral's side has still to move.
    fn left(&self) -> u64 {
        match self.to_memory {
            true => self.to_fetch,
            false => self.to_store,
        }
    }

    /// Items that can be stored before one raises a flag.
    fn unflagged(&self) -> u64 {
        let stored = self.items - self.to_store;
        let half = self.items.div_ceil(2);
        let flagged = if stored < half { half } else { self.items };
        flagged - stored - 1
    }

    fn reaches(&self, access: Access) -> bool {
        let (address, bytes) = (self.address(access), u64::from(self.width.bytes()));
        !UNREACHABLE.iter().any(|span| span.overlaps(address, bytes))
    }
}

/// An access a stream has to make now: a store of `written`, or a fetch.
#[derive(Debug, Clone, Copy)]
pub(super) struct Due {
    access: Access,
    pub(super) address: u64,
    pub(super) width: Width,
    pub(super) written: Option<u64>,
}

/// A stream that moves items between one register and a memory.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ring {
    nth: usize,
    pub(super) to_memory: bool,
    pub(super) width: Width,
    /// Where in memory the next item goes to or comes from.
    pub(super) memory_at: u64,
    /// How many come before one that raises a flag.
    pub(super) items: u64,
    /// The one fetched ahead, on the way from memory.
    pub(super) item: u64,
}

/// One stream beside its registers.
#[derive(Debug, Clone, Copy, Default, Serialize, Deserialize)]
struct Stream {
    transfer: Option<Transfer>,
    /// Value last written to the counter: every enable begins with it (section 15.5.6).
    programmed: u64,
    /// Its registers as they stand, for what may not be written while it runs.
    kept: [u64; STREAM_ROWS],
    interrupt: bool,
}

/// The model's state beside the registers.
#[derive(Debug)]
pub(super) struct Dma1 {
    lines: RequestLines,
    flash: FlashWatch,
    streams: [Stream; STREAMS],
}

rigless::store!(Dma1 {
    values: [streams],
    parts: [],
    built: [lines, flash],
});

impl Dma1 {
    pub(super) fn new(lines: RequestLines, flash: FlashWatch) -> Self {
        let mut streams = [Stream::default(); STREAMS];
        for (nth, stream) in streams.iter_mut().enumerate() {
            stream.kept = std::array::from_fn(|row| register(nth, row).spec().reset);
        }
        Self {
            lines,
            flash,
            streams,
        }
    }

    /// Serves every stream whose line stands.
    pub(super) fn serve(&mut self, registers: &mut RegisterFile, context: &mut DeviceContext<'_>) {
        for nth in 0..STREAMS {
            if self.stands(nth) {
                self.advance(nth, registers, context);
            }
        }
    }

    /// Whether a stream has a transfer under way, and its line stands.
    pub(super) fn stands(&self, nth: usize) -> bool {
        self.streams[nth].transfer.is_some() && self.lines.stands(nth)
    }

    /// The access a stream has to make now, for a caller that makes it at once.
    pub(super) fn due(&self, nth: usize) -> Option<Due> {
        let transfer = self.streams[nth].transfer.as_ref()?;
        let access = transfer.next(self.lines.stands(nth))?;
        transfer.reaches(access).then(|| Due {
            access,
            address: transfer.address(access),
            width: transfer.width,
            written: (access == Access::Store).then(|| transfer.item.unwrap_or(0)),
        })
    }

    /// Whether a stream has no access to make before its line stands again.
    pub(super) fn waits(&self, nth: usize) -> bool {
        let transfer = self.streams[nth].transfer.as_ref();
        transfer.is_none_or(|transfer| transfer.next(self.lines.stands(nth)).is_none())
    }

    /// No stream has anything to do before a line rises.
    pub(super) fn is_at_rest(&self) -> bool {
        (0..STREAMS).all(|nth| !self.stands(nth))
    }

    /// The one stream that serves line `id`, where it moves items between the register at `register` and
    /// a memory.
    pub(super) fn ring(&self, id: usize, register: u64) -> Option<Ring> {
        let serves =
            |nth: &usize| self.streams[*nth].transfer.is_some() && self.lines.selected(*nth) == id;
        let mut serving = (0..STREAMS).filter(serves);
        let nth = serving.next().filter(|_| serving.next().is_none())?;
        let transfer = self.streams[nth].transfer.as_ref()?;
        let bytes = u64::from(transfer.width.bytes());
        let plain = transfer.peripheral_at == register
            && transfer.peripheral_step == 0
            && transfer.memory_step == bytes
            && transfer.under_way.is_none()
            && transfer.item.is_none() == transfer.to_memory;
        plain.then(|| Ring {
            nth,
            to_memory: transfer.to_memory,
            width: transfer.width,
            memory_at: transfer.memory_at,
            items: transfer.unflagged(),
            item: transfer.item.unwrap_or(0),
        })
    }

    /// A ring's next items were moved; from memory, `item` is the last one fetched.
    pub(super) fn went_round(&mut self, ring: &Ring, items: u64, item: u64) {
        if let Some(transfer) = &mut self.streams[ring.nth].transfer {
            transfer.to_fetch -= items;
            transfer.to_store -= items;
            transfer.memory_at += items * transfer.memory_step;
            transfer.item = (!transfer.to_memory).then_some(item);
        }
    }

    /// The access [`due`](Self::due) named was made; `value` is what it read.
    pub(super) fn moved(
        &mut self,
        nth: usize,
        due: &Due,
        value: u64,
        registers: &mut RegisterFile,
        context: &mut DeviceContext<'_>,
    ) {
        if due.access == Access::Store
            && let Some(transfer) = &mut self.streams[nth].transfer
        {
            transfer.item = None;
        }
        self.count_access(nth, due.access, value, registers, context);
    }

    /// Asks for the next access of a stream, if it has one to make.
    pub(super) fn advance(
        &mut self,
        nth: usize,
        registers: &mut RegisterFile,
        context: &mut DeviceContext<'_>,
    ) {
        let Some(transfer) = &mut self.streams[nth].transfer else {
            return;
        };
        let Some(access) = transfer.next(self.lines.stands(nth)) else {
            return;
        };
        if !transfer.reaches(access) {
            return self.fail(nth, registers, context);
        }
        transfer.under_way = Some(access);
        let address = transfer.address(access);
        match access {
            Access::Fetch => context.read_from(address, transfer.width, token(nth, access)),
            Access::Store => {
                let item = transfer.item.take().unwrap_or(0);
                context.write_to(address, transfer.width, item, token(nth, access));
            }
        }
    }

    /// An access was made; `value` is what it read.
    fn made(
        &mut self,
        nth: usize,
        access: Access,
        value: u64,
        registers: &mut RegisterFile,
        context: &mut DeviceContext<'_>,
    ) {
        let Some(transfer) = self.streams[nth].transfer.as_mut() else {
            return;
        };
        if transfer.under_way != Some(access) {
            return;
        }
        transfer.under_way = None;
        self.count_access(nth, access, value, registers, context);
        self.advance(nth, registers, context);
    }

    /// Counts an access that was made, and says so in the flags where it is half or the last.
    fn count_access(
        &mut self,
        nth: usize,
        access: Access,
        value: u64,
        registers: &mut RegisterFile,
        context: &mut DeviceContext<'_>,
    ) {
        let Some(transfer) = self.streams[nth].transfer.as_mut() else {
            return;
        };
        let address = transfer.address(access);
        transfer.step(access);
        if access == Access::Fetch {
            self.flash.note_dma_read(address);
            transfer.item = Some(value);
            transfer.to_fetch -= 1;
        } else {
            transfer.to_store -= 1;
            let stored = transfer.items - transfer.to_store;
            // Half of the round is reached once, by the first item at or beyond it (15.3.19).
            if 2 * stored >= transfer.items && 2 * (stored - 1) < transfer.items {
                self.flag(nth, HALF, registers, context);
            }
            self.end_round(nth, registers, context);
        }
    }

    /// Ends the transfer with its last item, or begins the next round.
    fn end_round(
        &mut self,
        nth: usize,
        registers: &mut RegisterFile,
        context: &mut DeviceContext<'_>,
    ) {
        let stream = &mut self.streams[nth];
        let kept = stream.kept;
        let Some(transfer) = stream.transfer.as_mut().filter(|t| t.to_store == 0) else {
            return;
        };
        if !transfer.circular {
            return self.stop(nth, COMPLETE, registers, context);
        }
        (transfer.to_fetch, transfer.to_store) = (transfer.items, transfer.items);
        (transfer.peripheral_at, transfer.memory_at) = (kept[PERIPHERAL], kept[MEMORY]);
        self.flag(nth, COMPLETE, registers, context);
    }

    /// The stream goes off, with `flag` up.
    fn stop(
        &mut self,
        nth: usize,
        flag: u64,
        registers: &mut RegisterFile,
        context: &mut DeviceContext<'_>,
    ) {
        let stream = &mut self.streams[nth];
        if let Some(transfer) = stream.transfer.take() {
            registers.set(register(nth, COUNT), transfer.left());
            stream.kept[COUNT] = transfer.left();
        }
        stream.kept[CONTROL] = registers.get(register(nth, CONTROL)) & !s0cr::EN.mask();
        registers.set(register(nth, CONTROL), stream.kept[CONTROL]);
        self.flag(nth, flag, registers, context);
    }

    /// An access led nowhere (section 15.3.20).
    fn fail(&mut self, nth: usize, registers: &mut RegisterFile, context: &mut DeviceContext<'_>) {
        self.stop(nth, TRANSFER_ERROR, registers, context);
    }

    fn flag(
        &mut self,
        nth: usize,
        flag: u64,
        registers: &mut RegisterFile,
        context: &mut DeviceContext<'_>,
    ) {
        let status = status(nth);
        let standing = registers.get(status) | flag << FLAGS_AT[nth % 4];
        registers.set(status, standing);
        self.drive_interrupt(nth, registers, context);
    }

    fn drive_interrupt(
        &mut self,
        nth: usize,
        registers: &RegisterFile,
        context: &mut DeviceContext<'_>,
    ) {
        let flags = registers.get(status(nth)) >> FLAGS_AT[nth % 4];
        let enabled = (registers.get(register(nth, CONTROL)) & ENABLES) << 1;
        let stream = &mut self.streams[nth];
        let raised = flags & enabled != 0;
        if stream.interrupt != raised {
            stream.interrupt = raised;
            context.interrupt(nth, Level::from(raised));
        }
    }

    /// Begins the transfer the registers describe (section 15.3.19).
    fn start(&mut self, nth: usize, registers: &mut RegisterFile, context: &mut DeviceContext<'_>) {
        let mut control = registers.get(register(nth, CONTROL));
        let direction = s0cr::DIR.get(control);
        let fifo = s0fcr::DMDIS.is_set(registers.get(register(nth, FIFO)));
        if fifo || direction > 1 || s0cr::DBM.is_set(control) || s0cr::PFCTRL.is_set(control) {
            return context.tell(
                "SxCR",
                "a mode of DMA1 that is not modelled: direct mode only",
            );
        }
        // Direct mode moves single items of the peripheral's width (sections 15.3.14 and 15.5.5).
        control = s0cr::MSIZE.set(control, s0cr::PSIZE.get(control));
        for forced in [s0cr::MBURST, s0cr::PBURST, s0cr::PINCOS] {
            control = forced.set(control, 0);
        }
        registers.set(register(nth, CONTROL), control);
        let stream = &mut self.streams[nth];
        registers.set(register(nth, COUNT), stream.programmed);
        let width = [Width::W8, Width::W16, Width::W32][s0cr::PSIZE.get(control).min(2) as usize];
        let step = |on: bool| if on { u64::from(width.bytes()) } else { 0 };
        stream.transfer = Some(Transfer {
            to_memory: direction == 0,
            circular: s0cr::CIRC.is_set(control),
            width,
            peripheral_step: step(s0cr::PINC.is_set(control)),
            memory_step: step(s0cr::MINC.is_set(control)),
            items: stream.programmed,
            to_fetch: stream.programmed,
            to_store: stream.programmed,
            peripheral_at: registers.get(register(nth, PERIPHERAL)),
            memory_at: registers.get(register(nth, MEMORY)),
            item: None,
            under_way: None,
        });
        self.advance(nth, registers, context);
    }

    /// Bits a write may change while the stream runs: its enables.
    fn protect(&self, nth: usize, row: usize, registers: &mut RegisterFile) {
        let open = match row {
            CONTROL => s0cr::EN.mask() | ENABLES,
            FIFO => s0fcr::FEIE.mask(),
            _ => 0,
        };
        registers.restore(register(nth, row), !open, self.streams[nth].kept[row]);
    }

    fn stream_written(
        &mut self,
        nth: usize,
        row: usize,
        registers: &mut RegisterFile,
        context: &mut DeviceContext<'_>,
    ) {
        let running = s0cr::EN.is_set(self.streams[nth].kept[CONTROL]);
        if running {
            self.protect(nth, row, registers);
        } else if row == COUNT {
            self.streams[nth].programmed = s0ndtr::NDT.get(registers.get(register(nth, COUNT)));
        }
        let written = registers.get(register(nth, row));
        self.streams[nth].kept[row] = written;
        if row != CONTROL {
            return;
        }
        match (running, s0cr::EN.is_set(written)) {
            (false, true) => self.start(nth, registers, context),
            // Section 15.3.16: a transfer that is suspended is complete.
            (true, false) => self.stop(nth, COMPLETE, registers, context),
            _ => {}
        }
        self.streams[nth].kept[CONTROL] = registers.get(register(nth, CONTROL));
        self.drive_interrupt(nth, registers, context);
    }

    fn count(&self, nth: usize) -> Option<u64> {
        Some(self.streams[nth].transfer.as_ref()?.left())
    }

    /// `FCR` with the level of what is fetched ahead: in quarters of 16 bytes, rounded down.
    fn fifo(&self, nth: usize, registers: &RegisterFile) -> Option<u64> {
        let transfer = self.streams[nth].transfer.as_ref()?;
        let level = match transfer.item {
            None => EMPTY,
            Some(_) => u64::from(transfer.width.bytes() / 4),
        };
        Some(s0fcr::FS.set(registers.get(register(nth, FIFO)), level))
    }

    fn shown(&self, shown: Register, registers: &RegisterFile) -> Option<u64> {
        match place(shown)? {
            (nth, COUNT) => self.count(nth),
            (nth, FIFO) => self.fifo(nth, registers),
            _ => None,
        }
    }
}

/// Register `row` of stream `nth`.
fn register(nth: usize, row: usize) -> Register {
    Register::ALL[COMMON_ROWS + STREAM_ROWS * nth + row]
}

/// The stream a register belongs to, and its row there.
fn place(of: Register) -> Option<(usize, usize)> {
    let row = of.index().checked_sub(COMMON_ROWS)?;
    Some((row / STREAM_ROWS, row % STREAM_ROWS))
}

/// The register a stream's flags are in.
fn status(nth: usize) -> Register {
    [Register::Lisr, Register::Hisr][nth / 4]
}

fn token(nth: usize, access: Access) -> u64 {
    2 * nth as u64 + u64::from(access == Access::Store)
}

/// The stream and the access a token was made of.
fn of_token(token: u64) -> (usize, Access) {
    let access = match token % 2 {
        0 => Access::Fetch,
        _ => Access::Store,
    };
    (token as usize / 2 % STREAMS, access)
}

impl Device for Dma1 {
    type Register = Register;

    fn read(
        &mut self,
        register: Register,
        registers: &mut RegisterFile,
        _context: &mut DeviceContext<'_>,
    ) -> Option<u64> {
        self.shown(register, registers)
    }

    fn peek(
        &self,
        register: Register,
        registers: &RegisterFile,
        _now: rigless::time::VirtualNanos,
    ) -> Option<u64> {
        self.shown(register, registers)
    }

    fn write(
        &mut self,
        written: Register,
        value: u64,
        registers: &mut RegisterFile,
        context: &mut DeviceContext<'_>,
    ) {
        let (flags, first) = match written {
            Register::Lifcr => (Register::Lisr, 0),
            Register::Hifcr => (Register::Hisr, STREAMS / 2),
            _ => {
                if let Some((nth, row)) = place(written) {
                    self.stream_written(nth, row, registers, context);
                }
                return;
            }
        };
        let standing = registers.get(flags);
        registers.set(flags, standing & !value);
        registers.set(written, 0);
        for nth in first..first + STREAMS / 2 {
            self.drive_interrupt(nth, registers, context);
        }
    }

    /// A line rose that only the bus carries, or a stream was given one that stands.
    fn on_request(
        &mut self,
        request: RequestChange,
        registers: &mut RegisterFile,
        context: &mut DeviceContext<'_>,
    ) {
        if request.instance == super::dmamux::NAME && request.request < STREAMS {
            self.advance(request.request, registers, context);
        }
    }

    fn on_access(
        &mut self,
        token: u64,
        value: u64,
        registers: &mut RegisterFile,
        context: &mut DeviceContext<'_>,
    ) {
        let (nth, access) = of_token(token);
        self.made(nth, access, value, registers, context);
    }

    fn on_refused(
        &mut self,
        token: u64,
        registers: &mut RegisterFile,
        context: &mut DeviceContext<'_>,
    ) {
        let (nth, access) = of_token(token);
        let waiting = self.streams[nth].transfer.and_then(|made| made.under_way);
        if waiting == Some(access) {
            self.fail(nth, registers, context);
        }
    }

    fn reset(&mut self) {
        *self = Self::new(self.lines.clone(), self.flash.clone());
    }
}
