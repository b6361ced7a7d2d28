//! Waveforms of both inputs while a run goes on: some cycles and a spectrum,
//! small enough for a page.

use calib_core::settings::ReferenceCalibration;
use calib_link::Client;
use calib_link::capture::{Capture, Inputs, Taking, Window, spectrum};
use calib_link::{Error, Result};
use calib_protocol::message::{RunState, Status};
use schemars::JsonSchema;
use serde::Serialize;

/// Least pairs of a capture: lines of the spectrum 24 Hz apart, read in under 2 s
/// over the serial port.
const LEAST_PAIRS: f64 = 2048.0;
/// Most pairs of a capture: 82 ms, 1.6 cycles of 20 Hz.
const MOST_PAIRS: f64 = 4096.0;
/// Cycles captured, where there is room, and drawn.
const CYCLES: f64 = 3.0;
/// Samples drawn at most: more than a phone has pixels.
const DRAWN_SAMPLES: usize = 500;
/// Lines of the spectrum drawn for each tenfold of frequency.
const LINES_PER_DECADE: f64 = 100.0;

/// Refusals after which a calibrator counts as one that hands out no samples; a
/// capture may break, or another host ask for one.
const PATIENCE: u32 = 5;

/// Both inputs, drawn.
#[derive(Clone, Debug, Default, Serialize, JsonSchema)]
pub struct Waveforms {
    /// Running number among those of this server.
    pub(super) number: u32,
    /// Frequency that was played, Hz.
    frequency_hz: f64,
    /// Between two samples, s.
    step_s: f64,
    /// Reference, m/s2, without its mean.
    reference_ms2: Vec<f32>,
    /// Device under test, V, without its mean.
    dut_v: Vec<f32>,
    /// Frequency in Hz, reference in m/s2 r.m.s., device under test in V r.m.s.
    spectrum: Vec<[f32; 3]>,
    /// A signal reaches the end of its converter's range.
    clipped: bool,
}

/// Looks at the inputs of a calibrator, a request or two at a time.
pub(super) struct Eye {
    inputs: Inputs,
    reference: ReferenceCalibration,
    taking: Option<(Taking, f32)>,
    /// Refusals without a capture between them.
    refusals: u32,
}

impl Eye {
    /// Asks for what turns codes into volts, and volts into accelerations.
    ///
    /// # Errors
    /// Those of the link and the device.
    pub(super) fn open(client: &mut Client) -> Result<Self> {
        Ok(Self {
            inputs: Inputs::of(client)?,
            reference: client.settings()?.reference,
            taking: None,
            refusals: 0,
        })
    }

    /// A request or two more; the waveforms, once all of them is here. Pairs that are taken are read
    /// to their end, whatever is played meanwhile.
    ///
    /// # Errors
    /// Those of the link. What the device refuses ends the looking, not the run.
    pub(super) fn look(
        &mut self,
        client: &mut Client,
        status: &Status,
    ) -> Result<Option<Waveforms>> {
        let plays = matches!(status.state, RunState::Settling | RunState::Measuring);
        let begins = plays && status.frequency_hz > 0.0 && self.refusals <= PATIENCE;
        if !begins && !self.is_reading() {
            self.taking = None;
            return Ok(None);
        }
        self.go_on(client, status.frequency_hz)
    }

    /// The rest of pairs that were taken before a run ended: a short run has waveforms too, over
    /// however slow a link.
    ///
    /// # Errors
    /// Those of the link.
    pub(super) fn rest(&mut self, client: &mut Client) -> Result<Option<Waveforms>> {
        let mut drawn = None;
        while drawn.is_none() && self.is_reading() {
            drawn = self.go_on(client, 0.0)?;
        }
        Ok(drawn)
    }

    /// All pairs are taken, and some of them not here.
    fn is_reading(&self) -> bool {
        let taking = self.taking.as_ref();
        taking.is_some_and(|(taking, _)| taking.is_whole())
    }

    fn go_on(&mut self, client: &mut Client, frequency_hz: f32) -> Result<Option<Waveforms>> {
        match self.step(client, frequency_hz) {
            Err(error @ Error::Link(_)) => Err(error),
            Err(_) => {
                self.taking = None;
                self.refusals += 1;
                Ok(None)
            }
            Ok(drawn) => {
                if drawn.is_some() {
                    self.refusals = 0;
                }
                Ok(drawn)
            }
        }
    }

    fn step(&mut self, client: &mut Client, frequency_hz: f32) -> Result<Option<Waveforms>> {
        // Samples of two frequencies are no waveform of either.
        let other = |(taking, of): &(Taking, f32)| !taking.is_whole() && *of != frequency_hz;
        self.taking = self.taking.take().filter(|taking| !other(taking));
        let Some((taking, of)) = &mut self.taking else {
            let pairs = pairs(frequency_hz, self.inputs.sample_rate_hz);
            let taking = Taking::begin(client, self.inputs, pairs)?;
            self.taking = Some((taking, frequency_hz));
            return Ok(None);
        };
        // A second part where one has come: a stop waits for both.
        let mut capture = taking.step(client)?;
        if capture.is_none() && taking.is_whole() {
            capture = taking.step(client)?;
        }
        let Some(capture) = capture else {
            return Ok(None);
        };
        let of = *of;
        self.taking = None;
        let reference = self
            .reference
            .at(of)
            .map(|at| f64::from(at.sensitivity_v_per_ms2));
        Ok(reference.map(|v_per_ms2| draw(&capture, of.into(), v_per_ms2)))
    }
}

fn pairs(frequency_hz: f32, sample_rate_hz: f64) -> u16 {
    let wanted = CYCLES * sample_rate_hz / f64::from(frequency_hz);
    // Between the two bounds, so it is a u16.
    wanted.clamp(LEAST_PAIRS, MOST_PAIRS) as u16
}

