//! The scalars that can be measured at a point, in the one order in which data are stored.

use schemars::JsonSchema;
use serde::Serialize;
use std::fmt;
use std::ops::{Index, IndexMut};

/// Channel of the digitiser.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Channel {
    /// Reference transducer.
    Reference,
    /// Device under test.
    Dut,
}

impl Channel {
    /// Both, in the order of every `[T; 2]` by channel.
    pub const BOTH: [Self; 2] = [Self::Reference, Self::Dut];
}

/// Observables that are measured together and reported as one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Group {
    /// Output of the device under test over that of the reference.
    Ratio,
    /// Output of the reference over the coil voltage.
    Drive,
    /// Coil current over the coil voltage.
    Current,
    /// Harmonics of the reference over its fundamental.
    RefHarmonics,
    /// Harmonics of the device under test over its fundamental.
    DutHarmonics,
    /// Means of both channels.
    Dc,
    /// Noise of both channels.
    Noise,
    /// Output of a record; it has no points, so none of the observables.
    Output,
}

impl Group {
    /// All groups of points, in the order of their observables.
    pub const ALL: [Self; 7] = [
        Self::Ratio,
        Self::Drive,
        Self::Current,
        Self::RefHarmonics,
        Self::DutHarmonics,
        Self::Dc,
        Self::Noise,
    ];
    /// Complex responses at the excitation frequency.
    pub const RESPONSES: [Self; 3] = [Self::Ratio, Self::Drive, Self::Current];

    /// Name in JSON.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Ratio => "ratio",
            Self::Drive => "drive",
            Self::Current => "current",
            Self::RefHarmonics => "ref_harmonics",
            Self::DutHarmonics => "dut_harmonics",
            Self::Dc => "dc",
            Self::Noise => "noise",
            Self::Output => "output",
        }
    }

    /// The group with this name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        let mut all = Self::ALL.into_iter().chain([Self::Output]);
        all.find(|group| group.name() == name)
    }

    /// Words that need no training.
    #[must_use]
    pub const fn plain(self) -> &'static str {
        match self {
            Self::Ratio => "the ratio of the two transducers",
            Self::Drive => "the motion per coil voltage",
            Self::Current => "the coil current",
            Self::RefHarmonics => "the distortion of the reference signal",
            Self::DutHarmonics => "the distortion of the device's signal",
            Self::Dc => "the mean of the signals",
            Self::Noise => "the noise",
            Self::Output => "the output",
        }
    }

    /// Whether it is one of [`Group::RESPONSES`].
    #[must_use]
    pub const fn is_response(self) -> bool {
        matches!(self, Self::Ratio | Self::Drive | Self::Current)
    }

    /// Its observables, in the order of the data.
    pub fn observables(self) -> impl Iterator<Item = Observable> {
        let all = Observable::ALL.into_iter();
        all.filter(move |observable| observable.group() == self)
    }
}

impl fmt::Display for Group {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.pad(self.name())
    }
}

/// Lists the observables by group: the one place that says in which order data are stored.
macro_rules! observables {
    ($($group:ident: $($name:ident)+;)+) => {
        /// A scalar that can be measured at a point.
        ///
        /// Magnitudes and noise are natural logarithms, so that gains add; phases are in rad;
        /// harmonics are relative to the fundamental, their phase to n times its phase; means are
        /// in V.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
        #[repr(u8)]
        #[expect(missing_docs, reason = "a regular list; the text above says what each is")]
        pub enum Observable {
            $($($name,)+)+
        }

        impl Observable {
            /// All of them, in the order of the data.
            pub const ALL: [Self; 26] = [$($(Self::$name,)+)+];

            /// Group of columns it is measured in.
            #[must_use]
            pub const fn group(self) -> Group {
                match self {
                    $($(Self::$name)|+ => Group::$group,)+
                }
            }
        }
    };
}

observables! {
    Ratio: Ratio RatioPhase;
    Drive: Drive DrivePhase;
    Current: Current CurrentPhase;
    RefHarmonics: RefH2Real RefH2Imaginary RefH3Real RefH3Imaginary
        RefH4Real RefH4Imaginary RefH5Real RefH5Imaginary;
    DutHarmonics: DutH2Real DutH2Imaginary DutH3Real DutH3Imaginary
        DutH4Real DutH4Imaginary DutH5Real DutH5Imaginary;
    Dc: RefDc DutDc;
    Noise: RefNoise DutNoise;
}

/// The observables of a complex value: logarithm and phase, or real and imaginary part.
pub(crate) type Complex = [Observable; 2];

