//! The seam between the emulated board and the physics around it.
//!
//! The board knows codes and time, the plant knows volts and metres per second squared: all
//! analogue matters (output stage, exciter, transducers, conditioning, range, resolution and noise
//! of the digitiser) are on the plant's side. Both sides are exact in time, because a converter's
//! trigger is: durations are whole virtual nanoseconds.
//!
//! ```text
//!            hold(drive_code, duration_ns)                sample()
//!   DAC1 ------------------------------------> plant ------------------> ADC1, ADC2
//! ```

use rigless::snapshot::{Error, Reader, Writer};
use serde::{Deserialize, Serialize};

/// Code of the drive output (DAC1, 12 bit right aligned) at which the exciter gets 0 V.
///
/// The output stage's bias network holds this level as well while the converter is off and its pin
/// floats, so a board without firmware is silent.
pub const DRIVE_MID_CODE: u16 = 2048;

/// Number of input channels sampled at one trigger: reference, then device under test.
pub const INPUT_CHANNELS: usize = 2;

/// Temperature of the air around a board whose rig says nothing else, degrees Celsius.
pub const AIR_C: f64 = 23.0;

/// How much warmer than the air the processor is, K: some 0.6 W (180 mA at 3.3 V with the core at
/// 480 MHz) over some 42 K/W from junction to air.
pub const SELF_HEATING_K: f64 = 25.0;

/// Conversions of each input converter at a trigger.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct Conversions {
    /// Conversions whose mean is the sample, at least 1; the first is at the trigger.
    pub count: u32,
    /// From one to the next, ps: whole periods of the dither are to be told from nearly whole ones.
    pub apart_ps: u64,
    /// For how long each is connected to its pin, ns.
    pub sampling_ns: u64,
}

impl Default for Conversions {
    /// One, of a sampling time that is no matter.
    fn default() -> Self {
        Self {
            count: 1,
            apart_ps: 0,
            sampling_ns: 2_000,
        }
    }
}

impl Conversions {
    /// From one to the next, ns, rounded up.
    #[must_use]
    pub fn apart_ns(&self) -> u64 {
        self.apart_ps.div_ceil(1000)
    }
}

/// The square wave the board plays on the dither's pin.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Dither {
    /// Its frequency, Hz.
    pub frequency_hz: f64,
    /// Periods since it rose, at this instant: 0 to 1.
    pub phase: f64,
}

/// Devices at the board's analogue pins, and the air around it.
///
/// The board calls [`hold`](Self::hold) for every stretch of time in which the drive output was
/// constant, and [`sample`](Self::sample) at each conversion, in the order of virtual time. In
/// normal operation that is one `hold` of 20 000 ns and one `sample` per trigger.
///
/// An implementation must be deterministic: the same calls give the same codes.
pub trait RigPort: Send {
    /// Advances the physics by `duration_ns` with the drive output constant at `drive_code`
    /// (0 ..= 4095, [`DRIVE_MID_CODE`] is 0 V).
    fn hold(&mut self, drive_code: u16, duration_ns: u64);

    /// From now on each sample is made so.
    fn set_conversions(&mut self, conversions: Conversions) {
        let _ = conversions;
    }

    /// From now on the dither's pin plays this, or nothing.
    fn set_dither(&mut self, dither: Option<Dither>) {
        let _ = dither;
    }

    /// From now on the drive output has the converter's buffer before it, or not.
    fn set_drive_buffer(&mut self, on: bool) {
        let _ = on;
    }

    /// The codes both digitisers give for the present instant: reference, then device under test,
    /// 16 bit offset binary (32 768 is 0 V).
    fn sample(&mut self) -> [u16; INPUT_CHANNELS];

    /// Writes what a rig built the same way needs to go on from here.
    ///
    /// # Errors
    ///
    /// A rig that cannot, as every one that does not say how.
    fn store(&self, to: &mut Writer) -> Result<(), Error> {
        let _ = to;
        Err(Error::Unsaved(std::any::type_name::<Self>()))
    }

    /// Goes on from what [`store`](Self::store) wrote.
    ///
    /// # Errors
    ///
    /// As there, and what another rig wrote.
    fn load(&mut self, from: &mut Reader) -> Result<(), Error> {
        let _ = from;
        Err(Error::Unsaved(std::any::type_name::<Self>()))
    }

    /// Temperature of the processor on the board at the present instant, degrees Celsius.
    fn processor_c(&self) -> f64 {
        AIR_C + SELF_HEATING_K
    }
}

/// A rig whose input connectors are shorted: every code is mid-scale.
///
/// For tests that are about the board alone.
#[derive(Debug, Clone, Copy, Default)]
pub struct ShortedInputs;

impl RigPort for ShortedInputs {
    fn hold(&mut self, _drive_code: u16, _duration_ns: u64) {}

    fn sample(&mut self) -> [u16; INPUT_CHANNELS] {
        [32_768; INPUT_CHANNELS]
    }
}

impl<R: RigPort + ?Sized> RigPort for Box<R> {
    fn hold(&mut self, drive_code: u16, duration_ns: u64) {
        (**self).hold(drive_code, duration_ns);
    }

    fn set_conversions(&mut self, conversions: Conversions) {
        (**self).set_conversions(conversions);
    }

    fn set_dither(&mut self, dither: Option<Dither>) {
        (**self).set_dither(dither);
    }

    fn set_drive_buffer(&mut self, on: bool) {
        (**self).set_drive_buffer(on);
    }

    fn sample(&mut self) -> [u16; INPUT_CHANNELS] {
        (**self).sample()
    }

    fn store(&self, to: &mut Writer) -> Result<(), Error> {
        (**self).store(to)
    }

    fn load(&mut self, from: &mut Reader) -> Result<(), Error> {
        (**self).load(from)
    }

    fn processor_c(&self) -> f64 {
        (**self).processor_c()
    }
}
