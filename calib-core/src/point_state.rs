//! A point ends in a state, valid or refused, never in a silent number.

use core::fmt;
use serde::{Deserialize, Serialize};

/// Outcome of one calibration point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum PointState {
    /// Every check of the point passed: sensitivity and uncertainty hold.
    Valid,
    /// The point was measured or attempted, and its numbers must not be used.
    Refused(Reason),
}

/// Why a point was refused. New reasons are added at the end: the number is
/// what is stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Reason {
    /// A channel reached the end of the converter's range.
    Clipped,
    /// Total harmonic distortion above Table 2 of ISO 16063-21.
    Distortion,
    /// Noise makes the result scatter more than Table 1 of ISO 16063-21 grants in all, or the device under
    /// test has too little signal over it.
    SignalToNoise,
    /// Acceleration amplitude moved more than Table 2 allows while measuring.
    AmplitudeUnstable,
    /// Tone further from its nominal frequency than Table 2 allows.
    FrequencyDeviation,
    /// The loop did not settle on the set acceleration in the time allowed.
    NotSettled,
    /// The set acceleration needs more drive voltage than is allowed.
    DriveLimit,
    /// The set acceleration exceeds the exciter's acceleration limit.
    AccelerationLimit,
    /// The set acceleration exceeds the exciter's velocity limit.
    VelocityLimit,
    /// The set acceleration exceeds the exciter's displacement limit.
    DisplacementLimit,
    /// The reference channel shows no signal although the exciter is driven.
    ReferenceDead,
    /// The device under test shows no signal although the table moves.
    DutOpen,
    /// Acceleration exceeded the set level far enough to be dangerous.
    Overload,
    /// Samples were lost: converter or DMA overrun.
    Overrun,
    /// No tone of the sample clock lies within 0.01 % of this frequency, or
    /// the reference has no calibration there.
    FrequencyUnavailable,
    /// Stopped by the operator, a host or the supervisor.
    Stopped,
    /// The uncertainty budget of the settings makes no sense at this point.
    BudgetInvalid,
    /// Fewer averages than broadband excitation needs (4.4, Note 1).
    TooFewAverages,
    /// Coherence below 0.98 with broadband excitation (4.4, Note 1).
    LowCoherence,
    /// The level does not follow the drive as it did before: the reference
    /// drifts, is loose or has failed, or the amplifier gives no more. More
    /// drive could go too far.
    LevelNotFollowing,
    /// The device under test distorts more than the motion it is given:
    /// saturated, loose or striking something.
    DutDistortion,
    /// The instrument is colder or hotter than it is made for
    /// ([`crate::thermometer`]).
    TemperatureOutOfRange,
    /// Both halves of a sample pair are not shown to be of one instant
    /// ([`crate::alignment`]): the phase would be wrong.
    ChannelsNotAligned,
    /// A line of the mains is too near to the tone to be told from it, and larger than Table 1 of
    /// ISO 16063-21 grants in all ([`crate::hum`]).
    Hum,
    /// No host has spoken for as long as the lease of the settings grants.
    HostsSilent,
}

impl Reason {
    /// True when going on with the next point would be pointless or unsafe.
    pub fn ends_run(self) -> bool {
        matches!(
            self,
            Self::ReferenceDead
                | Self::LevelNotFollowing
                | Self::Overload
                | Self::Overrun
                | Self::Stopped
                | Self::TemperatureOutOfRange
                | Self::ChannelsNotAligned
                | Self::HostsSilent
        )
    }
}

/// `valid`, or `refused: ` and the reason in words.
impl fmt::Display for PointState {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Valid => formatter.write_str("valid"),
            Self::Refused(reason) => write!(formatter, "refused: {reason}"),
        }
    }
}

/// The reason in words.
impl fmt::Display for Reason {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::Clipped => "a channel is clipped",
            Self::Distortion => "too much harmonic distortion",
            Self::SignalToNoise => "too little signal over noise",
            Self::AmplitudeUnstable => "the amplitude moved while measuring",
            Self::FrequencyDeviation => "the frequency is off",
            Self::NotSettled => "the level did not settle",
            Self::DriveLimit => "the level needs more drive voltage than allowed",
            Self::AccelerationLimit => "the level exceeds the acceleration limit",
            Self::VelocityLimit => "the level exceeds the velocity limit",
            Self::DisplacementLimit => "the level exceeds the displacement limit",
            Self::ReferenceDead => "the reference gives no signal",
            Self::DutOpen => "the device under test gives no signal",
            Self::Overload => "the acceleration overshot dangerously",
            Self::Overrun => "samples were lost",
            Self::FrequencyUnavailable => "this frequency is not available",
            Self::Stopped => "stopped",
            Self::BudgetInvalid => "the uncertainty budget makes no sense here",
            Self::TooFewAverages => "too few spectra were averaged",
            Self::LowCoherence => "the coherence is below 0.98",
            Self::LevelNotFollowing => {
                "the level does not follow the drive: reference, cable or amplifier"
            }
            Self::DutDistortion => "the device under test distorts",
            Self::TemperatureOutOfRange => "the instrument is too cold or too hot",
            Self::ChannelsNotAligned => "the channels are not of the same instants",
            Self::Hum => "hum of the mains too near to the frequency",
            Self::HostsSilent => "no host has spoken for longer than the lease grants",
        })
    }
}
