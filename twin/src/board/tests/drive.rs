//! The drive output of DAC1.

use rigless::soc::stm32h743::generated::dac::Register;
use rigless::soc::stm32h743::generated::{DAC, DMA1, DMAMUX1, dma1, dmamux1};

use super::{RAM, Rigged, Schematic};
use crate::rig_port::DRIVE_MID_CODE;

const ENABLE: u64 = 1;
const TRIGGERED_BY_TIM6: u64 = 1 << 1 | 5 << 2;
const DMA: u64 = 1 << 12;
const UNDERRUN_INTERRUPT: u64 = 1 << 13;
const UNDERRUN: u64 = 1 << 13;

#[test]
fn a_pin_nobody_drives_is_silent() {
    let mut rigged = Rigged::new();
    rigged.run(1_000_000);
    assert_eq!(rigged.analog.drive_code(), DRIVE_MID_CODE);
    rigged.write(&DAC, Register::Dhr12r1, 4095);
    assert_eq!(
        rigged.analog.drive_code(),
        DRIVE_MID_CODE,
        "loaded, not enabled"
    );
}

/// The mistake the architecture warns of: enabled before anything is loaded, the pin gets code 0.
#[test]
fn enabling_before_loading_kicks() {
    let mut rigged = Rigged::new();
    rigged.write(&DAC, Register::Cr, ENABLE);
    assert_eq!(rigged.analog.drive_code(), 0);
}

#[test]
fn a_preloaded_channel_is_enabled_silently() {
    let mut rigged = Rigged::new();
    rigged.write(&DAC, Register::Dhr12r1, u64::from(DRIVE_MID_CODE));
    rigged.write(&DAC, Register::Cr, ENABLE | TRIGGERED_BY_TIM6);
    rigged.start_sample_clock(1280);
    rigged.run(100_000);
    assert_eq!(rigged.analog.drive_code(), DRIVE_MID_CODE);
    assert!(rigged.analog.silent_since().is_some());
}

#[test]
fn a_code_waits_for_its_trigger_and_holds_until_the_next() {
    let mut rigged = Rigged::new();
    rigged.write(&DAC, Register::Dhr12r1, 2048);
    rigged.write(&DAC, Register::Cr, ENABLE | TRIGGERED_BY_TIM6);
    rigged.start_sample_clock(1280);
    rigged.write(&DAC, Register::Dhr12r1, 3000);
    rigged.run(20_000);
    rigged.write(&DAC, Register::Dhr12r1, 1000);
    rigged.run(20_000);
    rigged
        .analog
        .advance(rigless::time::VirtualNanos(rigged.now));
    assert_eq!(rigged.told().holds, [(2048, 20_000), (3000, 20_000)]);
    assert_eq!(rigged.analog.drive_code(), 1000);
}

/// DMA1 stream 1 in circular mode plays four codes from RAM, one per trigger.
fn play(rigged: &mut Rigged, codes: [u16; 4]) {
    use dma1::Register as Dma;
    for (place, code) in codes.iter().enumerate() {
        rigged.ram.0[2 * place..2 * place + 2].copy_from_slice(&code.to_le_bytes());
    }
    rigged.write(&DMAMUX1, dmamux1::Register::DmamuxC1cr, 67);
    rigged.write(&DMA1, Dma::S1par, DAC.base + 8);
    rigged.write(&DMA1, Dma::S1m0ar, RAM);
    rigged.write(&DMA1, Dma::S1ndtr, 4);
    // Memory to peripheral, circular, memory increment, halfwords, enabled.
    let control = 0b01 << 6 | 1 << 8 | 1 << 10 | 0b01 << 11 | 0b01 << 13 | 1;
    rigged.write(&DMA1, Dma::S1cr, control);
}

