//! The sets that are diagnosed: drawn anew from fixed seeds, or measured.

use super::sealed::oscillator::{RIG, added, record};
use super::sealed::random::Random;
use super::{Fault, case};
use calib_gap::Options;
use calib_gap_challenge::draw::nameable;
use calib_gap_challenge::strata::Stratum;
use calib_gap_challenge::truth::{MANIFEST, Manifest};
use calib_gap_challenge::{Design, challenge};
use rayon::prelude::*;
use std::path::{Path, PathBuf};

/// Strata of the generator that shares nothing with the twin, and cases of each.
const INDEPENDENT: [(&str, u64); 7] = [
    ("null", 16),
    ("off2u", 12),
    ("single", 42),
    ("ratio", 20),
    ("pairs", 30),
    ("withheld", 21),
    ("size", 21),
];
/// Cases of each stratum of the twin.
const OF_TWIN: usize = 20;
const OSCILLATORS: &str = "\
    cubic_stiffness quadratic_stiffness coulomb_friction quadratic_damping cubic_damping \
    input_delay input_saturation output_highpass second_mode dead_zone hysteresis";
const OSCILLATOR_SAMPLES: usize = 3000;
const SEED: u64 = 20_261_122;
/// Effects that are drawn: those of the day of the baseline, so that a new one changes no set.
const DRAWN: &str = "\
    adc_clipping adc_cubic adc_dead_zone adc_quadratic ambient_vibration amplifier_clipping \
    amplifier_even_order amplifier_gain_drift armature_mode averaging_window back_emf \
    base_strain channel_skew clock_offset coil_heating coulomb_friction crosstalk dut_drift \
    dut_frequency_slope dut_highpass dut_level_nonlinearity dut_lowpass_1 dut_lowpass_2 \
    dut_resonance dut_temperature force_factor_droop gravity_tilt loose_mount \
    lossy_inductance mains_pickup mechanical_damping mount_compliance payload_mass \
    reference_drift reference_highpass reference_resonance reference_temperature \
    relative_motion sampling_jitter suspension_asymmetry suspension_cubic transverse_motion";
/// Measured sets beside the repository, and one to score on.
const MEASURED: [(&str, Option<&str>); 13] = [
    ("cmi_low_frequency", None),
    ("ptb_accelerometer_sine", None),
    ("ptb_accelerometer_shock", None),
    ("real_emps_position", None),
    ("real_emps_spring1", None),
    ("real_opamp_highpass", None),
    ("real_opamp_lowpass", None),
    ("real_rc_highpass", None),
    ("real_rc_lowpass", None),
    ("shaker_drive", None),
    ("silverbox_fit", None),
    ("silverbox_fit", Some("silverbox_multisine")),
    ("silverbox_fit", Some("silverbox_arrow")),
];

/// A dataset and how it is diagnosed.
pub(super) struct Set {
    pub(super) name: String,
    pub(super) folder: PathBuf,
    pub(super) options: Options,
}

/// All sets, those that are drawn written below `folder`.
pub(super) fn all(folder: &Path) -> Result<Vec<Set>, Fault> {
    let mut sets = independent(folder)?;
    sets.extend(of_twin(folder)?);
    sets.extend(oscillators(folder)?);
    sets.extend(measured());
    Ok(sets)
}

fn independent(root: &Path) -> Result<Vec<Set>, Fault> {
    let cases: Vec<(&str, u64)> = INDEPENDENT
        .iter()
        .flat_map(|&(stratum, count)| (0..count).map(move |index| (stratum, index)))
        .collect();
    let draw = |&(stratum, index): &(&str, u64)| {
        let name = format!("independent-{stratum}-{index:02}");
        let folder = root.join(&name);
        let options = case::write(stratum, index, SEED, &folder)?.options;
        Ok(Set {
            name,
            folder,
            options,
        })
    };
    cases.par_iter().map(draw).collect()
}

fn of_twin(root: &Path) -> Result<Vec<Set>, Fault> {
    let out = root.join("twin");
    let mut effects = nameable();
    effects.retain(|effect| DRAWN.split(' ').any(|name| name == effect.entry.id));
    let design = Design {
        strata: &Stratum::ALL,
        per_stratum: OF_TWIN,
        effects,
        seed: SEED,
    };
    challenge(&out, &design, |_, _| ())?;
    let manifest = Manifest::find(&out)?.ok_or_else(|| format!("no {MANIFEST}"))?;
    let set = |case: calib_gap_challenge::truth::OpenCase| Set {
        folder: out.join(&case.name),
        name: format!("twin-{}", case.name),
        options: Options {
            without: case.without,
            ..Options::default()
        },
    };
    Ok(manifest.cases.into_iter().map(set).collect())
}

fn oscillators(root: &Path) -> Result<Vec<Set>, Fault> {
    let draw = |(seed, name): (usize, &&str)| {
        let folder = root.join(name);
        let mut random = Random::new(SEED + seed as u64);
        std::fs::create_dir_all(&folder)?;
        std::fs::write(folder.join("rig.toml"), RIG)?;
        let text = record(&added(name), OSCILLATOR_SAMPLES, &mut random);
        std::fs::write(folder.join("record.csv"), text)?;
        Ok(Set {
            name: format!("oscillator-{name}"),
            folder,
            options: Options::default(),
        })
    };
    let names: Vec<&str> = OSCILLATORS.split(' ').collect();
    names.par_iter().enumerate().map(draw).collect()
}

/// Those that are there.
fn measured() -> Vec<Set> {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../shared/data");
    let set = |(name, validate): (&str, Option<&str>)| Set {
        name: match validate {
            Some(other) => format!("measured-{name}-{other}"),
            None => format!("measured-{name}"),
        },
        folder: root.join(name),
        options: Options {
            validate: validate.map(|other| root.join(other)),
            ..Options::default()
        },
    };
    let sets = MEASURED.into_iter().map(set);
    let (there, missing): (Vec<Set>, Vec<Set>) =
        sets.partition(|set| set.folder.join("rig.toml").is_file());
    for set in missing {
        eprintln!("{} is missing: left out", set.folder.display());
    }
    there
}
