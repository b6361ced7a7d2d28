//! ADC1 and ADC2.

use rigless::soc::stm32h743::generated::adc3::Register;
use rigless::soc::stm32h743::generated::adc3_common::Register as Pair;
use rigless::soc::stm32h743::generated::{ADC1, ADC2, ADC12_COMMON, DMA1, DMAMUX1, dma1, dmamux1};
use rigless::soc::{FieldSpec, Peripheral};

use rigless::time::VirtualNanos;

use super::{RAM, Rigged};
use crate::board::PartFault;

const READY: u64 = 1;
const END_OF_CONVERSION: u64 = 1 << 2;
const OVERRUN: u64 = 1 << 4;
const REGULATOR_READY: u64 = 1 << 12;

const ENABLE: u64 = 1;
const START: u64 = 1 << 2;
const STOP: u64 = 1 << 4;
const REGULATOR: u64 = 1 << 28;
const CALIBRATE: u64 = 1 << 31;

/// Circular DMA, trigger 13 (TIM6) on the rising edge, 16 bit.
const CONFIGURATION: u64 = 0b11 | 13 << 5 | 0b01 << 10;
const SIMULTANEOUS_WORDS: u64 = 0b00110 | 0b10 << 14;
const CHANNELS: [(&Peripheral, u64); 2] = [(&ADC1, 15), (&ADC2, 10)];

/// Both converters from deep power down to enabled, as the manual's sequence has it.
pub(super) fn enable(rigged: &mut Rigged) {
    rigged.write(&ADC12_COMMON, Pair::Ccr, SIMULTANEOUS_WORDS);
    for (converter, channel) in CHANNELS {
        rigged.write(converter, Register::Cr, REGULATOR);
        rigged.run(10_000);
        assert_eq!(rigged.read(converter, Register::Isr), REGULATOR_READY);
        rigged.write(converter, Register::Cr, REGULATOR | CALIBRATE);
        assert_ne!(rigged.read(converter, Register::Cr) & CALIBRATE, 0);
        rigged.run(100_000);
        assert_eq!(rigged.read(converter, Register::Cr) & CALIBRATE, 0);
        rigged.write(converter, Register::Pcsel, 1 << channel);
        rigged.write(converter, Register::Sqr1, channel << 6);
        rigged.write(converter, Register::Smpr2, 0);
        rigged.write(converter, Register::Cr, REGULATOR | ENABLE);
        rigged.run(1_000);
        assert_eq!(rigged.read(converter, Register::Isr) & READY, READY);
    }
    rigged.write(&ADC1, Register::Cfgr, CONFIGURATION);
}

pub(super) fn start(rigged: &mut Rigged) {
    rigged.write(&ADC1, Register::Cr, REGULATOR | ENABLE | START);
    rigged.start_sample_clock(1280);
}

/// One calibration of the offset takes 1280 cycles: of 64 MHz, halved by revision V, 40 us.
#[test]
fn calibration_takes_its_cycles_of_the_halved_clock() {
    let mut rigged = Rigged::new();
    rigged.write(&ADC1, Register::Cr, REGULATOR);
    rigged.run(10_000);
    rigged.write(&ADC1, Register::Cr, REGULATOR | CALIBRATE);
    rigged.run(39_999);
    assert_ne!(rigged.read(&ADC1, Register::Cr) & CALIBRATE, 0);
    rigged.run(1);
    assert_eq!(rigged.read(&ADC1, Register::Cr) & CALIBRATE, 0);
}

#[test]
fn a_trigger_converts_both_channels_into_one_word() {
    let mut rigged = Rigged::new();
    enable(&mut rigged);
    start(&mut rigged);
    rigged.run(19_999);
    assert_eq!(rigged.told().samples, 0);
    rigged.run(1);
    assert_eq!(rigged.told().samples, 1);
    assert_ne!(rigged.read(&ADC1, Register::Isr) & END_OF_CONVERSION, 0);
    // Device under test in the upper half, reference in the lower.
    assert_eq!(rigged.read(&ADC12_COMMON, Pair::Cdr), 0x2001_1001);
    assert_eq!(rigged.read(&ADC1, Register::Isr) & END_OF_CONVERSION, 0);
}

