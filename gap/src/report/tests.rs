//! The page holds what the answer says, and nothing an answer says can leave its place.

use super::report;
use crate::answer::*;
use crate::axis::Axis;
use crate::estimation::gap::{Gap, GapSize, Slice};
use crate::observable::{Group, Observable};
use crate::pictures::{Conditions, Datum, Pictures, Residuals, Trace};
use calib_effects::Stage;

const HOSTILE: &str = "a<b>&'\"</style><script>";

fn gap(observable: Group) -> Gap {
    let of_observable = GapSize {
        before_rel: 0.0791,
        after_rel: 0.003_14,
        floor_rel: 0.003,
        closed: None,
        chi_before: 12.0,
        chi_after: 1.02,
    };
    let mut gap = Gap {
        size: GapSize {
            closed: Some(0.42),
            ..of_observable
        },
        held_out_rows: 18,
        chosen: vec!["crosstalk"],
        rms_before: None,
        rms_after: None,
        by_observable: [(observable, of_observable)].into(),
        by_level: Vec::new(),
        by_band: Vec::new(),
    };
    gap.by_level = vec![Slice::new((1.0, 2.0), &gap), Slice::new((2.0, 10.0), &gap)];
    gap
}

fn answer(verdict: Verdict, gap: Gap, pictures: Pictures) -> Answer {
    let cause = |effect: &'static str, probability: f64| Cause {
        effects: vec![effect],
        probability,
        delta_bic: 0.0,
        stability: 0.93,
        stability_over_runs: None,
        cautions: vec![HOSTILE.into()],
        parameters: [(
            effect,
            [(
                "share",
                Estimate {
                    value: 0.012_5,
                    u: 1e-4,
                },
            )]
            .into(),
        )]
        .into(),
    };
    Answer {
        summary: HOSTILE.into(),
        verdict,
        r#where: vec![Where {
            stage: Stage::Dut,
            observable: Group::Ratio,
            axis: Axis::Level,
            or_along: vec![Axis::Travel],
            from: 1.0,
            to: 10.0,
            share: 0.6,
            p_value: 1e-7,
            class: "odd",
            shape: None,
        }],
        causes: vec![cause("crosstalk", 0.7), cause("dut_resonance", 0.2)],
        none_of_these_p_value: 0.5,
        confusable: vec![vec![HOSTILE.into(), "channel_skew".into()]],
        next_measurement: HOSTILE.into(),
        gap,
        remainder: None,
        noise: OwnNoise {
            outlier_rows: vec![17],
            ..OwnNoise::default()
        },
        probability_other: 0.125,
        nominal_parameters: [(
            "coil_ohm",
            Estimate {
                value: 2.0,
                u: 0.01,
            },
        )]
        .into(),
        dataset: DatasetSummary {
            path: HOSTILE.into(),
            rows: 4,
            columns_used: vec![HOSTILE.into()],
            input_held: Some(true),
            sha256: "00".into(),
        },
        confirmation: None,
        pictures,
    }
}

fn points() -> Pictures {
    let row = |frequency_hz: f64| Conditions {
        frequency_hz,
        level_ms2: 10.0,
        run: 0,
        time_s: 0.0,
        warmer_k: 0.0,
        rotation_deg: 0.0,
        tilt_deg: f64::NAN,
        payload_kg: 0.0,
        held_out: frequency_hz > 100.0,
    };
    let datum = |row: usize| Datum {
        row,
        observable: Observable::Ratio,
        before: 0.08,
        after: 0.001,
        u: 0.001,
        u_after: 0.001,
    };
    Pictures::Points(Residuals {
        rows: [20.0, 40.0, 80.0, 160.0].map(row).into(),
        data: (0..4).map(datum).collect(),
    })
}

fn record() -> Pictures {
    Pictures::Record(Trace {
        interval_s: 0.1,
        measured: vec![0.0, 1.0, -1.0],
        before: vec![0.0, 0.1, -0.1],
        after: vec![0.0, 0.01, f64::NAN],
    })
}

