//! The drive output at both inputs, as the ratio of the channels is measured.

use serde::{Deserialize, Serialize};

use super::range::Range;

/// A divider from the drive output to both input connectors, in place of the transducers.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CommonSource {
    /// Volts at its tap for a volt of the drive.
    pub volt_per_v: f64,
    /// By how much each lead's end is above the tap, relative: at the reference's input, at the
    /// device's. Leads that are exchanged exchange these.
    pub leads_rel: [f64; 2],
}

impl CommonSource {
    /// With the leads exchanged.
    pub fn exchanged(self) -> Self {
        let [reference, dut] = self.leads_rel;
        Self {
            leads_rel: [dut, reference],
            ..self
        }
    }

    /// Volts at each input for a volt of the drive.
    pub(crate) fn gains(&self) -> [f64; 2] {
        self.leads_rel
            .map(|excess| self.volt_per_v * (1.0 + excess))
    }

    pub(super) fn ranges(&self) -> Vec<Range> {
        let range = |name: &str, value, lowest, highest| {
            Range::new(format!("common_source.{name}"), value, lowest, highest)
        };
        let lead = |value| range("leads_rel", value, -0.5, 0.5);
        let [reference, dut] = self.leads_rel;
        vec![
            range("volt_per_v", self.volt_per_v, 1e-6, 1e3),
            lead(reference),
            lead(dut),
        ]
    }
}
