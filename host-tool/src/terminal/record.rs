//! A record on one screen: the response with U, and the table of its points.

use calib_certificate::decision::Stated;
use calib_certificate::model::{Point, PointValues};
use calib_certificate::{Certificate, Language, SensitivityUnit};
use calib_core::point::PointResult;
use calib_output::code;
use calib_plot::{Plot, Scale};
use calib_protocol::record::Record;
use std::fmt::Write;

/// Rows of the plot.
const ROWS: usize = 14;

/// The record in words, as a plot and as a table, `width` columns wide, in the quantity and unit of the sensor.
pub fn show(record: &Record, certificate: &Certificate, width: usize) -> String {
    let unit = certificate.kind.unit();
    let mut text = heading(record, certificate);
    if let Some(verdict) = certificate.verdict(Language::En) {
        text += &super::verdict(&verdict);
        text += "\n\n";
    }
    text += &response(certificate, unit, width);
    text.push('\n');
    if let Some(shown) = certificate.resonance.and_then(|shown| shown.in_words()) {
        let _ = writeln!(text, "mounted resonance, effective: {shown}\n");
    }
    let heading = format!("S/({})", unit.name());
    let _ = writeln!(
        text,
        "   f/Hz   a/(m/s2)  {heading:>13}    U/%    phase/deg  verdict"
    );
    for point in &certificate.points {
        let measured = record.points.iter().find(|measured| is(point, measured));
        text += &line(certificate, point, measured, unit);
    }
    text
}

fn heading(record: &Record, certificate: &Certificate) -> String {
    let labels = &record.head.labels;
    let mut text = format!(
        "record {} of {}, {}\n",
        record.head.id,
        record.head.instrument_serial,
        certificate
            .dated(Language::En)
            .unwrap_or_else(|| "day not known".to_owned())
    );
    let sensor = [labels.dut_model.as_str(), labels.dut_serial.as_str()].join(" ");
    let sensor = sensor.trim();
    let _ = writeln!(
        text,
        "sensor {}",
        if sensor.is_empty() {
            "not stated"
        } else {
            sensor
        }
    );
    if !record.complete {
        text += "stopped before its end\n";
    }
    text
}

/// Deviation from the sensitivity at the reference point, in percent.
fn response(certificate: &Certificate, unit: SensitivityUnit, width: usize) -> String {
    let Some((point, reference)) = certificate.reference_result() else {
        return "no point passed: there is nothing to draw\n".to_owned();
    };
    let deviation = |point| deviation(point, reference.sensitivity);
    let deviations = certificate.points.iter().filter_map(deviation).collect();
    let caption = "deviation from it in %, bars are U";
    let plot = Plot::spanning(caption, Scale::Logarithmic, "Hz", deviations);
    format!(
        "S({} Hz) = {:.5} {}, U = {:.2} % (k = {:.2})\n\n{}",
        point.nominal_frequency_hz,
        unit.of_si(reference.sensitivity),
        unit.name(),
        reference.expanded_uncertainty_percent,
        reference.coverage_factor,
        plot.terminal(width, ROWS)
    )
}

fn deviation(point: &Point, of_reference: f64) -> Option<calib_plot::Point> {
    let values = point.outcome.as_ref().ok()?;
    let relative = values.sensitivity / of_reference;
    let percent = 100.0 * (relative - 1.0);
    let half_bar = values.expanded_uncertainty_percent * relative;
    Some(calib_plot::Point::new(point.nominal_frequency_hz, percent).with_bar(half_bar))
}

/// True when the certificate's point was made of this result.
fn is(point: &Point, measured: &PointResult) -> bool {
    let same = |a: f64, b: f32| (a / f64::from(b) - 1.0).abs() < 1e-5;
    same(point.nominal_frequency_hz, measured.spec.frequency_hz)
        && same(
            point.nominal_acceleration_ms2,
            measured.spec.acceleration_rms_ms2,
        )
}

fn line(
    certificate: &Certificate,
    point: &Point,
    measured: Option<&PointResult>,
    unit: SensitivityUnit,
) -> String {
    let frequency = point.nominal_frequency_hz;
    let verdict = match certificate.conformity_of(point) {
        Stated::NotSpecified | Stated::NotJudgeable if point.outcome.is_err() => {
            measured.map_or_else(String::new, |m| m.verdict.to_string())
        }
        Stated::NotSpecified => "valid".to_owned(),
        judged => code(&judged).replace('_', " "),
    };
    match &point.outcome {
        Ok(values) => format!(
            "{frequency:>7}  {:>9.3}  {:>13.5}  {:>5.2}  {:>11.3}  {verdict}\n",
            point.acceleration_ms2,
            unit.of_si(values.sensitivity),
            values.expanded_uncertainty_percent,
            phase_deg(values),
        ),
        Err(_) => format!("{frequency:>7}  {verdict}\n"),
    }
}

/// No "-0.000".
fn phase_deg(values: &PointValues) -> f64 {
    match values.phase_deg.abs() < 0.000_5 {
        true => 0.0,
        false => values.phase_deg,
    }
}
