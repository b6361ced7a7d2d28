//! The first sentence of an answer: what does it, how much of the gap that is, and what is left.

use crate::answer::{Answer, Cause, OwnNoise, Remainder, Verdict};
use crate::observable::Group;
use crate::thresholds;

/// A number as a person reads it: three significant digits, with an exponent only below 1e-3 and from 1e6 on; a dash
/// where there is none.
pub fn three_digits(value: f64) -> String {
    let size = value.abs();
    match size {
        0.0 => "0".into(),
        _ if !size.is_finite() => "-".into(),
        _ if !(1e-3..1e6).contains(&size) => format!("{value:.2e}"),
        _ => {
            let decimals = (2.0 - size.log10().floor()).clamp(0.0, 6.0) as usize;
            let text = format!("{value:.decimals$}");
            match text.contains('.') {
                true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
                false => text,
            }
        }
    }
}

impl Answer {
    /// With its summary.
    pub(crate) fn summarised(mut self) -> Self {
        let mut sentences = vec![self.first_sentence()];
        sentences.extend(self.remainder.filter(|_| !self.causes.is_empty()).map(left));
        sentences.extend(noise(&self.noise));
        self.summary = sentences.join(" ");
        self
    }

    fn first_sentence(&self) -> String {
        let size = &self.gap.size;
        let closed = size.closed.map(|share| (100.0 * share).max(0.0));
        let share = closed.map_or("the gap".to_owned(), |c| format!("{c:.1} % of the gap"));
        let first = self.causes.first();
        match (self.verdict, first) {
            (Verdict::NoGap, _) => {
                "The simulation describes the data within the stated uncertainties.".into()
            }
            (Verdict::Data, _) => "Nothing is wrong with the rig that these data show.".into(),
            (Verdict::Explained, Some(first)) => format!("{} explains {share}.", described(first)),
            (Verdict::PartlyExplained, Some(first)) => {
                format!("{} explains {share}, not all of it.", described(first))
            }
            (Verdict::Ambiguous, Some(first)) => {
                let others = self.causes.iter().skip(1);
                let others: Vec<String> = others.take(2).map(|c| c.effects.join("+")).collect();
                let or = match others.is_empty() {
                    true => String::new(),
                    false => format!(", and so may {}", others.join(" or ")),
                };
                format!(
                    "{} may explain {share}{or}.{}",
                    described(first),
                    self.in_all()
                )
            }
            (_, Some(first)) if size.closed.is_some_and(|c| c >= thresholds::HALF) => format!(
                "{} closes {share} on rows that took no part, but not at every level and in every band: \
                 no cause in the library explains it.",
                described(first)
            ),
            (_, Some(first)) => format!(
                "No cause in the library explains the gap; the nearest, {}, closes {} of it on rows \
                 that took no part.",
                described(first),
                closed.map_or("none".into(), |c| format!("{c:.1} %"))
            ),
            (_, None) => "No cause in the library explains the gap.".into(),
        }
    }

    /// Effects that all possible causes have in common, and how probable it is with any of them.
    fn in_all(&self) -> String {
        let possible = self.causes.iter();
        let possible: Vec<&Cause> = possible
            .filter(|c| c.probability > thresholds::POSSIBLE_PROBABILITY)
            .collect();
        let [first, _, ..] = possible[..] else {
            return String::new();
        };
        let shared = first.effects.iter();
        let shared = shared.filter(|id| possible.iter().all(|c| c.effects.contains(id)));
        let shared: Vec<&str> = shared.copied().collect();
        match shared.is_empty() {
            true => String::new(),
            false => {
                let together: f64 = possible.iter().map(|c| c.probability).sum();
                format!(
                    " All of them have {}: probability {together:.2} together.",
                    shared.join(" with ")
                )
            }
        }
    }
}

/// Names of a cause, each with the value that says how large it is or where it sits.
fn described(cause: &Cause) -> String {
    let one = |id: &&'static str| {
        let values = cause.parameters.get(id);
        let entry = calib_effects::effect(id);
        let parameter = entry.and_then(|entry| entry.parameters.first());
        let value = parameter.and_then(|p| Some((p, values?.get(p.name)?)));
        value.map_or((*id).to_owned(), |(parameter, estimate)| {
            let value = three_digits(estimate.value);
            // What the data say of a nominal value is known to its stated uncertainty.
            match entry.is_some_and(|entry| entry.of_nominal) {
                true => format!(
                    "{id} (off by {:+.1} u, {value})",
                    estimate.value / estimate.u
                ),
                false => format!("{id} ({} {value})", parameter.name),
            }
        })
    };
    let names: Vec<String> = cause.effects.iter().map(one).collect();
    names.join(" with ")
}

fn left(left: Remainder) -> String {
    format!(
        "What is left, {} % in {} along {} from {} to {}, is not explained.",
        three_digits(100.0 * left.rms_rel),
        left.observable,
        left.axis.name(),
        three_digits(left.from),
        three_digits(left.to)
    )
}

fn noise(noise: &OwnNoise) -> Vec<String> {
    let mut sentences = Vec::new();
    let list = |map: &std::collections::BTreeMap<Group, f64>| {
        let items = map
            .iter()
            .map(|(group, value)| format!("{} in {group}", three_digits(*value)));
        items.collect::<Vec<_>>().join(", ")
    };
    if !noise.factor_on_u.is_empty() {
        let factors = list(&noise.factor_on_u);
        sentences.push(format!(
            "The data scatter by more than is stated, times {factors}."
        ));
    }
    if !noise.memory.is_empty() {
        let memories = list(&noise.memory);
        sentences.push(format!(
            "Rows resemble those before them, by a share of {memories}."
        ));
    }
    if !noise.outlier_rows.is_empty() {
        let rows: Vec<String> = noise.outlier_rows.iter().map(ToString::to_string).collect();
        sentences.push(format!(
            "Nothing describes row {}: misread?",
            rows.join(", ")
        ));
    }
    sentences
}

#[cfg(test)]
mod tests {
    use super::three_digits;

    #[test]
    fn numbers_have_three_digits() {
        let shown =
            [f64::NAN, 0.0, -0.05, 0.3099, 3100.0, 12.345, 1.0002e7, 4e-5].map(three_digits);
        let read = [
            "-", "0", "-0.05", "0.31", "3100", "12.3", "1.00e7", "4.00e-5",
        ];
        assert_eq!(shown, read);
    }
}
