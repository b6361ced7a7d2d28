//! An effect with values for its parameters, and how it is written.

use std::fmt;
use std::str::FromStr;

use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::effect::{CalibratorAction, Effect, Library};
use crate::model::{Conditions, Model};

/// An effect at work.
#[derive(Clone)]
pub struct ActiveEffect<A: 'static = CalibratorAction> {
    pub(super) effect: &'static Effect<A>,
    pub(super) values: Vec<f64>,
}

/// Why an effect was not accepted.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum EffectError {
    /// No effect has that name.
    #[error("no effect is called {name}; the library has: {known}")]
    Unknown {
        /// The name given.
        name: String,
        /// All names.
        known: String,
    },
    /// The effect has no such parameter.
    #[error("{effect} has no parameter {parameter}; it has: {known}")]
    UnknownParameter {
        /// Name of the effect.
        effect: &'static str,
        /// The name given.
        parameter: String,
        /// All names.
        known: String,
    },
    /// Not of the form `NAME=PARAM:VALUE,PARAM:VALUE`.
    #[error("{text} is not understood; write NAME or NAME=PARAM:VALUE,PARAM:VALUE")]
    Malformed {
        /// The part that was not understood.
        text: String,
    },
    /// A value outside of its bounds.
    #[error("{effect}: {parameter} = {value} must be from {lowest} to {highest} {unit}")]
    OutOfBounds {
        /// Name of the effect.
        effect: &'static str,
        /// Name of the parameter.
        parameter: &'static str,
        /// The value given.
        value: f64,
        /// Smallest accepted value.
        lowest: f64,
        /// Largest accepted value.
        highest: f64,
        /// Unit of the parameter.
        unit: &'static str,
    },
}

impl<A: Library> Effect<A> {
    /// The effect with the usual value of each parameter.
    pub fn usual(&'static self) -> ActiveEffect<A> {
        let parameters = self.entry.parameters.iter();
        ActiveEffect::trusted(self, parameters.map(|parameter| parameter.usual).collect())
    }
}

impl<A: Library> ActiveEffect<A> {
    /// `effect` with `values` in the order of its parameters.
    ///
    /// # Errors
    /// [`EffectError::OutOfBounds`] for a value outside of its bounds, a missing one (NaN) included.
    pub fn new(effect: &'static Effect<A>, values: &[f64]) -> Result<Self, EffectError> {
        let given = values.iter().copied().chain(std::iter::repeat(f64::NAN));
        let mut accepted = Vec::with_capacity(effect.entry.parameters.len());
        for (parameter, value) in effect.entry.parameters.iter().zip(given) {
            let [lowest, highest] = parameter.simulated;
            if !(lowest..=highest).contains(&value) {
                return Err(EffectError::OutOfBounds {
                    effect: effect.entry.id,
                    parameter: parameter.name,
                    value,
                    lowest,
                    highest,
                    unit: parameter.unit,
                });
            }
            accepted.push(value);
        }
        Ok(Self::trusted(effect, accepted))
    }

    fn trusted(effect: &'static Effect<A>, values: Vec<f64>) -> Self {
        Self { effect, values }
    }

    /// The effect of the library.
    pub fn effect(&self) -> &'static Effect<A> {
        self.effect
    }

    /// Values in the order of the effect's parameters.
    pub fn values(&self) -> &[f64] {
        &self.values
    }
}

impl ActiveEffect<CalibratorAction> {
    /// Changes `model` as the effect does under `conditions`.
    pub fn apply(&self, conditions: &Conditions, model: &mut Model) {
        (self.effect.apply)(&self.values, conditions, model);
    }
}

impl<A> PartialEq for ActiveEffect<A> {
    fn eq(&self, other: &Self) -> bool {
        self.effect.entry.id == other.effect.entry.id && self.values == other.values
    }
}

/// As its text.
impl<A> Serialize for ActiveEffect<A> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl<'de, A: Library> Deserialize<'de> for ActiveEffect<A> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        text.parse().map_err(serde::de::Error::custom)
    }
}

