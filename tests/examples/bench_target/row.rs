//! One figure, beside the limit physics or the aim sets.

use serde_json::{Value, json};

/// A figure of the table.
pub(crate) struct Row {
    pub(crate) what: String,
    pub(crate) value: f64,
    pub(crate) unit: &'static str,
    /// Lower limit, or upper limit for a rate.
    pub(crate) limit: Option<f64>,
    /// Reason of the limit, or origin of the figure.
    pub(crate) note: String,
}

impl Row {
    /// A figure without a limit.
    pub(crate) fn new(what: impl Into<String>, value: f64, unit: &'static str) -> Self {
        Self {
            what: what.into(),
            value,
            unit,
            limit: None,
            note: String::new(),
        }
    }

    /// Adds the limit.
    pub(crate) fn limit(self, limit: f64, note: impl Into<String>) -> Self {
        Self {
            limit: Some(limit),
            note: note.into(),
            ..self
        }
    }

    /// Adds a remark.
    pub(crate) fn note(self, note: impl Into<String>) -> Self {
        Self {
            note: note.into(),
            ..self
        }
    }

    /// Prints all of them as a table.
    pub(crate) fn print(rows: &[Self]) {
        println!("{:<44} {:>12} {:>12}", "", "measured", "limit");
        for row in rows {
            let limit = row.limit.map_or_else(String::new, figure);
            let line = format!(
                "{:<44} {:>12} {limit:>12} {:<14} {}",
                row.what,
                figure(row.value),
                row.unit,
                row.note
            );
            println!("{}", line.trim_end());
        }
    }

    /// All of them for programs.
    pub(crate) fn json(rows: &[Self]) -> Value {
        let rows = rows.iter().map(|row| {
            json!({
                "what": row.what,
                "value": row.value,
                "unit": row.unit,
                "limit": row.limit,
                "note": row.note,
            })
        });
        Value::Array(rows.collect())
    }
}

/// Four digits are enough for any of them.
fn figure(value: f64) -> String {
    let digits = 3 - (value.abs().max(1e-3).log10().floor() as i32);
    format!("{value:.*}", digits.clamp(0, 4) as usize)
}
