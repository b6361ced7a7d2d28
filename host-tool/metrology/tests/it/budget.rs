//! Budgets whose results other people printed.

use calib_metrology::budget::type_a;
use calib_metrology::budget::{self, Budget, Component, CoverageRule, Distribution, Model, Unit};
use calib_metrology::evaluated::EvaluationView;
use calib_metrology::input::Source;
use calib_metrology::statistics::student_factor;
use nalgebra::{DMatrix, DVector};
use std::path::Path;

const TABLE_D1: &str = include_str!("../../../../docs/metrology/examples/table-d1.toml");

fn parse(text: &str) -> calib_files::Result<Budget> {
    budget::parse(&Source::from_text(Path::new("b.toml"), text)?)
}

/// Asserts that `value` rounds to `printed`, digit by digit.
#[track_caller]
pub(crate) fn prints(value: f64, printed: &str) {
    let number: f64 = printed.parse().expect("a printed number");
    let mantissa = printed.split('e').next().unwrap_or(printed);
    let decimals = mantissa.split('.').nth(1).map_or(0, str::len) as i32;
    let exponent: i32 = printed
        .split('e')
        .nth(1)
        .map_or(0, |text| text.parse().expect("an exponent"));
    let half_unit = 0.5 * 10.0_f64.powi(exponent - decimals);
    let slack = 1.0e-9 * number.abs();
    assert!(
        (value - number).abs() <= half_unit + slack,
        "{value} does not print as {printed}"
    );
}

/// Standard uncertainty, sensitivity coefficient, degrees of freedom, shape.
pub(crate) type Row = (f64, f64, f64, char);
/// Name, rows, and u, k and U as printed.
pub(crate) type Case = (
    &'static str,
    Vec<Row>,
    &'static str,
    &'static str,
    &'static str,
);

/// One row (standard uncertainty, coefficient, degrees of freedom, shape).
pub(crate) fn row(u: f64, c: f64, degrees_of_freedom: f64, shape: char) -> Row {
    (u, c, degrees_of_freedom, shape)
}

pub(crate) fn budget_of(rows: &[Row], coverage: CoverageRule) -> Budget {
    let components = rows
        .iter()
        .enumerate()
        .map(|(index, &(u, c, degrees_of_freedom, shape))| {
            let distribution = match shape {
                'R' => Distribution::Rectangular,
                'T' => Distribution::Triangular,
                'U' => Distribution::UShaped,
                _ => Distribution::Normal {
                    coverage_factor: 1.0,
                },
            };
            Component {
                label: format!("x{index}"),
                value: u * distribution.divisor(),
                distribution,
                sensitivity_coefficient: c,
                degrees_of_freedom,
            }
        })
        .collect();
    Budget {
        measurand: "y".into(),
        unit: Unit::Percent,
        model: Model::Sum,
        coverage,
        truncate_degrees_of_freedom: false,
        components,
        correlations: Vec::new(),
        remarks: Vec::new(),
    }
}

pub(crate) const INF: f64 = f64::INFINITY;

#[test]
fn table_d1_of_iso_16063_21() {
    let evaluation = budget::evaluate(&parse(TABLE_D1).expect("budget"));
    let printed = [
        "0.25", "0.087", "0.14", "0.12", "0.21", "0.12", "0.029", "0.0014", "0.12", "0.029",
        "0.029", "0.017", "0.017", "0.00", "0.017", "0.017", "0.017",
    ];
    assert_eq!(evaluation.components.len(), printed.len());
    for (component, printed) in evaluation.components.iter().zip(printed) {
        prints(component.contribution, printed);
    }
    prints(evaluation.combined_standard_uncertainty, "0.42");
    // The table doubles the rounded 0.42; unrounded it is 0.847.
    prints(evaluation.expanded_uncertainty, "0.847");
    assert_eq!(evaluation.coverage_factor, 2.0);
    assert_eq!(evaluation.effective_degrees_of_freedom, INF);
    // With the formula the table itself prints: sqrt(2^2 + 5^2) % of 10 %.
    let corrected = TABLE_D1.replace("value = 0.51", "value = 0.53852");
    let evaluation = budget::evaluate(&parse(&corrected).expect("budget"));
    prints(evaluation.combined_standard_uncertainty, "0.4252");
}

