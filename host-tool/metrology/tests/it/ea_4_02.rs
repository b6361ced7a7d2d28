//! Supplements of EA-4/02: S2 to S7 and S9 to S12 (S1 and S8 are introductions).
//!
//! Inputs are those the supplements state; where a supplement prints digits
//! that only follow from its own rounded intermediate results, the test says
//! so and evaluates those.

use calib_metrology::budget::type_a;
use calib_metrology::budget::{self, CoverageBasis, CoverageRule};

use crate::budget::{Case, INF, Row, budget_of, prints, r, row};

#[test]
fn ea_4_02_examples_with_a_normal_or_t_output() {
    let cases: [Case; 5] = [
        (
            "S2",
            vec![
                row(22.5e-3, 1.0, INF, 'N'),
                row(8.95e-3, 1.0, INF, 'R'),
                row(14.4e-3, 1.0, 2.0, 'N'),
                row(5.77e-3, 1.0, INF, 'R'),
                row(5.77e-3, 1.0, INF, 'R'),
            ],
            "0.0293",
            "2.08",
            "0.061",
        ),
        (
            "S3, milliohm",
            vec![
                row(2.5, 1.0, INF, 'N'),
                row(r(10.0), 1.0, INF, 'R'),
                row(r(2.75), 1.0, INF, 'R'),
                row(r(5.5), 1.0, INF, 'R'),
                row(1.0e-6 / 6.0_f64.sqrt(), 1.0e7, INF, 'T'),
                row(0.07e-6, 1.0e7, 4.0, 'N'),
            ],
            "8.33",
            "2.00",
            "17",
        ),
        (
            "S4, nanometre",
            vec![
                row(15.0, 1.0, INF, 'N'),
                row(r(30.0), 1.0, INF, 'R'),
                row(5.37, 1.0, 4.0, 'N'),
                row(r(32.0), 1.0, INF, 'R'),
                row(r(0.05), -575.0, INF, 'R'),
                row(0.236, 50.0, INF, 'S'),
                row(r(6.7), -1.0, INF, 'R'),
            ],
            "36.4",
            "2.00",
            "73",
        ),
        (
            "S5, degree Celsius",
            vec![
                row(0.1, 1.0, INF, 'N'),
                row(1.0, 0.077, INF, 'N'),
                row(r(0.5), 0.077, INF, 'R'),
                row(r(2.0), 0.077, INF, 'R'),
                row(r(0.1), -0.407, INF, 'R'),
                row(0.15, 1.0, INF, 'N'),
                row(r(0.3), 1.0, INF, 'R'),
                row(r(1.0), 1.0, INF, 'R'),
            ],
            "0.641",
            "2.00",
            "1.3",
        ),
        // The rows of the attenuator as rounded in its table.
        ("S7, as tabulated", attenuator(), "0.0224", "2.00", "0.045"),
    ];
    for (name, rows, u, k, expanded) in cases {
        println!("{name}");
        let evaluation = budget::evaluate(&budget_of(&rows, CoverageRule::Probability(0.9545)));
        prints(evaluation.combined_standard_uncertainty, u);
        prints(evaluation.coverage_factor, k);
        prints(evaluation.expanded_uncertainty, expanded);
        assert_eq!(evaluation.coverage_basis, CoverageBasis::StudentT);
    }
    let s2 = budget::evaluate(&budget_of(
        &[
            row(22.5e-3, 1.0, INF, 'N'),
            row(8.95e-3, 1.0, INF, 'R'),
            row(14.4e-3, 1.0, 2.0, 'N'),
            row(5.77e-3, 1.0, INF, 'R'),
            row(5.77e-3, 1.0, INF, 'R'),
        ],
        CoverageRule::Default,
    ));
    prints(s2.effective_degrees_of_freedom, "34.4");
}

fn attenuator() -> Vec<Row> {
    vec![
        row(9.0e-3, 1.0, INF, 'N'),
        row(2.5e-3, 1.0, INF, 'R'),
        row(1.1e-3, 1.0, INF, 'U'),
        row(2.0e-2, 1.0, INF, 'U'),
        row(1.7e-3, 1.0, INF, 'U'),
        row(3.0e-4, -1.0, INF, 'U'),
        row(3.0e-4, 1.0, INF, 'R'),
        row(2.0e-3, -1.0, INF, 'R'),
        row(2.0e-3, 1.0, INF, 'N'),
    ]
}

/// Mean of readings and its standard uncertainty.
fn observed(readings: &[f64]) -> (f64, f64) {
    let observed = type_a::observe(&[readings]).expect("several readings");
    (observed.mean[0], observed.covariance[(0, 0)].sqrt())
}

