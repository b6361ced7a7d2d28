//! The board: NUCLEO-H743ZI2 with its clocks, pins, DMA streams, interrupts.
//!
//! | function | peripheral | pin | DMA |
//! |---|---|---|---|
//! | reference channel | ADC1 INP15 | PA3 (A0) | DMA1 stream 0, pairs |
//! | device under test | ADC2 INP10 | PC0 (A1) | with ADC1 |
//! | exciter | DAC1 channel 1 | PA4 | DMA1 stream 1 |
//! | sample clock | TIM6 | | |
//! | temperature of the processor | ADC3 INP18, INP19 | | |
//! | host link | USART3 | PD8 (TX), PD9 (RX) | DMA1 streams 2, 3 |
//! | host link | OTG FS | PA11 (D-), PA12 (D+), PA9 (VBUS) | |
//! | LEDs | GPIO | PB0 green, PE1 yellow, PB14 red | |
//! | button | GPIO | PC13, active high | |
//! | records | FLASH bank 2 | | |
//! | time | TIM2 | | |
//! | watchdog | IWDG1 | | |
//! | fall of the supply | PWR (PVD), EXTI line 16 | | |

mod axi_sram;
mod cache;
mod clocks;
mod converter;
mod digitiser;
mod exciter;
mod sample_clock;
mod stack;
mod supply;
mod thermometer;
mod usb;

pub(crate) use axi_sram::{AllZero, axi_static};
pub(crate) use converter::NotReady;
pub(crate) use digitiser::{BLOCK_PAIRS, Digitiser};
pub(crate) use exciter::{Exciter, MID_SCALE, silence_now};
pub(crate) use sample_clock::{SAMPLE_RATE_HZ, SampleClock};
pub(crate) use stack::unused_bytes as unused_stack_bytes;
pub(crate) use thermometer::{SensorConverter, factory_codes};
pub(crate) use usb::{PACKET_BYTES, UsbDriver, UsbParts, UsbPort, run as run_usb, usb_port};

use digitiser::DigitiserParts;
use embassy_stm32::flash::{self, Flash};
use embassy_stm32::gpio::{AnyPin, Input, Level, Output, Pull, Speed};
use embassy_stm32::mode::Async;
use embassy_stm32::usart::{self, Uart};
use embassy_stm32::wdg::IndependentWatchdog;
use embassy_stm32::{Peri, Peripherals, bind_interrupts, dma, peripherals};
use exciter::ExciterParts;

bind_interrupts!(
    /// Interrupts the drivers of the HAL need.
    pub struct Irqs {
        FLASH => flash::InterruptHandler;
        USART3 => usart::InterruptHandler<peripherals::USART3>;
        OTG_FS => embassy_stm32::usb::InterruptHandler<peripherals::USB_OTG_FS>;
        DMA1_STREAM0 => dma::InterruptHandler<peripherals::DMA1_CH0>;
        DMA1_STREAM1 => dma::InterruptHandler<peripherals::DMA1_CH1>;
        DMA1_STREAM2 => dma::InterruptHandler<peripherals::DMA1_CH2>;
        DMA1_STREAM3 => dma::InterruptHandler<peripherals::DMA1_CH3>;
    }
);

/// Speed of the virtual COM port, baud, 8N1.
pub(crate) const LINK_BAUD: u32 = 115_200;

/// The record area: all of bank 2, as offsets in flash (see `memory.x`).
pub(crate) const RECORD_AREA: core::ops::Range<u32> = 0x10_0000..0x20_0000;

/// Longest time without a sign of life, microseconds. Until it has passed, a
/// hang that keeps the drive task from running lets the ring repeat its 20 ms.
const WATCHDOG_US: u32 = 250_000;

/// The virtual COM port.
pub(crate) type Port = Uart<'static, Async>;
/// The flash behind the archive.
pub(crate) type RecordFlash = Flash<'static>;
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

/// Lamps of the board.
pub(crate) struct Lamps {
    /// LD1: ready, or the last run passed.
    pub(crate) green: Output<'static>,
    /// LD2: measuring.
    pub(crate) yellow: Output<'static>,
    /// LD3: fault, or the last run holds a refused point.
    pub(crate) red: Output<'static>,
}

/// Everything the tasks own, wired.
pub(crate) struct Board {
    pub(crate) lamps: Lamps,
    pub(crate) button: Input<'static>,
    pub(crate) port: Port,
    pub(crate) port_buffers: PortBuffers,
    pub(crate) usb: UsbParts,
    pub(crate) digitiser: Digitiser,
    pub(crate) exciter: Exciter,
    pub(crate) sensor_converter: SensorConverter,
    pub(crate) sample_clock: SampleClock,
    pub(crate) flash: RecordFlash,
    pub(crate) watchdog: Watchdog,
}

impl Board {
    /// Starts clocks and caches and wires everything; the sample clock stands.
    ///
    /// # Panics
    /// When a converter does not answer: the board is broken, and the panic
    /// is reported after the reset.
    pub(crate) async fn start() -> Self {
        // Note(unsafe): the first thing that happens; every user comes later.
        unsafe { axi_sram::clear() };
        let p: Peripherals = embassy_stm32::init(clocks::config());
        clocks::watch();
        supply::watch().await;
        cache::enable_instruction_cache();
        let lamp = |pin: Peri<'static, AnyPin>| Output::new(pin, Level::Low, Speed::Low);
        let exciter = Exciter::new(ExciterParts {
            _dac: p.DAC1,
            pin: p.PA4,
            dma: p.DMA1_CH1,
        });
        let digitiser = Digitiser::new(DigitiserParts {
            _converters: (p.ADC1, p.ADC2),
            reference_pin: p.PA3,
            dut_pin: p.PC0,
            dma: p.DMA1_CH0,
        });
        let mut config = usart::Config::default();
        config.baudrate = LINK_BAUD;
        let port = Uart::new(p.USART3, p.PD9, p.PD8, p.DMA1_CH3, p.DMA1_CH2, Irqs, config);
        // Note(unwrap): init; each is made once, from constants.
        Self {
            lamps: Lamps {
                green: lamp(p.PB0.into()),
                yellow: lamp(p.PE1.into()),
                red: lamp(p.PB14.into()),
            },
            button: Input::new(p.PC13, Pull::Down),
            port: port.expect("USART3"),
            port_buffers: PortBuffers {
                receive: RECEIVE.take(),
                transmit: TRANSMIT.take(),
            },
            usb: UsbParts {
                otg: p.USB_OTG_FS,
                d_plus: p.PA12,
                d_minus: p.PA11,
                _vbus: p.PA9,
            },
            digitiser: digitiser.await.expect("converters"),
            exciter,
            sensor_converter: SensorConverter::new(p.ADC3),
            sample_clock: SampleClock::new(p.TIM6),
            flash: Flash::new(p.FLASH, Irqs),
            watchdog: IndependentWatchdog::new(p.IWDG1, WATCHDOG_US),
        }
    }
}
