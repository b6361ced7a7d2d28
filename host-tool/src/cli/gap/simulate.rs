//! `calib gap simulate`: a dataset of known cause.

use super::super::Context;
use calib_host::gap::believed::Believed;
use calib_host::gap::simulated::{Request, simulate};
use calib_host::{Error, Result};
use calib_twin::dataset;
use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// Which columns a dataset has.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum Columns {
    /// All of them.
    All,
    /// All but the coil current.
    NoCurrent,
    /// Frequency, conditions, ratio and phase.
    Ratio,
}

impl From<Columns> for dataset::Columns {
    fn from(columns: Columns) -> Self {
        match columns {
            Columns::All => Self::All,
            Columns::NoCurrent => Self::NoCurrent,
            Columns::Ratio => Self::RatioOnly,
        }
    }
}

/// `calib gap simulate`.
#[derive(Debug, Args)]
pub(crate) struct Simulate {
    /// Beliefs of the simulation: rig.toml, a dataset folder, a rig file, `standard` or `oscillator`.
    #[arg(value_name = "RIG")]
    rig: PathBuf,
    /// An effect of the measured side, with its usual values where none are given; may be repeated.
    #[arg(long, value_name = "NAME[=PARAM:VALUE,...]")]
    effect: Vec<String>,
    /// Folder of the dataset.
    #[arg(long, value_name = "DATASET")]
    out: PathBuf,
    /// Seed of noise, mountings and true values.
    #[arg(long, default_value_t = 0)]
    seed: u64,
    /// Columns to keep.
    #[arg(long, value_enum, default_value = "all")]
    columns: Columns,
    /// Put every nominal parameter this many standard uncertainties off.
    #[arg(long, value_name = "U", value_parser = off_by)]
    off_by: Option<f64>,
}

const OFF_BY: &str = "must be a number from 0 to 3: a rig farther off is a gap by definition";

fn off_by(text: &str) -> Result<f64, String> {
    let value: f64 = text.parse().map_err(|_| OFF_BY.to_owned())?;
    if (0.0..=3.0).contains(&value) {
        Ok(value)
    } else {
        Err(OFF_BY.to_owned())
    }
}

impl Simulate {
    /// Writes the dataset.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let table = ["points.csv", "record.csv"].map(|name| self.out.join(name));
        if table.iter().any(|path| path.exists()) {
            return Err(Error::input(
                self.out.display().to_string(),
                "holds a dataset already, and is not overwritten",
                "give another folder with --out",
            ));
        }
        let request = Request {
            effects: self.effect,
            seed: self.seed,
            columns: self.columns.into(),
            off_by: self.off_by,
        };
        let made = simulate(&Believed::load(&self.rig)?, &request, &self.out)?;
        context.print(&made, || {
            let cause = match made.effects.as_slice() {
                [] => "no effect".to_owned(),
                some => some.join(" and "),
            };
            let missing = match made.left_out {
                0 => String::new(),
                n => format!(", {n} settings left out"),
            };
            format!(
                "{}: {} rows with {cause}{missing}",
                self.out.display(),
                made.rows
            )
        })
    }
}