#[test]
fn gum_h1_end_gauge() {
    // Contributions in nm with the degrees of freedom of H.1.6.
    let alpha = 11.5e-6;
    let length_nm = 50_000_623.0;
    let rows = [
        row(25.0, 1.0, 18.0, 'N'),
        row(5.8, 1.0, 24.0, 'N'),
        row(3.9, 1.0, 5.0, 'N'),
        row(6.7, 1.0, 8.0, 'N'),
        row(1.0e-6 / 3.0_f64.sqrt(), 0.1 * length_nm, 50.0, 'R'),
        row(0.05 / 3.0_f64.sqrt(), -length_nm * alpha, 2.0, 'R'),
    ];
    let evaluation = budget::evaluate(&budget_of(&rows, CoverageRule::Probability(0.99)));
    prints(evaluation.combined_standard_uncertainty, "31.663879");
    prints(evaluation.effective_degrees_of_freedom, "16.751856");
    prints(evaluation.coverage_factor, "2.90355");
    prints(
        student_factor(0.95, evaluation.effective_degrees_of_freedom),
        "2.11220",
    );
    // The guide truncates to 16 degrees: t = 2.92, U = 93 nm (92.5 there).
    let mut truncated = budget_of(&rows, CoverageRule::Probability(0.99));
    truncated.truncate_degrees_of_freedom = true;
    prints(budget::evaluate(&truncated).coverage_factor, "2.92");
    // In metres every variance is 1e-18 times as large; nothing may change.
    let metres: Vec<_> = rows
        .iter()
        .map(|r| row(r.0 * 1e-9, r.1, r.2, r.3))
        .collect();
    let evaluation = budget::evaluate(&budget_of(&metres, CoverageRule::Default));
    prints(evaluation.effective_degrees_of_freedom, "16.751856");
}

#[test]
fn gum_h2_from_the_observations() {
    let v = [5.007, 4.994, 5.005, 4.990, 4.999];
    let i = [19.663e-3, 19.639e-3, 19.640e-3, 19.685e-3, 19.678e-3];
    let phi = [1.0456, 1.0438, 1.0468, 1.0428, 1.0433];
    let observed = type_a::observe(&[&v, &i, &phi]).expect("five observations");
    assert_eq!(observed.degrees_of_freedom, 4.0);
    let covariance = type_a::propagate(&observed.mean, &observed.covariance, impedance);
    let result = impedance(&observed.mean);
    for (value, printed) in result
        .iter()
        .zip(["127.732169928", "219.846511913", "254.259701948"])
    {
        prints(*value, printed);
    }
    let u = |index: usize| covariance[(index, index)].sqrt();
    for (index, expected) in [0.071_071_407_4, 0.295_581_677_4, 0.236_336_130_1]
        .iter()
        .enumerate()
    {
        assert!(
            (u(index) / expected - 1.0).abs() < 1e-8,
            "{index}: {}",
            u(index)
        );
    }
    let r = |a, b| type_a::correlation(&covariance, a, b);
    for (value, expected) in [
        (r(0, 1), -0.588_429_784),
        (r(1, 2), 0.992_511_649),
        (r(0, 2), -0.485_259_224),
    ] {
        assert!((value - expected).abs() < 2e-8, "{value} {expected}");
    }
}

