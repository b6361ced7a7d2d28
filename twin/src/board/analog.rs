//! The board's analogue pins: the one place where converters meet the rig.
//!
//! DAC1 says when the level on PA4 changes, the converter pair says when it samples. Between two of
//! those instants the drive output is constant, so the rig hears every stretch of time exactly once.

use std::sync::{Arc, Mutex, MutexGuard};

use rigless::snapshot::{self, Reader, Store, Writer};
use rigless::time::VirtualNanos;

use serde::{Deserialize, Serialize};

use crate::rig_port::{Conversions, DRIVE_MID_CODE, Dither, INPUT_CHANNELS, RigPort};

/// A square wave a timer plays.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(super) struct Wave {
    pub(super) frequency_hz: f64,
    /// When it rose first.
    pub(super) risen: VirtualNanos,
}

impl Wave {
    fn at(self, now: VirtualNanos) -> Dither {
        let periods = now.0.saturating_sub(self.risen.0) as f64 * 1e-9 * self.frequency_hz;
        Dither {
            frequency_hz: self.frequency_hz,
            phase: periods.fract(),
        }
    }
}

/// The pins of drive, reference and device under test, with the rig on them: what an [`Analog`] is a handle
/// of.
pub(super) struct Pins {
    rig: Box<dyn RigPort>,
    drive_code: u16,
    reached: VirtualNanos,
    /// Instant at which the drive last left or reached silence.
    silent_since: Option<VirtualNanos>,
    samples: u64,
    conversions: Conversions,
    drive_buffer: bool,
    /// Wave the timer of the dither plays, and whether its pin is connected to it.
    wave: Option<Wave>,
    wave_on_pin: bool,
}

/// A shared handle of the pins: DAC1 holds one, the converter pair holds one.
#[derive(Clone)]
pub struct Analog(Arc<Mutex<Pins>>);

impl std::fmt::Debug for Analog {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.debug_struct("Analog").finish_non_exhaustive()
    }
}

/// The rig keeps itself; it is the one that was on the pins when the run was kept.
impl Store for Analog {
    fn store(&self, to: &mut Writer) -> Result<(), snapshot::Error> {
        let pins = self.lock();
        to.put(&(
            pins.drive_code,
            pins.reached,
            pins.silent_since,
            pins.samples,
            pins.conversions,
            pins.drive_buffer,
            pins.wave,
            pins.wave_on_pin,
        ))?;
        pins.rig.store(to)
    }

    fn load(&mut self, from: &mut Reader) -> Result<(), snapshot::Error> {
        let mut pins = self.lock();
        (
            pins.drive_code,
            pins.reached,
            pins.silent_since,
            pins.samples,
            pins.conversions,
            pins.drive_buffer,
            pins.wave,
            pins.wave_on_pin,
        ) = from.take()?;
        pins.set_rig();
        pins.rig.load(from)
    }
}

impl Analog {
    /// The pins with `rig` on them, at rest.
    #[must_use]
    pub fn new(rig: Box<dyn RigPort>) -> Self {
        Self(Arc::new(Mutex::new(Pins {
            rig,
            drive_code: DRIVE_MID_CODE,
            reached: VirtualNanos(0),
            silent_since: Some(VirtualNanos(0)),
            samples: 0,
            conversions: Conversions::default(),
            drive_buffer: true,
            wave: None,
            wave_on_pin: false,
        })))
    }

    /// The level on the drive output becomes `code` at `now`.
    pub(super) fn drive(&self, code: u16, now: VirtualNanos) {
        self.lock().drive(code, now);
    }

    /// The timer of the dither plays this from `now` on.
    pub(super) fn play_dither(&self, wave: Option<Wave>, now: VirtualNanos) {
        let mut pins = self.lock();
        pins.advance(now);
        pins.wave = wave;
        pins.set_rig();
    }

    /// The dither's pin is connected to its timer, or not.
    pub(super) fn connect_dither(&self, on: bool, now: VirtualNanos) {
        let mut pins = self.lock();
        if on != pins.wave_on_pin {
            pins.advance(now);
            pins.wave_on_pin = on;
            pins.set_rig();
        }
    }

    /// Each sample is made so from now on.
    pub(super) fn convert_so(&self, conversions: Conversions) {
        let mut pins = self.lock();
        if conversions != pins.conversions {
            pins.conversions = conversions;
            pins.set_rig();
        }
    }

    /// Temperature of the processor, hundredths of a degree Celsius.
    pub(super) fn processor_centi_c(&self) -> i32 {
        (self.lock().rig.processor_c() * 100.0).round() as i32
    }

    /// Lets the rig live on to `now` without a conversion.
    pub fn advance(&self, now: VirtualNanos) {
        self.lock().advance(now);
    }

    /// The code on the drive output.
    #[must_use]
    pub fn drive_code(&self) -> u16 {
        self.lock().drive_code
    }

    /// Conversions of both channels so far.
    #[must_use]
    pub fn samples(&self) -> u64 {
        self.lock().samples
    }

    /// Since when the drive output has been at [`DRIVE_MID_CODE`], or `None` while it is not.
    #[must_use]
    pub fn silent_since(&self) -> Option<VirtualNanos> {
        self.lock().silent_since
    }

    /// Replaces the rig at the present instant and hands the old one back.
    pub fn replace_rig(&self, rig: Box<dyn RigPort>) -> Box<dyn RigPort> {
        let mut pins = self.lock();
        let before = std::mem::replace(&mut pins.rig, rig);
        pins.set_rig();
        before
    }

    /// The pins, for more than one call.
    pub(super) fn lock(&self) -> MutexGuard<'_, Pins> {
        self.0
            .lock()
            .unwrap_or_else(std::sync::PoisonError::into_inner)
    }
}

impl Pins {
    /// The level on the drive output becomes `code` at `now`.
    pub(super) fn drive(&mut self, code: u16, now: VirtualNanos) {
        if code == self.drive_code {
            return;
        }
        self.advance(now);
        self.drive_code = code;
        self.silent_since = (code == DRIVE_MID_CODE).then_some(now);
    }

    /// The drive converter has its buffer before the pin, or not.
    pub(super) fn buffer_drive(&mut self, on: bool, now: VirtualNanos) {
        if on != self.drive_buffer {
            self.advance(now);
            self.drive_buffer = on;
            self.set_rig();
        }
    }

    /// The codes of both input channels at `now`.
    pub(super) fn sample(&mut self, now: VirtualNanos) -> [u16; INPUT_CHANNELS] {
        self.advance(now);
        self.samples += 1;
        self.rig.sample()
    }

    /// The drive converter has its buffer before the pin.
    pub(super) fn buffers_drive(&self) -> bool {
        self.drive_buffer
    }

    /// Each sample is made so, and has been.
    pub(super) fn convert_so(&self, conversions: Conversions) -> bool {
        self.conversions == conversions
    }

    /// Tells the rig how the converters are set.
    fn set_rig(&mut self) {
        self.rig.set_conversions(self.conversions);
        self.rig.set_drive_buffer(self.drive_buffer);
        let wave = self.wave.filter(|_| self.wave_on_pin);
        self.rig.set_dither(wave.map(|wave| wave.at(self.reached)));
    }

    fn advance(&mut self, now: VirtualNanos) {
        let duration_ns = now.0.saturating_sub(self.reached.0);
        if duration_ns > 0 {
            self.rig.hold(self.drive_code, duration_ns);
            self.reached = now;
        }
    }
}
