//! Faults that happen on site end in a named reason, a silent exciter and a record, and never in a
//! table that runs away. The scenarios are the files in `scenarios/site`.

use calib_core::point_state::PointState;
use calib_link::Error;
use calib_link::session::Outcome;
use calib_protocol::message::RunState;
use calib_tests::rigged::{Fault, Rigged, point};
use calib_tests::witness::{Seen, Witness};
use calib_twin::rig::Rig;
use serde::Deserialize;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// Acceleration that no fault may make the loop exceed, relative to the set level.
const HIGHEST_REL: f64 = 1.5;

/// Longest time the exciter is driven once a block has told that it must not be. Evaluating a block and
/// overwriting the ring take part of it; the ring itself would last 20 ms.
const BEYOND_DETECTION_MS: f64 = 3.0;

/// A run that is refused was silent long before it was asked for.
const STILL_SILENT: Duration = Duration::from_millis(200);

/// A fault and what must come of it.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Scenario {
    what: String,
    frequency_hz: f32,
    level_ms2: f32,
    effects: Vec<String>,
    faults: Vec<String>,
    /// Name of the reason, or `Valid`; more than one where chance decides.
    states: Vec<String>,
    /// Highest acceleration of the table, relative to the set level.
    #[serde(default = "usual_highest_rel")]
    highest_rel: f64,
    /// How long it may be above 1.5 times the set level, ms.
    #[serde(default)]
    above_for_ms: f64,
    /// Account of all blocks of the point: its tone ends as that of every point does.
    #[serde(default)]
    judged_at_the_end: bool,
    /// From mounting the rig to asking for the run, s.
    #[serde(default)]
    mounted_for_s: f64,
    /// The run is refused for this: there is no point, and no record.
    #[serde(default)]
    not_started: Option<String>,
}

fn usual_highest_rel() -> f64 {
    HIGHEST_REL
}

#[test]
fn every_fault_ends_in_its_reason_silence_and_a_record() -> Result<(), Fault> {
    let mut rigged = Rigged::with_rig(&Rig::standard())?;
    // From some 0.2 s on a point is measured, for half a second.
    rigged.adjust(|settings| settings.blocks = 5)?;
    let mut failures = Vec::new();
    let files = scenario_files()?;
    assert!(files.len() >= 20, "{} scenarios", files.len());
    for file in &files {
        let scenario: Scenario = toml::from_str(&std::fs::read_to_string(file)?)
            .map_err(|error| format!("{}: {error}", file.display()))?;
        let name = file.file_stem().unwrap_or_default().to_string_lossy();
        for failure in carry_out(&mut rigged, &scenario)? {
            failures.push(format!("{name} ({}): {failure}", scenario.what));
        }
    }
    assert!(failures.is_empty(), "\n{}", failures.join("\n"));
    Ok(())
}

/// Runs one point and says what was not as it must be.
fn carry_out(rigged: &mut Rigged, scenario: &Scenario) -> Result<Vec<String>, Fault> {
    let set_peak_ms2 = f64::from(scenario.level_ms2) * std::f64::consts::SQRT_2;
    let pairs = rigged.board().sample_pairs();
    let (witness, seen) = Witness::new(&scenario.rig()?, HIGHEST_REL * set_peak_ms2, pairs);
    drop(rigged.board().replace_rig(Box::new(witness)));
    let records = rigged.client.records()?.len();
    rigged
        .client
        .wait(Duration::from_secs_f64(scenario.mounted_for_s))?;
    let started = rigged.run_held(&[point(scenario.frequency_hz, scenario.level_ms2)]);
    if let Some(reason) = &scenario.not_started {
        return not_started(rigged, started, reason, records);
    }
    let mut failures = scenario.wrong_with_motion(&seen.take(), set_peak_ms2);
    failures.extend(wrong_with_record(rigged, scenario, &started?, records)?);
    rigged.expect_silence(Duration::from_millis(100))?;
    if rigged.client.status()?.overruns != 0 {
        failures.push("samples lost".to_owned());
    }
    Ok(failures)
}

impl Scenario {
    fn rig(&self) -> Result<Rig, Fault> {
        let mut rig = Rig::standard();
        for effect in &self.effects {
            rig.effects.push(effect.parse()?);
        }
        for fault in &self.faults {
            rig.faults.push(fault.parse()?);
        }
        Ok(rig)
    }

    /// Forbidden motion of the table.
    fn wrong_with_motion(&self, seen: &Seen, set_peak_ms2: f64) -> Vec<String> {
        let highest_rel = seen.highest_ms2 / set_peak_ms2;
        let (above_ms, driven_ms) = (seen.above_for_ms, seen.driven_after_block_ms);
        println!(
            "{highest_rel:>8.2} of the set level, above 1.5 for {above_ms:.1} ms, driven for \
             {driven_ms:.1} ms beyond the block that told: {}",
            self.what
        );
        let mut failures = Vec::new();
        if highest_rel > self.highest_rel {
            failures.push(format!(
                "the table reached {highest_rel:.2} of the set level"
            ));
        }
        if above_ms > self.above_for_ms {
            failures.push(format!("above 1.5 of the set level for {above_ms:.1} ms"));
        }
        if !self.judged_at_the_end && driven_ms > BEYOND_DETECTION_MS {
            failures.push(format!("driven for {driven_ms:.2} ms beyond detection"));
        }
        failures
    }
}

/// Forbidden claims of result and record. There were `records` before.
fn wrong_with_record(
    rigged: &mut Rigged,
    scenario: &Scenario,
    outcome: &Outcome,
    records: usize,
) -> Result<Vec<String>, Fault> {
    let result = outcome.points.first().ok_or("no result")?;
    let state = match result.state {
        PointState::Valid => "Valid".to_owned(),
        PointState::Refused(reason) => format!("{reason:?}"),
    };
    println!("{state:<20}");
    let mut failures = Vec::new();
    if !scenario.states.contains(&state) {
        failures.push(format!("state {state}"));
    }
    if outcome.state == RunState::Failed {
        failures.push("not stored".to_owned());
    }
    if outcome.record_id as usize != records + 1 {
        failures.push("another record".to_owned());
    }
    let refused = rigged.client.records()?.last().map(|record| record.refused);
    if refused != Some(u16::from(state != "Valid")) {
        failures.push("the record does not say so".to_owned());
    }
    Ok(failures)
}

/// Checks a start that must not happen: the instrument declines, stays silent, and stores nothing.
fn not_started(
    rigged: &mut Rigged,
    started: Result<Outcome, Fault>,
    reason: &str,
    records: usize,
) -> Result<Vec<String>, Fault> {
    let mut failures = Vec::new();
    let refusal = match started {
        Ok(_) => "started".to_owned(),
        Err(fault) => match fault.downcast_ref::<Error>() {
            Some(Error::Refused(refused)) => format!("{:?}", refused.refusal),
            _ => return Err(fault),
        },
    };
    if refusal != reason {
        failures.push(format!("{refusal} in place of {reason}"));
    }
    if rigged.board().silent_for() < Some(STILL_SILENT) {
        failures.push("the exciter moved".to_owned());
    }
    if rigged.client.records()?.len() != records {
        failures.push("a record of nothing".to_owned());
    }
    println!("{refusal:<20} and silent");
    Ok(failures)
}

fn scenario_files() -> Result<Vec<PathBuf>, Fault> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenarios/site");
    let mut files: Vec<PathBuf> = std::fs::read_dir(folder)?
        .map(|entry| entry.map(|entry| entry.path()))
        .collect::<Result<_, _>>()?;
    files.sort();
    Ok(files)
}
