//! The core's way to the flash: loads of poisoned words fail, and a bank at work stalls them.
//!
//! The emulated core reads memory without asking anybody. So the pages that hold poisoned words, and
//! all pages of a bank that programs or erases, are sent over the bus, where this stands in between;
//! everywhere else nothing gets slower. A load of a poisoned word is refused, which the core takes as a
//! precise bus fault, and noted by the flash interface. A load from a bank at work gets its data, and
//! the core does nothing more until the work is done; so does one that is to fetch from it.
//!
//! An access of the core to the areas of code and SRAM where there is no memory is a bus fault too, which
//! the emulator by itself lets pass: a stack that overflows is noticed at once, as on the part.
//!
//! Loads of DMA controllers are not held up, and fetches are asked about between stretches of at most
//! [`LOOK`] instructions, of code outside of the flash [`LOOK_ELSEWHERE`].

use std::collections::BTreeSet;
use std::ops::Range;

use rigless::emulator::{
    Access, AccessKind, BitAlias, Checked, CoreBus, DataModel, Error, Exit, HaltReason, HostCall,
    InterruptLine, Processor, Queued,
};
use rigless::soc::stm32h743::MEMORY;
use rigless::soc::{Endian, Width};
use rigless::time::VirtualNanos;

use super::flash::{FlashWatch, bank_of, bank_range};

/// Instructions between two looks at where the core fetches from, while bank 1 is at work: of code in flash,
/// and of code elsewhere, which may go so far into flash before it is held up.
const LOOK: u32 = 64;
const LOOK_ELSEWHERE: u32 = 4096;

/// First address behind the areas of code and SRAM (ARMv7-M, B3.1): below there are memories alone.
const PERIPHERALS: u64 = 0x4000_0000;

/// Whether nothing answers at an address of the areas for memories (RM0433 Rev 9, table 7).
fn is_nowhere(address: u64) -> bool {
    let mut memories = MEMORY.iter();
    address < PERIPHERALS
        && !memories.any(|memory| (memory.base..memory.base + memory.size).contains(&address))
}

/// A core whose loads from flash are looked at.
#[derive(Debug)]
pub(super) struct FlashBus {
    core: Box<dyn Processor>,
    flash: FlashWatch,
    /// First addresses of the pages that are sent over the bus.
    routed: BTreeSet<u64>,
    /// State they follow from, since the last reset: banks that go there as a whole, and pages with poisoned
    /// words.
    followed: Option<([bool; 2], BTreeSet<u64>)>,
}

impl FlashBus {
    pub(super) fn new(core: Box<dyn Processor>, flash: FlashWatch) -> Self {
        Self {
            core,
            flash,
            routed: BTreeSet::new(),
            followed: None,
        }
    }

    /// Sends the pages over the bus that must be. Bank 2 stays there once it was at work, until the next
    /// reset: its thousand pages would go there and back for every word that is programmed. Bank 1 goes there
    /// only while the core runs from elsewhere: from there, it is held up before it can load anything.
    fn route(&mut self, poisoned: &[u64]) {
        let page = self.core.page_size();
        let poisoned: BTreeSet<u64> = poisoned.iter().map(|word| word & !(page - 1)).collect();
        let was_at_work = self.followed.as_ref().is_some_and(|(banks, _)| banks[1]);
        let runs_from_1 = bank_of(self.core.pc()) == Some(0);
        let banks = [
            self.flash.is_busy(0) && !runs_from_1,
            self.flash.is_busy(1) || was_at_work,
        ];
        let from = Some((banks, poisoned));
        if from == self.followed {
            return;
        }
        self.followed = from;
        let poisoned = self.followed.iter().flat_map(|(_, poisoned)| poisoned);
        let whole = (0..2).filter(|bank| banks[*bank]);
        let whole = whole.flat_map(|bank| bank_range(bank).step_by(page as usize));
        let wanted: BTreeSet<u64> = whole.chain(poisoned.copied()).collect();
        for &page in wanted.difference(&self.routed) {
            self.core.ask(Queued::Route(page));
        }
        for &page in self.routed.difference(&wanted) {
            self.core.ask(Queued::Unroute(page));
        }
        self.routed = wanted;
    }

    /// Whether the core waits for the flash, by a load or for its next instruction.
    fn is_stalled(&self) -> bool {
        let fetches = bank_of(self.core.pc()).is_some_and(|bank| self.flash.is_busy(bank));
        fetches || self.flash.is_awaited()
    }
}

/// The run's bus, looked at.
struct Looked<'b> {
    bus: &'b mut dyn CoreBus,
    flash: &'b FlashWatch,
}

