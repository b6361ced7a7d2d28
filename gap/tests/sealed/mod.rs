//! Sealed cases: a rig in the time domain, written apart from the diagnosis.
//!
//! Nothing here is shared with the crate under test. The nonlinear exciter is
//! solved by collocation: the motion at equidistant instants of one period is
//! the unknown, derivatives are spectral, and the coil voltage is a pure sine.

pub(crate) mod cases;
pub(crate) mod collocation;
pub(crate) mod design;
pub(crate) mod oscillator;
pub(crate) mod random;
pub(crate) mod rig;
