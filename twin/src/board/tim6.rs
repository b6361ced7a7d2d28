//! TIM6, the sample clock: a basic timer whose update event triggers both converters.
//!
//! RM0433 Rev 9, chapter 42. Up-counting from 0 to `ARR` with prescaler; `PSC` takes effect at the
//! next update, `ARR` at once unless `ARPE` buffers it; update flag and interrupt; trigger output
//! (`MMS` = reset, enable or update), which the part hands to the converters ([`Tim6::take_pulse`]).
//! Updates fall on exact multiples of the timer's clock from where it was last started, so the rate
//! never drifts.
//!
//! Left out: one-pulse mode, `UIFREMAP` and the update's own DMA request; each is told to the run
//! when a firmware asks for it.

use rigless::device::{Device, DeviceContext, Level, RegisterFile};
use rigless::soc::stm32h743::generated::tim6::{Register, cr1, cr2, dier, egr, sr};
use rigless::time::{EventId, VirtualNanos};
use serde::{Deserialize, Serialize};

/// The instance's name, as listeners see it.
pub(super) const NAME: &str = "TIM6";
const UPDATE_LINE: usize = 0;
const NS_PER_S: u64 = 1_000_000_000;

/// Source of the trigger output, by `MMS`.
const MMS_RESET: u64 = 0;
const MMS_ENABLE: u64 = 1;
const MMS_UPDATE: u64 = 2;

/// The model's state beside the registers.
#[derive(Debug, Serialize, Deserialize)]
pub(super) struct Tim6 {
    clock_hz: u64,
    /// Where the running count was last based: an instant and the counter's value there.
    base: VirtualNanos,
    base_count: u64,
    /// Updates since `base`.
    updates: u64,
    prescaler: u64,
    reload: u64,
    next: Option<EventId>,
    /// A pulse that a write caused, due at once.
    written: Option<EventId>,
    /// The trigger output has pulsed, and nobody has taken it.
    pulse: Option<VirtualNanos>,
}

rigless::store!(Tim6);

impl Tim6 {
    pub(super) fn new() -> Self {
        Self {
            clock_hz: rigless::soc::stm32h743::peripherals::tim::RESET_CLOCK_HZ,
            base: VirtualNanos(0),
            base_count: 0,
            updates: 0,
            prescaler: 0,
            reload: 0xFFFF,
            next: None,
            written: None,
            pulse: None,
        }
    }

    /// The instant of a pulse of the trigger output, once.
    pub(super) fn take_pulse(&mut self) -> Option<VirtualNanos> {
        self.pulse.take()
    }

    fn period_ticks(&self) -> u64 {
        (self.reload + 1) * (self.prescaler + 1)
    }

    /// Instant `ticks` of the timer's clock after the base, rounded up to the whole nanosecond.
    fn instant(&self, ticks: u64) -> VirtualNanos {
        // Whole seconds apart: 64 bits hold the rest.
        let (seconds, rest) = (ticks / self.clock_hz, ticks % self.clock_hz);
        let ns = seconds * NS_PER_S + (rest * NS_PER_S).div_ceil(self.clock_hz);
        VirtualNanos(self.base.0 + ns)
    }

    /// Ticks of the timer's clock between the base and `now`.
    fn ticks(&self, now: VirtualNanos) -> u64 {
        let ns = u128::from(now.0.saturating_sub(self.base.0));
        (ns * u128::from(self.clock_hz) / u128::from(NS_PER_S)) as u64
    }

    fn count(&self, now: VirtualNanos, registers: &RegisterFile) -> u64 {
        if !cr1::CEN.is_set(registers.get(Register::Cr1)) || self.clock_hz == 0 {
            return self.base_count;
        }
        (self.base_count + self.ticks(now) / (self.prescaler + 1)) % (self.reload + 1)
    }

    /// Starts counting afresh from `count` at `now`.
    fn rebase(&mut self, count: u64, now: VirtualNanos) {
        self.base = now;
        self.base_count = count;
        self.updates = 0;
    }

    /// The event of the next update, where that update does nothing but pulse the trigger output: no
    /// interrupt, nothing taken over from a shadow register, nothing that is told.
    pub(super) fn plain_update(&self, registers: &RegisterFile) -> Option<EventId> {
        let shadows = (registers.get(Register::Psc), registers.get(Register::Arr));
        let pulses = cr2::MMS.get(registers.get(Register::Cr2)) == MMS_UPDATE;
        let plain = pulses
            && self.written.is_none()
            && self.pulse.is_none()
            && shadows == (self.prescaler, self.reload)
            && !cr1::UDIS.is_set(registers.get(Register::Cr1))
            && !dier::UIE.is_set(registers.get(Register::Dier));
        self.next.filter(|_| plain)
    }

    /// So many updates of [`plain_update`](Self::plain_update), whose pulses the caller makes.
    pub(super) fn pass_updates(&mut self, updates: u64, registers: &mut RegisterFile) {
        self.updates += updates;
        registers.set(Register::Sr, sr::UIF.mask());
    }

    /// Instant of the next update.
    pub(super) fn next_update(&self) -> VirtualNanos {
        self.update_after(0)
    }

    /// Instant of the update that `updates` come before.
    pub(super) fn update_after(&self, updates: u64) -> VirtualNanos {
        let already = self.base_count * (self.prescaler + 1);
        self.instant((self.updates + updates + 1) * self.period_ticks() - already)
    }

