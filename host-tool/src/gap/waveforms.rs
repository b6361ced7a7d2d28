//! Waveforms of both channels beside a run, and the harmonics and means in them.
//!
//! A capture is taken while a point is held and read while the run goes on: over a serial line that
//! may take longer than a point, and a point or two may be passed over. Who needs them runs them
//! once more.

use super::known::Known;
use calib_link::Client;
use calib_link::capture::{Capture, FitError, Inputs, Taking, ToneFit, fit};
use calib_link::{Error, Result};
use calib_protocol::capture::MAX_CAPTURE_PAIRS;
use calib_protocol::message::{RunState, Status};
use calib_twin::dataset::{self, Point};
use num_complex::Complex64;
use std::collections::BTreeMap;

/// Cycles of the tone in a capture, if there is room.
const CYCLES: f64 = 3.0;
/// Fewest pairs of a capture: 41 ms at 50 kS/s, 0.8 s over the serial line.
const FEWEST_PAIRS: u16 = 2048;
/// Parts of a capture that are read at a look: the operator must be heard in between.
const PARTS: usize = 4;
/// Highest frequency of a harmonic that is used, over the sample rate: beyond it the anti-alias
/// filter decides.
const HIGHEST: f64 = 0.4;
/// Rounding noise of the output converter is pushed away from the tone, so noise at a harmonic is up
/// to 2.7 times (in power) what white noise of the same size would be there.
const COLOUR: f64 = 1.65;
/// Least standard uncertainty of a relative harmonic, and of a mean, V: a lone capture does not show
/// what the converters do to them.
const LEAST_U_HARMONIC: f64 = 2e-5;
const LEAST_U_DC_V: f64 = 2e-5;

/// Harmonics beside a fundamental: orders 2 to 5.
type Harmonics = [dataset::Harmonic; 4];

/// Takes captures beside a run.
#[derive(Debug)]
pub(super) struct Waveforms {
    inputs: Inputs,
    /// Means without drive, V: offsets of the inputs.
    rest_v: [f64; 2],
    /// Index of the point, and its capture on the way.
    taking: Option<(usize, Taking)>,
    taken: BTreeMap<usize, Capture>,
}

impl Waveforms {
    /// Looks at the inputs while nothing moves.
    pub(super) fn at_rest(client: &mut Client) -> Result<Self> {
        let inputs = Inputs::of(client)?;
        let rest = inputs.capture(client, FEWEST_PAIRS)?;
        let mean = |volts: &[f64]| volts.iter().sum::<f64>() / volts.len() as f64;
        Ok(Self {
            inputs,
            rest_v: [mean(&rest.reference_v), mean(&rest.dut_v)],
            taking: None,
            taken: BTreeMap::new(),
        })
    }

    /// Another run begins: its points count from 0.
    pub(super) fn begin(&mut self) {
        self.taking = None;
        self.taken.clear();
    }

    /// One look at a run: begins a capture, or reads some of one.
    pub(super) fn look(&mut self, client: &mut Client, status: &Status) -> Result<()> {
        let index = usize::from(status.point);
        match self.taking.take() {
            Some((of, taking)) => self.go_on(client, of, taking, PARTS),
            None if is_held(status) && !self.taken.contains_key(&index) => {
                let rate_hz = self.inputs.sample_rate_hz;
                let pairs = (CYCLES * rate_hz / f64::from(status.frequency_hz)).ceil();
                // A cast saturates, and makes 0 of what is no number.
                let pairs = (pairs as u16).clamp(FEWEST_PAIRS, MAX_CAPTURE_PAIRS);
                self.taking = Some((index, Taking::begin(client, self.inputs, pairs)?));
                Ok(())
            }
            None => Ok(()),
        }
    }

    /// Reads what is left of the last capture.
    pub(super) fn end(&mut self, client: &mut Client) -> Result<()> {
        match self.taking.take() {
            Some((of, taking)) if taking.is_whole() => {
                self.go_on(client, of, taking, usize::from(MAX_CAPTURE_PAIRS))
            }
            _ => Ok(()),
        }
    }

    fn go_on(
        &mut self,
        client: &mut Client,
        of: usize,
        mut taking: Taking,
        parts: usize,
    ) -> Result<()> {
        for _ in 0..parts {
            let was_whole = taking.is_whole();
            match taking.step(client) {
                Ok(Some(capture)) => {
                    if was_whole || still_held(client, of)? {
                        self.taken.insert(of, capture);
                    }
                    return Ok(());
                }
                Ok(None) if !taking.is_whole() => break,
                // The last pair is taken: was the level held until then?
                Ok(None) if !was_whole && !still_held(client, of)? => return Ok(()),
                Ok(None) => {}
                // Samples were lost meanwhile: this capture is none, and the run goes on.
                Err(Error::Refused(_)) => return Ok(()),
                Err(error) => return Err(error),
            }
        }
        self.taking = Some((of, taking));
        Ok(())
    }

