//! Ranges of a rig's values, and what is said about a value outside of them.

use super::Rig;

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
        /// What the system said.
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

/// A value and where it may lie.
pub(super) struct Range {
    pub(super) parameter: String,
    pub(super) value: f64,
    pub(super) lowest: f64,
    pub(super) highest: f64,
}

impl Range {
    /// `lowest <= value <= highest`.
    pub(super) fn new(parameter: impl Into<String>, value: f64, lowest: f64, highest: f64) -> Self {
        Self {
            parameter: parameter.into(),
            value,
            lowest,
            highest,
        }
    }

    fn check(&self, file: &str) -> Result<(), RigError> {
        // NaN is in no range.
        if (self.lowest..=self.highest).contains(&self.value) {
            return Ok(());
        }
        Err(RigError::OutOfRange {
            file: file.to_owned(),
            parameter: self.parameter.clone(),
            value: self.value,
            range: format!("from {} to {}", self.lowest, self.highest),
        })
    }
}

impl Rig {
    /// Checks every value against its range.
    pub(super) fn validate(&self, file: &str) -> Result<(), RigError> {
        let parts = [
            self.converter.ranges(),
            self.amplifier.ranges(),
            self.exciter.ranges(),
            self.reference.ranges("reference"),
            self.dut.ranges("dut"),
            self.certificate.ranges(),
            self.surroundings.ranges(),
        ];
        parts
            .iter()
            .flatten()
            .try_for_each(|range| range.check(file))?;
        self.check_orders(file)?;
        self.check_causality(file)
    }

    fn check_causality(&self, file: &str) -> Result<(), RigError> {
        let model = self.model();
        if model.reference.is_causal() && model.dut.is_causal() {
            return Ok(());
        }
        Err(RigError::NotCausal {
            file: file.to_owned(),
        })
    }

    /// A Butterworth filter is built from second-order sections.
    fn check_orders(&self, file: &str) -> Result<(), RigError> {
        let converter = &self.converter;
        for (parameter, order) in [
            (
                "converter.reconstruction_order",
                converter.reconstruction_order,
            ),
            ("converter.anti_alias_order", converter.anti_alias_order),
        ] {
            if order % 2 != 0 {
                return Err(RigError::OutOfRange {
                    file: file.to_owned(),
                    parameter: parameter.to_owned(),
                    value: f64::from(order),
                    range: "even".to_owned(),
                });
            }
        }
        Ok(())
    }
}
