//! CSV: one row per point, one heading row, opens in Excel.
//!
//! UTF-8 with byte order mark. English: comma and decimal point; German:
//! semicolon and decimal comma, as Excel expects in that language. Refused
//! points have empty results. Text that Excel would take for a formula is led
//! by an apostrophe.

use super::kind::{SensitivityUnit, SensorKind};
use super::measured::MEASURED;
use super::model::{Certificate, Point, PointValues};
use super::words::Language;
use crate::decision::Assessment;
use calib_files::{Error, Result};
use calib_output::code;
use calib_output::number::{self, decimal};

/// Stand in headings for the unit of the sensitivity, and for that per standard acceleration of free fall.
const UNIT: &str = "{unit}";
const PER_G: &str = "{per_g}";
/// Stands for the motion of the sensor with its unit, where it is no acceleration.
const MOTION: &str = "{motion}";

/// Headings of the columns before what is measured.
const RESULT: [&str; 18] = [
    "certificate",
    "dut_model",
    "dut_serial",
    "date",
    "frequency_hz",
    "actual_frequency_hz",
    "acceleration_rms_ms2",
    "{motion}",
    "sensitivity_{unit}",
    "sensitivity_{per_g}",
    "expanded_uncertainty_percent",
    "coverage_factor",
    "deviation_percent",
    "deviation_db",
    "expanded_uncertainty_deviation_percent",
    "coverage_factor_deviation",
    "phase_deg",
    "expanded_uncertainty_phase_deg",
];

/// Headings of the columns behind it.
const JUDGEMENT: [&str; 21] = [
    "blocks",
    "state",
    "reason",
    "conformity",
    "lower_limit_{unit}",
    "upper_limit_{unit}",
    "false_accept_percent",
    "false_reject_percent",
    "as_found_sensitivity_{unit}",
    "as_found_expanded_uncertainty_percent",
    "change_percent",
    "coherence",
    "overrides",
    "marks",
    "record_chain",
    "replaces",
    "replaced_because",
    "comparison",
    "linearity",
    "mounted_resonance",
    "resonance_search",
];

/// Statements in words at the end of every row: section and key.
const IN_WORDS: [(&str, &str); 4] = [
    ("calibration", "substitution"),
    ("calibration", "linearity"),
    ("mounting", "resonance"),
    ("mounting", "resonance_search"),
];

/// Headings of all columns: scripts can rely on these names. Sensors that are no accelerometers have no column per g, and
/// one of their motion beside the acceleration.
fn headings(kind: SensorKind) -> impl Iterator<Item = String> {
    let measured = MEASURED.iter().map(|one| one.key);
    let all = RESULT.into_iter().chain(measured).chain(JUDGEMENT);
    all.filter_map(move |heading| {
        let own = [
            (UNIT, Some(kind.stated_unit().slug())),
            (PER_G, kind.per_g_unit().map(SensitivityUnit::slug)),
            (MOTION, kind.amplitude_slug()),
        ];
        match own.iter().find(|(place, _)| heading.contains(place)) {
            Some((place, own)) => Some(heading.replace(place, (*own)?)),
            None => Some(heading.to_owned()),
        }
    })
}

/// The table as CSV.
///
/// # Errors
/// [`Error::Input`] if the writer fails, which memory does not.
pub(super) fn render(certificate: &Certificate, language: Language) -> Result<Vec<u8>> {
    let delimiter = match language {
        Language::En => b',',
        Language::De => b';',
    };
    let mut writer = ::csv::WriterBuilder::new()
        .delimiter(delimiter)
        .terminator(::csv::Terminator::CRLF)
        .from_writer(vec![0xef, 0xbb, 0xbf]);
    let broken = |error: String| Error::input("CSV", error, "report this as a defect");
    writer
        .write_record(headings(certificate.kind))
        .map_err(|e| broken(e.to_string()))?;
    for (point, found) in certificate.pairs() {
        let mut row = row(certificate, point, language);
        row.extend(as_found(point, found, language));
        let coherence = point.view.coherence;
        row.push(coherence.map_or_else(String::new, |c| fixed(decimal(c), 4, language)));
        row.push(harmless(certificate.overrides().join("; ")));
        row.push(
            certificate
                .marks()
                .iter()
                .map(code)
                .collect::<Vec<_>>()
                .join(" "),
        );
        row.push(
            certificate
                .chain
                .map_or_else(String::new, |chain| super::standing::name(chain).to_owned()),
        );
        row.extend(replaces(certificate));
        row.extend(IN_WORDS.map(|(section, key)| said(certificate, section, key, language)));
        writer
            .write_record(row)
            .map_err(|e| broken(e.to_string()))?;
    }
    writer.into_inner().map_err(|e| broken(e.to_string()))
}

/// A statement in words; nothing where it is missing.
fn said(certificate: &Certificate, section: &str, key: &str, language: Language) -> String {
    let value = certificate.statement(section, key);
    let words = value.map(|value| harmless(super::present::value(value, language)));
    words.unwrap_or_default()
}

