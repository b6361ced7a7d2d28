//! Free values of a fit that are no effect: gains, nominal values of the exciter, healthy noise.

use crate::dataset::{ExciterParameter, Measurand, Quantity, Repeatability, Rig, Transducer};
use crate::model::facts::Facts;
use crate::model::row::Row;
use crate::observable::Channel;
use crate::thresholds;
use std::f64::consts::SQRT_2;

/// A parameter of the simulation that is not an effect, in units of its uncertainty.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Nuisance {
    /// Gain of the ratio.
    RatioGain,
    /// Gain of the drive.
    DriveGain,
    /// A value of the exciter.
    Exciter(ExciterParameter),
    /// Gain of the reference in a run.
    RunReference(usize),
    /// Gain of the device under test in a run.
    RunDut(usize),
    /// Noise of a healthy channel.
    Noise(Channel),
}

/// A nuisance with its prior.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Free {
    pub(crate) kind: Nuisance,
    /// Relative standard uncertainty, the unit of the parameter.
    pub(crate) unit: f64,
    /// Whether a prior of one unit holds; the measurand has none.
    pub(crate) bounded: bool,
}

impl Free {
    /// With a prior of the relative standard uncertainty `unit`.
    fn known(kind: Nuisance, unit: f64) -> Self {
        Self {
            kind,
            unit,
            bounded: true,
        }
    }

    /// Without a prior, in units of 1 %.
    fn unknown(kind: Nuisance) -> Self {
        Self {
            kind,
            unit: 0.01,
            bounded: false,
        }
    }

    /// Most that one step may change it, in its unit. A value of the exciter turns the shape of
    /// the response, which slopes foresee for a while only; a gain just shifts it, and a run's may
    /// have taken on a drift hundreds of its units wide before the drift was among the effects.
    pub(crate) fn longest_step(&self) -> f64 {
        match self.kind {
            _ if !self.bounded => 200.0,
            Nuisance::Exciter(_) => 10.0,
            _ => 10.0_f64.max(0.5 / self.unit),
        }
    }
}

/// The nuisances of a rig for what was measured; exact values are none.
pub(super) fn nuisances(rig: &Rig, rows: &[Row], facts: &Facts) -> Vec<Free> {
    let mut free: Vec<Free> = gains(rig, facts).collect();
    if facts.drive || facts.current {
        free.extend(exciter(rig));
    }
    free.extend(gains_of_runs(rig, rows, facts));
    free.extend(noises(rig, facts));
    free.retain(|f| f.unit > 0.0);
    free
}

/// Gains of ratio and drive; the one that is measured has no prior, nor has one of an unknown sensitivity.
fn gains(rig: &Rig, facts: &Facts) -> impl Iterator<Item = Free> {
    let relative = |t: Option<Transducer>| t?.sensitivity_v_per_ms2.map(Quantity::relative_u);
    let (s1, s2) = (relative(rig.reference), relative(rig.dut));
    let ratio = match (rig.measurand, s1.zip(s2)) {
        (Measurand::Drive, Some((a, b))) => Free::known(Nuisance::RatioGain, a.hypot(b)),
        _ => Free::unknown(Nuisance::RatioGain),
    };
    let drive = match (rig.measurand, s1) {
        (Measurand::DutSensitivity, Some(u)) => Free::known(Nuisance::DriveGain, u),
        _ => Free::unknown(Nuisance::DriveGain),
    };
    let ratio = facts.ratio.then_some(ratio);
    ratio
        .into_iter()
        .chain(facts.drive_modulus.then_some(drive))
}

/// The values of a complete exciter.
fn exciter(rig: &Rig) -> impl Iterator<Item = Free> {
    let values = rig.exciter.and_then(|e| e.complete());
    values.into_iter().flat_map(|values| {
        let known = move |p| Free::known(Nuisance::Exciter(p), values[p].relative_u());
        ExciterParameter::ALL.map(known)
    })
}

/// Scatter between runs by the repeatability of both channels.
fn gains_of_runs(rig: &Rig, rows: &[Row], facts: &Facts) -> impl Iterator<Item = Free> {
    let Repeatability {
        reference_gain,
        dut_gain,
    } = rig.repeatability;
    let (ratio, drive) = (facts.ratio, facts.drive_modulus);
    let runs = rows.iter().map(|r| r.run).max().unwrap_or(0) + 1;
    (0..runs).flat_map(move |run| {
        let reference = Free::known(Nuisance::RunReference(run), reference_gain);
        let dut = Free::known(Nuisance::RunDut(run), dut_gain);
        let reference = (ratio || drive).then_some(reference);
        reference.into_iter().chain(ratio.then_some(dut))
    })
}

/// Noise of the healthy channels.
fn noises(rig: &Rig, facts: &Facts) -> impl Iterator<Item = Free> {
    let measured = [facts.ref_noise, facts.dut_noise];
    // One noise is stated for both channels: whether its error is shared is not said. With
    // twice the variance in each, the mean of both has the stated uncertainty.
    let shared = if measured == [true; 2] { SQRT_2 } else { 1.0 };
    let unit = shared * rig.digitiser.noise_v.map_or(0.0, Quantity::relative_u);
    let channels = Channel::BOTH.into_iter().zip(measured);
    let measured = channels.filter(|(_, measured)| *measured);
    measured.map(move |(channel, _)| Free::known(Nuisance::Noise(channel), unit))
}

/// Factor on a value for a relative change; large uncertainties stay positive.
pub(super) fn stretched(change: f64, u: f64) -> f64 {
    if u > thresholds::LARGE_U {
        change.exp()
    } else {
        (1.0 + change).max(thresholds::LEAST_FACTOR)
    }
}

/// Its slope.
pub(super) fn stretched_slope(change: f64, u: f64) -> f64 {
    if u > thresholds::LARGE_U {
        change.exp()
    } else if 1.0 + change > thresholds::LEAST_FACTOR {
        1.0
    } else {
        0.0
    }
}
