//! Published budgets, in f32.

use super::coverage::PROBABILITY_K2;
use super::*;
use crate::channel_ratio::ChannelRatioPoint;
use crate::point::{PointResult, PointSpec};
use crate::point_state::Reason;
use crate::settings::{Distribution, Settings};

const RECTANGULAR: Distribution = Distribution::Rectangular;
const TWO: Distribution = Distribution::Normal {
    coverage_factor: 2.0,
};
const ONE: Distribution = Distribution::Normal {
    coverage_factor: 1.0,
};

/// A component by value and distribution.
fn line(value: f32, distribution: Distribution) -> Component<'static> {
    Component::new(Row::a1(18), value, distribution)
}

/// A standard uncertainty with degrees of freedom.
fn standard(value: f32, degrees_of_freedom: f32) -> Component<'static> {
    line(value, ONE).with_degrees_of_freedom(degrees_of_freedom)
}

fn budget(components: impl IntoIterator<Item = Component<'static>>) -> Budget<'static> {
    let mut budget = Budget::new();
    for component in components {
        budget.add(component).expect("a valid component");
    }
    budget
}

fn close(value: f32, expected: f64, tolerance: f64) {
    let error = (f64::from(value) / expected - 1.0).abs();
    assert!(error <= tolerance, "{value} is not {expected}");
}

/// Table D.1: row of A.1, value, distribution, printed contribution, percent.
fn table_d1() -> [(u8, f32, Distribution, &'static str); 17] {
    let transverse = Distribution::Special {
        divisor: 18.0_f32.sqrt(),
    };
    [
        (1, 0.5, TWO, "0.25"),
        (10, 0.15, RECTANGULAR, "0.087"),
        (2, 0.25, RECTANGULAR, "0.14"),
        (3, 0.2, RECTANGULAR, "0.12"),
        (11, 0.36, RECTANGULAR, "0.21"),
        (10, 0.2, RECTANGULAR, "0.12"),
        (8, 0.05, RECTANGULAR, "0.029"),
        (4, 0.0024, RECTANGULAR, "0.0014"),
        // Printed as 0.51 with the contribution 0.12.
        (6, 0.51, transverse, "0.12"),
        (7, 0.05, RECTANGULAR, "0.029"),
        (9, 0.05, RECTANGULAR, "0.029"),
        (13, 0.03, RECTANGULAR, "0.017"),
        (14, 0.03, RECTANGULAR, "0.017"),
        (15, 0.0, RECTANGULAR, "0.00"),
        (16, 0.03, RECTANGULAR, "0.017"),
        (17, 0.03, RECTANGULAR, "0.017"),
        (18, 0.03, RECTANGULAR, "0.017"),
    ]
}

#[test]
fn table_d1_comes_out_row_by_row() {
    let lines = table_d1();
    let budget =
        budget(lines.map(|(row, value, distribution, _)| {
            Component::new(Row::a1(row), value, distribution)
        }));
    for (component, (.., printed)) in budget.components().iter().zip(lines) {
        let digits = printed.len() - 2;
        let rounded = format!("{:.digits$}", component.contribution());
        assert_eq!(rounded, printed, "{}", component.label);
    }
    // By hand from the printed values: 0.4233 %, k = 2.
    let result = budget.expand(CoverageRule::Fixed(2.0)).expect("valid");
    close(result.standard_uncertainty, 0.4233, 1.2e-4);
    assert_eq!(format!("{:.2}", result.standard_uncertainty), "0.42");
    close(result.expanded_uncertainty, 0.8466, 1.2e-4);
    let automatic = budget.expand(CoverageRule::Probability(PROBABILITY_K2));
    assert_eq!(automatic.expect("valid").coverage.factor, 2.0);
}

#[test]
fn the_transverse_row_by_its_own_formula_changes_nothing_that_is_printed() {
    // sqrt(2^2 + 5^2) % of 10 % is 0.539 %, not 0.51 %; u becomes 0.4252 %.
    let mut lines = table_d1();
    lines[8].1 = (29.0_f32).sqrt() * 0.1;
    let budget = budget(lines.map(|(_, value, distribution, _)| line(value, distribution)));
    let combined = budget.combine().expect("valid");
    close(combined.standard_uncertainty, 0.4252, 1.2e-4);
}

/// GUM H.1, standard uncertainties in nm and their degrees of freedom.
const END_GAUGE: [(f32, f32); 6] = [
    (25.0, 18.0),
    (5.8, 24.0),
    (3.9, 5.0),
    (6.7, 8.0),
    (2.886_75, 50.0),
    (16.599, 2.0),
];

#[test]
fn the_end_gauge_of_the_gum() {
    // H.1: u = 31.66 nm (rounded to 32), 16.75 degrees of freedom, t99 = 2.90,
    // with the components as listed there (two of them unrounded).
    let budget = budget(END_GAUGE.map(|(u, dof)| standard(u, dof)));
    let combined = budget.combine().expect("valid");
    close(combined.standard_uncertainty, 31.664, 2.0e-4);
    close(combined.effective_degrees_of_freedom, 16.75, 2.0e-3);
    let at_99 = budget
        .expand(CoverageRule::Probability(0.99))
        .expect("valid");
    assert_eq!(at_99.coverage.shape, Shape::Student(16.0));
    // t99 of 16 degrees: 2.92078 (GUM, Table G.2: 2.92), U = 93 nm.
    close(at_99.coverage.factor, 2.920_78, 1.0e-5);
    close(at_99.expanded_uncertainty, 92.5, 1.0e-2);
}

#[test]
fn the_end_gauge_of_the_gum_in_metres() {
    // The same in metres: squares of 1e-16, fourth powers of 1e-33 and below;
    // the ratio of components to the largest keeps every digit.
    let in_nm = budget(END_GAUGE.map(|(u, dof)| standard(u, dof)));
    let in_m = budget(END_GAUGE.map(|(u, dof)| standard(u * 1.0e-9, dof)));
    let tiny = budget(END_GAUGE.map(|(u, dof)| standard(u * 1.0e-30, dof)));
    let expected = in_nm.combine().expect("valid");
    for (budget, scale) in [(in_m, 1.0e-9), (tiny, 1.0e-30)] {
        let combined = budget.combine().expect("valid");
        let u = f64::from(expected.standard_uncertainty) * scale;
        close(combined.standard_uncertainty, u, 1.0e-6);
        let dof = f64::from(expected.effective_degrees_of_freedom);
        close(combined.effective_degrees_of_freedom, dof, 1.0e-5);
    }
}

/// GUM H.2: five readings of V in volts, I in amperes, phase in radians.
const IMPEDANCE: [[f64; 5]; 3] = [
    [5.007, 4.994, 5.005, 4.990, 4.999],
    [19.663e-3, 19.639e-3, 19.640e-3, 19.685e-3, 19.678e-3],
    [1.0456, 1.0438, 1.0468, 1.0428, 1.0433],
];

/// Mean, and covariance of the means of two of the quantities.
fn mean(which: usize) -> f64 {
    IMPEDANCE[which].iter().sum::<f64>() / 5.0
}

fn covariance(a: usize, b: usize) -> f64 {
    let pairs = IMPEDANCE[a].iter().zip(&IMPEDANCE[b]);
    let sum: f64 = pairs.map(|(x, y)| (x - mean(a)) * (y - mean(b))).sum();
    sum / 20.0
}

#[test]
fn the_impedance_of_the_gum_with_its_correlations() {
    let (z, phi) = (mean(0) / mean(1), mean(2));
    let (sine, cosine) = phi.sin_cos();
    // R = Z cos(phi), X = Z sin(phi), Z: derivatives by V, I and phi.
    let cases = [
        (
            [cosine / mean(1), -z * cosine / mean(1), -z * sine],
            0.071_071_407_4,
        ),
        (
            [sine / mean(1), -z * sine / mean(1), z * cosine],
            0.295_581_677_4,
        ),
        ([1.0 / mean(1), -z / mean(1), 0.0], 0.236_336_130_1),
    ];
    for (derivatives, expected) in cases {
        let mut budget = budget([0, 1, 2].map(|i| {
            standard(covariance(i, i).sqrt() as f32, 4.0)
                .with_sensitivity_coefficient(derivatives[i] as f32)
        }));
        for (a, b) in [(0, 1), (0, 2), (1, 2)] {
            let r = covariance(a, b) / (covariance(a, a) * covariance(b, b)).sqrt();
            budget.correlate(a as u8, b as u8, r as f32).expect("valid");
        }
        // In R, terms of both signs cancel to a fifteenth: f32 leaves 1e-6.
        close(
            budget.combine().expect("valid").standard_uncertainty,
            expected,
            3.0e-6,
        );
    }
}

#[test]
fn full_correlation_is_the_bound_of_the_sum() {
    // D.4: (|u1| + |u2|)^2 + ur^2, here (3 + 4)^2 + 24^2 = 25^2.
    let mut budget = budget([standard(3.0, 9.0), standard(4.0, 9.0), standard(24.0, 9.0)]);
    budget.correlate(0, 1, 1.0).expect("valid");
    assert_eq!(budget.combine().expect("valid").standard_uncertainty, 25.0);
    budget.correlate(0, 1, -1.0).expect("valid");
    // Both statements together cancel: 3, 4 and 24 uncorrelated.
    close(
        budget.combine().expect("valid").standard_uncertainty,
        601.0_f64.sqrt(),
        1.0e-6,
    );
}

/// Combined and expanded uncertainty as printed.
type Printed = (&'static str, &'static str);

/// A supplement of EA-4/02 M:2022 with a normal result, unit as printed there.
type Supplement = (&'static str, std::vec::Vec<Component<'static>>, Printed);

fn known(u: f32) -> Component<'static> {
    standard(u, f32::INFINITY)
}

fn scaled(component: Component<'static>, coefficient: f32) -> Component<'static> {
    component.with_sensitivity_coefficient(coefficient)
}

/// 8.95 as printed, though 15 / sqrt(3) is 8.66.
fn supplement_2() -> Supplement {
    let rows = [22.5, 8.95, 5.77, 5.77].map(known);
    let rows = [rows.to_vec(), std::vec![standard(14.4, 2.0)]].concat();
    ("S2, mg", rows, ("29.3", "59"))
}

fn supplement_3() -> Supplement {
    let rows = std::vec![
        known(2.5),
        line(10.0, RECTANGULAR),
        line(2.75, RECTANGULAR),
        line(5.5, RECTANGULAR),
        scaled(line(1.0e-6, Distribution::Triangular), 1.0e7),
        scaled(standard(0.07e-6, 4.0), 1.0e7),
    ];
    ("S3, milliohm", rows, ("8.33", "17"))
}

fn supplement_4() -> Supplement {
    let rows = std::vec![
        line(30.0, TWO),
        line(30.0, RECTANGULAR),
        standard(5.37, 4.0),
        line(32.0, RECTANGULAR),
        scaled(line(0.05, RECTANGULAR), -575.0),
        scaled(known(0.236), 50.0),
        scaled(line(6.7, RECTANGULAR), -1.0),
    ];
    ("S4, nm", rows, ("36.4", "73"))
}

fn supplement_5() -> Supplement {
    let rows = std::vec![
        known(0.1),
        scaled(known(1.0), 0.077),
        scaled(line(0.5, RECTANGULAR), 0.077),
        scaled(line(2.0, RECTANGULAR), 0.077),
        scaled(line(0.1, RECTANGULAR), -0.407),
        line(0.3, TWO),
        line(0.3, RECTANGULAR),
        line(1.0, RECTANGULAR),
    ];
    ("S5, degree Celsius", rows, ("0.641", "1.3"))
}

/// Calibration factor 0.956 x 0.97597 = 0.93302 with limits of the mismatch
/// 0.0008, 0.014, 0.0008 and 0.0168 (u-shaped), U of the reference 0.011, drift
/// within 0.002, power ratio 0.00142, readings 0.9772, 0.9671, 0.9836 with
/// u = 0.0048029.
fn supplement_6() -> Supplement {
    let u_shaped = |limit: f32| line(limit, Distribution::UShaped);
    let (p, k_x) = (0.975_967, 0.933_024);
    let rows = std::vec![
        scaled(line(0.011, TWO), p),
        scaled(line(0.002, RECTANGULAR), p),
        scaled(u_shaped(0.000_8), k_x),
        scaled(u_shaped(0.014), -k_x),
        scaled(u_shaped(0.000_8), -k_x),
        scaled(u_shaped(0.016_8), k_x),
        scaled(known(0.001_42), k_x),
        scaled(known(0.000_142), k_x),
        scaled(standard(0.004_802_9, 2.0), 0.956),
    ];
    ("S6", rows, ("0.0162", "0.032"))
}

/// From its statements: readings 30.033, 30.058, 30.018, 30.052 dB, U = 0.005,
/// limits 0.002, 0.003 and twice 0.0005, mismatch 0.02, zeros twice 0.002.
fn supplement_7() -> Supplement {
    let root = 3.0_f32.sqrt();
    let stated = [
        9.132_1e-3,
        2.5e-3,
        2.0e-3 / root,
        2.0e-2,
        3.0e-3 / root,
        5.0e-4 / root,
        5.0e-4 / root,
        2.0e-3,
        2.0e-3,
    ];
    ("S7", stated.map(known).to_vec(), ("0.0224", "0.045"))
}

/// The rows as rounded in its table.
fn supplement_7_as_tabulated() -> Supplement {
    let rows = [
        9.0e-3, 2.5e-3, 1.1e-3, 2.0e-2, 1.7e-3, 3.0e-4, 3.0e-4, 2.0e-3, 2.0e-3,
    ];
    let rows = rows.map(known).to_vec();
    ("S7, as tabulated", rows, ("0.0224", "0.045"))
}

fn supplements() -> [Supplement; 7] {
    [
        supplement_2(),
        supplement_3(),
        supplement_4(),
        supplement_5(),
        supplement_6(),
        supplement_7(),
        supplement_7_as_tabulated(),
    ]
}

#[test]
fn the_normal_supplements_of_ea_4_02() {
    for (name, components, (u, expanded)) in supplements() {
        let result = budget(components)
            .expand(CoverageRule::Fixed(2.0))
            .expect("valid");
        let prints = |value: f32, printed: &str| {
            let digits = printed.split('.').nth(1).map_or(0, str::len);
            assert_eq!(format!("{value:.digits$}"), printed, "{name}");
        };
        prints(result.standard_uncertainty, u);
        prints(result.expanded_uncertainty, expanded);
    }
}

#[test]
fn weights_by_welch_and_satterthwaite() {
    // S2 by its degrees of freedom: 34.4, k = 2.08, U = 61 mg.
    let [(_, components, _), ..] = supplements();
    let student = budget(components)
        .expand(CoverageRule::Probability(PROBABILITY_K2))
        .expect("valid");
    close(student.effective_degrees_of_freedom, 34.4, 2.0e-3);
    assert_eq!(format!("{:.2}", student.coverage.factor), "2.08");
    assert_eq!(format!("{:.0}", student.expanded_uncertainty), "61");
}

#[test]
fn humidity_of_ea_4_02_is_a_trapezoid_too() {
    // S11: u = 0.164 degrees, U = 0.3. 1.81 is printed for k; its edge of 0.43
    // gives 1.796 by its own formula, the exact law of all inputs 1.83.
    let printed = [0.015, 0.010, 0.023, 0.029, 0.058, 0.144, 0.029, 0.017];
    let root = 3.0_f32.sqrt();
    let budget = budget(printed.map(|u| line(u * root, RECTANGULAR)));
    let result = budget
        .expand(CoverageRule::Probability(0.95))
        .expect("valid");
    assert_eq!(format!("{:.3}", result.standard_uncertainty), "0.164");
    assert_eq!(format!("{:.2}", result.coverage.factor), "1.80");
    assert_eq!(format!("{:.1}", result.expanded_uncertainty), "0.3");
}

#[test]
fn a_dominant_rectangle_has_its_own_factor() {
    // EA-4/02 S9: multimeter at 100 V, resolution 0.05 V dominates:
    // u = 0.030 V, k = 1.65 (0.95 sqrt 3), U = 0.05 V.
    let budget = budget([
        line(0.002, TWO),
        line(0.011, RECTANGULAR),
        line(0.05, RECTANGULAR),
    ]);
    let result = budget
        .expand(CoverageRule::Probability(0.95))
        .expect("valid");
    assert_eq!(result.coverage.shape, Shape::Rectangular);
    assert_eq!(format!("{:.2}", result.coverage.factor), "1.65");
    assert_eq!(format!("{:.2}", result.expanded_uncertainty), "0.05");
}

#[test]
fn two_dominant_rectangles_make_a_trapezoid() {
    // EA-4/02 S10: half-widths of 25 and 50 um, k = 1.83. Its u = 33 um is the
    // sum of the rounded 15 and 29 um; U = 0.06 mm by either.
    let of = |resolution: f32, mechanical: f32| {
        budget([
            line(mechanical, RECTANGULAR),
            line(resolution, RECTANGULAR),
            standard(0.46, f32::INFINITY),
            standard(1.15, f32::INFINITY).with_sensitivity_coefficient(1.7),
        ])
        .expand(CoverageRule::Probability(0.95))
        .expect("valid")
    };
    let root = 3.0_f32.sqrt();
    let rounded = of(15.0 * root, 29.0 * root);
    assert_eq!(format!("{:.0}", rounded.standard_uncertainty), "33");
    assert_eq!(
        format!("{:.2}", rounded.expanded_uncertainty / 1.0e3),
        "0.06"
    );
    let result = of(25.0, 50.0);
    assert_eq!(format!("{:.2}", result.coverage.factor), "1.83");
    let Shape::Trapezoidal { edge } = result.coverage.shape else {
        panic!("{result:?}");
    };
    close(edge, 1.0 / 3.0, 1.0e-6);
    // (1 - sqrt(0.05 * 8/9)) / sqrt((10/9) / 6) = 0.789181 / 0.430331 = 1.8339.
    close(result.coverage.factor, 1.833_9, 3.0e-5);
    assert_eq!(
        format!("{:.2}", result.expanded_uncertainty / 1.0e3),
        "0.06"
    );
}

#[test]
fn limits_of_the_trapezoid_are_rectangle_and_triangle() {
    // Rectangle: 0.95 sqrt 3. Triangle: (1 - sqrt 0.05) sqrt 6.
    close(coverage::trapezoid_factor(0.95, 1.0), 1.645_448, 1.0e-6);
    close(coverage::trapezoid_factor(0.95, 0.0), 1.901_767, 1.0e-6);
    // A wide flat part: the quantile lies on it, k u = a p (1 + edge) / 2.
    let edge = 0.97_f64;
    let expected = 0.95 * (1.0 + edge) / 2.0 / ((1.0 + edge * edge) / 6.0).sqrt();
    close(coverage::trapezoid_factor(0.95, 0.97), expected, 1.0e-6);
}

#[test]
fn the_water_meter_of_ea_4_02_needs_students_factor() {
    // S12, household water meter: 0.60e-3 of three readings and 0.68e-3 give
    // u = 9.1e-4 with 10.4 degrees of freedom, k = 2.28, U = 2e-3.
    let budget = budget([standard(0.60e-3, 2.0), standard(0.68e-3, f32::INFINITY)]);
    let result = budget
        .expand(CoverageRule::Probability(PROBABILITY_K2))
        .expect("valid");
    assert_eq!(format!("{:.1e}", result.standard_uncertainty), "9.1e-4");
    assert_eq!(
        format!("{:.1}", result.effective_degrees_of_freedom),
        "10.4"
    );
    assert_eq!(format!("{:.2}", result.coverage.factor), "2.28");
    assert_eq!(format!("{:.0e}", result.expanded_uncertainty), "2e-3");
}

#[test]
fn a_working_reference_takes_two_stages() {
    // First stage 0.3 and 0.4 (4 degrees of freedom): 0.5, nu = 0.5^4 / (0.4^4
    // / 4) = 9.766. Second stage with 1.2: 1.3, nu = 1.3^4 / (0.5^4 / 9.766).
    let first = budget([standard(0.3, f32::INFINITY), standard(0.4, 4.0)])
        .expand(CoverageRule::Fixed(2.0))
        .expect("valid");
    let working = first.as_component(Row::a1(1));
    let second = budget([working, standard(1.2, f32::INFINITY)])
        .combine()
        .expect("valid");
    close(second.standard_uncertainty, 1.3, 1.0e-6);
    close(second.effective_degrees_of_freedom, 446.2656, 1.0e-5);
}

#[test]
fn nonsense_is_refused_by_name() {
    let mut budget = Budget::new();
    assert_eq!(budget.combine(), Err(BudgetError::Empty));
    let refuse = |budget: &mut Budget<'_>, component| {
        assert!(budget.components().is_empty());
        budget.add(component)
    };
    for value in [-1.0, f32::NAN, f32::INFINITY] {
        let component = line(value, RECTANGULAR);
        assert_eq!(refuse(&mut budget, component), Err(BudgetError::Value(0)));
    }
    for coverage_factor in [0.0, -2.0, f32::NAN] {
        let component = line(1.0, Distribution::Normal { coverage_factor });
        assert_eq!(refuse(&mut budget, component), Err(BudgetError::Divisor(0)));
    }
    let component = standard(1.0, 0.0);
    assert_eq!(
        refuse(&mut budget, component),
        Err(BudgetError::DegreesOfFreedom(0))
    );
    let component = standard(1.0, 1.0).with_sensitivity_coefficient(f32::NAN);
    assert_eq!(
        refuse(&mut budget, component),
        Err(BudgetError::SensitivityCoefficient(0))
    );
    budget.add(standard(1.0, 1.0)).expect("valid");
    assert_eq!(
        budget.correlate(0, 1, 0.5),
        Err(BudgetError::CorrelationIndex(1))
    );
    assert_eq!(
        budget.correlate(0, 0, 0.5),
        Err(BudgetError::CorrelationIndex(0))
    );
    budget.add(standard(1.0, 1.0)).expect("valid");
    assert_eq!(
        budget.correlate(0, 1, 1.1),
        Err(BudgetError::CorrelationCoefficient)
    );
    assert_eq!(
        budget.correlate(0, 1, f32::NAN),
        Err(BudgetError::CorrelationCoefficient)
    );
    budget.add(standard(1.0, 1.0)).expect("valid");
    for (a, b) in [(0, 1), (1, 2), (0, 2)] {
        budget
            .correlate(a, b, -1.0)
            .expect("each alone is possible");
    }
    assert_eq!(budget.combine(), Err(BudgetError::NegativeVariance));
    assert!(BudgetError::Value(2).to_string().starts_with("component 3"));
}

#[test]
fn a_point_budget_has_a_row_for_every_source() {
    let settings = Settings::field_calibrator();
    let reference = settings.reference.at(160.0).expect("in the table");
    let spec = PointSpec {
        frequency_hz: 160.0,
        acceleration_rms_ms2: 10.0,
    };
    let point = PointResult {
        repeatability_rel: 1.0e-4,
        repeatability_phase_rad: 1.0e-4,
        hum_rel: 2.0e-4,
        dropout_rel: 3.0e-4,
        blocks: 10,
        acceleration_rms_ms2: 10.0,
        sensitivity_v_per_ms2: 0.01,
        ..PointResult::refused(spec, None, Reason::Stopped)
    };
    let budget = point_budget(&settings, &reference, &point).expect("valid");
    let rows = |budget: &Budget<'_>| -> std::vec::Vec<u8> {
        budget.components().iter().map(|c| c.row.number).collect()
    };
    let mut magnitude = rows(&budget.magnitude);
    magnitude.sort_unstable();
    // Row 3 has the gain of the converters and their linearity; mounting and relative motion have a part that
    // grows with the frequency; row 5 has noise that comes with the motion beside the hum.
    let mut expected: std::vec::Vec<u8> = (1..=18).chain([3, 3, 5, 8, 9]).collect();
    expected.sort_unstable();
    assert_eq!(magnitude, expected);
    assert_eq!(budget.phase.components().len(), 21);
    let (magnitude, phase) = budget.expand().expect("valid");
    // By hand, percent: 0.25, 0.1443, 0.0577, 0.1269, 2 x 0.0289 + 0.0289,
    // 0.0866, 0.2078, 4 x 0.0173, 0.01, hum of 0.02 over sqrt 2, 0.03 over sqrt 2, and twice the linearity, 10 / 7200 over
    // sqrt 3: u = 0.4127. Mounting and motion at 160 Hz are 1e-4 of themselves.
    let squares: f64 = [
        0.25_f64, 0.144_34, 0.057_74, 0.126_93, 0.028_87, 0.028_87, 0.028_87, 0.086_60, 0.207_85,
        0.017_32, 0.017_32, 0.017_32, 0.017_32, 0.01, 0.001_386, 0.080_19, 0.080_19, 0.014_14,
        0.021_21,
    ]
    .iter()
    .map(|u| u * u)
    .sum();
    close(
        magnitude.standard_uncertainty,
        squares.sqrt() / 100.0,
        1.0e-4,
    );
    assert_eq!(magnitude.coverage.factor, 2.0);
    assert!(phase.expanded_uncertainty > reference.expanded_uncertainty_phase_rad);
}

