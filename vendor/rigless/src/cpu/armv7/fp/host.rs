// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! The arithmetic of [`fp`](super) on singles by the host's own unit, where it gives exactly what
//! the pseudocode does, flags included, and by the software everywhere else.
//!
//! The host rounds to nearest, ties to even, because Rust requires that of every thread. So it's asked
//! only in the default mode, `FPSCR.AHP`, `DN`, `FZ` and `RMode` all 0, for operands that are normal
//! or zero, and believed only when its result is normal with an exponent above the least, or an
//! exact zero. That leaves one flag that may be raised, `IXC`, and whether it is follows from
//! arithmetic in double precision, which holds the sum, product or remainder it takes exactly. A
//! host that other code told to flush denormals changes none of it, since no denormal is read or
//! made.

use std::cmp::Ordering;

use rustc_apfloat::Round;

use super::{FPSCR_DEFAULTS, Fixed, SIGN, fpscr, mask, raise};

/// The smallest normal single, below which a magnitude is a zero or a denormal, A2.5.4.
const SMALLEST_NORMAL: u32 = 0x0080_0000;
/// Twice that: the smallest a result tiny before rounding can't have been rounded to.
const SAFELY_NORMAL: u32 = 0x0100_0000;
/// The magnitude of an infinity, above which every NaN's is.
const INFINITY: u32 = 0x7F80_0000;

fn magnitude(operand: u32) -> u32 {
    operand & !SIGN
}

/// Whether the host takes `operand` for what it is whatever its own modes are.
fn plain(operand: u32) -> bool {
    let magnitude = magnitude(operand);
    magnitude == 0 || (SMALLEST_NORMAL..INFINITY).contains(&magnitude)
}

/// Whether the host may be asked at all for an operation on `operands`.
fn may_ask(operands: &[u32], fpscr: u32) -> bool {
    fpscr & FPSCR_DEFAULTS == 0 && operands.iter().all(|&operand| plain(operand))
}

/// `result`, with `IXC` raised unless `exact`, where the host may be believed on it: it's safely
/// normal, or the zero that's exact when `zero`.
fn believed(result: f32, exact: bool, zero: bool, fpscr: &mut u32) -> Option<u32> {
    let bits = result.to_bits();
    let magnitude = magnitude(bits);
    if !(SAFELY_NORMAL..INFINITY).contains(&magnitude) && !(magnitude == 0 && zero) {
        return None;
    }
    if !exact {
        raise(fpscr, fpscr::IXC);
    }
    Some(bits)
}

fn single(operand: u32) -> f32 {
    f32::from_bits(operand)
}

fn wide(operand: u32) -> f64 {
    f64::from(single(operand))
}

/// `FPAdd()`.
pub(crate) fn add(op1: u32, op2: u32, fpscr: &mut u32) -> u32 {
    sum(op1, op2, fpscr).unwrap_or_else(|| super::add(op1, op2, fpscr))
}

/// `FPSub()`.
pub(crate) fn subtract(op1: u32, op2: u32, fpscr: &mut u32) -> u32 {
    sum(op1, op2 ^ SIGN, fpscr).unwrap_or_else(|| super::subtract(op1, op2, fpscr))
}

fn sum(op1: u32, op2: u32, fpscr: &mut u32) -> Option<u32> {
    if !may_ask(&[op1, op2], *fpscr) {
        return None;
    }
    let result = single(op1) + single(op2);
    let (large, small) = if magnitude(op1) >= magnitude(op2) {
        (op1, op2)
    } else {
        (op2, op1)
    };
    // Dekker's fast two-sum: the rounded sum less the larger operand is a single, and so is what's
    // left of the smaller, so neither difference rounds.
    let exact = f64::from(result) - wide(large) == wide(small);
    // A zero is exact only from opposites, which two zeros of any sign are as well.
    let zero = magnitude(op1) == magnitude(op2);
    believed(result, exact, zero, fpscr)
}

