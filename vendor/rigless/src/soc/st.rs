// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! The peripherals ST builds into more than one of its parts, written once.
//!
//! A model here is generic over a part's own generated layout. It reaches the registers and fields
//! both manuals name alike through a trait the part implements, or by name with
//! [`crate::soc::field_of`], and takes what a part's silicon decides from the part that builds it.
//! Where two manuals give a peripheral the same registers and the same behavior, it's one model.

pub mod dma;
pub mod gpio;
pub mod tim;
