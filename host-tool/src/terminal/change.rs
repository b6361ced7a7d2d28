//! A change of settings: before and since, those of the reference row by row.

use calib_core::channel_ratio::ChannelRatio;
use calib_core::settings::{ReferenceChannel, ReferencePoint, Settings};
use calib_protocol::change::ReferenceChange;
use jiff::Timestamp;
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

/// The change as text, 80 columns wide.
pub fn show_change(change: &ReferenceChange) -> String {
    let (before, since) = (&change.before, &change.settings.reference_channel());
    let labels = &change.head.labels;
    let mut text = format!(
        "record {} of {}: settings have changed\n{}, {}\n\n",
        change.head.id,
        change.head.instrument_serial,
        time(labels.unix_time_s),
        said(&labels.operator),
    );
    let mut line = |name: &str, of: &dyn Fn(&ReferenceChannel) -> String| {
        let (before, since) = (of(before), of(since));
        let mark = if before == since { "" } else { "*" };
        // Writing into memory does not fail.
        let _ = writeln!(text, "{name:<14}{before:<31}{since:<31}{mark}");
    };
    line("", &|channel| match channel == before {
        true => "before".into(),
        false => "since".into(),
    });
    line("serial", &|channel| said(&channel.calibration.serial));
    line("certificate", &|channel| {
        said(&channel.calibration.certificate)
    });
    line("calibrated", &|channel| {
        day(channel.calibration.calibrated_day)
    });
    line("due", &|channel| day(channel.calibration.due_day));
    line("V per code", &|channel| {
        format!("{:e}", channel.input.volt_per_code)
    });
    line("channels", &|channel| ratio(&channel.ratio));
    if let Some(before) = &change.all_before {
        for line in others(before, &change.settings) {
            text.push_str(&line);
        }
    }
    if !change.concerns_reference() {
        return text;
    }
    text.push_str(
        "\n     Hz  mV/(m/s2)      U %  phase deg  mV/(m/s2)      U %  phase deg  change %\n",
    );
    for (before, since) in pairs(&before.calibration.points, &since.calibration.points) {
        text.push_str(&row(before, since));
    }
    text
}

/// A line for each setting beside the reference's channel that is another one, by its place in the
/// settings file.
fn others(before: &Settings, since: &Settings) -> Vec<String> {
    let (before, since) = (leaves(before), leaves(since));
    let places: BTreeSet<&String> = before.keys().chain(since.keys()).collect();
    let of_reference = ["reference.", "reference_input.", "channel_ratio."];
    let others = places
        .into_iter()
        .filter(|place| !of_reference.iter().any(|part| place.starts_with(part)));
    others
        .filter(|place| before.get(*place) != since.get(*place))
        .map(|place| {
            let said = |all: &BTreeMap<String, String>| all.get(place).cloned();
            let [before, since] =
                [&before, &since].map(|all| said(all).unwrap_or_else(|| "none".into()));
            format!("{place}: {before} -> {since}\n")
        })
        .collect()
}

/// Every number and word of settings, by its place.
fn leaves(settings: &Settings) -> BTreeMap<String, String> {
    let mut found = BTreeMap::new();
    // As text first: numbers of single precision are then written as they were meant.
    let text = serde_json::to_string(settings).unwrap_or_default();
    gather(
        "",
        &serde_json::from_str(&text).unwrap_or_default(),
        &mut found,
    );
    found
}

fn gather(place: &str, value: &Value, found: &mut BTreeMap<String, String>) {
    let below = |name: &str| match place {
        "" => name.to_owned(),
        place => format!("{place}.{name}"),
    };
    match value {
        Value::Object(fields) => fields
            .iter()
            .for_each(|(name, value)| gather(&below(name), value, found)),
        Value::Array(rows) => (1..)
            .zip(rows)
            .for_each(|(row, value)| gather(&below(&row.to_string()), value, found)),
        value => {
            found.insert(place.to_owned(), value.to_string());
        }
    }
}

/// The ratio of the channels in a few words.
fn ratio(ratio: &ChannelRatio) -> String {
    match ratio.points.len() {
        0 => "taken as equal".into(),
        count => format!("ratio of {}, {count} frequencies", day(ratio.measured_day)),
    }
}

/// Rows of both tables side by side, by frequency.
fn pairs<'a>(
    before: &'a [ReferencePoint],
    since: &'a [ReferencePoint],
) -> Vec<(Option<&'a ReferencePoint>, Option<&'a ReferencePoint>)> {
    let mut all: Vec<f32> = before
        .iter()
        .chain(since)
        .map(|row| row.frequency_hz)
        .collect();
    all.sort_by(f32::total_cmp);
    all.dedup();
    let at = |rows: &'a [ReferencePoint], hz: f32| rows.iter().find(|row| row.frequency_hz == hz);
    all.into_iter()
        .map(|hz| (at(before, hz), at(since, hz)))
        .collect()
}

