//! Differences between what was frozen and what is.

use super::Frozen;
use serde_json::Value;
use std::fmt;

/// Most that a probability may move.
const PROBABILITY: f64 = 1e-6;
/// Most that a value may move, relative to itself.
const VALUE_REL: f64 = 1e-9;
/// Differences printed in full.
const SHOWN: usize = 60;

/// Differences found, each with its place.
#[derive(Default)]
pub(super) struct Differences(Vec<String>);

impl Differences {
    /// Adds the differences between two sets of answers; without a baseline there are none. Measured sets, which
    /// another computer may not have, may be missing.
    pub(super) fn compare(&mut self, before: &Frozen, now: &Frozen) {
        for (name, now) in now {
            match before.get(name) {
                Some(before) => self.values(name, before, now),
                None if before.is_empty() => {}
                None => self.0.push(format!("{name}: new")),
            }
        }
        let missing = before.keys().filter(|name| !now.contains_key(*name));
        let missing = missing.filter(|name| !name.starts_with("measured-"));
        self.0
            .extend(missing.map(|name| format!("{name}: missing")));
    }

    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Their number, and of how many sets.
    pub(super) fn count(&self) -> String {
        let set = |line: &String| line.split([' ', ':']).next().map(ToOwned::to_owned);
        let mut sets: Vec<String> = self.0.iter().filter_map(set).collect();
        sets.dedup();
        format!("{} differences in {} sets", self.0.len(), sets.len())
    }

    fn values(&mut self, place: &str, before: &Value, now: &Value) {
        match (before, now) {
            (Value::Object(a), Value::Object(b)) if a.keys().eq(b.keys()) => {
                for (key, before) in a {
                    self.values(&format!("{place} {key}"), before, &b[key]);
                }
            }
            (Value::Array(a), Value::Array(b)) if a.len() == b.len() => {
                for (at, (before, now)) in a.iter().zip(b).enumerate() {
                    self.values(&format!("{place} {at}"), before, now);
                }
            }
            (Value::Number(a), Value::Number(b)) => {
                let pair = [a, b].map(|n| n.as_f64().unwrap_or(f64::NAN));
                if !same(place, pair) {
                    self.0
                        .push(format!("{place}: {:e} was {:e}", pair[1], pair[0]));
                }
            }
            _ if before != now => self.0.push(format!("{place}: {now} was {before}")),
            _ => {}
        }
    }
}

/// Probabilities by their difference, all else by its ratio.
fn same(place: &str, [before, now]: [f64; 2]) -> bool {
    let probability = ["probability", "p_value", "closed", "stability"];
    let difference = (before - now).abs();
    match probability.iter().any(|word| place.ends_with(word)) {
        true => difference <= PROBABILITY,
        false => difference <= VALUE_REL * before.abs().max(now.abs()),
    }
}

impl fmt::Display for Differences {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for line in self.0.iter().take(SHOWN) {
            writeln!(f, "  {line}")?;
        }
        if self.0.len() > SHOWN {
            writeln!(f, "  ... and {} more", self.0.len() - SHOWN)?;
        }
        writeln!(f, "{}", self.count())
    }
}