#[test]
fn ea_4_02_s6_power_sensor_from_its_statements() {
    // K_X = (K_S + dK_D) (M_Sr M_Xc)/(M_Sc M_Xr) p_Cr p_Cc p.
    let (p, u_p) = observed(&[0.9772, 0.9671, 0.9836]);
    let k_s = 0.957 - 0.001;
    let k_x = k_s * p;
    let mismatch = |limit: f64| limit / 2.0_f64.sqrt();
    let rows = [
        row(0.011 / 2.0, p, INF, 'N'),
        row(r(0.002), p, INF, 'R'),
        row(mismatch(0.0008), k_x, INF, 'U'),
        row(mismatch(0.014), -k_x, INF, 'U'),
        row(mismatch(0.0008), -k_x, INF, 'U'),
        row(mismatch(0.0168), k_x, INF, 'U'),
        row(0.001_42, k_x, INF, 'N'),
        row(0.000_142, k_x, INF, 'N'),
        row(u_p, k_s, 2.0, 'N'),
    ];
    let result = budget::evaluate(&budget_of(&rows, CoverageRule::Default));
    prints(k_x, "0.933");
    prints(result.combined_standard_uncertainty, "0.0162");
    assert_eq!(result.coverage_factor, 2.0);
    prints(result.expanded_uncertainty, "0.032");
}

#[test]
fn ea_4_02_s7_attenuator_from_its_statements() {
    let (mean, u_mean) = observed(&[30.033, 30.058, 30.018, 30.052]);
    let rows = [
        row(u_mean, 1.0, 3.0, 'N'),
        row(0.005 / 2.0, 1.0, INF, 'N'),
        row(r(0.002), 1.0, INF, 'R'),
        row(0.02, 1.0, INF, 'U'),
        row(r(0.003), 1.0, INF, 'R'),
        row(r(0.0005), 1.0, INF, 'R'),
        row(r(0.0005), -1.0, INF, 'R'),
        row(0.002, 1.0, INF, 'N'),
        row(0.002, -1.0, INF, 'N'),
    ];
    let result = budget::evaluate(&budget_of(&rows, CoverageRule::Default));
    prints(mean + 0.003, "30.043");
    prints(result.combined_standard_uncertainty, "0.0224");
    assert_eq!(result.coverage_factor, 2.0);
    prints(result.expanded_uncertainty, "0.045");
}

#[test]
fn ea_4_02_examples_with_dominant_rectangles() {
    let at_95 = CoverageRule::Probability(0.95);
    let s9 = [
        row(0.001, -1.0, INF, 'N'),
        row(r(0.05), 1.0, INF, 'R'),
        row(r(0.011), -1.0, INF, 'R'),
    ];
    let s9 = budget::evaluate(&budget_of(&s9, at_95));
    assert_eq!(s9.coverage_basis, CoverageBasis::Rectangular);
    prints(s9.combined_standard_uncertainty, "0.030");
    prints(s9.coverage_factor, "1.65");
    prints(s9.expanded_uncertainty, "0.05");

    // S10 in micrometres: half-widths 25 and 50, so beta = 1/3.
    let s10 = |resolution: f64, mechanical: f64| {
        let rows = [
            row(0.46, -1.0, INF, 'R'),
            row(1.15, 1.7, INF, 'R'),
            row(resolution, 1.0, INF, 'R'),
            row(mechanical, 1.0, INF, 'R'),
        ];
        budget::evaluate(&budget_of(&rows, at_95))
    };
    assert_eq!(
        s10(r(25.0), r(50.0)).coverage_basis,
        CoverageBasis::Trapezoidal
    );
    prints(s10(r(25.0), r(50.0)).coverage_factor, "1.83");
    // Its combined uncertainty is of the rounded 15 and 29, as printed there.
    prints(s10(15.0, 29.0).combined_standard_uncertainty, "33");
    prints(s10(15.0, 29.0).expanded_uncertainty / 1000.0, "0.06");

    let s11 = [15.0, 10.0, 23.0, 29.0, 58.0, 144.0, 29.0, 17.0];
    let rows: Vec<_> = s11
        .iter()
        .enumerate()
        .map(|(n, &u)| row(u / 1000.0, 1.0, INF, if n < 2 { 'N' } else { 'R' }))
        .collect();
    let s11 = budget::evaluate(&budget_of(&rows, at_95));
    assert_eq!(s11.coverage_basis, CoverageBasis::Trapezoidal);
    prints(s11.combined_standard_uncertainty, "0.164");
    prints(s11.expanded_uncertainty, "0.3");
    // 1.81 is printed. Its own beta = 0.43 in its own formula (S10.13) gives
    // 1.796, and the exact law of all eight inputs 1.83: the last digit of the
    // print follows from neither.
    prints(s11.coverage_factor, "1.80");
}

#[test]
fn ea_4_02_s12_truncates_the_degrees_of_freedom() {
    let rows = [row(0.60e-3, 1.0, 2.0, 'N'), row(0.68e-3, 1.0, INF, 'N')];
    let mut s12 = budget_of(&rows, CoverageRule::Probability(0.9545));
    let interpolated = budget::evaluate(&s12);
    prints(interpolated.combined_standard_uncertainty, "9.1e-4");
    prints(interpolated.effective_degrees_of_freedom, "10.4");
    prints(interpolated.coverage_factor, "2.27");
    s12.truncate_degrees_of_freedom = true;
    let truncated = budget::evaluate(&s12);
    prints(truncated.coverage_factor, "2.28");
    prints(truncated.expanded_uncertainty, "2e-3");
}
