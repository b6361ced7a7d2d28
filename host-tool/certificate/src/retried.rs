//! Records that measured again what had no result in another: one calibration, as it was completed.
//!
//! Points that have a result stay as they are; those that were refused or never tried are taken from where they have one.
//! Each point says by its record where it is from. U and conformity are those of all: the change that any of the runs saw from
//! its first point to the repetition of it counts for every point, and the temperature that is farthest from 23 degrees
//! Celsius.

use super::model::{Certificate, Entry, Value};
use super::stored::run_day;
use calib_core::closing::Closing;
use calib_core::point::{PointResult, PointSpec};
use calib_core::point_state::PointState;
use calib_files::{Error, Result};
use calib_output::number::decimal;
use calib_protocol::record::Record;

/// Room temperature, hundredths of a degree Celsius.
const ROOM_CENTI_C: i16 = 2300;

/// The record with what others measured again; the record itself where there are none.
///
/// # Errors
/// [`Error::Input`] when they are not of one device, instrument and settings, or measured nothing that was missing.
pub fn complete(record: &Record, retried: &[Record]) -> Result<Record> {
    let mut whole = record.clone();
    for later in retried {
        belongs(record, later)?;
        let taken = valid(later).filter(|point| take(&mut whole, point)).count();
        if taken == 0 {
            return Err(refused(
                record,
                later,
                "has a result for no point that has none",
            ));
        }
        whole.closing = worse(whole.closing, later.closing);
        let labels = (&mut whole.head.labels, &later.head.labels);
        let temperatures = (labels.0.temperature_centi_c, labels.1.temperature_centi_c);
        labels.0.temperature_centi_c = farther(temperatures);
    }
    whole.complete |= whole.untried.is_empty() && !retried.is_empty();
    Ok(whole)
}

/// Longest time from a record to what completes it, s: the work of a day.
const SAME_DAY_S: u64 = 86_400;

/// Whether a later record measured nothing but points that have no result in this one, within a day.
pub fn completes(record: &Record, later: &Record) -> bool {
    let mut points = later.points.iter().map(|point| point.spec);
    let times = [record, later].map(|record| record.head.labels.unix_time_s);
    let soon = times[0] > 0 && times[0] <= times[1] && times[1] - times[0] <= SAME_DAY_S;
    belongs(record, later).is_ok()
        && soon
        && later.untried.is_empty()
        && points.len() > 0
        && points.all(|spec| without_result(record).any(|left| left == spec))
}

/// Points of a record that have no result: refused, or never tried.
pub fn without_result(record: &Record) -> impl Iterator<Item = PointSpec> {
    let refused = record
        .points
        .iter()
        .filter(|p| p.state != PointState::Valid);
    let refused = refused.map(|point| point.spec);
    refused.chain(record.untried.iter().copied())
}

/// Says which points are from which record.
pub(super) fn state(certificate: &mut Certificate, retried: &[Record]) {
    let stated: Vec<Value> = retried.iter().map(of_record).collect();
    let mut sections = certificate.sections.iter_mut();
    let section = sections.find(|section| section.key == "calibration");
    if let (Some(section), false) = (section, stated.is_empty()) {
        section.entries.push(Entry {
            key: "retried",
            clause: "",
            value: Some(Value::List(stated)),
        });
    }
}

fn of_record(record: &Record) -> Value {
    let day = run_day(record).map_or(Value::Text("\u{2013}".to_owned()), Value::Day);
    let hz = |point: &PointResult| Value::Exact(decimal(point.spec.frequency_hz), "Hz");
    let points = valid(record).map(hz).collect();
    let id = Value::Text(record.head.id.to_string());
    Value::Phrase(
        "retried.value".to_owned(),
        vec![id, day, Value::List(points)],
    )
}

fn valid(record: &Record) -> impl Iterator<Item = &PointResult> {
    record
        .points
        .iter()
        .filter(|p| p.state == PointState::Valid)
}

/// Puts a result in the place of a point without; false where there is none.
fn take(whole: &mut Record, point: &PointResult) -> bool {
    let mut points = whole.points.iter_mut();
    let refused = points.find(|p| p.spec == point.spec && p.state != PointState::Valid);
    if let Some(refused) = refused {
        *refused = *point;
        return true;
    }
    let untried = whole.untried.iter().position(|spec| *spec == point.spec);
    // A record has room for all of its list.
    let taken = untried.is_some() && whole.points.push(*point).is_ok();
    if let Some(at) = untried.filter(|_| taken) {
        whole.untried.remove(at);
    }
    taken
}

fn worse(one: Closing, other: Closing) -> Closing {
    match (one, other) {
        (Closing::Refused(_), _) | (_, Closing::None) => one,
        (_, Closing::Refused(_)) | (Closing::None, _) => other,
        (Closing::Changed(first), Closing::Changed(second)) => {
            match first.magnitude_rel.abs() < second.magnitude_rel.abs() {
                true => other,
                false => one,
            }
        }
    }
}

/// The farther of two temperatures; one that was not told is not known of both.
fn farther(temperatures: (Option<i16>, Option<i16>)) -> Option<i16> {
    let (one, other) = (temperatures.0?, temperatures.1?);
    let distance = |centi_c: i16| centi_c.abs_diff(ROOM_CENTI_C);
    Some(if distance(one) < distance(other) {
        other
    } else {
        one
    })
}

