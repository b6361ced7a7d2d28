//! The board: clocks, pins, DMA streams and interrupts of an STM32H743.
//!
//! Pins, clocks and scales are the data of a board, in its folder of
//! `firmware/boards`. The drivers here are the part's, the same on every board:
//!
//! | function | peripheral | DMA |
//! |---|---|---|
//! | reference channel | ADC1 | DMA1 stream 0, pairs |
//! | device under test | ADC2 | with ADC1 |
//! | exciter | a channel of DAC1 | DMA1 stream 1 |
//! | sample clock | TIM6 | |
//! | dither of both inputs | TIM3 CH1 | |
//! | temperature of the processor | ADC3 INP18, INP19 | |
//! | host link | the board's serial port | DMA1 streams 2, 3 |
//! | host link | OTG FS: PA11 (D-), PA12 (D+), PA9 (VBUS) | |
//! | lamps, button | GPIO | |
//! | records | FLASH bank 2 | |
//! | updates | FLASH bank 1 | |
//! | key | RNG | |
//! | time | TIM2 | |
//! | watchdog | IWDG1 | |
//! | fall of the supply | PWR (PVD), EXTI line 16 | |

mod axi_sram;
mod cache;
mod clocks;
mod code_flash;
mod common_signal;
mod converter;
mod description;
mod digitiser;
mod dither;
mod exciter;
mod itcm;
mod option_bytes;
mod panel;
mod random;
mod record_flash;
mod sample_clock;
mod selected;
mod stack;
mod supply;
mod thermometer;
mod usb;
mod watchdog;
mod wiring;

pub(crate) use axi_sram::{AllZero, Promise, axi_static, promise};
pub(crate) use clocks::CORE_MHZ;
pub(crate) use code_flash::{CodeFlash, running_slot};
pub(crate) use converter::NotReady;
pub(crate) use description::{Clocks, Panel, Silicon};
pub(crate) use digitiser::{BLOCK_PAIRS, Digitiser, block_end};
pub(crate) use exciter::{Exciter, MID_SCALE, silence_now};
pub(crate) use option_bytes::option_bytes;
pub(crate) use panel::{Lamp, Lamps, PushButton};
pub(crate) use random::RandomSource;
pub(crate) use record_flash::{
    RECORD_AREA, RecordFlash, finish_word, wrong_words_of_image, wrong_words_of_records,
};
pub(crate) use sample_clock::{APERTURE, SAMPLE_RATE_HZ, SampleClock};
pub(crate) use selected::{CONVERTERS, NAME};
pub(crate) use stack::unused_bytes as unused_stack_bytes;
pub(crate) use thermometer::{SensorConverter, factory_codes};
pub(crate) use usb::{
    FRAME_NUMBERS, PACKET_BYTES, UsbDriver, UsbPort, frame_number, is_addressed, run as run_usb,
    usb_port,
};
pub(crate) use wiring::{Port, UsbParts, wiring};

use crate::retained;
use calib_firmware::restarts::{LeftOut, Reached};
use embassy_stm32::peripherals;
use embassy_stm32::wdg::IndependentWatchdog;

/// Longest time without a sign of life, microseconds. Until it has passed, a
/// hang that keeps the drive task from running lets the ring repeat its 20 ms.
const WATCHDOG_US: u32 = 250_000;

/// Time of the watchdog until the tasks run: converters take 50 ms, a crystal less than 100.
const BOOT_WATCHDOG_US: u32 = 1_000_000;

/// Silicon the image is for.
#[cfg(feature = "hitl")]
pub(crate) const SILICON: Silicon = selected::CLOCKS.silicon;

/// The watchdog.
pub(crate) type Watchdog = IndependentWatchdog<'static, peripherals::IWDG1>;

/// Bytes of the ring the serial line is received into: 350 ms at 115 200 baud.
pub(crate) const RECEIVE_BYTES: usize = 4096;

axi_static!(RECEIVE: [u8; RECEIVE_BYTES]);
axi_static!(TRANSMIT: [u8; 512]);

/// Memory the port's DMA reaches.
pub(crate) struct PortBuffers {
    /// Ring of received bytes.
    pub(crate) receive: &'static mut [u8],
    /// Bytes on their way out.
    pub(crate) transmit: &'static mut [u8],
}

/// Everything the tasks own, wired.
pub(crate) struct Board {
    /// Whether there is a clock at OSC_IN; without it the part runs on its own.
    pub(crate) clocked: bool,
    pub(crate) lamps: Lamps,
    pub(crate) button: PushButton,
    pub(crate) port: Port,
    pub(crate) port_buffers: PortBuffers,
    pub(crate) usb: UsbParts,
    /// None when a converter does not answer, or when they are left out.
    pub(crate) digitiser: Option<Digitiser>,
    pub(crate) exciter: Exciter,
    pub(crate) sensor_converter: SensorConverter,
    pub(crate) sample_clock: SampleClock,
    pub(crate) flash: RecordFlash,
    pub(crate) random: RandomSource,
    pub(crate) watchdog: Watchdog,
}

/// Restarts the board: the exciter to rest, the flash left to finish its word, reset.
pub(crate) fn restart() -> ! {
    cortex_m::interrupt::disable();
    silence_now();
    finish_word();
    cortex_m::asm::dsb();
    cortex_m::peripheral::SCB::sys_reset()
}

impl Board {
    /// Starts clocks and caches and wires everything; the sample clock stands.
    ///
    /// A start that hangs is ended by the watchdog after [`BOOT_WATCHDOG_US`].
    pub(crate) async fn start(left_out: LeftOut) -> Self {
        // Note(unsafe): the first things that happen; every user comes later.
        unsafe {
            axi_sram::clear();
            itcm::load();
        }
        watchdog::unleash(BOOT_WATCHDOG_US);
        let clocked = clocks::is_clocked();
        let part = embassy_stm32::init(clocks::config(clocked));
        if clocked {
            clocks::watch();
        }
        supply::watch().await;
        cache::enable_instruction_cache();
        cache::count_cycles();
        let wired = selected::wire(part);
        let exciter = Exciter::new(wired.exciter);
        retained::enter(Reached::Converters);
        let digitiser = match left_out.has(LeftOut::CONVERTERS) {
            true => None,
            false => {
                let digitiser = Digitiser::new(wired.digitiser, exciter::ADC2_CHANNEL);
                digitiser.await.ok()
            }
        };
        retained::enter(Reached::Running);
        let [green, yellow, red] = wired.lamps.map(Lamp::new);
        Self {
            clocked,
            lamps: Lamps { green, yellow, red },
            button: PushButton::new(wired.button),
            port: wired.port,
            port_buffers: PortBuffers {
                receive: RECEIVE.take(),
                transmit: TRANSMIT.take(),
            },
            usb: wired.usb,
            digitiser,
            exciter,
            sensor_converter: SensorConverter::new(wired.adc3),
            sample_clock: SampleClock::new(wired.tim6),
            flash: RecordFlash::new(wired.flash),
            random: RandomSource::new(wired.rng),
            watchdog: IndependentWatchdog::new(wired.iwdg, WATCHDOG_US),
        }
    }
}
