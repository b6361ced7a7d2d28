//! The `[[correlation]]` tables of a budget file.

use crate::budget::{Coefficient, Component, Correlation, first_negative_eigenvalue};
use crate::input::{self, Number, Source};
use calib_files::Result;
use serde::Deserialize;
use toml::{Spanned, Value};

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct CorrelationTable {
    pub(super) a: Spanned<Value>,
    pub(super) b: Spanned<Value>,
    pub(super) r: Number,
}

pub(super) fn correlations(
    source: &Source,
    tables: &[Spanned<CorrelationTable>],
    components: &[Component],
) -> Result<Vec<Correlation>> {
    let mut all: Vec<Correlation> = Vec::new();
    for table in tables {
        let correlation = correlation(source, table.get_ref(), components)?;
        let pair = |other: &Correlation| {
            let (a, b) = (other.a.min(other.b), other.a.max(other.b));
            (a, b)
                == (
                    correlation.a.min(correlation.b),
                    correlation.a.max(correlation.b),
                )
        };
        if all.iter().any(pair) {
            return Err(source.at(
                &table.get_ref().a.span(),
                "this pair of components is correlated twice",
                "keep one [[correlation]] for each pair",
            ));
        }
        all.push(correlation);
    }
    match first_negative_eigenvalue(components.len(), &all) {
        None => Ok(all),
        Some(lowest) => Err(source.at(
            &tables.last().map_or(0..0, |table| table.get_ref().r.span()),
            format!(
                "the correlation matrix is not positive semidefinite: \
                 smallest eigenvalue {lowest:.3}"
            ),
            "no quantities can be correlated like this; reduce the coefficients \
             or correct a sign",
        )),
    }
}

fn correlation(
    source: &Source,
    table: &CorrelationTable,
    components: &[Component],
) -> Result<Correlation> {
    let a = index_of(source, &table.a, components)?;
    let b = index_of(source, &table.b, components)?;
    if a == b {
        return Err(source.at(
            &table.b.span(),
            "a component is correlated with itself",
            "name two different components",
        ));
    }
    if let Value::String(text) = table.r.get_ref()
        && text == "unknown"
    {
        let coefficient = Coefficient::Unknown;
        return Ok(Correlation { a, b, coefficient });
    }
    let r = input::finite(source, "r", &table.r)?;
    if r.abs() > 1.0 {
        return Err(source.at(
            &table.r.span(),
            format!("r = {r} is outside -1 .. 1"),
            "write a correlation coefficient, or \"unknown\" for the bound of D.4",
        ));
    }
    let coefficient = Coefficient::Known(r);
    Ok(Correlation { a, b, coefficient })
}

fn index_of(source: &Source, key: &Spanned<Value>, components: &[Component]) -> Result<usize> {
    let found = match key.get_ref() {
        Value::String(label) => components
            .iter()
            .position(|component| component.label == label.trim()),
        Value::Integer(number) => usize::try_from(*number)
            .ok()
            .and_then(|number| number.checked_sub(1))
            .filter(|index| *index < components.len()),
        _ => None,
    };
    found.ok_or_else(|| {
        source.at(
            &key.span(),
            format!("no component is called {}", key.get_ref()),
            "write the label of a component, or its number from 1",
        )
    })
}
