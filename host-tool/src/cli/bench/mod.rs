//! The bench of records at the command line.

mod entries;
mod export;
mod history;
mod sensors;

pub(crate) use entries::BenchVerb;
pub(crate) use export::Export;
pub(crate) use history::History;
pub(crate) use sensors::{Sensors, find as find_sensor};

use super::Context;
use calib_files::Result;
use calib_logbook::{Bench, default_path};

impl Context {
    /// The bench to look into.
    fn bench(&self) -> Result<Bench> {
        Bench::open_existing(&self.bench_path())
    }

    /// The bench to add to, created if it is not there.
    fn bench_to_add_to(&self) -> Result<Bench> {
        Bench::open(&self.bench_path())
    }

    /// The bench, if this user has one: then runs and certificates are entered.
    pub(super) fn bench_if_there(&self) -> Result<Option<Bench>> {
        Bench::open_if_there(&self.bench_path())
    }

    /// Where the bench is, or would be.
    pub(super) fn bench_path(&self) -> std::path::PathBuf {
        self.bench.clone().unwrap_or_else(default_path)
    }
}
