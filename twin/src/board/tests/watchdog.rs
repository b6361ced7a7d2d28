//! IWDG, and what the part says of a restart.

use rigless::device::ResetCause;
use rigless::soc::stm32h743::generated::iwdg::Register;
use rigless::soc::stm32h743::generated::{IWDG, RCC, rcc};

use super::Bench;

const UNLOCK: u64 = 0x5555;
const START: u64 = 0xCCCC;
const FEED: u64 = 0xAAAA;
/// `IWDG1RSTF` of `RCC_RSR` (RM0433 Rev 9, section 8.7.39).
const BY_WATCHDOG: u64 = 1 << 26;
const POWER_ON: u64 = 1 << 23;

/// Prescaler 32 and 1000 counts of the 32 kHz LSI: one second.
fn start(bench: &mut Bench) {
    bench.write(&IWDG, Register::Kr, UNLOCK);
    bench.write(&IWDG, Register::Pr, 3);
    bench.write(&IWDG, Register::Rlr, 999);
    bench.write(&IWDG, Register::Kr, START);
}

#[test]
fn a_watchdog_not_fed_restarts_the_part_and_says_so() {
    let mut bench = Bench::new();
    assert_ne!(bench.read(&RCC, rcc::Register::Rsr) & POWER_ON, 0);
    assert_eq!(bench.read(&RCC, rcc::Register::Rsr) & BY_WATCHDOG, 0);
    start(&mut bench);
    bench.run(990_000_000);
    assert!(bench.restarts.is_empty());
    bench.run(20_000_000);
    assert_eq!(bench.restarts, [ResetCause::Model("IWDG")]);
    assert_ne!(bench.read(&RCC, rcc::Register::Rsr) & BY_WATCHDOG, 0);
    bench.run(5_000_000_000);
    assert_eq!(bench.restarts.len(), 1, "it stands still after the restart");
}

#[test]
fn a_watchdog_fed_in_time_keeps_quiet() {
    let mut bench = Bench::new();
    start(&mut bench);
    for _ in 0..10 {
        bench.run(900_000_000);
        bench.write(&IWDG, Register::Kr, FEED);
    }
    assert!(bench.restarts.is_empty());
}

#[test]
fn its_settings_need_the_key() {
    let mut bench = Bench::new();
    bench.write(&IWDG, Register::Rlr, 5);
    assert_eq!(bench.read(&IWDG, Register::Rlr), 0xFFF);
    bench.write(&IWDG, Register::Kr, UNLOCK);
    bench.write(&IWDG, Register::Rlr, 5);
    assert_eq!(bench.read(&IWDG, Register::Rlr), 5);
}
