//! Linked comparisons: published table, known truth, faults.

use calib_metrology::input::Source;
use calib_metrology::linking::{self, OnFailure, judge, link};
use calib_metrology::monte_carlo::Lanes;
use std::path::Path;

#[test]
fn the_published_table_flags_whom_the_report_names() {
    let Some(path) = crate::shared::path("data/euramet_auv_v_k3_doe.csv") else {
        return;
    };
    let table = linking::read_table(Source::read(&path).expect("file")).expect("table");
    let judgement = judge(&table.degrees);
    let named: Vec<(&str, Option<f64>)> = judgement
        .inconsistent
        .iter()
        .map(|degree| (degree.laboratory.as_str(), degree.frequency_hz))
        .collect();
    let expected: Vec<_> = [0.1, 0.125, 0.16, 0.2].map(|f| ("CMI", Some(f))).into();
    assert_eq!(named, expected);
    assert_eq!(judgement.on_limit.len(), 1);
    assert_eq!(judgement.on_limit[0].laboratory, "INRIM");
    assert_eq!(judgement.on_limit[0].frequency_hz, Some(1.0));
}

#[test]
fn linked_degrees_cover_the_truth() {
    // Four laboratories measure X, three of them and three others measure Y.
    let (x, y) = (130.0, 1.002);
    let r = x / y;
    let u_x = [0.2, 0.3, 0.25, 0.4];
    let u_y = [0.002, 0.003, 0.0025, 0.004, 0.003, 0.005];
    // Biases of the laboratories that do not link, in the unit of Y.
    let bias = [0.0, 0.0, 0.0, 0.006, -0.004, 0.0];
    let (draws, mut covered, mut pairs) = (5000, [0u32; 6], 0u32);
    let mut lanes = Lanes::new(2024, 0);
    let mut normal = [0.0; 10];
    let mut consistent_draws = 0;
    for _ in 0..draws {
        lanes.fill_normal(&mut normal);
        let cipm: Vec<_> = (0..4)
            .map(|l| (format!("L{l}"), x + u_x[l] * normal[l], u_x[l]))
            .collect();
        let rmo: Vec<_> = (0..6)
            .map(|l| {
                let name = if l < 3 {
                    format!("L{l}")
                } else {
                    format!("R{l}")
                };
                (name, y + bias[l] + u_y[l] * normal[4 + l], u_y[l])
            })
            .collect();
        let linked = link(&cipm, &rmo, 1.959_964, OnFailure::Keep).expect("three link");
        // Mandel-Paule weights in the draws that fail the test would only widen
        // the intervals: the truth of this case has no spread between them.
        consistent_draws += u32::from(linked.reference_value.consistent);
        for (index, laboratory) in linked.laboratories.iter().enumerate() {
            let truth = r * bias[index];
            covered[index] += u32::from((laboratory.d - truth).abs() <= laboratory.u_expanded);
        }
        let pair = linked.pairs.iter().find(|p| p.a == "R3" && p.b == "R4");
        let pair = pair.expect("pair");
        pairs += u32::from((pair.d - r * 0.010).abs() <= pair.u_expanded);
    }
    // 95 % of 5000 are 4750, binomial deviation 15.4; four of them are 62.
    for count in covered.into_iter().chain([pairs]) {
        assert!((4688..=4812).contains(&count), "{covered:?} {pairs}");
    }
    // The consistency test itself rejects 5 %.
    assert!(
        (4688..=4812).contains(&consistent_draws),
        "{consistent_draws}"
    );
}

#[test]
fn files_are_read_in_both_forms() {
    let text = "title = 'T'\n[[cipm]]\nlaboratory = 'A'\nfrequency_hz = 160\nvalue = 130\n\
                standard_uncertainty = 0.2\n[[rmo]]\nlaboratory = 'A'\nfrequency_hz = 160\n\
                value = 1.0\nexpanded_uncertainty = 0.004\nk = 2\n\
                [[result]]\ncomparison = 'rmo'\nlaboratory = 'B'\nfrequency_hz = 160\n\
                value = 1.01\nstandard_uncertainty = 0.002\n";
    let source = |text: &str| Source::from_text(Path::new("l.toml"), text).expect("text");
    let file = linking::parse(&source(text)).expect("file");
    let linked = file.link_all();
    assert_eq!(linked.len(), 1);
    // r = 130; B: 131.3 - 130.
    assert!((linked[0].linked.laboratories[1].d - 1.3).abs() < 1e-9);
    let report = linking::link_report(&file, &linked, true);
    assert!(
        report.lines().all(|line| line.chars().count() <= 80),
        "{report}"
    );
    let cases = [
        (text.replace("'B'", "'A'"), 15, "two results"),
        (text.replace("value = 1.0\n", "value = 0\n"), 10, "ratio"),
        (text.replace("0.2\n", "-0.2\n"), 6, "greater than zero"),
        (text.replace("k = 2\n", "kk = 2\n"), 12, "unknown field"),
        (
            text.replace("[[cipm]]\nlaboratory = 'A'", "[[cipm]]\nlaboratory = 'Z'"),
            1,
            "no laboratory",
        ),
    ];
    for (text, line, what) in cases {
        let message = linking::parse(&source(&text)).expect_err(what).to_string();
        assert!(
            message.starts_with(&format!("l.toml:{line}: ")),
            "{message}"
        );
        assert!(message.contains(what), "{message}");
    }
}

#[test]
fn faults_of_a_table_name_the_line() {
    let cases = [
        ("lab,f,d,U_expanded\nA,1,0.1,0\n", 2, "greater than zero"),
        ("lab,f,d,U_expanded\nA,1,0.1,1\nA,1,0.2,1\n", 3, "twice"),
        ("lab,f,d\nA,1,0.1\n", 1, "expanded uncertainty"),
        ("lab,f,d,U_expanded\nA,1,x,1\n", 2, "finite"),
    ];
    for (text, line, what) in cases {
        let source = Source::from_text(Path::new("d.csv"), text).expect("text");
        let message = linking::read_table(source).expect_err(what).to_string();
        assert!(message.starts_with(&format!("d.csv:{line}: ")), "{message}");
        assert!(message.contains(what), "{message}");
    }
}