#[test]
fn dma_plays_a_ring_one_code_per_trigger() {
    let mut rigged = Rigged::new();
    rigged.write(&DAC, Register::Dhr12r1, 2048);
    rigged.write(&DAC, Register::Cr, ENABLE);
    play(&mut rigged, [2100, 2200, 2300, 2400]);
    rigged.write(&DAC, Register::Cr, ENABLE | TRIGGERED_BY_TIM6 | DMA);
    rigged.start_sample_clock(1280);
    rigged.run(7 * 20_000);
    rigged
        .analog
        .advance(rigless::time::VirtualNanos(rigged.now));
    let played: Vec<u16> = rigged.told().holds.iter().map(|&(code, _)| code).collect();
    // Silence until the first trigger, mid-scale again at it, then the ring.
    assert_eq!(
        played.concat_silence(),
        [2048, 2100, 2200, 2300, 2400, 2100]
    );
    assert_eq!(rigged.analog.drive_code(), 2200);
    assert_eq!(rigged.read(&DAC, Register::Sr), 0, "no underrun");
}

/// Equal neighbours merged: the pin does not change between them.
trait ConcatSilence {
    fn concat_silence(self) -> Vec<u16>;
}

impl ConcatSilence for Vec<u16> {
    fn concat_silence(mut self) -> Vec<u16> {
        self.dedup();
        self
    }
}

#[test]
fn a_request_nobody_serves_is_an_underrun() {
    let mut rigged = Rigged::new();
    rigged.write(&DAC, Register::Dhr12r1, 2048);
    let control = ENABLE | TRIGGERED_BY_TIM6 | DMA | UNDERRUN_INTERRUPT;
    rigged.write(&DAC, Register::Cr, control);
    rigged.interrupts(54);
    rigged.start_sample_clock(1280);
    rigged.run(20_000);
    assert_eq!(rigged.read(&DAC, Register::Sr), 0);
    rigged.run(20_000);
    assert_eq!(rigged.read(&DAC, Register::Sr), UNDERRUN);
    assert_eq!(rigged.interrupts(54), [true]);
    rigged.write(&DAC, Register::Sr, UNDERRUN);
    assert_eq!(rigged.read(&DAC, Register::Sr), 0, "cleared by writing one");
}

#[test]
fn a_system_reset_lets_the_pin_float() {
    let mut rigged = Rigged::new();
    rigged.write(&DAC, Register::Dhr12r1, 3000);
    rigged.write(&DAC, Register::Cr, ENABLE);
    assert_eq!(rigged.analog.drive_code(), 3000);
    let at = rigless::time::VirtualNanos(rigged.now);
    rigless::mcu::Mcu::reset(&mut rigged.part, at, rigless::device::ResetCause::Pin);
    assert_eq!(rigged.analog.drive_code(), DRIVE_MID_CODE);
}

/// On a board that has its drive on PA5: everything of channel 2, and nothing of channel 1.
#[test]
fn the_other_channel_drives_where_the_board_has_it() {
    const UP: u32 = 16;
    let schematic = Schematic {
        drive_channel: 1,
        ..Schematic::nucleo_h743zi2()
    };
    let mut rigged = Rigged::on(schematic);
    rigged.write(&DAC, Register::Cr, ENABLE << UP);
    for (register, value, code) in [
        (Register::Dhr12r2, 3000, 3000),
        (Register::Dhr12l2, 3001 << 4, 3001),
        (Register::Dhr8r2, 0x80, 0x800),
        (Register::Dhr12rd, 3002 << 16 | 1, 3002),
        (Register::Dhr12ld, 3003 << 20 | 1, 3003),
        (Register::Dhr8rd, 0x90 << 8 | 1, 0x900),
        (Register::Dhr12r1, 1, 0x900),
    ] {
        rigged.write(&DAC, register, value);
        assert_eq!(rigged.analog.drive_code(), code, "{register:?}");
    }
    // Unserved requests, as on channel 1.
    let control = ENABLE | TRIGGERED_BY_TIM6 | DMA | UNDERRUN_INTERRUPT;
    rigged.write(&DAC, Register::Cr, control << UP);
    rigged.interrupts(54);
    rigged.start_sample_clock(1280);
    rigged.run(2 * 20_000);
    assert_eq!(rigged.read(&DAC, Register::Sr), UNDERRUN << UP);
    assert_eq!(rigged.interrupts(54), [true]);
    rigged.write(&DAC, Register::Sr, UNDERRUN << UP);
    assert_eq!(rigged.read(&DAC, Register::Sr), 0, "cleared by writing one");
}
