//! The host's metrology against numbers others published, and known truths.

mod bad_input;
mod budget;
mod coverage;
mod documentation;
mod ea_4_02;
mod identify;
mod linking;
mod monte_carlo;
mod sensitivity;
mod shared;
mod shock;
