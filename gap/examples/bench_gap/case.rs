//! One sealed case: drawn, written, diagnosed, compared with the truth.

use super::sealed::random::Random;
use super::sealed::scatter::{Deviates, Scatter};
use super::sealed::table::{self, GOOD};
use super::sealed::truth::{FORMS, NOMINAL, OTHER_FORM, Truth};
use super::sealed::{design, effects as drawn_effects};
use calib_effects::{Entry, Of, named};
use calib_gap::{Answer, Cause, GapError, Options, Verdict, diagnose, misfit};
use std::fmt;
use std::path::{Path, PathBuf};

/// An effect smaller than this, with its form known, is not asked for by name.
pub(super) const VISIBLE_SIGMA: f64 = 6.0;

/// Outcome of a case.
pub(super) struct Outcome {
    pub(super) index: u64,
    pub(super) truth: Vec<&'static str>,
    pub(super) answer: Answer,
    /// Processor time of the diagnosis, in s.
    pub(super) time_s: f64,
    /// Size in standard deviations of the whole dataset, with the true form known.
    pub(super) sigma: f64,
    /// Remainder of the best substitute, in the same unit (strata `withheld` and of several effects).
    pub(super) left_sigma: f64,
    /// Size of each true effect beside the others, in the same unit; empty where it is alone.
    pub(super) conditional_sigma: Vec<f64>,
    /// How the noise differs from what is stated.
    pub(super) unkind: Unkind,
}

/// How the noise of a case differs from what its dataset states.
#[derive(Debug, Clone, Default)]
pub(super) struct Unkind {
    /// True scatter over the stated one.
    pub(super) factor: Option<f64>,
    /// Share of its deviate that a row remembers of the one before it.
    pub(super) memory: Option<f64>,
    /// Rows that were misread, from 0.
    pub(super) misread: Vec<usize>,
}

impl Unkind {
    /// Factor by which the noise may hide more than it is stated to. Of noise with a memory the
    /// mean over many rows is worse than that of independent ones by this much.
    pub(super) fn hides(&self) -> f64 {
        let remembered = self.memory.map(|m| ((1.0 + m) / (1.0 - m)).sqrt());
        self.factor.or(remembered).unwrap_or(1.0)
    }
}

impl Outcome {
    /// Place of the true set among the causes, and its probability.
    pub(super) fn place(&self) -> Option<(usize, f64)> {
        let same = |effects: &[&str]| {
            effects.len() == self.truth.len() && self.truth.iter().all(|t| effects.contains(t))
        };
        let at = self.answer.causes.iter().position(|c| same(&c.effects))?;
        Some((at, self.answer.causes[at].probability))
    }

    /// Whether the stage of the (first) true effect is among the first two places.
    pub(super) fn stage_found(&self) -> bool {
        let truth = self.truth.first().and_then(|id| named(Of::Calibrator, id));
        let first_two = self.answer.r#where.iter().take(2);
        truth.is_some_and(|t| first_two.into_iter().any(|w| w.stage == t.stage))
    }

    /// Whether a set names what is at work: nothing that is not there, and all that shows beside the rest.
    pub(super) fn is_right(&self, set: &Cause) -> bool {
        let shows = |at: usize| {
            let beside = self.conditional_sigma.get(at);
            beside.is_none_or(|sigma| *sigma > VISIBLE_SIGMA)
        };
        let mut asked = (0..self.truth.len()).filter(|at| shows(*at));
        set.effects.iter().all(|name| self.truth.contains(name))
            && asked.all(|at| set.effects.contains(&self.truth[at]))
    }

    pub(super) fn is(&self, verdict: Verdict) -> bool {
        self.answer.verdict == verdict
    }
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let a = &self.answer;
        let causes: Vec<String> = a
            .causes
            .iter()
            .take(12)
            .map(|c| {
                let [right, doubts] = [usize::from(self.is_right(c)), c.cautions.len()];
                let names = c.effects.join("+");
                format!("{names}:{:.4}/{doubts}/{right}", c.probability)
            })
            .collect();
        let stages: Vec<&str> = a.r#where.iter().map(|w| w.stage.name()).collect();
        let noise = &a.noise;
        write!(
            f,
            "{} {} {:?} {:?}{:?}{:?} other={:.3} p={:.2e} sigma={:.1}{:.0?} left={:.1} top={} stage={} chi={:.2}>{:.2} closed={:.3} {:.2}s [{}] {}",
            self.index,
            self.truth.join("+"),
            a.verdict,
            noise.factor_on_u,
            noise.memory,
            noise.outlier_rows,
            a.probability_other,
            a.none_of_these_p_value,
            self.sigma,
            self.conditional_sigma,
            self.left_sigma,
            self.place().is_some_and(|p| p.0 == 0),
            self.stage_found(),
            a.gap.size.chi_before,
            a.gap.size.chi_after,
            a.gap.size.closed.unwrap_or(f64::NAN),
            self.time_s,
            causes.join(" "),
            stages.join(",")
        )
    }
}