#[test]
fn dma_fills_a_ring_with_pairs() {
    use dma1::Register as Dma;
    let mut rigged = Rigged::new();
    enable(&mut rigged);
    rigged.write(&DMAMUX1, dmamux1::Register::DmamuxC0cr, 9);
    rigged.write(&DMA1, Dma::S0par, ADC12_COMMON.base + 0xC);
    rigged.write(&DMA1, Dma::S0m0ar, RAM);
    rigged.write(&DMA1, Dma::S0ndtr, 4);
    // Peripheral to memory, circular, memory increment, words, half and full interrupts, enabled.
    let control = 1 << 8 | 1 << 10 | 0b10 << 11 | 0b10 << 13 | 0b11 << 3 | 1;
    rigged.write(&DMA1, Dma::S0cr, control);
    rigged.interrupts(11);
    start(&mut rigged);
    rigged.run(2 * 20_000);
    assert_eq!(rigged.interrupts(11), [true], "half full");
    rigged.run(3 * 20_000);
    let (words, _) = rigged.ram.0[..16].as_chunks();
    let words: Vec<u32> = words.iter().map(|word| u32::from_le_bytes(*word)).collect();
    assert_eq!(words, [0x2005_1005, 0x2002_1002, 0x2003_1003, 0x2004_1004]);
    assert_eq!(rigged.read(&ADC1, Register::Isr) & OVERRUN, 0);
}

#[test]
fn a_word_nobody_reads_is_kept_and_the_next_is_an_overrun() {
    let mut rigged = Rigged::new();
    enable(&mut rigged);
    rigged.write(&ADC1, Register::Ier, OVERRUN);
    rigged.interrupts(18);
    start(&mut rigged);
    rigged.run(2 * 20_000);
    for converter in [&ADC1, &ADC2] {
        assert_ne!(rigged.read(converter, Register::Isr) & OVERRUN, 0);
    }
    assert_eq!(rigged.interrupts(18).last(), Some(&true));
    assert_eq!(
        rigged.read(&ADC12_COMMON, Pair::Cdr),
        0x2001_1001,
        "the old word"
    );
}

#[test]
fn a_stopped_or_misconfigured_pair_converts_nothing() {
    let mut rigged = Rigged::new();
    enable(&mut rigged);
    start(&mut rigged);
    rigged.write(&ADC1, Register::Cr, REGULATOR | ENABLE | STOP);
    rigged.run(100_000);
    assert_eq!(rigged.told().samples, 0, "stopped");
    rigged.write(&ADC1, Register::Cfgr, CONFIGURATION & !(0b11 << 10));
    rigged.write(&ADC1, Register::Cfgr, CONFIGURATION ^ 1 << 5);
    rigged.write(&ADC1, Register::Cr, REGULATOR | ENABLE | START);
    rigged.run(100_000);
    assert_eq!(rigged.told().samples, 0, "another trigger is selected");
}

/// 810.5 + 8.5 cycles of 32 MHz are 25.6 us: every second trigger at 50 kHz comes too early.
#[test]
fn a_trigger_during_a_conversion_is_ignored() {
    let mut rigged = Rigged::new();
    enable(&mut rigged);
    for (converter, channel) in CHANNELS {
        rigged.write(converter, Register::Smpr2, 0b111 << (3 * (channel - 10)));
    }
    start(&mut rigged);
    for _ in 0..10 {
        rigged.run(20_000);
        rigged.read(&ADC12_COMMON, Pair::Cdr);
    }
    assert_eq!(rigged.told().samples, 5);
}

/// A channel nothing is connected to reads 0 V, whatever the rig does.
#[test]
fn the_wrong_channel_sees_nothing() {
    let mut rigged = Rigged::new();
    enable(&mut rigged);
    rigged.write(&ADC2, Register::Sqr1, 11 << 6);
    start(&mut rigged);
    rigged.run(20_000);
    assert_eq!(rigged.read(&ADC12_COMMON, Pair::Cdr), 0x0000_1001);
}

#[test]
fn fewer_bits_drop_the_lowest() {
    use rigless::soc::stm32h743::generated::adc3::cfgr;
    let resolution: &FieldSpec = cfgr::RES;
    let mut rigged = Rigged::new();
    enable(&mut rigged);
    rigged.write(&ADC1, Register::Cfgr, resolution.set(CONFIGURATION, 0b110));
    start(&mut rigged);
    rigged.run(20_000);
    // 12 bits of the reference's 0x1001, and all 16 of the other.
    assert_eq!(rigged.read(&ADC12_COMMON, Pair::Cdr), 0x2001_0100);
}

/// Tests a driver that wants one mid-scale for every width (RM0433 Rev 9, section 25.6.5).
#[test]
fn fewer_bits_may_be_left_justified() {
    use rigless::soc::stm32h743::generated::adc3::{cfgr, cfgr2};
    let mut rigged = Rigged::new();
    enable(&mut rigged);
    for (converter, configuration) in [(&ADC1, CONFIGURATION), (&ADC2, 0)] {
        let fourteen_bits = cfgr::RES.set(configuration, 0b001);
        rigged.write(converter, Register::Cfgr, fourteen_bits);
        rigged.write(converter, Register::Cfgr2, cfgr2::LSHIFT.set(0, 2));
    }
    start(&mut rigged);
    for _ in 0..3 {
        rigged.run(20_000);
        rigged.read(&ADC12_COMMON, Pair::Cdr);
    }
    rigged.run(20_000);
    // 0x2004 and 0x1004, then 0x2005 and 0x1005 without their lowest two bits.
    assert_eq!(rigged.read(&ADC12_COMMON, Pair::Cdr), 0x2004_1004);
    rigged.run(20_000);
    assert_eq!(rigged.read(&ADC12_COMMON, Pair::Cdr), 0x2004_1004);
}

