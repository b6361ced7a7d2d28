//! The date of a run whose time nobody told: between the records around it, and never a wrong one.

use super::model::{Certificate, Value};
use super::particulars::Around;
use super::present;
use super::stored::unix_day;
use super::words::Language;
use calib_protocol::record::Record;
use jiff::Timestamp;
use jiff::civil::Date;

/// Clocks of two computers may differ by so much, and a run is dated by its begin: 2 minutes.
const CLOCKS_DIFFER_S: u64 = 120;

impl Around {
    /// Two of the times, in the order of the running numbers, of which the second is earlier than the first: a
    /// clock went backwards.
    pub(crate) fn contradiction(&self, record: &Record) -> Option<(u64, u64)> {
        let own = Some(record.head.labels.unix_time_s).filter(|own| *own > 0);
        let slack_s = CLOCKS_DIFFER_S + u64::from(record.clock.uncertainty_s);
        let known = [self.before_unix_time_s, own, self.behind_unix_time_s];
        let known: Vec<u64> = known.into_iter().flatten().collect();
        let mut pairs = known.windows(2).map(|pair| (pair[0], pair[1]));
        pairs.find(|(earlier, later)| later.saturating_add(slack_s) < *earlier)
    }

    /// First and last day a record without a time can be of, as far as they are known; neither where the times
    /// contradict each other.
    fn days(&self, record: &Record) -> (Option<Date>, Option<Date>) {
        if record.head.labels.unix_time_s > 0 || self.contradiction(record).is_some() {
            return (None, None);
        }
        let day = |time: Option<u64>| time.and_then(unix_day);
        (day(self.before_unix_time_s), day(self.behind_unix_time_s))
    }

    /// First and last day, where both are known.
    pub(crate) fn between(&self, record: &Record) -> Option<(Date, Date)> {
        let (first, last) = self.days(record);
        first.zip(last)
    }

    /// The day in words, where a run has none of its own.
    pub(crate) fn value(&self, record: &Record) -> Option<Value> {
        let phrase = |key: &str, days: &[Date]| {
            let days = days.iter().copied().map(Value::Day).collect();
            Some(Value::Phrase(key.to_owned(), days))
        };
        match self.days(record) {
            (Some(first), Some(last)) if first == last => Some(Value::Day(first)),
            (Some(first), Some(last)) => phrase("date.between", &[first, last]),
            (Some(first), None) => phrase("date.not_before", &[first]),
            (None, Some(last)) => phrase("date.not_after", &[last]),
            (None, None) => None,
        }
    }
}

impl Certificate {
    /// The date of the calibration in words, if anything is known of it.
    pub fn dated(&self, language: Language) -> Option<String> {
        let date = self.statement("calibration", "date")?;
        Some(present::value(date, language))
    }
}

/// A time to the minute, UTC.
pub fn minute(unix_time_s: u64) -> String {
    let seconds = i64::try_from(unix_time_s).unwrap_or(i64::MAX);
    let time = Timestamp::from_second(seconds).map(|time| time.strftime("%Y-%m-%d %H:%M UTC"));
    time.map_or_else(|_| unix_time_s.to_string(), |time| time.to_string())
}
