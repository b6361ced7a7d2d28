//! ADC1 and ADC2, regular simultaneous: pairs of reference and DUT samples.
//!
//! The HAL's ring-buffered ADC does not cover dual mode, so the registers are
//! set here and the HAL only runs the DMA ring. Source: RM0433 Rev 8, 25.4.
//!
//! One pair is one word of the common data register: low half reference
//! (ADC1, master), high half device under test (ADC2), both left justified
//! offset binary.
//!
//! With one DMA stream for both and data kept in an overrun (`OVRMOD` = 0), the
//! slave's half may be that of another trigger (ES0392, "ADC slave data may be
//! shifted in Dual regular simultaneous mode"). So data are overwritten here: a
//! pair that was not fetched is lost, and `OVR`, which rises all the same, says
//! so. What the silicon does with that is not believed but looked at:
//! [`Digitiser::common_signal`].

use super::axi_sram::axi_static;
use super::common_signal::CommonSignal;
use super::converter::{NotReady, calibrate, enable};
use super::dither::Dither;
use super::sample_clock::{ADC_CLOCK_HZ, CONVERSIONS};
use super::selected::{CONVERTERS, Irqs};
use super::wiring::DigitiserParts;
use core::sync::atomic::{AtomicU32, Ordering};
use defmt::Format;
use embassy_stm32::dma::{self, ReadableRingBuffer, TransferOptions};
use embassy_stm32::pac::{
    self,
    adc::{Adc, vals},
    adccommon::vals::{Ckmode, Damdf, Dual},
};
use embassy_stm32::{peripherals, rcc};
use embassy_time::{Duration, Timer};

/// Sample pairs handed over at once: 10 ms, half of the DMA ring.
pub(crate) const BLOCK_PAIRS: usize = 500;

/// Resolution of both.
const RESOLUTION: vals::Res = match CONVERTERS.input.bits() {
    16 => vals::Res::BITS16,
    14 => vals::Res::BITS14,
    12 => vals::Res::BITS12,
    10 => vals::Res::BITS10,
    8 => vals::Res::BITS8,
    _ => panic!("the part's converters have 8, 10, 12, 14 or 16 bits"),
};
/// Places the sum of [`CONVERSIONS`] has more than one of them.
const SUM_PLACES: u8 = CONVERSIONS.trailing_zeros() as u8;
/// `tim6_trgo` among the triggers of a regular group (RM0433 Rev 8, table 209).
const TRIGGER_TIM6: u8 = 13;

axi_static!(RING: [u32; 2 * BLOCK_PAIRS]);

/// Of DMA1, as [`DigitiserParts`] has it.
const STREAM: usize = 0;

/// Why samples are missing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Format)]
pub(crate) enum DigitiserFault {
    /// The converters were not read in time.
    ConverterOverrun,
    /// A half of the ring was overwritten before it was taken.
    RingOverrun,
    /// No samples for longer than two blocks take.
    Silent,
    /// A converter did not become ready at start.
    NotReady,
}

impl From<NotReady> for DigitiserFault {
    fn from(NotReady: NotReady) -> Self {
        Self::NotReady
    }
}

/// The pair of converters with its DMA ring.
pub(crate) struct Digitiser {
    ring: ReadableRingBuffer<'static, u32>,
    common_signal: CommonSignal,
    /// Channel of the device under test.
    dut_channel: u8,
    /// Channel of ADC2 on which it hears the drive on the chip.
    drive_channel: u8,
    _dither: Dither,
}

