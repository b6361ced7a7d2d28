//! Limits of a search.

use crate::effects::library;
use crate::options::Options;

/// Effects at a time that are tried where fewer leave structure.
const MOST: usize = 4;

/// Limits of a search.
#[derive(Debug, Clone)]
pub(crate) struct Limits {
    /// Entries of the library that may take part.
    pub(crate) allowed: Vec<bool>,
    /// Largest number of effects in a set, whatever they leave.
    pub(crate) most_effects: usize,
    /// Largest number where fewer leave structure.
    pub(crate) where_structure_is_left: usize,
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
            where_structure_is_left: names.len(),
        }
    }

    /// Those of a diagnosis.
    pub(crate) fn of(options: &Options) -> Self {
        let withheld = |name: &str| options.without.iter().any(|n| n == name);
        let allowed = library().iter().map(|e| !withheld(e.entry().id));
        Self {
            allowed: allowed.collect(),
            most_effects: options.usual_effects(),
            where_structure_is_left: options.most_effects.unwrap_or(MOST),
        }
    }
}
