//! The parts of the firmware that know no hardware: what a request does, who
//! may ask for it, how a link is served, how the journal lies in flash, what a
//! capture keeps. They run on the host too, where their tests are.
#![cfg_attr(not(test), no_std)]
#![forbid(unsafe_code)]

pub mod archive;
pub mod capture;
pub mod command;
pub mod link;
pub mod scpi;
pub mod session;
