//! What a fit moves that is no effect: gains, nominal values of the exciter, healthy noise.

use crate::dataset::{Exciter, Measurand, Rig};
use crate::effects::Facts;
use crate::model::row::Row;

/// A parameter of the simulation that is not an effect, in units of its uncertainty.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Nuisance {
    /// Gain of the ratio.
    RatioGain,
    /// Gain of the drive.
    DriveGain,
    /// One of the six exciter values.
    Exciter(usize),
    /// Gain of the reference in a run.
    RunReference(usize),
    /// Gain of the device under test in a run.
    RunDut(usize),
    /// Noise of a healthy channel.
    Noise(usize),
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
    let mut free = Vec::new();
    let relative = |t: Option<crate::dataset::Transducer>| {
        t.and_then(|t| t.sensitivity_v_per_ms2)
            .map(|q| q.u / q.value)
    };
    let (s1, s2) = (relative(rig.reference), relative(rig.dut));
    let unbounded = |kind| Free {
        kind,
        unit: 0.01,
        bounded: false,
    };
    if facts.ratio {
        free.push(match (rig.measurand, s1.zip(s2)) {
            (Measurand::Drive, Some((a, b))) => Free {
                kind: Nuisance::RatioGain,
                unit: a.hypot(b),
                bounded: true,
            },
            _ => unbounded(Nuisance::RatioGain),
        });
    }
    if facts.drive {
        free.push(match (rig.measurand, s1) {
            (Measurand::DutSensitivity, Some(u)) => Free {
                kind: Nuisance::DriveGain,
                unit: u,
                bounded: true,
            },
            _ => unbounded(Nuisance::DriveGain),
        });
    }
    if facts.drive || facts.current {
        let values = rig
            .exciter
            .and_then(|e| e.complete())
            .unwrap_or_default_units();
        for (i, unit) in values.into_iter().enumerate() {
            free.push(Free {
                kind: Nuisance::Exciter(i),
                unit,
                bounded: true,
            });
        }
    }
    let runs = rows.iter().map(|r| r.run).max().unwrap_or(0) + 1;
    for run in 0..runs {
        if facts.ratio || facts.drive {
            free.push(Free {
                kind: Nuisance::RunReference(run),
                unit: rig.repeatability.reference_gain,
                bounded: true,
            });
        }
        if facts.ratio {
            free.push(Free {
                kind: Nuisance::RunDut(run),
                unit: rig.repeatability.dut_gain,
                bounded: true,
            });
        }
    }
    // One noise is stated for both channels: whether its error is shared is not said. With
    // twice the variance in each, the mean of both has the stated uncertainty.
    let shared = if facts.ref_noise && facts.dut_noise {
        std::f64::consts::SQRT_2
    } else {
        1.0
    };
    let noise = shared * rig.digitiser.noise_v.map_or(0.0, |q| q.u / q.value);
    if facts.ref_noise {
        free.push(Free {
            kind: Nuisance::Noise(0),
            unit: noise,
            bounded: true,
        });
    }
    if facts.dut_noise {
        free.push(Free {
            kind: Nuisance::Noise(1),
            unit: noise,
            bounded: true,
        });
    }
    free.retain(|f| f.unit > 0.0);
    free
}

/// Relative uncertainties of the exciter entries.
trait RelativeUnits {
    fn unwrap_or_default_units(self) -> [f64; 6];
}

impl RelativeUnits for Option<[crate::dataset::Quantity; 6]> {
    fn unwrap_or_default_units(self) -> [f64; 6] {
        self.map_or([0.0; 6], |e| e.map(|q| q.u / q.value))
    }
}

/// Factor on a value for a relative change; large uncertainties stay positive.
pub(super) fn stretched(change: f64, u: f64) -> f64 {
    if u > 0.3 {
        change.exp()
    } else {
        (1.0 + change).max(0.02)
    }
}

/// Its slope.
pub(super) fn stretched_slope(change: f64, u: f64) -> f64 {
    if u > 0.3 {
        change.exp()
    } else if 1.0 + change > 0.02 {
        1.0
    } else {
        0.0
    }
}

/// Names of the nominal parameters in JSON, in the order of the nuisances of the exciter.
pub(crate) const EXCITER_NAMES: [&str; 6] = Exciter::NAMES;