/// Keeping data in an overrun with one stream is what ES0392 warns of; overwriting them is not.
#[test]
fn the_slave_of_a_part_with_the_erratum_lags_unless_data_are_overwritten() {
    for (overwrite, second) in [(0, 0x2001_1002), (1 << 12, 0x2002_1002)] {
        let mut rigged = Rigged::new();
        rigged.part.fail(VirtualNanos(0), PartFault::SlaveShifted);
        enable(&mut rigged);
        rigged.write(&ADC1, Register::Cfgr, CONFIGURATION | overwrite);
        rigged.write(&ADC2, Register::Cfgr, overwrite);
        start(&mut rigged);
        rigged.run(20_000);
        rigged.read(&ADC12_COMMON, Pair::Cdr);
        rigged.run(20_000);
        assert_eq!(rigged.read(&ADC12_COMMON, Pair::Cdr), second);
    }
}

#[test]
fn a_word_nobody_reads_is_overwritten_where_that_is_asked_for_and_told_all_the_same() {
    let mut rigged = Rigged::new();
    enable(&mut rigged);
    rigged.write(&ADC1, Register::Cfgr, CONFIGURATION | 1 << 12);
    rigged.write(&ADC2, Register::Cfgr, 1 << 12);
    start(&mut rigged);
    rigged.run(2 * 20_000);
    for converter in [&ADC1, &ADC2] {
        assert_ne!(rigged.read(converter, Register::Isr) & OVERRUN, 0);
    }
    assert_eq!(rigged.read(&ADC12_COMMON, Pair::Cdr), 0x2002_1002);
}

/// PA3 is the reference's pin. The resistors work in input mode, and not in analogue mode.
#[test]
fn the_port_pulls_at_what_a_converter_sees() {
    use rigless::soc::stm32h743::generated::{GPIOA, gpioa};
    let mut rigged = Rigged::new();
    enable(&mut rigged);
    start(&mut rigged);
    let analogue = rigged.read(&GPIOA, gpioa::Register::Moder) | 0b11 << 6;
    let mut sample = |mode: u64, resistor: u64| {
        rigged.write(&GPIOA, gpioa::Register::Moder, mode);
        rigged.write(&GPIOA, gpioa::Register::Pupdr, resistor << 6);
        rigged.run(20_000);
        rigged.read(&ADC12_COMMON, Pair::Cdr)
    };
    assert_eq!(sample(analogue, 0b01), 0x2001_1001);
    // (65 535 - 0x1002) / 41 and 0x1003 / 41 codes of the reference alone.
    let input = analogue & !(0b11 << 6);
    assert_eq!(sample(input, 0b01), 0x2002_0000 | (0x1002 + 1498));
    assert_eq!(sample(input, 0b10), 0x2003_0000 | (0x1003 - 100));
}

/// RM0433 Rev 9, section 25.4.30: 16 conversions per trigger, their sum shifted by four places.
#[test]
fn sixteen_conversions_of_a_trigger_are_one_datum_and_take_their_time() {
    use rigless::soc::stm32h743::generated::adc3::cfgr2;
    let mut rigged = Rigged::new();
    enable(&mut rigged);
    let sixteen = cfgr2::OVSS.set(cfgr2::OSR.set(1, 15), 4);
    for (converter, _) in CHANNELS {
        rigged.write(converter, Register::Cfgr2, sixteen);
    }
    start(&mut rigged);
    for _ in 0..4 {
        rigged.run(20_000);
        rigged.read(&ADC12_COMMON, Pair::Cdr);
    }
    // 16 times 1.5 + 8.5 cycles of 32 MHz are 5 us: every trigger is heard.
    assert_eq!(rigged.told().samples, 4);
    rigged.run(20_000);
    assert_eq!(rigged.read(&ADC12_COMMON, Pair::Cdr), 0x2005_1005);
    // 16 times 64.5 + 8.5 cycles are 36 us: every second comes too early.
    for (converter, channel) in CHANNELS {
        rigged.write(converter, Register::Smpr2, 0b101 << (3 * (channel - 10)));
    }
    for _ in 0..10 {
        rigged.run(20_000);
        rigged.read(&ADC12_COMMON, Pair::Cdr);
    }
    assert_eq!(rigged.told().samples, 10);
}
