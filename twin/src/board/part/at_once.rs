//! Samples taken at once, without a stop of the run for each.
//!
//! A sample is an event, a look at every model and a settle of its own, 50 000 times a second, and
//! mostly the core sleeps until a buffer is full. Here the same models do the same at the same
//! instants without the run in between: one sample while the core works, as many as are due while it
//! sleeps. Whatever is more than that, an interrupt first of all, is left to the run's own stop. Test
//! `a_fast_run_is_the_plain_one` compares the two.

use rigless::emulator::Memory;
use rigless::mcu::{Mcu, Operate};
use rigless::time::{NO_DEADLINE, VirtualNanos};

use super::Part;
use crate::board::dma1::STREAMS;

impl Part {
    /// Takes the samples due by `now` and from there up to before `limit`, as long as nothing but the
    /// sample path has anything to do; answers the instant at which the run has to look again.
    pub(super) fn sample_at_once(
        &mut self,
        now: VirtualNanos,
        limit: VirtualNanos,
        memory: &mut dyn Memory,
    ) -> VirtualNanos {
        let Some(mut at) = self.only_sample(now) else {
            return now;
        };
        let limit = limit.min(self.bus().next_event().unwrap_or(NO_DEADLINE));
        loop {
            at = self.stretch(at, limit, memory);
            let settled = self.one_sample(at, memory);
            let next = self.tim6.next_update();
            if !settled || next >= limit {
                let (registers, mut context) = self.base.bus_mut().drive(at, self.slots.tim6);
                self.tim6.schedule(registers, &mut context);
                return if settled { limit } else { at };
            }
            at = next;
        }
    }

    /// The instant of the sample clock's pulse, where that is all that is due by `now`; it is then
    /// taken off the queue of events.
    fn only_sample(&mut self, now: VirtualNanos) -> Option<VirtualNanos> {
        let bus = self.base.bus_mut();
        let registers = bus.slots()[self.slots.tim6].registers();
        let update = self.tim6.plain_update(registers)?;
        let at = self.tim6.next_update();
        let alone = !self.pins.serial.is_sending()
            && !self.pins.usb.has_news()
            && bus.is_settled()
            && bus.take_event(update, at, now);
        alone.then_some(at)
    }

    /// The sample clock's pulse at `at` with all that follows from it; answers whether nothing is
    /// left for the run to settle.
    fn one_sample(&mut self, at: VirtualNanos, memory: &mut dyn Memory) -> bool {
        let bus = self.base.bus_mut();
        self.tim6
            .pass_updates(1, bus.slot_mut(self.slots.tim6).registers_mut());
        self.trigger_converters(at);
        for nth in 0..STREAMS {
            if self.dma1.stands(nth) && !self.move_items(nth, at, memory) {
                // Something is amiss: the run asks the bus again, and is told.
                let (registers, mut context) = self.base.bus_mut().drive(at, self.slots.dma1);
                self.dma1.advance(nth, registers, &mut context);
            }
        }
        self.base.bus().is_settled()
    }

    /// Makes the accesses that stream `nth` has to make now; answers whether that was all of them.
    fn move_items(&mut self, nth: usize, at: VirtualNanos, memory: &mut dyn Memory) -> bool {
        while let Some(due) = self.dma1.due(nth) {
            let Some(value) = self.reach(at, due.address, due.width, due.written, memory) else {
                return false;
            };
            let (registers, mut context) = self.base.bus_mut().drive(at, self.slots.dma1);
            self.dma1.moved(nth, &due, value, registers, &mut context);
        }
        self.dma1.waits(nth)
    }
}
