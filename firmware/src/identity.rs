//! Who this instrument is, and why it started.

use calib_firmware::restarts::{LeftOut, Reason};
use calib_protocol::health::MAX_RESTARTS;
use calib_protocol::message::ResetCause;
use calib_protocol::update::ImageOrigin;
use core::fmt::Write;
use embassy_stm32::pac::{self, rcc::regs::Rsr};
use heapless::{String, Vec};

/// Git hash of the image; `-dirty` when it was built from changed files.
const GIT_HASH: &str = env!("CALIB_GIT_HASH");
const VERSION: &str = env!("CARGO_PKG_VERSION");

/// Facts that do not change while the board runs.
#[derive(Clone)]
pub(crate) struct Identity {
    pub(crate) serial: String<32>,
    pub(crate) version: String<16>,
    pub(crate) git_hash: String<24>,
    /// The image, as the loader found it.
    pub(crate) image: ImageOrigin,
    pub(crate) reset_cause: ResetCause,
    pub(crate) last_panic: Option<Reason>,
    /// Why it restarted, each time within a minute of the one before.
    pub(crate) restarts: Vec<Reason, MAX_RESTARTS>,
    /// Parts this start does without.
    pub(crate) left_out: LeftOut,
    /// Cause of an unintended restart.
    pub(crate) incident: Option<Reason>,
}

impl Identity {
    /// Reads unique id, reset flags and what was kept, and clears the flags. To be called once.
    pub(crate) fn read() -> Self {
        let flags = pac::RCC.rsr().read();
        pac::RCC.rsr().modify(|w| w.set_rmvf(true));
        let reset_cause = cause(flags);
        let (history, last_panic) = crate::retained::begin(reset_cause);
        Self {
            incident: last_panic.clone().or_else(|| incident(reset_cause)),
            serial: fitting(embassy_stm32::uid::uid_hex()),
            version: fitting(VERSION),
            git_hash: fitting(GIT_HASH),
            image: crate::update::origin(),
            reset_cause,
            last_panic,
            restarts: history.reasons().clone(),
            left_out: history.left_out(),
        }
    }

    /// Version and git hash in one, as records carry it.
    pub(crate) fn firmware(&self) -> String<40> {
        let mut text = String::new();
        // 16 + 1 + 23 characters always fit.
        let _ = write!(text, "{} {}", self.version, self.git_hash);
        text
    }
}

/// As much of `text` as fits.
fn fitting<const N: usize>(text: &str) -> String<N> {
    let mut result = String::new();
    for character in text.chars() {
        if result.push(character).is_err() {
            break;
        }
    }
    result
}

/// A restart nobody asked for and that left no message.
fn incident(cause: ResetCause) -> Option<Reason> {
    match cause {
        ResetCause::Watchdog => Some(fitting("restarted by the watchdog: everything stood still")),
        ResetCause::BrownOut => Some(fitting("restarted by a drop of the supply")),
        _ => None,
    }
}

/// The most specific flag wins: every reset also sets the pin flag, and power
/// on sets the brown-out flag as well (RM0433 Rev 8, table 56).
fn cause(flags: Rsr) -> ResetCause {
    if flags.porrstf() {
        ResetCause::PowerOn
    } else if flags.borrstf() {
        ResetCause::BrownOut
    } else if flags.iwdg1rstf() || flags.wwdg1rstf() {
        ResetCause::Watchdog
    } else if flags.sftrstf() {
        ResetCause::Software
    } else if flags.pinrstf() {
        ResetCause::Pin
    } else {
        ResetCause::Other
    }
}
