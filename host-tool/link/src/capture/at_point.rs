//! A capture while a point is held at its level.

use super::{Capture, Inputs, Taking};
use crate::Client;
use crate::session;
use crate::{Error, Result};
use calib_core::point::{ExcitationKind, PointResult, PointSpec};
use calib_core::tone::Tone;
use calib_protocol::capture::MAX_CAPTURE_PAIRS;
use calib_protocol::message::{RunState, Status};
use calib_protocol::record::RunLabels;
use std::ops::ControlFlow;
use std::time::Duration;

/// Time between two looks at a point that is not at its level yet.
const POLL_INTERVAL: Duration = Duration::from_millis(20);

/// Cycles of the tone a capture should hold, if there is room.
const CYCLES: f64 = 10.0;

/// Pairs a capture should have at least: 82 ms and 12 Hz between spectral lines
/// at 50 kHz.
const USUAL_PAIRS: u16 = 4096;

/// A point that was measured, and its waveforms.
#[derive(Clone, Debug)]
pub struct Measured {
    /// Running number of the record the calibrator keeps.
    pub record_id: u32,
    /// How the run ended.
    pub state: RunState,
    /// Result of the calibrator; none if the run was stopped before.
    pub point: Option<PointResult>,
    /// Frequency of the tone, Hz: the exact one, within 0.01 % of the nominal.
    pub frequency_hz: f64,
    /// The waveforms, every sample taken while the level was held; none if it was
    /// not held for so long: the point was refused or stopped.
    pub capture: Option<Capture>,
}

/// Pairs that hold ten cycles of `frequency_hz`, at least 4096, at most
/// [`MAX_CAPTURE_PAIRS`] (ten cycles of 30.5 Hz at 50 kHz; 6.5 of 20 Hz).
pub fn pairs_for(frequency_hz: f64, sample_rate_hz: f64) -> u16 {
    let wanted = (CYCLES * sample_rate_hz / frequency_hz).ceil();
    // A cast saturates, and makes 0 of what is no number.
    (wanted as u16).clamp(USUAL_PAIRS, MAX_CAPTURE_PAIRS)
}

/// Frequency of the tone the calibrator plays for `nominal_hz`, Hz: a rational
/// part of the sample rate within 0.01 %. A fit to a capture needs this one.
pub fn tone_frequency_hz(nominal_hz: f32, sample_rate_hz: f64) -> Option<f64> {
    let tone = Tone::nearest(nominal_hz, sample_rate_hz as f32)?;
    Some(f64::from(tone.cycles) * sample_rate_hz / f64::from(tone.period_samples))
}

/// Measures one point as a run of its own and captures `pairs` pairs while its
/// level is held ([`pairs_for`] says how many are good). `stop` is asked all the
/// time: true stops the run, which silences the exciter.
///
/// # Errors
/// Those of the link, the device, [`session::begin`] and [`Inputs::capture`].
pub fn measure(
    client: &mut Client,
    inputs: &Inputs,
    point: PointSpec,
    pairs: u16,
    labels: RunLabels,
    stop: impl Fn() -> bool,
) -> Result<Measured> {
    let frequency_hz = tone_frequency_hz(point.frequency_hz, inputs.sample_rate_hz)
        .ok_or_else(|| no_tone(point.frequency_hz))?;
    let record_id = session::begin(client, &[point], ExcitationKind::HeldSine, labels)?;
    let capture = while_held(client, *inputs, pairs, &stop);
    let capture = match capture {
        Ok(capture) => capture,
        Err(error) => {
            // Nobody follows this run any more: the exciter must not go on.
            client.stop()?;
            return Err(error);
        }
    };
    let outcome = session::follow(client, record_id, &[point], |_| match stop() {
        true => ControlFlow::Break(()),
        false => ControlFlow::Continue(()),
    })?;
    Ok(Measured {
        record_id,
        state: outcome.state,
        point: outcome.points.first().copied(),
        frequency_hz,
        capture,
    })
}

fn no_tone(frequency_hz: f32) -> Error {
    Error::input(
        "point",
        format!("{frequency_hz} Hz is no frequency the sample clock has a tone for"),
        "choose one from 4.2 Hz to 22.5 kHz",
    )
}

/// Waits for the level and captures; none if the run ends before, or does not
/// hold its level to the last pair.
fn while_held(
    client: &mut Client,
    inputs: Inputs,
    pairs: u16,
    stop: &impl Fn() -> bool,
) -> Result<Option<Capture>> {
    let mut status = client.status()?;
    while !is_held(&status) {
        if stop() || !status.state.is_exciting() {
            return Ok(None);
        }
        client.wait(POLL_INTERVAL)?;
        status = client.status()?;
    }
    let mut taking = Taking::begin(client, inputs, pairs)?;
    while !stop() {
        let was_whole = taking.is_whole();
        if let Some(capture) = taking.step(client)? {
            let held = was_whole || is_held(&client.status()?);
            return Ok(held.then_some(capture));
        }
        match (was_whole, taking.is_whole()) {
            // The last pair is taken: was the level held until then?
            (false, true) if !is_held(&client.status()?) => return Ok(None),
            (_, true) => {}
            (_, false) => client.wait(POLL_INTERVAL)?,
        }
    }
    Ok(None)
}

/// Whether the level is held and measured: while the exciter is being silenced
/// afterwards, the drive is 0.
fn is_held(status: &Status) -> bool {
    status.state == RunState::Measuring && status.drive_peak_v > 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn low_tones_get_more_pairs_as_far_as_there_is_room() {
        // 10 cycles of 50 Hz are 0.2 s.
        assert_eq!(pairs_for(50.0, 50_000.0), 10_000);
        assert_eq!(pairs_for(1000.0, 50_000.0), USUAL_PAIRS);
        assert_eq!(pairs_for(5.0, 50_000.0), MAX_CAPTURE_PAIRS);
        assert_eq!(pairs_for(f64::NAN, 50_000.0), USUAL_PAIRS);
    }

    #[test]
    fn the_tone_is_a_rational_part_of_the_sample_clock() {
        // 3 cycles in 4762 samples, as the firmware's own test has it.
        let exact_hz = tone_frequency_hz(31.5, 50_000.0).expect("a tone");
        assert_eq!(exact_hz, 3.0 * 50_000.0 / 4762.0);
        assert_eq!(tone_frequency_hz(1.0, 50_000.0), None);
    }
}
