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

/// Methods that are those of what is behind.
macro_rules! pass_on {
    ($behind:ident:
        &$this:ident { $($read:ident($($a:ident: $of:ty),*) $(-> $is:ty)?;)+ }
        &mut $that:ident { $($write:ident($($b:ident: $to:ty),*) $(-> $was:ty)?;)+ }
    ) => {
        $(fn $read(&$this $(, $a: $of)*) $(-> $is)? { $this.$behind.$read($($a),*) })+
        $(fn $write(&mut $that $(, $b: $to)*) $(-> $was)? { $that.$behind.$write($($b),*) })+
    };
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

    pass_on! { bus:
        &self { time(instructions: u64) -> VirtualNanos; }
        &mut self {
            acknowledge(line: InterruptLine, instructions: u64) -> Option<u64>;
            read_checked(access: Access, report: bool) -> Option<Checked>;
            write_checked(access: Access) -> Option<bool>;
            stops_before(access: &Access) -> bool;
            send_trace(bytes: &[u8]);
        }
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

    fn reset(&mut self) {
        // It ends what is under way, which changes the flash: then the pages are looked at anew.
        self.followed = None;
        self.core.reset();
    }

    pass_on! { core:
        &self {
            retired() -> u64;
            maps(start: u64, length: u64) -> bool;
            page_size() -> u64;
            next_event() -> Option<VirtualNanos>;
            pc() -> u64;
            gdb_register(number: usize) -> Option<Vec<u8>>;
            target_xml() -> &'static str;
            data_model() -> DataModel;
            byte_order(address: u64) -> Endian;
            save() -> Vec<u8>;
            bit_alias(address: u64, width: Width) -> Option<BitAlias>;
            own_ranges() -> Vec<Range<u64>>;
            host_call(read: &mut dyn FnMut(u64, Width) -> Option<u64>) -> Option<HostCall>;
        }
        &mut self {
            ask(queued: Queued);
            boot(table: u64, read: &dyn Fn(u64, Width) -> Option<u64>);
            take_reset_request() -> bool;
            on_event(now: VirtualNanos);
            add_breakpoint(address: u64) -> bool;
            remove_breakpoint(address: u64);
            pass_breakpoint(address: u64);
            attach_debugger(attached: bool);
            hold_interrupts(held: bool);
            set_gdb_register(number: usize, bytes: &[u8]) -> bool;
            debugger_access(write: Option<u64>, address: u64, width: Width, now: VirtualNanos) -> Option<u64>;
            take_debugger_trace() -> Vec<u8>;
            load(bytes: &[u8]) -> Result<(), Error>;
            monitor_command(command: &str) -> Option<String>;
            debugger_halted(why: HaltReason) -> bool;
            check_reads(every: bool);
            answer_host_call(answer: Option<u64>);
        }
    }
}
