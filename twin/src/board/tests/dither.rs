//! TIM3 and the pin its wave is played on.

use rigless::soc::stm32h743::generated::{GPIOC, TIM3, gpioa, tim2::Register};

use super::Rigged;
use crate::rig_port::Dither;

/// 64 MHz / 640: 100 kHz in PWM mode 1.
fn play(rigged: &mut Rigged, high_ticks: u64) {
    rigged.write(&TIM3, Register::Arr, 639);
    rigged.write(&TIM3, Register::Ccr1, high_ticks);
    rigged.write(&TIM3, Register::Ccmr1Output, 6 << 4);
    rigged.write(&TIM3, Register::Ccer, 1);
    rigged.write(&TIM3, Register::Cr1, 1);
}

/// PC6 to TIM3: `MODER` an alternate function, number 2.
fn connect(rigged: &mut Rigged, function: u64) {
    let analogue = rigged.read(&GPIOC, gpioa::Register::Moder);
    let alternate = analogue & !(0b11 << 12) | 0b10 << 12;
    rigged.write(&GPIOC, gpioa::Register::Afrl, function << 24);
    rigged.write(&GPIOC, gpioa::Register::Moder, alternate);
}

fn heard(rigged: &mut Rigged) -> Option<Dither> {
    rigged.run(20_000);
    rigged.told().dither
}

/// Started 5 us before the sample clock: at its pulses, 20 us apart, half of a period of 10 us is over.
#[test]
fn the_rig_hears_the_wave_with_its_phase() {
    let mut rigged = Rigged::new();
    connect(&mut rigged, 2);
    play(&mut rigged, 320);
    rigged.run(5_000);
    rigged.start_sample_clock(1280);
    let dither = heard(&mut rigged).unwrap();
    assert_eq!(dither.frequency_hz, 100e3);
    assert!((dither.phase - 0.5).abs() < 1e-6, "{dither:?}");
    rigged.write(&TIM3, Register::Cr1, 0);
    assert_eq!(heard(&mut rigged), None);
}

#[test]
fn a_pin_that_is_not_the_timers_plays_nothing() {
    let mut rigged = Rigged::new();
    rigged.start_sample_clock(1280);
    play(&mut rigged, 320);
    assert_eq!(heard(&mut rigged), None);
    connect(&mut rigged, 3);
    assert_eq!(heard(&mut rigged), None);
    connect(&mut rigged, 2);
    assert!(heard(&mut rigged).is_some());
}

/// The front end makes a dither of equal halves alone.
#[test]
fn a_wave_of_unequal_halves_is_none() {
    let mut rigged = Rigged::new();
    rigged.start_sample_clock(1280);
    connect(&mut rigged, 2);
    play(&mut rigged, 300);
    assert_eq!(heard(&mut rigged), None);
}
