//! Until when a reference may be used: its due day, or later where a rule of the laboratory and a check by reciprocity
//! say so (ISO/IEC 17025:2017, 6.4.7 and 7.7.1; ILAC-G24).

use super::particulars::{IntervalRule, Particulars, ReferenceCheck};
use super::stored::day;
use calib_protocol::record::Record;
use jiff::ToSpan;
use jiff::civil::Date;

/// Days a rule may state: beyond, it is no interval.
const LONGEST_DAYS: u32 = 1826;

impl IntervalRule {
    /// Problem of the rule, if any.
    pub(super) fn problem(&self) -> Option<String> {
        let days = [
            ("extend_days", self.extend_days),
            ("checked_within_days", self.checked_within_days),
        ];
        let wrong = days
            .iter()
            .find(|(_, days)| !(1..=LONGEST_DAYS).contains(days));
        if let Some((item, days)) = wrong {
            let range = format!("is not between 1 and {LONGEST_DAYS}");
            return Some(format!("reference_interval.{item}: {days} {range}"));
        }
        let percent = self.largest_change_percent;
        (!(0.01..=10.0).contains(&percent)).then(|| {
            format!(
                "reference_interval.largest_change_percent: {percent} is not between 0.01 and 10"
            )
        })
    }

    /// The check shows on a day that the reference is what it was.
    fn is_met(&self, check: &ReferenceCheck, on: Date) -> bool {
        let age_days = on.since(check.day).map_or(i32::MAX, |age| age.get_days());
        let largest = check.change_rel.abs() + check.expanded_rel;
        // Turned over it shows one value, at d.c., and not that the response is what it was.
        check.since_baseline
            && !check.by_gravity
            && !check.significant
            && 100.0 * largest <= self.largest_change_percent
            && (0..=i64::from(self.checked_within_days)).contains(&i64::from(age_days))
    }
}

/// How the calibration of a reference stands on a day.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum InForce {
    /// Until its due day, or none is stated.
    AsCalibrated,
    /// Beyond its due day by the rule, until this day.
    Extended { due: Date, until: Date },
    /// No longer.
    Overdue { due: Date },
}

/// How the calibration of the record's reference stood on a day.
pub(super) fn in_force(record: &Record, particulars: &Particulars, on: Option<Date>) -> InForce {
    let (Some(due), Some(on)) = (day(record.settings.reference.due_day), on) else {
        return InForce::AsCalibrated;
    };
    if on <= due {
        return InForce::AsCalibrated;
    }
    let stated = particulars.reference_interval;
    let rule = stated.zip(particulars.reference_check);
    let met = rule.filter(|(rule, check)| rule.is_met(check, on));
    let until = met.and_then(|(rule, _)| due.checked_add(i64::from(rule.extend_days).days()).ok());
    match until.filter(|until| on <= *until) {
        Some(until) => InForce::Extended { due, until },
        None => InForce::Overdue { due },
    }
}
