//! A check as text.

use super::change::{Change, is_within};
use super::evaluate::Evaluation;
use crate::text::Table;

/// Tables of results and budget within 80 columns.
pub fn report(evaluation: &Evaluation) -> String {
    let mut table = Table::new(&[
        "f/Hz",
        "mV/(m/s2)",
        "phase/deg",
        "U/%",
        "certificate",
        "off by/%",
    ]);
    for point in &evaluation.points {
        table.row([
            point.frequency_hz.to_string(),
            format!("{:.4}", 1000.0 * point.sensitivity_v_per_ms2),
            format!("{:+.2}", point.phase_deg),
            format!("{:.2}", 100.0 * point.expanded_uncertainty_rel),
            format!("{:.4}", 1000.0 * point.certified_v_per_ms2),
            format!("{:+.2}", 100.0 * point.change_rel),
        ]);
    }
    let exciter = &evaluation.exciter;
    format!(
        "{table}\nexciter: {:.1} g, {:.0} N/m, Bl {:.3} N/A; coil with the mass {:+.1} mohm\nposition {}; {:.1} mA carry the mass\n\n{}",
        1000.0 * exciter.moving_mass_kg,
        exciter.stiffness_n_per_m,
        exciter.force_factor_n_per_a,
        1000.0 * exciter.warmer_ohm,
        if evaluation.equipment.held {
            "held"
        } else {
            "not held"
        },
        1000.0 * exciter.hold_a,
        budget(evaluation),
    )
}

/// The budget at a few frequencies, %.
fn budget(evaluation: &Evaluation) -> String {
    let points = &evaluation.points;
    let nearest = |hz: f64| {
        let off = |index: &usize| (points[*index].frequency_hz / hz).ln().abs();
        (0..points.len()).min_by(|one, other| off(one).total_cmp(&off(other)))
    };
    let mut shown: Vec<usize> = [40.0, 80.0, 160.0, 315.0, 1000.0]
        .into_iter()
        .filter_map(nearest)
        .collect();
    shown.dedup();
    let names: Vec<String> = shown
        .iter()
        .map(|index| format!("{} Hz", points[*index].frequency_hz))
        .collect();
    let mut header = vec!["u/%"];
    header.extend(names.iter().map(String::as_str));
    let mut table = Table::new(&header);
    for row in &evaluation.budget {
        let values = shown
            .iter()
            .map(|index| format!("{:.3}", 100.0 * row.standard_rel[*index].abs()));
        table.row(std::iter::once(row.what.clone()).chain(values));
    }
    table.to_string()
}

/// U of the ratio of the channels that a check counts on, relative.
const WANTED_RATIO_REL: f64 = 5e-4;

/// Warning about the ratio of the channels in a check; none where the ratio is known well enough and, where there is
/// a baseline, was measured anew since. The channels may change as the reference may.
pub fn about_the_ratio(found: &Evaluation, baseline: Option<&Evaluation>) -> Option<String> {
    const REMEDY: &str = "`calib adjust ratio --write` before a check";
    if found.ratio.is_empty() {
        return Some(format!(
            "the ratio of the channels was never measured, and U has what its parts may be off by: {REMEDY}"
        ));
    }
    if baseline.is_some_and(|baseline| baseline.ratio == found.ratio) {
        return Some(format!(
            "the ratio of the channels is still that of the baseline: if it changed since, that looks like a change of \
             the reference: {REMEDY}"
        ));
    }
    let stated = found.ratio.iter().filter(|row| is_within(row.frequency_hz));
    let most_rel = stated
        .map(|row| row.expanded_uncertainty_rel)
        .fold(0.0, f64::max);
    (most_rel > WANTED_RATIO_REL).then(|| {
        format!(
            "the ratio of the channels is known to {:.2} %, where {:.2} % is wanted: against the certificate U has \
             that; against a baseline it cancels",
            100.0 * most_rel,
            100.0 * WANTED_RATIO_REL
        )
    })
}

/// Conclusions, a line each.
pub fn change_text(changes: &[Change]) -> String {
    let lines = changes.iter().map(|change| {
        let over = match change.frequencies {
            1 => "one value".to_owned(),
            count => format!("63 Hz to 250 Hz, {count} frequencies"),
        };
        format!("reference {} ({over})", change.words())
    });
    lines.collect::<Vec<_>>().join("\n")
}
