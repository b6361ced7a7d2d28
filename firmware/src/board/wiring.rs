//! From the table of pins in a board's file to the drivers.

use calib_protocol::health::Work;
use embassy_stm32::adc::{AdcChannel, AnyAdcChannel, Instance};
use embassy_stm32::dac::{Channel, DacPin};
use embassy_stm32::gpio::{self, AnyPin};
use embassy_stm32::mode::Async;
use embassy_stm32::peripherals::{PA9, PA11, PA12, USB_OTG_FS};
use embassy_stm32::timer::simple_pwm::{PwmPin, PwmPinConfig};
use embassy_stm32::timer::{self, TimerPin};
use embassy_stm32::usart::Uart;
use embassy_stm32::{Peri, peripherals};

/// Speed of the serial port, baud, 8N1.
pub(crate) const LINK_BAUD: u32 = 115_200;

/// Interrupts as work that is timed.
pub(crate) const UART: usize = Work::UartInterrupt as usize;
pub(crate) const USB: usize = Work::UsbInterrupt as usize;
pub(crate) const DMA: usize = Work::DmaInterrupt as usize;

/// The serial port.
pub(crate) type Port = Uart<'static, Async>;

/// Peripherals and pins of the digitiser.
pub(crate) struct DigitiserParts {
    /// Held, so that nothing else reprograms the converters.
    pub(crate) _converters: (
        Peri<'static, peripherals::ADC1>,
        Peri<'static, peripherals::ADC2>,
    ),
    pub(crate) reference: InputPin<peripherals::ADC1>,
    pub(crate) dut: InputPin<peripherals::ADC2>,
    pub(crate) dither: DitherParts,
    pub(crate) dma: Peri<'static, peripherals::DMA1_CH0>,
}

/// Peripheral and pin of the dither.
pub(crate) struct DitherParts {
    /// Held, so that nothing else reprograms the timer.
    _timer: Peri<'static, peripherals::TIM3>,
    _pin: PwmPin<'static, peripherals::TIM3, timer::Ch1>,
}

impl DitherParts {
    /// The compiler refuses a pin that the timer's first channel does not drive.
    pub(crate) fn new(
        timer: Peri<'static, peripherals::TIM3>,
        pin: Peri<'static, impl TimerPin<peripherals::TIM3, timer::Ch1>>,
    ) -> Self {
        // Slow edges: an input is not far.
        let config = PwmPinConfig {
            output_type: gpio::OutputType::PushPull,
            speed: gpio::Speed::Low,
            pull: gpio::Pull::None,
        };
        Self {
            _timer: timer,
            _pin: PwmPin::new_with_config(pin, config),
        }
    }
}

/// The pin of an input of the converter `T`.
pub(crate) struct InputPin<T: 'static> {
    pub(super) channel: AnyAdcChannel<'static, T>,
    pub(super) pin: gpio::Flex<'static>,
}

