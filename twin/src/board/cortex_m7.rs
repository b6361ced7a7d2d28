//! The part's core: a Cortex-M7 r1p1 with double-precision FPU, as the emulator is to make it.

use std::num::{NonZeroU32, NonZeroU64};
use std::sync::Arc;

use rigless::cpu;
use rigless::emulator::{CoreSpec, Processor};
use rigless::image::Image;
use rigless::machine::armv7m;
use rigless::mcu::{Mcu, Operate};

use super::flash_bus::FlashBus;
use super::part::Part;
use super::pins::SUPPLY_MV;

/// SYSCLK of the shipping firmware, which drives SysTick alone (480 MHz, VOS0).
const CLOCK_HZ: NonZeroU64 = NonZeroU64::new(480_000_000).expect("not zero");

/// Instructions per second of a core that takes so many cycles for each: 3 is one that runs from flash
/// with wait states and without a cache.
#[must_use]
pub fn instructions_per_s(cycles_per_instruction: NonZeroU64) -> u64 {
    CLOCK_HZ.get() / cycles_per_instruction
}

/// Reference clock of SysTick is the core clock over this (RM0433 Rev 9, section 19.1.1).
const REFCLK_DIVIDER: NonZeroU32 = NonZeroU32::new(8).expect("not zero");
const PRIORITY_BITS: u8 = 4;
/// `BOOT_ADD0` as the vendor programs it (RM0433 Rev 9, table 9).
const VECTOR_TABLE: u32 = 0x0800_0000;
/// Unique device identity (RM0433 Rev 9, section 61.1): wafer position and number, then the lot's
/// name in ASCII. A lot no wafer fab has.
const UNIQUE_ID: [u8; 12] = *b"\x23\x00\x41\x00\x07TWIN01 ";
const UNIQUE_ID_AT: u64 = 0x1FF1_E800;
/// Flash size in KiB (section 61.2).
const FLASH_SIZE_KIB: u16 = 2048;
const FLASH_SIZE_AT: u64 = 0x1FF1_E880;
/// Codes the factory reads of the temperature sensor at 30 and 110 degrees Celsius and of the internal
/// reference, with 3.3 V as the converter's reference, in 16 bits (DS12110 Rev 11, tables 118 and 181):
/// 620 mV, 780 mV (2 mV/K) and 1216 mV, the typical values of tables 180 and 117, which the emulator's
/// ADC3 converts.
const FACTORY_CODES: [(u64, u32); 3] =
    [(0x1FF1_E820, 620), (0x1FF1_E840, 780), (0x1FF1_E860, 1216)];
/// ES0392 Rev 15, section 2.1, in the layout of PM0253 Rev 6, table 52.
const CPUID: u32 = 0x411F_C271;

/// 16 KiB of instruction and data cache (PM0253 Rev 6, tables 77 and 81). The emulated core reports
/// them and caches nothing: cache maintenance is accepted, coherency mistakes stay invisible.
const CACHES: armv7m::Caches = armv7m::Caches {
    clidr: 0x0900_0003,
    ctr: 0x8303_C003,
    ccsidr: &[0xF00F_E019, 0xF01F_E009],
};

/// `ITCMCR`, `DTCMCR`, `AHBPCR`, `CACR`, `AHBSCR` and `ABFSR` as offset, reset value and writable
/// bits (PM0253 Rev 6, tables 104 to 109).
const ACCESS_CONTROL: [(u64, u32, u32); 6] = [
    (0xF90, 0b0111 << 3, 0b111),
    (0xF94, 0b1000 << 3, 0b111),
    (0xF98, 0, 0b1),
    (0xF9C, 0, 0b111),
    (0xFA0, 1 << 11, 0xFFFF),
    (0xFA8, 0, 0),
];

/// The core of `part` as the emulator makes it.
pub(super) fn spec(part: &Part, shortcuts: bool) -> CoreSpec {
    let lines = u32::from(Operate::cpu(part).interrupt_lines);
    let core = armv7m::Core {
        variant: armv7m::Variant::M7,
        clock_hz: CLOCK_HZ,
        interrupt_lines: NonZeroU32::new(lines).unwrap_or(NonZeroU32::MIN),
        priority_bits: PRIORITY_BITS,
        refclk_divider: REFCLK_DIVIDER,
        instructions_per_second: NonZeroU64::new(part.instructions_per_s())
            .unwrap_or(NonZeroU64::MIN),
        boot: "flash",
    };
    let mut config = armv7m::Config::new(core, &cpu::armv7m::windows(Mcu::bus(part)));
    config.fpu = armv7m::Fpu::FpV5Dp;
    config.mpu_regions = armv7m::MpuRegions::Sixteen;
    config.cpuid = CPUID;
    config.caches = Some(CACHES);
    config.branch_prediction = armv7m::BranchPrediction::Always;
    config.implementation_registers = ACCESS_CONTROL
        .iter()
        .map(
            |&(offset, reset, writable)| armv7m::ImplementationRegister {
                offset,
                reset,
                writable,
            },
        )
        .collect();
    config.vector_table = Some(VECTOR_TABLE);
    config.shortcuts = shortcuts;
    let mut spec = config.spec();
    let core = Arc::clone(&spec.processor);
    let flash = part.flash_watch();
    spec.processor = Arc::new(move |endian| {
        let core = FlashBus::new(core(endian)?, flash.clone());
        Ok(Box::new(core) as Box<dyn Processor>)
    });
    spec.factory_images = factory_images();
    spec
}

/// Content of the system memory as the vendor programs it: the part's identity, its flash size, and codes of
/// its sensors.
fn factory_images() -> Vec<Image> {
    let code = |millivolt: u32| (millivolt * 0xFFFF / SUPPLY_MV) as u16;
    let sensors = FACTORY_CODES.map(|(at, millivolt)| (at, code(millivolt).to_le_bytes().to_vec()));
    [
        (UNIQUE_ID_AT, UNIQUE_ID.to_vec()),
        (FLASH_SIZE_AT, FLASH_SIZE_KIB.to_le_bytes().to_vec()),
    ]
    .into_iter()
    .chain(sensors)
    .filter_map(|(address, bytes)| {
        let name = std::path::Path::new("system memory");
        Image::new(name, bytes, Some(address)).ok()
    })
    .collect()
}