impl CoreBus for Looked<'_> {
    fn access(&mut self, access: Access, from_code: bool) -> Option<u64> {
        if is_nowhere(access.address) {
            return None;
        }
        if access.kind == AccessKind::Read
            && let Some(bank) = bank_of(access.address)
        {
            if self.flash.is_busy(bank) {
                self.flash.await_bank(bank);
            }
            if self.bus.read_checked(access, true) == Some(Checked::Uncorrectable) {
                return None;
            }
        }
        self.bus.access(access, from_code)
    }

    fn time(&self, instructions: u64) -> VirtualNanos {
        self.bus.time(instructions)
    }

    fn queued(&mut self) -> Vec<Queued> {
        let mut queued = self.bus.queued();
        if self.flash.is_awaited() {
            queued.push(Queued::Return);
        }
        queued
    }

    fn carry_on(&mut self, instructions: u64, event: Option<VirtualNanos>) -> Option<u32> {
        match self.flash.is_awaited() {
            true => None,
            false => self.bus.carry_on(instructions, event),
        }
    }

    fn acknowledge(&mut self, line: InterruptLine, instructions: u64) -> Option<u64> {
        self.bus.acknowledge(line, instructions)
    }

    fn read_checked(&mut self, access: Access, report: bool) -> Option<Checked> {
        self.bus.read_checked(access, report)
    }

    fn write_checked(&mut self, access: Access) -> Option<bool> {
        self.bus.write_checked(access)
    }

    fn stops_before(&mut self, access: &Access) -> bool {
        self.bus.stops_before(access)
    }

    fn send_trace(&mut self, bytes: &[u8]) {
        self.bus.send_trace(bytes);
    }
}

impl Processor for FlashBus {
    fn run(&mut self, budget: u32, bus: &mut dyn CoreBus) -> (Exit, u64) {
        if self.is_stalled() {
            return (Exit::Waiting, 0);
        }
        let budget = match self.flash.is_busy(0) {
            true if bank_of(self.core.pc()).is_some() => budget.min(LOOK),
            true => budget.min(LOOK_ELSEWHERE),
            false => budget,
        };
        let mut bus = Looked {
            bus,
            flash: &self.flash,
        };
        self.core.run(budget, &mut bus)
    }

    fn check_words(&mut self, words: &[u64]) {
        self.route(words);
    }

    fn waiting(&self) -> bool {
        self.is_stalled() || self.core.waiting()
    }

    unsafe fn map(&mut self, start: u64, length: u64, host: *mut u8, writable: bool) {
        // SAFETY: the caller's promise, handed on as it is.
        unsafe { self.core.map(start, length, host, writable) }
    }

    // The rest is the core's own.

    fn retired(&self) -> u64 {
        self.core.retired()
    }

    fn ask(&mut self, queued: Queued) {
        self.core.ask(queued);
    }

    fn maps(&self, start: u64, length: u64) -> bool {
        self.core.maps(start, length)
    }

    fn page_size(&self) -> u64 {
        self.core.page_size()
    }

    fn boot(&mut self, table: u64, read: &dyn Fn(u64, Width) -> Option<u64>) {
        self.core.boot(table, read);
    }

    fn reset(&mut self) {
        // It ends what is under way, which changes the flash: then the pages are looked at anew.
        self.followed = None;
        self.core.reset();
    }

    fn take_reset_request(&mut self) -> bool {
        self.core.take_reset_request()
    }

    fn next_event(&self) -> Option<VirtualNanos> {
        self.core.next_event()
    }

    fn on_event(&mut self, now: VirtualNanos) {
        self.core.on_event(now);
    }

    fn pc(&self) -> u64 {
        self.core.pc()
    }

    fn add_breakpoint(&mut self, address: u64) -> bool {
        self.core.add_breakpoint(address)
    }

    fn remove_breakpoint(&mut self, address: u64) {
        self.core.remove_breakpoint(address);
    }

    fn pass_breakpoint(&mut self, address: u64) {
        self.core.pass_breakpoint(address);
    }

    fn attach_debugger(&mut self, attached: bool) {
        self.core.attach_debugger(attached);
    }

    fn hold_interrupts(&mut self, held: bool) {
        self.core.hold_interrupts(held);
    }

    fn gdb_register(&self, number: usize) -> Option<Vec<u8>> {
        self.core.gdb_register(number)
    }

    fn set_gdb_register(&mut self, number: usize, bytes: &[u8]) -> bool {
        self.core.set_gdb_register(number, bytes)
    }

    fn debugger_access(
        &mut self,
        write: Option<u64>,
        address: u64,
        width: Width,
        now: VirtualNanos,
    ) -> Option<u64> {
        self.core.debugger_access(write, address, width, now)
    }

    fn take_debugger_trace(&mut self) -> Vec<u8> {
        self.core.take_debugger_trace()
    }

    fn target_xml(&self) -> &'static str {
        self.core.target_xml()
    }

    fn data_model(&self) -> DataModel {
        self.core.data_model()
    }

    fn byte_order(&self, address: u64) -> Endian {
        self.core.byte_order(address)
    }

    fn save(&self) -> Vec<u8> {
        self.core.save()
    }

    fn load(&mut self, bytes: &[u8]) -> Result<(), Error> {
        self.core.load(bytes)
    }

    fn monitor_command(&mut self, command: &str) -> Option<String> {
        self.core.monitor_command(command)
    }

    fn debugger_halted(&mut self, why: HaltReason) -> bool {
        self.core.debugger_halted(why)
    }

    fn bit_alias(&self, address: u64, width: Width) -> Option<BitAlias> {
        self.core.bit_alias(address, width)
    }

    fn own_ranges(&self) -> Vec<Range<u64>> {
        self.core.own_ranges()
    }

    fn check_reads(&mut self, every: bool) {
        self.core.check_reads(every);
    }

    fn host_call(&self, read: &mut dyn FnMut(u64, Width) -> Option<u64>) -> Option<HostCall> {
        self.core.host_call(read)
    }

    fn answer_host_call(&mut self, answer: Option<u64>) {
        self.core.answer_host_call(answer);
    }
}
