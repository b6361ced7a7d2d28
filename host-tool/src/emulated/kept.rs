//! The emulated calibrator that remembers, as hardware does.

use super::{EmulatedBoard, FlashFile};
use crate::Result;
use calib_link::Transport;
use calib_twin::rig::Rig;
use std::io::{self, Write};
use std::path::PathBuf;
use std::time::Duration;

/// The emulated calibrator of `--device emulated` and `emulated-usb`: its records and settings
/// outlive the process, in a file of the user's.
pub struct KeptBoard {
    link: Box<dyn Transport>,
    board: EmulatedBoard,
    flash: FlashFile,
}

impl KeptBoard {
    /// Switches the user's emulated calibrator on.
    ///
    /// # Errors
    /// As [`EmulatedBoard::power_on`] and [`FlashFile::hold`].
    pub fn power_on() -> Result<Self> {
        Self::power_on_and(|board| Ok(Box::new(board.link())))
    }

    /// Connects by a USB cable instead of the serial line.
    ///
    /// # Errors
    /// As [`Self::power_on`], and when the USB port does not come up.
    pub fn power_on_with_usb() -> Result<Self> {
        Self::power_on_and(|board| Ok(Box::new(board.usb_link()?)))
    }

    /// Puts a hand on its button.
    ///
    /// # Errors
    /// As [`EmulatedBoard::hold_button`].
    pub fn hold_button(&self) -> Result<()> {
        self.board.hold_button_once_up()
    }

    fn power_on_and(
        connect: impl FnOnce(&EmulatedBoard) -> Result<Box<dyn Transport>>,
    ) -> Result<Self> {
        let flash = FlashFile::hold(&flash_file())?;
        let rig = Rig::standard();
        let board = match flash.power_on(&rig)? {
            Some(board) => board,
            None => EmulatedBoard::power_on_calibrated(&rig, None)?,
        };
        Ok(Self {
            link: connect(&board)?,
            board,
            flash,
        })
    }
}

impl Drop for KeptBoard {
    fn drop(&mut self) {
        // No caller is left to be told: the next one finds the flash of before.
        if let Err(error) = self.flash.keep(&self.board) {
            let lost = "the emulated calibrator forgets what was stored just now";
            let _ = writeln!(io::stderr(), "{lost}: {error}");
        }
    }
}

/// `CALIB_STATE_DIR`, else the place this system has for such files.
fn flash_file() -> PathBuf {
    let folder = std::env::var_os("CALIB_STATE_DIR").map(PathBuf::from);
    let folder = folder
        .or_else(|| {
            Some(
                dirs::state_dir()
                    .or_else(dirs::data_local_dir)?
                    .join("calib"),
            )
        })
        .unwrap_or_else(|| PathBuf::from("."));
    folder.join("emulated-board.flash")
}

impl Transport for KeptBoard {
    fn name(&self) -> String {
        self.link.name()
    }

    fn send(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.link.send(bytes)
    }

    fn now(&self) -> Duration {
        self.link.now()
    }

    fn receive(&mut self, buffer: &mut [u8], timeout: Duration) -> io::Result<usize> {
        self.link.receive(buffer, timeout)
    }

    fn wait(&mut self, duration: Duration) -> io::Result<()> {
        self.link.wait(duration)
    }
}
