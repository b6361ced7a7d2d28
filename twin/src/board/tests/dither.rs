//! TIM3 and the pin its wave is played on.

use rigless::soc::stm32h743::generated::{GPIOC, TIM3, gpioa, tim2::Register};

use super::Bench;
use crate::rig_port::Dither;

/// 64 MHz / 640: 100 kHz in PWM mode 1.
fn play(bench: &mut Bench, high_ticks: u64) {
    bench.write(&TIM3, Register::Arr, 639);
    bench.write(&TIM3, Register::Ccr1, high_ticks);
    bench.write(&TIM3, Register::Ccmr1Output, 6 << 4);
    bench.write(&TIM3, Register::Ccer, 1);
    bench.write(&TIM3, Register::Cr1, 1);
}

/// PC6 to TIM3: `MODER` an alternate function, number 2.
fn connect(bench: &mut Bench, function: u64) {
    let analogue = bench.read(&GPIOC, gpioa::Register::Moder);
    let alternate = analogue & !(0b11 << 12) | 0b10 << 12;
    bench.write(&GPIOC, gpioa::Register::Afrl, function << 24);
    bench.write(&GPIOC, gpioa::Register::Moder, alternate);
}

fn heard(bench: &mut Bench) -> Option<Dither> {
    bench.run(20_000);
    bench.told().dither
}

/// Started 5 us before the sample clock: at its pulses, 20 us apart, half of a period of 10 us is over.
#[test]
fn the_rig_hears_the_wave_with_its_phase() {
    let mut bench = Bench::new();
    connect(&mut bench, 2);
    play(&mut bench, 320);
    bench.run(5_000);
    bench.start_sample_clock(1280);
    let dither = heard(&mut bench).unwrap();
    assert_eq!(dither.frequency_hz, 100e3);
    assert!((dither.phase - 0.5).abs() < 1e-6, "{dither:?}");
    bench.write(&TIM3, Register::Cr1, 0);
    assert_eq!(heard(&mut bench), None);
}

#[test]
fn a_pin_that_is_not_the_timers_plays_nothing() {
    let mut bench = Bench::new();
    bench.start_sample_clock(1280);
    play(&mut bench, 320);
    assert_eq!(heard(&mut bench), None);
    connect(&mut bench, 3);
    assert_eq!(heard(&mut bench), None);
    connect(&mut bench, 2);
    assert!(heard(&mut bench).is_some());
}

/// The front end makes a dither of equal halves alone.
#[test]
fn a_wave_of_unequal_halves_is_none() {
    let mut bench = Bench::new();
    bench.start_sample_clock(1280);
    connect(&mut bench, 2);
    play(&mut bench, 300);
    assert_eq!(heard(&mut bench), None);
}
