//! Kinds of sealed cases.

use super::draw::{self, Drawn};
use calib_twin::dataset::{Columns, Options};
use rand_chacha::ChaCha12Rng;

/// An effect that can be drawn.
pub type Effect = &'static calib_twin::effects::Effect;

/// A kind of case; [`Stratum::about`] says what each is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[expect(missing_docs, reason = "`about` says what each is")]
pub enum Stratum {
    Null,
    NominalOff,
    Single,
    RatioOnly,
    Pair,
    Withheld,
    Decoy,
    Size,
}

/// A case before it is measured.
pub struct Plan {
    /// Kind.
    pub stratum: Stratum,
    /// Effects of the measured side.
    pub effects: Vec<Drawn>,
    /// Names the diagnosis has to do without.
    pub without: Vec<String>,
}

impl Stratum {
    /// All kinds.
    pub const ALL: [Self; 8] = [
        Self::Null,
        Self::NominalOff,
        Self::Single,
        Self::RatioOnly,
        Self::Pair,
        Self::Withheld,
        Self::Decoy,
        Self::Size,
    ];

    /// Name in files and on the command line.
    pub fn name(self) -> &'static str {
        self.described().0
    }

    /// Description of a case of this kind.
    pub fn about(self) -> &'static str {
        self.described().1
    }

    fn described(self) -> (&'static str, &'static str) {
        match self {
            Self::Null => (
                "null",
                "No effect; the nominal values are off as their uncertainties say",
            ),
            Self::NominalOff => (
                "nominal-off",
                "No effect; every nominal value is off by twice its standard uncertainty",
            ),
            Self::Single => ("single", "One effect, all columns"),
            Self::RatioOnly => (
                "ratio-only",
                "One effect that shows in the ratio, nothing else measured",
            ),
            Self::Pair => ("pair", "Two effects, all columns"),
            Self::Withheld => (
                "withheld",
                "One effect, and the diagnosis has to do without it",
            ),
            Self::Decoy => (
                "decoy",
                "One effect, and the diagnosis has to do without another one",
            ),
            Self::Size => ("size", "One effect from barely visible to gross"),
        }
    }

    /// Case `index` of this kind: the effects of `all` take turns, their values are drawn.
    pub fn plan(self, index: usize, all: &[Effect], random: &mut ChaCha12Rng) -> Plan {
        let ratio: Vec<_> = all
            .iter()
            .copied()
            .filter(|e| e.entry.shows_in_ratio())
            .collect();
        let turn = all[index % all.len()];
        let chosen = match self {
            Self::Null | Self::NominalOff => Vec::new(),
            Self::Single | Self::Withheld | Self::Decoy | Self::Size => vec![turn],
            Self::RatioOnly => vec![ratio[index % ratio.len()]],
            Self::Pair => vec![turn, other(all, turn.entry.id, random)],
        };
        let without = match self {
            Self::Withheld => vec![turn.entry.id.to_owned()],
            Self::Decoy => vec![other(all, turn.entry.id, random).entry.id.to_owned()],
            _ => Vec::new(),
        };
        Plan {
            stratum: self,
            effects: chosen.into_iter().map(|e| draw::draw(e, random)).collect(),
            without,
        }
    }

    /// How a case of this kind is measured.
    pub fn options(self, seed: u64) -> Options {
        Options {
            seed,
            columns: match self {
                Self::RatioOnly => Columns::RatioOnly,
                _ => Columns::All,
            },
            parameters_off_by: (self == Self::NominalOff).then_some(2.0),
            ..Options::default()
        }
    }
}

fn other(all: &[Effect], than: &str, random: &mut ChaCha12Rng) -> Effect {
    let rest: Vec<Effect> = all.iter().copied().filter(|e| e.entry.id != than).collect();
    rest[draw::below(rest.len(), random)]
}