fn row(certificate: &Certificate, point: &Point, language: Language) -> Vec<String> {
    let said = |section, key| said(certificate, section, key, language);
    let number = |value: f64| match value.is_finite() {
        true => language.shortest(value + 0.0),
        false => String::new(),
    };
    let mut row = vec![
        harmless(certificate.number.clone()),
        said("item", "model"),
        said("item", "serial"),
        said("calibration", "date"),
        number(point.nominal_frequency_hz),
        number(point.frequency_hz),
        number(point.acceleration_ms2),
    ];
    let motion = certificate.kind.amplitude_slug();
    row.extend(motion.map(|_| number(point.amplitude_rms)));
    match &point.outcome {
        Ok(values) => row.extend(results(values, language)),
        Err(_) => {
            let columns = if certificate.kind.per_g_unit().is_some() {
                10
            } else {
                9
            };
            row.extend(std::iter::repeat_n(String::new(), columns));
        }
    }
    let measured = MEASURED.iter().map(|one| (one.of)(&point.measured));
    row.extend(measured.map(|value| value.map(number).unwrap_or_default()));
    let view = &point.view;
    row.extend([
        view.blocks.to_string(),
        code(&view.state),
        view.reason.clone().unwrap_or_default(),
        code(&certificate.conformity_of(point)),
    ]);
    let judged = point.values().and_then(|values| values.assessment);
    let unit = certificate.kind.stated_unit();
    row.extend(judged.map_or_else(Default::default, |judged| limits(&judged, unit, language)));
    row
}

/// Limits in this unit and risks of a judged point.
fn limits(judged: &Assessment, unit: SensitivityUnit, language: Language) -> [String; 4] {
    // Limits are products of decimal numbers.
    let number = |value: f64| match value.is_finite() {
        true => language.shortest(number::shortened(value, 12)),
        false => String::new(),
    };
    let percent = |probability: Option<f64>| {
        probability
            .map(|p| fixed(100.0 * p, 4, language))
            .unwrap_or_default()
    };
    [
        number(unit.of_si(judged.tolerance.lower)),
        number(unit.of_si(judged.tolerance.upper)),
        percent(judged.false_accept),
        percent(judged.false_reject),
    ]
}

/// Sensitivity and U before an adjustment, and the change since.
fn as_found(left: &Point, found: Option<&Point>, language: Language) -> [String; 3] {
    let Some(values) = found.and_then(Point::values) else {
        return Default::default();
    };
    let fixed = |value: f64, decimals: usize| fixed(value, decimals, language);
    let (uncertainty, decimals) = values.printed_uncertainty_percent;
    let printed = values.printed;
    let change = super::adjustment::change_percent(found, left);
    [
        fixed(printed.value, printed.decimals),
        fixed(uncertainty, decimals),
        change.map(|c| fixed(c, decimals)).unwrap_or_default(),
    ]
}

/// The certificate that this one replaces, and why.
fn replaces(certificate: &Certificate) -> [String; 2] {
    let amended = certificate.particulars.calibration.replaces.as_ref();
    amended.map_or_else(Default::default, |amended| {
        [&amended.certificate, &amended.reason].map(|words| harmless(words.clone()))
    })
}

/// Results as printed: what is on paper and what is in the file is one number.
fn results(values: &PointValues, language: Language) -> Vec<String> {
    let fixed = |value: f64, decimals: usize| fixed(value, decimals, language);
    let (uncertainty, decimals) = values.printed_uncertainty_percent;
    let printed = values.printed;
    let per_g = values.printed_per_g;
    let phase = values.printed_phase_deg;
    let deviation = values.deviation;
    let of_deviation = deviation.and_then(|d| Some((d.uncertainty?, d.decimals)));
    let mut row = vec![fixed(printed.value, printed.decimals)];
    row.extend(per_g.map(|per_g| fixed(per_g.value, per_g.decimals)));
    row.extend([
        fixed(uncertainty, decimals),
        fixed(values.coverage_factor, 2),
        deviation
            .map(|d| fixed(d.percent, d.decimals))
            .unwrap_or_default(),
        deviation
            .map(|d| fixed(d.db, d.decimals + 1))
            .unwrap_or_default(),
        of_deviation
            .map(|(u, decimals)| fixed(u.printed_percent, decimals))
            .unwrap_or_default(),
        of_deviation
            .map(|(u, _)| fixed(u.coverage_factor, 2))
            .unwrap_or_default(),
        phase
            .map(|r| fixed(r.value, r.decimals))
            .unwrap_or_default(),
        phase
            .map(|r| fixed(r.uncertainty, r.decimals))
            .unwrap_or_default(),
    ]);
    row
}

fn fixed(value: f64, decimals: usize, language: Language) -> String {
    language.with_sign(number::fixed(value, decimals))
}

/// Keeps a spreadsheet from running what an operator typed.
fn harmless(text: String) -> String {
    if text.starts_with(['=', '+', '-', '@', '\t', '\r']) {
        format!("'{text}")
    } else {
        text
    }
}
