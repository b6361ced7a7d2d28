// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! The arithmetic only ARM state has, DDI 0406C A5.2.4 and A8.4.3.
//!
//! Each reads only the encoding, so it runs when the instruction is translated. The shifts,
//! `AddWithCarry` and the saturations ARM state shares with Thumb are in
//! [`crate::cpu::armv7::translate::alu`].

use crate::cpu::armv7::translate::alu::ShiftType;
use crate::cpu::armv7::translate::bits;

/// `ARMExpandImm(imm12)`, A5.2.4, for the instructions that take no carry from the constant.
pub(super) fn arm_expand_imm(imm12: u32) -> u32 {
    arm_expand_imm_c(imm12).0
}

/// `ARMExpandImm_C(imm12, carry_in)`, A5.2.4: the constant, and the carry out where the rotation
/// decides it. `None` means the carry out is the carry in, which a rotation of zero hands back,
/// since `Shift_C` by zero does.
pub(super) fn arm_expand_imm_c(imm12: u32) -> (u32, Option<u32>) {
    let rotation = 2 * bits(imm12, 11, 8);
    let imm32 = bits(imm12, 7, 0).rotate_right(rotation);
    (imm32, (rotation != 0).then_some(imm32 >> 31))
}

/// `DecodeRegShift(type)`, A8.4.3: a register-controlled shift is never RRX.
pub(super) fn decode_reg_shift(shift_type: u32) -> ShiftType {
    match shift_type & 0b11 {
        0b00 => ShiftType::Lsl,
        0b01 => ShiftType::Lsr,
        0b10 => ShiftType::Asr,
        _ => ShiftType::Ror,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Table A5-6: the byte rotated right by twice the rotation, with the carry from bit 31 of the
    /// constant whenever the rotation isn't zero, A5.2.4's "Carry out".
    #[test]
    fn arm_expand_imm_rotates_the_byte_by_twice_the_rotation() {
        assert_eq!(arm_expand_imm_c(0x0AB), (0x0000_00AB, None));
        assert_eq!(
            arm_expand_imm_c(0x0FF),
            (0x0000_00FF, None),
            "no carry at 0"
        );
        assert_eq!(
            arm_expand_imm_c(0x1FF),
            (0xC000_003F, Some(1)),
            "gh000000..00abcdef"
        );
        assert_eq!(arm_expand_imm_c(0x2FF), (0xF000_000F, Some(1)));
        assert_eq!(arm_expand_imm_c(0x3FF), (0xFC00_0003, Some(1)));
        assert_eq!(
            arm_expand_imm_c(0x4AB),
            (0xAB00_0000, Some(1)),
            "abcdefgh at the top"
        );
        assert_eq!(arm_expand_imm_c(0x42B), (0x2B00_0000, Some(0)));
        assert_eq!(arm_expand_imm_c(0x9FF), (0x003F_C000, Some(0)));
        assert_eq!(arm_expand_imm_c(0xEFF), (0x0000_0FF0, Some(0)));
        assert_eq!(arm_expand_imm_c(0xF01), (0x0000_0004, Some(0)));
        assert_eq!(arm_expand_imm_c(0x102), (0x8000_0000, Some(1)));
        assert_eq!(
            arm_expand_imm_c(0x100),
            (0, Some(0)),
            "a rotated zero clears C"
        );
    }

    /// `ARMExpandImm()` is the constant `ARMExpandImm_C()` gives, whatever the carry.
    #[test]
    fn arm_expand_imm_is_the_constant_alone() {
        for imm12 in [0x000, 0x0FF, 0x1FF, 0x4AB, 0xF01, 0xFFF] {
            assert_eq!(
                arm_expand_imm(imm12),
                arm_expand_imm_c(imm12).0,
                "{imm12:#05x}"
            );
        }
        assert_eq!(arm_expand_imm(0xFFF), 0x0000_03FC);
    }

    /// A8.4.3's `DecodeRegShift()`: the two type bits pick LSL, LSR, ASR or ROR.
    #[test]
    fn decode_reg_shift_picks_the_four_shifts() {
        let shifts = [0b00, 0b01, 0b10, 0b11].map(decode_reg_shift);
        assert_eq!(
            shifts,
            [
                ShiftType::Lsl,
                ShiftType::Lsr,
                ShiftType::Asr,
                ShiftType::Ror
            ]
        );
    }
}
