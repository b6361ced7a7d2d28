// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! Loops that change nothing, skipped a whole number of times at once.
//!
//! An idle task that polls RAM for work, rather than waiting with `WFI`, retires instructions
//! until an interrupt comes and does nothing with them. The core watches for such a loop: from a
//! block's start it runs on until it's back at that start with every register, every byte of
//! memory and every input the same as before, and nothing reaching the bus on the way. A read of a
//! PMU counter brings the PMU up to date with the instructions retired, so a loop that reads one
//! never comes back the same. Each time round from there is then the same, since
//! the core is deterministic and nothing it reads changes until the runner's next event. So the
//! core retires as many whole loops as fit in the stretch in one step, and runs the rest as it
//! would. The run is the same instruction for instruction, and lands on the same state at the
//! same instant, as if it had run every loop.
//!
//! While it looks, every store goes through the core, which keeps each page a store changes as
//! it was before, so only those pages are compared. A loop found is forgotten when an
//! asynchronous exception is taken or anything outside the core writes memory or remaps it.

use std::collections::BTreeMap;

use super::{Family, Saved};
use crate::emulator::core::PAGE_SIZE;

/// The instructions retired with nothing reaching the bus before the core looks for a loop.
const QUIET: u64 = 1 << 9;
/// The instructions after which a start the core hasn't come back to moves to where the core is.
const ANCHOR: u64 = 1 << 12;
/// The longest the core looks before it waits.
const LONGEST: u64 = 1 << 16;
/// The instructions the core waits before looking again after its first look that found nothing.
/// Each look that fails doubles it, and an asynchronous exception starts it over.
const FIRST_BACKOFF: u64 = 1 << 12;
/// The longest the core waits before looking again.
const LAST_BACKOFF: u64 = 1 << 22;

/// What the core knows of the loop it's in.
pub(crate) struct Cycles {
    /// How many times the core has reached the bus.
    reached: u64,
    /// The instructions retired when the core last reached the bus.
    reached_at: u64,
    /// The start the core is waiting to come back to, with how many times it had reached the bus
    /// then.
    looking: Option<(Saved, u64)>,
    /// Each host page stored to since the start, by its address, as it was at the start.
    stored: BTreeMap<usize, Vec<u8>>,
    /// The instructions retired when the core started looking.
    looked_from: u64,
    found: Option<Found>,
    /// The instructions retired when the core was last at the start of the loop found.
    started: u64,
    /// The instructions retired before the core may look next.
    next_look: u64,
    /// The instructions the core waits after a look that fails.
    backoff: u64,
}

impl Default for Cycles {
    fn default() -> Self {
        Self {
            reached: 0,
            reached_at: 0,
            looking: None,
            stored: BTreeMap::new(),
            looked_from: 0,
            found: None,
            started: 0,
            next_look: 0,
            backoff: FIRST_BACKOFF,
        }
    }
}

/// A loop that changes nothing.
struct Found {
    /// The state at its start, as [`normalized`] leaves it.
    start: Saved,
    /// The instructions it retires.
    length: u64,
    /// What each time round adds to the PMU's totals.
    totals: [u64; 3],
    /// Whether it takes a synchronous exception, which moves where the last one was.
    enters: bool,
}

/// `saved` with what moves with the instructions retired taken out: the count itself and the PMU's
/// totals. When `enters`, the last synchronous exception's count becomes the instructions since.
fn normalized(mut saved: Saved, enters: bool) -> Saved {
    if enters {
        saved.entries.0 = saved.retired - saved.entries.0;
    }
    saved.retired = 0;
    saved.system.pmu.set_totals([0; 3]);
    saved
}

