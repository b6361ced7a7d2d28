//! `calib selfcheck` by the shipping image: the ten runs of a check on the emulated board.

use calib_core::point::PointSpec;
use calib_link::session;
use calib_metrology::reciprocity::{Evaluation, Runs, change, evaluate};
use calib_protocol::record::Record;
use calib_tests::bench::{Bench, Fault, point, true_certificate};
use calib_tests::self_check::{equipment, plan};
use calib_twin::oracle;
use calib_twin::reciprocity::session::{Level, RUNS};
use calib_twin::reciprocity::{Hold, SelfCheckDraw};
use std::time::Duration;

/// A whole check is to take no longer, without the hands.
const LONGEST: Duration = Duration::from_secs(240);

fn list(levels: &[Level], is_loaded: bool) -> Vec<PointSpec> {
    let level = |level: &Level| {
        let level_rms_ms2 = if is_loaded {
            level.loaded_rms_ms2
        } else {
            level.bare_rms_ms2
        };
        point(level.frequency_hz as f32, level_rms_ms2 as f32)
    };
    levels.iter().map(level).collect()
}

/// The ten records of a check, and what they say.
fn checked(bench: &mut Bench, draw: &SelfCheckDraw, levels: &[Level]) -> Result<Evaluation, Fault> {
    let mut records: Vec<Record> = Vec::new();
    let folder = tempfile::tempdir()?;
    for (mounting, input) in RUNS {
        // 4 K: as it is after some runs.
        bench.mount(&draw.loaded(mounting, input, if mounting.is_some() { 4.5 } else { 4.0 }));
        let id = bench.run_held(&list(levels, mounting.is_some()))?.record_id;
        records.push(session::download(&mut bench.client, id, folder.path(), |_| ())?.record);
        bench.client.release(id)?;
    }
    let records: Vec<&Record> = records.iter().collect();
    Ok(evaluate(&Runs::from_records(&records)?, &equipment(draw))?)
}

/// A drawn calibrator whose network is linear: what bends takes the plant ten times as long, and is in the drawn
/// checks.
fn calibrator() -> SelfCheckDraw {
    let mut draw = SelfCheckDraw::new(11, Hold::Current);
    draw.rig.effects.clear();
    draw
}

/// Every other frequency of a check, so that it takes half of the time; then, with fewer blocks, one of a reference
/// that lost 1 %.
#[test]
fn a_check_finds_the_reference_within_its_uncertainty_in_four_minutes_and_its_drift()
-> Result<(), Fault> {
    let draw = calibrator();
    let mut bench = Bench::with_rig(&draw.rig)?;
    bench.certify_reference(&true_certificate(&draw.rig))?;
    let all = plan(0.050, draw.stated.mass_kg).levels;
    let half: Vec<Level> = all.iter().copied().step_by(2).collect();
    assert_eq!(2 * half.len(), all.len());
    let begun = bench.board().elapsed();
    let found = checked(&mut bench, &draw, &half)?;
    let took = bench.board().elapsed() - begun;
    println!(
        "half a check: {:.1} s, {:?}",
        took.as_secs_f64(),
        found.exciter
    );
    assert!(2 * took <= LONGEST, "{took:?}");
    for point in &found.points {
        let truth = oracle::reference_sensitivity(&draw.rig, point.frequency_hz);
        let error_rel = point.sensitivity_v_per_ms2 / truth.norm() - 1.0;
        println!(
            "{:>6} Hz {:+.3} % U {:.3} %",
            point.frequency_hz,
            100.0 * error_rel,
            100.0 * point.expanded_uncertainty_rel,
        );
        // Seven statements of 95 %: beyond 1.5 U lies one in 370.
        assert!(
            error_rel.abs() <= 1.5 * point.expanded_uncertainty_rel,
            "{point:?}"
        );
    }

    bench.adjust(|settings| settings.blocks = 2)?;
    let changed = draw.on_another_day(1).with_reference_changed(0.99);
    let drifted =
        change(&checked(&mut bench, &changed, &half)?, &found).ok_or("four frequencies")?;
    println!("{drifted:?}");
    assert!(drifted.significant, "{drifted:?}");
    assert!(
        (drifted.change_rel + 0.01).abs() <= 1.5 * drifted.expanded_rel,
        "{drifted:?}"
    );
    Ok(())
}
