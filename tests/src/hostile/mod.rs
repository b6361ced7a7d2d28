//! Bytes of any kind against the decoder, the command layer, records, the host's
//! client and its readers of files: what must hold whatever they are.
//!
//! Each function is the body of a fuzz target in `fuzz/` and panics when
//! something does not hold; `tests/fuzz_smoke.rs` runs the same bodies on
//! mutated seeds with a stable compiler.

mod client;
mod commands;
pub mod files;
mod frames;
mod mutate;
mod records;
mod seeds;

pub use client::client;
pub use commands::{Heard, commands, heard, info};
pub use frames::{Whole, framed, frames, whole_frames};
pub use mutate::Mutator;
pub use records::records;
pub use seeds::Seed;

/// All seeds, as they lie in `fuzz/corpus`.
pub fn seeds() -> Vec<Seed> {
    let mut all = seeds::seeds();
    all.extend(files::seeds());
    all
}
