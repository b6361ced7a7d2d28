//! ADC1 and ADC2, the two simultaneously sampling converters, and their common block.
//!
//! RM0433 Rev 9, chapter 25, for silicon revision V. Modelled: deep power down, regulator start-up,
//! calibration and enable with the datasheet's times; dual regular simultaneous mode (`DUAL` = 6) of
//! one conversion per trigger on TIM6's trigger output, with the pair's 32-bit data register, its DMA
//! request, end-of-conversion and overrun flags and the pair's interrupt; a single software-started
//! conversion of one converter. Resolution, left shift, oversampling of all conversions by one trigger, sampling time, clock and `OVRMOD` are honoured: a
//! trigger during a conversion is ignored, and the run is told. A part may have the slave's data beside
//! those of another trigger (`skew`).
//!
//! A conversion samples at its trigger and its data is there at once: for a chain of which both
//! channels share every delay, the 1 to 5 microseconds of a conversion change nothing but the age of
//! a sample. Left out, and told: injected groups, watchdogs, offsets, sequences of more
//! than one conversion, the other dual modes.
//!
//! - [`Converter`]: the registers of ADC1 or ADC2.
//! - [`Common`]: the registers of the pair, trigger and DMA request.
//! - `Pair`, here: what the two converters and the common block share.

mod common;
mod converter;
mod skew;
mod stretch;

use std::sync::{Arc, Mutex, MutexGuard};

use rigless::device::{DeviceContext, Level};
use rigless::snapshot::{self, Reader, Store, Writer};
use rigless::soc::FieldSpec;
use rigless::soc::stm32h743::generated::adc3::{cfgr, cfgr2, cr, isr};
use rigless::time::VirtualNanos;

pub(super) use common::Common;
pub(super) use converter::Converter;
pub(super) use stretch::Stretch;

use self::skew::Skew;
use super::analog::{Analog, Pins};
use super::flaws::{self, Flaws};
use super::input_pin::Pull;
use crate::rig_port::{Conversions, INPUT_CHANNELS};

/// The pair's instance name, as listeners see it.
pub(super) const NAME: &str = "ADC12_Common";
/// Position of the pair's interrupt in each of its instances.
const PAIR_LINE: usize = 0;

/// Channel of ADC2 with the DAC's first channel; the second is beside it (RM0433 Rev 8, 25.4.11).
const ADC2_HEARS_DAC: u64 = 16;

const NS_PER_S: u128 = 1_000_000_000;

/// Half cycles of the analogue clock each `SMP` code samples for (RM0433 Rev 9, section 25.6.6).
const SAMPLING_HALF_CYCLES: [u64; 8] = [3, 5, 17, 33, 65, 129, 775, 1621];

/// State shared by both converters and their common block.
#[derive(Debug)]
struct Pair {
    analog: Analog,
    flaws: Flaws,
    /// Channel of ADC2 on which it hears the drive on the chip.
    internal: u64,
    /// Channel of each converter that is wired to a connector.
    wired: [u64; 2],
    /// Both converters run at half the clock they are given.
    halves_clock: bool,
    /// The analogue clock both converters run on, 0 while it stands still.
    clock_hz: u64,
    converters: [State; 2],
    /// Data not yet read from the pair's register.
    unread: bool,
    busy_until: VirtualNanos,
    /// Pulls of the ports on the pins of reference and device under test.
    pulls: [Pull; INPUT_CHANNELS],
    skew: Skew,
}

/// One converter's registers as the pair needs them: the register file belongs to its instance.
#[derive(Debug, Clone, Copy, Default, serde::Serialize, serde::Deserialize)]
struct State {
    control: u64,
    configuration: u64,
    processing: u64,
    status: u64,
    interrupts: u64,
    sampling: [u64; 2],
    sequence: u64,
    preselection: u64,
    data: u16,
}

/// A shared handle of the pair.
#[derive(Debug, Clone)]
pub(super) struct SharedPair(Arc<Mutex<Pair>>);

rigless::store!(Pair {
    values: [clock_hz, converters, unread, busy_until, pulls, skew],
    parts: [],
    built: [analog, flaws, internal, wired, halves_clock],
});

impl Store for SharedPair {
    fn store(&self, to: &mut Writer) -> Result<(), snapshot::Error> {
        self.lock().store(to)
    }

    fn load(&mut self, from: &mut Reader) -> Result<(), snapshot::Error> {
        self.lock().load(from)
    }
}

impl SharedPair {
    pub(super) fn new(
        analog: Analog,
        flaws: Flaws,
        drive: usize,
        wired: [u64; 2],
        halves_clock: bool,
    ) -> Self {
        Self(Arc::new(Mutex::new(Pair {
            analog,
            flaws,
            internal: ADC2_HEARS_DAC + drive as u64,
            wired,
            halves_clock,
            clock_hz: 0,
            converters: [State::default(); 2],
            unread: false,
            busy_until: VirtualNanos(0),
            pulls: [Pull::None; INPUT_CHANNELS],
            skew: Skew::default(),
        })))
    }

    fn lock(&self) -> MutexGuard<'_, Pair> {
        self.0
            .lock()
            .unwrap_or_else(std::sync::PoisonError::into_inner)
    }
}

impl State {
    fn enabled(&self) -> bool {
        cr::ADEN.is_set(self.control) && isr::ADRDY.is_set(self.status)
    }

    fn flag(&mut self, field: &FieldSpec, up: bool) {
        self.status = field.set(self.status, u64::from(up));
    }

    /// The one channel of the sequence, or `None` for a longer sequence.
    fn channel(&self) -> Option<u64> {
        let length = self.sequence & 0xF;
        (length == 0).then_some((self.sequence >> 6) & 0x1F)
    }