/// Row 3 has the step of the converters and, of 0.02 % and 0.0005 rad with k = 2, the ratio; the 0.1 % of the
/// parts is gone.
#[test]
fn a_measured_ratio_replaces_the_tolerance_of_the_parts() {
    let mut settings = Settings::field_calibrator();
    let point = |frequency_hz| ChannelRatioPoint {
        frequency_hz,
        magnitude: 1.004,
        phase_rad: -0.01,
        expanded_uncertainty_rel: 2.0e-4,
        expanded_uncertainty_phase_rad: 5.0e-4,
    };
    settings
        .channel_ratio
        .points
        .extend([point(100.0), point(160.0)]);
    let of = |frequency_hz| {
        let spec = PointSpec {
            frequency_hz,
            acceleration_rms_ms2: 10.0,
        };
        let reference = settings.reference.at(frequency_hz).expect("in the table");
        let point = PointResult::refused(spec, None, Reason::Stopped);
        let budget = point_budget(&settings, &reference, &point).expect("valid");
        let ratios = |budget: &Budget<'_>, row: u8| -> std::vec::Vec<f32> {
            let rows = budget.components().iter().filter(|c| c.row.number == row);
            rows.map(Component::standard_uncertainty).collect()
        };
        (ratios(&budget.magnitude, 3), ratios(&budget.phase, 3))
    };
    let (magnitude, phase) = of(160.0);
    assert_eq!((magnitude, phase), (vec![1.0e-4], vec![2.5e-4]));
    // Outside its table: the tolerance of the parts.
    let (magnitude, phase) = of(200.0);
    close(magnitude[0], 0.001 / 3.0_f64.sqrt(), 1.0e-6);
    close(phase[0], 0.05_f64.to_radians() / 3.0_f64.sqrt(), 1.0e-6);
}

