//! Effects far larger than what the runs may differ by.

use super::sealed::design;
use super::sealed::random::Random;
use super::sealed::table::{self, GOOD, Quality};
use super::sealed::truth::Truth;
use calib_gap::{Options, Verdict, diagnose};

/// Over eleven runs the device drifts by 13 %, where a mounting may change it by 0.02 %: without a
/// drift the runs' gains take it on, and must give it back once it is tried.
#[test]
fn a_large_drift_is_named_although_the_runs_could_hide_it() {
    let mut random = Random::new(11);
    let mut truth = Truth::honest(&mut random);
    truth.effects.insert("dut_drift.b", 3e-5);
    let folder = tempfile::tempdir().expect("a folder");
    let mut rows = design::full();
    for (n, row) in rows.iter_mut().enumerate() {
        row.run = n / 20;
    }
    let precise = Quality {
        u_ratio: 2e-4,
        u_phase_deg: 0.02,
        ..GOOD
    };
    let points = table::points(&truth, &rows, &precise, false, &mut random);
    std::fs::write(folder.path().join("points.csv"), points).expect("written");
    std::fs::write(folder.path().join("rig.toml"), table::rig()).expect("written");
    let answer = diagnose(folder.path(), &Options::default()).expect("a good dataset");
    assert_eq!(answer.verdict, Verdict::Explained);
    assert_eq!(answer.causes[0].effects, ["dut_drift"]);
}
