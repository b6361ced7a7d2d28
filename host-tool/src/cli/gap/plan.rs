//! `calib gap plan`: what to measure next.

use super::super::Context;
use super::misuse::unusable;
use calib_gap::{ENOUGH_SIGMA, Measurement, Pair, Plan};
use calib_host::gap::believed::Believed;
use calib_host::gap::simulated::{Request, simulate};
use calib_host::{Error, Result};
use clap::Args;
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Rigs that are built in.
const NAMES: [&str; 2] = ["standard", "oscillator"];
/// Pairs that are printed.
const MOST_PAIRS: usize = 12;

/// `calib gap plan`.
#[derive(Debug, Args)]
pub(crate) struct PlanVerb {
    /// A dataset, or the beliefs of a simulation: rig.toml, a rig file, `standard`.
    #[arg(value_name = "DATASET|RIG")]
    input: PathBuf,
    /// Most measurements.
    #[arg(long, default_value_t = 24, value_parser = clap::value_parser!(u8).range(1..=100))]
    most: u8,
}

impl PlanVerb {
    /// Plans and prints.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let most = usize::from(self.most);
        let plan = if is_dataset(&self.input) {
            calib_gap::plan(&self.input, false, most).map_err(|e| unusable(&self.input, e))?
        } else {
            of_rig(&self.input, most)?
        };
        context.print(&plan, || text(&plan))
    }
}

fn is_dataset(input: &Path) -> bool {
    ["points.csv", "record.csv"]
        .iter()
        .any(|table| input.join(table).exists())
}

/// The usual session of the rig says which conditions are in reach.
fn of_rig(rig: &Path, most: usize) -> Result<Plan> {
    if !rig.exists() && rig.extension().is_none() && !NAMES.iter().any(|n| rig == Path::new(n)) {
        return Err(Error::usage(
            format!("there is no {}", rig.display()),
            "give a dataset folder, a rig.toml, a rig file of the emulated calibrator, or `standard`",
        ));
    }
    let believed = Believed::load(rig)?;
    let failed = |e| Error::file("create", &std::env::temp_dir(), e);
    let folder = tempfile::tempdir().map_err(failed)?;
    if matches!(believed, Believed::Oscillator(_)) {
        return Err(Error::input(
            rig.display().to_string(),
            "is an oscillator, for which there is no plan of points",
            "take a record of larger amplitude, and one of half the amplitude",
        ));
    }
    simulate(&believed, &Request::default(), folder.path())?;
    calib_gap::plan(folder.path(), true, most).map_err(|e| unusable(rig, e))
}

fn text(plan: &Plan) -> String {
    let mut text = String::new();
    let told = |p: &Pair| p.sigma_now >= ENOUGH_SIGMA;
    if plan.pairs.iter().all(told) {
        let _ = writeln!(text, "what is possible is told apart already");
    } else if plan.measurements.is_empty() {
        let _ = writeln!(text, "no point in reach tells what is possible apart");
    } else {
        let _ = writeln!(
            text,
            "{:>9} {:>8} {:>5} {:>5} {:>7} {:>6} {:>8}  what it is for",
            "Hz", "m/s2", "rot", "tilt", "kg", "degC", "time/s"
        );
    }
    for m in &plan.measurements {
        line(&mut text, m);
    }
    let open = |p: &&Pair| p.sigma_after < ENOUGH_SIGMA;
    let left = plan.pairs.iter().filter(open).count();
    let _ = writeln!(
        text,
        "{} of {} pairs are told apart by {ENOUGH_SIGMA} sigma or more once all are measured:",
        plan.pairs.len() - left,
        plan.pairs.len()
    );
    let mut pairs: Vec<&Pair> = plan.pairs.iter().collect();
    pairs.sort_by(|a, b| a.sigma_after.total_cmp(&b.sigma_after));
    for pair in pairs.iter().take(MOST_PAIRS) {
        let _ = writeln!(
            text,
            "  {:<52} {:>8.1} sigma now, {:>8.1} after",
            format!("{} / {}", set(&pair.one), set(&pair.other)),
            pair.sigma_now,
            pair.sigma_after
        );
    }
    text.trim_end().to_owned()
}

fn line(text: &mut String, m: &Measurement) {
    let level = m
        .acceleration_ms2
        .map_or("-".to_owned(), |a| format!("{a:.2}"));
    let extra = match m.extra_columns.as_slice() {
        [] => String::new(),
        some => format!(" (with {})", some.join(", ")),
    };
    let _ = writeln!(
        text,
        "{:>9.1} {level:>8} {:>5.0} {:>5.0} {:>7.3} {:>6.1} {:>8.0}  {}{extra}: {} from {}, then {:.1} sigma",
        m.frequency_hz,
        m.rotation_deg,
        m.tilt_deg,
        m.payload_kg,
        m.temperature_c,
        m.time_s,
        m.look_at,
        set(&m.separates[0]),
        set(&m.separates[1]),
        m.sigma
    );
}

fn set(names: &[&str]) -> String {
    match names {
        [] => "nothing".into(),
        some => some.join("+"),
    }
}