/// Processor time of this thread (Linux), in s.
pub(super) fn processor_s() -> f64 {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap_or_default();
    let nanoseconds = text.split_whitespace().next();
    nanoseconds
        .and_then(|t| t.parse::<f64>().ok())
        .unwrap_or(0.0)
        * 1e-9
}

fn names(stratum: &str, index: u64, random: &mut Random) -> Vec<&'static str> {
    let all: Vec<&'static str> = drawn_effects::names().collect();
    let later: Vec<&'static str> = drawn_effects::later_names().collect();
    let turn = |list: &[&'static str]| vec![list[index as usize % list.len()]];
    // Over frequency, rotation, payload, temperature and time, but not over level.
    let seen = |entry: &Entry| entry.shows_in_ratio() && !entry.shows_in("acceleration_ms2");
    let is_seen = |name: &&&str| named(Of::Calibrator, name).is_some_and(seen);
    let seen_in_ratio: Vec<&'static str> = all.iter().filter(is_seen).copied().collect();
    match stratum {
        "null" | "off2u" | "noise_1.2" | "noise_2" | "misread" | "memory" => Vec::new(),
        "form" => turn(&FORMS),
        "ratio" => turn(&seen_in_ratio),
        "pairs" | "beside" => several(2, &all, random),
        "triples" => several(3, &all, random),
        "opened" => two_that_bend_and_noise(&all, random),
        "later" | "later_withheld" => turn(&later),
        // One alone, two, and one in another form, in turns; without the library's own, one alone.
        "weak" if index % 3 == 1 => several(2, &all, random),
        "weak" if index % 3 == 2 => turn(&FORMS),
        "weak" | "weak_withheld" => turn(&[all, later].concat()),
        _ => turn(&all),
    }
}

