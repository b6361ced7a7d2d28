//! SYSCFG, watched: since when the regulator's overdrive has been on.

use rigless::device::{Device, DeviceContext, RegisterFile};
use rigless::soc::stm32h743::generated::syscfg::Register;
use rigless::soc::stm32h743::peripherals::syscfg::{ODEN, Syscfg};
use rigless::time::VirtualNanos;

/// The emulator's SYSCFG, whose overdrive switch is watched.
#[derive(Debug, Default)]
pub(super) struct WatchedSyscfg {
    inner: Syscfg,
    since: Option<VirtualNanos>,
}

rigless::store!(WatchedSyscfg {
    values: [inner, since],
    parts: [],
    built: [],
});

impl WatchedSyscfg {
    /// Since when the overdrive has been on.
    pub(super) fn overdrive_since(&self) -> Option<VirtualNanos> {
        self.since
    }
}

impl Device for WatchedSyscfg {
    type Register = Register;

    fn write(
        &mut self,
        register: Register,
        value: u64,
        registers: &mut RegisterFile,
        context: &mut DeviceContext<'_>,
    ) {
        self.inner.write(register, value, registers, context);
        if register == Register::Pwrcr {
            let on = ODEN.is_set(value);
            self.since = on.then(|| self.since.unwrap_or(context.now()));
        }
    }

    fn reset(&mut self) {
        *self = Self::default();
    }
}
