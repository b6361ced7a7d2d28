// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
#![doc = include_str!("stm32h743/README.md")]

#[rustfmt::skip]
pub mod generated;

mod memory_map;
pub mod peripherals;

pub use memory_map::{CPU, MEMORY, builder};
pub use peripherals::Stm32h743;
