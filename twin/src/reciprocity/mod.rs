//! Checks of the reference by reciprocity on calibrators that are wrong in every way known.
//!
//! - [`distributions`]: what is drawn, from where to where, and why: the one table.
//! - [`SelfCheckDraw`]: a calibrator with shunt, divider and mass, as they are and as they are stated.
//! - [`response`]: device's input over reference's, in steady state, by impedances.
//! - [`session`]: the runs of a check, one after another, while the coil warms and cools.
//!
//! Nothing here forms a sensitivity from a mass: currents, voltages and motions follow from the physics
//! of each load, and the truth from the reference. The plant in time agrees: test
//! `the_plant_with_a_mass_agrees_with_its_impedances`.

pub mod distributions;
mod draw;
pub mod response;
pub mod session;

pub use draw::{Hold, Mounting, SelfCheckDraw, Stated};
