//! Slopes taken at an earlier step, or at a smaller set.

use super::column::Column;
use super::evaluation::Evaluation;
use super::problem::Problem;

/// Slopes taken at an earlier step, or at a smaller set: against the nuisances,
/// then perhaps against the parameters of the first effects.
pub(crate) struct Slopes {
    columns: Vec<Column>,
    /// Weights that the columns hold.
    weight: Vec<f64>,
}

impl Slopes {
    /// Slopes with the weights they hold.
    pub(crate) fn new(columns: Vec<Column>, weight: Vec<f64>) -> Self {
        Self { columns, weight }
    }

    /// The slopes of those rows of a problem that are a problem of their own.
    pub(crate) fn of_part(
        &self,
        whole: &Problem,
        part: &Problem,
        keep: &dyn Fn(usize) -> bool,
    ) -> Self {
        let kept = |values: &[f64], from: usize| -> Vec<f64> {
            let data = values.iter().enumerate();
            let inside = data.filter(|(at, _)| keep(whole.row_of[from + at]));
            inside.map(|(_, value)| *value).collect()
        };
        let of_part = |column: &Column| Column {
            parts: column
                .parts
                .iter()
                .map(|(o, values)| (*o, kept(values, whole.data_of(*o).start)))
                .collect(),
        };
        // Without its rows, a run has no gain.
        let at = |kind| whole.free.iter().position(|free| free.kind == kind);
        let nuisances = part.free.iter().filter_map(|free| at(free.kind));
        let columns = nuisances.chain(whole.free.len()..self.columns.len());
        Self {
            columns: columns.map(|at| of_part(&self.columns[at])).collect(),
            weight: kept(&self.weight, 0),
        }
    }

    /// Column of a parameter, with the weights of now.
    pub(super) fn column(
        &self,
        problem: &Problem,
        index: usize,
        here: &Evaluation,
    ) -> Option<Column> {
        let mut column = self.columns.get(index)?.clone();
        for (observable, values) in &mut column.parts {
            let range = problem.data_of(*observable);
            let (now, then) = (&here.weight[range.clone()], &self.weight[range]);
            for ((value, now), then) in values.iter_mut().zip(now).zip(then) {
                *value *= now / then;
            }
        }
        Some(column)
    }
}
