//! A supply that fails while a host works with the instrument, and what the host was told by then.
//!
//! [`Desk::cut`] gives the shipping image one spell of power: the host first looks whether all it was
//! told before is there, then goes on working, until the supply fails where the [`Cut`] says.

mod link;
mod told;

pub use link::Cut;
pub use told::Doing;

use crate::bench::Fault;
use calib_link::Client;
use calib_twin::plant::Plant;
use calib_twin::rig::Rig;
use calib_twin::runner::{Emulator, Firmware, SharedEmulator, Torn};
use link::{FailingLink, Failure};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;
use told::Told;

/// How long the supply stays away: nothing in the part remembers longer.
const OFF: Duration = Duration::from_millis(10);
/// From power-on until the part runs.
const RESET: Duration = Duration::from_micros(10);
/// From then until requests are heard.
const BOOT: Duration = Duration::from_millis(100);
/// Time after which the firmware has seen the button go up or down.
const BUTTON_SEEN: Duration = Duration::from_millis(60);
/// Longest spell of power: a session that comes to no end has no cut either.
const LONGEST: Duration = Duration::from_secs(120);

/// A host with an instrument whose supply fails again and again.
pub struct Desk {
    board: SharedEmulator,
    told: Told,
    /// Where the host keeps what it downloads.
    folder: PathBuf,
}

/// Circumstances of a cut.
#[derive(Clone, Copy, Debug)]
pub struct Met {
    /// Action of the host at the cut.
    pub doing: Doing,
    /// State it left in flash.
    pub torn: Torn,
}

impl Desk {
    /// An instrument with erased flash on the standard rig; downloads go to `folder`.
    ///
    /// # Errors
    /// The image is missing or does not run.
    pub fn new(folder: &Path) -> Result<Self, Fault> {
        let firmware = Firmware::shipping()?;
        let rig = Box::new(Plant::new(&Rig::standard()));
        let board = Emulator::power_on(&firmware, rig)?;
        Ok(Self {
            board: Arc::new(Mutex::new(board)),
            told: Told::default(),
            folder: folder.to_owned(),
        })
    }

    /// Works until the supply fails at `cut`, and gives it back.
    ///
    /// # Errors
    /// Something that was told before is not there, or the session cannot go on.
    pub fn cut(&mut self, cut: Cut) -> Result<Met, Fault> {
        let failure = Failure::default();
        let link = FailingLink::new(self.board.clone(), cut, failure.clone());
        let mut client = conversation(link);
        // It ends by an error: that of the supply, or one that matters.
        let error = self.session(&mut client).err();
        let Some(torn) = failure.torn() else {
            return Err(error.unwrap_or_else(|| format!("no cut in {LONGEST:?}").into()));
        };
        let mut board = self.board.lock().unwrap_or_else(PoisonError::into_inner);
        board.run_for(OFF)?;
        board.restore_power()?;
        let doing = self.told.doing;
        Ok(Met { doing, torn })
    }

    /// Looks once more, with power: after the last cut.
    ///
    /// # Errors
    /// Something that was told is not there.
    pub fn look(&mut self) -> Result<(), Fault> {
        let never = Cut::After(Duration::MAX);
        let link = FailingLink::new(self.board.clone(), never, Failure::default());
        let mut client = conversation(link);
        client.wait(BOOT)?;
        self.told.look(&mut client, &self.folder)
    }

    /// Records compared with what was told of them.
    pub fn compared(&self) -> u64 {
        self.told.compared
    }

    /// Records that were told.
    pub fn records(&self) -> u32 {
        self.told.stored
    }

    /// Loads of the core that met a word whose check bits do not fit.
    pub fn poisoned_loads(&self) -> u64 {
        let board = self.board.lock().unwrap_or_else(PoisonError::into_inner);
        board.flash_watch().poisoned_loads()
    }

    /// Sector erases begun so far.
    pub fn erases(&self) -> u64 {
        let board = self.board.lock().unwrap_or_else(PoisonError::into_inner);
        link::erases(&board)
    }

    /// Fills the record area once around, so that sectors are erased from now on.
    ///
    /// # Errors
    /// The instrument refuses.
    pub fn fill(&mut self) -> Result<(), Fault> {
        let never = Cut::After(Duration::MAX);
        let link = FailingLink::new(self.board.clone(), never, Failure::default());
        let mut client = conversation(link);
        client.wait(BOOT)?;
        self.told.look(&mut client, &self.folder)?;
        let before = self.erases();
        while self.erases() == before {
            self.change_settings(&mut client)?;
            self.told.release(&mut client)?;
        }
        Ok(())
    }

    /// Writes other settings with a hand on the button.
    fn change_settings(&mut self, client: &mut Client) -> Result<(), Fault> {
        self.told.doing = Doing::Settings;
        self.press_button(true)?;
        client.wait(BUTTON_SEEN)?;
        self.told.change_settings(client)?;
        self.press_button(false)?;
        client.wait(BUTTON_SEEN)?;
        Ok(())
    }

    fn press_button(&self, held: bool) -> Result<(), Fault> {
        let mut board = self.board.lock().unwrap_or_else(PoisonError::into_inner);
        Ok(board.press_button(held)?)
    }

    fn session(&mut self, client: &mut Client) -> Result<(), Fault> {
        let elapsed = |desk: &Self| {
            let board = desk.board.lock().unwrap_or_else(PoisonError::into_inner);
            board.uptime()
        };
        self.told.doing = Doing::Boot;
        // Whoever held it has let go: one that is down at a start opens nothing.
        self.press_button(false)?;
        client.wait(RESET)?;
        client.wait(BOOT)?;
        self.told.look(client, &self.folder)?;
        while elapsed(self) < LONGEST {
            self.change_settings(client)?;
            self.told.measure(client)?;
            self.told.download(client, &self.folder)?;
            self.told.release(client)?;
        }
        Ok(())
    }
}

/// A host's conversation over `link`. It always counts its requests alike, so that the same cuts meet
/// the same instructions in every run: the restart before each of them forgets the last one's.
fn conversation(link: FailingLink) -> Client {
    Client::new(Box::new(link)).counting_from(0)
}
