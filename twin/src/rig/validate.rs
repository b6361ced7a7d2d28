//! Whether a rig can be: every value in its range, orders even, networks causal.

use super::Rig;
use super::error::RigError;
use super::reciprocity;

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
            reciprocity::ranges(self),
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
