//! Stored records on the host: their hash chain and signatures, and records to try things with.
#![forbid(unsafe_code)]

pub mod hash_chain;
pub mod origin;
pub mod sample;
pub mod signature;
