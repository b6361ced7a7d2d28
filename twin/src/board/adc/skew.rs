//! A slave whose data are not of the master's trigger.

use serde::{Deserialize, Serialize};

/// Why, and since when, the slave's half of the common data register is that of the trigger before.
#[derive(Debug, Clone, Copy, Default, Serialize, Deserialize)]
pub(super) struct Skew {
    /// The part has the erratum: see [`Skew::slave`].
    erratum: bool,
    /// Starts of the pair still to come that go wrong, whatever the configuration.
    bad_starts: u32,
    /// The present start is one of those.
    late: bool,
    /// Data of the slave's conversion before.
    before: u16,
}

impl Skew {
    pub(super) fn give_erratum(&mut self) {
        self.erratum = true;
    }

    pub(super) fn spoil_starts(&mut self, starts: u32) {
        self.bad_starts = starts;
    }

    /// The pair is started.
    pub(super) fn started(&mut self) {
        self.late = self.bad_starts > 0;
        self.bad_starts = self.bad_starts.saturating_sub(1);
    }

    /// Value of the slave's half of the register for its conversion's `data`.
    ///
    /// ES0392, "ADC slave data may be shifted in Dual regular simultaneous mode": with one DMA channel
    /// for both and `OVRMOD` = 0, samples of the slave can end up beside those of another trigger.
    /// Secondary sources (rusefi #9597, ArduPilot/ChibiOS #64); the sheet does not say how often, so a
    /// part that has it shows it at once. `weak` is that configuration.
    pub(super) fn slave(&mut self, data: u16, weak: bool) -> u16 {
        let before = std::mem::replace(&mut self.before, data);
        if self.late || (self.erratum && weak) {
            before
        } else {
            data
        }
    }
}
