//! The columns a table over frequency can have.

use crate::model::{Point, PointValues};
use crate::rounding::Rounded;
use crate::words::Language;

/// A column of the table over frequency.
pub(crate) struct Column {
    /// Name in templates.
    pub(crate) name: &'static str,
    /// Message key after `column.`.
    pub(super) key: &'static str,
    /// Unit, empty for none.
    pub(super) unit: &'static str,
    /// Cell of a point.
    pub(super) cell: fn(&Point, Language) -> String,
}

/// Every column there is, in the order of the built-in layout.
pub(crate) const COLUMNS: [Column; 14] = [
    column("frequency", "frequency", "Hz", |p, l| {
        l.shortest(p.nominal_frequency_hz)
    }),
    column("acceleration", "acceleration", "m/s²", |p, l| {
        l.number(p.acceleration_ms2, 3)
    }),
    column("sensitivity", "sensitivity", "mV/(m/s²)", |p, l| {
        cell(p, |v| Some(value_of(&v.printed_mv_per_ms2, l)))
    }),
    column("sensitivity_per_g", "sensitivity", "mV/g", |p, l| {
        cell(p, |v| Some(value_of(&v.printed_mv_per_g, l)))
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
            Some(l.number(v.deviation_percent?, v.printed_uncertainty_percent.1))
        })
    }),
    // One percent is 0.087 dB: one more digit keeps the resolution.
    column("deviation_db", "deviation", "dB", |p, l| {
        cell(p, |v| {
            Some(l.number(v.deviation_db?, v.printed_uncertainty_percent.1 + 1))
        })
    }),
    column("phase", "phase", "°", |p, l| {
        cell(p, |v| Some(value_of(&v.printed_phase_deg?, l)))
    }),
    column("uncertainty_phase", "uncertainty_phase", "°", |p, l| {
        cell(p, |v| {
            v.printed_phase_deg
                .map(|r| l.number(r.uncertainty, r.decimals))
        })
    }),
    column("distortion", "distortion", "%", |p, l| {
        l.number(p.distortion_percent, 2)
    }),
    column("signal_to_noise", "signal_to_noise", "dB", |p, l| {
        l.number(p.signal_to_noise_db, 0)
    }),
    column("coherence", "coherence", "", |p, l| {
        p.coherence.map_or(DASH.to_owned(), |c| l.number(c, 4))
    }),
    column("verdict", "verdict", "", verdict),
];

const fn column(
    name: &'static str,
    key: &'static str,
    unit: &'static str,
    cell: fn(&Point, Language) -> String,
) -> Column {
    Column {
        name,
        key,
        unit,
        cell,
    }
}

/// Printed where there is no number.
pub(super) const DASH: &str = "\u{2013}";

/// A result, or a dash where there is none.
pub(super) fn cell(point: &Point, of: impl Fn(&PointValues) -> Option<String>) -> String {
    let values = point.outcome.as_ref().ok();
    values.and_then(of).unwrap_or_else(|| DASH.to_owned())
}

/// A rounded value without its uncertainty.
pub(super) fn value_of(rounded: &Rounded, language: Language) -> String {
    language.number(rounded.value, rounded.decimals)
}

/// Conformity, or why there is no result.
pub(super) fn verdict(point: &Point, language: Language) -> String {
    match &point.outcome {
        Ok(values) => match values.assessment {
            Some(judged) => language
                .word(&format!("conformity.{}", judged.conformity.name()))
                .to_owned(),
            None => language.word("verdict.pass").to_owned(),
        },
        Err(refusal) => {
            let reason = language.word(&format!("reason.{}", refusal.0)).to_owned();
            format!("{}: {reason}", language.word("verdict.refused"))
        }
    }
}
