//! Faults of a rig on site, each from an instant on.
//!
//! An effect is a property a rig has; a fault happens to it. Faults act at three places: on the drive
//! before the coil, on the body that moves, and on the volts at an input connector. Their files are in
//! [`crate::effects::fault`].

mod body;
mod channel;
mod drive;

pub use body::BodyFault;
pub use channel::{ChannelFaults, Contact, Fade, Surge};
pub use drive::DriveFault;

use crate::rig_port::INPUT_CHANNELS;

/// All faults of a rig; none by default.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Faults {
    /// Reference, device under test.
    pub channels: [ChannelFaults; INPUT_CHANNELS],
    /// Between drive converter and coil.
    pub drive: Vec<DriveFault>,
    /// Of what moves.
    pub body: Vec<BodyFault>,
    /// From an instant on, s, the processor has this temperature, degrees Celsius.
    pub processor_c: Option<(f64, f64)>,
}

impl Faults {
    /// The faults of the channel a parameter selects: 0 reference, 1 device under test.
    pub(crate) fn channel(&mut self, selector: f64) -> &mut ChannelFaults {
        &mut self.channels[usize::from(selector >= 0.5)]
    }

    /// Volts at the coil for `drive_v` demanded at `elapsed_s`.
    pub(crate) fn drive_v(&self, drive_v: f64, elapsed_s: f64) -> f64 {
        self.drive
            .iter()
            .fold(drive_v, |volt, fault| fault.volt(volt, elapsed_s))
    }
}