/// `FPMul()`.
pub(crate) fn multiply(op1: u32, op2: u32, fpscr: &mut u32) -> u32 {
    product(op1, op2, fpscr).unwrap_or_else(|| super::multiply(op1, op2, fpscr))
}

fn product(op1: u32, op2: u32, fpscr: &mut u32) -> Option<u32> {
    if !may_ask(&[op1, op2], *fpscr) {
        return None;
    }
    let result = single(op1) * single(op2);
    // The product of two significands of 24 bits fits the 53 of a double.
    let exact = f64::from(result) == wide(op1) * wide(op2);
    let zero = magnitude(op1) == 0 || magnitude(op2) == 0;
    believed(result, exact, zero, fpscr)
}

/// `FPDiv()`.
pub(crate) fn divide(op1: u32, op2: u32, fpscr: &mut u32) -> u32 {
    quotient(op1, op2, fpscr).unwrap_or_else(|| super::divide(op1, op2, fpscr))
}

fn quotient(op1: u32, op2: u32, fpscr: &mut u32) -> Option<u32> {
    if !may_ask(&[op1, op2], *fpscr) || magnitude(op2) == 0 {
        return None;
    }
    let result = single(op1) / single(op2);
    let exact = f64::from(result) * wide(op2) == wide(op1);
    believed(result, exact, magnitude(op1) == 0, fpscr)
}

/// `FPSqrt()`.
pub(crate) fn square_root(operand: u32, fpscr: &mut u32) -> u32 {
    root(operand, fpscr).unwrap_or_else(|| super::square_root(operand, fpscr))
}

fn root(operand: u32, fpscr: &mut u32) -> Option<u32> {
    if !may_ask(&[operand], *fpscr) || operand & SIGN != 0 {
        return None;
    }
    let result = single(operand).sqrt();
    let exact = f64::from(result) * f64::from(result) == wide(operand);
    believed(result, exact, operand == 0, fpscr)
}

/// `FPMulAdd()`: `addend + op1 * op2` with one rounding.
pub(crate) fn multiply_add(addend: u32, op1: u32, op2: u32, fpscr: &mut u32) -> u32 {
    fused(addend, op1, op2, fpscr).unwrap_or_else(|| super::multiply_add(addend, op1, op2, fpscr))
}

fn fused(addend: u32, op1: u32, op2: u32, fpscr: &mut u32) -> Option<u32> {
    if !may_ask(&[addend, op1, op2], *fpscr) {
        return None;
    }
    // The product is exact. Knuth's two-sum answers the sum, rounded to a double, and its error.
    let (product, addend) = (wide(op1) * wide(op2), wide(addend));
    let sum = product + addend;
    let without = sum - product;
    let error = (product - (sum - without)) + (addend - without);
    let result = rounded_to_odd(sum, error) as f32;
    let exact = error == 0.0 && f64::from(result) == sum;
    // The sum is zero only when it's exactly that.
    believed(result, exact, sum == 0.0, fpscr)
}

/// The exact `sum + error`, `error` less than half a unit in the last place of `sum`, rounded to odd:
/// the neighbor with the odd significand where it's between two. Rounding that to nearest in a
/// format of at most 51 bits is rounding the exact value once, Boldo and Melquiond, "Emulation of a
/// FMA and correctly rounded sums", IEEE Transactions on Computers 57, 2008.
fn rounded_to_odd(sum: f64, error: f64) -> f64 {
    let bits = sum.to_bits();
    if error == 0.0 || bits & 1 != 0 {
        return sum;
    }
    // Away from zero the bits count up.
    let away = (error > 0.0) == (sum > 0.0);
    f64::from_bits(if away { bits + 1 } else { bits - 1 })
}

