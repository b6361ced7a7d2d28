//! The clock of this computer.

/// Seconds since 1970-01-01 UTC; 0 where the clock is before that.
pub fn unix_time_s() -> u64 {
    u64::try_from(jiff::Timestamp::now().as_second()).unwrap_or(0)
}