#[test]
fn gum_h2_from_the_rounded_inputs() {
    let mean = DVector::from_column_slice(&[4.999, 19.6610e-3, 1.04446]);
    let r = DMatrix::from_row_slice(
        3,
        3,
        &[1.0, -0.36, 0.86, -0.36, 1.0, -0.65, 0.86, -0.65, 1.0],
    );
    let inputs = type_a::covariance(&[0.0032, 0.0095e-3, 0.00075], &r);
    let covariance = type_a::propagate(&mean, &inputs, impedance);
    for (index, expected) in [0.069_978_727_99, 0.295_716_826_8, 0.236_602_971_8]
        .iter()
        .enumerate()
    {
        let u = covariance[(index, index)].sqrt();
        assert!((u / expected - 1.0).abs() < 1e-8, "{index}: {u}");
    }
    let r = |a, b| type_a::correlation(&covariance, a, b);
    for (value, expected) in [
        (r(0, 1), -0.591_484_610_8),
        (r(1, 2), 0.992_797_472_7),
        (r(0, 2), -0.490_623_905_4),
    ] {
        assert!((value - expected).abs() < 2e-8, "{value} {expected}");
    }
}

/// Resistance, reactance and impedance from voltage, current and phase.
fn impedance(x: &DVector<f64>) -> DVector<f64> {
    let z = x[0] / x[1];
    DVector::from_column_slice(&[z * x[2].cos(), z * x[2].sin(), z])
}

/// Half-width to standard uncertainty of a rectangular law.
pub(crate) fn r(half_width: f64) -> f64 {
    half_width / 3.0_f64.sqrt()
}

#[test]
fn correlated_components_add_with_their_sign() {
    let text = |r: &str, c: f64| {
        format!(
            "[[component]]\nlabel = 'a'\nvalue = 0.3\ndistribution = 'normal'\nk = 1\n\
             [[component]]\nlabel = 'b'\nvalue = 0.4\ndistribution = 'normal'\nk = 1\n\
             sensitivity_coefficient = {c}\n\
             [[correlation]]\na = 'a'\nb = 'b'\nr = {r}\n"
        )
    };
    let u = |r: &str, c: f64| {
        let budget = parse(&text(r, c)).expect("budget");
        budget::evaluate(&budget).combined_standard_uncertainty
    };
    // 0.09 + 0.16 + 2 r c 0.12 by hand.
    assert!((u("1", 1.0) - 0.7).abs() < 1e-12);
    assert!((u("1", -1.0) - 0.1).abs() < 1e-12);
    assert!((u("0.5", 1.0) - 0.37_f64.sqrt()).abs() < 1e-12);
    // The bound of D.4 adds whatever the sign.
    assert!((u("'unknown'", -1.0) - 0.7).abs() < 1e-12);
}

#[test]
fn halving_a_component_does_what_the_advice_says() {
    let evaluation = budget::evaluate(&parse(TABLE_D1).expect("budget"));
    let advice = &evaluation.improve_first;
    assert_eq!(advice.len(), 3);
    assert!(advice[0].label.starts_with("Calibration of reference"));
    let halved = TABLE_D1.replace("value = 0.5\n", "value = 0.25\n");
    let again = budget::evaluate(&parse(&halved).expect("budget"));
    let promised = advice[0].expanded_uncertainty_if_halved;
    assert!((again.expanded_uncertainty / promised - 1.0).abs() < 1e-12);
}

#[test]
fn two_stages_carry_uncertainty_and_degrees_of_freedom() {
    let folder = tempfile::tempdir().expect("folder");
    let inner = "[[component]]\nlabel = 'a'\nvalue = 0.3\ndistribution = 'normal'\nk = 1\n\
                 degrees_of_freedom = 4\n";
    std::fs::write(folder.path().join("working.toml"), inner).expect("written");
    let outer = "coverage_probability = 0.95\n[[component]]\nlabel = 'working reference'\n\
                 budget = 'working.toml'\n";
    let path = folder.path().join("outer.toml");
    std::fs::write(&path, outer).expect("written");
    let evaluation = budget::evaluate(&budget::load(&path).expect("two stages"));
    assert!((evaluation.combined_standard_uncertainty - 0.3).abs() < 1e-12);
    prints(evaluation.coverage_factor, "2.77645");
    // A budget that names itself is refused, not followed for ever.
    let circle = outer.replace("working.toml", "outer.toml");
    std::fs::write(&path, circle).expect("written");
    let message = budget::load(&path).expect_err("circle").to_string();
    assert!(message.contains("leads back to itself"), "{message}");
}

