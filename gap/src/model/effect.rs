//! Explanation of one effect: when data can show it, where a fit starts, and its action on a row.

use super::chain::{Chain, Transfer};
use super::facts::Facts;
use super::row::Row;
use super::scatter::Scatter;
use calib_effects::{Entry, Parameter};

/// Explanations of a file, in the order in which equals are preferred.
pub(crate) type Explanations = &'static [&'static dyn Effect];

/// Kind of observable in which an effect shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Shows {
    /// Magnitude and phase.
    Response,
    /// Harmonics, of the exciter or of a channel.
    Harmonics,
    /// Noise and leakage.
    Noise,
}

/// A fitted parameter before it is stated.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Stated {
    /// Value.
    pub(crate) value: f64,
    /// Standard uncertainty.
    pub(crate) u: f64,
}

/// One entry of the library.
pub(crate) trait Effect: Sync {
    /// Its words.
    fn entry(&self) -> &'static Entry;

    /// The parameters that are fitted, in the order of their values.
    fn parameters(&self) -> &'static [Parameter] {
        self.entry().parameters
    }

    /// Turns the values of a fit into those that the vocabulary defines.
    fn state(&self, _values: &mut [Stated]) {}

    /// Whether the data can show the effect at all.
    fn applies(&self, facts: &Facts) -> bool;

    /// Where a fit starts.
    fn starts(&self, facts: &Facts) -> Vec<Start>;

    /// The starts of the first screening.
    fn screened(&self, facts: &Facts) -> Vec<Start> {
        self.starts(facts)
    }

    /// The effect from which no data with these facts can tell this one.
    fn alike(&self, _facts: &Facts) -> Option<&'static Entry> {
        None
    }

    /// Smallest and largest value of the first parameter at which the effect is more than a limit of
    /// another one, within the bounds of the vocabulary.
    fn within(&self, _facts: &Facts) -> Option<[f64; 2]> {
        None
    }

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
    fn makes_nonlinear(&self) -> bool {
        false
    }

    /// Whether it makes harmonics, of the exciter or of a channel.
    fn distorts(&self) -> bool {
        self.makes_nonlinear()
    }

    /// Whether the response depends on level so steeply that the gain of each run matters.
    fn saturates(&self) -> bool {
        false
    }

    /// Whether the effect works by noise and scatter, not by a response.
    fn scatters(&self) -> bool {
        self.entry().only_scatters
    }

    /// Where it shows.
    fn shows(&self) -> Shows {
        match (self.scatters(), self.makes_nonlinear()) {
            (true, _) => Shows::Noise,
            (_, true) => Shows::Harmonics,
            _ => Shows::Response,
        }
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

/// A start: members whose changes of the prediction span the screening fit.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Start {
    /// Parameter vectors, physical values.
    pub(crate) members: Vec<Vec<f64>>,
    /// Parameter that scales the change, if one does.
    pub(crate) amplitude: Option<usize>,
    /// The amplitude may change its sign.
    pub(crate) signed: bool,
}

impl Start {
    /// A shape whose size is not free.
    pub(crate) fn shape(parameters: Vec<f64>) -> Self {
        Self {
            members: vec![parameters],
            amplitude: None,
            signed: false,
        }
    }

    /// A shape with a factor of either sign.
    pub(crate) fn signed(parameters: Vec<f64>, amplitude: usize) -> Self {
        Self {
            members: vec![parameters],
            amplitude: Some(amplitude),
            signed: true,
        }
    }

    /// A shape with a positive factor.
    pub(crate) fn positive(parameters: Vec<f64>, amplitude: usize) -> Self {
        Self {
            members: vec![parameters],
            amplitude: Some(amplitude),
            signed: false,
        }
    }

    /// The first member with its amplitude multiplied.
    pub(crate) fn scaled(&self, factor: f64) -> Vec<f64> {
        let mut parameters = self.members[0].clone();
        if let Some(index) = self.amplitude {
            parameters[index] *= factor;
        }
        parameters
    }
}

/// `count` values from `low` to `high` in equal ratios.
pub(crate) fn ratios(low: f64, high: f64, count: usize) -> Vec<f64> {
    (0..count)
        .map(|i| low * (high / low).powf(i as f64 / (count - 1).max(1) as f64))
        .collect()
}
