//! The registers of the converter pair: clock, dual mode, trigger, data and DMA request.

use rigless::device::{Device, DeviceContext, RegisterFile};
use rigless::soc::stm32h743::generated::adc3::{cfgr, cr, isr};
use rigless::soc::stm32h743::generated::adc3_common::{Register, ccr};
use rigless::time::VirtualNanos;

use super::{INPUT_CHANNELS, Pair, SharedPair};
use crate::board::input_pin::Pull;
use crate::board::request_lines::{ADC1, RequestLines};

/// `DUAL` of the regular simultaneous mode alone (RM0433 Rev 9, section 25.7.2).
pub(super) const REGULAR_SIMULTANEOUS: u64 = 0b00110;
/// `DAMDF` of one 32-bit word per pair for 16 to 10 bits.
const WORD_PER_PAIR: u64 = 0b10;
/// `EXTSEL` of TIM6's trigger output (section 25.4.19, table 213) and `EXTEN` of its rising edge.
const TIM6_TRGO: u64 = 13;
const RISING: u64 = 0b01;
/// Divider each `PRESC` code selects.
const PRESCALER: [u64; 12] = [1, 2, 4, 6, 8, 10, 12, 16, 32, 64, 128, 256];
/// Places of the two clocks the memory map wires.
const KERNEL_CLOCK: usize = 0;

/// The model's state beside the registers.
#[derive(Debug)]
pub(crate) struct Common {
    pub(super) pair: SharedPair,
    lines: RequestLines,
    kernel_hz: u64,
    bus_hz: u64,
}

rigless::store!(Common {
    values: [kernel_hz, bus_hz],
    parts: [pair],
    built: [lines],
});

impl Common {
    pub(crate) fn new(pair: SharedPair, lines: RequestLines) -> Self {
        Self {
            pair,
            lines,
            kernel_hz: 0,
            bus_hz: 0,
        }
    }

    /// The pair converted last was not fetched.
    pub(crate) fn leave_a_pair_unread(&mut self) {
        self.pair.lock().unread = true;
    }

    /// Sets the pulls of the ports on the pins of reference and device under test.
    pub(crate) fn set_pulls(&mut self, pulls: [Pull; INPUT_CHANNELS]) {
        self.pair.lock().pulls = pulls;
    }

    /// The part has the erratum by which the slave's data may be those of another trigger.
    pub(crate) fn give_slave_erratum(&mut self) {
        self.pair.lock().skew.give_erratum();
    }

    /// In the next `starts` starts the slave's data are those of the trigger before.
    pub(crate) fn spoil_starts(&mut self, starts: u32) {
        self.pair.lock().skew.spoil_starts(starts);
    }

    /// Takes over the flaws of the silicon, which stay whatever resets the registers.
    pub(crate) fn inherit_silicon(&mut self, before: &Self) {
        let skew = before.pair.lock().skew;
        self.pair.lock().skew = skew;
    }

    /// Figure 136: kernel clock over `PRESC`, or bus clock over 1, 2 or 4; revision V halves both, revision Y neither.
    fn clock(&self, control: u64) {
        let prescaler = PRESCALER.get(ccr::PRESC.get(control) as usize);
        let hz = match ccr::CKMODE.get(control) {
            0 => self.kernel_hz / prescaler.copied().unwrap_or(256),
            mode => self.bus_hz >> (mode - 1),
        };
        let mut pair = self.pair.lock();
        pair.clock_hz = if pair.halves_clock { hz / 2 } else { hz };
    }

    /// TIM6's trigger output pulses.
    pub(crate) fn on_tim6(&mut self, registers: &RegisterFile, context: &mut DeviceContext<'_>) {
        let control = registers.get(Register::Ccr);
        if ccr::DUAL.get(control) == REGULAR_SIMULTANEOUS {
            self.trigger(control, context);
        }
    }

