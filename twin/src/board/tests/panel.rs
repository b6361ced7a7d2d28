//! Lamps and button.

use rigless::soc::Peripheral;
use rigless::soc::stm32h743::generated::gpioa::Register;
use rigless::soc::stm32h743::generated::{GPIOB, GPIOC, GPIOE};
use rigless::time::VirtualNanos;

use super::super::Leds;
use super::super::schematic::Active;
use super::{Rigged, Schematic};

/// Ports of an output each, by number.
fn drive(rigged: &mut Rigged, port: &Peripheral, pins: u64) {
    let outputs = (0..16).filter(|pin| pins >> pin & 1 == 1);
    rigged.write(
        port,
        Register::Moder,
        outputs.map(|pin| 1 << (2 * pin)).sum(),
    );
}

#[test]
fn leds_follow_their_output_pins() {
    let mut rigged = Rigged::new();
    assert_eq!(rigged.part.leds(), Leds::default());
    drive(&mut rigged, &GPIOB, 1 | 1 << 14);
    drive(&mut rigged, &GPIOE, 1 << 1);
    rigged.write(&GPIOB, Register::Bsrr, 1 << 14);
    rigged.write(&GPIOE, Register::Bsrr, 1 << 1);
    let expected = Leds {
        green: false,
        yellow: true,
        red: true,
    };
    assert_eq!(rigged.part.leds(), expected);
}

#[test]
fn the_button_is_high_while_pressed() {
    const BUTTON: u64 = 1 << 13;
    let mut rigged = Rigged::new();
    rigged.write(&GPIOC, Register::Moder, 0);
    for pressed in [true, false, true] {
        rigged.part.press_button(VirtualNanos(rigged.now), pressed);
        let input = rigged.read(&GPIOC, Register::Idr);
        assert_eq!(input & BUTTON != 0, pressed);
    }
}

#[test]
fn lamps_and_button_to_the_other_rail_are_the_other_way_round() {
    const BUTTON: u64 = 1 << 13;
    let schematic = Schematic {
        lit: Active::Low,
        pressed: Active::Low,
        ..Schematic::nucleo_h743zi2()
    };
    let mut rigged = Rigged::on(schematic);
    assert_eq!(
        rigged.part.leds(),
        Leds::default(),
        "an input lights nothing"
    );
    drive(&mut rigged, &GPIOB, 1 | 1 << 14);
    rigged.write(&GPIOB, Register::Bsrr, 1 << 14);
    let expected = Leds {
        green: true,
        ..Leds::default()
    };
    assert_eq!(rigged.part.leds(), expected);
    rigged.write(&GPIOC, Register::Moder, 0);
    for pressed in [true, false] {
        rigged.part.press_button(VirtualNanos(rigged.now), pressed);
        let input = rigged.read(&GPIOC, Register::Idr);
        assert_eq!(input & BUTTON == 0, pressed);
    }
}
