//! A record on one screen: the response with U, and the table of its points.

use super::COLUMNS;
use super::conformity_statement::{within, wrapped};
use calib_certificate::decision::Stated;
use calib_certificate::model::{Point, PointValues};
use calib_certificate::{Certificate, Language, SensitivityUnit};
use calib_core::point::PointResult;
use calib_output::code;
use calib_plot::{Plot, Scale};
use calib_protocol::record::Record;
use std::fmt::Write;

/// Width of the column of frequencies, with the space behind it.
const INDENT: usize = 8;
/// Rows of the plot.
const ROWS: usize = 14;

/// The record in words, as a plot and as a table, `width` columns wide, in the quantity and unit of the sensor.
pub fn show(record: &Record, certificate: &Certificate, width: usize) -> String {
    let unit = certificate.kind.unit();
    let mut text = wrapped_lines(&heading(record, certificate), width);
    if let Some(conformity) = certificate.conformity_statement(Language::En) {
        text += &within(&conformity, width);
        text += "\n\n";
    }
    text += &response(certificate, unit, width);
    text.push('\n');
    if let Some(shown) = certificate.resonance.and_then(|shown| shown.in_words()) {
        let _ = writeln!(
            text,
            "{}\n",
            wrapped(&format!("mounted resonance, effective: {shown}"), width)
        );
    }
    let narrow = width < COLUMNS;
    let of_s = format!("S/({})", unit.name());
    let _ = match narrow {
        // The line above has the unit.
        true => writeln!(text, "{:>7} {:>10} {:>5} state", "f/Hz", "S", "U/%"),
        false => writeln!(
            text,
            "   f/Hz   a/(m/s2)  {of_s:>13}    U/%    phase/deg  state"
        ),
    };
    for point in &certificate.points {
        let measured = record.points.iter().find(|measured| is(point, measured));
        let state = state(certificate, point, measured);
        text += &match narrow {
            true => narrow_line(point, unit, &state, width),
            false => line(point, unit, &state),
        };
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
    let result = format!(
        "S({} Hz) = {:.5} {}, U = {:.2} % (k = {:.2})",
        point.nominal_frequency_hz,
        unit.of_si(reference.sensitivity),
        unit.name(),
        reference.expanded_uncertainty_percent,
        reference.coverage_factor,
    );
    format!(
        "{}\n\n{}",
        wrapped(&result, width),
        plot.terminal(width, ROWS)
    )
}

fn wrapped_lines(text: &str, width: usize) -> String {
    text.lines()
        .map(|line| wrapped(line, width) + "\n")
        .collect()
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

fn state(certificate: &Certificate, point: &Point, measured: Option<&PointResult>) -> String {
    match certificate.conformity_of(point) {
        Stated::NotSpecified | Stated::NotJudgeable if point.outcome.is_err() => {
            measured.map_or_else(String::new, |m| m.state.to_string())
        }
        Stated::NotSpecified => "valid".to_owned(),
        judged => code(&judged).replace('_', " "),
    }
}

/// Level and phase are left out.
fn narrow_line(point: &Point, unit: SensitivityUnit, state: &str, width: usize) -> String {
    let frequency = point.nominal_frequency_hz;
    let text = match &point.outcome {
        Ok(values) => format!(
            "{frequency:>7} {:>10.4} {:>5.2} {state}",
            unit.of_si(values.sensitivity),
            values.expanded_uncertainty_percent,
        ),
        Err(_) => format!("{frequency:>7} {state}"),
    };
    if text.chars().count() <= width {
        return text + "\n";
    }
    // What does not fit goes on below, under what it belongs to.
    let words = wrapped(state, width - INDENT);
    let lines: String = words
        .lines()
        .map(|line| format!("{:INDENT$}{line}\n", ""))
        .collect();
    format!("{}\n{lines}", text.trim_end_matches(state).trim_end())
}

fn line(point: &Point, unit: SensitivityUnit, state: &str) -> String {
    let frequency = point.nominal_frequency_hz;
    match &point.outcome {
        Ok(values) => format!(
            "{frequency:>7}  {:>9.3}  {:>13.5}  {:>5.2}  {:>11.3}  {state}\n",
            point.acceleration_ms2,
            unit.of_si(values.sensitivity),
            values.expanded_uncertainty_percent,
            phase_deg(values),
        ),
        Err(_) => format!("{frequency:>7}  {state}\n"),
    }
}

/// No "-0.000".
fn phase_deg(values: &PointValues) -> f64 {
    match values.phase_deg.abs() < 0.000_5 {
        true => 0.0,
        false => values.phase_deg,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use calib_certificate::{Known, Particulars};
    use calib_core::point_state::{PointState, Reason};
    use calib_record::sample;

    /// A phone held upright, with the longest words there are.
    #[test]
    fn a_record_fits_forty_columns_and_eighty() {
        let mut record = sample::record(&[80.0, 160.0, 10_000.0]);
        record.points[2].state = PointState::Refused(Reason::ChannelsNotAligned);
        let known = Known {
            kind: Some("mV/(mm/s)".parse().expect("a kind")),
            nominal: Some("4 mV/(mm/s)".parse().expect("a sensitivity")),
            tolerance: Some("5,3:reference".parse().expect("a tolerance")),
            ..Known::default()
        };
        let mut particulars = Particulars::default();
        particulars.for_device(&known).expect("complete");
        let certificate = Certificate::from_record(&record, &particulars);
        for width in [40, 80] {
            let shown = show(&record, &certificate, width);
            for line in shown.lines() {
                let columns = line.chars().count();
                assert!(columns <= width, "{columns} of {width}: {line}\n{shown}");
            }
            for said in ["refused", "mV/(mm/s)", "phase/deg"] {
                let left_out = width == 40 && said == "phase/deg";
                assert_eq!(shown.contains(said), !left_out, "{said}:\n{shown}");
            }
        }
    }
}
