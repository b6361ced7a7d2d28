//! Maps of the residual: over frequency and level, and over each condition.
//!
//! A cell holds the root mean square of difference over uncertainty: about 1
//! is noise. The number is printed in the cell, so colour is not needed.

use crate::observable::Group;
use crate::pictures::{Conditions, Datum, Residuals};
use crate::summary::three_digits;
use crate::thresholds;
use serde::Serialize;

/// Rows of a map: the observables of a group that are phases, or those that are not.
type Mapped = (Group, bool);

const MAPPED: [(Mapped, &str); 10] = [
    ((Group::Ratio, false), "ratio"),
    ((Group::Ratio, true), "ratio, phase"),
    ((Group::Drive, false), "drive"),
    ((Group::Drive, true), "drive, phase"),
    ((Group::Current, false), "current"),
    ((Group::Current, true), "current, phase"),
    ((Group::RefHarmonics, false), "harmonics, reference"),
    ((Group::DutHarmonics, false), "harmonics, device"),
    ((Group::Dc, false), "d.c."),
    ((Group::Noise, false), "noise"),
];

fn mapped(datum: &Datum) -> Mapped {
    (datum.observable.group(), datum.observable.is_phase())
}

/// Upper ends of the colour classes, in standard uncertainties.
const CLASSES: [f64; 5] = [1.5, 3.0, 6.0, 15.0, 50.0];
const FREQUENCY_BINS: usize = 12;
const LEVEL_BINS: usize = 6;

/// Values of a map by row and column; none where nothing was measured.
#[derive(Serialize)]
pub(super) struct Map {
    columns: Vec<String>,
    rows: Vec<(String, Vec<Option<f64>>)>,
}

/// A map of the simulation as it is, and of the one with the most probable cause.
#[derive(Serialize)]
pub(super) struct Pair {
    title: &'static str,
    before: Map,
    after: Map,
}

/// Title of a map, and the map where these data fill it.
type Builder = (&'static str, fn(&Residuals, Side) -> Option<Map>);

/// All maps that these data fill.
pub(super) fn maps(residuals: &Residuals) -> Vec<Pair> {
    let builders: [Builder; 3] = [
        ("What shows it, over frequency", by_observable),
        ("At which level, over frequency", by_level),
        ("Under which condition", by_condition),
    ];
    let pair = |(title, build): Builder| {
        Some(Pair {
            title,
            before: build(residuals, |d| d.before / d.u)?,
            after: build(residuals, |d| d.after / d.u_after)?,
        })
    };
    builders.into_iter().filter_map(pair).collect()
}

/// Difference over uncertainty, before or after.
type Side = fn(&Datum) -> f64;

/// Root mean square of the data that belong to each column.
fn line<'a>(
    data: impl Iterator<Item = &'a Datum>,
    side: Side,
    columns: usize,
    column: impl Fn(&Datum) -> Option<usize>,
) -> Vec<Option<f64>> {
    let mut sums = vec![(0.0, 0.0); columns];
    for datum in data {
        if let Some(sum) = column(datum).and_then(|at| sums.get_mut(at)) {
            sum.0 += side(datum).powi(2);
            sum.1 += 1.0;
        }
    }
    let root = |(sum, count): (f64, f64)| (count > 0.0).then(|| (sum / count).sqrt());
    sums.into_iter().map(root).collect()
}

/// Logarithmic bins.
struct Bins {
    edges: Vec<f64>,
}

impl Bins {
    fn new(values: impl Iterator<Item = f64>, most: usize) -> Option<Self> {
        let finite = values.filter(|v| v.is_finite() && *v > 0.0);
        let (low, high) = finite.fold((f64::INFINITY, 0.0_f64), |(a, b), v| (a.min(v), b.max(v)));
        (high > 0.0).then(|| {
            let count = if high > thresholds::ONE_LEVEL * low {
                most
            } else {
                1
            };
            let step = (high / low).powf(1.0 / count as f64);
            let edges = (0..=count).map(|at| low * step.powi(at as i32));
            Self {
                edges: edges.collect(),
            }
        })
    }

    fn count(&self) -> usize {
        self.edges.len() - 1
    }

    fn of(&self, value: f64) -> Option<usize> {
        let above = self.edges[1..].iter().position(|edge| value < *edge);
        value.is_finite().then(|| above.unwrap_or(self.count() - 1))
    }

