//! The contribution chart of a budget.

use super::Evaluation;
use crate::chart::{self, Svg};
use crate::text::significant;

const BAR_HEIGHT: f64 = 20.0;
const LABEL_WIDTH: f64 = 280.0;
const BAR_WIDTH: f64 = 360.0;

/// Contributions `|c_i| u_i` as bars, largest first, with the combined
/// standard uncertainty as the full width.
pub fn contribution_chart(evaluation: &Evaluation) -> String {
    let mut order: Vec<_> = evaluation.components.iter().collect();
    order.sort_by(|a, b| b.contribution.total_cmp(&a.contribution));
    let height = 60.0 + BAR_HEIGHT * (order.len() as f64 + 1.0);
    let mut svg = Svg::new(LABEL_WIDTH + BAR_WIDTH + 100.0, height);
    svg.text(10.0, 22.0, "start", 14.0, &evaluation.measurand);
    let widest = order.first().map_or(0.0, |first| first.contribution);
    let full = evaluation.combined_standard_uncertainty.max(widest);
    let unit = evaluation.unit.symbol();
    let mut row = |index: usize, label: &str, value: f64, color: &str| {
        let top = 36.0 + BAR_HEIGHT * index as f64;
        let width = (value / full).min(1.0) * BAR_WIDTH;
        svg.text(LABEL_WIDTH - 6.0, top + 14.0, "end", 11.0, label);
        svg.rectangle(LABEL_WIDTH, top + 3.0, width, BAR_HEIGHT - 6.0, color, 1.0);
        let written = format!("{} {unit}", significant(value, 2));
        svg.text(
            LABEL_WIDTH + width + 6.0,
            top + 14.0,
            "start",
            11.0,
            &written,
        );
    };
    for (index, component) in order.iter().enumerate() {
        row(index, &component.label, component.contribution, chart::BLUE);
    }
    row(
        order.len(),
        "combined standard uncertainty",
        evaluation.combined_standard_uncertainty,
        chart::GREY,
    );
    svg.finish()
}