fn draw(capture: &Capture, frequency_hz: f64, reference_v_per_ms2: f64) -> Waveforms {
    let cycles = CYCLES * capture.sample_rate_hz / frequency_hz;
    let samples = (cycles as usize).clamp(2, capture.reference_v.len().max(2));
    let every = samples.div_ceil(DRAWN_SAMPLES);
    let trace = |volts: &[f64], factor: f64| -> Vec<f32> {
        let mean = volts.iter().sum::<f64>() / volts.len().max(1) as f64;
        let drawn = volts.iter().take(samples).step_by(every);
        drawn.map(|volt| ((volt - mean) * factor) as f32).collect()
    };
    Waveforms {
        number: 0,
        frequency_hz,
        step_s: every as f64 / capture.sample_rate_hz,
        reference_ms2: trace(&capture.reference_v, 1.0 / reference_v_per_ms2),
        dut_v: trace(&capture.dut_v, 1.0),
        spectrum: lines(capture, frequency_hz, reference_v_per_ms2),
        clipped: capture.reference_clipped || capture.dut_clipped,
    }
}

/// Spectra of both channels; where lines are closer than a page can show, the
/// highest of them stands for all.
///
/// Taken over whole cycles of the tone: it and its harmonics lie on lines, and
/// nothing of them is in the mean.
fn lines(capture: &Capture, frequency_hz: f64, reference_v_per_ms2: f64) -> Vec<[f32; 3]> {
    let cycle = capture.sample_rate_hz / frequency_hz;
    let length = capture.reference_v.len();
    let cycles = (length as f64 / cycle).floor().max(1.0);
    let samples = ((cycles * cycle).round() as usize).min(length);
    let of = |volts: &[f64]| {
        let whole = volts.get(..samples).unwrap_or(volts);
        spectrum(whole, capture.sample_rate_hz, Window::Hann)
    };
    let (reference, dut) = (of(&capture.reference_v), of(&capture.dut_v));
    let mut lines: Vec<(i64, [f32; 3])> = Vec::new();
    for (line, (a, b)) in reference.rms_v.iter().zip(&dut.rms_v).enumerate().skip(1) {
        let frequency_hz = reference.frequency_hz(line);
        let place = (LINES_PER_DECADE * frequency_hz.log10()) as i64;
        let (a, b) = ((a / reference_v_per_ms2) as f32, *b as f32);
        match lines.last_mut() {
            Some((last, [_, high_a, high_b])) if *last == place => {
                (*high_a, *high_b) = (high_a.max(a), high_b.max(b));
            }
            _ => lines.push((place, [frequency_hz as f32, a, b])),
        }
    }
    lines.into_iter().map(|(_, line)| line).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 10 m/s2 r.m.s. at 0.01 V/(m/s2), an object of 0.02, and 1 % of a third harmonic.
    fn capture(frequency_hz: f64, pairs: usize) -> Capture {
        let wave = |amplitude_v: f64| {
            let sample = move |n: usize| {
                let angle = std::f64::consts::TAU * frequency_hz * n as f64 / 50_000.0;
                0.3 + amplitude_v * (angle.sin() + 0.01 * (3.0 * angle).sin())
            };
            (0..pairs).map(sample).collect()
        };
        Capture {
            first_index: 0,
            sample_rate_hz: 50_000.0,
            reference_v: wave(0.1 * 2.0_f64.sqrt()),
            dut_v: wave(0.2 * 2.0_f64.sqrt()),
            reference_clipped: false,
            dut_clipped: false,
        }
    }

    #[test]
    fn a_tone_is_drawn_in_its_units_and_its_spectrum_shows_it() {
        let drawn = draw(&capture(1000.0, 2048), 1000.0, 0.01);
        // Three cycles of 50 samples.
        assert_eq!(drawn.reference_ms2.len(), 150);
        assert!((drawn.step_s - 0.02e-3).abs() < 1e-15);
        let highest = |trace: &[f32]| trace.iter().fold(0.0_f32, |high, a| high.max(*a));
        // The mean is taken over a broken number of cycles, 40.96: 1 % of a cycle's
        // amplitude at most stays in it.
        assert!((highest(&drawn.reference_ms2) / 14.142 - 1.0).abs() < 0.02);
        assert!((highest(&drawn.dut_v) / 0.282_84 - 1.0).abs() < 0.02);
        let at = |f: f32| {
            let near = drawn
                .spectrum
                .iter()
                .filter(|line| (line[0] / f - 1.0).abs() < 0.03);
            near.fold([0.0_f32; 2], |high, line| {
                [high[0].max(line[1]), high[1].max(line[2])]
            })
        };
        // Flat top: at most 0.11 % low between two lines.
        assert!(
            (at(1000.0)[0] / 10.0 - 1.0).abs() < 2e-3,
            "{:?}",
            at(1000.0)
        );
        assert!((at(1000.0)[1] / 0.2 - 1.0).abs() < 2e-3);
        assert!((at(3000.0)[0] / 0.1 - 1.0).abs() < 2e-2, "{:?}", at(3000.0));
        assert!(drawn.spectrum.len() < 400);
    }

    #[test]
    fn a_slow_tone_is_drawn_as_far_as_it_was_captured_and_thinned() {
        assert_eq!(pairs(20.0, 50_000.0), 4096);
        assert_eq!(pairs(10_000.0, 50_000.0), 2048);
        let drawn = draw(&capture(20.0, 4096), 20.0, 0.01);
        assert_eq!(drawn.reference_ms2.len(), 4096_usize.div_ceil(9));
        assert!((drawn.step_s - 0.18e-3).abs() < 1e-15);
    }
}
