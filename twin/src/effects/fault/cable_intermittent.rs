//! A cable with a loose contact that vibration opens and closes.

use super::super::{Effect, Parameter, Stage};
use super::{AT_S, CHANNEL, FaultEffect};
use crate::faults::Contact;
/// See the module.
pub(super) const EFFECT: FaultEffect = Effect {
    id: "cable_intermittent",
    stage: Stage::Conditioning,
    formula: "signal interrupted rate_hz times a second from at_s on",
    parameters: &[
        CHANNEL,
        AT_S,
        Parameter::new("rate_hz", "Hz", [0.1, 1e4], 30.0),
        Parameter::new("open_fraction", "1", [0.0, 1.0], 0.3),
    ],
    apply: |values, faults| {
        faults.channel(values[0]).contact = Some(Contact {
            at_s: values[1],
            rate_hz: values[2],
            open_fraction: values[3],
        });
    },
};
