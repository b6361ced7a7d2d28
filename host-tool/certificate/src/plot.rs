//! Frequency responses of a certificate, with bars of U and the tolerance.

use super::band;
use super::model::{Certificate, Point as Row, PointValues};
use super::words::Language;
use calib_plot::{Axis, Ink, Mark, Plot, Point, Scale, Shape};

/// Sensitivity in the unit of the kind with the deviation from the reference point.
pub(super) fn sensitivity(certificate: &Certificate, language: Language) -> String {
    let unit = certificate.kind.stated_unit();
    let points = points(certificate, language, |values| {
        let value = unit.of_si(values.sensitivity);
        Some((value, value * values.expanded_uncertainty_percent / 100.0))
    });
    let x = frequencies(certificate, language);
    let shown =
        |(hz, limits): band::Place| (hz, unit.of_si(limits.lower), unit.of_si(limits.upper));
    let area = |area: Vec<band::Place>| area.into_iter().map(shown).collect();
    let areas = band::areas(certificate, x.low, x.high);
    let areas: Vec<Vec<_>> = areas.into_iter().map(area).collect();
    let own = band::at_reference(certificate).map(shown);
    let limits = areas.iter().flatten().chain(&own);
    let ends = points.iter().flat_map(Point::ends);
    let ends = ends.chain(limits.flat_map(|(_, lower, upper)| [*lower, *upper]));
    let y = Axis::around(Scale::Linear, ends);
    let title = language.phrase("plot.sensitivity_in", &[unit.printed()]);
    let mut plot = Plot::new(title, x, y);
    plot.right = deviations(certificate, &plot.y, language);
    let band = |places| Mark::Band {
        places,
        ink: Ink::Blue,
    };
    plot.marks.extend(areas.into_iter().map(band));
    plot.marks.extend(own.map(|(x, lower, upper)| Mark::Limits {
        x,
        limits: [lower, upper],
    }));
    finish(plot, points, certificate, language, "plot-sensitivity")
}

/// Phase in degrees.
pub(super) fn phase(certificate: &Certificate, language: Language) -> String {
    let points = points(certificate, language, |values| {
        Some((values.phase_deg, values.printed_phase_deg?.uncertainty))
    });
    let y = Axis::around(Scale::Linear, points.iter().flat_map(Point::ends));
    let x = frequencies(certificate, language);
    let plot = Plot::new(language.word("plot.phase"), x, y);
    finish(plot, points, certificate, language, "plot-phase")
}

fn frequencies(certificate: &Certificate, language: Language) -> Axis {
    let frequencies = certificate.points.iter().map(|row| row.frequency_hz);
    Axis::around(Scale::Logarithmic, frequencies).titled(language.word("plot.frequency"))
}

/// The scale of `y` in percent of the sensitivity at the reference point.
fn deviations(certificate: &Certificate, y: &Axis, language: Language) -> Option<Axis> {
    let (_, values) = certificate.reference_result()?;
    let reference = certificate.kind.stated_unit().of_si(values.sensitivity);
    let percent = |value: f64| (value / reference - 1.0) * 100.0;
    let axis = Axis::new(Scale::Linear, percent(y.low), percent(y.high));
    Some(axis.titled(language.word("plot.deviation")))
}

/// Points that passed: their value and the half width of their bar.
fn points(
    certificate: &Certificate,
    language: Language,
    of: impl Fn(&PointValues) -> Option<(f64, f64)>,
) -> Vec<Point> {
    let point = |(index, row): (usize, &Row)| {
        let (value, half_bar) = of(row.outcome.as_ref().ok()?)?;
        let title = format!(
            "{} Hz: {} \u{b1} {}",
            language.shortest(row.nominal_frequency_hz),
            language.number(value, 4),
            language.number(half_bar, 4)
        );
        let is_reference = certificate.reference == Some(index);
        let shape = if is_reference {
            Shape::Hollow
        } else {
            Shape::Dot
        };
        Some(Point {
            shape,
            title,
            ..Point::new(row.frequency_hz, value).with_bar(half_bar)
        })
    };
    certificate
        .points
        .iter()
        .enumerate()
        .filter_map(point)
        .collect()
}

/// The drawing with its points, the line through them, and what was refused.
fn finish(
    plot: Plot,
    points: Vec<Point>,
    certificate: &Certificate,
    language: Language,
    id: &str,
) -> String {
    let line = points.iter().map(|point| (point.x, point.y)).collect();
    let mut plot = plot
        .with(Mark::Line {
            points: line,
            ink: Ink::Blue,
        })
        .with(Mark::Points {
            points,
            ink: Ink::Blue,
        });
    let refused = certificate.points.iter().filter_map(|row| {
        let refusal = row.outcome.as_ref().err()?;
        let title = format!(
            "{} Hz: {}",
            language.shortest(row.nominal_frequency_hz),
            language.word(&format!("reason.{}", refusal.0))
        );
        Some(Mark::Missing {
            x: row.frequency_hz,
            title,
        })
    });
    plot.marks.extend(refused);
    plot.zoom = true;
    plot.decimal_sign = language.decimal_sign();
    plot.svg(id)
}