impl Family {
    /// Between blocks, with no debugger's breakpoint or step: retires as many whole times round
    /// the loop the core is at the start of as fit in the budget, or looks for one.
    pub(super) fn fast_forward(&mut self) {
        let pc = self.state.r[15];
        if let Some(found) = &self.cycles.found {
            if found.start.state.r[15] == pc
                && normalized(self.saved(), found.enters) == found.start
            {
                self.skip();
                return;
            }
            // A whole loop's length without its start means the core has left the loop.
            if self.retired - self.cycles.started <= found.length {
                return;
            }
            self.cycles.found = None;
        }
        let Some((looking, reached)) = &self.cycles.looking else {
            if self.retired >= self.cycles.next_look
                && self.retired - self.cycles.reached_at >= QUIET
            {
                self.cycles.looked_from = self.retired;
                self.pages.watch_stores();
                self.anchor();
            }
            return;
        };
        // A look that reaches the bus or runs long waits longer each time, so busy firmware stops
        // paying for looks that fail.
        if self.cycles.reached != *reached || self.retired - self.cycles.looked_from > LONGEST {
            self.stop_looking();
            self.cycles.next_look = self.retired + self.cycles.backoff;
            self.cycles.backoff = (self.cycles.backoff * 2).min(LAST_BACKOFF);
            return;
        }
        // A block that turned hot ran nothing, and comes back to where it was.
        if looking.state.r[15] != pc || self.retired == looking.retired {
            if self.retired - looking.retired > ANCHOR {
                self.anchor();
            }
            return;
        }
        let now = self.saved();
        let enters = now.entries != looking.entries;
        if normalized(now.clone(), enters) != normalized(looking.clone(), enters)
            || !self.stored_same()
        {
            return;
        }
        let (looking, _) = self.cycles.looking.take().expect("looking");
        self.pages.unwatch_stores();
        let [taken, returned, changes] = now.system.pmu.totals();
        let [was_taken, was_returned, was_changes] = looking.system.pmu.totals();
        self.cycles.found = Some(Found {
            length: now.retired - looking.retired,
            totals: [
                taken - was_taken,
                returned - was_returned,
                changes - was_changes,
            ],
            enters,
            start: normalized(now, enters),
        });
        self.cycles.backoff = FIRST_BACKOFF;
        self.skip();
    }

    /// Retires the whole times round the loop found that fit in the budget.
    fn skip(&mut self) {
        let found = self.cycles.found.as_ref().expect("a loop");
        let times = u64::from(self.budget) / found.length;
        let instructions = times * found.length;
        self.retired += instructions;
        self.budget -= u32::try_from(instructions).expect("inside the budget");
        if found.enters {
            self.entries.0 += instructions;
        }
        let mut totals = self.system.pmu.totals();
        for (total, each) in totals.iter_mut().zip(found.totals) {
            *total += times * each;
        }
        self.system.pmu.set_totals(totals);
        self.cycles.started = self.retired;
    }

    /// Whether every page stored to since the core started looking holds what it did then.
    fn stored_same(&self) -> bool {
        self.cycles.stored.iter().all(|(page, before)| {
            // SAFETY: only `storing` adds a key, and it is the start of a page `map` was given:
            // `Pages::map` takes whole aligned pages, so all `PAGE_SIZE` bytes lie inside it. The
            // `map` contract keeps the page valid and in place until the processor is dropped, so
            // a stale key still reads valid bytes. Nothing changes the bytes during this call,
            // and the slice ends before it returns.
            let now = unsafe { std::slice::from_raw_parts(*page as *const u8, before.len()) };
            now == before.as_slice()
        })
    }

    /// Makes where the core is the start it waits to come back to. Each page is kept as the
    /// next store finds it.
    fn anchor(&mut self) {
        self.cycles.stored.clear();
        self.cycles.looking = Some((self.saved(), self.cycles.reached));
    }

    fn stop_looking(&mut self) {
        self.cycles.looking = None;
        self.cycles.stored.clear();
        self.pages.unwatch_stores();
    }

    /// A store is about to change the host's byte at `host`, which the core keeps the page of
    /// as it was while it looks for a loop.
    ///
    /// # Safety
    ///
    /// `host` is what `Pages::host` gave for the address being stored to.
    pub(super) unsafe fn storing(&mut self, host: *mut u8) {
        if !self.pages.watching_stores() {
            return;
        }
        let length = usize::try_from(PAGE_SIZE).expect("a page");
        let page = host as usize & !(length - 1);
        self.cycles.stored.entry(page).or_insert_with(|| {
            // SAFETY: the caller gives a pointer into a page `map` was given, so rounding it down
            // gives that page's start, and the reasons in `stored_same` hold.
            unsafe { std::slice::from_raw_parts(page as *const u8, length) }.to_vec()
        });
    }

    /// The core reached the bus.
    pub(super) fn reached_bus(&mut self) {
        self.cycles.reached += 1;
        self.cycles.reached_at = self.retired;
    }

    /// Something other than the loop ran on the core, or memory changed under it: the loop found
    /// and any look go.
    pub(super) fn forget_loops(&mut self) {
        self.cycles.found = None;
        self.stop_looking();
    }

    /// Everything the core knows of loops goes, as a reset or a state put back leaves it.
    pub(super) fn forget_everything(&mut self) {
        self.forget_loops();
        self.cycles = Cycles::default();
    }

