//! A list measured once: followed with its progress, stopped by Ctrl-C, and kept.

use super::again::Followed;
use super::{Context, alarm, progress::RunProgress};
use calib_core::point::{ExcitationKind, PointSpec};
use calib_core::point_state::PointState;
use calib_host::in_unit::Stating;
use calib_host::refusals;
use calib_host::{Error, Result};
use calib_link::session::{self, Outcome};
use calib_link::{Client, StopSwitch};
use calib_logbook::{Logbook, waiting};
use calib_protocol::message::RunState;
use calib_protocol::record::{Record, RunLabels};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

/// The record of a run.
pub(super) struct Kept {
    /// Its number in the logbook; none while it waits for that, and where this user has none.
    pub(super) id: Option<i64>,
    pub(super) record: Record,
}

/// Fetches the record, and keeps it in the logbook, if this user has one. None of a run that could not be stored.
pub(super) fn keep(
    context: &Context,
    client: &mut Client,
    outcome: &Outcome,
) -> Result<Option<Kept>> {
    let path = context.logbook_path();
    if outcome.state == RunState::Failed {
        return Ok(None);
    }
    let (record, bytes) = session::take(client, outcome.record_id)?;
    if !path.exists() {
        return Ok(Some(Kept { id: None, record }));
    }
    // It is on disk before the logbook is asked for, which another program may hold.
    let place = waiting::put(&path, &bytes)?;
    let keys = session::stated_key(client)?;
    let id = enter(context, &path, keys.as_slice())
        .ok()
        .and_then(|entered| {
            let of_run = |(of, _): &&(PathBuf, i64)| *of == place;
            entered.iter().find(of_run).map(|(_, id)| *id)
        });
    Ok(Some(Kept { id, record }))
}

/// Enters the records that wait for the logbook; why it takes them later, in words that were told.
pub(super) fn enter(
    context: &Context,
    path: &Path,
    keys: &[waiting::Stated],
) -> Result<Vec<(PathBuf, i64)>, String> {
    let entered = Logbook::enter_waiting(path, keys).map_err(|error| {
        let folder = waiting::folder(path);
        let until = format!("the record waits in {} until then", folder.display());
        context.remark(&format!("{error}: {until}; the next run enters it"));
        error.to_string()
    })?;
    if let Some(objection) = entered.objection() {
        context.remark(&objection.to_string());
    }
    Ok(entered.numbers)
}

/// A measurement asked for, and how it is shown.
pub(super) struct Asked<'a> {
    pub(super) points: &'a [PointSpec],
    pub(super) excitation: ExcitationKind,
    pub(super) stating: Stating,
}

/// Runs a list with progress, over another link if this one breaks. Ctrl-C stops it and silences the exciter.
pub(super) fn measure(
    context: &Context,
    client: &mut Client,
    asked: &Asked<'_>,
    labels: RunLabels,
    switch: &StopSwitch,
    progress: &mut RunProgress<'_>,
) -> Result<Outcome> {
    let serial = client.info()?.serial;
    // Ahead of any answer that is waited for; the look at each progress is a second way.
    client.heed(switch.clone());
    let points = asked.points;
    let followed = Followed {
        context,
        points,
        switch,
        record_id: session::begin(client, points, asked.excitation, labels)?,
        serial: &serial,
    };
    followed.to_its_end(client, |state| {
        progress.show(state, points);
        match refusals::dead_from_the_start(state.points) {
            Some(_) => ControlFlow::Break(()),
            None => flow(switch),
        }
    })
}

/// From now on, Ctrl-C asks a run to stop instead of ending the tool.
pub(super) fn stop_on_interrupt(context: &Context) -> impl Fn() -> ControlFlow<()> + use<> {
    let switch = context.switch.clone().unwrap_or_else(|| {
        let switch = StopSwitch::default();
        let pressed = switch.clone();
        // Without the handler Ctrl-C still ends this tool; the calibrator goes on.
        let _ = ctrlc::set_handler(move || {
            pressed.ask();
        });
        switch
    });
    move || flow(&switch)
}

/// From now on, Ctrl-C is a stop on this switch, which a client heeds; one that is not confirmed in time is an
/// alarm, where there is an exciter. That of a program that asked is stopped by [`ask_for_silence`].
pub(super) fn switch_of_interrupts(context: &Context) -> StopSwitch {
    if let Some(switch) = &context.switch {
        return switch.clone();
    }
    let (switch, emulated) = (StopSwitch::default(), !context.is_outside());
    let pressed = switch.clone();
    let _ = ctrlc::set_handler(move || {
        ask_for_silence(&pressed, emulated);
    });
    switch
}

/// Asks a run for silence, and returns the number of this stop. One that is not confirmed in time is an alarm on
/// standard error, unless no exciter is there to be heard.
pub fn ask_for_silence(switch: &StopSwitch, emulated: bool) -> u64 {
    let (number, confirmed) = (switch.ask(), switch.clone());
    // It ends with its stop, or with this program.
    drop(alarm::watch(move || {
        confirmed.is_confirmed(number) || emulated
    }));
    number
}

fn flow(switch: &StopSwitch) -> ControlFlow<()> {
    match switch.is_asked() {
        true => ControlFlow::Break(()),
        false => ControlFlow::Continue(()),
    }
}

/// Turns anything but a full pass into exit code 7.
pub(super) fn judge(outcome: &Outcome, wanted: usize) -> Result<()> {
    let refused = outcome
        .points
        .iter()
        .filter(|point| point.state != PointState::Valid)
        .count();
    match outcome.state {
        RunState::Failed => Err(Error::NotPassed(
            "the record could not be stored; the results above are all there is".to_owned(),
        )),
        RunState::Stopped if refusals::dead_from_the_start(&outcome.points).is_some() => {
            Err(Error::NotPassed(format!(
                "the device under test gives no signal: the other points of {wanted} were not tried"
            )))
        }
        RunState::Stopped => Err(Error::NotPassed(format!(
            "stopped after {} of {wanted} points; the exciter is silent",
            outcome.points.len()
        ))),
        _ if refused > 0 => Err(Error::NotPassed(format!(
            "{refused} of {wanted} points were refused"
        ))),
        _ => Ok(()),
    }
}
