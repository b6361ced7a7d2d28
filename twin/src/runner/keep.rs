//! A run kept in a file, and gone on with: in another process, on another day.
//!
//! The file holds the core, every memory, every model and where the rig is. Read back with the same
//! image, into a rig built the same way, the run goes on as if it had never stopped: test
//! `a_run_that_was_kept_goes_on_as_one_that_was_not`.

use std::path::Path;
use std::time::Duration;

use rigless::emulator::Resume;
use rigless::session::Session;
use rigless::snapshot::{self, Snapshot};

use super::core_thread::CoreThread;
use super::{Emulator, Error, Firmware, Log};
use crate::board::CalibratorBoard;
use crate::rig_port::RigPort;

/// State the owner of a board keeps beside the board.
#[derive(Debug, Default, serde::Serialize, serde::Deserialize)]
struct Owner {
    power_ons: u64,
    powered_at: Duration,
}
rigless::store!(Owner);

impl Emulator {
    /// Keeps the run as it stands in a file at `path`, which replaces what was there as a whole.
    ///
    /// # Errors
    ///
    /// [`Error::Keep`] with a USB cable in, on a rig that cannot be kept, or when the file cannot be
    /// written; [`Error::Ended`] when the emulator fails.
    pub fn keep(&mut self, path: &Path) -> Result<(), Error> {
        let digest = self.firmware.digest();
        let owner = Owner {
            power_ons: self.power_ons,
            powered_at: self.powered_at,
        };
        let taken = self
            .core
            .act(move |session, host, stop| snapshot::take(session, host, stop, &digest, &owner))?;
        let failed = |reason: &dyn std::fmt::Display| Error::Keep {
            path: path.to_owned(),
            reason: reason.to_string(),
        };
        let taken = taken.map_err(|error| failed(&error))?;
        let beside = path.with_extension("part");
        std::fs::write(&beside, taken.file)
            .and_then(|()| std::fs::rename(&beside, path))
            .map_err(|error| failed(&error))
    }

    /// Goes on with the run kept at `path`: the same image, and a rig built as the one that was on the
    /// connectors. The log begins anew.
    ///
    /// # Errors
    ///
    /// [`Error::Keep`] for a file that is none, is damaged, or is of another image or board.
    pub fn go_on(firmware: &Firmware, rig: Box<dyn RigPort>, path: &Path) -> Result<Self, Error> {
        let failed = |error: snapshot::Error| Error::Keep {
            path: path.to_owned(),
            reason: error.to_string(),
        };
        let kept = Snapshot::read(path).map_err(failed)?;
        let pins = firmware.pins(rig);
        let mut owner = Owner::default();
        let restore = |session: &mut Session<CalibratorBoard>| -> Result<Resume<'static>, Error> {
            kept.restore(session, &firmware.digest(), &mut owner)
                .map_err(failed)
        };
        let core = CoreThread::go_on(firmware, &pins, restore)?;
        Ok(Self {
            core,
            firmware: firmware.clone(),
            pins,
            log: Log::default(),
            power_ons: owner.power_ons,
            powered_at: owner.powered_at,
        })
    }
}
