// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! Translations that every core of this process shares.
//!
//! What a block becomes hangs on where it starts, on how it's to be compiled, on the halfwords fetched
//! for it and on the addresses it had to stop before. A core that wants a block another core had
//! translated from the same takes the code over, with its own cells, counter and cache of recent
//! lookups put in. A board that starts a second time, or a second board, then compiles next to nothing.

use std::collections::HashMap;
use std::sync::{Arc, LazyLock, Mutex, PoisonError};

use super::family::Features;
use super::translate::Start;
use crate::emulator::core::{Code, Tier};

/// The number of the core's cache of recent lookups among what a block reads of its core's own.
pub(crate) const RECENT: u32 = 0;
/// The number of the counter a quick translation counts its runs in.
pub(crate) const COUNTER: u32 = 1;
/// The number of the first exit's cell; those after it follow.
pub(crate) const CELLS: u32 = 2;

/// The most translations that are kept: about 120 MB of them.
const MOST: usize = 1 << 17;

/// How a block is to be translated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Wanted {
    pub(crate) start: Start,
    pub(crate) features: Features,
    pub(crate) tier: Tier,
    /// What the keys of the blocks it chains to have beside where those start; `None` where it doesn't
    /// chain.
    pub(crate) space: Option<u64>,
}

impl Wanted {
    /// Whether the block counts its runs.
    pub(crate) fn counts(&self) -> bool {
        self.tier == Tier::Quick && !self.start.checked
    }
}

/// What a translation asked while it was made, with the answers.
pub(crate) struct Asked {
    pub(crate) fetched: Vec<(u32, Option<u16>)>,
    pub(crate) stops: Vec<(u32, bool)>,
}

/// A block translated, for any core that answers what it asked as it was answered.
pub(crate) struct Translation {
    pub(crate) code: Code,
    /// The address and `ITSTATE` each of its exits leads to, in the order of their cells.
    pub(crate) exits: Vec<(u32, u32)>,
    /// The first and last byte it came from.
    pub(crate) range: (u32, u32),
    /// Whether it loops back to its start.
    pub(crate) looped: bool,
    /// The address and `ITSTATE` of every instruction of a checked block.
    pub(crate) steps: Vec<(u32, u32)>,
    pub(crate) asked: Asked,
}

impl Translation {
    fn holds(
        &self,
        fetch: &mut dyn FnMut(u32) -> Option<u16>,
        stop_before: &dyn Fn(u32) -> bool,
    ) -> bool {
        let mut fetched = self.asked.fetched.iter();
        let mut stops = self.asked.stops.iter();
        fetched.all(|&(address, answer)| fetch(address) == answer)
            && stops.all(|&(address, answer)| stop_before(address) == answer)
    }
}

type Kept = HashMap<Wanted, Vec<Arc<Translation>>>;

static SHARED: LazyLock<Mutex<Kept>> = LazyLock::new(Mutex::default);

/// The translation of what's `wanted`, if a core made it from what `fetch` and `stop_before` answer.
pub(crate) fn find(
    wanted: &Wanted,
    fetch: &mut dyn FnMut(u32) -> Option<u16>,
    stop_before: &dyn Fn(u32) -> bool,
) -> Option<Arc<Translation>> {
    let kept = SHARED.lock().unwrap_or_else(PoisonError::into_inner);
    let made = kept.get(wanted)?.iter();
    made.into_iter()
        .find(|made| made.holds(fetch, stop_before))
        .cloned()
}

/// Keeps a translation for [`find`].
pub(crate) fn keep(wanted: Wanted, translation: Arc<Translation>) {
    let mut kept = SHARED.lock().unwrap_or_else(PoisonError::into_inner);
    if kept.len() >= MOST {
        kept.clear();
    }
    kept.entry(wanted).or_default().push(translation);
}

#[cfg(test)]
mod tests {
    use super::super::translate::testing::{Bench, CODE};
    use super::*;

    /// How many translations that begin with `first` at [`CODE`] are kept.
    fn kept_of(first: u16) -> usize {
        let kept = SHARED.lock().unwrap_or_else(PoisonError::into_inner);
        kept.values()
            .flatten()
            .filter(|made| made.asked.fetched.first() == Some(&(CODE, Some(first))))
            .count()
    }

    /// A second core takes over what the first had translated, and not what other halfwords at the
    /// same address became.
    #[test]
    fn a_core_takes_over_what_another_translated_from_the_same_halfwords() {
        // MOVS r0, #imm8, and a branch to itself.
        let r0_after = |first: u16| {
            let mut bench = Bench::new(&[first, 0xE7FE]);
            let _ = bench.run(1);
            bench.core.state.r[0]
        };
        assert_eq!(r0_after(0x20C3), 0xC3);
        let made = kept_of(0x20C3);
        assert!(made > 0);
        assert_eq!(r0_after(0x20C3), 0xC3);
        assert_eq!(kept_of(0x20C3), made, "translated again");
        assert_eq!(r0_after(0x20C4), 0xC4);
        assert!(kept_of(0x20C4) > 0);
    }
}
