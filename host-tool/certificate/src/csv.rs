//! CSV: one row per point, one heading row, opens in Excel.
//!
//! UTF-8 with byte order mark. English: comma and decimal point; German:
//! semicolon and decimal comma, as Excel expects in that language. Refused
//! points have empty results. Text that Excel would take for a formula is led
//! by an apostrophe.

use super::adjustment::change_percent;
use super::kind::{SensitivityUnit, SensorKind};
use super::model::{Certificate, Point, PointValues};
use super::particulars::Amendment;
use super::rounding::Rounded;
use super::words::Language;
use crate::decision::Assessment;
use calib_files::{Error, Result};
use calib_output::code;
use calib_output::measured::MEASURED;
use calib_output::number::{self, decimal};

/// A heading, and the cell below it; empty where there is nothing to say.
type Column<Name> = (Name, fn(&Row<'_>) -> Option<String>);

/// Columns before what is measured: scripts can rely on these names.
const RESULT: [Column<&str>; 18] = [
    ("certificate", |r| Some(harmless(&r.certificate.number))),
    ("dut_model", |r| r.said("item", "model")),
    ("dut_serial", |r| r.said("item", "serial")),
    ("date", |r| r.said("calibration", "date")),
    ("frequency_hz", |r| r.number(r.point.nominal_frequency_hz)),
    ("actual_frequency_hz", |r| r.number(r.point.frequency_hz)),
    ("acceleration_rms_ms2", |r| {
        r.number(r.point.acceleration_ms2)
    }),
    (MOTION, |r| r.number(r.point.amplitude_rms)),
    ("sensitivity_{unit}", |r| r.rounded(r.values?.printed)),
    ("sensitivity_{per_g}", |r| {
        r.rounded(r.values?.printed_per_g?)
    }),
    ("expanded_uncertainty_percent", |r| r.uncertainty(r.values?)),
    ("coverage_factor", |r| r.fixed(r.values?.coverage_factor, 2)),
    ("deviation_percent", |r| {
        let deviation = r.values?.deviation?;
        r.fixed(deviation.percent, deviation.decimals)
    }),
    ("deviation_db", |r| {
        let deviation = r.values?.deviation?;
        r.fixed(deviation.db, deviation.decimals + 1)
    }),
    ("expanded_uncertainty_deviation_percent", |r| {
        let deviation = r.values?.deviation?;
        r.fixed(deviation.uncertainty?.printed_percent, deviation.decimals)
    }),
    ("coverage_factor_deviation", |r| {
        r.fixed(r.values?.deviation?.uncertainty?.coverage_factor, 2)
    }),
    ("phase_deg", |r| r.rounded(r.values?.printed_phase_deg?)),
    ("expanded_uncertainty_phase_deg", |r| {
        let phase = r.values?.printed_phase_deg?;
        r.fixed(phase.uncertainty, phase.decimals)
    }),
];

/// Columns behind it.
const JUDGEMENT: [Column<&str>; 21] = [
    ("blocks", |r| Some(r.point.view.observed.blocks.to_string())),
    ("state", |r| Some(code(&r.point.view.state))),
    ("reason", |r| r.point.view.reason.clone()),
    ("conformity", |r| {
        Some(code(&r.certificate.conformity_of(r.point)))
    }),
    ("lower_limit_{unit}", |r| {
        r.limit(r.judged()?.tolerance.lower)
    }),
    ("upper_limit_{unit}", |r| {
        r.limit(r.judged()?.tolerance.upper)
    }),
    ("false_accept_percent", |r| {
        r.fixed(100.0 * r.judged()?.false_accept?, 4)
    }),
    ("false_reject_percent", |r| {
        r.fixed(100.0 * r.judged()?.false_reject?, 4)
    }),
    ("as_found_sensitivity_{unit}", |r| {
        r.rounded(r.found?.values()?.printed)
    }),
    ("as_found_expanded_uncertainty_percent", |r| {
        r.uncertainty(r.found?.values()?)
    }),
    ("change_percent", |r| {
        let (_, decimals) = r.found?.values()?.printed_uncertainty_percent;
        r.fixed(change_percent(r.found, r.point)?, decimals)
    }),
    ("coherence", |r| {
        r.fixed(decimal(r.point.view.coherence?), 4)
    }),
    ("overrides", |r| {
        Some(harmless(&r.certificate.overrides().join("; ")))
    }),
    ("marks", |r| {
        let marks: Vec<_> = r.certificate.marks().iter().map(code).collect();
        Some(marks.join(" "))
    }),
    ("record_chain", |r| {
        r.certificate.record_chain.as_ref().map(code)
    }),
    ("replaces", |r| Some(harmless(&r.replaces()?.certificate))),
    ("replaced_because", |r| {
        Some(harmless(&r.replaces()?.reason))
    }),
    ("comparison", |r| r.said("calibration", "substitution")),
    ("linearity", |r| r.said("calibration", "linearity")),
    ("mounted_resonance", |r| r.said("mounting", "resonance")),
    ("resonance_search", |r| {
        r.said("mounting", "resonance_search")
    }),
];

/// Stands for the motion of the sensor with its unit, where it is no acceleration.
const MOTION: &str = "{motion}";

/// The columns there are for a kind, with their headings. Sensors that are no accelerometers have no column per g, and
/// one of their motion beside the acceleration.
fn of_kind(kind: SensorKind, columns: &[Column<&str>]) -> Vec<Column<String>> {
    let own = [
        ("{unit}", Some(kind.stated_unit().slug())),
        ("{per_g}", kind.per_g_unit().map(SensitivityUnit::slug)),
        (MOTION, kind.amplitude_slug()),
    ];
    let named = |(heading, cell): &Column<&str>| {
        let heading = match own.iter().find(|(place, _)| heading.contains(place)) {
            Some((place, own)) => heading.replace(place, (*own)?),
            None => (*heading).to_owned(),
        };
        Some((heading, *cell))
    };
    columns.iter().filter_map(named).collect()
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
    let [before, behind] =
        [&RESULT[..], &JUDGEMENT].map(|columns| of_kind(certificate.kind, columns));
    let measured = MEASURED.iter().map(|one| one.key);
    let headings = before
        .iter()
        .map(|column| column.0.as_str())
        .chain(measured);
    writer
        .write_record(headings.chain(behind.iter().map(|column| column.0.as_str())))
        .map_err(|e| broken(e.to_string()))?;
    for (point, found) in certificate.pairs() {
        let row = Row {
            certificate,
            point,
            values: point.values(),
            found,
            language,
        };
        let cells = |columns: &[Column<String>]| -> Vec<_> {
            columns.iter().map(|(_, cell)| cell(&row)).collect()
        };
        let measured = MEASURED
            .iter()
            .map(|one| row.number((one.of)(&point.measured)?));
        let all = cells(&before)
            .into_iter()
            .chain(measured)
            .chain(cells(&behind));
        writer
            .write_record(all.map(Option::unwrap_or_default))
            .map_err(|e| broken(e.to_string()))?;
    }
    writer.into_inner().map_err(|e| broken(e.to_string()))
}

/// Sources of a row. Results are as printed: paper and file show one number.
struct Row<'a> {
    certificate: &'a Certificate,
    point: &'a Point,
    values: Option<&'a PointValues>,
    /// The point before an adjustment.
    found: Option<&'a Point>,
    language: Language,
}

impl Row<'_> {
    /// A statement in words.
    fn said(&self, section: &str, key: &str) -> Option<String> {
        let value = self.certificate.statement(section, key)?;
        Some(harmless(&super::present::value(value, self.language)))
    }

    fn judged(&self) -> Option<Assessment> {
        self.values?.assessment
    }

    fn replaces(&self) -> Option<&Amendment> {
        self.certificate.particulars.calibration.replaces.as_ref()
    }

    fn number(&self, value: f64) -> Option<String> {
        let finite = value.is_finite();
        finite.then(|| self.language.shortest(value + 0.0))
    }

    /// A limit in the unit of the sensitivity. Limits are products of decimal numbers.
    fn limit(&self, si: f64) -> Option<String> {
        let value = self.certificate.kind.stated_unit().of_si(si);
        let finite = value.is_finite();
        finite.then(|| self.language.shortest(number::shortened(value, 12)))
    }

    fn fixed(&self, value: f64, decimals: usize) -> Option<String> {
        Some(self.language.with_sign(number::fixed(value, decimals)))
    }

    fn rounded(&self, printed: Rounded) -> Option<String> {
        self.fixed(printed.value, printed.decimals)
    }

    fn uncertainty(&self, values: &PointValues) -> Option<String> {
        let (uncertainty, decimals) = values.printed_uncertainty_percent;
        self.fixed(uncertainty, decimals)
    }
}

/// Keeps a spreadsheet from running what an operator typed.
fn harmless(text: &str) -> String {
    if text.starts_with(['=', '+', '-', '@', '\t', '\r']) {
        format!("'{text}")
    } else {
        text.to_owned()
    }
}
