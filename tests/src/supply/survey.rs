//! Cuts of a session that goes on: each on a second board, with the flash a cut would have left.

use super::outage::{Next, Outage};
use super::plan::Plan;
use super::tally::Tally;
use super::told::Told;
use super::{Cut, Desk, Met};
use crate::rigged::Fault;
use calib_twin::runner::{Emulator, FlashAtCut, Torn};
use std::path::Path;

/// Name of a restart that nothing but the supply has caused.
const POWER_ON: &str = "PowerOn";

/// Looks at every cut of a desk's session on a second board.
pub struct Survey {
    second: Desk,
    /// Knowledge of the first host.
    told: Told,
    plan: Plan,
    tally: Tally,
    /// Number of things the first host was told by the last cut.
    heard: u32,
    /// So many cuts end it, the last of which comes.
    wanted: u32,
    /// Flash of the second board after its start, when the first one's supply failed at the same instant.
    expected: Option<Aftermath>,
}

/// Flash after a start: content, and how many words cannot be read.
#[derive(PartialEq)]
struct Aftermath {
    content: Vec<u8>,
    poisoned: usize,
}

impl Aftermath {
    fn of(board: &mut Emulator) -> Result<Self, Fault> {
        Ok(Self {
            content: board.record_flash()?,
            poisoned: board.flash_watch().poisoned_words(),
        })
    }
}

impl Survey {
    /// A survey of `wanted` cuts of `desk`, drawn from `seed`; the second host downloads to `folder`.
    ///
    /// # Errors
    /// The image is missing or does not run.
    pub fn new(desk: &Desk, folder: &Path, wanted: u32, seed: u64) -> Result<Self, Fault> {
        Ok(Self {
            second: Desk::new(folder)?,
            told: desk.told.clone(),
            plan: Plan::new(seed),
            tally: Tally::default(),
            heard: 0,
            wanted,
            expected: None,
        })
    }

    /// The cuts so far.
    pub fn tally(&self) -> &Tally {
        &self.tally
    }

    /// Whether all its cuts were.
    pub fn is_done(&self) -> bool {
        self.tally.cuts() >= self.wanted
    }

    /// Loads of the second board's core that met a word whose check bits do not fit.
    pub fn poisoned_loads(&self) -> u64 {
        self.second.poisoned_loads()
    }

    /// The first cut of a spell.
    pub(super) fn first(&mut self) -> Cut {
        self.plan.first()
    }

    /// Gives the second board the flash of a cut, cuts its start as often as `again` says, and looks.
    fn look_at(&mut self, flash: &FlashAtCut, again: &[Cut], works: bool) -> Result<(), Fault> {
        self.second.take_over(flash, &self.told)?;
        let restarts = self.second.board().resets()?.len();
        let compared = self.second.compared();
        for cut in again {
            let met = self.second.cut(*cut)?;
            self.tally.note_again(met.torn);
        }
        self.second.look()?;
        self.tally.starts += 1 + again.len() as u32;
        if works {
            self.second.round()?;
            self.tally.rounds += 1;
        }
        self.tally.compared += self.second.compared() - compared;
        let causes = self.second.board().resets()?;
        match causes
            .iter()
            .skip(restarts)
            .find(|cause| *cause != POWER_ON)
        {
            Some(cause) => Err(format!("a start ended by {cause}").into()),
            None => Ok(()),
        }
    }
}

impl Outage for Survey {
    /// A cut is due after each thing told: something told from memory and not from flash is lost then.
    fn is_due(&self) -> bool {
        self.told.known().tells != self.heard
    }

    fn come(&mut self, board: &mut Emulator) -> Result<Next, Fault> {
        self.heard = self.told.known().tells;
        let flash = board.flash_at_cut()?;
        let (doing, torn) = (self.told.known().doing, flash.torn());
        let fate = self.plan.fate(matches!(torn, Torn::Sector { .. }));
        let place = format!("{doing:?}, {torn:?}, then {:?}", fate.again);
        let comes = fate.comes || self.tally.cuts() + 1 >= self.wanted;
        let again = if comes { &[][..] } else { &fate.again };
        self.look_at(&flash, again, fate.works && !comes)
            .map_err(|fault| format!("cut {}, {place}: {fault}", self.tally.cuts()))?;
        self.tally.note(Met { doing, torn });
        if !comes {
            return Ok(Next::GoOn(self.plan.next(board)));
        }
        self.expected = Some(Aftermath::of(&mut self.second.board())?);
        Ok(Next::Fail)
    }

    fn started(&mut self, board: &mut Emulator) -> Result<(), Fault> {
        let Some(expected) = self.expected.take() else {
            return Ok(());
        };
        self.tally.came += 1;
        match Aftermath::of(board)? == expected {
            true => Ok(()),
            false => Err("the second board has come up with other flash than the first".into()),
        }
    }
}
