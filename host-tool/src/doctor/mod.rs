//! Finds obstacles between this computer and a calibrator, and the way out.
//!
//! Each [`Finding`] is one check: ports, rights, the answer, versions, the
//! clock. A check that cannot be made is a warning that says so.

mod clock;
mod device;
mod finding;
mod ports;

pub use finding::{Finding, State};

use crate::Device;
use calib_link::Address;

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
