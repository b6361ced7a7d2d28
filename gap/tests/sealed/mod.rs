//! Sealed cases: a rig with its truth, written apart from the diagnosis.
//!
//! Nothing here is shared with the crate under test. The nonlinear exciter is
//! solved by collocation: the motion at equidistant instants of one period is
//! the unknown, derivatives are spectral, and the coil voltage is a pure sine.

mod characteristic;
pub(crate) mod design;
mod disturbed;
pub(crate) mod effects;
mod exciter;
pub(crate) mod oscillator;
pub(crate) mod random;
mod response;
pub(crate) mod scatter;
mod steady;
pub(crate) mod table;
pub(crate) mod truth;
