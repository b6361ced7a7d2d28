//! Restarts nobody asked for: what of them is kept over a reset, and when one more is not tried.
//!
//! | the start before ended | the next one |
//! |---|---|
//! | supply, reset pin, a host's or a hand's order | begins anew: everything is tried |
//! | by a fault outside: supply or clock | goes on as it was |
//! | by a fault, or without a word, within a minute | counts it |
//! | the same, [`MAX_RESTARTS`] times in a row | leaves out what it ended in |
//!
//! A minute of life ends the count. What is left out stays out until somebody tries again: an
//! instrument that tried by itself would be silent in between, for good.

use calib_protocol::frame::CRC;
use calib_protocol::health::MAX_RESTARTS;
use calib_protocol::message::ResetCause;
use heapless::{String, Vec};

/// Longest reason kept, bytes.
pub const REASON_BYTES: usize = 160;
/// Life after which a restart is not counted with those before, ms.
pub const MINUTE_MS: u64 = 60_000;

/// Double words of a kept history: check sum, counters, texts.
pub const WORDS: usize = 2 + MAX_RESTARTS * REASON_BYTES / 8;

/// Why a start ended, in words.
pub type Reason = String<REASON_BYTES>;

/// How far a start has come.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Reached {
    /// Clocks and supply.
    Clocks = 0,
    /// The converters of the measurement.
    Converters = 1,
    /// The record area is being read; links and lamps work already.
    Archive = 2,
    /// Everything runs.
    Running = 3,
}

impl Reached {
    fn of(number: u8) -> Option<Self> {
        [Self::Clocks, Self::Converters, Self::Archive, Self::Running]
            .into_iter()
            .find(|reached| *reached as u8 == number)
    }
}

/// Parts a start does without.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct LeftOut(u8);

impl LeftOut {
    /// Nothing.
    pub const NOTHING: Self = Self(0);
    /// The converters, and with them all that measures.
    pub const CONVERTERS: Self = Self(1);
    /// The record area.
    pub const ARCHIVE: Self = Self(2);
    /// The part's own USB port: the serial line is left.
    pub const USB: Self = Self(4);

    /// Whether `part` is left out.
    pub const fn has(self, part: Self) -> bool {
        self.0 & part.0 != 0
    }

    /// Whether everything is tried.
    pub const fn is_nothing(self) -> bool {
        self.0 == 0
    }

    const fn and(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// Parts to leave out as well after a start has ended too often in `reached`. A fault while running may come
    /// from anywhere: first nothing is measured and stored, then the port is closed too.
    fn after(self, reached: Reached) -> Self {
        let measuring = Self::CONVERTERS.and(Self::ARCHIVE);
        match reached {
            Reached::Converters => self.and(Self::CONVERTERS),
            Reached::Archive if !self.has(Self::ARCHIVE) => self.and(Self::ARCHIVE),
            _ if self == measuring => self.and(Self::USB),
            _ => self.and(measuring),
        }
    }
}

/// The way out of a start.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Way {
    /// No word was left: the watchdog, or nothing that is known.
    Unknown = 0,
    /// A fault that told why.
    Fault = 1,
    /// Supply or clock: no fault of what runs.
    Outside = 2,
    /// Somebody asked for it.
    Asked = 3,
}

impl Way {
    fn of(number: u8) -> Option<Self> {
        [Self::Unknown, Self::Fault, Self::Outside, Self::Asked]
            .into_iter()
            .find(|way| *way as u8 == number)
    }
}

/// History kept over a reset.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct History {
    /// Restarts in a row.
    count: u8,
    left_out: LeftOut,
    reached: Reached,
    way: Way,
    /// Of the last starts that ended, oldest first.
    reasons: Vec<Reason, MAX_RESTARTS>,
}

impl Default for History {
    fn default() -> Self {
        Self::new()
    }
}

impl History {
    /// Of an instrument that has just been switched on.
    pub const fn new() -> Self {
        Self {
            count: 0,
            left_out: LeftOut::NOTHING,
            reached: Reached::Clocks,
            way: Way::Unknown,
            reasons: Vec::new(),
        }
    }