fn row(before: Option<&ReferencePoint>, since: Option<&ReferencePoint>) -> String {
    let frequency_hz = before.or(since).map_or(0.0, |row| row.frequency_hz);
    let change = match (before, since) {
        (Some(before), Some(since)) => {
            let ratio =
                f64::from(since.sensitivity_v_per_ms2) / f64::from(before.sensitivity_v_per_ms2);
            format!("{:+.3}", 100.0 * (ratio - 1.0))
        }
        _ => String::new(),
    };
    format!(
        "{frequency_hz:>7}{}{}{change:>10}\n",
        half(before),
        half(since)
    )
}

fn half(row: Option<&ReferencePoint>) -> String {
    match row {
        None => " ".repeat(31),
        Some(row) => format!(
            "{:>11.5}{:>9.3}{:>11.3}",
            1e3 * row.sensitivity_v_per_ms2,
            100.0 * row.expanded_uncertainty_rel,
            row.phase_rad.to_degrees()
        ),
    }
}

fn said(words: &str) -> String {
    match words.trim() {
        "" => "not stated".to_owned(),
        words => words.to_owned(),
    }
}

fn time(unix_time_s: u64) -> String {
    let known = i64::try_from(unix_time_s)
        .ok()
        .filter(|seconds| *seconds > 0);
    let time = known.and_then(|seconds| Timestamp::from_second(seconds).ok());
    time.map_or("at a time not known".into(), |time| {
        time.strftime("%Y-%m-%d %H:%MZ").to_string()
    })
}

fn day(days_since_1970: u32) -> String {
    calib_certificate::day(days_since_1970).map_or("not stated".to_owned(), |day| day.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;
    use calib_protocol::record::{RecordHead, RunLabels};

    #[test]
    fn both_states_stand_side_by_side_with_what_changed() {
        let before = Settings::field_calibrator();
        let mut settings = before.clone();
        settings.reference.due_day = 20_819; // date -u -d @$((20819*86400)): 2027-01-01
        settings.reference.points[0].sensitivity_v_per_ms2 *= 1.01;
        settings.reference.points.truncate(2);
        let change = ReferenceChange {
            head: RecordHead {
                id: 5,
                instrument_serial: "CAL-1".try_into().expect("short"),
                labels: RunLabels {
                    unix_time_s: 1_795_269_900,
                    ..RunLabels::BLANK
                },
                ..RecordHead::BLANK
            },
            settings,
            before: before.reference_channel(),
            all_before: None,
        };
        let text = show_change(&change);
        assert!(text.starts_with("record 5 of CAL-1: "), "{text}");
        assert!(text.contains("2026-11-21 14:05Z, not stated"), "{text}");
        let due = text.lines().find(|line| line.starts_with("due"));
        let due: Vec<_> = due.expect("a line").split_whitespace().collect();
        assert_eq!(due, ["due", "not", "stated", "2027-01-01", "*"]);
        let rows: Vec<Vec<&str>> = text
            .lines()
            .skip_while(|line| !line.contains("Hz"))
            .skip(1)
            .map(|line| line.split_whitespace().collect())
            .collect();
        assert_eq!(rows.len(), before.reference.points.len());
        // 10.2 mV/(m/s2) and one percent more.
        assert_eq!(rows[0][1], "10.20000");
        assert_eq!(rows[0][4], "10.30200");
        assert_eq!(rows[0][7], "+1.000");
        assert_eq!(rows[1][7], "+0.000");
        // A row that was taken out has nothing since.
        assert_eq!(rows[2].len(), 4);
        assert!(
            text.lines().all(|line| line.chars().count() <= 80),
            "{text}"
        );
    }

    #[test]
    fn settings_beside_the_reference_s_stand_by_their_place() {
        let before = Settings::field_calibrator();
        let mut settings = before.clone();
        settings.limits.acceleration_peak_ms2 = 400.0;
        settings.influences[0].value_rel = 0.0;
        let change = ReferenceChange {
            head: RecordHead::BLANK,
            settings,
            before: before.reference_channel(),
            all_before: Some(before),
        };
        let text = show_change(&change);
        let lines: Vec<&str> = text.lines().filter(|line| line.contains("->")).collect();
        assert_eq!(
            lines,
            [
                "influences.1.value_rel: 0.0025 -> 0.0",
                "limits.acceleration_peak_ms2: 200.0 -> 400.0"
            ]
        );
        assert!(!text.contains("mV/(m/s2)"), "{text}");
    }
}
