//! The supply: its voltage detector silences the exciter before the part stops.
//!
//! Below 2.8 V the converters' reference goes with the supply and the drive
//! means nothing any more, while the core still has more than a volt to go on
//! for: time to silence the exciter and to keep the reason. Source: RM0433
//! Rev 8, sections 6.5.3 (PVD) and 20.4 (EXTI line 16).

use embassy_stm32::interrupt::{self, InterruptExt};
use embassy_stm32::pac;
use embassy_time::{Duration, Timer};

/// The highest level the detector has: 2.86 V rising, 2.76 V falling, typical
/// (DS12110 Rev 11, table 116).
const LEVEL: u8 = 0b110;
/// EXTI line of the detector.
const LINE: usize = 16;
/// A supply that comes up slowly is looked at this often.
const LOOK: Duration = Duration::from_millis(1);

/// Waits until the supply is there, then watches it from now on: when it
/// falls, the interrupt takes the panic path.
pub(super) async fn watch() {
    pac::PWR.cr1().modify(|w| {
        w.set_pls(LEVEL);
        w.set_pvde(true);
    });
    // Silent and dark meanwhile: nothing is written to flash, nothing starts.
    while pac::PWR.csr1().read().pvdo() {
        super::watchdog::pet();
        Timer::after(LOOK).await;
    }
    // The detector's output rises when the supply falls.
    pac::EXTI.rtsr(0).modify(|w| w.set_line(LINE, true));
    pac::EXTI.pr(0).write(|w| w.set_line(LINE, true));
    pac::EXTI.imr(0).modify(|w| w.set_line(LINE, true));
    interrupt::PVD_AVD.unpend();
    // Note(unsafe): its handler is the panic path, which needs nothing else.
    unsafe { interrupt::PVD_AVD.enable() };
}
