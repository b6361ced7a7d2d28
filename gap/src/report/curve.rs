//! The most probable cause's curve through the data, for what shows the gap most clearly.
//!
//! Drawn is the difference to the simulation as it is: the data with two
//! standard uncertainties to either side, and what the best set of effects
//! says that difference should be.

use crate::observable::{Channel, Group, Observable};
use crate::pictures::{Conditions, Datum, Residuals, Trace};
use crate::summary::three_digits;
use calib_plot::{Axis, Ink, Mark, Plot, Point, Scale, Shape};
use std::collections::BTreeMap;

/// Plots of a report.
const MOST_PLOTS: usize = 4;

/// Name of an observable, its unit as drawn, and the factor to that unit.
fn drawn(observable: Observable) -> (String, &'static str, f64) {
    const PERCENT: (&str, f64) = ("%", 100.0);
    const DEGREES: (&str, f64) = ("\u{b0}", 180.0 / std::f64::consts::PI);
    const MILLIVOLTS: (&str, f64) = ("mV", 1e3);
    let harmonic = |channel| {
        let parts = Observable::harmonics(channel);
        let part = if parts.iter().any(|[real, _]| *real == observable) {
            "in phase"
        } else {
            "in quadrature"
        };
        let of = match channel {
            Channel::Reference => "reference",
            Channel::Dut => "device",
        };
        let order = observable.order().unwrap_or(0);
        format!("harmonic {order} of the {of}, {part}")
    };
    let (name, (unit, factor)) = match observable {
        Observable::Ratio => ("ratio".into(), PERCENT),
        Observable::RatioPhase => ("ratio, phase".into(), DEGREES),
        Observable::Drive => ("drive".into(), PERCENT),
        Observable::DrivePhase => ("drive, phase".into(), DEGREES),
        Observable::Current => ("current".into(), PERCENT),
        Observable::CurrentPhase => ("current, phase".into(), DEGREES),
        Observable::RefDc => ("d.c. of the reference".into(), MILLIVOLTS),
        Observable::DutDc => ("d.c. of the device".into(), MILLIVOLTS),
        Observable::RefNoise => ("noise of the reference".into(), PERCENT),
        Observable::DutNoise => ("noise of the device".into(), PERCENT),
        _ if observable.group() == Group::RefHarmonics => (harmonic(Channel::Reference), PERCENT),
        _ => (harmonic(Channel::Dut), PERCENT),
    };
    (name, unit, factor)
}

/// Plots of what shows the gap most clearly, the first one also over level where that is asked for.
pub(super) fn curves(residuals: &Residuals, level_axis: bool) -> Vec<Plot> {
    let mut plots = Vec::new();
    for (rank, at) in clearest(residuals).into_iter().enumerate() {
        let of = |d: &&Datum| d.observable == at;
        let data: Vec<&Datum> = residuals.data.iter().filter(of).collect();
        if level_axis && rank == 0 {
            plots.extend(Curve::new(residuals, &data, LEVEL).plot(drawn(at)));
        }
        plots.extend(Curve::new(residuals, &data, FREQUENCY).plot(drawn(at)));
    }
    plots
}

/// Observables with the largest excess over what the cause leaves to chance; of the harmonics of a
/// channel one.
fn clearest(residuals: &Residuals) -> Vec<Observable> {
    let mut excess: BTreeMap<Observable, f64> = BTreeMap::new();
    for datum in &residuals.data {
        *excess.entry(datum.observable).or_default() +=
            (datum.before / datum.u_after).powi(2) - 1.0;
    }
    let mut order: Vec<(Observable, f64)> = excess.into_iter().collect();
    order.sort_by(|a, b| b.1.total_cmp(&a.1));
    let mut chosen: Vec<Observable> = Vec::new();
    for (observable, _) in order {
        let alike =
            |c: &Observable| observable.order().is_some() && c.group() == observable.group();
        if chosen.len() < MOST_PLOTS && !chosen.iter().any(alike) {
            chosen.push(observable);
        }
    }
    chosen
}

/// Axis of a plot: its words, and the value of a row.
type Abscissa = (&'static str, fn(&Conditions) -> f64);
const LEVEL: Abscissa = ("level in m/s\u{b2}", |r| r.level_ms2);
const FREQUENCY: Abscissa = ("frequency in Hz", |r| r.frequency_hz);

/// Data of one observable over one condition.
struct Curve<'a> {
    residuals: &'a Residuals,
    data: Vec<&'a Datum>,
    over: Abscissa,
}

