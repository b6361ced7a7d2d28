//! ADC3: the temperature sensor in the processor, and the reference voltage
//! that says what the converter's own reference is.
//!
//! ADC3 shares neither clock settings nor registers with the pair of ADC1 and
//! ADC2, and converts only when asked: the samples of a measurement do not
//! notice. Source: RM0433 Rev 8, 25.4.

use super::converter::{NotReady, calibrate, enable, within};
use calib_core::thermometer::FactoryCodes;
use embassy_stm32::pac::{self, adc::vals, adccommon::vals::Presc};
use embassy_stm32::{Peri, peripherals, rcc};
use embassy_time::{Duration, Timer};

/// Channels of ADC3 (RM0433 Rev 8, table 205).
const SENSOR_CHANNEL: u8 = 18;
const REFERENCE_CHANNEL: u8 = 19;
/// Where the factory left its codes (DS12110 Rev 11, tables 118 and 181).
const SENSOR_AT_30_C: usize = 0x1FF1_E820;
const SENSOR_AT_110_C: usize = 0x1FF1_E840;
const REFERENCE_CODE: usize = 0x1FF1_E860;
/// Sensor and reference have started (DS12110 Rev 11, tables 117 and 180: less
/// than 50 us).
const START_UP: Duration = Duration::from_micros(100);
/// The internal oscillator's 64 MHz, halved; revision V halves it once more.
const CLOCK_HZ: u32 = 32_000_000;
/// A conversion takes 52 us.
const CONVERSION_LIMIT: Duration = Duration::from_millis(2);

/// Codes of the sensor and of the reference, read one after the other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct SensorCodes {
    pub(crate) sensor: u16,
    pub(crate) reference: u16,
}

/// ADC3, owned so that nothing else reprograms it.
pub(crate) struct SensorConverter {
    _adc: Peri<'static, peripherals::ADC3>,
}

impl SensorConverter {
    /// The converter before [`Self::start`].
    pub(crate) fn new(adc: Peri<'static, peripherals::ADC3>) -> Self {
        Self { _adc: adc }
    }

    /// Powers and calibrates the converter; 10 ms, most of it waiting.
    ///
    /// # Errors
    /// [`NotReady`] when it does not answer.
    pub(crate) async fn start(&mut self) -> Result<(), NotReady> {
        rcc::enable_and_reset::<peripherals::ADC3>();
        pac::ADC3_COMMON.ccr().modify(|w| {
            w.set_presc(Presc::DIV2);
            w.set_vsenseen(true);
            w.set_vrefen(true);
        });
        calibrate(pac::ADC3, CLOCK_HZ).await?;
        enable(pac::ADC3).await?;
        pac::ADC3.cfgr().modify(|w| w.set_res(vals::Res::BITS16));
        for channel in [SENSOR_CHANNEL, REFERENCE_CHANNEL].map(usize::from) {
            pac::ADC3
                .pcsel()
                .modify(|w| w.set_pcsel(channel, vals::Pcsel::PRESELECTED));
            // 810.5 cycles, 51 us: the sensor wants 9 us (DS12110 Rev 11, table 180).
            pac::ADC3.smpr(1).modify(|w| {
                w.set_smp(channel - 10, vals::SampleTime::CYCLES810_5);
            });
        }
        Timer::after(START_UP).await;
        Ok(())
    }

    /// Converts both.
    ///
    /// # Errors
    /// [`NotReady`] when the converter does not answer.
    pub(crate) async fn read(&mut self) -> Result<SensorCodes, NotReady> {
        Ok(SensorCodes {
            sensor: convert(SENSOR_CHANNEL).await?,
            reference: convert(REFERENCE_CHANNEL).await?,
        })
    }
}

async fn convert(channel: u8) -> Result<u16, NotReady> {
    let adc = pac::ADC3;
    adc.sqr1().modify(|w| {
        w.set_l(0);
        w.set_sq(0, channel);
    });
    adc.isr().write(|w| {
        w.set_eoc(true);
        w.set_eos(true);
    });
    adc.cr().modify(|w| w.set_adstart(true));
    within(CONVERSION_LIMIT, || adc.isr().read().eoc()).await?;
    Ok(adc.dr().read().rdata())
}

/// Codes the factory read.
pub(crate) fn factory_codes() -> FactoryCodes {
    // Note(unsafe): halfwords of the system memory, which every part has.
    let code = |address: usize| unsafe { (address as *const u16).read_volatile() };
    FactoryCodes {
        at_30_c: code(SENSOR_AT_30_C),
        at_110_c: code(SENSOR_AT_110_C),
        reference: code(REFERENCE_CODE),
    }
}
