//! From a request to the volts of both channels.

use super::Capture;
use crate::Client;
use crate::{Error, Result};
use calib_core::converter::MID_SAMPLE;
use calib_core::settings::Settings;
use calib_protocol::capture::{CapturePart, MAX_CAPTURE_PAIRS};
use std::time::Duration;

/// Narrowest converter, bits.
const NARROWEST_BITS: u32 = 8;

/// Time between two looks at a capture that is not whole: a block.
const POLL_INTERVAL: Duration = Duration::from_millis(10);

/// Looks at a capture that does not grow before it counts as dead: blocks come
/// every 10 ms, so 20 times longer than the longest pause of a sound instrument.
const IDLE_LOOKS: u32 = 20;

/// Scales that turn codes into volts and sample numbers into seconds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inputs {
    /// Samples per second and channel, Hz.
    pub sample_rate_hz: f64,
    /// Volts at the reference connector per code.
    pub reference_volt_per_code: f64,
    /// Volts at the connector of the device under test per code.
    pub dut_volt_per_code: f64,
}

impl Inputs {
    /// Asks the calibrator, once for any number of captures.
    ///
    /// # Errors
    /// Those of the link and the device.
    pub fn of(client: &mut Client) -> Result<Self> {
        let sample_rate_hz = f64::from(client.info()?.sample_rate_hz);
        let Settings {
            reference_input,
            dut_input,
            ..
        } = client.settings()?;
        Ok(Self {
            sample_rate_hz,
            reference_volt_per_code: reference_input.volt_per_code.into(),
            dut_volt_per_code: dut_input.volt_per_code.into(),
        })
    }

    /// Captures `pairs` pairs, 1 to [`MAX_CAPTURE_PAIRS`], from now on: whatever
    /// the instrument is doing, and without disturbing it. Over the serial port
    /// 8192 pairs take 3.0 s to read.
    ///
    /// # Errors
    /// Those of the link and the device, `Refused(CaptureBroken)` when samples
    /// were lost meanwhile; and [`Error::Input`] when no samples come, or another
    /// host asked for another capture before this one was read.
    pub fn capture(&self, client: &mut Client, pairs: u16) -> Result<Capture> {
        let mut taking = Taking::begin(client, *self, pairs)?;
        loop {
            if let Some(capture) = taking.step(client)? {
                return Ok(capture);
            }
            if !taking.is_whole() {
                client.wait(POLL_INTERVAL)?;
            }
        }
    }

    fn volts(&self, codes: &[[u16; 2]], channel: usize) -> Vec<f64> {
        let volt_per_code = [self.reference_volt_per_code, self.dut_volt_per_code][channel];
        let volts =
            |pair: &[u16; 2]| (f64::from(pair[channel]) - f64::from(MID_SAMPLE)) * volt_per_code;
        codes.iter().map(volts).collect()
    }
}

/// A capture on its way, one request at a time: for programs that have other
/// things to do meanwhile, such as to stop the exciter.
#[derive(Clone, Debug)]
pub struct Taking {
    inputs: Inputs,
    pairs: u16,
    /// Last state of the calibrator: taken pairs, and the first one's number
    /// once all are taken.
    taken: u16,
    first: Option<u64>,
    idle_looks: u32,
    codes: Vec<[u16; 2]>,
}

impl Taking {
    /// Asks for `pairs` pairs from the next block on.
    ///
    /// # Errors
    /// As [`Inputs::capture`].
    pub fn begin(client: &mut Client, inputs: Inputs, pairs: u16) -> Result<Self> {
        client.capture(pairs)?;
        Ok(Self {
            inputs,
            pairs,
            taken: 0,
            first: None,
            idle_looks: 0,
            codes: Vec::with_capacity(pairs.min(MAX_CAPTURE_PAIRS).into()),
        })
    }

    /// Whether all pairs are taken, and only their way to here is left: what
    /// happens from now on is not in the capture.
    pub fn is_whole(&self) -> bool {
        self.first.is_some()
    }

    /// Pairs that are here, and those that were asked for.
    pub fn progress(&self) -> (usize, usize) {
        (self.codes.len(), self.pairs.into())
    }

    /// One request: looks whether the pairs are taken, or reads some of them.
    /// The capture once all are here.
    ///
    /// # Errors
    /// As [`Inputs::capture`].
    pub fn step(&mut self, client: &mut Client) -> Result<Option<Capture>> {
        // Not more than a u16 says, which `accept` sees to.
        let part = client.read_capture(self.codes.len() as u16)?;
        self.accept(&part)
            .map_err(|(problem, hint)| Error::input(client.name(), problem, hint))?;
        if self.codes.len() < usize::from(self.pairs) {
            return Ok(None);
        }
        let first_index = self.first.unwrap_or_default();
        Ok(Some(self.finish(first_index)))
    }

    fn accept(&mut self, part: &CapturePart) -> Result<(), (&'static str, &'static str)> {
        let other = "began another capture while this one was read";
        let one_host = "end the program that uses its other port, and repeat";
        if part.total != self.pairs || self.first.is_some_and(|first| first != part.first) {
            return Err((other, one_host));
        }
        if !part.is_whole() {
            return self.wait_for(part);
        }
        self.first = Some(part.first);
        let before = self.codes.len();
        let room = usize::from(self.pairs) - before;
        self.codes.extend(part.codes().take(room));
        match self.codes.len() > before {
            true => Ok(()),
            false => Err((
                "ends a capture before its last pair",
                "reset the instrument and repeat",
            )),
        }
    }

    /// Notes how far a capture is that is not whole.
    fn wait_for(&mut self, part: &CapturePart) -> Result<(), (&'static str, &'static str)> {
        self.idle_looks = match part.taken > self.taken {
            true => 0,
            false => self.idle_looks + 1,
        };
        self.taken = self.taken.max(part.taken);
        match self.idle_looks > IDLE_LOOKS {
            true => Err((
                "takes no samples",
                "its sample clock has stopped: reset the instrument and repeat",
            )),
            false => Ok(()),
        }
    }

    fn finish(&self, first_index: u64) -> Capture {
        let last = last_sample(&self.codes);
        let clipped = |channel: usize| {
            let ends = |pair: &[u16; 2]| [0, last].contains(&pair[channel]);
            self.codes.iter().any(ends)
        };
        Capture {
            first_index,
            sample_rate_hz: self.inputs.sample_rate_hz,
            reference_v: self.inputs.volts(&self.codes, 0),
            dut_v: self.inputs.volts(&self.codes, 1),
            reference_clipped: clipped(0),
            dut_clipped: clipped(1),
        }
    }
}

/// Highest sample of converters of which these are: codes are left justified, so the low bits that
/// none of them uses tell the width.
fn last_sample(pairs: &[[u16; 2]]) -> u16 {
    let used = pairs.iter().flatten().fold(0, |used, sample| used | sample);
    u16::MAX << used.trailing_zeros().min(u16::BITS - NARROWEST_BITS)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_end_of_the_range_is_that_of_the_converter() {
        assert_eq!(last_sample(&[[0x8001, 0x8000], [0x7FFE, 0xFFFF]]), 0xFFFF);
        // 14 bits: 4 * 16 383. Silence alone is no end of any range.
        assert_eq!(last_sample(&[[0x8004, 0x8000], [0x7FF8, 0xFFFC]]), 0xFFFC);
        assert_ne!(last_sample(&[[0x8000, 0x8000]]), 0x8000);
        assert_ne!(last_sample(&[]), 0);
    }
}
