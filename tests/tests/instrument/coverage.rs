//! The uncertainty is a promise: firmware in the loop, with known truth.

use calib_tests::coverage;

/// 200 draws of three points. Were the coverage 95.4 %, 600 points with errors
/// shared within a draw scatter by about 1.2 %; 93 % to 97.5 % is the band
/// and excludes a budget off by more than a fifth.
#[test]
fn expanded_uncertainty_contains_the_truth_about_95_times_in_100() {
    let tally = coverage::run(200, 10_000, |_| ()).expect("every draw runs");
    println!("{tally:?}");
    assert_eq!(tally.refused, [], "{tally:?}");
    for percent in [tally.magnitude_percent(), tally.phase_percent()] {
        assert!((93.0..=97.5).contains(&percent), "{percent} % of {tally:?}");
    }
}
