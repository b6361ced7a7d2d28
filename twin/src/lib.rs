//! The digital twin: simulated physics and the emulated board that runs the shipping firmware.
//!
//! - [`rig_port`]: the seam between the two.
//!
//! Nothing here depends on `calib-core`: what judges shares no code with what it judges.

pub mod rig_port;
