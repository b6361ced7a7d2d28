//! Why a point was refused, and what to do about it: the one table that the tool, the page and
//! docs/troubleshooting.md share. The names are those of [`Reason`], the words its own.

use calib_certificate::{Language, REASONS};
use calib_core::point::{PointResult, PointSpec};
use calib_core::point_state::{PointState, Reason};
use calib_core::points::possible;
use calib_core::settings::Settings;
use calib_output::code;
use schemars::JsonSchema;
use serde::Serialize;

/// A reason with the points it refused.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Refused {
    /// Code of the reason, in snake case.
    pub reason: String,
    /// The reason in words.
    pub reason_text: String,
    /// Remedy.
    pub remedy: &'static str,
    /// Nominal frequencies of the points, Hz.
    pub frequencies_hz: Vec<f32>,
}

impl Refused {
    fn new(reason: Reason) -> Self {
        Self::in_words_of(Language::En, reason)
    }

    fn in_words_of(language: Language, reason: Reason) -> Self {
        Self {
            reason: code(&reason),
            reason_text: language.word(&format!("reason.{reason:?}")).to_owned(),
            remedy: remedy(reason),
            frequencies_hz: Vec::new(),
        }
    }
}

/// Remedy for a refusal.
pub fn remedy(reason: Reason) -> &'static str {
    match reason {
        Reason::Clipped => {
            "Lower the level, or the gain of the conditioner that clips (the page shows which)."
        }
        Reason::Distortion => {
            "Lower the level; look for a loose mount, a cable that pulls, or an amplifier at its end."
        }
        Reason::SignalToNoise => {
            "Raise the level or the gain; look for hum: cable, ground loop, a machine nearby."
        }
        Reason::AmplitudeUnstable => {
            "Fix the cable and the mount, let the exciter warm up, keep off the table; try again."
        }
        Reason::FrequencyDeviation => {
            "The instrument's clock is off: `calib selftest`, then have it serviced."
        }
        Reason::NotSettled => {
            "Tighten the mount and fix the cable; a payload that is too heavy or loose does not settle."
        }
        Reason::DriveLimit => {
            "Lower the level; check that the amplifier is on, its gain is right and the payload is light enough."
        }
        Reason::AccelerationLimit => {
            "Lower the level, or raise the exciter's limit in the settings if its manual allows it."
        }
        Reason::VelocityLimit => "Lower the level at this frequency, or leave the frequency out.",
        Reason::DisplacementLimit => {
            "Lower the level at this frequency: low frequencies need long strokes."
        }
        Reason::ReferenceDead => {
            "Is the amplifier on, and the reference's cable in? Does the table move? Then try again."
        }
        Reason::DutOpen => {
            "Is the cable in, at both ends? Is the supply (IEPE, 4 mA) on? Is it on the right input? Then try again."
        }
        Reason::Overload => {
            "Look at the exciter before anything else: mount, payload, limits; then try again at a lower level."
        }
        Reason::Overrun => {
            "Try again; if it happens again, `calib selftest` and have the instrument serviced."
        }
        Reason::FrequencyUnavailable => {
            "Choose a frequency that the reference is calibrated for: `calib settings` shows its table."
        }
        Reason::Stopped => {
            "Somebody pressed STOP or the button; start again when the exciter is free."
        }
        Reason::BudgetInvalid => {
            "Correct the influences in the settings: `calib settings` shows them."
        }
        Reason::TooFewAverages => "Let the run end: broadband excitation needs 64 averages.",
        Reason::LowCoherence => {
            "Raise the level, tighten the mount, or measure this point with a single sine."
        }
        Reason::LevelNotFollowing => {
            "Check mount and cable of the reference, and the amplifier; then try again."
        }
        Reason::DutDistortion => {
            "Is it mounted firmly, within its range, and touching nothing? Lower the level."
        }
        Reason::TemperatureOutOfRange => {
            "Bring the instrument to between the temperatures it is made for, and wait."
        }
        Reason::ChannelsNotAligned => {
            "Restart the instrument; if it happens again, have it serviced."
        }
        Reason::Hum => {
            "Move the frequency by 3 Hz or more from the mains and its multiples, raise the level, or find where the hum gets in: cable, ground loop."
        }
        Reason::HostsSilent => {
            "Is the computer asleep, or its cable out? Start again; `lease_s` in the settings says how long it may be silent."
        }
        _ => "Install a newer calib: this one does not know the reason.",
    }
}

/// The whole table, for the page and the docs. The reasons are in the words of certificates of this language;
/// the remedies are English.
pub fn table(language: Language) -> Vec<Refused> {
    let line = |reason| Refused::in_words_of(language, reason);
    REASONS.into_iter().map(line).collect()
}

