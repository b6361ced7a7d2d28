// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! What both families' memory paths share: an access of the guest's memory, and reading and
//! writing the host's copy of it where the page table maps it.
#![expect(
    unsafe_code,
    reason = "a family reads and writes the guest's memory where its page table maps it"
)]

use super::translate::Size;
use crate::soc::Endian;

/// One access of the guest's memory: where, how wide, and the value a store writes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Request {
    pub(crate) address: u32,
    pub(crate) size: Size,
    pub(crate) write: Option<u32>,
}

impl Request {
    pub(crate) fn read(address: u32, size: Size) -> Self {
        Self {
            address,
            size,
            write: None,
        }
    }

    /// A store of `value`'s low `size` bytes, which is all a narrow store writes, A7.7.160 and the
    /// rest. A caller may hand over the whole register.
    pub(crate) fn write(address: u32, size: Size, value: u32) -> Self {
        Self {
            address,
            size,
            write: Some(value & size.low_bytes()),
        }
    }
}

/// Reads `size` bytes of the guest's memory at `host`, in the order `endian`.
///
/// # Safety
///
/// `host` is what `Pages::host` answered for the address read, and that address is aligned to
/// `size`, so the bytes are inside one mapped page.
pub(crate) unsafe fn read_host(host: *mut u8, size: Size, endian: Endian) -> u32 {
    let mut bytes = [0; 4];
    let count = size.bytes() as usize;
    // SAFETY: the caller's promise puts the `count` bytes at `host` inside a mapped page.
    unsafe { std::ptr::copy_nonoverlapping(host, bytes.as_mut_ptr(), count) };
    u32::try_from(crate::emulator::memory::from_target(
        &bytes[..count],
        endian,
    ))
    .expect("four bytes at most")
}

/// Writes the low `size` bytes of `value` to the guest's memory at `host`, in the order `endian`.
///
/// # Safety
///
/// `host` is what `Pages::host` answered for the address written, that address is aligned to
/// `size`, so the bytes are inside one mapped page, and `Pages::host` said the page is writable.
pub(crate) unsafe fn write_host(host: *mut u8, size: Size, value: u32, endian: Endian) {
    let count = size.bytes() as usize;
    let bytes = crate::emulator::memory::to_target(u64::from(value), count, endian);
    // SAFETY: the caller's promise puts the `count` bytes at `host` inside a writable mapped page.
    unsafe { std::ptr::copy_nonoverlapping(bytes.as_ptr(), host, count) };
}
