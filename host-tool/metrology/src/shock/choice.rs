//! Choices of a user for an identification from a shock.

/// Options of the fit.
#[derive(Clone, Copy, Debug, Default)]
pub struct Choice {
    /// Lowest frequency, Hz; default the first bin.
    pub from_hz: Option<f64>,
    /// Highest frequency, Hz; default where the input's spectrum has fallen
    /// to a tenth.
    pub to_hz: Option<f64>,
    /// Stated u0 of (27); default from the residuals.
    pub u0: Option<f64>,
    /// Pre-warp the mapping.
    pub prewarp: bool,
    /// Delay of the input channel behind the output channel that the
    /// measuring chains are known to have, s (8.2).
    pub input_delay_s: f64,
}
