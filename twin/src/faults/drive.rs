//! Faults of the power amplifier and of the cable to the coil.

/// A fault between drive converter and coil.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DriveFault {
    /// The voltage is this factor wrong from an instant on; 0 is none at all.
    Gain {
        /// From when on, s.
        at_s: f64,
        /// Factor.
        factor: f64,
    },
    /// The voltage saturates from an instant on.
    Clipping {
        /// From when on, s.
        at_s: f64,
        /// V peak.
        threshold_v: f64,
    },
}

impl DriveFault {
    /// Volts behind the fault at `elapsed_s`.
    pub(super) fn volt(&self, volt: f64, elapsed_s: f64) -> f64 {
        match *self {
            Self::Gain { at_s, factor } if elapsed_s >= at_s => factor * volt,
            Self::Clipping { at_s, threshold_v } if elapsed_s >= at_s => {
                volt.clamp(-threshold_v, threshold_v)
            }
            _ => volt,
        }
    }
}