impl<A> fmt::Debug for ActiveEffect<A> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, formatter)
    }
}

impl<A> fmt::Display for ActiveEffect<A> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.effect.entry.id)?;
        let mut separator = '=';
        for (parameter, value) in self.effect.entry.parameters.iter().zip(&self.values) {
            write!(formatter, "{separator}{}:{value}", parameter.name)?;
            separator = ',';
        }
        Ok(())
    }
}

/// Reads `NAME` or `NAME=PARAM:VALUE,PARAM:VALUE`; parameters not given have their usual value.
impl<A: Library> FromStr for ActiveEffect<A> {
    type Err = EffectError;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let (name, list) = text.split_once('=').unwrap_or((text, ""));
        let effect = Effect::<A>::named(name.trim()).ok_or_else(|| EffectError::Unknown {
            name: name.trim().to_owned(),
            known: names::<A>().join(", "),
        })?;
        let mut active = effect.usual();
        for part in list.split(',').filter(|part| !part.trim().is_empty()) {
            let (index, value) = assignment(effect, part)?;
            active.values[index] = value;
        }
        Self::new(effect, &active.values)
    }
}

/// Names of all effects of a library.
fn names<A: Library>() -> Vec<&'static str> {
    Effect::<A>::all().map(|effect| effect.entry.id).collect()
}

/// Index and value of one `PARAM:VALUE`.
fn assignment<A>(effect: &'static Effect<A>, part: &str) -> Result<(usize, f64), EffectError> {
    let malformed = || EffectError::Malformed {
        text: part.to_owned(),
    };
    let (name, value) = part.split_once(':').ok_or_else(malformed)?;
    let value: f64 = value.trim().parse().map_err(|_| malformed())?;
    let names = effect
        .entry
        .parameters
        .iter()
        .map(|parameter| parameter.name);
    let index = names.clone().position(|known| known == name.trim());
    let index = index.ok_or_else(|| EffectError::UnknownParameter {
        effect: effect.entry.id,
        parameter: name.trim().to_owned(),
        known: names.collect::<Vec<_>>().join(", "),
    })?;
    Ok((index, value))
}

#[cfg(test)]
mod tests {
    use super::super::oscillator::OscillatorAction;
    use super::*;

    fn hold_for<A: Library>() {
        let names = names::<A>();
        let mut unique = names.clone();
        unique.sort_unstable();
        unique.dedup();
        assert_eq!(unique, names, "sorted, each once");
        let mut entries: Vec<&str> = calib_effects::entries(A::OF).map(|e| e.id).collect();
        entries.sort_unstable();
        assert_eq!(
            names, entries,
            "every entry of the vocabulary acts, and nothing else"
        );
        for effect in Effect::<A>::all() {
            let text = effect.usual().to_string();
            let read: ActiveEffect<A> = text.parse().expect("own text");
            assert_eq!(read.to_string(), text);
            assert!(
                ActiveEffect::new(effect, effect.usual().values()).is_ok(),
                "{text}"
            );
        }
    }

    #[test]
    fn every_entry_acts_and_is_read_back_with_usual_values_in_bounds() {
        hold_for::<CalibratorAction>();
        hold_for::<OscillatorAction>();
        hold_for::<super::super::fault::FaultAction>();
    }

    #[test]
    fn a_wrong_text_is_told_what_would_be_right() {
        for (text, hint) in [
            ("suspension_cubik", "suspension_cubic"),
            ("suspension_cubic=k3:1", "k3_n_per_m3"),
            ("suspension_cubic=k3_n_per_m3", "PARAM:VALUE"),
            ("suspension_cubic=k3_n_per_m3:lots", "PARAM:VALUE"),
            ("suspension_cubic=k3_n_per_m3:1e99", "100000000000000"),
            ("suspension_cubic=k3_n_per_m3:nan", "must be from"),
            ("", "dut_resonance"),
        ] {
            let message = text.parse::<ActiveEffect>().expect_err(text).to_string();
            assert!(message.contains(hint), "{text}: {message}");
        }
    }
}