/// Refusals of a run by reason, in the order they came.
pub fn of(points: &[PointResult]) -> Vec<Refused> {
    let mut found: Vec<(Reason, Refused)> = Vec::new();
    for point in points {
        let PointState::Refused(reason) = point.state else {
            continue;
        };
        let known = found.iter().position(|(known, _)| *known == reason);
        let at = known.unwrap_or_else(|| {
            found.push((reason, Refused::new(reason)));
            found.len() - 1
        });
        found[at].1.frequencies_hz.push(point.spec.frequency_hz);
    }
    found.into_iter().map(|(_, refused)| refused).collect()
}

/// The reason when nothing was measured yet and the device under test gives no signal: all other
/// points would be refused for the same. The point that the stop cut off says nothing of the device.
pub fn dead_from_the_start(points: &[PointResult]) -> Option<Reason> {
    let cut_off = PointState::Refused(Reason::Stopped);
    let mut tried = points
        .iter()
        .map(|point| point.state)
        .filter(|state| *state != cut_off)
        .peekable();
    tried.peek()?;
    tried
        .all(|state| state == PointState::Refused(Reason::DutOpen))
        .then_some(Reason::DutOpen)
}

/// Points of a list that this instrument would refuse without measuring, by reason: no tone, no
/// calibration of the reference there, or beyond a limit of the exciter.
pub fn impossible(list: &[PointSpec], settings: &Settings, sample_rate_hz: f32) -> Vec<Refused> {
    let refused: Vec<PointResult> = list
        .iter()
        .filter_map(|spec| {
            let reason = possible(*spec, settings, sample_rate_hz).err()?;
            Some(PointResult::refused(*spec, None, reason))
        })
        .collect();
    of(&refused)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The firmware ends the point it is at when it is stopped, and the record has it.
    #[test]
    fn a_dead_device_is_told_from_a_stop() {
        let refused =
            |reason| PointResult::refused(calib_record::sample::point(160.0).spec, None, reason);
        let (open, stopped) = (refused(Reason::DutOpen), refused(Reason::Stopped));
        let dead = Some(Reason::DutOpen);
        assert_eq!(dead_from_the_start(&[open]), dead);
        assert_eq!(dead_from_the_start(&[open, stopped]), dead);
        assert_eq!(dead_from_the_start(&[stopped]), None);
        assert_eq!(dead_from_the_start(&[]), None);
        let measured = calib_record::sample::point(160.0);
        assert_eq!(dead_from_the_start(&[measured, open, stopped]), None);
    }

    /// A reason has one name: that of the code, in snake case in JSON and CSV, and without underscores in SCPI. A state
    /// on a sensor has one name in each language.
    #[test]
    fn reasons_and_states_have_words_in_both_languages_and_in_the_docs() {
        let docs = include_str!("../../docs/troubleshooting.md");
        let said_alike = |key: &str| {
            let [english, german] = [Language::En, Language::De].map(|l| l.word(key).to_owned());
            assert!(
                english != key && german != key && english != german,
                "{key}: {english}"
            );
            english
        };
        let not_reportable = said_alike("reason.NotReportable");
        assert_eq!(not_reportable, "no valid number");
        assert!(docs.contains("`not_reportable`") && docs.contains(&not_reportable));
        for reason in REASONS {
            let english = said_alike(&format!("reason.{reason:?}"));
            assert_eq!(english, reason.to_string(), "the core says it otherwise");
        }
        for key in [
            "pass",
            "conditionalPass",
            "conditionalFail",
            "fail",
            "notJudgeable",
        ] {
            let english = said_alike(&format!("conformity.{key}"));
            let row = format!("| {} | ", english.to_uppercase());
            assert!(docs.contains(&row), "docs/troubleshooting.md lacks {row}");
        }
    }

    #[test]
    fn the_table_is_complete_and_the_docs_have_every_line_of_it() {
        // Reasons are numbered without gaps: a new one is not in the table yet.
        let last = *REASONS.last().expect("reasons") as usize;
        assert_eq!(last + 1, REASONS.len());
        let docs = include_str!("../../docs/troubleshooting.md");
        for line in table(Language::En) {
            let row = format!(
                "| `{}` | {} | {} |",
                line.reason, line.reason_text, line.remedy
            );
            assert!(docs.contains(&row), "docs/troubleshooting.md lacks:\n{row}");
            assert!(!line.remedy.contains("newer calib"), "{}", line.reason);
        }
    }
}
