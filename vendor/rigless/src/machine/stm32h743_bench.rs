// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! The smallest board there is for the STM32H743: one whole part, a rail, one crystal, a known peer
//! on every serial port and every serial interface, two on the third interface behind two chip
//! selects, two on the first inter-integrated circuit interface at a 7-bit and a 10-bit address, and
//! known voltages on the converters' pins.
//!
//! It exists to prove the part rather than to be a board, the same as the STM32F427's bench. A board's
//! sensors and its crystal are things a conformance run mustn't depend on, and a part has to be
//! provable before there's a board to put it on. So this fits the least that still lets something
//! happen: a rail, because a regulator with no supply has nothing to regulate, one crystal, because a
//! part with nothing on its oscillator pins can't run its loops, and a peer on every bus, because a bus
//! with nothing on the far end proves only that a flag moved. `I2C2` to `I2C4` carry none, so the run
//! also proves the address nothing answers on an empty bus. The card slots stay empty, since the part
//! models its card interfaces with nothing in them.
//!
//! The core is the part's own Cortex-M7, and `config` is where its facts live, so the boards built on
//! the part take the same core.

use std::num::{NonZeroU32, NonZeroU64};

use crate::chip::i2c::{Pattern as I2cPattern, TenBit};
use crate::chip::spi::Pattern;
use crate::chip::uart;
use crate::cpu::armv7::registers::{mask, set};
use crate::device::Level;
use crate::machine::armv7m;
use crate::machine::{Board, Crystal, Supply, Target};
use crate::snapshot::store;
use crate::soc::stm32h743::Stm32h743;
use crate::soc::stm32h743::peripherals::adc::Channel;
use crate::soc::stm32h743::peripherals::gpio::Pin;
use crate::soc::stm32h743::peripherals::spi::{self, Select};
use crate::soc::stm32h743::peripherals::usart;
use crate::soc::{Access, Error, FieldSpec};

/// The serial interface that carries the two selected peers, `SPI3`, by [`spi::INSTANCES`]' order.
const SELECTED: usize = 2;

/// The name `rigless run --machine` matches.
pub const NAME: &str = "stm32h743-bench";

/// The one MCU.
pub const MCU: &str = "stm32h743";

/// What every peer answers, one word per transfer, none of it a word the conformance firmware sends,
/// so a model shifting its own transmission back is caught rather than passed. The fifth is wider than
/// a byte because it's the one a sixteen-bit frame takes, and an eight-bit frame can't carry it.
pub const MISO_PATTERN: [u32; 8] = [0x5A, 0xA5, 0x3C, 0xC3, 0x1234, 0xF0, 0x6B, 0x96];

/// The third serial interface carries two peers behind two pins of port D rather than one, so the
/// bench can prove a chip select: the firmware drops one pin and must read this word, then drops the
/// other and must read the other's. Neither is in [`MISO_PATTERN`].
pub const ON_PD10: [u32; 1] = [0xD1];
/// The second of the two.
pub const ON_PD7: [u32; 1] = [0x71];

/// What the peer on every serial port answers, one word for each word it hears, and then nothing. None
/// of it is a word the conformance firmware sends. It speaks only when spoken to, since the part's ports
/// lose whatever a far end puts on the line while their receivers are off, RM0433 rev 9 section 48.5.6.
pub const RX_PATTERN: [u16; 5] = [0x1E, 0xE1, 0x2D, 0xD2, 0x4B];

/// The address the peer on `I2C1` answers to.
pub const I2C_PEER_ADDRESS: u8 = 0x50;

/// What the peer on `I2C1` answers, one byte a read, then repeating the last, none of it a byte the
/// conformance firmware writes.
pub const I2C_PATTERN: [u8; 3] = [0x2D, 0x3E, 0x4F];

