//! The host's metrology against numbers others published, and known truths.

mod budget;
mod coverage;
mod ea_4_02;
mod identify;
mod linking;
mod monte_carlo;
mod sensitivity;
mod shared;
mod shock;
