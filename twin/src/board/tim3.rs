//! TIM3, of which a channel plays the square wave for the dither.
//!
//! RM0433 Rev 9, chapter 39. Modelled: up-counting from 0 to `ARR`, the first channel in PWM mode 1 (high while
//! the counter is below `CCR1`), without events: what is on the pin at an instant follows from when it was
//! started. Only half of a period may be high, since the front end makes nothing else of it. Anything more is
//! told to the run.

use rigless::device::{Device, DeviceContext, RegisterFile};
use rigless::soc::stm32h743::generated::tim2::{Register, ccer, ccmr1_output, cr1};
use rigless::time::VirtualNanos;
use serde::{Deserialize, Serialize};

use super::analog::Wave;

/// The instance's name.
pub(super) const NAME: &str = "TIM3";
/// `OC1M` of PWM mode 1.
const PWM_MODE_1: u64 = 6;

/// The model's state beside the registers.
#[derive(Debug, Default, Serialize, Deserialize)]
pub(super) struct Tim3 {
    clock_hz: u64,
    /// Since when it has been counting.
    started: Option<VirtualNanos>,
    /// As last written: the register is two rows of the table, at one address.
    mode: u64,
    wave: Option<Wave>,
    /// Whether the wave is another than the part has taken.
    changed: bool,
}

rigless::store!(Tim3);

impl Tim3 {
    /// [`take_change`](Self::take_change) has something to hand over.
    pub(super) fn has_changed(&self) -> bool {
        self.changed
    }

    /// Wave the channel plays from now on, once after each change.
    pub(super) fn take_change(&mut self) -> Option<Option<Wave>> {
        std::mem::take(&mut self.changed).then_some(self.wave)
    }

    /// Plays nothing, which the part is to be told.
    pub(super) fn silent() -> Self {
        Self {
            clock_hz: rigless::soc::stm32h743::peripherals::tim::RESET_CLOCK_HZ,
            changed: true,
            ..Self::default()
        }
    }

    fn settle(&mut self, registers: &RegisterFile, context: &mut DeviceContext<'_>) {
        let counts = cr1::CEN.is_set(registers.get(Register::Cr1));
        self.started = self.started.filter(|_| counts);
        if counts && self.started.is_none() {
            self.started = Some(context.now());
        }
        let wave = self.wave(registers, context);
        self.changed |= wave != self.wave;
        self.wave = wave;
    }

    fn wave(&self, registers: &RegisterFile, context: &mut DeviceContext<'_>) -> Option<Wave> {
        let risen = self.started?;
        if !ccer::CC1E.is_set(registers.get(Register::Ccer)) || self.clock_hz == 0 {
            return None;
        }
        let period_ticks = registers.get(Register::Arr) + 1;
        let plain = ccmr1_output::OC1M.get(self.mode) == PWM_MODE_1
            && registers.get(Register::Psc) == 0
            && !ccer::CC1P.is_set(registers.get(Register::Ccer))
            && 2 * registers.get(Register::Ccr1) == period_ticks;
        if !plain {
            context.tell(
                "CCR1",
                "a wave that is high for other than half of a period is not modelled",
            );
            return None;
        }
        Some(Wave {
            frequency_hz: self.clock_hz as f64 / period_ticks as f64,
            risen,
        })
    }
}

impl Device for Tim3 {
    type Register = Register;

    fn write(
        &mut self,
        register: Register,
        value: u64,
        registers: &mut RegisterFile,
        context: &mut DeviceContext<'_>,
    ) {
        match register {
            Register::Ccmr1Input | Register::Ccmr1Output => self.mode = value,
            Register::Dier if value != 0 => context.tell("DIER", "requests are not modelled"),
            _ => {}
        }
        self.settle(registers, context);
    }

    fn on_clock(&mut self, hz: u64, registers: &mut RegisterFile, context: &mut DeviceContext<'_>) {
        self.clock_hz = hz;
        self.settle(registers, context);
    }

    fn reset(&mut self) {
        *self = Self {
            clock_hz: self.clock_hz,
            ..Self::silent()
        };
    }
}
