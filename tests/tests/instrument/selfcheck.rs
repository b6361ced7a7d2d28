//! `calib selfcheck` by the shipping image: the ten runs of a check on the emulated board.

use calib_metrology::reciprocity::change;
use calib_tests::rigged::{Fault, Rigged, true_certificate};
use calib_tests::self_check::{LONGEST, by_image, linear, plan};
use calib_twin::oracle;
use calib_twin::reciprocity::session::Level;

/// Every other frequency of a check, so that it takes half of the time; then, with fewer blocks, one of a reference
/// that lost 1 %.
#[test]
fn a_check_finds_the_reference_within_its_uncertainty_in_four_minutes_and_its_drift()
-> Result<(), Fault> {
    let draw = linear(11);
    let mut rigged = Rigged::with_rig(&draw.rig)?;
    rigged.certify_reference(&true_certificate(&draw.rig))?;
    let all = plan(0.050, draw.stated.mass_kg).levels;
    let half: Vec<Level> = all.iter().copied().step_by(2).collect();
    assert_eq!(2 * half.len(), all.len());
    let begun = rigged.board().elapsed();
    let found = by_image(&mut rigged, &draw, &half)?;
    let took = rigged.board().elapsed() - begun;
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

    rigged.adjust(|settings| settings.blocks = 2)?;
    let changed = draw.on_another_day(1).with_reference_changed(0.99);
    let drifted =
        change(&by_image(&mut rigged, &changed, &half)?, &found).ok_or("four frequencies")?;
    println!("{drifted:?}");
    assert!(drifted.significant, "{drifted:?}");
    assert!(
        (drifted.change_rel + 0.01).abs() <= 1.5 * drifted.expanded_rel,
        "{drifted:?}"
    );
    Ok(())
}
