//! Serial ports, and whether this user may use them.

use super::finding::{Finding, State};
use crate::Device;
use calib_link::Address;
use calib_link::port::Port;

/// The rule that gives the user at the seat the right to the board's port
/// (udev(7); `uaccess` is set by systemd's 73-seat-late.rules, hence the 70).
/// The package for Debian installs the same file.
pub(super) const UDEV_RULE: &str = include_str!("../../packaging/70-calib.rules").trim_ascii();

pub(super) fn check(ports: &[Port], address: Option<&Device>) -> Vec<Finding> {
    let likely: Vec<&Port> = ports.iter().filter(|port| port.likely).collect();
    let found = match likely.as_slice() {
        [] => none(ports, address),
        [port] => Finding::new("ports", State::Good, describe(port)),
        several => {
            let names: Vec<_> = several.iter().map(|port| port.name.as_str()).collect();
            Finding::new("ports", State::Warning, names.join(", "))
                .with_remedy("more than one may be the calibrator: name one with --device")
        }
    };
    let named = match address {
        Some(Device::At(Address::Serial(name))) => vec![name.as_str()],
        Some(_) => Vec::new(),
        None => likely.iter().map(|port| port.name.as_str()).collect(),
    };
    let mut findings = vec![found];
    findings.extend(named.into_iter().map(rights));
    findings
}

fn none(ports: &[Port], address: Option<&Device>) -> Finding {
    let text = format!("no calibrator among {} serial ports", ports.len());
    match address {
        // Who named one does not need ours.
        Some(_) => Finding::new("ports", State::Good, text),
        None => Finding::new("ports", State::Warning, text).with_remedy(
            "plug the ST-LINK in with a cable that carries data; `--device emulated` needs none",
        ),
    }
}

fn describe(port: &Port) -> String {
    format!("{} {}", port.name, port.description)
        .trim()
        .to_owned()
}

#[cfg(unix)]
fn rights(name: &str) -> Finding {
    use rustix::fs::{Access, access};
    let good = || Finding::new("rights", State::Good, format!("{name} can be used"));
    match access(name, Access::READ_OK | Access::WRITE_OK) {
        Ok(()) => good(),
        Err(rustix::io::Errno::NOENT) => {
            Finding::new("rights", State::Failed, format!("there is no {name}"))
                .with_remedy("`calib devices` lists the ports")
        }
        Err(error) => Finding::new("rights", State::Failed, format!("{name}: {error}"))
            .with_remedy(permission_remedy()),
    }
}

#[cfg(not(unix))]
fn rights(name: &str) -> Finding {
    // Opening it will tell.
    Finding::new("rights", State::Good, format!("{name} is there"))
}

/// Command to type, once.
#[cfg(unix)]
fn permission_remedy() -> String {
    format!(
        "add the rule and plug the calibrator in again:\n\
         echo '{UDEV_RULE}' | sudo tee /etc/udev/rules.d/70-calib.rules\n\
         sudo udevadm control --reload\n\
         without a seat (ssh): sudo usermod -a -G dialout $USER, then log in again"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn port(name: &str, likely: bool) -> Port {
        Port {
            name: name.to_owned(),
            description: "STLink".to_owned(),
            usb_serial: None,
            likely,
        }
    }

    #[test]
    fn a_missing_port_and_two_candidates_are_told_apart() {
        let state = |ports: &[Port]| check(ports, None)[0].state;
        assert_eq!(state(&[]), State::Warning);
        assert_eq!(state(&[port("/dev/ttyS0", false)]), State::Warning);
        assert_eq!(state(&[port("/dev/null", true)]), State::Good);
        assert_eq!(state(&[port("a", true), port("b", true)]), State::Warning);
    }

    #[cfg(unix)]
    #[test]
    fn a_port_without_rights_gets_the_rule_and_a_missing_one_does_not() {
        let gone = rights("/dev/no-such-port");
        assert_eq!(gone.state, State::Failed);
        assert!(!gone.remedy.contains("udev"), "{gone:?}");
        assert_eq!(rights("/dev/null").state, State::Good);
        assert!(permission_remedy().contains(UDEV_RULE));
        // The rule names the vendor that ports are recognised by.
        assert!(UDEV_RULE.contains("0483") && UDEV_RULE.contains("uaccess"));
    }
}