impl Observable {
    /// Ratio of the outputs.
    pub const RATIO: Complex = [Self::Ratio, Self::RatioPhase];
    /// Reference output over coil voltage.
    pub const DRIVE: Complex = [Self::Drive, Self::DrivePhase];
    /// Coil current over coil voltage.
    pub const CURRENT: Complex = [Self::Current, Self::CurrentPhase];

    /// Harmonics 2 to 5 of a channel.
    #[must_use]
    pub const fn harmonics(channel: Channel) -> [Complex; 4] {
        match channel {
            Channel::Reference => [
                [Self::RefH2Real, Self::RefH2Imaginary],
                [Self::RefH3Real, Self::RefH3Imaginary],
                [Self::RefH4Real, Self::RefH4Imaginary],
                [Self::RefH5Real, Self::RefH5Imaginary],
            ],
            Channel::Dut => [
                [Self::DutH2Real, Self::DutH2Imaginary],
                [Self::DutH3Real, Self::DutH3Imaginary],
                [Self::DutH4Real, Self::DutH4Imaginary],
                [Self::DutH5Real, Self::DutH5Imaginary],
            ],
        }
    }

    /// Mean of a channel.
    #[must_use]
    pub const fn dc(channel: Channel) -> Self {
        match channel {
            Channel::Reference => Self::RefDc,
            Channel::Dut => Self::DutDc,
        }
    }

    /// Noise of a channel.
    #[must_use]
    pub const fn noise(channel: Channel) -> Self {
        match channel {
            Channel::Reference => Self::RefNoise,
            Channel::Dut => Self::DutNoise,
        }
    }

    /// Order of a harmonic, 2 to 5.
    #[must_use]
    pub const fn order(self) -> Option<usize> {
        match self {
            Self::RefH2Real | Self::RefH2Imaginary | Self::DutH2Real | Self::DutH2Imaginary => {
                Some(2)
            }
            Self::RefH3Real | Self::RefH3Imaginary | Self::DutH3Real | Self::DutH3Imaginary => {
                Some(3)
            }
            Self::RefH4Real | Self::RefH4Imaginary | Self::DutH4Real | Self::DutH4Imaginary => {
                Some(4)
            }
            Self::RefH5Real | Self::RefH5Imaginary | Self::DutH5Real | Self::DutH5Imaginary => {
                Some(5)
            }
            _ => None,
        }
    }

    /// Whether it is a phase, known up to whole turns.
    #[must_use]
    pub const fn is_phase(self) -> bool {
        matches!(
            self,
            Self::RatioPhase | Self::DrivePhase | Self::CurrentPhase
        )
    }

    /// Whether it is noise, not a component of the block.
    #[must_use]
    pub const fn is_noise(self) -> bool {
        matches!(self, Self::RefNoise | Self::DutNoise)
    }
}

/// One value for each observable.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Table<T>([T; Observable::ALL.len()]);

impl<T> Table<T> {
    /// The value that `of` gives each.
    pub fn from_fn(of: impl FnMut(Observable) -> T) -> Self {
        Self(Observable::ALL.map(of))
    }

    /// Observables with their values, in the order of the data.
    pub fn iter(&self) -> impl Iterator<Item = (Observable, &T)> {
        Observable::ALL.iter().copied().zip(&self.0)
    }

    pub(crate) fn iter_mut(&mut self) -> impl Iterator<Item = (Observable, &mut T)> {
        Observable::ALL.iter().copied().zip(&mut self.0)
    }
}

impl<T: Copy> Table<T> {
    /// One value for all.
    pub const fn filled(value: T) -> Self {
        Self([value; Observable::ALL.len()])
    }
}

impl<T> Index<Observable> for Table<T> {
    type Output = T;

    fn index(&self, observable: Observable) -> &T {
        &self.0[observable as usize]
    }
}

impl<T> IndexMut<Observable> for Table<T> {
    fn index_mut(&mut self, observable: Observable) -> &mut T {
        &mut self.0[observable as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn groups_are_stored_one_after_the_other() {
        let by_group: Vec<Observable> = Group::ALL.iter().flat_map(|g| g.observables()).collect();
        assert_eq!(by_group, Observable::ALL);
    }

    #[test]
    fn a_harmonic_knows_its_channel_and_order() {
        for (channel, group) in [
            (Channel::Reference, Group::RefHarmonics),
            (Channel::Dut, Group::DutHarmonics),
        ] {
            let all = Observable::harmonics(channel);
            assert!(all.as_flattened().iter().copied().eq(group.observables()));
            for (order, parts) in (2..).zip(all) {
                assert_eq!(parts.map(Observable::order), [Some(order); 2]);
            }
        }
    }
}