    fn trigger(&mut self, control: u64, context: &mut DeviceContext<'_>) {
        let shared = self.pair.clone();
        let mut pair = shared.lock();
        if !pair.armed() {
            return;
        }
        let Some(conversions) = pair.conversions() else {
            return context.tell("CCR", "a trigger finds the converters without a clock");
        };
        let now = context.now();
        if now < pair.busy_until {
            return context.tell("CCR", "a trigger during a conversion is ignored");
        }
        let duration_ns = u64::from(conversions.count) * conversions.apart_ns();
        pair.busy_until = VirtualNanos(now.0 + duration_ns);
        pair.analog.convert_so(conversions);
        let codes = pair.sample(now);
        let one_stream = ccr::DAMDF.get(control) != 0;
        if pair.unread {
            pair.overrun();
            if pair.overwrites() {
                pair.take(codes, one_stream, context);
            }
            self.lines.drive(ADC1, false);
        } else if !isr::OVR.is_set(pair.converters[0].status) {
            pair.take(codes, one_stream, context);
            let moves = cfgr::DMNGT.get(pair.converters[0].configuration) & 1 == 1;
            self.lines.drive(ADC1, moves && one_stream);
        }
        if pair.interrupts_enabled() {
            pair.drive_interrupt(context);
        }
    }
}

impl Pair {
    /// The pair converts at each trigger: both enabled, the master started, on TIM6's rising edge.
    pub(super) fn armed(&self) -> bool {
        let [master, slave] = &self.converters;
        master.enabled()
            && slave.enabled()
            && cr::ADSTART.is_set(master.control)
            && cfgr::EXTEN.get(master.configuration) == RISING
            && cfgr::EXTSEL.get(master.configuration) == TIM6_TRGO
    }

    /// Both converters put new data over what nobody has read (section 25.4.27, `OVRMOD`).
    pub(super) fn overwrites(&self) -> bool {
        let mut both = self.converters.iter();
        both.all(|converter| cfgr::OVRMOD.is_set(converter.configuration))
    }

    fn take(&mut self, codes: [u16; 2], one_stream: bool, context: &mut DeviceContext<'_>) {
        let live = [self.live_channel(0), self.live_channel(1)];
        let weak = one_stream && !self.overwrites();
        for (nth, code) in codes.into_iter().enumerate() {
            let converter = &mut self.converters[nth];
            converter.data = converter.convert(live[nth], code, context);
            converter.status |= isr::EOC.mask() | isr::EOS.mask();
        }
        let slave = &mut self.converters[1];
        slave.data = self.skew.slave(slave.data, weak);
        self.unread = true;
    }

    /// Data arrived over unread data (section 25.4.27). Until the flag is cleared the DMA is not asked.
    fn overrun(&mut self) {
        for converter in &mut self.converters {
            converter.flag(isr::OVR, true);
        }
    }

    fn read_data(&mut self) -> u64 {
        for converter in &mut self.converters {
            converter.flag(isr::EOC, false);
        }
        self.unread = false;
        let [master, slave] = &self.converters;
        u64::from(slave.data) << 16 | u64::from(master.data)
    }
}

impl Device for Common {
    type Register = Register;

    fn read(
        &mut self,
        register: Register,
        _registers: &mut RegisterFile,
        _context: &mut DeviceContext<'_>,
    ) -> Option<u64> {
        match register {
            Register::Cdr => {
                let data = self.pair.lock().read_data();
                self.lines.drive(ADC1, false);
                Some(data)
            }
            Register::Csr => {
                let pair = self.pair.lock();
                Some(pair.converters[0].status | pair.converters[1].status << 16)
            }
            _ => None,
        }
    }

    fn write(
        &mut self,
        register: Register,
        value: u64,
        _registers: &mut RegisterFile,
        context: &mut DeviceContext<'_>,
    ) {
        if register != Register::Ccr {
            return;
        }
        let dual = ccr::DUAL.get(value);
        if dual != 0 && dual != REGULAR_SIMULTANEOUS {
            context.tell("CCR", "this dual mode is not modelled");
        }
        if !matches!(ccr::DAMDF.get(value), 0 | WORD_PER_PAIR) {
            context.tell("CCR", "this data format is not modelled");
        }
        self.clock(value);
    }

    fn on_clock_input(
        &mut self,
        input: usize,
        hz: u64,
        registers: &mut RegisterFile,
        _context: &mut DeviceContext<'_>,
    ) {
        match input {
            KERNEL_CLOCK => self.kernel_hz = hz,
            _ => self.bus_hz = hz,
        }
        self.clock(registers.get(Register::Ccr));
    }

    fn reset(&mut self) {
        self.lines.drive(ADC1, false);
        let mut pair = self.pair.lock();
        pair.unread = false;
        pair.busy_until = VirtualNanos(0);
    }
}
