//! Linear responses of all effects together.

use super::chain::Transfer;
use super::effect::Active;
use super::row::Row;

/// Responses at the frequency of a row and at its orders.
#[derive(Clone, Copy)]
pub(super) struct Transfers<'a> {
    pub(super) row: &'a Row,
    effects: &'a [Active<'a>],
    /// At the frequency of the row.
    pub(super) first: Transfer,
}

impl<'a> Transfers<'a> {
    pub(super) fn new(row: &'a Row, effects: &'a [Active<'a>]) -> Self {
        Self {
            row,
            effects,
            first: at(row, effects, row.frequency_hz),
        }
    }

    /// At a multiple of the frequency of the row.
    pub(super) fn at_order(&self, n: usize) -> Transfer {
        at(self.row, self.effects, self.row.frequency_hz * n as f64)
    }
}

fn at(row: &Row, effects: &[Active<'_>], frequency_hz: f64) -> Transfer {
    let mut transfer = Transfer::default();
    for effect in effects {
        effect.transfer(row, frequency_hz, &mut transfer);
    }
    transfer
}
