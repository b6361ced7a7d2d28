//! TIM6.

use rigless::soc::stm32h743::generated::{TIM6, tim6::Register};

use super::Rigged;

/// 64 MHz / 1280 = 50 kHz: an update every 20 000 ns, exactly, for ever.
#[test]
fn updates_fall_on_exact_multiples_of_the_period() {
    let mut rigged = Rigged::new();
    rigged.write(&TIM6, Register::Dier, 1);
    rigged.start_sample_clock(1280);
    rigged.interrupts(54);
    for _ in 0..1000 {
        rigged.run(19_999);
        assert_eq!(
            rigged.read(&TIM6, Register::Sr),
            0,
            "not a nanosecond early"
        );
        rigged.run(1);
        assert_eq!(rigged.read(&TIM6, Register::Sr), 1);
        assert_eq!(rigged.interrupts(54), [true]);
        rigged.write(&TIM6, Register::Sr, 0);
        assert_eq!(rigged.interrupts(54), [false]);
    }
}

/// 64 MHz / 1067 is no whole number of nanoseconds: after n updates the error is still below one.
#[test]
fn a_period_of_no_whole_nanoseconds_does_not_drift() {
    let mut rigged = Rigged::new();
    rigged.start_sample_clock(1067);
    let last_ns = 1_000_000 * 1067_u64 * 1000 / 64_000;
    rigged.run(last_ns - 1);
    rigged.write(&TIM6, Register::Sr, 0);
    rigged.run(2);
    assert_eq!(rigged.read(&TIM6, Register::Sr), 1, "the millionth update");
}

#[test]
fn the_counter_counts_ticks_and_stops_when_told() {
    let mut rigged = Rigged::new();
    rigged.start_sample_clock(1280);
    rigged.run(30_000);
    assert_eq!(rigged.read(&TIM6, Register::Cnt), 640, "half a period on");
    rigged.write(&TIM6, Register::Cr1, 0);
    rigged.run(1_000_000);
    assert_eq!(rigged.read(&TIM6, Register::Cnt), 640);
    rigged.write(&TIM6, Register::Cr1, 1);
    rigged.run(10_000);
    assert_eq!(rigged.read(&TIM6, Register::Cnt), 0, "the other half");
}

/// `PSC` is buffered to the next update (RM0433 Rev 9, section 42.3.2).
#[test]
fn a_prescaler_takes_effect_at_the_next_update() {
    let mut rigged = Rigged::new();
    rigged.start_sample_clock(1280);
    rigged.write(&TIM6, Register::Psc, 1);
    rigged.run(20_000);
    rigged.write(&TIM6, Register::Sr, 0);
    rigged.run(39_999);
    assert_eq!(rigged.read(&TIM6, Register::Sr), 0);
    rigged.run(1);
    assert_eq!(rigged.read(&TIM6, Register::Sr), 1);
}
