//! The library of effects: what can cause a gap, by name.
//!
//! One entry says what the effect is, when data can show it, where a fit
//! starts, and what it does to one row. An effect that can sit in either
//! channel, or whose text leaves a detail open, has variants: several entries
//! of one name, of which the best one speaks for the name.

mod about;
mod facts;
mod start;

mod adc;
mod amplifier;
mod coil;
mod filters;
mod gains;
mod mechanics;
mod motion;
mod mount;
mod noise;
mod resonance;
mod suspension;
mod timing;

pub use about::{About, Parameter, Scale, Stage};
pub(crate) use facts::Facts;
pub(crate) use start::Start;

use crate::error::GapError;
use crate::model::chain::{Chain, Transfer};
use crate::model::row::Row;
use crate::model::scatter::Scatter;

/// One entry of the library.
pub(crate) trait Effect: Sync {
    /// Name, stage, formula, parameters.
    fn about(&self) -> &'static About;

    /// Whether the data can show the effect at all.
    fn applies(&self, facts: &Facts) -> bool;

    /// Where a fit starts.
    fn starts(&self, facts: &Facts) -> Vec<Start>;

    /// Parameters from the amplitudes that a linear fit gave to the members of a start.
    fn combine(&self, start: &Start, amplitudes: &[f64]) -> Vec<f64> {
        start.scaled(amplitudes[0])
    }

    /// More starts around the best one, for effects that only scatter: first other
    /// sizes (rounds 0 and 1), then other details.
    fn around(&self, _best: &[f64], _round: usize, _facts: &Facts) -> Vec<Vec<f64>> {
        Vec::new()
    }

    /// Acts on exciter, amplifier and digitiser of a row.
    fn chain(&self, _parameters: &[f64], _row: &Row, _chain: &mut Chain) {}

    /// Adds noise and leakage to a row; `dut_gain` is the gain of the device under test
    /// relative to its nominal value.
    fn scatter(&self, _parameters: &[f64], _row: &Row, _dut_gain: f64, _scatter: &mut Scatter) {}

    /// Multiplies linear responses at a frequency (of the fundamental or a harmonic).
    fn transfer(
        &self,
        _parameters: &[f64],
        _row: &Row,
        _frequency_hz: f64,
        _transfer: &mut Transfer,
    ) {
    }

    /// Whether [`Effect::transfer`] is all there is.
    fn is_linear(&self) -> bool {
        false
    }

    /// Whether the exciter becomes nonlinear.
    fn bends(&self) -> bool {
        false
    }

    /// Whether it makes harmonics, of the exciter or of a channel.
    fn distorts(&self) -> bool {
        self.bends()
    }

    /// Whether the response depends on level so steeply that the gain of each run matters.
    fn saturates(&self) -> bool {
        false
    }

    /// Whether the effect leaves part of the scatter open, which slopes do not see.
    fn opens(&self) -> bool {
        self.scatters()
    }

    /// Whether the effect works by noise and scatter, not by a response.
    fn scatters(&self) -> bool {
        false
    }
}

/// An effect with values for its parameters.
#[derive(Clone)]
pub(crate) struct Active<'a> {
    /// Place in the library.
    pub(crate) entry: usize,
    pub(crate) effect: &'a dyn Effect,
    pub(crate) parameters: Vec<f64>,
    /// Size of a usual step of each parameter, so that all slopes are of one order.
    pub(crate) unit: Vec<f64>,
}

impl Active<'_> {
    pub(crate) fn chain(&self, row: &Row, chain: &mut Chain) {
        self.effect.chain(&self.parameters, row, chain);
    }

    pub(crate) fn scatter(&self, row: &Row, dut_gain: f64, scatter: &mut Scatter) {
        self.effect
            .scatter(&self.parameters, row, dut_gain, scatter);
    }

    pub(crate) fn transfer(&self, row: &Row, frequency_hz: f64, transfer: &mut Transfer) {
        self.effect
            .transfer(&self.parameters, row, frequency_hz, transfer);
    }
}

