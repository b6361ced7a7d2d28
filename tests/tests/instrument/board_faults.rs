//! Faults of the board itself: silent first, then a restart that says why, in `info` and on the next
//! record, with every record from before still there. The scenarios are the files in
//! `scenarios/board`.

use calib_core::point::ExcitationKind;
use calib_core::point_state::PointState;
use calib_protocol::message::{ResetCause, RunSpec, RunState};
use calib_protocol::record::{self, Record, RunLabels};
use calib_tests::rigged::{Fault, Rigged, point};
use calib_twin::board::PartFault;
use calib_twin::rig::Rig;
use calib_twin::runner::Emulator;
use serde::Deserialize;
use std::path::Path;
use std::time::Duration;

/// From the start of a run until its point is being measured.
const UNDER_WAY: Duration = Duration::from_millis(450);
/// The rail of the board.
const USUAL_MV: u32 = 3300;
/// The clock's handler, and the place of the time driver in the vector table (line 28).
const CLOCK_HANDLER: &str = "NonMaskableInt";
const NEXT_VECTOR: u64 = 0x0802_0000 + 4 * (16 + 28);

/// A fault and what must come of it.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Scenario {
    what: String,
    fault: Injected,
    /// Part of the reason given after the restart; empty where there is none.
    #[serde(default)]
    reports: String,
    /// Cause of the restart; empty where there is none.
    #[serde(default)]
    reset_cause: String,
    /// Why the point is refused where there is no restart.
    #[serde(default)]
    state: String,
    /// The output is at mid-scale for good at most so long after the fault, ms.
    silent_within_ms: f64,
}

#[derive(Clone, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
enum Injected {
    AdcOverrun,
    DmaError { stream: u8 },
    DmaStops { stream: u8 },
    ClockLost,
    Patch { symbol: String, halfwords: Vec<u16> },
    SupplyFails,
    SupplySinks { to_mv: u32, mv_per_ms: u32 },
    ButtonStuck,
}

#[test]
fn every_fault_of_the_board_is_silent_and_reported() -> Result<(), Fault> {
    let mut rigged = Rigged::with_rig(&Rig::standard())?;
    rigged.adjust(|settings| settings.blocks = 4)?;
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenarios/board");
    let mut files: Vec<_> = std::fs::read_dir(folder)?
        .map(|entry| entry.map(|entry| entry.path()))
        .collect::<Result<_, _>>()?;
    files.sort();
    assert!(files.len() >= 12, "{} scenarios", files.len());
    let mut failures = Vec::new();
    for file in files {
        let scenario: Scenario = toml::from_str(&std::fs::read_to_string(&file)?)
            .map_err(|error| format!("{}: {error}", file.display()))?;
        let name = file.file_stem().unwrap_or_default().to_string_lossy();
        if let Err(fault) = carry_out(&mut rigged, &scenario) {
            failures.push(format!("{name} ({}): {fault}", scenario.what));
        }
    }
    assert!(failures.is_empty(), "\n{}", failures.join("\n"));
    Ok(())
}

/// After this rest an instrument has heard the mains, and drives as soon as it is asked.
const HEARD: Duration = Duration::from_millis(1200);

