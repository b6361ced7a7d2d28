//! The registers of ADC1 or ADC2: power, calibration, enable, start and flags.

use rigless::device::{Device, DeviceContext, RegisterFile};
use rigless::soc::stm32h743::generated::adc3::{Register, cfgr, cfgr2, cr, isr};
use rigless::soc::stm32h743::peripherals::adc::LDORDY;
use rigless::time::{EventId, VirtualNanos};

use super::{SharedPair, State};
use crate::board::flaws::Lasting;

/// Start-up of the regulator (DS12110 Rev 10, table 95, typical).
const REGULATOR_NS: u64 = 5_000;
/// Cycles of a calibration of the offset, and of one with the linearity (the same table).
const CALIBRATION_CYCLES: u64 = 1_280;
const LINEARITY_CYCLES: u64 = 165_010;

/// The model's state beside the registers.
#[derive(Debug)]
pub(crate) struct Converter {
    nth: usize,
    pair: SharedPair,
    faults: Lasting,
    regulator: Option<EventId>,
    calibration: Option<EventId>,
    enable: Option<EventId>,
}

rigless::store!(Converter {
    values: [regulator, calibration, enable],
    parts: [],
    built: [nth, pair, faults],
});

impl Converter {
    /// ADC1 is number 0, ADC2 number 1.
    pub(crate) fn new(nth: usize, pair: SharedPair, faults: Lasting) -> Self {
        Self {
            nth,
            pair,
            faults,
            regulator: None,
            calibration: None,
            enable: None,
        }
    }

    fn with_state<T>(&self, change: impl FnOnce(&mut State) -> T) -> T {
        change(&mut self.pair.lock().converters[self.nth])
    }

    fn control_written(&mut self, registers: &mut RegisterFile, context: &mut DeviceContext<'_>) {
        let mut control = registers.get(Register::Cr);
        if cr::DEEPPWD.is_set(control) {
            control &= !cr::ADVREGEN.mask();
            self.regulator = None;
        }
        if !cr::ADVREGEN.is_set(control) {
            self.with_state(|state| state.flag(&LDORDY, false));
        } else if self.regulator.is_none() && !self.with_state(|s| LDORDY.is_set(s.status)) {
            let at = VirtualNanos(context.now().0 + REGULATOR_NS);
            self.regulator = Some(context.schedule(at));
        }
        if cr::JADSTART.is_set(control) || cr::JADSTP.is_set(control) {
            context.tell("CR", "injected conversions are not modelled");
            control &= !(cr::JADSTART.mask() | cr::JADSTP.mask());
        }
        control = self.stop_or_disable(control);
        registers.set(Register::Cr, control);
        let before = self.with_state(|state| std::mem::replace(&mut state.control, control));
        if self.nth == 0 && cr::ADSTART.is_set(control & !before) {
            self.pair.lock().skew.started();
        }
        self.start_calibration(control, context);
        self.start_enable(control, context);
        self.start_conversion(registers, context);
    }

    /// `ADSTP` and `ADDIS` take effect at the write.
    fn stop_or_disable(&mut self, mut control: u64) -> u64 {
        if cr::ADSTP.is_set(control) {
            control &= !(cr::ADSTP.mask() | cr::ADSTART.mask());
        }
        if cr::ADDIS.is_set(control) {
            control &= !(cr::ADDIS.mask() | cr::ADEN.mask() | cr::ADSTART.mask());
            self.enable = None;
            self.with_state(|state| state.flag(isr::ADRDY, false));
        }
        control
    }

    fn start_calibration(&mut self, control: u64, context: &mut DeviceContext<'_>) {
        if !cr::ADCAL.is_set(control) || self.calibration.is_some() {
            return;
        }
        let cycles = match cr::ADCALLIN.is_set(control) {
            true => LINEARITY_CYCLES,
            false => CALIBRATION_CYCLES,
        };
        self.calibration = self.after_cycles(cycles, context);
    }

    fn start_enable(&mut self, control: u64, context: &mut DeviceContext<'_>) {
        let ready = self.with_state(|state| isr::ADRDY.is_set(state.status));
        let answers = self.faults.converter_answers(self.nth);
        if cr::ADEN.is_set(control) && !ready && self.enable.is_none() && answers {
            if !self.with_state(|state| LDORDY.is_set(state.status)) {
                context.tell("CR", "enabled before the regulator is ready");
            }
            self.enable = self.after_cycles(1, context);
        }
    }

