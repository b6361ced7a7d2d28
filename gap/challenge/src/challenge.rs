//! Sealed sets: many datasets whose causes are written down and locked away.

use super::draw::{self, Drawn};
use super::strata::{Effect, Plan, Stratum};
use super::truth::{MANIFEST, Manifest, OpenCase, TrueCase, Truth, sha256};
use super::visible::Yardstick;
use calib_files::file::{self, Existing};
use calib_files::{Error, Result};
use calib_twin::dataset::{Nominal, Point, Setting, generate, points_csv, standard_design};
use calib_twin::effects::ActiveEffect;
use calib_twin::model::{Channel, Conditions, Model};
use rand_chacha::ChaCha12Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use rayon::prelude::*;
use schemars::JsonSchema;
use serde::Serialize;
use std::path::{Path, PathBuf};

/// An effect this small nobody can be asked to name, in standard uncertainties
/// of the whole dataset: another one is drawn, as long as one is found.
const LEAST_SIGMA: f64 = 10.0;
/// Range of sizes of [`Stratum::Size`].
const SIZES_SIGMA: [f64; 2] = [1.0, 1000.0];
/// Fewest rows of a usable case.
const LEAST_ROWS: usize = 60;
/// Draws until an effect is neither invisible nor beyond what the rig can hold.
const MOST_DRAWS: usize = 40;

/// Published facts of a set that was made.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Sealed {
    /// Folder of the set.
    pub folder: PathBuf,
    /// Number of datasets.
    pub cases: usize,
    /// File with the truth.
    pub truth: PathBuf,
    /// Its SHA-256: publish it before anybody answers.
    pub truth_sha256: String,
}

struct Measured {
    plan: Plan,
    points: Vec<Point>,
    size_sigma: f64,
    least_sigma: f64,
}

/// Description of a sealed set: the same description makes the same set.
#[derive(Clone)]
pub struct Design<'d> {
    /// Kinds of cases.
    pub strata: &'d [Stratum],
    /// Cases of each kind.
    pub per_stratum: usize,
    /// Effects that are drawn, in their turns: a new one anywhere in the list makes another set.
    pub effects: Vec<Effect>,
    /// Seed of all draws.
    pub seed: u64,
}

/// Makes the set of `design` in the folder `out`, and locks its truth.
/// Cases come in random order.
///
/// # Errors
/// [`Error::Input`] when the folder or the truth exists already; [`Error::File`].
pub fn challenge(
    out: &Path,
    design: &Design<'_>,
    progress: impl Fn(usize, usize) + Sync,
) -> Result<Sealed> {
    let truth_file = Truth::beside(out);
    refuse_existing(&[out, &truth_file])?;
    let nominal = Nominal::standard();
    let settings = standard_design(&nominal);
    let order = shuffled(design);
    let done = std::sync::atomic::AtomicUsize::new(0);
    let cases: Vec<TrueCase> = order
        .par_iter()
        .enumerate()
        .map(|(place, &(stratum, index))| {
            let name = format!("case-{:05}", place + 1);
            let case = case(&nominal, &settings, stratum, index, design);
            let case = store(&nominal, case, out, name)?;
            let count = done.fetch_add(1, std::sync::atomic::Ordering::Relaxed) + 1;
            progress(count, order.len());
            Ok(case)
        })
        .collect::<Result<_>>()?;
    seal(
        out,
        truth_file,
        Truth {
            seed: design.seed,
            cases,
        },
    )
}

fn refuse_existing(paths: &[&Path]) -> Result<()> {
    match paths.iter().find(|path| path.exists()) {
        None => Ok(()),
        Some(path) => Err(Error::input(
            path.display().to_string(),
            "exists already: a sealed set is never overwritten",
            "give another folder",
        )),
    }
}

/// All cases, in an order that tells nothing.
fn shuffled(design: &Design<'_>) -> Vec<(Stratum, usize)> {
    let mut order: Vec<(Stratum, usize)> = design
        .strata
        .iter()
        .flat_map(|&stratum| (0..design.per_stratum).map(move |index| (stratum, index)))
        .collect();
    let mut random = ChaCha12Rng::seed_from_u64(design.seed);
    for last in (1..order.len()).rev() {
        order.swap(last, draw::below(last + 1, &mut random));
    }
    order
}

/// A stream of random numbers of its own for each case.
fn stream(seed: u64, stratum: Stratum, index: usize) -> ChaCha12Rng {
    let mut random = ChaCha12Rng::seed_from_u64(seed);
    random.set_stream(1 + 1_000_000 * stratum as u64 + index as u64);
    random
}