    /// An asynchronous exception was taken.
    pub(super) fn interrupted(&mut self) {
        self.forget_loops();
        self.cycles.backoff = FIRST_BACKOFF;
        self.cycles.next_look = self.retired;
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::exception::IRQ;
    use super::super::super::translate::testing::{Bench, DEVICE, RAM, SPIN, VECTORS};
    use super::{FIRST_BACKOFF, LONGEST};
    use crate::device::Level;
    use crate::emulator::{Exit, InterruptLine, Processor, Queued};
    use crate::soc::Endian;

    /// `MOVS PC, LR`, A8.8.105, which returns from a Supervisor Call to the instruction after it.
    const RETURN: u32 = 0xE1B0_F00E;
    /// The Supervisor Call's and the IRQ's offsets in the vector table, B1.8.1.
    const SUPERVISOR_CALL: u32 = 0x08;
    const IRQ_VECTOR: u32 = 0x18;

    /// Polls the word at `RAM + 4`, adding one to the word at `RAM` and taking it off again each
    /// time round, which leaves memory as it was.
    const POLL: [u32; 10] = [
        0xE300_0000, // movw r0, #0
        0xE342_0000, // movt r0, #0x2000
        0xE590_1000, // ldr r1, [r0]
        0xE281_1001, // add r1, r1, #1
        0xE580_1000, // str r1, [r0]
        0xE241_1001, // sub r1, r1, #1
        0xE580_1000, // str r1, [r0]
        0xE590_2004, // ldr r2, [r0, #4]
        0xE352_0000, // cmp r2, #0
        0x0AFF_FFF7, // beq the ldr
    ];
    /// Waits for the cycle counter to reach 0x8000, throwing each read away, so every time round
    /// the registers are the same and only the counter says when to stop, DDI 0460D 6.3.
    const DEADLINE: [u32; 9] = [
        0xE308_3000, // movw r3, #0x8000
        0xE3A0_2001, // mov r2, #1
        0xEE09_2F1C, // mcr p15, 0, r2, c9, c12, 0: PMCR.E
        0xE3A0_2102, // mov r2, #0x80000000
        0xEE09_2F3C, // mcr p15, 0, r2, c9, c12, 1: PMCNTENSET.C
        0xEE19_1F1D, // mrc p15, 0, r1, c9, c13, 0: PMCCNTR
        0xE151_0003, // cmp r1, r3
        0xE3A0_1000, // mov r1, #0
        0x3AFF_FFFB, // blo the mrc
    ];

    /// Counts in the word at `RAM` while it polls the word at `RAM + 4`, with the same registers
    /// each time round.
    const COUNT: [u32; 9] = [
        0xE300_0000, // movw r0, #0
        0xE342_0000, // movt r0, #0x2000
        0xE590_1000, // ldr r1, [r0]
        0xE281_1001, // add r1, r1, #1
        0xE580_1000, // str r1, [r0]
        0xE3A0_1000, // mov r1, #0
        0xE590_2004, // ldr r2, [r0, #4]
        0xE352_0000, // cmp r2, #0
        0x0AFF_FFF8, // beq the first ldr
    ];

    /// Counts the exceptions taken in PMU counter 0, then makes a Supervisor Call each time round
    /// while it polls the word at `RAM + 4`, and reads the counter once the word is set, DDI 0460D
    /// 6.3.
    const CALLS: [u32; 15] = [
        0xE300_0000, // movw r0, #0
        0xE342_0000, // movt r0, #0x2000
        0xE3A0_2001, // mov r2, #1
        0xEE09_2F1C, // mcr p15, 0, r2, c9, c12, 0: PMCR.E
        0xE3A0_2000, // mov r2, #0
        0xEE09_2FBC, // mcr p15, 0, r2, c9, c12, 5: PMSELR
        0xE3A0_2009, // mov r2, #9, exceptions taken
        0xEE09_2F3D, // mcr p15, 0, r2, c9, c13, 1: PMXEVTYPER
        0xE3A0_2001, // mov r2, #1
        0xEE09_2F3C, // mcr p15, 0, r2, c9, c12, 1: PMCNTENSET.P0
        0xEF00_0000, // svc #0
        0xE590_2004, // ldr r2, [r0, #4]
        0xE352_0000, // cmp r2, #0
        0x0AFF_FFFB, // beq the svc
        0xEE19_5F5D, // mrc p15, 0, r5, c9, c13, 2: PMXEVCNTR
    ];

    /// Polls the word at `RAM + 4` with IRQs masked, unmasking them for one instruction each time
    /// round.
    const MASKED: [u32; 7] = [
        0xE300_0000, // movw r0, #0
        0xE342_0000, // movt r0, #0x2000
        0xF10C_0080, // cpsid i
        0xE590_2004, // ldr r2, [r0, #4]
        0xF108_0080, // cpsie i
        0xE352_0000, // cmp r2, #0
        0x0AFF_FFFA, // beq the cpsid
    ];

    /// Counts in a register for ever, so no time round is like another.
    const BUSY: [u32; 2] = [
        0xE281_1001, // add r1, r1, #1
        0xEAFF_FFFD, // b the add
    ];

    /// Polls a word on the bus until it's set, which the bench never does.
    const DEVICE_POLL: [u32; 5] = [
        0xE300_0000, // movw r0, #0
        0xE344_0000, // movt r0, #0x4000
        0xE590_2000, // ldr r2, [r0]
        0xE352_0000, // cmp r2, #0
        0x0AFF_FFFC, // beq the ldr
    ];

    /// Counts down from 1024 in a register, then reads the device and starts again, so every look
    /// for a loop ends at the bus.
    const QUIET_THEN_BUS: [u32; 7] = [
        0xE300_0000, // movw r0, #0
        0xE344_0000, // movt r0, #0x4000
        0xE3A0_3B01, // mov r3, #0x400
        0xE253_3001, // subs r3, r3, #1
        0x1AFF_FFFD, // bne the subs
        0xE590_2000, // ldr r2, [r0]
        0xEAFF_FFFA, // b the mov
    ];

    /// The program on two benches, one with a breakpoint nothing reaches, which keeps its core
    /// running every instruction.
    fn benches(program: &[u32]) -> [Bench; 2] {
        let code: Vec<u32> = program.iter().copied().chain([SPIN]).collect();
        let mut every = Bench::arm(Endian::Big, &code);
        assert!(every.core.add_breakpoint(0x1000));
        [Bench::arm(Endian::Big, &code), every]
    }

    /// A loop that changes nothing is retired a whole number of times at once, and leaves the core
    /// as running every instruction does, then leaves it the same once memory changes under it.
    #[test]
    fn a_loop_that_changes_nothing_ends_where_every_instruction_would() {
        let [mut skipped, mut every] = benches(&POLL);
        let ran = skipped.run(1 << 22);
        assert_eq!(ran, every.run(1 << 22));
        assert_eq!(ran, (Exit::Budget, 1 << 22));
        assert!(skipped.core.cycles.found.is_some(), "the loop was found");
        assert_eq!(skipped.core.save(), every.core.save());
        set_flag([&mut skipped, &mut every]);
        assert_eq!(skipped.run(100), every.run(100));
        assert_eq!(skipped.run(100).0, Exit::Waiting);
        assert_eq!(skipped.core.save(), every.core.save());
    }

    /// A loop whose way out is the cycle counter changes the PMU each time round, so it's never
    /// skipped past the instant it leaves.
    #[test]
    fn a_loop_that_reads_the_cycle_counter_isnt_skipped() {
        let [mut skipped, mut every] = benches(&DEADLINE);
        let ran = skipped.run(1 << 20);
        assert_eq!(ran.0, Exit::Waiting);
        assert_eq!(ran, every.run(1 << 20));
        assert_eq!(skipped.core.save(), every.core.save());
    }

    /// A loop that reads the bus makes every read, since what the bus answers may change.
    #[test]
    fn a_loop_that_reads_the_bus_isnt_skipped() {
        assert_eq!(DEVICE >> 16, 0x4000);
        let [mut skipped, mut every] = benches(&DEVICE_POLL);
        for _ in 0..1000 {
            assert_eq!(skipped.run(1 << 16), every.run(1 << 16));
        }
        assert_eq!(skipped.bus.accesses.len(), every.bus.accesses.len());
        assert_eq!(skipped.core.save(), every.core.save());
    }

    /// Busy firmware that reaches the bus between quiet stretches waits longer before each look.
    #[test]
    fn a_look_the_bus_ends_waits_longer_before_the_next() {
        let [mut skipped, mut every] = benches(&QUIET_THEN_BUS);
        for _ in 0..64 {
            assert_eq!(skipped.run(1 << 16), every.run(1 << 16));
        }
        assert!(skipped.core.cycles.backoff > FIRST_BACKOFF);
        assert_eq!(skipped.bus.accesses.len(), every.bus.accesses.len());
        assert_eq!(skipped.core.save(), every.core.save());
    }

    /// A loop that changes memory each time round, with the same registers, runs every time.
    #[test]
    fn a_loop_that_counts_in_memory_isnt_skipped() {
        let [mut skipped, mut every] = benches(&COUNT);
        assert_eq!(skipped.run(1 << 20), every.run(1 << 20));
        let count = |bench: &Bench| (RAM..RAM + 4).map(|at| bench.byte(at)).collect::<Vec<_>>();
        assert_eq!(count(&skipped), count(&every));
        assert_eq!(skipped.core.save(), every.core.save());
    }

    /// Sets the word at `RAM + 4` on both benches, as a store from outside the core does.
    fn set_flag(benches: [&mut Bench; 2]) {
        for bench in benches {
            bench.write(RAM + 4, &[0, 0, 0, 1]);
            bench
                .core
                .ask(Queued::Invalidate(u64::from(RAM + 4), u64::from(RAM + 8)));
        }
    }

    /// A loop that takes an exception each time round moves the count of the last one and the
    /// PMU's totals as running every instruction does, which the program reads once it leaves.
    #[test]
    fn a_loop_that_takes_an_exception_counts_each_one() {
        let [mut skipped, mut every] = benches(&CALLS);
        for bench in [&mut skipped, &mut every] {
            bench.place_arm(VECTORS + SUPERVISOR_CALL, &[RETURN]);
        }
        let ran = skipped.run(1 << 22);
        assert_eq!(ran, every.run(1 << 22));
        assert!(
            skipped
                .core
                .cycles
                .found
                .as_ref()
                .is_some_and(|found| found.enters),
            "the loop was found"
        );
        assert_eq!(skipped.core.save(), every.core.save());
        set_flag([&mut skipped, &mut every]);
        assert_eq!(skipped.run(100), every.run(100));
        assert_eq!(skipped.core.state.r[15], every.core.state.r[15]);
        assert!(
            skipped.core.state.r[5] > 1 << 18,
            "{}",
            skipped.core.state.r[5]
        );
        assert_eq!(skipped.core.state.r[5], every.core.state.r[5]);
        assert_eq!(skipped.core.save(), every.core.save());
    }

    /// An interrupt raised while the loop has IRQs masked is taken where running every
    /// instruction takes it, at the next unmask.
    #[test]
    fn an_interrupt_raised_while_masked_is_taken_at_the_unmask() {
        let [mut skipped, mut every] = benches(&MASKED);
        assert_eq!(skipped.run(1 << 22), every.run(1 << 22));
        assert!(skipped.core.cycles.found.is_some(), "the loop was found");
        let line = InterruptLine::new(u16::try_from(IRQ).unwrap()).unwrap();
        for bench in [&mut skipped, &mut every] {
            bench.core.ask(Queued::Line(line, Level::High));
        }
        assert_eq!(skipped.run(1 << 20), every.run(1 << 20));
        assert_eq!(skipped.core.state.r[15], VECTORS + IRQ_VECTOR);
        assert_eq!(skipped.core.save(), every.core.save());
    }

    /// A state put back in the middle of a loop runs on as it did the first time.
    #[test]
    fn a_state_put_back_runs_on_as_it_did() {
        let [mut skipped, mut every] = benches(&POLL);
        assert_eq!(skipped.run(1 << 22), every.run(1 << 22));
        let kept = skipped.core.save();
        skipped.run(1 << 20);
        let first = skipped.core.save();
        skipped.core.load(&kept).unwrap();
        assert!(skipped.core.cycles.found.is_none(), "the loop is forgotten");
        assert_eq!(skipped.run(1 << 20), every.run(1 << 20));
        assert_eq!(skipped.core.save(), first);
        assert_eq!(skipped.core.save(), every.core.save());
    }

    /// A loop that never comes back the same is looked at for a while, then left for longer each
    /// time, and runs as every instruction does all along. A loop of one block chains to itself,
    /// so the core sees its start only between stretches.
    #[test]
    fn a_loop_that_never_repeats_backs_off() {
        let [mut skipped, mut every] = benches(&BUSY);
        for _ in 0..1 << 10 {
            assert_eq!(skipped.run(1 << 12), every.run(1 << 12));
        }
        assert!(skipped.core.cycles.found.is_none());
        assert!(skipped.core.cycles.backoff > FIRST_BACKOFF);
        assert!(skipped.core.cycles.next_look > LONGEST);
        assert_eq!(skipped.core.save(), every.core.save());
    }
}