impl<'a> Curve<'a> {
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

    /// The plot, if it spans anything; takes the name of the observable, its unit and the factor to
    /// that unit.
    fn plot(&self, (name, unit, factor): (String, &str, f64)) -> Option<Plot> {
        let mut places = self.data.iter().map(|d| self.at(d));
        let first = places.next()?;
        if places.all(|place| place == first) {
            return None;
        }
        let x = Axis::around(Scale::Logarithmic, self.data.iter().map(|d| self.at(d)));
        let of_datum = |d: &&Datum| self.point(d, unit, factor);
        let points: Vec<Point> = self.data.iter().map(of_datum).collect();
        let model = self.model(factor);
        let predicted = model.iter().flatten().map(|place| place.1);
        let ends = points.iter().flat_map(Point::ends).chain(predicted);
        let y = Axis::around(Scale::Linear, ends);
        let zero = vec![(x.low, 0.0), (x.high, 0.0)];
        let mut plot = Plot::new(format!("{name} in {unit}"), x.titled(self.over.0), y)
            .with(Mark::Line {
                points: zero,
                ink: Ink::Grey,
            })
            .with(Mark::Points {
                points,
                ink: Ink::Grey,
            });
        for points in model {
            plot.marks.extend(prediction(points));
        }
        Some(plot)
    }

    /// A datum with two standard uncertainties to either side.
    fn point(&self, d: &Datum, unit: &str, factor: f64) -> Point {
        let row = &self.residuals.rows[d.row];
        let value = d.before * factor;
        Point {
            shape: if row.held_out {
                Shape::Hollow
            } else {
                Shape::Dot
            },
            title: format!(
                "{} Hz: {} {unit}",
                three_digits(row.frequency_hz),
                three_digits(value)
            ),
            ..Point::new(self.at(d), value).with_bar(2.0 * d.u * factor)
        }
    }

    /// Prediction of the cause, in ascending order, by rows of the same condition.
    fn model(&self, factor: f64) -> Vec<Vec<(f64, f64)>> {
        let mut groups: BTreeMap<String, Vec<(f64, f64)>> = BTreeMap::new();
        for datum in &self.data {
            let r = &self.residuals.rows[datum.row];
            let key = format!(
                "{} {} {} {:.4} {:.1e}",
                r.run, r.rotation_deg, r.tilt_deg, r.payload_kg, r.level_ms2
            );
            let place = (self.at(datum), (datum.before - datum.after) * factor);
            groups.entry(key).or_default().push(place);
        }
        let mut groups: Vec<_> = groups.into_values().collect();
        for points in &mut groups {
            points.sort_by(|a, b| a.0.total_cmp(&b.0));
        }
        groups
    }
}

/// A cross per row, and the line through them.
fn prediction(points: Vec<(f64, f64)>) -> Vec<Mark> {
    let cross = |(x, y): &(f64, f64)| Point {
        shape: Shape::Cross,
        ..Point::new(*x, *y)
    };
    let crosses = Mark::Points {
        points: points.iter().map(cross).collect(),
        ink: Ink::Blue,
    };
    // Several levels at one frequency make a line meaningless.
    let one_each = points.windows(2).all(|pair| pair[1].0 > 1.005 * pair[0].0);
    if one_each && points.len() > 2 {
        vec![
            crosses,
            Mark::Line {
                points,
                ink: Ink::Blue,
            },
        ]
    } else {
        vec![crosses]
    }
}

/// The error of a record over time, before and after.
pub(super) fn trace(trace: &Trace) -> Plot {
    let seconds = |at: usize| at as f64 * trace.interval_s;
    let line = |values: &[f64], ink: Ink| {
        let points = values
            .iter()
            .enumerate()
            .map(|(at, value)| (seconds(at), *value));
        Mark::Line {
            points: points.collect(),
            ink,
        }
    };
    let all = trace.measured.iter().chain(&trace.before);
    let largest = all.fold(1e-30_f64, |most, value| most.max(value.abs()));
    let x = Axis::new(Scale::Linear, 0.0, seconds(trace.measured.len().max(2)));
    let y = Axis::new(Scale::Linear, -largest, largest);
    Plot::new("output, and what is left of it", x.titled("time in s"), y)
        .with(line(&trace.measured, Ink::Grey))
        .with(line(&trace.before, Ink::Red))
        .with(line(&trace.after, Ink::Blue))
}