    /// The history of a start that begins, with the words the one before left, if any.
    pub fn begin(kept: Option<Self>, cause: ResetCause) -> (Self, Option<Reason>) {
        let begun_anew = matches!(
            cause,
            ResetCause::PowerOn | ResetCause::BrownOut | ResetCause::Pin
        );
        let Some(mut history) = kept else {
            return (Self::new(), None);
        };
        let told = match history.way {
            Way::Fault | Way::Outside => history.reasons.last().cloned(),
            Way::Unknown | Way::Asked => None,
        };
        if begun_anew || history.way == Way::Asked {
            return (Self::new(), told);
        }
        match history.way {
            // Told once, and no fault of the instrument.
            Way::Outside => drop(history.reasons.pop()),
            Way::Unknown => history.push(unknown(cause)),
            Way::Fault | Way::Asked => {}
        }
        if history.way != Way::Outside {
            history.count();
        }
        (history.way, history.reached) = (Way::Unknown, Reached::Clocks);
        (history, told)
    }

    fn count(&mut self) {
        self.count = self.count.saturating_add(1);
        if usize::from(self.count) >= MAX_RESTARTS {
            self.left_out = self.left_out.after(self.reached);
            // What is left out now gets as many tries of its own.
            self.count = 0;
        }
    }

    /// The start has come to `reached`.
    pub fn enter(&mut self, reached: Reached) {
        self.reached = reached;
    }

    /// The start ends this way; a fault says why.
    pub fn leave(&mut self, way: Way, reason: Reason) {
        self.way = way;
        if way != Way::Asked {
            self.push(reason);
        }
    }

    /// A minute has passed: what happens now has nothing to do with the starts before. What is left
    /// out stays out, and why is not forgotten.
    pub fn live_on(&mut self) {
        self.count = 0;
        if self.left_out.is_nothing() {
            self.reasons.clear();
        }
    }

    /// Parts this start does without.
    pub fn left_out(&self) -> LeftOut {
        self.left_out
    }

    /// Why the last starts ended, oldest first.
    pub fn reasons(&self) -> &Vec<Reason, MAX_RESTARTS> {
        &self.reasons
    }

    fn push(&mut self, reason: Reason) {
        if self.reasons.is_full() {
            self.reasons.remove(0);
        }
        // There is room now.
        let _ = self.reasons.push(reason);
    }

    /// As it lies in memory.
    pub fn to_words(&self) -> [u64; WORDS] {
        let mut words = [0; WORDS];
        let (counters, texts) = words.split_at_mut(2);
        let mut lengths = [0; MAX_RESTARTS];
        let places = texts.as_chunks_mut::<{ REASON_BYTES / 8 }>().0;
        for ((reason, length), place) in self.reasons.iter().zip(&mut lengths).zip(places) {
            *length = reason.len() as u8;
            for (word, bytes) in place.iter_mut().zip(reason.as_bytes().chunks(8)) {
                let mut whole = [0; 8];
                for (to, from) in whole.iter_mut().zip(bytes) {
                    *to = *from;
                }
                *word = u64::from_le_bytes(whole);
            }
        }
        let [first, second, third] = lengths;
        let (reached, way) = (self.reached as u8, self.way as u8);
        let counts = [self.count, self.left_out.0, reached, way];
        let [count, left_out, reached, way] = counts;
        counters[1] = u64::from_le_bytes([
            count,
            left_out,
            reached,
            way,
            self.reasons.len() as u8,
            first,
            second,
            third,
        ]);
        words[0] = check_sum(&words);
        words
    }

    /// From memory; none when it holds anything else.
    pub fn from_words(words: &[u64; WORDS]) -> Option<Self> {
        let (counters, texts) = words.split_at(2);
        if counters.first() != Some(&check_sum(words)) {
            return None;
        }
        let [count, left_out, reached, way, reasons, lengths @ ..] = counters.get(1)?.to_le_bytes();
        let mut history = Self {
            count,
            left_out: LeftOut(left_out),
            reached: Reached::of(reached)?,
            way: Way::of(way)?,
            reasons: Vec::new(),
        };
        let places = texts
            .as_chunks::<{ REASON_BYTES / 8 }>()
            .0
            .iter()
            .zip(lengths);
        for (place, length) in places.take(usize::from(reasons)) {
            let bytes = place.iter().flat_map(|word| word.to_le_bytes());
            let bytes: Vec<u8, REASON_BYTES> = bytes.take(usize::from(length)).collect();
            history.reasons.push(String::from_utf8(bytes).ok()?).ok()?;
        }
        Some(history)
    }
}

/// Of a start that left no word.
fn unknown(cause: ResetCause) -> Reason {
    let text = match cause {
        ResetCause::Watchdog => "restarted by the watchdog: everything stood still",
        _ => "restarted without a word",
    };
    text.try_into().unwrap_or_default()
}

