//! Response of a linear exciter, or a balanced one, at the fundamental.

use super::complex::ln;
use super::exciter::{ExciterSlopes, Linear};
use num_complex::Complex64;

/// Responses of the fundamental to the coil voltage.
#[derive(Debug, Clone, Copy)]
pub(super) struct Fundamental {
    /// Logarithms of acceleration and of current over coil voltage.
    pub(super) ln: [Complex64; 2],
    /// Their slopes against the values of the exciter.
    pub(super) slopes: ExciterSlopes,
}

impl Fundamental {
    pub(super) fn new(linear: &Linear) -> Self {
        Self {
            ln: [ln(linear.acceleration_per_v), ln(linear.admittance)],
            slopes: linear.slopes,
        }
    }
}
