//! Option bytes, which are written in the workshop and only read here (docs/decisions.md).

use calib_core::self_test::OptionBytes;
use embassy_stm32::pac;

/// Those in force.
pub(crate) fn option_bytes() -> OptionBytes {
    OptionBytes(pac::FLASH.optsr_cur().read().0)
}
