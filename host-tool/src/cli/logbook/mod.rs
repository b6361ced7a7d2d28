//! The logbook at the command line.

mod assure;
mod entries;
mod export;
mod history;
mod sensors;
mod upkeep;

pub(super) use assure::Assurance;
pub(crate) use assure::Assure;
pub(crate) use entries::LogbookVerb;
pub(super) use entries::{Added, Written};
pub(crate) use export::Export;
pub(super) use export::Exported;
pub(crate) use history::History;
pub(crate) use sensors::{Sensors, find as find_sensor};
pub(super) use upkeep::{Backup, Problem};

use super::Context;
use calib_files::Result;
use calib_logbook::{Logbook, default_path};

impl Context {
    /// The logbook to look into.
    pub(super) fn logbook(&self) -> Result<Logbook> {
        Logbook::open_existing(&self.logbook_path())
    }

    /// The logbook to add to, created if it is not there.
    fn logbook_to_add_to(&self) -> Result<Logbook> {
        Logbook::open(&self.logbook_path())
    }

    /// The logbook, if this user has one: then certificates are entered.
    pub(super) fn logbook_if_there(&self) -> Result<Option<Logbook>> {
        Logbook::open_if_there(&self.logbook_path())
    }

    /// Where the logbook is, or would be.
    pub(super) fn logbook_path(&self) -> std::path::PathBuf {
        self.logbook.clone().unwrap_or_else(default_path)
    }
}
