//! IWDG, and what the part says of a restart.

use rigless::device::ResetCause;
use rigless::soc::stm32h743::generated::iwdg::Register;
use rigless::soc::stm32h743::generated::{IWDG, RCC, rcc};

use super::Rigged;

const UNLOCK: u64 = 0x5555;
const START: u64 = 0xCCCC;
const FEED: u64 = 0xAAAA;
/// `IWDG1RSTF` of `RCC_RSR` (RM0433 Rev 9, section 8.7.39).
const BY_WATCHDOG: u64 = 1 << 26;
const POWER_ON: u64 = 1 << 23;

/// Prescaler 32 and 1000 counts of the 32 kHz LSI: one second.
fn start(rigged: &mut Rigged) {
    rigged.write(&IWDG, Register::Kr, UNLOCK);
    rigged.write(&IWDG, Register::Pr, 3);
    rigged.write(&IWDG, Register::Rlr, 999);
    rigged.write(&IWDG, Register::Kr, START);
}

#[test]
fn a_watchdog_not_fed_restarts_the_part_and_says_so() {
    let mut rigged = Rigged::new();
    assert_ne!(rigged.read(&RCC, rcc::Register::Rsr) & POWER_ON, 0);
    assert_eq!(rigged.read(&RCC, rcc::Register::Rsr) & BY_WATCHDOG, 0);
    start(&mut rigged);
    rigged.run(990_000_000);
    assert!(rigged.restarts.is_empty());
    rigged.run(20_000_000);
    assert_eq!(rigged.restarts, [ResetCause::Model("IWDG")]);
    assert_ne!(rigged.read(&RCC, rcc::Register::Rsr) & BY_WATCHDOG, 0);
    rigged.run(5_000_000_000);
    assert_eq!(
        rigged.restarts.len(),
        1,
        "it stands still after the restart"
    );
}

#[test]
fn a_watchdog_fed_in_time_keeps_quiet() {
    let mut rigged = Rigged::new();
    start(&mut rigged);
    for _ in 0..10 {
        rigged.run(900_000_000);
        rigged.write(&IWDG, Register::Kr, FEED);
    }
    assert!(rigged.restarts.is_empty());
}

#[test]
fn its_settings_need_the_key() {
    let mut rigged = Rigged::new();
    rigged.write(&IWDG, Register::Rlr, 5);
    assert_eq!(rigged.read(&IWDG, Register::Rlr), 0xFFF);
    rigged.write(&IWDG, Register::Kr, UNLOCK);
    rigged.write(&IWDG, Register::Rlr, 5);
    assert_eq!(rigged.read(&IWDG, Register::Rlr), 5);
}
