//! Starting a run and following it to its end.

use crate::Client;
use crate::{Error, Result};
use calib_core::point::{ExcitationKind, PointResult, PointSpec};
use calib_protocol::message::{Refusal, RunSpec, RunState, Status};
use calib_protocol::record::{MAX_POINTS, RunLabels};
use heapless::Vec as FixedVec;
use std::ops::ControlFlow;
use std::time::Duration;

/// Time between two tries to start.
const POLL_INTERVAL: Duration = Duration::from_millis(100);

/// Time between two looks at a run: a point above 200 Hz lasts a quarter of a second, and a capture of it is begun at one
/// look, whole at the next, and read at those that follow.
const LOOK_INTERVAL: Duration = Duration::from_millis(50);

/// Looks at an idle calibrator before a run counts as lost: it begins within a
/// tenth of a second, or the board was reset.
const IDLE_POLLS: u32 = 40;

/// Where a run stands.
#[derive(Clone, Copy, Debug)]
pub struct Progress<'a> {
    /// State of the calibrator.
    pub status: Status,
    /// Results so far, in the order of the list.
    pub points: &'a [PointResult],
    /// Work done, 0 to 1, by the expected duration of each point.
    pub fraction: f64,
}

/// Time left of a run by the clock of this computer, once a twentieth is done.
pub fn time_left(elapsed: Duration, fraction: f64) -> Option<Duration> {
    (fraction > 0.05).then(|| elapsed.mul_f64(1.0 / fraction - 1.0))
}

/// How a run ended.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// Running number of the record.
    pub record_id: u32,
    /// `Finished`, `Stopped`, or `Failed` when the record could not be stored.
    pub state: RunState,
    /// Results in the order of the list.
    pub points: Vec<PointResult>,
}

