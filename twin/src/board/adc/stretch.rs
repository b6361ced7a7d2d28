//! Triggers that lead to nothing but a pair in the data register.

use std::sync::MutexGuard;

use rigless::device::RegisterFile;
use rigless::soc::stm32h743::generated::adc3::{cfgr, isr};
use rigless::soc::stm32h743::generated::adc3_common::{Register, ccr};
use rigless::time::VirtualNanos;

use super::common::REGULAR_SIMULTANEOUS;
use super::{Common, Pair};
use crate::board::analog::Pins;
use crate::board::flaws::State;
use crate::board::request_lines::ADC1;

/// The pair while each trigger's data are asked for and fetched, and nothing else comes of it.
pub(crate) struct Stretch<'a> {
    pair: MutexGuard<'a, Pair>,
    weak: bool,
    /// From a trigger to the end of its conversions, ns.
    pub(crate) lasts_ns: u64,
}

impl Stretch<'_> {
    /// The register the data are fetched from, and the line they are asked for on.
    pub(crate) const SOURCE: (Register, usize) = (Register::Cdr, ADC1);

    /// Content of the data register after a trigger at `now`.
    pub(crate) fn word(&mut self, pins: &mut Pins, flaws: &State, now: VirtualNanos) -> u32 {
        let pair = &mut *self.pair;
        let [reference, dut] = pair.sample_of(pins, flaws, now);
        let [master, slave] = &pair.converters;
        let (master, slave) = (master.data_of(reference), slave.data_of(dut));
        u32::from(pair.skew.slave(slave, self.weak)) << 16 | u32::from(master)
    }
}

impl Common {
    /// The pair, where a trigger at `now` leads to no more than that.
    pub(crate) fn stretch(
        &self,
        registers: &RegisterFile,
        pins: &Pins,
        now: VirtualNanos,
    ) -> Option<Stretch<'_>> {
        let control = registers.get(Register::Ccr);
        let pair = self.pair.lock();
        let [master, slave] = &pair.converters;
        let fetched = ccr::DUAL.get(control) == REGULAR_SIMULTANEOUS
            && ccr::DAMDF.get(control) != 0
            && cfgr::DMNGT.get(master.configuration) & 1 == 1
            && !isr::OVR.is_set(master.status)
            && !pair.unread;
        let alone = pair.armed() && !pair.interrupts_enabled() && now >= pair.busy_until;
        let wired = master.selects(pair.live_channel(0)) && slave.selects(pair.live_channel(1));
        let set = pair.conversions().filter(|set| pins.convert_so(*set))?;
        (fetched && alone && wired).then(|| Stretch {
            weak: !pair.overwrites(),
            lasts_ns: u64::from(set.count) * set.apart_ns(),
            pair,
        })
    }
}
