//! What the simulator of the whole instrument says once it has the cause.

use super::{escape, plain, short};
use crate::answer::{Confirmation, Distance};
use std::fmt::Write;

/// Before and after by observable, between the records of the simulator and the measurement.
pub(super) fn confirmed(page: &mut String, confirmation: &Confirmation) {
    let effects = escape(&confirmation.effects.join(" and "));
    let _ = write!(page, "<h2>Confirmed on the simulator</h2>");
    let Some(gap) = &confirmation.gap else {
        let _ = write!(
            page,
            "<p>With <code>{effects}</code> added, the simulated calibrator refuses all {} points: nothing is confirmed.</p>",
            confirmation.refused
        );
        return;
    };
    let _ = write!(
        page,
        "<p><code>{effects}</code> was added to the simulated rig, and the instrument's own firmware measured {} points of this dataset on it. Its records miss the measurement by {}\u{a0}% instead of {}\u{a0}%.</p><table><tr><th>Observable<th>Rows<th>Before<th>After</tr>",
        gap.rows,
        short(gap.after_percent),
        short(gap.before_percent)
    );
    for (name, distance) in &confirmation.by_observable {
        row(page, plain::observable(name), distance);
    }
    let _ = write!(
        page,
        "</table><p class=small>{} points were refused by the simulated instrument, with or without the cause.</p>",
        confirmation.refused
    );
}

fn row(page: &mut String, name: &str, distance: &Distance) {
    let _ = write!(
        page,
        "<tr><td>{name}<td>{}<td>{} %<td>{} %</tr>",
        distance.rows,
        short(distance.before_percent),
        short(distance.after_percent)
    );
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_figures_are_in_the_sentence_and_in_the_table() {
        let distance = Distance {
            before_percent: 7.91,
            after_percent: 0.314,
            rows: 18,
        };
        let mut page = String::new();
        let mut confirmation = Confirmation {
            effects: vec!["crosstalk=quadrature:<1".into()],
            gap: Some(distance),
            by_observable: [("ratio", distance)].into(),
            refused: 2,
        };
        confirmed(&mut page, &confirmation);
        for text in [
            "0.314\u{a0}% instead of 7.91\u{a0}%",
            "<td>18<td>7.91 %<td>0.314 %",
            "quadrature:&lt;1",
        ] {
            assert!(page.contains(text), "{text} in {page}");
        }
        confirmation.gap = None;
        confirmed(&mut page, &confirmation);
        assert!(page.contains("refuses all 2 points"));
    }
}
