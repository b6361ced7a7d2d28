//! The winner's curve through the data, for what shows the gap most clearly.
//!
//! Drawn is the difference to the simulation as it is: the data with two
//! standard uncertainties to either side, and what the best set of effects
//! says that difference should be.

use super::axes::{Axes, HEIGHT, LEFT, WIDTH};
use super::{escape, short};
use crate::pictures::{Conditions, Datum, Residuals};
use std::collections::BTreeMap;
use std::fmt::Write;

/// Plots of a report.
const MOST_PLOTS: usize = 4;

/// Name of a slot, its unit as drawn, and the factor to that unit.
fn slot(at: usize) -> (String, &'static str, f64) {
    let channel = |from: usize| ["reference", "device"][usize::from(at >= from + 8)];
    match at {
        0 => ("ratio".into(), "%", 100.0),
        1 => (
            "ratio, phase".into(),
            "\u{b0}",
            180.0 / std::f64::consts::PI,
        ),
        2 => ("drive".into(), "%", 100.0),
        3 => (
            "drive, phase".into(),
            "\u{b0}",
            180.0 / std::f64::consts::PI,
        ),
        4 => ("current".into(), "%", 100.0),
        5 => (
            "current, phase".into(),
            "\u{b0}",
            180.0 / std::f64::consts::PI,
        ),
        6..22 => {
            let order = 2 + (at - 6) % 8 / 2;
            let part = ["in phase", "in quadrature"][at % 2];
            (
                format!("harmonic {order} of the {}, {part}", channel(6)),
                "%",
                100.0,
            )
        }
        22 => ("d.c. of the reference".into(), "mV", 1e3),
        23 => ("d.c. of the device".into(), "mV", 1e3),
        24 => ("noise of the reference".into(), "%", 100.0),
        _ => ("noise of the device".into(), "%", 100.0),
    }
}

/// Writes the plots of what shows the gap most clearly.
pub(super) fn curves(page: &mut String, residuals: &Residuals, level_axis: bool) {
    page.push_str("<h2>Which: the cause's curve through the data</h2><p class=small>Difference to the simulation as it is. Dots: measured, with two standard uncertainties to either side (hollow: rows that took no part in the score's choice). Line and crosses: what the most probable cause predicts.</p>");
    for (rank, at) in clearest(residuals).into_iter().enumerate() {
        let data: Vec<&Datum> = residuals.data.iter().filter(|d| d.slot == at).collect();
        let level = level_axis && rank == 0;
        if level {
            Plot::new(residuals, &data, LEVEL).draw(page, slot(at));
        }
        Plot::new(residuals, &data, FREQUENCY).draw(page, slot(at));
    }
}

/// Slots with the largest excess over what the cause leaves to chance, one of each observable.
fn clearest(residuals: &Residuals) -> Vec<usize> {
    let mut excess: BTreeMap<usize, f64> = BTreeMap::new();
    for datum in &residuals.data {
        *excess.entry(datum.slot).or_default() += (datum.before / datum.u_after).powi(2) - 1.0;
    }
    let mut order: Vec<(usize, f64)> = excess.into_iter().collect();
    order.sort_by(|a, b| b.1.total_cmp(&a.1));
    let family = |slot: usize| match slot {
        6..22 => 100 + (slot - 6) / 8,
        _ => slot,
    };
    let mut chosen: Vec<usize> = Vec::new();
    for (slot, _) in order {
        if chosen.len() < MOST_PLOTS && !chosen.iter().any(|c| family(*c) == family(slot)) {
            chosen.push(slot);
        }
    }
    chosen
}

/// What a plot is drawn over: its words, and the value of a row.
type Abscissa = (&'static str, fn(&Conditions) -> f64);
const LEVEL: Abscissa = ("level in m/s\u{b2}", |r| r.level_ms2);
const FREQUENCY: Abscissa = ("frequency in Hz", |r| r.frequency_hz);

/// Data of one slot over one condition.
struct Plot<'a> {
    residuals: &'a Residuals,
    data: Vec<&'a Datum>,
    over: Abscissa,
}

