//! A channel of DAC1: the drive signal, silent unless it is told otherwise.
//!
//! Rest is mid-scale: zero volts behind the output stage. Converter and DMA
//! never stop; silence is a ring full of mid-scale codes. Source: RM0433
//! Rev 8, chapter 26.

use super::axi_sram::axi_static;
use super::digitiser::{BLOCK_PAIRS, pairs_behind};
use super::selected::{CONVERTERS, DriveChannel, Irqs};
use super::wiring::ExciterParts;
use embassy_stm32::dac::{Ch1, Ch2};
use embassy_stm32::dma::{self, TransferOptions, WritableRingBuffer};
use embassy_stm32::gpio;
use embassy_stm32::pac::{self, dac::vals::Mode};
use embassy_stm32::{peripherals, rcc};

/// Code of zero volts at the exciter.
pub(crate) const MID_SCALE: u16 = CONVERTERS.drive.mid_code();
/// The channel in the register arrays.
const CHANNEL: usize = DriveChannel::INDEX;
/// `tim6_trgo` among the DAC triggers (RM0433 Rev 8, table 223).
const TRIGGER_TIM6: u8 = 5;

const _: () = assert!(CONVERTERS.drive.bits() == 12, "DAC1 has 12 bits");

/// The output on its pin, without the buffer.
const ON_PIN: Mode = Mode::NORMAL_EXT_BUFDIS;
/// Channel of ADC2 on which it hears the output on the chip (RM0433 Rev 8, 25.4.11).
pub(super) const ADC2_CHANNEL: u8 = 16 + CHANNEL as u8;

/// Place of a channel in the register arrays.
trait Place {
    const INDEX: usize;
}

impl Place for Ch1 {
    const INDEX: usize = 0;
}

impl Place for Ch2 {
    const INDEX: usize = 1;
}

axi_static!(RING: [u16; 2 * BLOCK_PAIRS]);

/// The drive output with its DMA ring.
pub(crate) struct Exciter {
    ring: WritableRingBuffer<'static, u16>,
    /// The memory of the ring, for [`Exciter::hush`].
    memory: *mut u16,
}

// Note(unsafe): the pointer is to a static that this value alone writes.
unsafe impl Send for Exciter {}

/// The drive was written too late: the ring played a stale block.
#[derive(Clone, Copy, Debug, PartialEq, Eq, defmt::Format)]
pub(crate) struct Late;

impl Exciter {
    /// Brings the output to rest and arms it for the sample clock.
    pub(crate) fn new(parts: ExciterParts) -> Self {
        rcc::enable_and_reset::<peripherals::DAC1>();
        gpio::Flex::new(parts.pin.0).set_as_analog();
        let registers = pac::DAC1;
        // Without this the first trigger would move the reset value, full
        // negative scale, to the output: a kick of the whole armature. And before
        // the mode, which without data would make the output invalid (ES0392,
        // 2.11.1).
        preload_mid_scale();
        // Without the buffer, which is linear only to within 0.2 V of the rails
        // (DS12110 Rev 10, table 93) and disturbs VREF+ more (docs/errata.md); the
        // output stage has a high impedance.
        registers.mcr().modify(|w| w.set_mode(CHANNEL, ON_PIN));
        registers.cr().modify(|w| w.set_en(CHANNEL, true));

        let request =
            embassy_stm32::dac::Dma::<peripherals::DAC1, DriveChannel>::request(&*parts.dma);
        let channel = dma::Channel::new(parts.dma, Irqs);
        let target = registers.dhr12r(CHANNEL).as_ptr().cast::<u16>();
        let buffer = RING.take();
        buffer.fill(MID_SCALE);
        let memory = buffer.as_mut_ptr();
        // Note(unsafe): the data holding register takes halfwords; the memory
        // is a static, and both the ring and `hush` only write it volatile.
        let mut ring = unsafe {
            let buffer = core::slice::from_raw_parts_mut(memory, 2 * BLOCK_PAIRS);
            WritableRingBuffer::new(channel, request, target, buffer, TransferOptions::default())
        };
        ring.start();
        registers.cr().modify(|w| {
            w.set_tsel(CHANNEL, TRIGGER_TIM6);
            w.set_ten(CHANNEL, true);
            w.set_dmaen(CHANNEL, true);
        });
        Self { ring, memory }
    }

    /// Queues one block of codes behind the one being played.
    ///
    /// # Errors
    /// [`Late`] when the ring ran dry before; the block is not played.
    pub(crate) async fn play(&mut self, codes: &[u16; BLOCK_PAIRS]) -> Result<(), Late> {
        self.ring
            .write_exact(codes)
            .await
            .map(drop)
            .map_err(|_| Late)
    }

    /// Pairs from `block_end`, that of a block of the digitiser, to the first taken under codes that are
    /// queued now: both rings are moved by the same clock. None when the ring ran dry.
    pub(crate) fn way(&mut self, block_end: u32) -> Option<u32> {
        let queued = 2 * BLOCK_PAIRS - self.ring.len().ok()?.min(2 * BLOCK_PAIRS);
        Some(queued as u32 + pairs_behind(block_end))
    }

    /// Lets go of the pin at rest: until [`Self::connect`] only ADC2 hears what is played. Nothing else
    /// than mid-scale may have been played for two samples.
    pub(crate) fn disconnect(&mut self) {
        set_mode(Mode::NORMAL_INT_BUFDIS);
    }

    /// Takes the pin again, under the same condition.
    pub(crate) fn connect(&mut self) {
        set_mode(ON_PIN);
    }

    /// Brings the output to rest within two samples: whatever is queued
    /// becomes silence.
    ///
    /// # Timing
    /// 1000 writes of a halfword: some 10 us.
    // A function of its own: `./run no-panic` follows it.
    #[inline(never)]
    pub(crate) fn hush(&mut self) {
        for place in 0..2 * BLOCK_PAIRS {
            // Note(unsafe): inside the ring. The DMA may read either value of
            // a place being written; both are codes.
            unsafe { self.memory.add(place).write_volatile(MID_SCALE) };
        }
    }
}

/// Connects the channel to the pin or on the chip: the mode is only taken while the channel is off,
/// and the output register keeps its code meanwhile (RM0433 Rev 8, 26.4.3 and 26.7.16).
fn set_mode(mode: Mode) {
    let registers = pac::DAC1;
    registers.cr().modify(|w| w.set_en(CHANNEL, false));
    registers.mcr().modify(|w| w.set_mode(CHANNEL, mode));
    registers.cr().modify(|w| w.set_en(CHANNEL, true));
}

/// Puts mid-scale where the next conversion comes from.
fn preload_mid_scale() {
    pac::DAC1.dhr12r(CHANNEL).write(|w| w.set_dhr(MID_SCALE));
}

/// Brings the output to rest now, whatever else happens: for faults.
///
/// Detaches trigger and DMA, so that the code written is the last one.
// A function of its own: `./run no-panic` follows it.
#[inline(never)]
pub(crate) fn silence_now() {
    pac::DAC1.cr().modify(|w| {
        w.set_dmaen(CHANNEL, false);
        w.set_ten(CHANNEL, false);
    });
    preload_mid_scale();
}
