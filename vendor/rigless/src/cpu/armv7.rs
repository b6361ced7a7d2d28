// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! What the architecture's profiles share: the Thumb instructions and their lowering, the
//! floating-point extension's arithmetic, and `FPSCR`'s bit fields.
//!
//! A family's module plugs its core into the lowering with a [`translate::Profile`]. It decodes
//! only what its profile has of its own, its branches and its system instructions, and hands the
//! rest to [`translate::thumb16`] and [`translate::thumb32`].

#[cfg(not(emulator_absent))]
pub(crate) mod access;
#[cfg(not(emulator_absent))]
pub(crate) mod fp;
#[cfg_attr(
    emulator_absent,
    expect(
        dead_code,
        reason = "only the core uses most of it, and Miri builds the crate without one"
    )
)]
pub(crate) mod registers;
#[cfg(not(emulator_absent))]
pub(crate) mod translate;

/// The floating-point unit a part has, DDI 0403E.b A1.3 and Table A1-1, or DDI 0406C A2.6 for the
/// R profile's.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) enum Fpu {
    /// No floating-point extension, so CP10 and CP11 don't exist.
    None,
    /// FPv4-SP, single precision only: the Cortex-M4F's.
    FpV4Sp,
    /// `FPv5`, single precision only.
    FpV5Sp,
    /// `FPv5` with double precision.
    FpV5Dp,
    /// VFPv3-D16, single and double precision with sixteen double registers and no half-precision
    /// conversions or fused multiply-adds: the Cortex-R5F's, DDI 0460D 11.1.
    #[cfg_attr(
        emulator_absent,
        expect(
            dead_code,
            reason = "only the R core builds one, and Miri builds the crate without one"
        )
    )]
    VfpV3D16,
}

impl Fpu {
    /// The name the machine takes for this unit.
    #[must_use]
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::FpV4Sp => "fpv4-sp",
            Self::FpV5Sp => "fpv5-sp",
            Self::FpV5Dp => "fpv5-dp",
            Self::VfpV3D16 => "vfpv3-d16",
        }
    }
}

impl std::fmt::Display for Fpu {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.write_str(self.name())
    }
}

/// R0 to R15 as a target description names them, "Debugging with GDB" for GDB 18.1, section G.5.4,
/// the start of either profile's core feature.
#[cfg(not(emulator_absent))]
macro_rules! gdb_core_registers {
    () => {
        concat!(
            r#"<reg name="r0" bitsize="32"/><reg name="r1" bitsize="32"/><reg name="r2" bitsize="32"/>"#,
            r#"<reg name="r3" bitsize="32"/><reg name="r4" bitsize="32"/><reg name="r5" bitsize="32"/>"#,
            r#"<reg name="r6" bitsize="32"/><reg name="r7" bitsize="32"/><reg name="r8" bitsize="32"/>"#,
            r#"<reg name="r9" bitsize="32"/><reg name="r10" bitsize="32"/><reg name="r11" bitsize="32"/>"#,
            r#"<reg name="r12" bitsize="32"/><reg name="sp" bitsize="32" type="data_ptr"/>"#,
            r#"<reg name="lr" bitsize="32"/><reg name="pc" bitsize="32" type="code_ptr"/>"#,
        )
    };
}
#[cfg(not(emulator_absent))]
pub(crate) use gdb_core_registers;

/// The floating-point registers as GDB reads them, D0 to D15 and `FPSCR`, section G.5.4, and any
/// `extra` registers the family adds to the feature.
#[cfg(not(emulator_absent))]
macro_rules! gdb_vfp_registers {
    ($($extra:expr)?) => {
        concat!(
            r#"<feature name="org.gnu.gdb.arm.vfp">"#,
            r#"<reg name="d0" bitsize="64" type="ieee_double"/><reg name="d1" bitsize="64" type="ieee_double"/>"#,
            r#"<reg name="d2" bitsize="64" type="ieee_double"/><reg name="d3" bitsize="64" type="ieee_double"/>"#,
            r#"<reg name="d4" bitsize="64" type="ieee_double"/><reg name="d5" bitsize="64" type="ieee_double"/>"#,
            r#"<reg name="d6" bitsize="64" type="ieee_double"/><reg name="d7" bitsize="64" type="ieee_double"/>"#,
            r#"<reg name="d8" bitsize="64" type="ieee_double"/><reg name="d9" bitsize="64" type="ieee_double"/>"#,
            r#"<reg name="d10" bitsize="64" type="ieee_double"/><reg name="d11" bitsize="64" type="ieee_double"/>"#,
            r#"<reg name="d12" bitsize="64" type="ieee_double"/><reg name="d13" bitsize="64" type="ieee_double"/>"#,
            r#"<reg name="d14" bitsize="64" type="ieee_double"/><reg name="d15" bitsize="64" type="ieee_double"/>"#,
            r#"<reg name="fpscr" bitsize="32" type="int" group="float"/>"#,
            $($extra,)?
            "</feature>",
        )
    };
}
#[cfg(not(emulator_absent))]
pub(crate) use gdb_vfp_registers;
