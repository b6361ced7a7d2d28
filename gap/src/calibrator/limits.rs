//! Limits of a search.

use crate::effects::library;

/// Limits of a search.
#[derive(Debug, Clone)]
pub(crate) struct Limits {
    /// Entries of the library that may take part.
    pub(crate) allowed: Vec<bool>,
    /// Largest number of effects in a set.
    pub(crate) most_effects: usize,
}

impl Limits {
    /// Only the given names, all of them at a time.
    pub(crate) fn only(names: &[&str]) -> Self {
        let allowed = library()
            .iter()
            .map(|e| names.contains(&e.entry().id))
            .collect();
        Self {
            allowed,
            most_effects: names.len(),
        }
    }

    /// The whole library without the given names.
    pub(crate) fn without(names: &[String], most_effects: usize) -> Self {
        let allowed = library()
            .iter()
            .map(|e| !names.iter().any(|n| n == e.entry().id))
            .collect();
        Self {
            allowed,
            most_effects,
        }
    }
}
