//! The vocabulary of effects and faults: words and ranges, no equations.
//!
//! `twin` says how an entry acts, `gap` how it is explained; each has a test that no entry is left
//! out. They share these words and nothing else, so that the one can judge the other.
//!
//! ```text
//! dut .. environment   effects of a calibrator, a file per stage
//! oscillator           terms of an oscillator beside ISO 16063-43 formula (1)
//! fault                what breaks on site
//! entry, parameter     the fields of an entry
//! ```

mod entry;
mod parameter;

pub mod amplifier;
pub mod conditioning;
pub mod digitiser;
pub mod dut;
pub mod environment;
pub mod exciter;
pub mod fault;
pub mod mount;
pub mod oscillator;
pub mod reference;

pub use entry::{Entry, Of, Stage};
pub use parameter::{Parameter, Scale};

static FILES: [&[&Entry]; 10] = [
    dut::ENTRIES,
    reference::ENTRIES,
    mount::ENTRIES,
    conditioning::ENTRIES,
    digitiser::ENTRIES,
    exciter::ENTRIES,
    amplifier::ENTRIES,
    environment::ENTRIES,
    oscillator::ENTRIES,
    fault::ENTRIES,
];

/// All entries of a kind, stage by stage.
pub fn entries(of: Of) -> impl Iterator<Item = &'static Entry> + Clone {
    let all = FILES.iter().copied().flatten().copied();
    all.filter(move |entry| entry.of == of)
}

/// All effects that a diagnosis can be asked about: of calibrators, then of oscillators.
pub fn effects() -> impl Iterator<Item = &'static Entry> + Clone {
    entries(Of::Calibrator).chain(entries(Of::Oscillator))
}

/// The entry of a kind with a name.
#[must_use]
pub fn named(of: Of, id: &str) -> Option<&'static Entry> {
    entries(of).find(|entry| entry.id == id)
}

/// The first effect with a name: those that calibrators and oscillators share have the same plain
/// words.
#[must_use]
pub fn effect(id: &str) -> Option<&'static Entry> {
    effects().find(|entry| entry.id == id)
}

/// The name of the effect that shares most words with `name`, then the longest beginning; `None`
/// if none shares a word.
#[must_use]
pub fn nearest(name: &str) -> Option<&'static str> {
    let words = |id: &str| name.split('_').filter(|word| id.contains(word)).count();
    let beginning = |id: &str| {
        id.chars()
            .zip(name.chars())
            .take_while(|(a, b)| a == b)
            .count()
    };
    let ids = effects().map(|entry| entry.id);
    let nearest = ids.max_by_key(|id| (words(id), beginning(id)));
    nearest.filter(|id| words(id) > 0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn all() -> impl Iterator<Item = &'static Entry> {
        effects().chain(entries(Of::Fault))
    }

    #[test]
    fn every_name_is_there_once_for_each_kind() {
        for of in [Of::Calibrator, Of::Oscillator, Of::Fault] {
            let mut names: Vec<&str> = entries(of).map(|entry| entry.id).collect();
            let count = names.len();
            names.sort_unstable();
            names.dedup();
            assert_eq!(names.len(), count);
        }
        let known: usize = FILES.iter().map(|file| file.len()).sum();
        assert_eq!(all().count(), known, "an entry of no kind");
    }

    #[test]
    fn usual_values_and_site_sizes_lie_within_what_can_be() {
        for entry in all() {
            for p in entry.parameters {
                let name = format!("{}: {}", entry.id, p.name);
                let [lowest, highest] = p.simulated;
                assert!(lowest < highest && p.lower < p.upper, "{name}");
                assert!((lowest..=highest).contains(&p.usual), "{name}");
                assert!(p.site[0] < p.site[1], "{name}");
                assert!(p.site[0] >= lowest && p.site[1] <= highest, "{name}");
                // A fit multiplies these.
                assert!(p.scale == Scale::Linear || p.lower > 0.0, "{name}");
            }
        }
    }

    #[test]
    fn every_effect_is_described_and_told_from_others_of_its_kind() {
        for entry in effects() {
            let words = [entry.formula, entry.plain, entry.separate_by];
            assert!(words.iter().all(|text| !text.is_empty()), "{}", entry.id);
            assert!(!entry.columns.is_empty(), "{}", entry.id);
            assert!(!entry.confused_with.is_empty(), "{}", entry.id);
            for other in entry.confused_with {
                assert!(*other != entry.id, "{other}");
                assert!(named(entry.of, other).is_some(), "{}: no {other}", entry.id);
            }
        }
    }

    #[test]
    fn sizes_and_the_other_way_fit_the_parameters() {
        for entry in all() {
            assert!((1..=entry.parameters.len()).contains(&entry.sizes));
            if let Some(values) = entry.other_way {
                assert_eq!(values.len(), entry.parameters.len(), "{}", entry.id);
            }
        }
    }

    #[test]
    fn the_nearest_name_shares_words() {
        assert_eq!(nearest("suspension_cubik"), Some("suspension_cubic"));
        assert_eq!(nearest("xyz"), None);
    }
}
