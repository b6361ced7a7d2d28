//! An entry of the vocabulary, and the stages of a measuring chain.

use super::parameter::Parameter;
use schemars::JsonSchema;
use serde::Serialize;

/// Of what an entry is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Of {
    /// An effect of a calibrator, in the list `effects` of a rig file.
    Calibrator,
    /// A term of an oscillator.
    Oscillator,
    /// Something that breaks, in the list `faults` of a rig file: it acts in time only, and no
    /// diagnosis looks for it.
    Fault,
}

/// Part of the measuring chain in which an effect sits.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Stage {
    /// Device under test; of a record, the oscillator itself.
    Dut,
    /// Reference transducer.
    Reference,
    /// Between table and transducers.
    Mount,
    /// Amplifiers and filters between transducer and converter.
    Conditioning,
    /// Converter and its clock.
    Digitiser,
    /// Moving coil and suspension.
    Exciter,
    /// Power amplifier; of a record, its input.
    Amplifier,
    /// Surroundings.
    Environment,
}

impl Stage {
    /// All stages.
    pub const ALL: [Self; 8] = [
        Self::Dut,
        Self::Reference,
        Self::Mount,
        Self::Conditioning,
        Self::Digitiser,
        Self::Exciter,
        Self::Amplifier,
        Self::Environment,
    ];

    /// The stage with this name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|stage| stage.name() == name)
    }

    /// Name as in JSON.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Dut => "dut",
            Self::Reference => "reference",
            Self::Mount => "mount",
            Self::Conditioning => "conditioning",
            Self::Digitiser => "digitiser",
            Self::Exciter => "exciter",
            Self::Amplifier => "amplifier",
            Self::Environment => "environment",
        }
    }

    /// Words that need no training.
    #[must_use]
    pub fn plain(self) -> &'static str {
        match self {
            Self::Dut => "the device under test",
            Self::Reference => "the reference transducer",
            Self::Mount => "the way the device is mounted",
            Self::Conditioning => "the electronics between transducer and converter",
            Self::Digitiser => "the converter to numbers",
            Self::Exciter => "the shaker",
            Self::Amplifier => "the power amplifier",
            Self::Environment => "the surroundings",
        }
    }

    /// A word or two, for a drawing.
    #[must_use]
    pub fn label(self) -> &'static str {
        match self {
            Self::Dut => "device under test",
            Self::Reference => "reference",
            Self::Mount => "mounting",
            Self::Conditioning => "electronics",
            Self::Digitiser => "converter",
            Self::Exciter => "shaker",
            Self::Amplifier => "power amplifier",
            Self::Environment => "surroundings",
        }
    }
}

impl std::fmt::Display for Stage {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.pad(self.name())
    }
}

/// An effect, a term of an oscillator or a fault, in words.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct Entry {
    /// Name on the command line, in files and in JSON.
    pub id: &'static str,
    /// Of what it is an effect.
    pub of: Of,
    /// Where it sits.
    pub stage: Stage,
    /// First-order shape: r = dut/ref, d = ref/coil voltage, z = coil voltage/current, A level,
    /// q = f/f0; of oscillators, the changed term.
    pub formula: &'static str,
    /// Parameters in the order in which a rig file's values are kept.
    pub parameters: &'static [Parameter],
    /// Parameters that only a diagnosis has: how the instrument shows the effect. No rig file
    /// takes them.
    #[serde(skip)]
    pub only_fitted: &'static [Parameter],
    /// The effect as the end of "the simulation does not know that ...".
    pub plain: &'static str,
    /// Columns of a dataset that reveal it.
    pub columns: &'static [&'static str],
    /// Effects it is mistaken for.
    pub confused_with: &'static [&'static str],
    /// The measurement that tells it from those.
    pub separate_by: &'static str,
    /// False for what no data with one unknown gain can name, and for faults.
    pub identifiable: bool,
    /// Whether it works by noise and scatter, not by a response.
    #[serde(skip)]
    pub only_scatters: bool,
    /// Whether it is an error of what is stated of the rig, not of the rig.
    #[serde(skip)]
    pub of_nominal: bool,
    /// How many of the first parameters make up its size (or the frequency it sits at).
    #[serde(skip)]
    pub sizes: usize,
    /// Usual values of the other way in which it comes about, if there is one.
    #[serde(skip)]
    pub other_way: Option<&'static [f64]>,
}

impl Entry {
    /// An effect of a calibrator before it is filled in.
    pub(crate) const CALIBRATOR: Self = Self {
        id: "",
        of: Of::Calibrator,
        stage: Stage::Dut,
        formula: "",
        parameters: &[],
        only_fitted: &[],
        plain: "",
        columns: &[],
        confused_with: &[],
        separate_by: "",
        identifiable: true,
        only_scatters: false,
        of_nominal: false,
        sizes: 1,
        other_way: None,
    };

    /// A term of an oscillator before it is filled in.
    pub(crate) const OSCILLATOR: Self = Self {
        of: Of::Oscillator,
        columns: &["input", "output"],
        ..Self::CALIBRATOR
    };

    /// A fault before it is filled in.
    pub(crate) const FAULT: Self = Self {
        of: Of::Fault,
        identifiable: false,
        ..Self::CALIBRATOR
    };

    /// Whether the ratio of the two transducers, magnitude or phase, shows it. Noise averages out.
    #[must_use]
    pub fn shows_in_ratio(&self) -> bool {
        !self.only_scatters && (self.shows_in("ratio") || self.shows_in("dut_deg"))
    }

    /// Whether a column reveals it.
    #[must_use]
    pub fn shows_in(&self, column: &str) -> bool {
        self.columns.contains(&column)
    }

    /// Its parameter with a name, of those that a rig file takes.
    #[must_use]
    pub fn parameter(&self, name: &str) -> Option<&'static Parameter> {
        self.parameters.iter().find(|known| known.name == name)
    }
}
