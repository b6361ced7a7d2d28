//! ADC3 and the temperature of the part.

use rigless::soc::stm32h743::generated::adc3::Register;
use rigless::soc::stm32h743::generated::adc3_common::Register as Common;
use rigless::soc::stm32h743::generated::{ADC3, ADC3_COMMON, RCC, rcc};

use super::Rigged;

const ENABLE: u64 = 1;
const START: u64 = 1 << 2;
const REGULATOR: u64 = 1 << 28;
const SENSOR: u64 = 18;

/// The usual 48 degrees Celsius are 18 K above the sensor's 620 mV at 30: 656 mV of 3.3 V.
#[test]
fn the_sensor_shows_how_warm_the_part_is() {
    let mut rigged = Rigged::new();
    let clocks = rigged.read(&RCC, rcc::Register::Ahb4enr);
    rigged.write(&RCC, rcc::Register::Ahb4enr, clocks | 1 << 24);
    // 64 MHz over 2, the sensor on.
    rigged.write(&ADC3_COMMON, Common::Ccr, 1 << 18 | 1 << 23);
    rigged.write(&ADC3, Register::Cr, REGULATOR);
    rigged.run(10_000);
    rigged.write(&ADC3, Register::Cr, REGULATOR | ENABLE);
    rigged.run(1_000);
    rigged.write(&ADC3, Register::Pcsel, 1 << SENSOR);
    rigged.write(&ADC3, Register::Sqr1, SENSOR << 6);
    rigged.write(&ADC3, Register::Cr, REGULATOR | ENABLE | START);
    rigged.run(20_000);
    assert_eq!(rigged.read(&ADC3, Register::Dr), 656 * 65_535 / 3300);
}
