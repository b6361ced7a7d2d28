// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! What fetches were checked against when a block was translated, as a number in its key.
//!
//! B3.5.3: whether a fetch is allowed hangs on the MPU's registers and, while it's on, on the
//! privilege and on the execution priority being below 0. Each such combination is a space, and a
//! block stands for as long as its bytes do, in its own space. Its exits lead to blocks of the same
//! space, since everything that leaves it, an exception, a write to the system control space or to
//! the masks, goes through the run loop, which looks the next block up in the space it finds then.

use super::mpu::{Context, InForce, Mpu};

/// Where a space's number is in a block's key, above everything [`super::translate::block_key`]
/// puts there and the bit of a breakpoint.
const SHIFT: u32 = 52;

/// The most spaces there are at once. A block's key stays positive as an `i64`.
const MOST: usize = 1 << 10;

/// A space, as it's found again.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Space {
    /// What it adds to a block's key.
    pub(crate) key: u64,
    /// What its fetches are checked in.
    pub(crate) context: Context,
}

impl Space {
    /// The space while the MPU is off: the default map answers every context alike.
    pub(crate) const OFF: Self = Self {
        key: 0,
        context: Context {
            privileged: true,
            below_priority_zero: false,
        },
    };
}

/// The spaces blocks were translated in.
#[derive(Debug, Default)]
pub(crate) struct Spaces {
    /// Every space but that of an MPU that's off, whose number is 0.
    known: Vec<(InForce, Context)>,
}

impl Spaces {
    /// The space of what `mpu` says in `context`, or nothing when there are too many of them.
    pub(crate) fn find(&mut self, mpu: &Mpu, context: Context) -> Option<Space> {
        let Some(in_force) = mpu.in_force() else {
            return Some(Space::OFF);
        };
        let is = |known: &(InForce, Context)| known.1 == context && known.0 == in_force;
        let place = match self.known.iter().position(is) {
            Some(place) => place,
            None if self.known.len() + 1 < MOST => {
                self.known.push((in_force, context));
                self.known.len() - 1
            }
            None => return None,
        };
        Some(Space {
            key: (place as u64 + 1) << SHIFT,
            context,
        })
    }

    /// Forgets every space, once no block is left.
    pub(crate) fn clear(&mut self) {
        self.known.clear();
    }
}