impl<'a> Plot<'a> {
    fn new(residuals: &'a Residuals, data: &[&'a Datum], over: Abscissa) -> Self {
        let at = |d: &Datum| over.1(&residuals.rows[d.row]);
        let drawn = data.iter().copied();
        Self {
            residuals,
            data: drawn.filter(|d| at(d).is_finite() && at(d) > 0.0).collect(),
            over,
        }
    }

    /// Value of the condition a datum was taken at.
    fn at(&self, datum: &Datum) -> f64 {
        self.over.1(&self.residuals.rows[datum.row])
    }

    /// Draws it, if it spans anything, with the name of the slot, its unit and the factor to that unit.
    fn draw(&self, page: &mut String, (name, unit, factor): (String, &str, f64)) {
        let marks = self.data.iter().flat_map(|d| {
            let model = d.before - d.after;
            [d.before - 2.0 * d.u, d.before + 2.0 * d.u, model].map(|v| v * factor)
        });
        let Some(axes) = Axes::over(self.data.iter().map(|d| self.at(d)), marks) else {
            return;
        };
        let place = |d: &Datum, value: f64| (axes.to_x(self.at(d)), axes.to_y(value * factor));
        let _ = write!(
            page,
            "<svg class=plot viewBox='0 0 {WIDTH} {HEIGHT}' role=img aria-label='{}'>",
            escape(&name)
        );
        axes.draw(page);
        self.draw_data(page, place, |v| format!("{} {unit}", short(v * factor)));
        self.draw_model(page, |d| place(d, d.before - d.after));
        let _ = write!(
            page,
            "<text x={LEFT} y={}>{} in {unit}, over {}</text></svg>",
            HEIGHT - 4.0,
            escape(&name),
            self.over.0
        );
    }

    /// A dot for each datum, with two standard uncertainties to either side.
    fn draw_data(
        &self,
        page: &mut String,
        place: impl Fn(&Datum, f64) -> (f64, f64),
        words: impl Fn(f64) -> String,
    ) {
        for d in &self.data {
            let (px, py) = place(d, d.before);
            let up = place(d, d.before + 2.0 * d.u).1;
            let down = place(d, d.before - 2.0 * d.u).1;
            let row = &self.residuals.rows[d.row];
            let class = if row.held_out { "held" } else { "dot" };
            let _ = write!(
                page,
                "<path class=whisker d='M{px:.1} {up:.1}V{down:.1}'/><circle class={class} cx={px:.1} cy={py:.1} r=3><title>{} Hz: {}</title></circle>",
                short(row.frequency_hz),
                words(d.before)
            );
        }
    }

    /// What the cause predicts: a cross per row, joined within rows of the same condition.
    fn draw_model(&self, page: &mut String, place: impl Fn(&Datum) -> (f64, f64)) {
        let mut groups: BTreeMap<String, Vec<(f64, f64)>> = BTreeMap::new();
        for datum in &self.data {
            let r = &self.residuals.rows[datum.row];
            let key = format!(
                "{} {} {} {:.4} {:.1e}",
                r.run, r.rotation_deg, r.tilt_deg, r.payload_kg, r.level_ms2
            );
            groups.entry(key).or_default().push(place(datum));
        }
        for mut points in groups.into_values() {
            points.sort_by(|a, b| a.0.total_cmp(&b.0));
            line(page, &points);
        }
    }
}

/// Crosses in ascending order, and the line through them.
fn line(page: &mut String, points: &[(f64, f64)]) {
    for (x, y) in points {
        let _ = write!(
            page,
            "<path class=cross d='M{:.1} {y:.1}h6M{x:.1} {:.1}v6'/>",
            x - 3.0,
            y - 3.0
        );
    }
    // Several levels at one frequency make a line meaningless.
    let one_each = points.windows(2).all(|w| w[1].0 - w[0].0 > 0.5);
    if one_each && points.len() > 2 {
        page.push_str("<polyline class=model points='");
        for (x, y) in points {
            let _ = write!(page, "{x:.1},{y:.1} ");
        }
        page.push_str("'/>");
    }
}