fn carry_out(rigged: &mut Rigged, scenario: &Scenario) -> Result<(), Fault> {
    let restarts = rigged.board().resets()?.len();
    let records = rigged.client.records()?;
    rigged.client.wait(HEARD)?;
    rigged.client.start(run_of_one())?;
    rigged.client.wait(UNDER_WAY)?;
    if rigged.client.status()?.state != RunState::Measuring {
        return Err("the point is not being measured".into());
    }
    let silent_ms = strike(rigged, &scenario.fault)?;
    println!("silent after {silent_ms:>6.2} ms: {}", scenario.what);
    if silent_ms > scenario.silent_within_ms {
        return Err(format!("silent only after {silent_ms:.1} ms").into());
    }
    let restarted = rigged.board().resets()?.len() > restarts;
    if restarted != !scenario.reset_cause.is_empty() {
        return Err(format!("restarted: {restarted}").into());
    }
    if !restarted {
        return goes_on(rigged, scenario, records.len());
    }
    let info = rigged.client.info()?;
    let cause = format!("{:?}", info.reset_cause);
    let told = info.last_panic.as_deref().unwrap_or_default();
    let watchdog = info.reset_cause == ResetCause::Watchdog;
    if cause != scenario.reset_cause || !(watchdog || told.contains(&scenario.reports)) {
        return Err(format!("restarted by {cause}, told {told:?}").into());
    }
    if scenario.reports.is_empty() && !told.is_empty() {
        return Err(format!("what RAM held means nothing, and yet it told {told:?}").into());
    }
    // All records are there, beside one of this run if its point ended before the
    // fault was noticed; and the next one says what happened.
    let kept = rigged.client.records()?;
    if !kept.starts_with(&records) || kept.len() > records.len() + 1 {
        return Err("records were lost".into());
    }
    let record = next_record(rigged)?;
    let incident = record.incident.as_deref().unwrap_or_default();
    if !incident.contains(&scenario.reports) {
        return Err(format!("the record says {incident:?}").into());
    }
    // Or the third fault within a minute would be no start like the first: `degraded.rs`.
    rigged.client.reset()?;
    Ok(rigged.client.wait(Duration::from_millis(500))?)
}

/// Lets the fault happen, mends it after the restart, and answers after how many ms the output was
/// silent for good.
fn strike(rigged: &Rigged, fault: &Injected) -> Result<f64, Fault> {
    let mut board = rigged.board();
    let restarts = board.resets()?.len();
    let begun = board.elapsed();
    let patch = match fault.clone() {
        Injected::AdcOverrun => board.fail(PartFault::AdcOverrun).map(|()| None),
        Injected::DmaError { stream } => board.fail(PartFault::DmaError { stream }).map(|()| None),
        Injected::DmaStops { stream } => board.fail(PartFault::DmaStops { stream }).map(|()| None),
        Injected::ClockLost => {
            board.fail(PartFault::ClockLost)?;
            let handler = board.symbol(CLOCK_HANDLER)? | 1;
            let vector = [handler as u16, (handler >> 16) as u16];
            Ok(Some((NEXT_VECTOR, board.patch(NEXT_VECTOR, &vector)?)))
        }
        Injected::Patch { symbol, halfwords } => {
            let address = board.symbol(&symbol)? & !1;
            Ok(Some((address, board.patch(address, &halfwords)?)))
        }
        Injected::SupplyFails => board.power_cycle().map(|_| None),
        Injected::SupplySinks { to_mv, mv_per_ms } => {
            sink(&mut board, to_mv, mv_per_ms)?;
            Ok(None)
        }
        Injected::ButtonStuck => board.press_button(true).map(|()| None),
    }?;
    for _ in 0..350 {
        board.run_for(Duration::from_millis(1))?;
        if board.resets()?.len() > restarts {
            break;
        }
    }
    if let Some((address, before)) = patch {
        board.patch(address, &before)?;
    }
    board.run_for(Duration::from_millis(300))?;
    let silent = board.silent_for().ok_or("the output never came to rest")?;
    let at = board.elapsed() - silent;
    Ok(at.saturating_sub(begun).as_secs_f64() * 1e3)
}

/// Lets the rail sink to `to_mv`, holds it there, and gives it back.
fn sink(board: &mut Emulator, to_mv: u32, mv_per_ms: u32) -> Result<(), Fault> {
    for millivolts in (to_mv..USUAL_MV).rev().step_by(mv_per_ms as usize) {
        board.set_supply(millivolts)?;
        board.run_for(Duration::from_millis(1))?;
    }
    // It has restarted, and waits: it drives nothing and says nothing.
    board.run_for(Duration::from_millis(200))?;
    drop(board.read_serial());
    board.write_serial(&[0, 0]);
    board.run_for(Duration::from_millis(100))?;
    if board.leds()?.green || board.silent_for() < Some(Duration::from_millis(300)) {
        return Err("it works with too little supply".into());
    }
    Ok(board.set_supply(USUAL_MV)?)
}

