//! Limits of a search.

use crate::effects::library;
use crate::options::Options;

/// Effects at a time that are tried where fewer leave structure.
const MOST: usize = 4;
/// Data for each of them: with fewer three effects describe any table.
const DATA_PER_EFFECT: usize = 20;
/// Data for each of two, which have two values each: with fewer they pass through all points.
const FEWEST_PER_EFFECT: usize = 6;

/// Limits of a search.
#[derive(Debug, Clone)]
pub(crate) struct Limits {
    /// Entries of the library that may take part.
    pub(crate) allowed: Vec<bool>,
    /// Largest number of effects in a set, whatever they leave.
    pub(crate) most_effects: usize,
    /// Whether somebody stated that number.
    pub(crate) is_stated: bool,
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
            is_stated: true,
            where_structure_is_left: names.len(),
        }
    }

    /// Largest number of effects that so many data can tell apart, if fewer leave structure.
    pub(crate) fn most_of(&self, data: usize) -> usize {
        if self.is_stated {
            return self.most_effects;
        }
        let usual = self.most_effects.min((data / FEWEST_PER_EFFECT).max(1));
        usual.max(self.where_structure_is_left.min(data / DATA_PER_EFFECT))
    }

    /// Those of a diagnosis.
    pub(crate) fn of(options: &Options) -> Self {
        let withheld = |name: &str| options.without.iter().any(|n| n == name);
        let allowed = library().iter().map(|e| !withheld(e.entry().id));
        Self {
            allowed: allowed.collect(),
            most_effects: options.usual_effects(),
            is_stated: options.most_effects.is_some(),
            where_structure_is_left: options.most_effects.unwrap_or(MOST),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_short_table_has_no_room_for_a_third_effect() {
        let usual = Limits::of(&Options::default());
        let most = [5, 11, 12, 59, 60, 79, 80, 5000].map(|data| usual.most_of(data));
        assert_eq!(most, [1, 1, 2, 2, 3, 3, 4, 4]);
        // Who asks for a number gets it.
        let stated = Options {
            most_effects: Some(3),
            ..Options::default()
        };
        assert_eq!(Limits::of(&stated).most_of(8), 3);
        assert_eq!(Limits::only(&["back_emf"; 3]).most_of(8), 3);
    }
}
