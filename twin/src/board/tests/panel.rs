//! LEDs and button.

use rigless::soc::stm32h743::generated::gpioa::Register;
use rigless::soc::stm32h743::generated::{GPIOB, GPIOC, GPIOE};
use rigless::time::VirtualNanos;

use super::super::Leds;
use super::Bench;

#[test]
fn leds_follow_their_output_pins() {
    let mut bench = Bench::new();
    assert_eq!(bench.part.leds(), Leds::default());
    bench.write(&GPIOB, Register::Moder, 1 | 1 << 28);
    bench.write(&GPIOE, Register::Moder, 1 << 2);
    bench.write(&GPIOB, Register::Bsrr, 1 << 14);
    bench.write(&GPIOE, Register::Bsrr, 1 << 1);
    let expected = Leds {
        green: false,
        yellow: true,
        red: true,
    };
    assert_eq!(bench.part.leds(), expected);
}

#[test]
fn the_button_is_high_while_pressed() {
    const BUTTON: u64 = 1 << 13;
    let mut bench = Bench::new();
    bench.write(&GPIOC, Register::Moder, 0);
    for pressed in [true, false, true] {
        bench.part.press_button(VirtualNanos(bench.now), pressed);
        let input = bench.read(&GPIOC, Register::Idr);
        assert_eq!(input & BUTTON != 0, pressed);
    }
}
