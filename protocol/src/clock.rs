//! How the time of a run is known that no host began.
//!
//! An instrument has no clock of its own that goes on without supply. Hosts tell it the time when they begin to
//! speak; from then on it counts, until it restarts. A record says when it was told and how far the count may be
//! off; a run that nobody told the time of has none.

use serde::{Deserialize, Serialize};

/// Where the time of a run without a host comes from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct ClockReading {
    /// When a host told the time, seconds since 1970-01-01 UTC by that host's clock; 0: the time of the run is
    /// the host's that began it, or not known.
    pub told_unix_time_s: u64,
    /// How far the count since then may be off, s; what the host's clock was off by comes on top.
    pub uncertainty_s: u32,
}

impl ClockReading {
    /// Nothing was counted.
    pub const NONE: Self = Self {
        told_unix_time_s: 0,
        uncertainty_s: 0,
    };
}