/// All entries, in the order in which equals are preferred.
pub(crate) fn library() -> &'static [&'static dyn Effect] {
    &[
        &resonance::Resonance::Dut,
        &resonance::Resonance::Reference,
        &resonance::Resonance::Mount,
        &motion::RelativeMotion,
        &motion::TransverseMotion,
        &mount::BaseStrain,
        &mount::GravityTilt,
        &mount::LooseMount {
            upper: false,
            with_gravity: false,
        },
        &mount::LooseMount {
            upper: true,
            with_gravity: false,
        },
        &mount::LooseMount {
            upper: false,
            with_gravity: true,
        },
        &mount::LooseMount {
            upper: true,
            with_gravity: true,
        },
        &gains::FrequencySlope,
        &gains::LevelNonlinearity::Plain,
        &gains::LevelNonlinearity::Second,
        &gains::LevelNonlinearity::Third,
        &gains::Slow::DutTemperature,
        &gains::Slow::ReferenceTemperature,
        &gains::Slow::ReferenceDrift,
        &gains::Slow::DutDrift,
        &gains::Slow::AmplifierGainDrift,
        &filters::Filter::DutHighpass,
        &filters::Filter::ReferenceHighpass,
        &filters::Filter::DutLowpass1,
        &filters::Filter::AveragingWindow,
        &filters::Lowpass2,
        &timing::Crosstalk::Capacitive,
        &timing::Crosstalk::Resistive,
        &timing::ChannelSkew,
        &timing::ClockOffset,
        &noise::MainsPickup::Fundamental,
        &noise::MainsPickup::Everywhere,
        &noise::SamplingJitter,
        &noise::AmbientVibration::Broadband,
        &noise::AmbientVibration::ToneNearby,
        &noise::AmbientVibration::ToneEverywhere,
        &adc::Adc::CUBIC_REF,
        &adc::Adc::CUBIC_DUT,
        &adc::Adc::QUADRATIC_REF,
        &adc::Adc::QUADRATIC_DUT,
        &adc::Adc::DEAD_ZONE_REF,
        &adc::Adc::DEAD_ZONE_DUT,
        &adc::Adc::CLIPPING_REF,
        &adc::Adc::CLIPPING_DUT,
        &suspension::Suspension::Cubic,
        &suspension::Suspension::Asymmetry,
        &suspension::Suspension::Droop,
        &suspension::Suspension::Friction,
        &mechanics::Mechanics::Damping,
        &mechanics::Mechanics::BackEmf,
        &mechanics::Mechanics::PayloadMass,
        &coil::LossyInductance,
        &coil::CoilHeating,
        &motion::ArmatureMode,
        &amplifier::Amplifier::Clipping,
        &amplifier::Amplifier::EvenOrder,
    ]
}

/// Gains that no data with one unknown gain can name: described, never a candidate.
pub const NEVER_IDENTIFIABLE: [(&str, Stage, &str); 2] = [
    (
        "dut_gain",
        Stage::Dut,
        "constant r: the measurand itself; a second reference would tell",
    ),
    (
        "reference_gain",
        Stage::Reference,
        "constant 1/r: shared with the measurand; a second reference would tell",
    ),
];

/// One description per name, in library order.
#[must_use]
pub fn list() -> Vec<&'static About> {
    let mut all: Vec<&'static About> = Vec::new();
    for effect in library() {
        let about = effect.about();
        if !all.iter().any(|a| a.id == about.id) {
            all.push(about);
        }
    }
    all
}

/// Looks a name up, oscillator effects and constant gains included.
///
/// # Errors
/// [`GapError::UnknownEffect`] with the nearest name.
pub fn check_name(name: &str) -> Result<(), GapError> {
    let mut names: Vec<&str> = list().iter().map(|a| a.id).collect();
    names.extend(NEVER_IDENTIFIABLE.iter().map(|n| n.0));
    names.extend(crate::oscillator::names());
    if names.contains(&name) {
        return Ok(());
    }
    let common = |n: &str| name.split('_').filter(|part| n.contains(part)).count();
    let nearest = names
        .iter()
        .max_by_key(|n| common(n))
        .filter(|n| common(n) > 0);
    Err(GapError::UnknownEffect {
        name: name.into(),
        hint: nearest.map_or(String::new(), |n| format!(" (did you mean {n}?)")),
    })
}