/// A second `I2C1` address, past the 7-bit range, so the run also proves the 10-bit header, RM0433
/// rev 9 section 47.4.9.
pub const I2C_TEN_BIT_ADDRESS: u16 = 0x145;
/// What the 10-bit peer answers, disjoint from [`I2C_PATTERN`].
pub const I2C_TEN_BIT_PATTERN: [u8; 2] = [0x5C, 0x6D];

/// What the bench puts on every converter's pins, as a channel and its millivolts: half the rail on
/// channels 3 and 10 and a quarter on channel 5, so a converter that answered the wrong channel would
/// answer the wrong word.
pub const ON_ADC: [(u8, u32); 3] = [(3, 1650), (10, 1650), (5, 825)];

/// The core clock the conformance firmware's tree gives the part, the 400 MHz of DS12110 rev 11 table 2
/// at voltage scale 1.
const CLOCK_HZ: NonZeroU64 = NonZeroU64::new(400_000_000).expect("a running clock");
/// The reference clock of the core's timer is the core clock over eight, RM0433 rev 9 section 19.1.1
/// and figure 49.
const REFCLK_DIVIDER: NonZeroU32 = NonZeroU32::new(8).expect("a divider divides");
/// The MCU implements four priority bits, RM0433 rev 9 section 19.1.
const PRIORITY_BITS: u8 = 4;
/// The core is a Cortex-M7, DS12110 rev 11 section 3.1.
const VARIANT: armv7m::Variant = armv7m::Variant::M7;
/// The core has a double-precision FPU, DS12110 rev 11 section 3.1.
const FPU: armv7m::Fpu = armv7m::Fpu::FpV5Dp;
/// The MPU has sixteen regions, DS12110 rev 11 section 3.2.
const MPU_REGIONS: armv7m::MpuRegions = armv7m::MpuRegions::Sixteen;
/// The BOOT pin is held low, so the core boots from `BOOT_ADD0`, which ST programs to the start of the
/// main flash, RM0433 rev 9 section 2.6 and table 9.
const BOOT: &str = "flash";
/// Where the core finds its vector table at reset: `BOOT_ADD0` as ST programs it, RM0433 rev 9 table 9.
/// Address zero is the ITCM, so nothing aliases the flash there.
const VECTOR_TABLE: u32 = 0x0800_0000;
/// The core is a Cortex-M7 r1p1, ES0392 rev 15 section 2.1, so `CPUID` is Arm's implementer code,
/// variant 1, the M7's part number and revision 1, laid out as PM0253 rev 6 table 52 gives them.
const CPUID: u32 = 0x411F_C271;
/// The 16 Kbyte instruction and data caches of DS12110 rev 11 section 3.1: `CLIDR` and `CTR` as PM0253
/// rev 6 table 77 gives them, and each cache's `CCSIDR` from table 81, the data cache's first since
/// `CSSELR` selects it with zero.
const CACHES: armv7m::Caches = armv7m::Caches {
    clidr: 0x0900_0003,
    ctr: 0x8303_C003,
    ccsidr: &[0xF00F_E019, 0xF01F_E009],
};
// The fields of the access control registers, PM0253 rev 6 tables 105 to 108: `ITCMCR` and `DTCMCR`,
// `AHBPCR`, `CACR` and `AHBSCR`.
const TCM_EN: FieldSpec = FieldSpec::new("EN", 0, 1, Access::ReadWrite);
const TCM_RMW: FieldSpec = FieldSpec::new("RMW", 1, 1, Access::ReadWrite);
const TCM_RETEN: FieldSpec = FieldSpec::new("RETEN", 2, 1, Access::ReadWrite);
const TCM_SZ: FieldSpec = FieldSpec::new("SZ", 3, 4, Access::ReadOnly);
const AHBP_EN: FieldSpec = FieldSpec::new("EN", 0, 1, Access::ReadWrite);
const CACR_SIWT: FieldSpec = FieldSpec::new("SIWT", 0, 1, Access::ReadWrite);
const CACR_ECCEN: FieldSpec = FieldSpec::new("ECCEN", 1, 1, Access::ReadWrite);
const CACR_FORCEWT: FieldSpec = FieldSpec::new("FORCEWT", 2, 1, Access::ReadWrite);
const AHBS_CTL: FieldSpec = FieldSpec::new("CTL", 0, 2, Access::ReadWrite);
const AHBS_TPRI: FieldSpec = FieldSpec::new("TPRI", 2, 9, Access::ReadWrite);
const AHBS_INITCOUNT: FieldSpec = FieldSpec::new("INITCOUNT", 11, 5, Access::ReadWrite);
/// The 64 Kbyte ITCM and the 128 Kbyte DTCM of RM0433 rev 9 section 2.4, as table 105 encodes their
/// sizes.
const ITCM_64K: u32 = 0b0111;
const DTCM_128K: u32 = 0b1000;
const TCM_WRITABLE: u32 = mask(&TCM_EN) | mask(&TCM_RMW) | mask(&TCM_RETEN);
/// The access control registers of PM0253 rev 6 table 104, with the bits tables 105 to 109 make
/// writable. Every one resets to zero but the TCMs' read-only sizes and `AHBSCR`'s `INITCOUNT`,
/// whose reset value table 108 gives as `0b01`. `CACR` resets to zero, the value table 107 gives a
/// core with cache ECC, and `ABFSR` never records a fault since the runtime has no asynchronous
/// ones.
const ACCESS_CONTROL: [armv7m::ImplementationRegister; 6] = [
    register(0xF90, set(&TCM_SZ, 0, ITCM_64K), TCM_WRITABLE),
    register(0xF94, set(&TCM_SZ, 0, DTCM_128K), TCM_WRITABLE),
    register(0xF98, 0, mask(&AHBP_EN)),
    register(
        0xF9C,
        0,
        mask(&CACR_SIWT) | mask(&CACR_ECCEN) | mask(&CACR_FORCEWT),
    ),
    register(
        0xFA0,
        set(&AHBS_INITCOUNT, 0, 0b01),
        mask(&AHBS_CTL) | mask(&AHBS_TPRI) | mask(&AHBS_INITCOUNT),
    ),
    register(0xFA8, 0, 0),
];

