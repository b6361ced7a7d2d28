//! Frozen answers: whether diagnoses and certificates are what they were. `bench_frozen [--accept REASON]`
//!
//! Diagnoses the same sealed sets of both generators, records of oscillators and the measured sets,
//! writes the certificates of the kept records, and compares all with the baseline in `tests/frozen`.
//! A difference is listed and fails the bench; `--accept REASON` makes today's answers the baseline and
//! keeps the reason. Measured sets lie beside the repository; without them they are left out.

#[path = "../../../gap/examples/bench_gap/case.rs"]
#[allow(dead_code)]
mod case;
mod certificates;
mod compare;
#[path = "../../../gap/tests/sealed/mod.rs"]
#[allow(dead_code)]
mod sealed;
mod sets;
mod summary;
mod yardstick;

use compare::Differences;
use rayon::prelude::*;
use serde_json::Value;
use std::collections::BTreeMap;
use std::error::Error;
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// An error of any kind: there is nothing to recover.
type Fault = Box<dyn Error + Send + Sync>;

/// Answers or digests by the name of their set or file.
type Frozen = BTreeMap<String, Value>;

/// Most that a diagnosis may take longer than it did, in units of the yardstick.
const SLOWER_LIMIT: f64 = 1.05;

fn main() -> Result<(), Fault> {
    let reason = reason()?;
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("frozen");
    let (answers, times) = diagnoses()?;
    let certificates = certificates::digests(&folder.join("records"))?;
    let baseline = [
        ("answers.json", &answers),
        ("certificates.json", &certificates),
    ];
    let mut found = Differences::default();
    for (file, now) in baseline {
        found.compare(&read(&folder.join(file))?, now);
    }
    let times_before = read(&folder.join("times.json"))?;
    let slower = slower(&times_before, &times);
    println!(
        "{} answers, {} certificates",
        answers.len(),
        certificates.len()
    );
    print!("{found}");
    println!("time of a diagnosis, median: {slower:.3} of what it was");
    if let Some(reason) = reason {
        // Slower answers are accepted, a slower diagnosis is not: sets that had a time keep it.
        let mut times = times;
        if slower > SLOWER_LIMIT {
            for (name, time_before) in times_before {
                times.entry(name).and_modify(|time| *time = time_before);
            }
        }
        for (file, now) in baseline.iter().chain(&[("times.json", &times)]) {
            std::fs::write(folder.join(file), lines(now)?)?;
        }
        return keep(&folder.join("REASONS.md"), &reason, &found, slower);
    }
    match (found.is_empty(), slower > SLOWER_LIMIT) {
        (true, false) => Ok(()),
        (false, _) => {
            Err("answers differ: mend them, or `./run bench frozen --accept REASON`".into())
        }
        (true, true) => Err(format!("diagnoses take {slower:.3} times as long").into()),
    }
}

/// The reason of `--accept REASON`.
fn reason() -> Result<Option<String>, Fault> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match arguments.split_first() {
        None => Ok(None),
        Some((flag, words)) if flag == "--accept" && !words.is_empty() => Ok(Some(words.join(" "))),
        Some(_) => Err("usage: ./run bench frozen [--accept REASON]".into()),
    }
}

/// Answers of all sets, and the processor time of each in units of the yardstick.
fn diagnoses() -> Result<(Frozen, Frozen), Fault> {
    let folder = tempfile::tempdir()?;
    let sets = sets::all(folder.path())?;
    let before = yardstick::seconds();
    let diagnosed: Vec<(String, Value, f64)> = sets
        .par_iter()
        .map(|set| {
            let start = case::processor_s();
            let answer = calib_gap::diagnose(&set.folder, &set.options)?;
            let seconds = case::processor_s() - start;
            Ok((set.name.clone(), summary::of(&answer)?, seconds))
        })
        .collect::<Result<_, Fault>>()?;
    let unit = 0.5 * (before + yardstick::seconds());
    let times = diagnosed
        .iter()
        .map(|(name, _, seconds)| (name.clone(), Value::from(seconds / unit)));
    let times = times.collect();
    let answers = diagnosed
        .into_iter()
        .map(|(name, answer, _)| (name, answer));
    Ok((answers.collect(), times))
}

/// Median over the sets of their time over that of the baseline; 1 without a baseline.
fn slower(before: &Frozen, now: &Frozen) -> f64 {
    let ratio =
        |(name, time): (&String, &Value)| Some(time.as_f64()? / before.get(name)?.as_f64()?);
    let mut ratios: Vec<f64> = now.iter().filter_map(ratio).collect();
    ratios.sort_by(f64::total_cmp);
    ratios.get(ratios.len() / 2).copied().unwrap_or(1.0)
}

fn read(path: &Path) -> Result<Frozen, Fault> {
    match std::fs::read(path) {
        Ok(bytes) => Ok(serde_json::from_slice(&bytes)?),
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => Ok(Frozen::new()),
        Err(error) => Err(error.into()),
    }
}

/// JSON with one line per entry, so that a diff shows what changed.
fn lines(frozen: &Frozen) -> Result<String, Fault> {
    let entries: Vec<String> = frozen
        .iter()
        .map(|(name, value)| Ok(format!("{}: {value}", serde_json::to_string(name)?)))
        .collect::<Result<_, Fault>>()?;
    Ok(format!("{{\n{}\n}}\n", entries.join(",\n")))
}

/// Adds the reason, and what it accepts, to the list of them.
fn keep(path: &Path, reason: &str, found: &Differences, slower: f64) -> Result<(), Fault> {
    let mut text =
        std::fs::read_to_string(path).unwrap_or_else(|_| "# Why frozen answers changed\n".into());
    write!(
        text,
        "\n- {reason}\n  {}; time {slower:.3} of what it was.\n",
        found.count()
    )?;
    std::fs::write(path, text)?;
    Ok(())
}