    /// Adds harmonics and means to the row of a point. False when they should be there and are not.
    pub(super) fn complete(&self, row: &mut Point, index: usize, known: &Known) -> bool {
        let rate_hz = self.inputs.sample_rate_hz;
        let is_wanted = 5.0 * row.frequency_hz <= HIGHEST * rate_hz;
        let Some(capture) = self.taken.get(&index) else {
            return !is_wanted;
        };
        let fitted = |volts: &[f64]| fit(volts, rate_hz, row.frequency_hz);
        let Ok([reference, dut]) = both(fitted(&capture.reference_v), fitted(&capture.dut_v))
        else {
            return true;
        };
        row.ref_dc_v = Some(reference.dc_v - self.rest_v[0]);
        row.dut_dc_v = Some(dut.dc_v - self.rest_v[1]);
        let u_dc_v = reference
            .standard_uncertainty_dc_v
            .max(dut.standard_uncertainty_dc_v);
        row.u_dc_v = Some(u_dc_v.hypot(LEAST_U_DC_V));
        if is_wanted {
            let frequency_hz = row.frequency_hz;
            row.ref_harmonics = harmonics(&reference, |n| known.at_reference(n * frequency_hz));
            row.dut_harmonics = harmonics(&dut, |n| known.at_dut(n * frequency_hz));
            let all = reference.harmonics.iter().chain(&dut.harmonics);
            let u = all.map(|h| h.standard_uncertainty_rel).fold(0.0, f64::max);
            row.u_harmonic = Some((COLOUR * u).hypot(LEAST_U_HARMONIC));
        }
        true
    }
}

fn both<T>(a: Result<T, FitError>, b: Result<T, FitError>) -> Result<[T; 2], FitError> {
    Ok([a?, b?])
}

fn is_held(status: &Status) -> bool {
    status.state == RunState::Measuring && status.drive_peak_v > 0.0
}

fn still_held(client: &mut Client, index: usize) -> Result<bool> {
    let status = client.status()?;
    Ok(is_held(&status) && usize::from(status.point) == index)
}

/// Harmonics as they were before a channel of known `response` (at n times the frequency).
///
/// Order n is reported as `T(n) X(n) / |T(1) X(1)|` with the phase taken to n times that of
/// the fundamental.
fn harmonics(fit: &ToneFit, response: impl Fn(f64) -> Complex64) -> Option<Harmonics> {
    let first = response(1.0);
    let before = |harmonic: &calib_link::capture::Harmonic| {
        let n = f64::from(harmonic.order);
        let turned = Complex64::from_polar(first.norm(), n * first.arg());
        let seen = Complex64::from_polar(harmonic.amplitude_rel, harmonic.phase_rad);
        let before = seen * turned / response(n);
        dataset::Harmonic {
            amplitude: before.norm(),
            phase_deg: before.arg().to_degrees(),
        }
    };
    let all: Vec<dataset::Harmonic> = fit.harmonics.iter().map(before).collect();
    all.try_into().ok()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    /// A table with a harmonic of each order, seen through a first-order high-pass: what is
    /// computed before it is the table again.
    #[test]
    fn a_known_channel_is_taken_out_of_the_harmonics() {
        let (rate_hz, frequency_hz, corner_hz) = (50_000.0, 40.0, 30.0);
        let response = |hz: f64| {
            let p = Complex64::new(0.0, hz / corner_hz);
            p / (1.0 + p)
        };
        let table = [1.0, 0.1, 0.05, 0.02, 0.01];
        let phases = [0.7, -1.2, 2.0, 0.3, -2.9];
        let volts: Vec<f64> = (0..5000)
            .map(|sample| {
                let t_s = f64::from(sample) / rate_hz;
                let orders = table.iter().zip(phases).zip(1..);
                let part = |((amplitude, phase), n): ((&f64, f64), i32)| {
                    let hz = f64::from(n) * frequency_hz;
                    let seen = response(hz) * Complex64::from_polar(*amplitude, phase);
                    (seen * Complex64::from_polar(1.0, TAU * hz * t_s)).re
                };
                orders.map(part).sum()
            })
            .collect();
        let fit = fit(&volts, rate_hz, frequency_hz).expect("a tone");
        let found = harmonics(&fit, |n| response(n * frequency_hz)).expect("four");
        for (at, harmonic) in found.iter().enumerate() {
            let n = at as f64 + 2.0;
            let phase = phases[at + 1] - n * phases[0];
            let expected = Complex64::from_polar(table[at + 1], phase);
            let seen = Complex64::from_polar(harmonic.amplitude, harmonic.phase_deg.to_radians());
            // Rounding of the fit.
            assert!((seen - expected).norm() < 1e-9, "{n}: {harmonic:?}");
        }
    }
}