fn belongs(record: &Record, later: &Record) -> Result<()> {
    let problem = match () {
        () if record.head.instrument_serial != later.head.instrument_serial => {
            "is of another instrument"
        }
        () if record.head.labels.dut_serial != later.head.labels.dut_serial => {
            "is of another device"
        }
        () if record.settings != later.settings => "was measured with other settings",
        () if later.head.id <= record.head.id => "was not measured after it",
        () => return Ok(()),
    };
    Err(refused(record, later, problem))
}

fn refused(record: &Record, later: &Record, problem: &str) -> Error {
    Error::input(
        format!(
            "record {} as completing record {}",
            later.head.id, record.head.id
        ),
        problem,
        "`calib run --retry RECORD` measures what is missing in a record",
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::decision::Stated;
    use crate::{Certificate, Language, Particulars};
    use calib_core::closing::Change;
    use calib_core::point_state::Reason;
    use calib_record::sample::{point, record};

    const HZ: [f32; 3] = [80.0, 160.0, 1000.0];

    /// 80 Hz refused, 1 kHz and 2 kHz never tried; and what measured 80 and 1000 Hz again.
    fn pair() -> (Record, Record) {
        let mut first = record(&HZ);
        first.points[0].state = PointState::Refused(Reason::NotSettled);
        first.points.truncate(2);
        let spec = |hz| point(hz).spec;
        first.untried = [1000.0, 2000.0].map(spec).into_iter().collect();
        first.complete = false;
        let mut later = record(&[80.0, 1000.0]);
        later.head.id += 1;
        (first, later)
    }

    #[test]
    fn what_had_no_result_is_taken_and_the_rest_stays() {
        let (first, mut later) = pair();
        // A result that is there already is not replaced.
        let mut other = point(160.0);
        other.sensitivity_v_per_ms2 *= 2.0;
        later.points.push(other).expect("room");
        let whole = complete(&first, std::slice::from_ref(&later)).expect("one calibration");
        let of = |hz: f32| whole.points.iter().find(|p| p.spec.frequency_hz == hz);
        assert_eq!(of(80.0), Some(&later.points[0]));
        assert_eq!(of(160.0), Some(&first.points[1]));
        assert_eq!(of(1000.0), Some(&later.points[1]));
        assert_eq!(whole.untried[..], [point(2000.0).spec]);
        assert!(!whole.complete, "2 kHz is missing");
        let left: Vec<f32> = without_result(&whole).map(|p| p.frequency_hz).collect();
        assert_eq!(left, [2000.0]);
    }

    /// Before: points that were never tried were no reason against a pass.
    #[test]
    fn a_list_that_ended_early_is_judged_when_it_is_completed() {
        let tolerance = "[decision]\nspecification = 'relative'\ntolerance_percent = 5";
        let particulars: Particulars = toml::from_str(tolerance).expect("TOML");
        let stated = |record: &Record| {
            let certificate = Certificate::from_record(record, &particulars);
            let stated = certificate
                .conformity_statement(Language::En)
                .expect("a tolerance");
            (certificate.stated_conformity(), stated.because)
        };
        let (mut first, later) = pair();
        first.untried.truncate(1);
        let (before, because) = stated(&first);
        assert_eq!(before, Stated::NotJudgeable);
        assert!(because.starts_with("2 of 3 points"), "{because}");
        // Never tried alone keeps it from a statement, too.
        let mut begun = first.clone();
        begun.points[0].state = PointState::Valid;
        assert_eq!(stated(&begun).0, Stated::NotJudgeable);
        let whole = complete(&first, &[later]).expect("one calibration");
        assert_eq!(stated(&whole).0, Stated::Pass);
    }

    #[test]
    fn the_worst_of_both_runs_counts() {
        let (mut first, mut later) = pair();
        let changed = |magnitude_rel| {
            Closing::Changed(Change {
                magnitude_rel,
                phase_rad: 0.0,
                noise_rel: 0.0,
                noise_phase_rad: 0.0,
            })
        };
        (first.closing, later.closing) = (changed(0.01), changed(-0.02));
        first.head.labels.temperature_centi_c = Some(2300);
        later.head.labels.temperature_centi_c = Some(1500);
        let whole = complete(&first, std::slice::from_ref(&later)).expect("one calibration");
        assert_eq!(whole.closing, later.closing);
        assert_eq!(whole.head.labels.temperature_centi_c, Some(1500));
        later.closing = Closing::Refused(Reason::DutOpen);
        later.head.labels.temperature_centi_c = None;
        let whole = complete(&first, std::slice::from_ref(&later)).expect("one calibration");
        assert_eq!(whole.closing, later.closing);
        assert_eq!(whole.head.labels.temperature_centi_c, None);
    }

    #[test]
    fn what_does_not_complete_it_is_refused() {
        let refused = |change: fn(&mut Record), words: &str| {
            let (first, mut later) = pair();
            assert!(completes(&first, &later));
            change(&mut later);
            assert!(!completes(&first, &later), "{words}");
            let error = complete(&first, &[later]).expect_err(words);
            assert!(error.to_string().contains(words), "{error}");
        };
        refused(|r| r.head.instrument_serial.clear(), "another instrument");
        refused(|r| r.head.labels.dut_serial.clear(), "another device");
        refused(|r| r.settings.blocks += 1, "other settings");
        refused(|r| r.head.id = 1, "not measured after it");
        refused(|r| r.points.clear(), "no point that has none");
        let (first, mut later) = pair();
        later.head.labels.unix_time_s += 86_401;
        assert!(
            !completes(&first, &later),
            "next year's calibration is another"
        );
        let (first, mut later) = pair();
        later.points.push(point(160.0)).expect("room");
        assert!(
            !completes(&first, &later),
            "160 Hz has a result: a calibration of its own"
        );
    }
}
