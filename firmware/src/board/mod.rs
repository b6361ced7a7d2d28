//! The board: NUCLEO-H743ZI2 with its clocks, pins, DMA streams, interrupts.
//!
//! | function | peripheral | pin | DMA |
//! |---|---|---|---|
//! | reference channel | ADC1 INP15 | PA3 (A0) | DMA1 stream 0, pairs |
//! | device under test | ADC2 INP10 | PC0 (A1) | with ADC1 |
//! | exciter | DAC1 channel 1 | PA4 | DMA1 stream 1 |
//! | sample clock | TIM6 | | |
//! | host link | USART3 | PD8 (TX), PD9 (RX) | DMA1 streams 2, 3 |
//! | LEDs | GPIO | PB0 green, PE1 yellow, PB14 red | |
//! | button | GPIO | PC13, active high | |
//! | time | TIM2 | | |

mod cache;
mod clocks;

pub(crate) use clocks::TIMER_HZ;

use embassy_stm32::gpio::{Level, Output, Speed};
use embassy_stm32::mode::Async;
use embassy_stm32::usart::{self, Uart};
use embassy_stm32::{bind_interrupts, dma, peripherals};

bind_interrupts!(
    /// Interrupts the drivers of the HAL need.
    pub struct Irqs {
        USART3 => usart::InterruptHandler<peripherals::USART3>;
        DMA1_STREAM0 => dma::InterruptHandler<peripherals::DMA1_CH0>;
        DMA1_STREAM1 => dma::InterruptHandler<peripherals::DMA1_CH1>;
        DMA1_STREAM2 => dma::InterruptHandler<peripherals::DMA1_CH2>;
        DMA1_STREAM3 => dma::InterruptHandler<peripherals::DMA1_CH3>;
    }
);

/// Speed of the virtual COM port, baud, 8N1.
pub(crate) const LINK_BAUD: u32 = 115_200;

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
    /// Lamps.
    pub(crate) lamps: Lamps,
    /// Virtual COM port.
    pub(crate) link: Uart<'static, Async>,
}

impl Board {
    /// Starts clocks and caches, and wires every pin.
    pub(crate) fn start() -> Self {
        let p = embassy_stm32::init(clocks::config());
        cache::enable_instruction_cache();

        let lamp = |level| (level, Speed::Low);
        let (off, speed) = lamp(Level::Low);
        let lamps = Lamps {
            green: Output::new(p.PB0, off, speed),
            yellow: Output::new(p.PE1, off, speed),
            red: Output::new(p.PB14, off, speed),
        };

        let mut config = usart::Config::default();
        config.baudrate = LINK_BAUD;
        // Note(unwrap): init; the baud rate is a constant the part can make.
        let link = Uart::new(p.USART3, p.PD9, p.PD8, p.DMA1_CH3, p.DMA1_CH2, Irqs, config).unwrap();
        Self { lamps, link }
    }
}