fn case(
    nominal: &Nominal,
    settings: &[Setting],
    stratum: Stratum,
    index: usize,
    design: &Design<'_>,
) -> Measured {
    let mut random = stream(design.seed, stratum, index);
    let options = stratum.options(random.next_u64());
    let yardstick = Yardstick::new(nominal, settings, &options);
    let measure = |effects: &[Drawn]| {
        let points = generate(nominal, settings, effects, &options).points;
        let sigma = yardstick.sigma(&points);
        (points, sigma)
    };
    let wanted = (stratum == Stratum::Size).then(|| {
        let [least, most] = SIZES_SIGMA;
        least * (most / least).powf(draw::uniform(&mut random))
    });
    let mut last = None;
    for _ in 0..MOST_DRAWS {
        let mut plan = stratum.plan(index, &design.effects, &mut random);
        if !is_rig(nominal, &plan.effects) {
            continue;
        }
        if let Some(wanted) = wanted {
            resize(&mut plan.effects, wanted, |effects| measure(effects).1);
        }
        let (points, size_sigma) = measure(&plan.effects);
        let least_sigma = match plan.effects.as_slice() {
            [] | [_] => size_sigma,
            several => several
                .iter()
                .map(|effect| measure(std::slice::from_ref(effect)).1)
                .fold(f64::INFINITY, f64::min),
        };
        let enough = wanted.is_some() || plan.effects.is_empty() || least_sigma > LEAST_SIGMA;
        let usable = points.len() >= LEAST_ROWS && enough;
        last = Some(Measured {
            plan,
            points,
            size_sigma,
            least_sigma,
        });
        if usable {
            break;
        }
    }
    // Note: some draw is a rig.
    last.unwrap_or_else(|| Measured {
        plan: Stratum::Null.plan(index, &design.effects, &mut random),
        points: yardstick.into_points(),
        size_sigma: 0.0,
        least_sigma: 0.0,
    })
}

/// Whether there is such a rig: a suspension takes energy from the motion.
fn is_rig(nominal: &Nominal, effects: &[Drawn]) -> bool {
    let conditions = Conditions::usual(0.0);
    let [reference, dut] = [Channel::flat(1.0), Channel::flat(1.0)];
    let mut model = Model::new(nominal.exciter.model(0.0), reference, dut);
    for effect in effects {
        effect.apply(&conditions, &mut model);
    }
    model.coil.damping_ns_per_m > 0.0
}

/// Weakens or strengthens the effect until it changes the data by about `wanted`.
///
/// Every amplitude is scaled by one factor, found by bisection of its logarithm;
/// frequencies go the other way where that weakens the effect.
fn resize(effects: &mut [Drawn], wanted: f64, size: impl Fn(&[Drawn]) -> f64) {
    let [effect] = effects else { return };
    let original = effect.clone();
    let weaker_upwards = size(&[scaled(&original, 2.0)]) < size(&[scaled(&original, 0.5)]);
    let (mut low, mut high) = (-14.0_f64, 3.0_f64);
    for _ in 0..14 {
        let middle = 0.5 * (low + high);
        let exponent = if weaker_upwards { -middle } else { middle };
        *effect = scaled(&original, exponent.exp());
        if size(std::slice::from_ref(effect)) < wanted {
            low = middle;
        } else {
            high = middle;
        }
    }
}

/// The effect with its first parameter (its size, or the frequency it sits at) scaled.
fn scaled(effect: &Drawn, factor: f64) -> Drawn {
    let mut values = effect.values().to_vec();
    let entry = effect.effect().entry;
    for (value, parameter) in values.iter_mut().zip(entry.parameters).take(entry.sizes) {
        let [lowest, highest] = parameter.simulated;
        *value = (*value * factor).clamp(lowest, highest);
    }
    // Note: within bounds by the line above.
    ActiveEffect::new(effect.effect(), &values).unwrap_or_else(|_| effect.clone())
}

fn store(nominal: &Nominal, case: Measured, out: &Path, name: String) -> Result<TrueCase> {
    let folder = out.join(&name);
    let failed = |error| Error::file("write", &folder, error);
    calib_twin::dataset::write(&folder, nominal, &case.points).map_err(failed)?;
    let rig = std::fs::read(folder.join("rig.toml")).map_err(failed)?;
    let dataset = [rig, points_csv(&case.points).into_bytes()].concat();
    let effects = &case.plan.effects;
    let mut names: Vec<String> = effects
        .iter()
        .map(|e| e.effect().entry.id.to_owned())
        .collect();
    names.sort();
    let stage = |e: &Drawn| e.effect().entry.stage.to_string();
    Ok(TrueCase {
        name,
        stratum: case.plan.stratum.name().to_owned(),
        names,
        effects: effects.iter().map(ToString::to_string).collect(),
        stages: effects.iter().map(stage).collect(),
        without: case.plan.without,
        size_sigma: case.size_sigma,
        least_sigma: case.least_sigma,
        dataset_sha256: sha256(&dataset),
    })
}

fn seal(out: &Path, truth_file: PathBuf, truth: Truth) -> Result<Sealed> {
    let json = |value: serde_json::Result<Vec<u8>>| {
        value.map_err(|e| Error::input("challenge", e.to_string(), "report this as a defect"))
    };
    let bytes = json(serde_json::to_vec_pretty(&truth))?;
    let open = |case: &TrueCase| OpenCase {
        name: case.name.clone(),
        without: case.without.clone(),
    };
    let manifest = Manifest {
        truth_sha256: sha256(&bytes),
        cases: truth.cases.iter().map(open).collect(),
    };
    file::write(&truth_file, &bytes, Existing::Keep)?;
    let text = json(serde_json::to_vec_pretty(&manifest))?;
    file::write(&out.join(MANIFEST), &text, Existing::Keep)?;
    Ok(Sealed {
        folder: out.to_owned(),
        cases: truth.cases.len(),
        truth: truth_file,
        truth_sha256: manifest.truth_sha256,
    })
}
