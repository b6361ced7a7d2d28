//! A calibrator without hardware: the shipping firmware on the emulated board.
//!
//! Virtual time passes only while the host waits for an answer or says so, and
//! then as fast as this computer can: a run is the same each time, bit by bit.

mod flash_file;
mod kept;
pub mod rig_file;
mod serial_link;
mod settings;
mod usb_link;

pub use flash_file::FlashFile;
pub use kept::KeptBoard;
pub use serial_link::EmulatedTransport;
pub use settings::settings_for;
pub use usb_link::EmulatedUsbTransport;

use crate::{Error, Result};
use calib_link::Client;
use calib_protocol::message::SettingsChange;
use calib_twin::plant::Plant;
use calib_twin::rig::Rig;
use calib_twin::runner::{Emulator, Firmware, SharedEmulator};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

/// Time from power-on until the firmware looks at its button.
const BOOT: Duration = Duration::from_millis(400);
/// Time after which the firmware has seen what happens to the button.
const BUTTON_SEEN: Duration = Duration::from_millis(100);
/// Environment variable that names the firmware image.
const ELF_VARIABLE: &str = "CALIB_FIRMWARE_ELF";
/// The image, seen from the target directory.
const ELF_IN_TARGET: &str = "thumbv7em-none-eabihf/firmware/calib-firmware";

/// An emulated board with power, on a simulated rig.
#[derive(Clone, Debug)]
pub struct EmulatedBoard {
    emulator: SharedEmulator,
}

impl EmulatedBoard {
    /// Switches a new board on: its flash is erased.
    ///
    /// # Errors
    /// [`Error::Input`] when there is no firmware image, or it does not boot.
    pub fn power_on(rig: &Rig) -> Result<Self> {
        let emulator = Emulator::power_on(&firmware()?, Box::new(Plant::new(rig)));
        Self::around(emulator)
    }

    /// Switches a new board on and tells it what is certified about the rig's
    /// reference, as [`settings_for`] says.
    ///
    /// # Errors
    /// As [`Self::power_on`], and those of the link.
    pub fn power_on_calibrated(rig: &Rig, error_seed: Option<u64>) -> Result<Self> {
        let board = Self::power_on(rig)?;
        let mut client = Client::new(Box::new(board.link()));
        let settings = settings_for(rig, client.settings()?, error_seed);
        board.set_up(&mut client, settings)?;
        Ok(board)
    }

    /// Writes settings with a hand on the button, as whoever sets an instrument
    /// up must: they may say something else of its reference.
    ///
    /// # Errors
    /// Those of the link; the calibrator refuses.
    pub fn set_up(&self, client: &mut Client, change: impl Into<SettingsChange>) -> Result<()> {
        self.hold_button(true)?;
        client.wait(BUTTON_SEEN)?;
        let written = client.write_settings(change);
        self.hold_button(false)?;
        client.wait(BUTTON_SEEN)?;
        Ok(written?)
    }

    /// Puts a hand on the button, or takes it away.
    ///
    /// # Errors
    /// [`Error::Input`] when the emulator fails.
    pub fn hold_button(&self, held: bool) -> Result<()> {
        let pressed = self.emulator().press_button(held);
        pressed.map_err(|error| board_error(&error))
    }

    fn around(emulator: Result<Emulator, calib_twin::runner::Error>) -> Result<Self> {
        let emulator = emulator.map_err(|error| board_error(&error))?;
        Ok(Self {
            emulator: Arc::new(Mutex::new(emulator)),
        })
    }

    /// A link to the board's serial port.
    pub fn link(&self) -> EmulatedTransport {
        EmulatedTransport::new(Arc::clone(&self.emulator))
    }

    /// Plugs a cable into the board's USB port.
    ///
    /// # Errors
    /// [`Error::Input`] when no serial port shows itself there.
    pub fn usb_link(&self) -> Result<EmulatedUsbTransport> {
        let link = EmulatedUsbTransport::plug_in(Arc::clone(&self.emulator));
        link.map_err(|error| {
            Error::input(
                "emulated USB port",
                error.to_string(),
                "`--device emulated` uses the serial line instead",
            )
        })
    }

    /// The board itself, for who wants to press its button or cut its power.
    pub fn emulator(&self) -> MutexGuard<'_, Emulator> {
        self.emulator.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Puts a hand on the button of a board that was just switched on, as soon as
    /// it looks: one that is down from the start is stuck.
    ///
    /// # Errors
    /// [`Error::Input`] when the emulator fails.
    pub fn hold_button_once_up(&self) -> Result<()> {
        let up = self.emulator().run_for(BOOT);
        up.map_err(|error| board_error(&error))?;
        self.hold_button(true)?;
        let seen = self.emulator().run_for(BUTTON_SEEN);
        seen.map_err(|error| board_error(&error))
    }

    /// Content of the record flash.
    ///
    /// # Errors
    /// [`Error::Input`] when the emulator fails.
    pub fn record_flash(&self) -> Result<Vec<u8>> {
        let flash = self.emulator().record_flash();
        flash.map_err(|error| board_error(&error))
    }

    /// Pulls the reset pin.
    ///
    /// # Errors
    /// [`Error::Input`] when the emulator fails.
    pub fn reset(&self) -> Result<()> {
        self.emulator().reset().map_err(|error| board_error(&error))
    }
}

fn board_error(error: &calib_twin::runner::Error) -> Error {
    Error::input(
        "emulated board",
        error.to_string(),
        "build the firmware image with `./run demo` in the source tree",
    )
}

/// The image inside the tool, in a package.
#[cfg(image_inside)]
const INSIDE: Option<&[u8]> = Some(include_bytes!(env!("CALIB_EMBED_IMAGE")));
#[cfg(not(image_inside))]
const INSIDE: Option<&[u8]> = None;

/// The image: what the environment names, else the one inside, else what was built with this tool.
fn firmware() -> Result<Firmware> {
    let image = match (std::env::var_os(ELF_VARIABLE), INSIDE) {
        (Some(path), _) => Firmware::read(Path::new(&path)),
        (None, Some(bytes)) => Firmware::from_bytes(Path::new("inside calib"), bytes.to_vec()),
        (None, None) => Firmware::read(&built()),
    };
    image.map_err(|error| {
        Error::input(
            "firmware image",
            error.to_string(),
            format!("`./run demo` in the source tree builds it; or name one in {ELF_VARIABLE}"),
        )
    })
}

/// Where the image lies once it was built beside this program.
fn built() -> PathBuf {
    // target/release/calib, and target/release/deps/test-...
    let program = std::env::current_exe().unwrap_or_default();
    let candidates = program.ancestors().skip(1).take(3);
    let found = candidates
        .map(|folder| folder.join(ELF_IN_TARGET))
        .find(|path| path.is_file());
    found.unwrap_or_else(|| Path::new("target").join(ELF_IN_TARGET))
}
