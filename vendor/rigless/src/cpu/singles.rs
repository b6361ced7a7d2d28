// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! The floating-point unit's arithmetic on singles, twice over: by [`software`], and by [`host`],
//! which asks the host's own unit first. A core with [`shortcuts`](crate::machine::armv7m::Config)
//! takes the second. They're here for a test that compares them: the result and `FPSCR` are the same
//! for all operands in every mode.

use rustc_apfloat::Round;

use super::armv7::fp::{self, Fixed};

/// One operation on up to three operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operation {
    /// `FPAdd()` of the first two.
    Add,
    /// `FPSub()`.
    Subtract,
    /// `FPMul()`.
    Multiply,
    /// `FPDiv()`.
    Divide,
    /// `FPSqrt()` of the first.
    SquareRoot,
    /// `FPMulAdd()`: the first plus the product of the others.
    MultiplyAdd,
    /// `FPCompare()` as VCMP has it, answering the flags.
    Compare,
    /// As VCMPE has it, to which a quiet NaN is invalid.
    CompareRaising,
    /// `FPMaxNum()`.
    Maximum,
    /// `FPMinNum()`.
    Minimum,
    /// `FPToFixed()` of the first, rounded by `FPSCR`, in 32 bits with this many of fraction.
    ToFixed {
        /// Whether the format is signed.
        signed: bool,
        /// Bits of fraction.
        fraction_bits: u32,
        /// Rounded towards zero instead.
        truncated: bool,
    },
    /// `FixedToFP()` of the first operand's bits.
    FromFixed {
        /// Whether the format is signed.
        signed: bool,
        /// Bits of fraction.
        fraction_bits: u32,
        /// Bits of the format.
        size: u32,
    },
}

impl Operation {
    fn fixed(self) -> Fixed {
        let (size, fraction_bits, signed) = match self {
            Self::ToFixed {
                signed,
                fraction_bits,
                ..
            } => (32, fraction_bits, signed),
            Self::FromFixed {
                signed,
                fraction_bits,
                size,
            } => (size, fraction_bits, signed),
            _ => (32, 0, false),
        };
        Fixed {
            size,
            fraction_bits,
            signed,
        }
    }

    fn mode(self, fpscr: u32) -> Round {
        match self {
            Self::ToFixed {
                truncated: true, ..
            } => Round::TowardZero,
            Self::FromFixed { .. } => Round::NearestTiesToEven,
            _ => fp::rounding(fpscr),
        }
    }
}

/// What `operation` answers for `operands` under `fpscr`, and `FPSCR` after it, in software.
#[must_use]
pub fn software(operation: Operation, operands: [u32; 3], fpscr: u32) -> (u32, u32) {
    let ([a, b, c], mut after) = (operands, fpscr);
    let (fixed, mode) = (operation.fixed(), operation.mode(fpscr));
    let flags = &mut after;
    let result = match operation {
        Operation::Add => fp::add(a, b, flags),
        Operation::Subtract => fp::subtract(a, b, flags),
        Operation::Multiply => fp::multiply(a, b, flags),
        Operation::Divide => fp::divide(a, b, flags),
        Operation::SquareRoot => fp::square_root(a, flags),
        Operation::MultiplyAdd => fp::multiply_add(a, b, c, flags),
        Operation::Compare => fp::compare(a, b, false, flags),
        Operation::CompareRaising => fp::compare(a, b, true, flags),
        Operation::Maximum => fp::maximum_number(a, b, flags),
        Operation::Minimum => fp::minimum_number(a, b, flags),
        Operation::ToFixed { .. } => fp::to_fixed(a, fixed, mode, flags),
        Operation::FromFixed { .. } => fp::from_fixed(a, fixed, mode, flags),
    };
    (result, after)
}

/// What [`software`] answers, by the host's unit where it can.
#[must_use]
pub fn host(operation: Operation, operands: [u32; 3], fpscr: u32) -> (u32, u32) {
    use fp::host;
    let ([a, b, c], mut after) = (operands, fpscr);
    let (fixed, mode) = (operation.fixed(), operation.mode(fpscr));
    let flags = &mut after;
    let result = match operation {
        Operation::Add => host::add(a, b, flags),
        Operation::Subtract => host::subtract(a, b, flags),
        Operation::Multiply => host::multiply(a, b, flags),
        Operation::Divide => host::divide(a, b, flags),
        Operation::SquareRoot => host::square_root(a, flags),
        Operation::MultiplyAdd => host::multiply_add(a, b, c, flags),
        Operation::Compare => host::compare(a, b, false, flags),
        Operation::CompareRaising => host::compare(a, b, true, flags),
        Operation::Maximum => host::extremum_number(a, b, true, flags),
        Operation::Minimum => host::extremum_number(a, b, false, flags),
        Operation::ToFixed { .. } => host::to_fixed(a, fixed, mode, flags),
        Operation::FromFixed { .. } => host::from_fixed(a, fixed, mode, flags),
    };
    (result, after)
}