mod properties {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_budget_grows_with_each_component(
            values in prop::collection::vec(1.0e-6_f32..1.0, 2..15),
            which in any::<prop::sample::Index>(),
            growth in 1.01_f32..10.0,
        ) {
            let before = budget(values.iter().map(|v| line(*v, RECTANGULAR)));
            let mut grown = values.clone();
            *which.get_mut(&mut grown) *= growth;
            let after = budget(grown.iter().map(|v| line(*v, RECTANGULAR)));
            let u = |budget: &Budget<'_>| budget.combine().expect("valid").standard_uncertainty;
            prop_assert!(u(&after) >= u(&before));
            let largest = values.iter().fold(0.0_f32, |a, b| a.max(*b)) / 3.0_f32.sqrt();
            prop_assert!(u(&before) >= largest * 0.999_999);
        }

        #[test]
        fn degrees_of_freedom_lie_between_the_smallest_and_their_sum(
            lines in prop::collection::vec((1.0e-12_f32..1.0e-3, 1.0_f32..100.0), 1..15),
        ) {
            // GUM G.4.1: nu_eff is at most the sum, and at least the smallest.
            let combined = budget(lines.iter().map(|(u, dof)| standard(*u, *dof)))
                .combine()
                .expect("valid");
            let dof = combined.effective_degrees_of_freedom;
            let sum: f32 = lines.iter().map(|(_, dof)| dof).sum();
            let least = lines.iter().map(|(_, dof)| *dof).fold(f32::INFINITY, f32::min);
            prop_assert!(dof <= sum * 1.000_01 && dof >= least * 0.999_99);
        }
    }
}