/// The point was refused, and the instrument goes on.
fn goes_on(rigged: &mut Rigged, scenario: &Scenario, records: usize) -> Result<(), Fault> {
    let status = rigged.client.status()?;
    let state = match rigged.client.point(0)?.map(|result| result.state) {
        Some(PointState::Refused(reason)) => format!("{reason:?}"),
        other => format!("{other:?}"),
    };
    let lost = state == "Overrun";
    if state != scenario.state || (lost && status.overruns == 0) {
        return Err(format!("{state}, {} overruns", status.overruns).into());
    }
    if let Injected::ButtonStuck = scenario.fault {
        stuck(rigged, records)?;
    }
    // What happened before was told once.
    match next_record(rigged)?.incident {
        None => Ok(()),
        Some(incident) => Err(format!("told twice: {incident}").into()),
    }
}

/// A button that stays down has stopped the run and starts none; then it is mended. That it allows
/// nothing after a minute is `firmware/src/button.rs`'s to show.
fn stuck(rigged: &mut Rigged, records: usize) -> Result<(), Fault> {
    rigged.client.wait(Duration::from_secs(1))?;
    if rigged.client.records()?.len() != records + 1 {
        return Err("a run by itself".into());
    }
    rigged.board().press_button(false)?;
    Ok(rigged.client.wait(Duration::from_millis(60))?)
}

/// A run of one point that passes, and its record.
fn next_record(rigged: &mut Rigged) -> Result<Record, Fault> {
    let outcome = rigged.run(&[point(160.0, 10.0)])?;
    if outcome.points.first().map(|point| point.state) != Some(PointState::Valid) {
        return Err("the next run does not pass".into());
    }
    Ok(record::decode(&rigged.record(outcome.record_id)?)?)
}

fn run_of_one() -> RunSpec {
    RunSpec {
        points: [point(160.0, 10.0)].into_iter().collect(),
        labels: RunLabels::default(),
        // For all of its blocks, or it might be over before the fault.
        excitation: ExcitationKind::HeldSine,
    }
}

#[test]
fn a_tap_starts_a_press_stops_and_a_stuck_button_does_nothing() -> Result<(), Fault> {
    let mut rigged = Rigged::with_rig(&Rig::standard())?;
    rigged.under_a_hand(|_| Ok(()))?;
    assert_eq!(rigged.client.status()?.points, 28, "the default list");
    rigged.client.wait(Duration::from_secs(1))?;
    // From here on the button is stuck: it stops the run, and that was all.
    rigged.board().press_button(true)?;
    rigged.client.wait(Duration::from_secs(1))?;
    assert_eq!(rigged.client.status()?.state, RunState::Stopped);
    rigged.expect_silence(Duration::from_secs(1))?;
    assert_eq!(rigged.client.records()?.len(), 1, "no second run");
    // Stuck at boot it starts nothing and allows nothing, and a host still can run.
    rigged.client.reset()?;
    rigged.client.wait(Duration::from_secs(1))?;
    assert_eq!(rigged.client.status()?.state, RunState::Idle);
    let mut settings = rigged.client.settings()?;
    settings.reference.due_day += 1;
    assert!(rigged.client.write_settings(settings).is_err());
    assert_eq!(rigged.run(&[point(160.0, 10.0)])?.state, RunState::Finished);
    let unused = rigged.unused_stack_bytes()?;
    let told = rigged.client.info()?.stack_unused_bytes as usize;
    // Answering may have gone deeper than the look from outside saw.
    assert!(told.abs_diff(unused) <= 512, "it says {told}");
    assert!(unused >= 10 << 10, "less than 10 KiB are left");
    Ok(())
}