impl Digitiser {
    /// Calibrates and arms both converters; samples come with the clock. `drive_channel` is that of ADC2 on which
    /// it hears the drive on the chip.
    ///
    /// # Errors
    /// [`DigitiserFault::NotReady`] when a converter does not answer.
    pub(crate) async fn new(
        parts: DigitiserParts,
        drive_channel: u8,
    ) -> Result<Self, DigitiserFault> {
        rcc::enable_and_reset::<peripherals::ADC1>();
        pac::ADC12_COMMON.ccr().modify(|w| {
            // Synchronous to the timer's clock, so the aperture does not jitter
            // against it.
            w.set_ckmode(Ckmode::SYNC_DIV4);
            w.set_dual(Dual::DUAL_R);
            w.set_damdf(Damdf::FORMAT32TO10);
        });
        let channels = [
            (pac::ADC1, parts.reference.channel.get_hw_channel()),
            (pac::ADC2, parts.dut.channel.get_hw_channel()),
        ];
        for (adc, channel) in channels {
            calibrate(adc, ADC_CLOCK_HZ).await?;
            enable(adc).await?;
            select(adc, channel);
        }
        pac::ADC1.cfgr().modify(|w| {
            w.set_extsel(TRIGGER_TIM6);
            w.set_exten(vals::Exten::RISING_EDGE);
            w.set_dmngt(vals::Dmngt::DMA_CIRCULAR);
        });

        let request = embassy_stm32::adc::RxDma::<peripherals::ADC1>::request(&*parts.dma);
        let channel = dma::Channel::new(parts.dma, Irqs);
        let source = pac::ADC12_COMMON.cdr().as_ptr().cast::<u32>();
        let buffer = RING.take();
        // Note(unsafe): the common data register is a valid source of words.
        let mut ring = unsafe {
            ReadableRingBuffer::new(channel, request, source, buffer, TransferOptions::default())
        };
        ring.start();
        pac::ADC1.cr().modify(|w| w.set_adstart(true));
        let common_signal = CommonSignal::new([parts.reference.pin, parts.dut.pin]);
        Ok(Self {
            ring,
            common_signal,
            dut_channel: channels[1].1,
            drive_channel,
            _dither: Dither::start(parts.dither),
        })
    }

    /// The next block of pairs, in the order they were sampled.
    ///
    /// # Errors
    /// Any fault means that pairs are missing before the next block.
    pub(crate) async fn next(
        &mut self,
        block: &mut [u32; BLOCK_PAIRS],
    ) -> Result<(), DigitiserFault> {
        read(&mut self.ring, block).await
    }

    /// The next block, taken while one signal with edges is on both inputs, for
    /// [`calib_core::alignment::judge`].
    ///
    /// # Errors
    /// As [`Self::next`].
    pub(crate) async fn common_signal(
        &mut self,
        block: &mut [u32; BLOCK_PAIRS],
    ) -> Result<(), DigitiserFault> {
        use embassy_futures::select::{Either, select};
        let read = read(&mut self.ring, block);
        let taken = match select(read, self.common_signal.play()).await {
            Either::First(taken) => taken,
            Either::Second(never) => never,
        };
        self.common_signal.rest();
        taken
    }

    /// Puts the stream right after a fault: converters stopped, stale data and
    /// flags dropped, empty ring, both armed (RM0433 Rev 8, 25.4.27).
    pub(crate) fn restart(&mut self) {
        self.stop();
        self.start();
    }

    /// The device under test's half of the pairs becomes what the drive's converter puts out on the
    /// chip, or its pin again.
    pub(crate) fn hear_drive(&mut self, on: bool) {
        self.stop();
        let channel = if on {
            self.drive_channel
        } else {
            self.dut_channel
        };
        select(pac::ADC2, channel);
        self.start();
    }

    /// From now on a sample is one conversion, which shows the dither, or all of a trigger again.
    pub(crate) fn convert_once(&mut self, once: bool) {
        self.stop();
        for adc in [pac::ADC1, pac::ADC2] {
            oversample(adc, once);
        }
        self.start();
    }

    fn stop(&mut self) {
        pac::ADC1.cr().modify(|w| w.set_adstp(vals::Adstp::STOP));
        // Those of a trigger take 13.7 us at most; the loop is bounded all the same.
        for _ in 0..10_000 {
            if pac::ADC1.cr().read().adstp() != vals::Adstp::STOP {
                break;
            }
        }
    }

