//! Empty budgets with the rows of Tables A.1 to A.4.

use calib_core::budget::Table;
use schemars::JsonSchema;
use serde::Serialize;
use std::fmt::Write;

/// Rows of a table of Annex A, to be filled in.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Template {
    /// Name of the table, `A.1` to `A.4`.
    pub table: &'static str,
    /// `percent` or `deg`.
    pub unit: &'static str,
    /// Rows in the order of the table.
    pub rows: Vec<TemplateRow>,
}

/// A row without a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct TemplateRow {
    /// Number in the table, from 1.
    pub number: usize,
    /// Subject of the row.
    pub label: &'static str,
}

/// The catalogue of a table.
pub fn template(table: Table) -> Template {
    let rows = table.sources().iter().enumerate();
    Template {
        table: table.name(),
        unit: match table {
            Table::A1 | Table::A3 => "percent",
            Table::A2 | Table::A4 => "deg",
        },
        rows: rows
            .map(|(index, &label)| TemplateRow {
                number: index + 1,
                label,
            })
            .collect(),
    }
}

impl Template {
    /// A budget file: every row with the value 0, as half-width of a
    /// rectangular law but for the results of other budgets.
    pub fn to_toml(&self) -> String {
        let mut text = format!(
            "# ISO 16063-21, Table {}. Fill in the values in {}; remove what does not apply.\n\
             measurand = \"Table {}\"\nunit = \"{}\"\n",
            self.table, self.unit, self.table, self.unit
        );
        for row in &self.rows {
            let law = match row.number {
                1 => "distribution = \"normal\"      # or: budget = \"FILE.toml\"\nk = 2",
                _ => "distribution = \"rectangular\"",
            };
            let _ = write!(
                text,
                "\n# row {}\n[[component]]\nlabel = \"{}\"\nvalue = 0\n{law}\n",
                row.number, row.label
            );
        }
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::budget;
    use crate::input::Source;
    use std::path::Path;

    #[test]
    fn a_template_with_one_value_is_a_budget() {
        for (table, rows) in [
            (Table::A1, 18),
            (Table::A2, 17),
            (Table::A3, 11),
            (Table::A4, 11),
        ] {
            let text = template(table)
                .to_toml()
                .replacen("value = 0", "value = 0.5", 1);
            let source = Source::from_text(Path::new("t.toml"), text).expect("text");
            let budget = budget::parse(&source).expect("a budget");
            assert_eq!(budget.components.len(), rows);
            let u = budget::evaluate(&budget).combined_standard_uncertainty;
            assert!((u - 0.25).abs() < 1.0e-12);
        }
    }
}
