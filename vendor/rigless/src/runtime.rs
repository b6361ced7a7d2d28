// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! The runtime: what every SoC and machine is built on, and the emulator it runs in.

pub mod coverage;
pub mod device;
pub mod elf;
pub mod emulator;
pub mod image;
pub mod link;
pub mod mcu;
pub mod session;
pub mod snapshot;
pub mod symbols;
pub mod time;
pub mod version;