/// Text and attributes; fails where the page is not well-formed.
fn read(page: &str) -> String {
    use quick_xml::events::Event;
    let mut reader = quick_xml::Reader::from_str(page);
    let (mut text, mut open) = (String::new(), 0);
    loop {
        match reader.read_event().expect("well-formed") {
            Event::Start(start) => {
                assert_ne!(start.name().0, "script");
                open += 1;
                assert!(start.attributes().all(|attribute| attribute.is_ok()));
            }
            Event::End(_) => open -= 1,
            Event::Text(part) => text += &part,
            Event::GeneralRef(reference) => text += &format!("&{};", &*reference),
            Event::Eof => break,
            _ => {}
        }
    }
    assert_eq!(open, 0);
    text
}

/// Whether a verdict claims no cause.
fn quiet(verdict: Verdict) -> bool {
    matches!(verdict, Verdict::NoGap | Verdict::Data)
}

#[test]
fn every_verdict_has_its_page() {
    for (verdict, says) in [
        (Verdict::NoGap, "Simulation and measurement agree"),
        (Verdict::Explained, "one channel leaks into the other"),
        (
            Verdict::PartlyExplained,
            "This is part of it: one channel leaks into the other",
        ),
        (Verdict::Data, "The data are not as good as they say"),
        (
            Verdict::Ambiguous,
            "crosstalk (70.0\u{a0}%), dut_resonance (20.0\u{a0}%)",
        ),
        (
            Verdict::Unexplained,
            "the device under test and shows in the ratio of the two transducers, at levels from 1 to 10\u{a0}m",
        ),
    ] {
        for (observable, pictures) in [(Group::Ratio, points()), (Group::Output, record())] {
            let is_record = observable == Group::Output;
            let page = report(&[answer(verdict, gap(observable), pictures)]).expect("renders");
            let text = read(&page);
            assert!(text.contains(says), "{says} in {text}");
            let doubt = "outside the library</td><td>12.5\u{a0}%";
            assert_eq!(page.contains(doubt), !quiet(verdict), "{page}");
            assert!(!page.contains("NaN") && !page.contains("inf'"), "{page}");
            assert_eq!(page.contains("Where: maps"), !is_record);
            assert_eq!(page.contains("Grey: measured output"), is_record);
        }
    }
}

#[test]
fn several_answers_have_a_list_and_names_cannot_leave_their_place() {
    let answers = [points(), record()]
        .map(|pictures| answer(Verdict::Explained, gap(Group::Ratio), pictures));
    let page = report(&answers).expect("renders");
    let text = read(&page);
    assert!(
        text.trim_start().starts_with("Gap between") && text.contains("2 datasets"),
        "{text}"
    );
    assert!(page.contains("href=\"#d1\"") && page.contains("id=\"d1\""));
    assert!(
        !page.contains("<script") && !page.contains("a<b>"),
        "{page}"
    );
    assert_eq!(
        page.matches("d1-plot0").count(),
        2,
        "a clip path and its one user"
    );
}

#[test]
fn both_figures_of_a_confirmation_are_in_the_sentence_and_in_the_table() {
    let distance = Distance {
        before_rel: 0.0791,
        after_rel: 0.003_14,
        rows: 18,
    };
    let mut answer = answer(Verdict::Explained, gap(Group::Ratio), points());
    let mut confirmation = Confirmation {
        effects: vec!["crosstalk=quadrature:<1".into()],
        gap: Some(distance),
        by_observable: [(Group::Ratio, distance)].into(),
        refused: 2,
    };
    answer.confirmation = Some(confirmation.clone());
    let page = report(std::slice::from_ref(&answer)).expect("renders");
    for text in [
        "0.314\u{a0}% instead of 7.91\u{a0}%",
        "<td>18</td><td>7.91 %</td><td>0.314 %</td>",
        "quadrature:&lt;1",
    ] {
        assert!(page.contains(text), "{text} in {page}");
    }
    confirmation.gap = None;
    answer.confirmation = Some(confirmation);
    let page = report(&[answer]).expect("renders");
    assert!(page.contains("refuses all 2 points"));
}
