//! Sealed records of an oscillator: as [`case`](super::case), integrated in time and without a size in sigma.

use super::case::{Outcome, Unkind, folder_of, is_withheld, processor_s, random_of};
use super::sealed::oscillator::{Added, RIG, added, record_with};
use super::sealed::random::Random;
use calib_gap::{GapError, Options, diagnose};
use std::path::Path;

/// Effects that show by themselves.
const NAMES: [&str; 15] = [
    "cubic_stiffness",
    "quadratic_stiffness",
    "coulomb_friction",
    "quadratic_damping",
    "cubic_damping",
    "input_delay",
    "input_saturation",
    "output_highpass",
    "output_lowpass",
    "output_clipping",
    "output_trend",
    "resonance_drift",
    "second_mode",
    "dead_zone",
    "hysteresis",
];
const SAMPLES: usize = 2000;
/// P-value of a remainder that shows: what leaves less is as good as the truth.
const SHOWS: f64 = 0.01;

/// Whether a stratum is of records.
pub(super) fn is_of_records(stratum: &str) -> bool {
    stratum.starts_with("record")
}

/// Draws, diagnoses and scores a record.
pub(super) fn run(stratum: &str, index: u64, seed: u64) -> Result<Outcome, GapError> {
    let folder = folder_of(stratum, index);
    let mut random = random_of(index, seed);
    let (truth, motion) = draw(stratum, index, &mut random);
    let noise = random.log_between(1e-5, 1e-3);
    write(&folder, &record_with(&motion, SAMPLES, noise, &mut random))
        .map_err(|source| GapError::Usage(source.to_string()))?;
    let mut options = Options::default();
    if is_withheld(stratum) {
        options.without = truth.iter().map(ToString::to_string).collect();
    }
    let start = processor_s();
    let answer = diagnose(&folder, &options);
    let time_s = processor_s() - start;
    let _ = std::fs::remove_dir_all(&folder);
    let answer = answer?;
    let left = answer.none_of_these_p_value < SHOWS;
    Ok(Outcome {
        index,
        truth,
        time_s,
        sigma: f64::INFINITY,
        left_sigma: if left { f64::INFINITY } else { 0.0 },
        conditional_sigma: Vec::new(),
        unkind: Unkind::default(),
        answer,
    })
}

fn write(folder: &Path, record: &str) -> std::io::Result<()> {
    std::fs::create_dir_all(folder)?;
    std::fs::write(folder.join("rig.toml"), RIG)?;
    std::fs::write(folder.join("record.csv"), record)
}

/// Effects of a record, a tenth to three times as strong as usual; two at a time a third to three times.
fn draw(stratum: &str, index: u64, random: &mut Random) -> (Vec<&'static str>, Added) {
    let name = NAMES[index as usize % NAMES.len()];
    match stratum {
        "record_form" => other_form(index, random),
        "record_pairs" => {
            let others: Vec<_> = NAMES.into_iter().filter(|other| *other != name).collect();
            let other = others[random.below(others.len())];
            let [one, two] = [name, other].map(|n| added(n).scaled(random.log_between(0.3, 3.0)));
            (vec![name, other], one.and(two))
        }
        _ => {
            let factor = random.log_between(0.1, 3.0);
            (vec![name], added(name).scaled(factor))
        }
    }
}

/// Springs that soften as a sine or harden with the fifth power, and friction that is larger at rest, alone or beside a
/// spring that slips.
fn other_form(index: u64, random: &mut Random) -> (Vec<&'static str>, Added) {
    let none = Added::default();
    let sticks = Added {
        friction: 0.003,
        sticking: random.log_between(0.2, 1.0),
        ..none.clone()
    };
    match index % 4 {
        0 => {
            let sine = random.log_between(1.0, 6.0);
            (vec!["cubic_stiffness"], Added { sine, ..none })
        }
        1 => {
            let quintic = random.log_between(3.0, 100.0);
            (vec!["cubic_stiffness"], Added { quintic, ..none })
        }
        2 => (vec!["coulomb_friction"], sticks),
        _ => {
            let slips = added("hysteresis").scaled(random.log_between(0.1, 3.0));
            (vec!["coulomb_friction", "hysteresis"], sticks.and(slips))
        }
    }
}
