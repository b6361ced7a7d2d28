//! Evaluated readings as text.

use super::PointSensitivity;
use crate::text::{significant, table, wrap};

/// The table of results, and what the reader should know.
pub fn report(points: &[PointSensitivity], unit: &str, remarks: &[String]) -> String {
    let rows: Vec<Vec<String>> = points.iter().map(row).collect();
    let header = [
        "f/Hz",
        "S",
        "phase/deg",
        "dev/%",
        "dev/dB",
        "drift/%",
        "state",
    ];
    let method = points.first().map_or("", |point| point.method);
    let mut text = format!(
        "ISO 16063-21, clause 6, {method}; S in {unit}\n\n{}",
        table(&header, &rows)
    );
    if points.iter().any(|point| point.inverted) {
        text.push_str("\ninverted: the output falls with positive motion (Annex B)\n");
    }
    for (point, why) in points
        .iter()
        .filter_map(|p| Some((p, p.refused.as_deref()?)))
    {
        let line = format!("{} Hz refused: {why}", point.frequency_hz);
        text.push_str(&format!("\n{}", wrap(&line, 0)));
    }
    if points.iter().any(|point| point.drift_rel.is_some()) {
        text.push_str(&format!(
            "\n{}",
            wrap(
                "Half of each drift is the half-width of a rectangular component of \
                 the budget (row 3 of Table A.1).",
                0
            )
        ));
    }
    for remark in remarks {
        text.push_str(&wrap(remark, 2));
    }
    text
}

fn row(point: &PointSensitivity) -> Vec<String> {
    let places = |value: Option<f32>, places: usize| {
        value.map_or("-".into(), |value| format!("{value:+.places$}"))
    };
    let percent = |value: Option<f32>| value.map(|value| 100.0 * value);
    vec![
        significant(f64::from(point.frequency_hz), 5),
        point
            .sensitivity
            .map_or("-".into(), |s| significant(f64::from(s), 5)),
        places(point.phase_deg, 3),
        places(percent(point.deviation_rel), 3),
        places(point.deviation_db, 4),
        places(percent(point.drift_rel), 3),
        match (point.sensitivity, point.inverted) {
            (None, _) => "refused".into(),
            (_, true) => "inverted".into(),
            (_, false) => "valid".into(),
        },
    ]
}
