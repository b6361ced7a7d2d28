//! A supply that fails while a host works with the instrument, and what the host was told by then.
//!
//! [`Desk::cut`] gives the shipping image one spell of power: the host first looks whether all it was
//! told before is there, then goes on working, until the supply fails where the [`Cut`] says.
//!
//! A cut need not end the session that meets it. A [`Survey`] takes the flash as a cut would leave it,
//! puts it into a second board, and lets a second host, who knows what the first one knew by then, look
//! for it there, while the first session goes on as if nothing had been.

mod link;
mod outage;
mod plan;
mod survey;
mod tally;
mod told;

pub use outage::Cut;
pub use survey::Survey;
pub use tally::{Row, Tally};
pub use told::Doing;

use crate::rigged::Fault;
use calib_link::Client;
use calib_twin::plant::Plant;
use calib_twin::rig::Rig;
use calib_twin::runner::{Emulator, Firmware, FlashAtCut, SharedEmulator, Torn};
use link::{FailingLink, Failure};
use outage::{Fails, Outage};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
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
        self.spell(cut, Arc::new(Mutex::new(Fails)))
    }

    /// Works with a survey of all its cuts, the first of them `first`, until the supply fails at the
    /// one the survey lets come, and gives it back.
    ///
    /// # Errors
    /// As [`Desk::cut`], and those of the survey.
    pub fn surveyed(&mut self, survey: &Arc<Mutex<Survey>>) -> Result<Met, Fault> {
        let first = survey
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .first();
        self.spell(first, survey.clone())
    }

    /// Looks once more, after the last cut of a survey, and compares that start as well.
    ///
    /// # Errors
    /// As [`Desk::look`], and that of the survey.
    pub fn end(&mut self, survey: &Mutex<Survey>) -> Result<(), Fault> {
        self.look()?;
        let mut survey = survey.lock().unwrap_or_else(PoisonError::into_inner);
        survey.started(&mut self.board())
    }

    fn spell(&mut self, cut: Cut, outage: Arc<Mutex<dyn Outage>>) -> Result<Met, Fault> {
        let failure = Failure::default();
        let link = FailingLink::new(self.board.clone(), cut, outage.clone(), failure.clone());
        let mut client = conversation(link);
        // It ends by an error: that of the supply, or one that matters.
        let error = self.session(&mut client, &outage).err();
        let Some(torn) = failure.torn() else {
            return Err(error.unwrap_or_else(|| format!("no cut in {LONGEST:?}").into()));
        };
        let mut board = self.board();
        board.run_for(OFF)?;
        board.restore_power()?;
        let doing = self.told.known().doing;
        Ok(Met { doing, torn })
    }

    /// Looks once more, with power: after the last cut.
    ///
    /// # Errors
    /// Something that was told is not there.
    pub fn look(&mut self) -> Result<(), Fault> {
        let mut client = self.uncut();
        self.press_button(false)?;
        client.wait(RESET)?;
        client.wait(BOOT)?;
        self.told.look(&mut client, &self.folder)
    }

    /// Records compared with what was told of them.
    pub fn compared(&self) -> u64 {
        self.told.known().compared
    }

    /// Records that were told.
    pub fn records(&self) -> u32 {
        self.told.known().stored
    }

    /// Loads of the core that met a word whose check bits do not fit.
    pub fn poisoned_loads(&self) -> u64 {
        self.board().flash_watch().poisoned_loads()
    }

    /// Sector erases begun so far.
    pub fn erases(&self) -> u64 {
        link::erases(&self.board())
    }

    /// Fills the record area once around, so that sectors are erased from now on.
    ///
    /// # Errors
    /// The instrument refuses.
    pub fn fill(&mut self) -> Result<(), Fault> {
        let mut client = self.uncut();
        client.wait(BOOT)?;
        self.told.look(&mut client, &self.folder)?;
        let before = self.erases();
        while self.erases() == before {
            self.change_settings(&mut client)?;
            self.told.release(&mut client)?;
        }
        Ok(())
    }

    /// Goes on, with another board, from where the supply of one would have failed: its flash and what
    /// its host knew by then. This board is off meanwhile.
    fn take_over(&mut self, flash: &FlashAtCut, told: &Told) -> Result<(), Fault> {
        let mut board = self.board();
        board.cut_power()?;
        board.fit_flash(flash)?;
        board.run_for(OFF)?;
        board.restore_power()?;
        drop(board);
        self.told = told.apart();
        // What the first host has downloaded it has not.
        std::fs::remove_dir_all(&self.folder)?;
        std::fs::create_dir(&self.folder)?;
        Ok(())
    }

    /// One round of work, after a look.
    fn round(&mut self) -> Result<(), Fault> {
        let mut client = self.uncut();
        self.work(&mut client)
    }

    /// A conversation in which the supply holds.
    fn uncut(&self) -> Client {
        let never = Cut::After(Duration::MAX);
        let outage = Arc::new(Mutex::new(Fails));
        let link = FailingLink::new(self.board.clone(), never, outage, Failure::default());
        conversation(link)
    }

    fn board(&self) -> MutexGuard<'_, Emulator> {
        self.board.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Writes other settings with a hand on the button.
    fn change_settings(&mut self, client: &mut Client) -> Result<(), Fault> {
        self.told.turn_to(Doing::Settings);
        self.press_button(true)?;
        client.wait(BUTTON_SEEN)?;
        self.told.change_settings(client)?;
        self.press_button(false)?;
        client.wait(BUTTON_SEEN)?;
        Ok(())
    }

    fn press_button(&self, held: bool) -> Result<(), Fault> {
        Ok(self.board().press_button(held)?)
    }

    fn work(&mut self, client: &mut Client) -> Result<(), Fault> {
        self.change_settings(client)?;
        self.told.measure(client)?;
        self.told.download(client, &self.folder)?;
        self.told.release(client)
    }

    fn session(&mut self, client: &mut Client, outage: &Mutex<dyn Outage>) -> Result<(), Fault> {
        self.told.turn_to(Doing::Boot);
        // Whoever held it has let go: one that is down at a start opens nothing.
        self.press_button(false)?;
        client.wait(RESET)?;
        client.wait(BOOT)?;
        self.told.look(client, &self.folder)?;
        let mut outage = outage.lock().unwrap_or_else(PoisonError::into_inner);
        outage.started(&mut self.board())?;
        drop(outage);
        while self.board().uptime() < LONGEST {
            self.work(client)?;
        }
        Ok(())
    }
}

/// A host's conversation over `link`. It always counts its requests alike, so that the same cuts meet
/// the same instructions in every run: the restart before each of them forgets the last one's.
fn conversation(link: FailingLink) -> Client {
    Client::new(Box::new(link)).counting_from(0)
}