fn check_sum(words: &[u64; WORDS]) -> u64 {
    let mut digest = CRC.digest();
    digest.update(b"restarts");
    for word in words.iter().skip(1) {
        digest.update(&word.to_le_bytes());
    }
    u64::from(digest.finalize())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn reason(text: &str) -> Reason {
        text.try_into().expect("short")
    }

    /// A start that came to `reached` and ended this way.
    fn ended(kept: Option<History>, reached: Reached, way: Way) -> History {
        let cause = match way {
            Way::Unknown => ResetCause::Watchdog,
            _ => ResetCause::Software,
        };
        let mut history = kept.unwrap_or_default();
        history.enter(reached);
        if way != Way::Unknown {
            history.leave(way, reason("why"));
        }
        let words = history.to_words();
        History::begin(History::from_words(&words), cause).0
    }

    #[test]
    fn what_lies_in_memory_is_what_was_kept() {
        let mut history = History::new();
        let long = "x".repeat(REASON_BYTES);
        for text in ["first", "", &long] {
            history.leave(Way::Fault, reason(text));
        }
        let words = history.to_words();
        assert_eq!(History::from_words(&words), Some(history));
        for (index, bit) in [(0, 3), (1, 9), (2, 0), (WORDS - 1, 63)] {
            let mut damaged = words;
            damaged[index] ^= 1 << bit;
            assert_eq!(History::from_words(&damaged), None, "word {index}");
        }
        assert_eq!(History::from_words(&[0; WORDS]), None);
    }

    #[test]
    fn the_third_restart_in_a_row_leaves_out_what_it_ended_in() {
        for (reached, left_out) in [
            (Reached::Converters, LeftOut::CONVERTERS),
            (Reached::Archive, LeftOut::ARCHIVE),
        ] {
            for way in [Way::Fault, Way::Unknown] {
                let one = ended(None, reached, way);
                let two = ended(Some(one), reached, way);
                assert!(two.left_out().is_nothing());
                let three = ended(Some(two), reached, way);
                assert_eq!(three.left_out(), left_out);
                assert_eq!(three.reasons().len(), 3);
            }
        }
    }

    #[test]
    fn a_fault_of_what_runs_leaves_out_more_each_time() {
        let mut history = History::new();
        let mut found = std::vec::Vec::new();
        for _ in 0..9 {
            history = ended(Some(history), Reached::Running, Way::Fault);
            found.push(history.left_out());
        }
        let both = LeftOut::CONVERTERS.and(LeftOut::ARCHIVE);
        let all = both.and(LeftOut::USB);
        assert_eq!(found[1..3], [LeftOut::NOTHING, both]);
        assert_eq!(found[4..6], [both, all]);
        assert_eq!(found[8], all);
    }

    #[test]
    fn a_minute_of_life_ends_the_count_and_keeps_what_is_left_out() {
        let mut history = ended(None, Reached::Running, Way::Fault);
        for _ in 0..5 {
            history = ended(Some(history), Reached::Running, Way::Fault);
            history.live_on();
            assert!(history.left_out().is_nothing());
            assert!(history.reasons().is_empty());
        }
        for _ in 0..3 {
            history = ended(Some(history), Reached::Archive, Way::Unknown);
        }
        history.live_on();
        assert_eq!(history.left_out(), LeftOut::ARCHIVE);
        assert_eq!(history.reasons().len(), 3);
    }

    #[test]
    fn a_hand_a_host_and_the_supply_begin_anew() {
        let mut bad = History::new();
        for _ in 0..3 {
            bad = ended(Some(bad), Reached::Archive, Way::Fault);
        }
        assert_eq!(
            ended(Some(bad.clone()), Reached::Running, Way::Asked),
            History::new()
        );
        for cause in [ResetCause::PowerOn, ResetCause::Pin, ResetCause::BrownOut] {
            assert_eq!(History::begin(Some(bad.clone()), cause).0, History::new());
        }
    }

    #[test]
    fn supply_and_clock_are_told_and_not_counted() {
        let mut history = History::new();
        for _ in 0..10 {
            history.leave(Way::Outside, reason("the supply fell"));
            let (next, told) = History::begin(Some(history), ResetCause::Software);
            assert_eq!(told, Some(reason("the supply fell")));
            assert!(next.left_out().is_nothing() && next.reasons().is_empty());
            history = next;
        }
    }
}