    /// Conversions of a trigger whose sum is the data (section 25.4.30): `OVSR`, and 1, where `ROVSE` is set.
    fn conversions(&self) -> u32 {
        match cfgr2::ROVSE.is_set(self.processing) {
            true => cfgr2::OSR.get(self.processing) as u32 + 1,
            false => 1,
        }
    }

    /// Half cycles of the analogue clock `channel` is sampled for.
    fn sampling_half_cycles(&self, channel: u64) -> u64 {
        let (register, place) = (channel / 10, channel % 10);
        let code = (self.sampling[register as usize & 1] >> (3 * place)) & 0b111;
        SAMPLING_HALF_CYCLES[code as usize]
    }

    /// Half cycles of the analogue clock one conversion of `channel` takes: sampling, then
    /// 0.5 + N/2 cycles for N bits (RM0433 Rev 9, section 25.4.17).
    fn conversion_half_cycles(&self, channel: u64) -> u64 {
        self.sampling_half_cycles(channel) + 1 + u64::from(self.bits())
    }

    /// Resolution in bits (section 25.6.4, revision V).
    fn bits(&self) -> u32 {
        match cfgr::RES.get(self.configuration) {
            0b001 | 0b101 => 14,
            0b010 | 0b110 => 12,
            0b011 => 10,
            0b111 => 8,
            _ => 16,
        }
    }

    /// The channel selected is the wired one.
    fn selects(&self, wired: u64) -> bool {
        self.channel() == Some(wired) && self.preselection & (1 << wired) != 0
    }

    /// Data of a converter for the mean code at its connector: 0 where the channel selected is not the wired
    /// one, because that pin carries nothing.
    fn convert(&self, wired: u64, code: u16, context: &mut DeviceContext<'_>) -> u16 {
        if self.selects(wired) {
            return self.data_of(code);
        }
        context.tell("SQR1", "a pin without a signal is converted: 0 V");
        0
    }

    /// The sum of the conversions of `code`, shifted to the left as `LSHIFT` says.
    fn data_of(&self, code: u16) -> u16 {
        let sum = (u64::from(code) * u64::from(self.conversions())) >> (16 - self.bits());
        let shifted = match cfgr2::ROVSE.is_set(self.processing) {
            true => sum >> cfgr2::OVSS.get(self.processing),
            false => sum,
        };
        // The pair's register has 16 bits for each.
        (shifted << cfgr2::LSHIFT.get(self.processing)) as u16
    }
}

impl Pair {
    /// Codes at the pins of reference and device under test at `now`.
    fn sample(&self, now: VirtualNanos) -> [u16; INPUT_CHANNELS] {
        let (mut pins, flaws) = (self.analog.lock(), self.flaws.lock());
        self.sample_of(&mut pins, &flaws, now)
    }

    /// As [`sample`](Self::sample), of pins and flaws that are taken already.
    fn sample_of(
        &self,
        pins: &mut Pins,
        flaws: &flaws::State,
        now: VirtualNanos,
    ) -> [u16; INPUT_CHANNELS] {
        let [reference, dut] = pins.sample(now);
        let [reference_pull, dut_pull] = self.pulls;
        let dut = match self.hears_drive() {
            true => flaws.internal(now.0),
            false => dut_pull.of(dut),
        };
        flaws.adc([reference_pull.of(reference), dut], now.0)
    }

    /// ADC2 converts the drive on the chip in place of its pin.
    fn hears_drive(&self) -> bool {
        let slave = &self.converters[1];
        slave.channel() == Some(self.internal) && slave.preselection & (1 << self.internal) != 0
    }

    /// Channel of a converter that carries a signal.
    fn live_channel(&self, nth: usize) -> u64 {
        match nth == 1 && self.hears_drive() {
            true => self.internal,
            false => self.wired[nth],
        }
    }

    /// Conversions of the pair at a trigger, both being set alike; `None` while the clock stands still.
    fn conversions(&self) -> Option<Conversions> {
        let master = &self.converters[0];
        let slowest = |half_cycles: fn(&State, u64) -> u64| {
            let all = self.converters.iter();
            let each = all.filter_map(|one| Some(half_cycles(one, one.channel()?)));
            self.half_cycles_ps(each.max()?)
        };
        Some(Conversions {
            count: master.conversions(),
            apart_ps: slowest(State::conversion_half_cycles)?,
            sampling_ns: slowest(State::sampling_half_cycles)?.div_ceil(1000),
        })
    }

    /// Picoseconds so many half cycles of the analogue clock last, `None` while it stands still.
    fn half_cycles_ps(&self, half_cycles: u64) -> Option<u64> {
        let doubled_hz = 2 * u128::from(self.clock_hz);
        let ps_per_s = 1000 * NS_PER_S;
        (doubled_hz > 0).then(|| (u128::from(half_cycles) * ps_per_s).div_ceil(doubled_hz) as u64)
    }

    /// Nanoseconds `cycles` of the analogue clock last, `None` while it stands still.
    fn cycles_ns(&self, cycles: u64) -> Option<u64> {
        let hz = u128::from(self.clock_hz);
        (hz > 0).then(|| (u128::from(cycles) * NS_PER_S).div_ceil(hz) as u64)
    }

    /// Drives the interrupt the two converters share.
    fn drive_interrupt(&self, context: &mut DeviceContext<'_>) {
        let raised = self
            .converters
            .iter()
            .any(|converter| converter.status & converter.interrupts != 0);
        context.interrupt(PAIR_LINE, Level::from(raised));
    }

    /// Whether any converter has an interrupt enabled.
    fn interrupts_enabled(&self) -> bool {
        self.converters.iter().any(|state| state.interrupts != 0)
    }
}
