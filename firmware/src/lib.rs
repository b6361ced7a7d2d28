//! The parts of the firmware that know no hardware: what a request does, who
//! may ask for it, what a press means, how a link is served, how the journal
//! lies in flash, what a capture keeps, when one more restart is not tried, how
//! the lamps say so. They run on the host too, where their
//! tests are.
#![cfg_attr(not(test), no_std)]
#![forbid(unsafe_code)]

// Tests that a bench shares call this crate by its name.
#[cfg(test)]
extern crate self as calib_firmware;

pub mod archive;
pub mod button;
pub mod capture;
pub mod clock;
pub mod command;
pub mod device_key;
pub mod lamps;
pub mod lease;
pub mod link;
pub mod restarts;
pub mod scpi;
pub mod session;