/// Starts a run and follows it. `observe` is called at every look; its
/// `Break` stops the run, which silences the exciter and stores what there is.
///
/// # Errors
/// Those of the link and the device. [`Error::Input`] when the list has no place
/// in a run, or the sample clock no tone for one of its frequencies.
pub fn run(
    client: &mut Client,
    points: &[PointSpec],
    labels: RunLabels,
    observe: impl FnMut(&Progress<'_>) -> ControlFlow<()>,
) -> Result<Outcome> {
    run_excited(client, points, ExcitationKind::SingleSine, labels, observe)
}

/// [`run`] with another excitation than tone after tone; broadband lists come
/// from [`super::on_lines`].
///
/// # Errors
/// As [`run`].
pub fn run_excited(
    client: &mut Client,
    points: &[PointSpec],
    excitation: ExcitationKind,
    labels: RunLabels,
    observe: impl FnMut(&Progress<'_>) -> ControlFlow<()>,
) -> Result<Outcome> {
    let record_id = begin(client, points, excitation, labels)?;
    follow(client, record_id, points, observe)
}

/// Starts a run and returns the running number its record will have.
///
/// # Errors
/// As [`run`].
pub fn begin(
    client: &mut Client,
    points: &[PointSpec],
    excitation: ExcitationKind,
    labels: RunLabels,
) -> Result<u32> {
    let list: FixedVec<PointSpec, MAX_POINTS> = FixedVec::from_slice(points).map_err(|_| {
        Error::input(
            "point list",
            format!(
                "has {} points, a run has {MAX_POINTS} at most",
                points.len()
            ),
            "split the list",
        )
    })?;
    let spec = RunSpec {
        points: list,
        excitation,
        labels,
    };
    start_when_it_rests(client, &spec)
}

/// How often a calibrator is asked that writes the record of the run before, or reads its flash after a start:
/// for five seconds, an erased sector included.
const RESTS_WITHIN: u32 = 50;

/// A run that was stopped has told so by then.
const STOPS_WITHIN: u32 = 3;

/// A run that goes on refuses another; one that was stopped is waited for, and so is a calibrator at rest that is busy
/// with its flash.
fn start_when_it_rests(client: &mut Client, spec: &RunSpec) -> Result<u32> {
    let mut excited = 0;
    for _ in 0..RESTS_WITHIN {
        let begun = client.start(spec.clone());
        let is_busy =
            matches!(&begun, Err(Error::Refused(refused)) if refused.refusal == Refusal::Busy);
        if !is_busy {
            return begun;
        }
        excited += u32::from(client.status()?.state.is_exciting());
        if excited > STOPS_WITHIN {
            return begun;
        }
        client.wait(POLL_INTERVAL)?;
    }
    client.start(spec.clone())
}

/// Follows a run that has been started, also by somebody else.
///
/// # Errors
/// As [`run`].
pub fn follow(
    client: &mut Client,
    record_id: u32,
    points: &[PointSpec],
    mut observe: impl FnMut(&Progress<'_>) -> ControlFlow<()>,
) -> Result<Outcome> {
    follow_beside(client, record_id, points, |progress, _| {
        Ok::<_, Error>(observe(progress))
    })
}

/// [`follow`] for who asks the calibrator for other things meanwhile. A request or
/// two at each look: a stop waits for them. An error of `observe` stops the run as
/// well, for nobody follows it any more. Stops meanwhile are for this run alone.
///
/// # Errors
/// As [`run`], and what `observe` returns.
pub fn follow_beside<E: From<Error>>(
    client: &mut Client,
    record_id: u32,
    points: &[PointSpec],
    observe: impl FnMut(&Progress<'_>, &mut Client) -> Result<ControlFlow<()>, E>,
) -> Result<Outcome, E> {
    client.stop_for(Some(record_id));
    let outcome = to_its_end(client, record_id, points, observe);
    client.stop_for(None);
    outcome
}

fn to_its_end<E: From<Error>>(
    client: &mut Client,
    record_id: u32,
    points: &[PointSpec],
    mut observe: impl FnMut(&Progress<'_>, &mut Client) -> Result<ControlFlow<()>, E>,
) -> Result<Outcome, E> {
    let mut follower = Follower {
        client,
        wanted: points,
        results: Vec::new(),
        idle_polls: 0,
    };
    let mut stopping = false;
    loop {
        let status = follower.look()?;
        let progress = Progress {
            status,
            points: &follower.results,
            fraction: fraction(points, &status),
        };
        let flow = match observe(&progress, follower.client) {
            Ok(flow) => flow,
            Err(error) => {
                // Nobody follows any more: the exciter must not go on. If the
                // link is broken, its first error says it.
                let _ = follower.client.stop();
                return Err(error);
            }
        };
        if matches!(
            status.state,
            RunState::Finished | RunState::Stopped | RunState::Failed
        ) {
            return Ok(Outcome {
                record_id,
                state: status.state,
                points: follower.results,
            });
        }
        if flow.is_break() && !stopping {
            follower.client.stop()?;
            stopping = true;
        }
        follower.client.wait(LOOK_INTERVAL)?;
    }
}

struct Follower<'a> {
    client: &'a mut Client,
    wanted: &'a [PointSpec],
    results: Vec<PointResult>,
    idle_polls: u32,
}

impl Follower<'_> {
    /// Asks for the status and for every result that is new.
    fn look(&mut self) -> Result<Status> {
        let status = self.client.status()?;
        self.idle_polls = match status.state {
            RunState::Idle => self.idle_polls + 1,
            _ => 0,
        };
        if self.idle_polls > IDLE_POLLS {
            return Err(Error::input(
                format!("run on {}", self.client.name()),
                "the calibrator is idle: it was reset during the run",
                "`calib info` tells why it was reset, `calib records` what was stored",
            ));
        }
        let ready = match status.state {
            RunState::Idle => 0,
            RunState::Settling | RunState::Measuring => usize::from(status.point),
            _ => self.wanted.len(),
        };
        while self.results.len() < ready.min(self.wanted.len()) {
            // Note: the list is shorter than a run can be, so the index fits.
            let index = self.results.len() as u16;
            let Some(result) = self.client.point(index)? else {
                break;
            };
            self.results.push(result);
        }
        Ok(status)
    }
}

/// Seconds a point may take: settling in 0.5 s or 20 cycles, then blocks of at
/// least 0.2 s or ten cycles. Only the ratios matter here.
fn expected_s(point: &PointSpec) -> f64 {
    let period_s = 1.0 / f64::from(point.frequency_hz).max(0.1);
    (20.0 * period_s).max(0.5) + 5.0 * (10.0 * period_s).max(0.2)
}

fn fraction(points: &[PointSpec], status: &Status) -> f64 {
    if !status.state.is_exciting() {
        return if status.state == RunState::Idle {
            0.0
        } else {
            1.0
        };
    }
    let index = usize::from(status.point).min(points.len());
    let (done, rest) = points.split_at(index);
    let done_s: f64 = done.iter().map(expected_s).sum();
    let rest_s: f64 = rest.iter().map(expected_s).sum();
    let within = f64::from(status.block) / f64::from(status.blocks.max(1));
    let current_s = rest.first().map_or(0.0, expected_s) * within.min(1.0);
    (done_s + current_s) / (done_s + rest_s).max(f64::MIN_POSITIVE)
}