    fn start(&mut self) {
        let _ = pac::ADC12_COMMON.cdr().read();
        for adc in [pac::ADC1, pac::ADC2] {
            adc.isr().write(|w| {
                w.set_ovr(true);
                w.set_eoc(true);
                w.set_eos(true);
            });
        }
        self.ring.clear();
        BLOCK_END.store(place() % PLACES, Ordering::Relaxed);
        self.ring.start();
        pac::ADC1.cr().modify(|w| w.set_adstart(true));
    }
}

/// Place in the ring behind the block that was read last.
static BLOCK_END: AtomicU32 = AtomicU32::new(0);
const PLACES: u32 = 2 * BLOCK_PAIRS as u32;

/// Place of the pair that comes next.
fn place() -> u32 {
    let left = u32::from(pac::DMA1.st(STREAM).ndtr().read().ndt());
    PLACES.saturating_sub(left)
}

/// Place in the ring behind the block that was read last.
pub(crate) fn block_end() -> u32 {
    BLOCK_END.load(Ordering::Relaxed)
}

/// Pairs taken since the block that ended there was complete.
pub(super) fn pairs_behind(block_end: u32) -> u32 {
    (place() + PLACES).saturating_sub(block_end) % PLACES
}

async fn read(
    ring: &mut ReadableRingBuffer<'static, u32>,
    block: &mut [u32; BLOCK_PAIRS],
) -> Result<(), DigitiserFault> {
    use embassy_futures::select::{Either, select};
    match select(ring.read_exact(block), Timer::after(SILENCE)).await {
        Either::Second(()) => Err(DigitiserFault::Silent),
        Either::First(Err(_)) => Err(DigitiserFault::RingOverrun),
        Either::First(Ok(_)) if converter_overrun() => Err(DigitiserFault::ConverterOverrun),
        Either::First(Ok(_)) => {
            let end = (block_end() + BLOCK_PAIRS as u32) % PLACES;
            BLOCK_END.store(end, Ordering::Relaxed);
            Ok(())
        }
    }
}

/// Without a block for this long the sample clock or the DMA has stopped.
const SILENCE: Duration = Duration::from_millis(25);

fn converter_overrun() -> bool {
    let status = pac::ADC12_COMMON.csr().read();
    status.ovr_mst() || status.ovr_slv()
}

/// The conversions of `channel` per trigger, their mean left justified in 16 bits.
fn select(adc: Adc, channel: u8) {
    adc.cfgr().modify(|w| {
        w.set_res(RESOLUTION);
        w.set_ovrmod(vals::Ovrmod::OVERWRITE);
    });
    oversample(adc, false);
    // This one alone: a channel that is preselected loads its source.
    adc.pcsel()
        .write(|w| w.set_pcsel(usize::from(channel), vals::Pcsel::PRESELECTED));
    // 1.08 us: 172 ns settle 16 bits from 47 ohm (DS12110 Rev 10, table 185);
    // docs/hardware.md says what stands at the pin. 41 cycles in all have no
    // divisor in common with the 600 of a sample, which the dither wants.
    adc.smpr(usize::from(channel / 10)).modify(|w| {
        w.set_smp(usize::from(channel % 10), vals::SampleTime::CYCLES32_5);
    });
    adc.sqr1().modify(|w| {
        w.set_l(0);
        w.set_sq(0, channel);
    });
}

/// One conversion per trigger, or the mean of all of them, left justified in 16 bits.
fn oversample(adc: Adc, once: bool) {
    let (conversions, places) = if once {
        (1, 0)
    } else {
        (CONVERSIONS, SUM_PLACES)
    };
    let spare = CONVERTERS.input.spare_bits();
    adc.cfgr2().modify(|w| {
        w.set_rovse(true);
        w.set_ovsr(conversions - 1);
        w.set_ovss(places.saturating_sub(spare));
        w.set_lshift(spare.saturating_sub(places));
    });
}
