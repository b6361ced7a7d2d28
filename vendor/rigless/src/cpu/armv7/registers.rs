// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! `FPSCR`'s bit fields, by hand from ARM DDI 0403E.b, and the functions that read and write a
//! field of any register.
//!
//! The core works in 32-bit words, so [`mask`], [`get`], [`set`] and [`is_set`] answer in `u32`.

use crate::soc::{Access, FieldSpec};

#[expect(
    clippy::cast_possible_truncation,
    reason = "every field here is of a 32-bit register, and a const fn has no try_from"
)]
const fn word(value: u64) -> u32 {
    value as u32
}

/// The bits `field` occupies.
pub(crate) const fn mask(field: &FieldSpec) -> u32 {
    word(field.mask())
}

/// `field`'s value within `value`.
pub(crate) const fn get(field: &FieldSpec, value: u32) -> u32 {
    word(field.get(value as u64))
}

/// `value` with `field` replaced by `to`.
pub(crate) const fn set(field: &FieldSpec, value: u32, to: u32) -> u32 {
    word(field.set(value as u64, to as u64))
}

/// Whether any bit of `field` is set in `value`.
pub(crate) const fn is_set(field: &FieldSpec, value: u32) -> bool {
    field.is_set(value as u64)
}

/// `FPSCR`'s fields, A2.5.3.
pub(crate) mod fpscr {
    use super::{Access, FieldSpec};
    pub(crate) const N: &FieldSpec = &FieldSpec::new("N", 31, 1, Access::ReadWrite);
    pub(crate) const Z: &FieldSpec = &FieldSpec::new("Z", 30, 1, Access::ReadWrite);
    pub(crate) const C: &FieldSpec = &FieldSpec::new("C", 29, 1, Access::ReadWrite);
    pub(crate) const V: &FieldSpec = &FieldSpec::new("V", 28, 1, Access::ReadWrite);
    pub(crate) const AHP: &FieldSpec = &FieldSpec::new("AHP", 26, 1, Access::ReadWrite);
    pub(crate) const DN: &FieldSpec = &FieldSpec::new("DN", 25, 1, Access::ReadWrite);
    pub(crate) const FZ: &FieldSpec = &FieldSpec::new("FZ", 24, 1, Access::ReadWrite);
    pub(crate) const RMODE: &FieldSpec = &FieldSpec::new("RMode", 22, 2, Access::ReadWrite);
    pub(crate) const STRIDE: &FieldSpec = &FieldSpec::new("STRIDE", 20, 2, Access::ReadWrite);
    pub(crate) const LEN: &FieldSpec = &FieldSpec::new("LEN", 16, 3, Access::ReadWrite);
    pub(crate) const IDC: &FieldSpec = &FieldSpec::new("IDC", 7, 1, Access::ReadWrite);
    pub(crate) const IXC: &FieldSpec = &FieldSpec::new("IXC", 4, 1, Access::ReadWrite);
    pub(crate) const UFC: &FieldSpec = &FieldSpec::new("UFC", 3, 1, Access::ReadWrite);
    pub(crate) const OFC: &FieldSpec = &FieldSpec::new("OFC", 2, 1, Access::ReadWrite);
    pub(crate) const DZC: &FieldSpec = &FieldSpec::new("DZC", 1, 1, Access::ReadWrite);
    pub(crate) const IOC: &FieldSpec = &FieldSpec::new("IOC", 0, 1, Access::ReadWrite);
}