#[test]
fn faults_name_file_line_and_remedy() {
    let good = "[[component]]\nlabel = 'a'\nvalue = 0.3\ndistribution = 'normal'\nk = 2\n";
    let twin = "[[component]]\nlabel = 'b'\nvalue = 0.3\ndistribution = 'rectangular'\n";
    let third = "[[component]]\nlabel = 'c'\nvalue = 0.3\ndistribution = 'rectangular'\n";
    let impossible = format!(
        "{good}{twin}{third}\
         [[correlation]]\na='a'\nb='b'\nr=0.9\n[[correlation]]\na='b'\nb='c'\nr=0.9\n\
         [[correlation]]\na='a'\nb='c'\nr=-0.9\n"
    );
    let cases: &[(String, usize, &str)] = &[
        (String::new(), 1, "empty"),
        (good.replace("0.3", "-0.3"), 3, "never negative"),
        (good.replace("0.3", "nan"), 3, "not a number"),
        (good.replace("0.3", "inf"), 3, "finite"),
        (good.replace("k = 2", "k = 0"), 5, "greater than zero"),
        (good.replace("k = 2", "kk = 2"), 5, "unknown field"),
        (good.replace("normal", "gausian"), 4, "not known"),
        (
            format!("{good}degrees_of_freedom = 0\n"),
            6,
            "must be 1 or more",
        ),
        (
            format!("{good}degrees_of_freedom = 0.1\n"),
            6,
            "must be 1 or more",
        ),
        (good.replace("k = 2", "k = 0.01"), 5, "no coverage factor"),
        (good.replace("0.3", "150"), 3, "more than 100 %"),
        (
            format!("coverage_factor = 0.1\n{good}"),
            1,
            "no coverage factor",
        ),
        (format!("{good}{good}"), 7, "two components"),
        (
            format!("coverage_factor = 0\n{good}"),
            1,
            "greater than zero",
        ),
        (
            format!("coverage_probability = 95\n{good}"),
            1,
            "not between 0.68 and 1",
        ),
        (
            format!("{good}[[correlation]]\na='a'\nb='z'\nr=0\n"),
            8,
            "no component",
        ),
        (
            format!("{good}{twin}[[correlation]]\na='a'\nb='b'\nr=1.5\n"),
            13,
            "outside",
        ),
        (impossible, 25, "positive semidefinite"),
        (good.replace("0.3", "0.0"), 1, "every contribution is zero"),
    ];
    for (text, line, what) in cases {
        let error = parse(text).expect_err(what);
        let message = error.to_string();
        assert!(
            message.starts_with(&format!("b.toml:{line}: ")),
            "{message}"
        );
        assert!(message.contains(what), "{message}");
        assert!(
            error.hint().is_some_and(|hint| !hint.is_empty()),
            "{message}"
        );
    }
}

#[test]
fn the_report_fits_eighty_columns() {
    let evaluation = budget::evaluate(&parse(TABLE_D1).expect("budget"));
    let report = budget::report(&evaluation);
    assert!(
        report.lines().all(|line| line.chars().count() <= 80),
        "{report}"
    );
    assert!(report.contains("0.847 %"), "{report}");
    let chart = budget::contribution_chart(&evaluation);
    assert_eq!(chart.matches("<rect class='dot").count(), 17 + 1);
}

#[test]
fn the_json_has_the_documented_fields() {
    let evaluation = budget::evaluate(&parse(TABLE_D1).expect("budget"));
    let view = EvaluationView::new(&evaluation, None);
    let json = serde_json::to_value(view).expect("JSON");
    // 0.25 %, stated relative.
    let contribution = &json["components"][0]["contribution"];
    assert_eq!(contribution.as_f64(), Some(0.0025));
    assert_eq!(json["unit"], "1");
    assert!(json["effective_degrees_of_freedom"].is_null());
    for field in [
        "combined_standard_uncertainty",
        "coverage_factor",
        "expanded_uncertainty",
    ] {
        assert!(json[field].as_f64().is_some(), "{field}");
    }
}
