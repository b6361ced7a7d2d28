//! What stands between this computer and a calibrator, and the way out.
//!
//! Each [`Finding`] is one check: ports, rights, the answer, versions, the
//! clock. A check that cannot be made is a warning that says so.

mod clock;
mod device;
mod ports;

use crate::Device;
use calib_link::Address;
use serde::Serialize;

/// How a check ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum State {
    /// As it should be.
    Good,
    /// Not what is usual; measuring may still work.
    Warning,
    /// Measuring will not work.
    Failed,
}

/// One check.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Finding {
    /// What was looked at.
    pub check: &'static str,
    /// How it ended.
    pub state: State,
    /// What was found.
    pub finding: String,
    /// What to do about it; empty when there is nothing to do.
    pub remedy: String,
}

impl Finding {
    fn new(check: &'static str, state: State, finding: impl Into<String>) -> Self {
        Self {
            check,
            state,
            finding: finding.into(),
            remedy: String::new(),
        }
    }

    fn with_remedy(self, remedy: impl Into<String>) -> Self {
        Self {
            remedy: remedy.into(),
            ..self
        }
    }
}

/// Looks at everything. `address` is the calibrator that was named, else the
/// likely ports are asked.
pub fn examine(address: Option<&Device>) -> Vec<Finding> {
    let mut findings = vec![clock::check(jiff::Timestamp::now())];
    let ports = calib_link::port::list();
    findings.extend(ports::check(&ports, address));
    let asked: Vec<Device> = match address {
        Some(address) => vec![address.clone()],
        None => ports
            .iter()
            .filter(|port| port.likely)
            .map(|port| Device::At(Address::Serial(port.name.clone())))
            .collect(),
    };
    findings.extend(asked.iter().flat_map(device::check));
    findings
}
