//! The rail, and the detector that watches it.

use rigless::soc::stm32h743::generated::{EXTI, PWR, exti, pwr};
use rigless::time::VirtualNanos;

use super::Bench;

/// Detector on, at its highest level: 2.86 V rising, 2.76 V falling.
const DETECTOR: u64 = 1 << 4 | 0b110 << 5;
const OUTPUT: u64 = 1 << 4;
/// EXTI line 16, and the interrupt it has.
const LINE: u64 = 1 << 16;
const INTERRUPT: u16 = 1;

/// A bench whose detector interrupts on the edges `rising` selects.
fn watched(rising: u64) -> Bench {
    let mut bench = Bench::new();
    bench.write(&PWR, pwr::Register::Cr1, DETECTOR);
    bench.write(&EXTI, exti::Register::Rtsr1, rising);
    bench.write(&EXTI, exti::Register::Cpuimr1, LINE);
    bench.interrupts(INTERRUPT);
    bench
}

fn set(bench: &mut Bench, millivolts: u32) {
    let at = VirtualNanos(bench.now);
    bench.part.set_supply(at, millivolts);
    bench.settle();
}

#[test]
fn a_rail_below_the_level_interrupts_once() {
    let mut bench = watched(LINE);
    set(&mut bench, 2770);
    assert!(bench.interrupts(INTERRUPT).is_empty());
    assert_eq!(bench.read(&PWR, pwr::Register::Csr1) & OUTPUT, 0);
    set(&mut bench, 2750);
    assert_eq!(bench.interrupts(INTERRUPT), [true]);
    assert_eq!(bench.read(&PWR, pwr::Register::Csr1) & OUTPUT, OUTPUT);
    set(&mut bench, 2700);
    assert!(bench.interrupts(INTERRUPT).is_empty(), "no second edge");
    // Back above the falling level, and only then above the rising one.
    set(&mut bench, 2800);
    assert_eq!(bench.read(&PWR, pwr::Register::Csr1) & OUTPUT, OUTPUT);
    set(&mut bench, 2870);
    assert_eq!(bench.read(&PWR, pwr::Register::Csr1) & OUTPUT, 0);
}

#[test]
fn an_edge_nobody_selected_interrupts_nobody() {
    let mut bench = watched(0);
    set(&mut bench, 2000);
    assert!(bench.interrupts(INTERRUPT).is_empty());
}

#[test]
fn a_restart_does_not_raise_the_rail() {
    use rigless::device::ResetCause;
    use rigless::mcu::Mcu;
    let mut bench = watched(LINE);
    set(&mut bench, 2400);
    bench.part.reset(VirtualNanos(bench.now), ResetCause::Pin);
    bench.write(&PWR, pwr::Register::Cr1, DETECTOR);
    assert_eq!(bench.read(&PWR, pwr::Register::Csr1) & OUTPUT, OUTPUT);
}
