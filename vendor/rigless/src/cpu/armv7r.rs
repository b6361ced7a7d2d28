// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! The ARMv7-R core, written from ARM DDI 0406C, the ARMv7-A and ARMv7-R Architecture Reference
//! Manual, and DDI 0460D, the Cortex-R5 Technical Reference Manual, for what the Cortex-R5 picks
//! where the architecture leaves a choice.
//!
//! It runs ARM and Thumb code. The Thumb instructions both profiles have, and their lowering, are
//! [`crate::cpu::armv7`]'s, and the core's own state, banks, system registers and decode are here.

mod cp15;
mod exception;
mod family;
#[cfg(feature = "tms570lc4357")]
pub(crate) use family::{MpuRegions, Options, PortRegion, Ties};
mod mpu;
mod registers;
mod state;
mod translate;
#[cfg(any(test, fuzzing))]
pub(crate) use translate::testing;

/// The core a part's ties describe, out of reset, for a machine's
/// [`CoreSpec::processor`](crate::emulator::CoreSpec::processor).
///
/// # Errors
///
/// [`Error::Machine`](crate::emulator::Error::Machine) for a host the code generator can't
/// generate code for.
#[cfg(feature = "tms570lc4357")]
pub(crate) fn processor(
    ties: Ties,
) -> Result<Box<dyn crate::emulator::Processor>, crate::emulator::Error> {
    Ok(family::Family::new(ties)?)
}
