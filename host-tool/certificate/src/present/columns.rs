//! The columns a table over frequency can have.

use crate::decision::Stated;
use crate::kind::{SensitivityUnit, SensorKind};
use crate::model::{Point, PointValues};
use crate::rounding::Rounded;
use crate::words::Language;
use calib_output::measured::{Heading, MEASURED, Measured};
use calib_output::number::decimal;

/// A column of the table over frequency.
pub(crate) struct Column {
    /// Name in templates.
    pub(crate) name: &'static str,
    /// Printed where the layout names no columns.
    pub(super) usual: bool,
    unit: Unit,
    what: What,
}

/// Unit of a column.
enum Unit {
    /// One for all; empty for none.
    Fixed(&'static str),
    /// That of the sensitivity.
    Stated,
    /// The sensitivity per standard acceleration of free fall.
    PerG,
    /// That of the motion, where it is no acceleration.
    Motion,
}

/// Where the cells of a column come from.
enum What {
    /// A result: message key after `column.`, and the cell of a point.
    Result(&'static str, fn(&Point, Language) -> String),
    /// Measured quantities beside the result.
    Measured(&'static Measured, &'static Heading),
}

impl Column {
    /// Heading.
    pub(super) fn heading(&self, language: Language) -> String {
        match &self.what {
            What::Result(key, _) => language.word(&format!("column.{key}")).to_owned(),
            What::Measured(_, heading) => language.one_of(heading.words).to_owned(),
        }
    }

    /// Unit, empty for none; no unit where sensors of this kind have no such column.
    pub(super) fn unit(&self, kind: SensorKind) -> Option<&'static str> {
        match self.unit {
            Unit::Fixed(unit) => Some(unit),
            Unit::Stated => Some(kind.stated_unit().printed()),
            Unit::PerG => kind.per_g_unit().map(SensitivityUnit::printed),
            Unit::Motion => (kind.steps() > 0).then(|| kind.amplitude_unit()),
        }
    }

    /// Cell of a point.
    pub(super) fn cell(&self, point: &Point, language: Language) -> String {
        match &self.what {
            What::Result(_, cell) => cell(point, language),
            What::Measured(one, heading) => (one.of)(&point.measured)
                .map_or(DASH.to_owned(), |v| language.number(v, heading.decimals)),
        }
    }
}

/// Every column there is, in the order of the built-in layout.
pub(crate) fn columns() -> impl Iterator<Item = Column> {
    let measured = MEASURED.iter().filter_map(|one| {
        let heading = one.heading.as_ref()?;
        Some(Column {
            name: heading.name,
            usual: heading.usual,
            unit: Unit::Fixed(heading.unit),
            what: What::Measured(one, heading),
        })
    });
    RESULTS.into_iter().chain(measured).chain(STATES)
}

const RESULTS: [Column; 12] = [
    column("frequency", "frequency", "Hz", |p, l| {
        l.shortest(p.nominal_frequency_hz)
    }),
    column("acceleration", "acceleration", "m/s²", |p, l| {
        l.number(p.acceleration_ms2, 3)
    }),
    of_unit("amplitude", "amplitude", Unit::Motion, |p, l| {
        // As many figures as the acceleration has.
        let digits = 4 - p.amplitude_rms.log10().floor() as i32;
        l.number(p.amplitude_rms, usize::try_from(digits).unwrap_or(0).min(6))
    }),
    of_unit("sensitivity", "sensitivity", Unit::Stated, |p, l| {
        cell(p, |v| Some(value_of(&v.printed, l)))
    }),
    of_unit("sensitivity_per_g", "sensitivity", Unit::PerG, |p, l| {
        cell(p, |v| Some(value_of(&v.printed_per_g?, l)))
    }),
    column("uncertainty", "uncertainty", "%", |p, l| {
        cell(p, |v| {
            Some(l.number(
                v.printed_uncertainty_percent.0,
                v.printed_uncertainty_percent.1,
            ))
        })
    }),
    column("coverage_factor", "coverage_factor", "", |p, l| {
        cell(p, |v| Some(l.number(v.coverage_factor, 2)))
    }),
    column("deviation", "deviation", "%", |p, l| {
        cell(p, |v| {
            let deviation = v.deviation?;
            Some(l.number(deviation.percent, deviation.decimals))
        })
    }),
    column("deviation_db", "deviation", "dB", |p, l| {
        cell(p, |v| {
            let deviation = v.deviation?;
            Some(l.number(deviation.db, deviation.decimals + 1))
        })
    }),
    column(
        "uncertainty_deviation",
        "uncertainty_deviation",
        "%",
        |p, l| {
            cell(p, |v| {
                let deviation = v.deviation?;
                Some(l.number(deviation.uncertainty?.printed_percent, deviation.decimals))
            })
        },
    ),
    column("phase", "phase", "°", |p, l| {
        cell(p, |v| Some(value_of(&v.printed_phase_deg?, l)))
    }),
    column("uncertainty_phase", "uncertainty_phase", "°", |p, l| {
        cell(p, |v| {
            v.printed_phase_deg
                .map(|r| l.number(r.uncertainty, r.decimals))
        })
    }),
];

const STATES: [Column; 2] = [
    column("coherence", "coherence", "", |p, l| {
        observed(p.view.coherence.map(decimal), 4, l)
    }),
    column("state", "state", "", state),
];

const fn column(
    name: &'static str,
    key: &'static str,
    unit: &'static str,
    cell: fn(&Point, Language) -> String,
) -> Column {
    Column {
        name,
        usual: true,
        unit: Unit::Fixed(unit),
        what: What::Result(key, cell),
    }
}

/// A column in a unit of the sensor's kind.
const fn of_unit(
    name: &'static str,
    key: &'static str,
    unit: Unit,
    cell: fn(&Point, Language) -> String,
) -> Column {
    Column {
        name,
        usual: true,
        unit,
        what: What::Result(key, cell),
    }
}

/// Printed where there is no number.
pub(super) const DASH: &str = "\u{2013}";

/// A result, or a dash where there is none.
pub(super) fn cell(point: &Point, of: impl Fn(&PointValues) -> Option<String>) -> String {
    let values = point.outcome.as_ref().ok();
    values.and_then(of).unwrap_or_else(|| DASH.to_owned())
}

/// Observed value of a point, or a dash where there is none.
fn observed(value: Option<f64>, decimals: usize, language: Language) -> String {
    value.map_or(DASH.to_owned(), |value| language.number(value, decimals))
}

/// A rounded value without its uncertainty.
pub(super) fn value_of(rounded: &Rounded, language: Language) -> String {
    language.number(rounded.value, rounded.decimals)
}

/// Conformity, or why there is no result.
pub(super) fn state(point: &Point, language: Language) -> String {
    match &point.outcome {
        Ok(values) => match values.assessment {
            Some(judged) => {
                let stated = Stated::from(judged.conformity);
                language.word(stated.message()).to_owned()
            }
            None => language.word("state.valid").to_owned(),
        },
        Err(refusal) => {
            let reason = language.word(&format!("reason.{}", refusal.0)).to_owned();
            format!("{}: {reason}", language.word("state.refused"))
        }
    }
}
