//! Numbers and days of a record as a person writes them.

use calib_protocol::record::Record;
use jiff::{Timestamp, ToSpan, civil::Date, tz::TimeZone};

/// A day given as days since 1970-01-01; 0 is not stated.
pub fn day(days: u32) -> Option<Date> {
    let epoch = Date::constant(1970, 1, 1);
    (days > 0)
        .then(|| epoch.checked_add(i64::from(days).days()).ok())
        .flatten()
}

/// The UTC day of a run, if the host's clock was known.
pub(super) fn run_day(record: &Record) -> Option<Date> {
    unix_day(record.head.labels.unix_time_s)
}

/// The UTC day of a time; 0 is not known.
pub(super) fn unix_day(unix_time_s: u64) -> Option<Date> {
    let seconds = i64::try_from(unix_time_s).ok().filter(|s| *s > 0)?;
    let time = Timestamp::from_second(seconds).ok()?;
    Some(time.to_zoned(TimeZone::UTC).date())
}