impl<T: Instance> InputPin<T> {
    /// The compiler refuses a pin that leads to no channel of the converter.
    pub(crate) fn new<P>(pin: Peri<'static, P>) -> Self
    where
        P: gpio::Pin,
        Peri<'static, P>: AdcChannel<T>,
    {
        // Note(unsafe): a channel is a number; the port is `pin`'s alone.
        let channel = unsafe { pin.clone_unchecked() }.degrade_adc();
        Self {
            channel,
            pin: gpio::Flex::new(pin),
        }
    }
}

/// Peripherals and pins of the exciter.
pub(crate) struct ExciterParts {
    /// Held, so that nothing else reprograms the converter.
    pub(crate) _dac: Peri<'static, peripherals::DAC1>,
    pub(crate) pin: DrivePin,
    pub(crate) dma: Peri<'static, peripherals::DMA1_CH1>,
}

/// The pin of the exciter.
pub(crate) struct DrivePin(pub(super) Peri<'static, AnyPin>);

impl DrivePin {
    /// The compiler refuses a pin that `C`, a channel of DAC1, does not drive.
    pub(crate) fn new<C: Channel, P>(pin: Peri<'static, P>) -> Self
    where
        P: DacPin<peripherals::DAC1, C> + gpio::Pin,
    {
        Self(pin.into())
    }
}

/// Peripherals and pins of the port.
pub(crate) struct UsbParts {
    pub(crate) otg: Peri<'static, USB_OTG_FS>,
    pub(crate) d_plus: Peri<'static, PA12>,
    pub(crate) d_minus: Peri<'static, PA11>,
    /// Watched by the peripheral itself.
    pub(crate) _vbus: Peri<'static, PA9>,
}

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
    pub(crate) rng: Peri<'static, peripherals::RNG>,
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
        dither: $dither:ident,
        serial: $serial:ident,
        transmit: $transmit:ident,
        receive: $receive:ident,
    ) => {
        /// Channel of DAC1 that drives the exciter.
        pub(crate) type DriveChannel = embassy_stm32::dac::$channel;

        use crate::board::wiring::{DMA, UART, USB};
        use crate::timing::{Begin, End};

        embassy_stm32::bind_interrupts!(
            /// Interrupts the drivers of the HAL need.
            pub struct Irqs {
                $serial => Begin<UART>, embassy_stm32::usart::InterruptHandler<embassy_stm32::peripherals::$serial>, End<UART>;
                OTG_FS => Begin<USB>, embassy_stm32::usb::InterruptHandler<embassy_stm32::peripherals::USB_OTG_FS>, End<USB>;
                DMA1_STREAM0 => Begin<DMA>, embassy_stm32::dma::InterruptHandler<embassy_stm32::peripherals::DMA1_CH0>, End<DMA>;
                DMA1_STREAM1 => Begin<DMA>, embassy_stm32::dma::InterruptHandler<embassy_stm32::peripherals::DMA1_CH1>, End<DMA>;
                DMA1_STREAM2 => Begin<DMA>, embassy_stm32::dma::InterruptHandler<embassy_stm32::peripherals::DMA1_CH2>, End<DMA>;
                DMA1_STREAM3 => Begin<DMA>, embassy_stm32::dma::InterruptHandler<embassy_stm32::peripherals::DMA1_CH3>, End<DMA>;
            }
        );

        /// Gives every driver what it owns of the part.
        ///
        /// # Panics
        /// When the serial port takes no rate of [`crate::board::wiring::LINK_BAUD`].
        pub(crate) fn wire(p: embassy_stm32::Peripherals) -> crate::board::wiring::Wired {
            let mut config = embassy_stm32::usart::Config::default();
            config.baudrate = crate::board::wiring::LINK_BAUD;
            let port = embassy_stm32::usart::Uart::new(
                p.$serial, p.$receive, p.$transmit, p.DMA1_CH3, p.DMA1_CH2, Irqs, config,
            );
            crate::board::wiring::Wired {
                lamps: [p.$green.into(), p.$yellow.into(), p.$red.into()],
                button: p.$button.into(),
                digitiser: crate::board::wiring::DigitiserParts {
                    _converters: (p.ADC1, p.ADC2),
                    reference: crate::board::wiring::InputPin::new(p.$reference),
                    dut: crate::board::wiring::InputPin::new(p.$dut),
                    dither: crate::board::wiring::DitherParts::new(p.TIM3, p.$dither),
                    dma: p.DMA1_CH0,
                },
                exciter: crate::board::wiring::ExciterParts {
                    _dac: p.DAC1,
                    pin: crate::board::wiring::DrivePin::new::<DriveChannel, _>(p.$drive),
                    dma: p.DMA1_CH1,
                },
                // Note(unwrap): init; the rate is a constant.
                port: port.expect("serial port"),
                usb: crate::board::wiring::UsbParts {
                    otg: p.USB_OTG_FS,
                    d_plus: p.PA12,
                    d_minus: p.PA11,
                    _vbus: p.PA9,
                },
                adc3: p.ADC3,
                tim6: p.TIM6,
                flash: p.FLASH,
                rng: p.RNG,
                iwdg: p.IWDG1,
            }
        }
    };
}
pub(crate) use wiring;
