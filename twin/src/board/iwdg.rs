//! IWDG, the independent watchdog: once started, a firmware that stops feeding it restarts.
//!
//! RM0433 Rev 9, chapter 45: keys, prescaler 4 to 256, 12-bit reload, window, on the LSI clock, which
//! its start forces on. The update flags of `SR` read 0: a value written counts from the next reload.

use rigless::device::{Device, DeviceContext, Level, RegisterFile};
use rigless::soc::Layout;
use rigless::soc::stm32h743::generated::iwdg::Register;
use rigless::soc::stm32h743::peripherals::rcc::IWDG_STARTED;
use rigless::time::{EventId, VirtualNanos};

const START: u64 = 0xCCCC;
const RELOAD: u64 = 0xAAAA;
const UNLOCK: u64 = 0x5555;
const NO_WINDOW: u64 = 0xFFF;
/// The registers the key protects.
const SETTINGS: [Register; 3] = [Register::Pr, Register::Rlr, Register::Winr];
const NS_PER_S: u128 = 1_000_000_000;

/// The model's state beside the registers.
#[derive(Debug, serde::Serialize, serde::Deserialize)]
pub(super) struct Iwdg {
    lsi_hz: u64,
    started: bool,
    unlocked: bool,
    /// `PR`, `RLR` and `WINR` as last written with the key.
    accepted: [Option<u64>; 3],
    reloaded: VirtualNanos,
    expiry: Option<EventId>,
}

rigless::store!(Iwdg);

impl Iwdg {
    pub(super) fn new() -> Self {
        Self {
            lsi_hz: 0,
            started: false,
            unlocked: false,
            accepted: [None; 3],
            reloaded: VirtualNanos(0),
            expiry: None,
        }
    }

    fn prescaler(registers: &RegisterFile) -> u64 {
        4 << registers.get(Register::Pr).min(6)
    }

    fn feed(&mut self, registers: &RegisterFile, context: &mut DeviceContext<'_>) {
        self.reloaded = context.now();
        self.expiry = self
            .counts_ns(registers.get(Register::Rlr) + 1, registers)
            .map(|ns| context.schedule(VirtualNanos(context.now().0 + ns)));
    }

    fn counts_ns(&self, counts: u64, registers: &RegisterFile) -> Option<u64> {
        let ticks = u128::from(counts * Self::prescaler(registers));
        (self.lsi_hz > 0).then(|| (ticks * NS_PER_S / u128::from(self.lsi_hz)) as u64)
    }

    /// Fed while the counter is still above the window: that is a reset as well (section 45.3.2).
    fn too_early(&self, registers: &RegisterFile, now: VirtualNanos) -> bool {
        let window = registers.get(Register::Winr);
        let counts = registers.get(Register::Rlr).saturating_sub(window);
        window != NO_WINDOW
            && self
                .counts_ns(counts, registers)
                .is_some_and(|ns| now.0 < self.reloaded.0 + ns)
    }
}

impl Device for Iwdg {
    type Register = Register;

    fn write(
        &mut self,
        register: Register,
        value: u64,
        registers: &mut RegisterFile,
        context: &mut DeviceContext<'_>,
    ) {
        match (register, value) {
            (Register::Kr, key) => {
                self.unlocked = key == UNLOCK;
                match key {
                    START if !self.started => {
                        self.started = true;
                        context.request(IWDG_STARTED, Level::High);
                        self.feed(registers, context);
                    }
                    RELOAD if self.started => {
                        if self.too_early(registers, context.now()) {
                            context.request_reset();
                        }
                        self.feed(registers, context);
                    }
                    _ => {}
                }
            }
            (setting, value) => {
                let Some(place) = SETTINGS.iter().position(|known| *known == setting) else {
                    return;
                };
                if self.unlocked {
                    self.accepted[place] = Some(value);
                } else {
                    context.tell("KR", "a write without the key is ignored");
                    let kept = self.accepted[place].unwrap_or(setting.spec().reset);
                    registers.set(setting, kept);
                }
            }
        }
    }

    fn on_event(
        &mut self,
        event: EventId,
        _registers: &mut RegisterFile,
        context: &mut DeviceContext<'_>,
    ) {
        if self.started && self.expiry == Some(event) {
            context.request_reset();
        }
    }

    fn on_clock(&mut self, hz: u64, registers: &mut RegisterFile, context: &mut DeviceContext<'_>) {
        self.lsi_hz = hz;
        if self.started {
            self.feed(registers, context);
        }
    }

    fn reset(&mut self) {
        *self = Self {
            lsi_hz: self.lsi_hz,
            ..Self::new()
        };
    }
}