    /// An event `cycles` of the analogue clock from now, none while that clock stands still.
    fn after_cycles(&self, cycles: u64, context: &mut DeviceContext<'_>) -> Option<EventId> {
        let Some(ns) = self.pair.lock().cycles_ns(cycles) else {
            context.tell("CR", "waits for a clock that stands still");
            return None;
        };
        Some(context.schedule(VirtualNanos(context.now().0 + ns)))
    }

    /// A start by software converts once; a start by trigger arms the pair.
    fn start_conversion(&mut self, registers: &mut RegisterFile, context: &mut DeviceContext<'_>) {
        let control = registers.get(Register::Cr);
        let configuration = registers.get(Register::Cfgr);
        if !cr::ADSTART.is_set(control) {
            return;
        }
        if cfgr::AWD1EN.is_set(configuration) || cfgr2::TROVS.is_set(registers.get(Register::Cfgr2))
        {
            context.tell(
                "CFGR",
                "watchdogs and a trigger for each conversion are not modelled",
            );
        }
        if cfgr::EXTEN.get(configuration) != 0 {
            return;
        }
        let mut pair = self.pair.lock();
        let code = pair.sample(context.now())[self.nth];
        let wired = pair.live_channel(self.nth);
        let state = &mut pair.converters[self.nth];
        state.data = state.convert(wired, code, context);
        state.flag(isr::EOC, true);
        state.flag(isr::EOS, true);
        state.control &= !cr::ADSTART.mask();
        registers.set(Register::Cr, state.control);
        pair.drive_interrupt(context);
    }

    /// Mirrors the registers the pair converts by.
    fn mirror(&self, registers: &RegisterFile) {
        self.with_state(|state| {
            state.configuration = registers.get(Register::Cfgr);
            state.processing = registers.get(Register::Cfgr2);
            state.interrupts = registers.get(Register::Ier);
            state.sampling = [
                registers.get(Register::Smpr1),
                registers.get(Register::Smpr2),
            ];
            state.sequence = registers.get(Register::Sqr1);
            state.preselection = registers.get(Register::Pcsel);
        });
    }
}

impl Device for Converter {
    type Register = Register;

    fn read(
        &mut self,
        register: Register,
        registers: &mut RegisterFile,
        context: &mut DeviceContext<'_>,
    ) -> Option<u64> {
        match register {
            Register::Isr => Some(self.with_state(|state| state.status)),
            Register::Cr => {
                // The pair's trigger never clears a command; software conversions did so themselves.
                Some(registers.get(Register::Cr))
            }
            Register::Dr => {
                let mut pair = self.pair.lock();
                let state = &mut pair.converters[self.nth];
                state.flag(isr::EOC, false);
                let data = state.data;
                pair.drive_interrupt(context);
                Some(u64::from(data))
            }
            _ => None,
        }
    }

    fn write(
        &mut self,
        register: Register,
        value: u64,
        registers: &mut RegisterFile,
        context: &mut DeviceContext<'_>,
    ) {
        match register {
            Register::Cr => self.control_written(registers, context),
            Register::Isr => {
                // rc_w1, but the regulator's flag (section 25.6.1).
                self.with_state(|state| state.status &= !value | LDORDY.mask());
                self.pair.lock().drive_interrupt(context);
            }
            Register::Ier => {
                self.mirror(registers);
                self.pair.lock().drive_interrupt(context);
            }
            _ => self.mirror(registers),
        }
    }

    fn on_event(
        &mut self,
        event: EventId,
        registers: &mut RegisterFile,
        context: &mut DeviceContext<'_>,
    ) {
        let event = Some(event);
        if event == self.regulator {
            self.regulator = None;
            self.with_state(|state| state.flag(&LDORDY, true));
        }
        if event == self.calibration {
            self.calibration = None;
            let control = registers.get(Register::Cr) & !cr::ADCAL.mask();
            registers.set(Register::Cr, control);
            self.with_state(|state| state.control = control);
        }
        if event == self.enable {
            self.enable = None;
            self.with_state(|state| state.flag(isr::ADRDY, true));
            self.pair.lock().drive_interrupt(context);
        }
    }

    fn reset(&mut self) {
        (self.regulator, self.calibration, self.enable) = (None, None, None);
        self.with_state(|state| *state = State::default());
    }
}