/// So many different effects, one of a single converter at most.
fn several(count: usize, all: &[&'static str], random: &mut Random) -> Vec<&'static str> {
    let mut drawn = vec![all[random.below(all.len())]];
    while drawn.len() < count {
        let next = all[random.below(all.len())];
        let with = drawn.iter().chain([&next]);
        let converters = with.filter(|name| drawn_effects::is_of_one_channel(name));
        if converters.count() < 2 && !drawn.contains(&next) {
            drawn.push(next);
        }
    }
    drawn
}

/// Two that show in the harmonics, and one that shows as noise alone, which can pass either off as noise.
fn two_that_bend_and_noise(all: &[&'static str], random: &mut Random) -> Vec<&'static str> {
    let of = |is: fn(&Entry) -> bool| -> Vec<&'static str> {
        let those = all
            .iter()
            .filter(|name| named(Of::Calibrator, name).is_some_and(is));
        those.copied().collect()
    };
    let bent = of(|entry| entry.shows_in("ref_h2") || entry.shows_in("ref_h3"));
    let noise = of(|entry| entry.only_scatters);
    let mut drawn = several(2, &bent, random);
    drawn.push(noise[random.below(noise.len())]);
    drawn
}

/// Scatter of a stratum; the cases of `unkind` take each kind in turn.
fn scatter(stratum: &str, index: u64) -> Scatter {
    let memories = [0.8, 0.95, 0.98];
    // So that every effect meets every kind: 42 effects and 6 kinds have common factors.
    let kind = (index + index / 42) % 6;
    match (stratum, kind) {
        ("noise_1.2", _) | ("unkind", 0) => Scatter::Scaled(1.2),
        ("noise_2", _) | ("unkind", 1) => Scatter::Scaled(2.0),
        ("misread", _) => Scatter::Misread(1 + index as usize % 3),
        ("unkind", 2) => Scatter::Misread(1 + (index / 6) as usize % 3),
        ("memory", _) => Scatter::Correlated(memories[index as usize % 3]),
        ("unkind", kind) => Scatter::Correlated(memories[kind as usize - 3]),
        _ => Scatter::AsStated,
    }
}

/// Whether the true effects are taken out of the library.
pub(super) fn is_withheld(stratum: &str) -> bool {
    stratum.ends_with("withheld")
}

/// The generator of a case.
pub(super) fn random_of(index: u64, seed: u64) -> Random {
    Random::new(seed.wrapping_mul(1_000_003).wrapping_add(index))
}

/// Where a case is written.
pub(super) fn folder_of(stratum: &str, index: u64) -> PathBuf {
    let name = format!("{}-{stratum}-{index}", std::process::id());
    std::env::temp_dir().join("calib-bench-gap").join(name)
}

/// A case as written: its truth, and how to diagnose it.
pub(super) struct Written {
    pub(super) truth: Vec<&'static str>,
    /// How to diagnose it.
    pub(super) options: Options,
    unkind: Unkind,
}

/// Draws a case and writes it into `folder`; returns the truth and how to diagnose it.
pub(super) fn write(
    stratum: &str,
    index: u64,
    seed: u64,
    folder: &Path,
) -> Result<Written, GapError> {
    let mut random = random_of(index, seed);
    let truth = names(stratum, index, &mut random);
    let ratio_only = stratum == "ratio";
    let rows = if ratio_only {
        design::ratio_only(&mut random)
    } else {
        design::full()
    };
    let mut drawn = Truth::honest(&mut random);
    for name in &truth {
        drawn_effects::add(&mut drawn, name, &mut random);
        if stratum == "beside" && name == &truth[0] {
            // About a hundredth of the one that is added next.
            let factor = random.log_between(3e-3, 3e-2);
            drawn_effects::shrink(&mut drawn, factor);
        }
    }
    if stratum == "off2u" {
        for (value, (_, nominal, u)) in drawn.exciter.iter_mut().zip(NOMINAL) {
            *value = nominal + 2.0 * u * random.sign();
        }
    }
    // From invisible to the usual size, over three decades; or over the last one and a half.
    let smallest = match stratum {
        "size" => Some(1e-3),
        "weak" | "weak_withheld" => Some(3e-2),
        _ => None,
    };
    if let Some(smallest) = smallest {
        let factor = random.log_between(smallest, 1.0);
        drawn_effects::shrink(&mut drawn, factor);
    }
    if stratum == "form" || stratum == "weak" && index % 3 == 2 {
        drawn.effects.insert(OTHER_FORM, 1.0);
    }
    let scatter = scatter(stratum, index);
    // Rows with much distortion are not written, seldom more than a third.
    let mut deviates = Deviates::new(scatter.clone(), rows.len() * 2 / 3, &mut random);
    let points = table::scattered(
        &drawn,
        &rows,
        &GOOD,
        !ratio_only,
        &mut deviates,
        &mut random,
    );
    let write = || {
        std::fs::create_dir_all(folder)?;
        std::fs::write(folder.join("points.csv"), &points)?;
        std::fs::write(folder.join("rig.toml"), table::rig())
    };
    write().map_err(|source| GapError::Usage(source.to_string()))?;
    let mut options = Options::default();
    if is_withheld(stratum) {
        options.without = truth.iter().map(ToString::to_string).collect();
    }
    let unkind = Unkind {
        factor: match scatter {
            Scatter::Scaled(factor) => Some(factor),
            _ => None,
        },
        memory: match scatter {
            Scatter::Correlated(memory) => Some(memory),
            _ => None,
        },
        misread: deviates.misread,
    };
    Ok(Written {
        truth,
        options,
        unkind,
    })
}

/// Draws, diagnoses and scores a case.
pub(super) fn run(stratum: &str, index: u64, seed: u64) -> Result<Outcome, GapError> {
    let folder = folder_of(stratum, index);
    let written = write(stratum, index, seed, &folder)?;
    let outcome = diagnosed(stratum, index, written, &folder);
    if std::env::var_os("CALIB_BENCH_KEEP").is_none() {
        let _ = std::fs::remove_dir_all(&folder);
    }
    outcome
}

fn diagnosed(
    stratum: &str,
    index: u64,
    written: Written,
    folder: &Path,
) -> Result<Outcome, GapError> {
    let Written {
        truth,
        options,
        unkind,
    } = written;
    let start = processor_s();
    let answer = diagnose(folder, &options)?;
    let time_s = processor_s() - start;
    let known = misfit(folder, &truth)?;
    let root = |difference: f64| difference.max(0.0).sqrt();
    let sigma = root(misfit(folder, &[])? - known);
    let several = matches!(stratum, "triples" | "opened" | "beside");
    let left_sigma = match answer.causes.first() {
        Some(best) if several || is_withheld(stratum) => {
            root(misfit(folder, &best.effects)? - known)
        }
        _ => sigma,
    };
    let without = |name: &&str| {
        let others: Vec<&str> = truth.iter().filter(|n| n != &name).copied().collect();
        Ok(root(misfit(folder, &others)? - known))
    };
    let conditional_sigma = match truth.len() > 1 {
        true => truth.iter().map(without).collect::<Result<_, GapError>>()?,
        false => Vec::new(),
    };
    Ok(Outcome {
        index,
        truth,
        answer,
        time_s,
        sigma,
        left_sigma,
        conditional_sigma,
        unkind,
    })
}