const fn register(offset: u64, reset: u32, writable: u32) -> armv7m::ImplementationRegister {
    armv7m::ImplementationRegister {
        offset,
        reset,
        writable,
    }
}

/// The STM32H743's core as a target makes it, running at `clock_hz`: its Cortex-M7, with the
/// interrupt lines and the windows of the processor's own bus `mcu` has.
#[must_use]
pub(crate) fn config(mcu: &Stm32h743, clock_hz: NonZeroU64) -> armv7m::Config {
    let core = armv7m::Core {
        variant: VARIANT,
        clock_hz,
        interrupt_lines: NonZeroU32::new(u32::from(crate::mcu::Operate::cpu(mcu).interrupt_lines))
            .expect("an MCU with interrupts"),
        priority_bits: PRIORITY_BITS,
        refclk_divider: REFCLK_DIVIDER,
        instructions_per_second: armv7m::INSTRUCTIONS_PER_SECOND,
        boot: BOOT,
    };
    let mut config = armv7m::Config::new(
        core,
        &crate::cpu::armv7m::windows(crate::mcu::Mcu::bus(mcu)),
    );
    config.fpu = FPU;
    config.mpu_regions = MPU_REGIONS;
    config.cpuid = CPUID;
    config.caches = Some(CACHES);
    // CCR.BP always reads as one on this core, PM0253 rev 6 section 4.3.7.
    config.branch_prediction = armv7m::BranchPrediction::Always;
    config.implementation_registers = ACCESS_CONTROL.to_vec();
    config.vector_table = Some(VECTOR_TABLE);
    config
}

