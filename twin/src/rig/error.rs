//! Why a rig file was not accepted.

/// Why a rig file was not accepted.
#[derive(Debug, thiserror::Error)]
pub enum RigError {
    /// The file cannot be read.
    #[error(
        "cannot read rig file {file}: {source}; give the path of a rig file, or none for the standard rig"
    )]
    Unreadable {
        /// File as it was named.
        file: String,
        /// Error of the system.
        source: std::io::Error,
    },
    /// The text is no rig.
    #[error("rig file {file} is not understood: {source}")]
    Malformed {
        /// File as it was named.
        file: String,
        /// Line, column and reason.
        source: Box<toml::de::Error>,
    },
    /// A value lies outside of its range.
    #[error("rig file {file}: {parameter} = {value} must be {range}")]
    OutOfRange {
        /// File as it was named.
        file: String,
        /// Table and key.
        parameter: String,
        /// The value found.
        value: f64,
        /// The range in words.
        range: String,
    },
    /// An effect that no rig in time has.
    #[error(
        "rig file {file}: coupling with a constant phase angle (quadrature) has no causal network; \
         use in_phase or inverse_fx_s of crosstalk on a rig that runs in time"
    )]
    NotCausal {
        /// File as it was named.
        file: String,
    },
}