    pub(super) fn schedule(&mut self, registers: &RegisterFile, context: &mut DeviceContext<'_>) {
        let running = cr1::CEN.is_set(registers.get(Register::Cr1));
        self.next = (running && self.clock_hz > 0 && self.reload > 0)
            .then(|| context.schedule(self.next_update()));
    }

    /// The counter overflowed, or software generated an update; answers whether that is a trigger.
    fn update(&mut self, registers: &mut RegisterFile, context: &mut DeviceContext<'_>) -> bool {
        let control = registers.get(Register::Cr1);
        if cr1::UDIS.is_set(control) {
            return false;
        }
        let shadows = (registers.get(Register::Psc), registers.get(Register::Arr));
        if shadows != (self.prescaler, self.reload) {
            self.rebase(0, context.now());
            (self.prescaler, self.reload) = shadows;
        }
        registers.set(Register::Sr, sr::UIF.mask());
        self.drive_interrupt(registers, context);
        cr2::MMS.get(registers.get(Register::Cr2)) == MMS_UPDATE
    }

    /// A write causes a pulse: the part takes it at the stop this asks for.
    fn pulse_at_once(&mut self, context: &mut DeviceContext<'_>) {
        self.written = Some(context.schedule(context.now()));
    }

    fn drive_interrupt(&self, registers: &RegisterFile, context: &mut DeviceContext<'_>) {
        let enabled = dier::UIE.is_set(registers.get(Register::Dier));
        if enabled {
            let flag = sr::UIF.is_set(registers.get(Register::Sr));
            context.interrupt(UPDATE_LINE, Level::from(flag));
        }
    }

    fn control_written(&mut self, registers: &mut RegisterFile, context: &mut DeviceContext<'_>) {
        let control = registers.get(Register::Cr1);
        if cr1::OPM.is_set(control) {
            context.tell(
                "CR1",
                "one-pulse mode is not modelled (RM0433 Rev 9, 42.4.1)",
            );
        }
        let running = self.next.is_some();
        if cr1::CEN.is_set(control) && !running {
            self.rebase(self.base_count, context.now());
            if cr2::MMS.get(registers.get(Register::Cr2)) == MMS_ENABLE {
                self.pulse_at_once(context);
            }
            self.schedule(registers, context);
        }
    }
}

impl Device for Tim6 {
    type Register = Register;

    fn read(
        &mut self,
        register: Register,
        registers: &mut RegisterFile,
        context: &mut DeviceContext<'_>,
    ) -> Option<u64> {
        (register == Register::Cnt).then(|| self.count(context.now(), registers))
    }

    fn write(
        &mut self,
        register: Register,
        value: u64,
        registers: &mut RegisterFile,
        context: &mut DeviceContext<'_>,
    ) {
        let now = context.now();
        match register {
            Register::Cr1 => {
                if !cr1::CEN.is_set(registers.get(Register::Cr1)) && self.next.take().is_some() {
                    let ticks = self.ticks(now) / (self.prescaler + 1);
                    self.base_count = (self.base_count + ticks) % (self.reload + 1);
                }
                self.control_written(registers, context);
            }
            Register::Dier => {
                if dier::UDE.is_set(value) {
                    context.tell("DIER", "the update's DMA request is not modelled");
                }
                let flag = sr::UIF.is_set(registers.get(Register::Sr));
                context.interrupt(UPDATE_LINE, Level::from(flag && dier::UIE.is_set(value)));
            }
            Register::Sr => self.drive_interrupt(registers, context),
            Register::Egr if egr::UG.is_set(value) => {
                (self.prescaler, self.reload) =
                    (registers.get(Register::Psc), registers.get(Register::Arr));
                self.rebase(0, now);
                if cr1::URS.is_set(registers.get(Register::Cr1)) {
                    if cr2::MMS.get(registers.get(Register::Cr2)) == MMS_RESET {
                        self.pulse_at_once(context);
                    }
                } else if self.update(registers, context) {
                    self.pulse_at_once(context);
                }
                self.schedule(registers, context);
            }
            Register::Cnt => {
                self.rebase(value & 0xFFFF, now);
                self.schedule(registers, context);
            }
            Register::Arr if !cr1::ARPE.is_set(registers.get(Register::Cr1)) => {
                let count = self.count(now, registers);
                self.reload = value & 0xFFFF;
                self.rebase(count.min(self.reload), now);
                self.schedule(registers, context);
            }
            _ => {}
        }
    }

    fn on_event(
        &mut self,
        event: EventId,
        registers: &mut RegisterFile,
        context: &mut DeviceContext<'_>,
    ) {
        let mut pulses = self.written.take_if(|written| *written == event).is_some();
        if self.next == Some(event) {
            self.updates += 1;
            pulses |= self.update(registers, context);
            self.schedule(registers, context);
        }
        if pulses {
            self.pulse = Some(context.now());
        }
    }

    fn on_clock(&mut self, hz: u64, registers: &mut RegisterFile, context: &mut DeviceContext<'_>) {
        let count = self.count(context.now(), registers);
        self.rebase(count, context.now());
        self.clock_hz = hz;
        self.schedule(registers, context);
    }

    fn reset(&mut self) {
        *self = Self {
            clock_hz: self.clock_hz,
            ..Self::new()
        };
    }
}