/// The bench.
#[derive(Debug)]
pub struct Stm32h743Bench {
    /// The microcontroller, whole and the same one any board takes.
    pub mcu: Stm32h743,
    /// The crystal the bench fits, inside the 4 to 48 MHz RM0433 rev 9 section 8.5 accepts, and at the
    /// bottom of the 8 to 16 MHz a loop's `PLLxRGE` names as its top input range, section 8.7.12.
    pub hse: Crystal,
    /// The rail the bench regulates to, which is also `VDDA` and `VREF+`, inside the 1.62 to 3.6 V
    /// DS12110 rev 11 section 3.5.1 allows each.
    pub rail: Supply,
}

impl Stm32h743Bench {
    /// The bench as it's built: the part out of reset, then the little this board fits.
    pub fn new() -> Result<Self, Error> {
        let mut bench = Self {
            mcu: Stm32h743::new()?,
            hse: Crystal(8_000_000),
            rail: Supply(3300),
        };
        bench.fit();
        Ok(bench)
    }

    /// What the bench puts on the part's pins: a crystal on the high-speed pair, nothing on the
    /// low-speed one, a rail, a peer on every serial interface and every serial port, two of them
    /// behind chip selects on the third interface, two peers on the first inter-integrated circuit
    /// interface, and known voltages on three pins of every converter.
    fn fit(&mut self) {
        self.mcu.rcc.attach_crystals(self.hse.0, Crystal::NONE.0);
        let rail = self.rail.0;
        self.mcu.set_supply(rail);
        self.mcu.set_analog_supply(rail);
        for nth in 0..spi::INSTANCES.len() {
            if nth == SELECTED {
                continue;
            }
            self.mcu.spi[nth].attach(Pattern::answering(MISO_PATTERN));
        }
        for (words, pin) in [(ON_PD10, 10), (ON_PD7, 7)] {
            self.mcu.spi[SELECTED].attach_selected(
                Pattern::answering(words),
                Select {
                    port: "GPIOD",
                    pin: Pin::new(pin).expect("a port has sixteen pins"),
                    active: Level::Low,
                },
            );
        }
        for nth in 0..usart::INSTANCES.len() {
            self.mcu.usart[nth].attach(uart::Responder::answering(RX_PATTERN));
        }
        self.mcu.i2c[0].attach(I2cPattern::answering(I2C_PEER_ADDRESS, I2C_PATTERN));
        self.mcu.i2c[0].attach(TenBit::answering(I2C_TEN_BIT_ADDRESS, I2C_TEN_BIT_PATTERN));
        // `VREF+` and `VBAT` are the rail, as a board with neither brought out has them.
        for converter in &mut self.mcu.adc {
            converter.set_reference(rail);
            converter.set_backup_battery(rail);
            for (number, millivolts) in ON_ADC {
                let channel = Channel::new(number).expect("a pin channel");
                converter.set_input(channel, millivolts);
            }
        }
    }
}

store!(Stm32h743Bench {
    values: [],
    parts: [mcu],
    built: [hse, rail],
});

impl Board for Stm32h743Bench {
    fn name(&self) -> &'static str {
        NAME
    }

    fn target_names(&self) -> Vec<&'static str> {
        vec![MCU]
    }

    fn mcu(&mut self, target: usize) -> Option<&mut dyn crate::mcu::Mcu> {
        (target == 0).then_some(&mut self.mcu)
    }

    fn targets(&mut self) -> Vec<Target<'_>> {
        let core = config(&self.mcu, CLOCK_HZ).spec();
        vec![Target::new(MCU, &mut self.mcu, core)]
    }
}

/// The bench behind the constructor table of [`crate::machine::all`].
pub fn boxed() -> Result<Box<dyn Board>, Error> {
    Ok(Box::new(Stm32h743Bench::new()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_bench_hangs_a_peer_on_every_serial_interface_and_port_the_part_carries() {
        let bench = Stm32h743Bench::new().unwrap();
        for interface in &bench.mcu.spi {
            assert!(
                interface.attached(),
                "a bus with nothing on the far end proves only that a flag moved"
            );
        }
        for port in &bench.mcu.usart {
            assert!(port.attached());
        }
    }
}
