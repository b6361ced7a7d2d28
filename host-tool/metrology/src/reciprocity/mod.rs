//! Sensitivity of the reference by reciprocity: a mass and the ratio of two voltages, and no other standard.
//!
//! # Equation
//! A coil in a field of force factor Bl moves a mechanical impedance Zm: `a = jw Bl i / Zm`, and its voltage is
//! `u = (Zb + Bl^2/Zm) i` with the blocked impedance Zb. With `r = X/I` (reference's output over current),
//! `Z = U/I`, and a mass dm on the table in one of two loads, `Zm1 - Zm0 = jw dm`, Zb and Bl cancel:
//!
//! ```text
//! S1^2 = - dm r0 r1 / (jw (Z1 - Z0))
//! ```
//!
//! A run of the instrument with a shunt in place of the device gives `I Rs/X`, one with a divider at the coil
//! `U D/X`, both as voltage ratios: the stated sensitivity of the reference is taken out of the record again. The
//! derivation with all corrections is in `docs/metrology/reciprocity.md`.
//!
//! | module | subject |
//! |---|---|
//! | [`Equipment`] | mass, shunt, divider, and what is known of them |
//! | [`Runs`] | the ten runs of a check, from readings or records |
//! | [`evaluate`] | S1 over frequency with its budget, or why the data speak against the model |
//! | [`change`] | one statistic against a baseline or against the certificate |

mod budget;
mod change;
mod equipment;
mod evaluate;
mod model;
mod report;
mod runs;

pub use budget::{Row, Spread};
pub use change::{Against, Change, STATISTIC_HZ, change, from_certificate};
pub use equipment::Equipment;
pub use evaluate::{CheckPoint, Evaluation, evaluate};
pub use model::Identified;
pub use report::{about_the_ratio, change_text, report};
pub use runs::{Certified, Pair, RatioRow, Reading, RunError, Runs, STEPS, Step, levels};

use thiserror::Error;

/// Why a check states nothing.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum ReciprocityError {
    /// The runs are no check.
    #[error(transparent)]
    Runs(#[from] RunError),
    /// The bare calibrator is not what it was.
    #[error(
        "at {frequency_hz} Hz the calibrator without the mass gave {change_percent:+.2} % after it against before: \
         something moved or a connection changed"
    )]
    Bracket {
        /// Frequency, Hz.
        frequency_hz: f64,
        /// By how much, %.
        change_percent: f64,
    },
    /// The mountings of the mass differ.
    #[error(
        "at {frequency_hz} Hz the mountings of the mass differ by {spread_percent:.2} %: is it seated?"
    )]
    Mountings {
        /// Frequency, Hz.
        frequency_hz: f64,
        /// Greatest difference, %.
        spread_percent: f64,
    },
    /// No mass, spring and damper move like that.
    #[error(
        "at {frequency_hz} Hz the motion is {residual_percent:.1} % off that of a mass on a spring: the suspension \
         is not linear or not the same with the mass, or the mass is not what was stated"
    )]
    Mechanics {
        /// Frequency, Hz.
        frequency_hz: f64,
        /// Residual, %.
        residual_percent: f64,
    },
    /// The square of a sensitivity with another phase than that of the reference.
    #[error(
        "at {frequency_hz} Hz the phase is {phase_deg:+.1} degrees off that of the reference: shunt or divider are \
         not what they were said to be, or the exciter is not reciprocal"
    )]
    Phase {
        /// Frequency, Hz.
        frequency_hz: f64,
        /// Difference, degrees.
        phase_deg: f64,
    },
    /// The result over the certificate is another at each frequency.
    #[error(
        "the result over the certificate is {spread_percent:.2} % off its mean at {frequency_hz} Hz: the data speak \
         against the reciprocal model"
    )]
    Flatness {
        /// Frequency, Hz.
        frequency_hz: f64,
        /// By how much, %.
        spread_percent: f64,
    },
}

#[cfg(test)]
mod tests;