/// `FPCompare()` of two numbers, `N`, `Z`, `C` and `V` where `FPSCR` holds them. With no NaN and no
/// flushing nothing is raised.
pub(crate) fn compare(op1: u32, op2: u32, quiet_nan_exc: bool, fpscr: &mut u32) -> u32 {
    match order(op1, op2, *fpscr) {
        None => super::compare(op1, op2, quiet_nan_exc, fpscr),
        Some(Ordering::Equal) => mask(fpscr::Z) | mask(fpscr::C),
        Some(Ordering::Less) => mask(fpscr::N),
        Some(Ordering::Greater) => mask(fpscr::C),
    }
}

/// The order of two numbers, as integers see it: two zeros are equal whatever their signs.
fn order(op1: u32, op2: u32, fpscr: u32) -> Option<Ordering> {
    if fpscr & FPSCR_DEFAULTS != 0 || magnitude(op1) > INFINITY || magnitude(op2) > INFINITY {
        return None;
    }
    let signed = |operand: u32| {
        let magnitude = magnitude(operand).cast_signed();
        if operand & SIGN == 0 {
            magnitude
        } else {
            -magnitude
        }
    };
    Some(signed(op1).cmp(&signed(op2)))
}

/// `FPMaxNum()` or `FPMinNum()`, by `maximum`.
pub(crate) fn extremum_number(op1: u32, op2: u32, maximum: bool, fpscr: &mut u32) -> u32 {
    let first = match order(op1, op2, *fpscr) {
        None if maximum => return super::maximum_number(op1, op2, fpscr),
        None => return super::minimum_number(op1, op2, fpscr),
        Some(Ordering::Greater) => maximum,
        Some(Ordering::Less) => !maximum,
        Some(Ordering::Equal) => (op1 & SIGN != 0) != maximum,
    };
    if first { op1 } else { op2 }
}

/// `FPToFixed()`: `operand` in `format`, sign- or zero-extended to 32 bits, rounded by `mode`.
pub(crate) fn to_fixed(operand: u32, format: Fixed, mode: Round, fpscr: &mut u32) -> u32 {
    fixed(operand, format, mode, fpscr)
        .unwrap_or_else(|| super::to_fixed(operand, format, mode, fpscr))
}

fn fixed(operand: u32, format: Fixed, mode: Round, fpscr: &mut u32) -> Option<u32> {
    if !may_ask(&[operand], *fpscr) {
        return None;
    }
    let scaled = wide(operand) * power_of_two(format.fraction_bits);
    let rounded = match mode {
        // A magnitude past 2^63 saturates, which is past every format too.
        Round::TowardZero => scaled as i64 as f64,
        Round::NearestTiesToEven => scaled.round_ties_even(),
        _ => return None,
    };
    let (lowest, highest) = if format.signed {
        let half = power_of_two(format.size - 1);
        (-half, half - 1.0)
    } else {
        (0.0, power_of_two(format.size) - 1.0)
    };
    if !(lowest..=highest).contains(&rounded) {
        return None;
    }
    if rounded != scaled {
        raise(fpscr, fpscr::IXC);
    }
    let word = (rounded as i64).cast_unsigned() & u64::from(u32::MAX);
    u32::try_from(word).ok()
}

/// `FixedToFP()`: the low `format.size` bits of `operand` as a single, rounded by `mode`.
pub(crate) fn from_fixed(operand: u32, format: Fixed, mode: Round, fpscr: &mut u32) -> u32 {
    if mode != Round::NearestTiesToEven {
        return super::from_fixed(operand, format, mode, fpscr);
    }
    let above = u64::BITS - format.size;
    let shifted = u64::from(operand) << above;
    let integer = if format.signed {
        shifted.cast_signed() >> above
    } else {
        (shifted >> above).cast_signed()
    };
    let rounded = integer as f32;
    // A double holds every integer of 32 bits.
    if f64::from(rounded) != integer as f64 {
        raise(fpscr, fpscr::IXC);
    }
    // A nonzero integer over at most 2^32 is normal, so the scaling is exact.
    ((f64::from(rounded) / power_of_two(format.fraction_bits)) as f32).to_bits()
}

fn power_of_two(exponent: u32) -> f64 {
    f64::from_bits(u64::from(1023 + exponent) << 52)
}
