//! From the table of pins in a board's file to the drivers.

use super::digitiser::DigitiserParts;
use super::exciter::ExciterParts;
use super::{Port, UsbParts};
use embassy_stm32::gpio::AnyPin;
use embassy_stm32::{Peri, peripherals};

/// The part, split into what each driver owns.
pub(crate) struct Wired {
    /// Green, yellow and red.
    pub(crate) lamps: [Peri<'static, AnyPin>; 3],
    pub(crate) button: Peri<'static, AnyPin>,
    pub(crate) digitiser: DigitiserParts,
    pub(crate) exciter: ExciterParts,
    pub(crate) port: Port,
    pub(crate) usb: UsbParts,
    pub(crate) adc3: Peri<'static, peripherals::ADC3>,
    pub(crate) tim6: Peri<'static, peripherals::TIM6>,
    pub(crate) flash: Peri<'static, peripherals::FLASH>,
    pub(crate) iwdg: Peri<'static, peripherals::IWDG1>,
}

/// Turns a board's table into the function `wire`, the interrupts `Irqs` and the
/// type `DriveChannel`.
///
/// The compiler refuses a pin its converter or serial port cannot use, and one
/// that is given twice.
macro_rules! wiring {
    (
        green: $green:ident,
        yellow: $yellow:ident,
        red: $red:ident,
        button: $button:ident,
        reference: $reference:ident,
        dut: $dut:ident,
        drive: $drive:ident by $channel:ident,
        serial: $serial:ident,
        transmit: $transmit:ident,
        receive: $receive:ident,
    ) => {
        /// Channel of DAC1 that drives the exciter.
        pub(crate) type DriveChannel = embassy_stm32::dac::$channel;

        embassy_stm32::bind_interrupts!(
            /// Interrupts the drivers of the HAL need.
            pub struct Irqs {
                FLASH => embassy_stm32::flash::InterruptHandler;
                $serial => embassy_stm32::usart::InterruptHandler<embassy_stm32::peripherals::$serial>;
                OTG_FS => embassy_stm32::usb::InterruptHandler<embassy_stm32::peripherals::USB_OTG_FS>;
                DMA1_STREAM0 => embassy_stm32::dma::InterruptHandler<embassy_stm32::peripherals::DMA1_CH0>;
                DMA1_STREAM1 => embassy_stm32::dma::InterruptHandler<embassy_stm32::peripherals::DMA1_CH1>;
                DMA1_STREAM2 => embassy_stm32::dma::InterruptHandler<embassy_stm32::peripherals::DMA1_CH2>;
                DMA1_STREAM3 => embassy_stm32::dma::InterruptHandler<embassy_stm32::peripherals::DMA1_CH3>;
            }
        );

        /// Gives every driver what it owns of the part.
        ///
        /// # Panics
        /// When the serial port takes no rate of [`crate::board::LINK_BAUD`].
        pub(crate) fn wire(p: embassy_stm32::Peripherals) -> crate::board::Wired {
            use embassy_stm32::adc::AdcChannel;
            let mut config = embassy_stm32::usart::Config::default();
            config.baudrate = crate::board::LINK_BAUD;
            let port = embassy_stm32::usart::Uart::new(
                p.$serial, p.$receive, p.$transmit, p.DMA1_CH3, p.DMA1_CH2, Irqs, config,
            );
            crate::board::Wired {
                lamps: [p.$green.into(), p.$yellow.into(), p.$red.into()],
                button: p.$button.into(),
                digitiser: crate::board::DigitiserParts {
                    _converters: (p.ADC1, p.ADC2),
                    reference: p.$reference.degrade_adc(),
                    dut: p.$dut.degrade_adc(),
                    dma: p.DMA1_CH0,
                },
                exciter: crate::board::ExciterParts {
                    _dac: p.DAC1,
                    pin: crate::board::DrivePin::new(p.$drive),
                    dma: p.DMA1_CH1,
                },
                // Note(unwrap): init; the rate is a constant.
                port: port.expect("serial port"),
                usb: crate::board::UsbParts {
                    otg: p.USB_OTG_FS,
                    d_plus: p.PA12,
                    d_minus: p.PA11,
                    _vbus: p.PA9,
                },
                adc3: p.ADC3,
                tim6: p.TIM6,
                flash: p.FLASH,
                iwdg: p.IWDG1,
            }
        }
    };
}
pub(crate) use wiring;
