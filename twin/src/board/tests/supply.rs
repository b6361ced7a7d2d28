//! The rail, and the detector that watches it.

use rigless::soc::stm32h743::generated::{EXTI, PWR, exti, pwr};
use rigless::time::VirtualNanos;

use super::Rigged;

/// Detector on, at its highest level: 2.86 V rising, 2.76 V falling.
const DETECTOR: u64 = 1 << 4 | 0b110 << 5;
const OUTPUT: u64 = 1 << 4;
/// EXTI line 16, and the interrupt it has.
const LINE: u64 = 1 << 16;
const INTERRUPT: u16 = 1;

/// A part whose detector interrupts on the edges `rising` selects.
fn watched(rising: u64) -> Rigged {
    let mut rigged = Rigged::new();
    rigged.write(&PWR, pwr::Register::Cr1, DETECTOR);
    rigged.write(&EXTI, exti::Register::Rtsr1, rising);
    rigged.write(&EXTI, exti::Register::Cpuimr1, LINE);
    rigged.interrupts(INTERRUPT);
    rigged
}

fn set(rigged: &mut Rigged, millivolts: u32) {
    let at = VirtualNanos(rigged.now);
    rigged.part.set_supply(at, millivolts);
    rigged.settle();
}

#[test]
fn a_rail_below_the_level_interrupts_once() {
    let mut rigged = watched(LINE);
    set(&mut rigged, 2770);
    assert!(rigged.interrupts(INTERRUPT).is_empty());
    assert_eq!(rigged.read(&PWR, pwr::Register::Csr1) & OUTPUT, 0);
    set(&mut rigged, 2750);
    assert_eq!(rigged.interrupts(INTERRUPT), [true]);
    assert_eq!(rigged.read(&PWR, pwr::Register::Csr1) & OUTPUT, OUTPUT);
    set(&mut rigged, 2700);
    assert!(rigged.interrupts(INTERRUPT).is_empty(), "no second edge");
    // Back above the falling level, and only then above the rising one.
    set(&mut rigged, 2800);
    assert_eq!(rigged.read(&PWR, pwr::Register::Csr1) & OUTPUT, OUTPUT);
    set(&mut rigged, 2870);
    assert_eq!(rigged.read(&PWR, pwr::Register::Csr1) & OUTPUT, 0);
}

#[test]
fn an_edge_nobody_selected_interrupts_nobody() {
    let mut rigged = watched(0);
    set(&mut rigged, 2000);
    assert!(rigged.interrupts(INTERRUPT).is_empty());
}

#[test]
fn a_restart_does_not_raise_the_rail() {
    use rigless::device::ResetCause;
    use rigless::mcu::Mcu;
    let mut rigged = watched(LINE);
    set(&mut rigged, 2400);
    rigged.part.reset(VirtualNanos(rigged.now), ResetCause::Pin);
    rigged.write(&PWR, pwr::Register::Cr1, DETECTOR);
    assert_eq!(rigged.read(&PWR, pwr::Register::Csr1) & OUTPUT, OUTPUT);
}