    fn names(&self, unit: &str) -> Vec<String> {
        let name =
            |pair: &[f64]| format!("{}..{}{unit}", three_digits(pair[0]), three_digits(pair[1]));
        self.edges.windows(2).map(name).collect()
    }
}

fn by_observable(residuals: &Residuals, side: Side) -> Option<Map> {
    let bins = frequencies(residuals)?;
    let column = |datum: &Datum| bins.of(residuals.rows[datum.row].frequency_hz);
    let rows = MAPPED.iter().map(|(together, name)| {
        let inside = residuals.data.iter().filter(|d| mapped(d) == *together);
        ((*name).to_owned(), line(inside, side, bins.count(), column))
    });
    Some(Map {
        columns: bins.names(" Hz"),
        rows: rows
            .filter(|row| row.1.iter().any(Option::is_some))
            .collect(),
    })
}

fn frequencies(residuals: &Residuals) -> Option<Bins> {
    Bins::new(
        residuals.rows.iter().map(|r| r.frequency_hz),
        FREQUENCY_BINS,
    )
}

fn by_level(residuals: &Residuals, side: Side) -> Option<Map> {
    let bins = frequencies(residuals)?;
    let levels = Bins::new(residuals.rows.iter().map(|r| r.level_ms2), LEVEL_BINS)?;
    let column = |datum: &Datum| bins.of(residuals.rows[datum.row].frequency_hz);
    let names = levels.names(" m/s\u{b2}");
    let rows = names.into_iter().enumerate().rev().map(|(at, name)| {
        let of_level = |d: &&Datum| levels.of(residuals.rows[d.row].level_ms2) == Some(at);
        let data = residuals.data.iter().filter(of_level);
        (name, line(data, side, bins.count(), column))
    });
    (levels.count() > 1).then(|| Map {
        columns: bins.names(" Hz"),
        rows: rows.collect(),
    })
}

/// Condition in words, with the value that tells its rows apart.
type Condition = (&'static str, &'static str, fn(&Conditions) -> f64);

const CONDITIONS: [Condition; 6] = [
    ("run", "", |r| r.run as f64 + 1.0),
    ("rotation", "\u{b0}", |r| r.rotation_deg),
    ("tilt", "\u{b0}", |r| r.tilt_deg),
    ("payload", " kg", |r| r.payload_kg),
    ("temperature", " K above reference", |r| {
        (2.0 * r.warmer_k).round() / 2.0
    }),
    ("time", " min", |r| (r.time_s / 600.0).floor() * 10.0),
];
/// Most values of a condition that are listed.
const MOST_VALUES: usize = 8;

fn by_condition(residuals: &Residuals, side: Side) -> Option<Map> {
    let mut rows = Vec::new();
    for (name, unit, value) in CONDITIONS {
        let mut values: Vec<f64> = residuals.rows.iter().map(value).collect();
        values.sort_by(f64::total_cmp);
        values.dedup();
        if values.len() < 2 {
            continue;
        }
        let groups = values.chunks(values.len().div_ceil(MOST_VALUES));
        for group in groups {
            let (first, last) = (group[0], group[group.len() - 1]);
            let inside = |d: &&Datum| (first..=last).contains(&value(&residuals.rows[d.row]));
            let data = residuals.data.iter().filter(inside);
            let column = |d: &Datum| MAPPED.iter().position(|m| m.0 == mapped(d));
            let range = if first == last {
                three_digits(first)
            } else {
                format!("{}..{}", three_digits(first), three_digits(last))
            };
            rows.push((
                format!("{name} {range}{unit}"),
                line(data, side, MAPPED.len(), column),
            ));
        }
    }
    (!rows.is_empty()).then(|| Map {
        columns: MAPPED.iter().map(|m| m.1.to_owned()).collect(),
        rows,
    })
}

/// Colour class of a cell.
pub(super) fn class(chi: f64) -> usize {
    let class = CLASSES.iter().position(|end| chi <= *end);
    class.unwrap_or(CLASSES.len())
}

/// Number of a cell, at most four characters.
pub(super) fn number(chi: f64) -> String {
    match chi {
        c if c < 9.95 => format!("{c:.1}"),
        c if c < 9999.5 => format!("{c:.0}"),
        c => format!("{c:.0e}"),
    }
}
