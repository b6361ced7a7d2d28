//! The contribution chart of a budget.

use super::Evaluation;
use crate::text::significant;
use calib_plot::{Axis, Ink, Mark, Plot, Scale, sheet};

/// Room for the labels of components.
const LABEL_WIDTH: f64 = 300.0;
/// Height of a bar with the space around it.
const BAR_HEIGHT: f64 = 20.0;

/// Contributions `|c_i| u_i` as bars, largest first, and the combined standard
/// uncertainty below.
pub fn contribution_chart(evaluation: &Evaluation) -> String {
    let combined = evaluation.combined_standard_uncertainty;
    // From below, as an axis counts.
    let mut rows: Vec<(&str, f64)> = vec![("combined standard uncertainty", combined)];
    let mut order: Vec<_> = evaluation.components.iter().collect();
    order.sort_by(|a, b| a.contribution.total_cmp(&b.contribution));
    rows.extend(order.iter().map(|c| (c.label.as_str(), c.contribution)));
    let widest = rows
        .iter()
        .map(|row| row.1)
        .fold(f64::MIN_POSITIVE, f64::max);
    let unit = evaluation.unit.symbol();
    // So that the longest bar leaves room for its value.
    let x = Axis::new(Scale::Linear, 0.0, 1.3 * widest).titled(unit);
    let y = Axis::named(rows.iter().map(|row| row.0.to_owned()).collect());
    let bars = rows
        .iter()
        .enumerate()
        .map(|(at, row)| (at as f64 + 0.5, row.1));
    let (below, above): (Vec<_>, Vec<_>) = bars.clone().partition(|bar| bar.0 < 1.0);
    let mut plot = Plot::new(&evaluation.measurand, x, y)
        .with(Mark::Bars {
            bars: below,
            ink: Ink::Grey,
        })
        .with(Mark::Bars {
            bars: above,
            ink: Ink::Blue,
        });
    let words = bars.map(|(place, value)| Mark::Words {
        at: (value, place),
        text: format!("{} {unit}", significant(value, 2)),
    });
    plot.marks.extend(words);
    plot.left = LABEL_WIDTH;
    plot.height = 80.0 + BAR_HEIGHT * rows.len() as f64;
    sheet(&[plot], 1)
}
