//! The digital twin: simulated physics and the emulated board that runs the shipping firmware.
//!
//! - [`rig`]: the parameters of a simulated calibrator, read from a file or drawn by seed.
//! - [`model`]: what a calibrator is made of, with everything effects may change.
//! - [`effects`]: what real calibrators do beside, one file each.
//! - [`faults`]: what happens to them on site, from an instant on.
//! - [`steady`]: a model at one frequency once all has settled.
//! - [`oscillator`]: a single oscillator in time.
//! - [`dataset`]: gap datasets of known cause.
//! - [`reciprocity`]: checks of the reference by reciprocity, drawn with all that is unkind to them.
//! - [`plant`]: its physics in the time domain, with the converters.
//! - [`oracle`]: the truth about it, by formulas in the frequency domain.
//! - [`influence`]: rigs that are wrong in every way an uncertainty budget admits.
//! - [`rig_port`]: the seam between plant and board.
//! - [`board`]: the emulated board, by its schematic.
//! - [`runner`]: runs an image on the board, step by step or paced.
//! - [`usb_host`]: a USB host for the board.
//!
//! Nothing here depends on `calib-core`: what judges shares no code with what it judges.

pub mod board;
pub mod converters;
pub mod dataset;
pub mod effects;
pub mod faults;
pub mod influence;
pub mod model;
pub mod oracle;
pub mod oscillator;
pub mod plant;
pub mod reciprocity;
pub mod rig;
pub mod rig_port;
pub mod runner;
pub mod steady;
pub mod usb_host;

pub use nalgebra::Complex;
