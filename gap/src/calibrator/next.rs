//! Next measurement: what is still open, as something a person on site can do.

use super::lack_of_fit::LackOfFit;
use super::problem::Problem;
use crate::answer::{Cause, OwnNoise, Remainder, Verdict, Where};
use crate::axis::Axis;
use crate::observable::Group;
use crate::summary::three_digits;
use calib_effects::{Of, named};

/// Findings from which a next measurement follows.
pub(super) struct Next<'a> {
    pub(super) causes: &'a [Cause],
    pub(super) left: &'a LackOfFit,
    pub(super) problem: &'a Problem,
    pub(super) remainder: Option<&'a Remainder>,
    pub(super) noise: &'a OwnNoise,
    /// Bumps that are left.
    pub(super) local: &'a [Where],
}

impl Next<'_> {
    /// The measurement that would tell, in words.
    pub(super) fn measurement(&self, verdict: Verdict) -> String {
        match (verdict, self.causes) {
            (Verdict::NoGap, _) => {
                "none needed: repeat the plan after the next change of the rig".into()
            }
            (Verdict::Data, _) => settled_by(self.noise),
            (Verdict::Explained, _) => {
                let first = self.causes.first().map_or("", |c| c.effects[0]);
                to_confirm(first) + &self.so_far()
            }
            (Verdict::Ambiguous, [first, second, ..]) => to_tell(first, second) + &self.so_far(),
            (Verdict::Ambiguous, _) => {
                "repeat the points with the smallest probability of noise in another run".into()
            }
            (Verdict::PartlyExplained, [first, ..]) => self.beside(first),
            (Verdict::PartlyExplained | Verdict::Unexplained, _) => {
                sweep(self.local).unwrap_or_else(|| self.more_points())
            }
        }
    }

    /// Measurement for the remainder beside a cause.
    fn beside(&self, first: &Cause) -> String {
        let name = first.effects.join("+");
        if !self.noise.memory.is_empty() {
            return format!("to be sure of {name}: {}", settled_by(self.noise));
        }
        if let Some(sweep) = sweep(self.local) {
            return format!("for what {name} leaves: {sweep}");
        }
        let Some(left) = self.remainder else {
            return to_confirm(first.effects[0]) + &self.so_far();
        };
        format!(
            "for what {name} leaves: {} between {} and {}, {}",
            left.observable,
            three_digits(left.from),
            three_digits(left.to),
            way(left.axis)
        )
    }

    /// Range measured so far, to which "higher" and "lower" refer.
    fn so_far(&self) -> String {
        let facts = &self.problem.facts;
        let (lowest, highest) = (
            three_digits(facts.lowest_hz),
            three_digits(facts.highest_hz),
        );
        format!(" (so far from {lowest} Hz to {highest} Hz)")
    }

    /// More of what deviates most.
    fn more_points(&self) -> String {
        let outcomes = self.left.outcomes.iter();
        let worst = outcomes.max_by(|a, b| a.z.abs().total_cmp(&b.z.abs()));
        let usual = (Group::Ratio, Axis::Frequency);
        let (group, axis) = worst.map_or(usual, |w| (w.observable.group(), w.axis));
        format!(
            "{} between {} Hz and {} Hz: {}",
            group.name(),
            self.problem.facts.lowest_hz,
            self.problem.facts.highest_hz,
            way(axis)
        )
    }
}

/// How to see along which condition something varies.
fn way(axis: Axis) -> &'static str {
    match axis {
        Axis::Frequency => "twice as many frequencies, up once and down once, mounted anew between",
        Axis::Level | Axis::InverseLevel => {
            "the same frequencies at a third and at three times the level"
        }
        Axis::Travel => "the lowest frequencies at half and at full travel",
        Axis::Time => "the same few points at once after switching on, and again two hours later",
        Axis::Payload => "the same points with no payload and with the heaviest one",
        Axis::Temperature => "the same points with the room 10 K colder or warmer",
        Axis::Rotation => "the same points with the device turned by 45 degrees at a time",
        Axis::CoilVoltage => "the same points at half the drive, and with another amplifier",
        Axis::Amplitude => "a record of larger amplitude, and one of half the amplitude",
    }
}

/// Measurement that shows the true noise.
fn settled_by(noise: &OwnNoise) -> String {
    let rows: Vec<String> = noise.outlier_rows.iter().map(ToString::to_string).collect();
    if !rows.is_empty() {
        return format!("measure row {} of the table once more", rows.join(", "));
    }
    if !noise.memory.is_empty() {
        return "the same points in another order: what follows the clock is drift, what follows \
                the frequency is the rig"
            .into();
    }
    let worst = noise.factor_on_u.iter();
    let worst = worst.max_by(|a, b| a.1.total_cmp(b.1));
    let (group, factor) = worst.map_or((Group::Ratio, 1.0), |(group, factor)| (*group, *factor));
    format!(
        "ten repetitions of one point without touching the rig: they should scatter by {factor:.1} \
         times what is stated for {group}; state that"
    )
}

/// The measurement that tells an effect from those it is mistaken for.
fn separate_by(id: &str) -> Option<&'static str> {
    named(Of::Calibrator, id).map(|entry| entry.separate_by)
}

/// Measures the part of the first cause that the second lacks.
fn to_tell(first: &Cause, second: &Cause) -> String {
    let mut lacking = first
        .effects
        .iter()
        .filter(|e| !second.effects.contains(*e));
    let differing = lacking.next().unwrap_or(&first.effects[0]);
    format!(
        "to tell {} from {}, measure: {}",
        first.effects.join("+"),
        second.effects.join("+"),
        separate_by(differing).unwrap_or("more points")
    )
}

/// Measurement that would show a cause once more, described without its name.
fn to_confirm(id: &str) -> String {
    let entry = named(Of::Calibrator, id);
    entry.map_or_else(
        || "repeat with another run".into(),
        |entry| {
            format!(
                "to confirm that {} ({id}), measure: {}",
                entry.plain, entry.separate_by
            )
        },
    )
}

/// Measurement that tells where bumps come from.
fn sweep(local: &[Where]) -> Option<String> {
    let range = |place: &Where| match place.from == place.to {
        true => format!("{} Hz", place.from),
        false => format!("{} .. {} Hz", place.from, place.to),
    };
    let ranges: Vec<String> = local.iter().map(range).collect();
    (!ranges.is_empty()).then(|| {
        format!(
            "a finer sweep about {}, once as it is and once mounted anew with another cable and \
             adapter: a bump that moves belongs to the mounting",
            ranges.join(", ")
        )
    })
}
