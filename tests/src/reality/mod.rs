//! Does U hold on a site? Every effect and fault of the library that is an error of a measurement, at
//! the sizes of sites, through the shipping firmware, judged by the truth.
//!
//! ```text
//! sizes   how large what goes wrong is: reality/sizes.toml
//! draw    a rig, its list and what is wrong with it, by seed
//! tally   what came of the points of an effect in a band
//! ```
//!
//! A point is right when the truth is within U as a certificate of the run states it, told the temperature and the data
//! sheet's mounted resonance; refused; or wrong, unless the certificate warns of what went wrong. Every draw has one point in each band, so that
//! counts in a band are counts of runs.

mod draw;
mod sizes;
mod tally;

pub use draw::{BANDS_HZ, Draw};
pub use sizes::{LeftOut, Sizes};
pub use tally::{Fate, Tally, most_by_chance, over_informed};

use crate::boardless;
use crate::judge::from_truth;
use crate::rigged::{Fault, Rigged, reference_point};
use crate::turns;
use calib_certificate::model::{Point, PointValues, Remark, Value};
use calib_certificate::{Certificate, Particulars};
use calib_core::point::PointResult;
use calib_core::point_state::PointState;
use calib_core::settings::Settings;
use calib_link::session;
use calib_protocol::record::{self, Record, RunLabels};
use calib_twin::Complex;
use std::collections::BTreeMap;
use std::ops::ControlFlow;

/// Remarks of a certificate that say what went wrong in all of its points.
const WARNINGS: [&str; 3] = ["changed_meanwhile", "not_repeated", "mount_gives_way"];
/// Stratum without an effect.
pub const CLEAN: &str = "clean";
/// Stratum of two effects or faults at a time.
pub const PAIR: &str = "pair";

/// Counts of a stratum, band by band, and the reasons of refusals.
#[derive(Clone, Debug, Default)]
pub struct Stratum {
    /// In the order of [`BANDS_HZ`].
    pub bands: Bands,
    /// These runs by certificates that were not told the data sheet: a mount may be a part of the device.
    pub without_data_sheet: Bands,
    /// How often points were refused, by reason in words.
    pub reasons: BTreeMap<String, u32>,
    /// Effects, seed, frequency in Hz, level in m/s2 and error over U of points that were wrong.
    pub wrong: Vec<String>,
}

/// Counts of each of [`BANDS_HZ`].
pub type Bands = [Tally; BANDS_HZ.len()];

/// All bands together.
pub fn pooled(bands: &Bands) -> Tally {
    let mut pooled = Tally::default();
    bands.iter().for_each(|band| pooled.merge(band));
    pooled
}

impl Stratum {
    /// All bands together.
    pub fn pooled(&self) -> Tally {
        pooled(&self.bands)
    }

    /// Adds another of the same effects.
    pub fn merge(&mut self, other: Self) {
        let own = self.bands.iter_mut().chain(&mut self.without_data_sheet);
        let others = other.bands.iter().chain(&other.without_data_sheet);
        own.zip(others).for_each(|(band, more)| band.merge(more));
        for (reason, count) in other.reasons {
            *self.reasons.entry(reason).or_default() += count;
        }
        self.wrong.extend(other.wrong);
    }
}

/// Names of all strata: clean, every effect and fault of the sizes, pairs.
pub fn strata(sizes: &Sizes) -> Vec<String> {
    let names = sizes.effects().into_iter();
    let all = std::iter::once(CLEAN).chain(names).chain([PAIR]);
    all.map(str::to_owned).collect()
}

/// Part that measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Through {
    /// The shipping image on the emulated board.
    Firmware,
    /// The core on the plant, without a board between: the same numbers, many times as fast.
    Core,
    /// The core, whose settings state the exciter's own transverse motion: U is smaller, and has to hold as well.
    CoreToldExciter,
}

/// Carries out `runs` runs of a stratum, seeded from `first_seed` on, on all cores.
///
/// # Errors
/// The first run that could not be carried out.
pub fn run(
    sizes: &Sizes,
    through: Through,
    stratum: &str,
    runs: u64,
    first_seed: u64,
) -> Result<Stratum, Fault> {
    turns::all(
        runs,
        |rigged, draw| {
            let seed = first_seed + draw;
            let draw = drawn(sizes, stratum, seed)?;
            let record = match through {
                Through::Firmware => by_firmware(rigged, &draw)?,
                Through::Core => by_core(&draw, [0.0; 2]),
                Through::CoreToldExciter => by_core(&draw, draw.transverse_motion_rel),
            };
            Ok(judge(&draw, &record, seed))
        },
        Stratum::merge,
        |_| (),
    )
}

/// A point as the firmware measures it and as the core alone does.
#[derive(Clone, Copy, Debug)]
pub struct Both {
    /// Through the shipping image.
    pub firmware: PointResult,
    /// Without a board between.
    pub core: PointResult,
}

impl Both {
    /// How far the two are apart over U, magnitude and phase; none unless both passed.
    pub fn apart(&self) -> Option<[f64; 2]> {
        let [firmware, core] = [&self.firmware, &self.core];
        let passed = firmware.state == PointState::Valid && core.state == PointState::Valid;
        let found = [core.sensitivity_v_per_ms2, core.phase_rad].map(f64::from);
        let apart = from_truth(firmware, Complex::from_polar(found[0], found[1]));
        passed.then_some([
            apart.magnitude_rel.abs() / f64::from(core.expanded_uncertainty_rel),
            apart.phase_rad.abs() / f64::from(core.expanded_uncertainty_phase_rad),
        ])
    }
}

/// As [`run`], through firmware and core, point by point.
///
/// # Errors
/// The first run that could not be carried out.
pub fn run_both(
    sizes: &Sizes,
    stratum: &str,
    runs: u64,
    first_seed: u64,
) -> Result<Vec<Both>, Fault> {
    turns::all(
        runs,
        |rigged, draw| {
            let draw = drawn(sizes, stratum, first_seed + draw)?;
            let [firmware, core] = [by_firmware(rigged, &draw)?, by_core(&draw, [0.0; 2])];
            let points = firmware.points.iter().zip(&core.points);
            let both = |(firmware, core): (&PointResult, &PointResult)| Both {
                firmware: *firmware,
                core: *core,
            };
            Ok(points.map(both).collect())
        },
        |all, more: Vec<Both>| all.extend(more),
        |_| (),
    )
}

/// The rig of a run of a stratum, with its effects.
fn drawn(sizes: &Sizes, stratum: &str, seed: u64) -> Result<Draw, Fault> {
    Draw::new(sizes, &effects_of(sizes, stratum, seed), seed)
}

/// The effects of a run of a stratum.
fn effects_of<'s>(sizes: &'s Sizes, stratum: &'s str, seed: u64) -> Vec<&'s str> {
    let names = sizes.effects();
    let count = names.len() as u64;
    match stratum {
        CLEAN => Vec::new(),
        // Every pair has its turn: the seeds count through them.
        PAIR => {
            let (first, apart) = (seed % count, 1 + seed / count % (count - 1));
            let index = [first, (first + apart) % count];
            index.map(|index| names[index as usize]).to_vec()
        }
        name => vec![name],
    }
}

/// One run, on the worker's instrument.
fn by_firmware(rigged: &mut Option<Rigged>, draw: &Draw) -> Result<Record, Fault> {
    let rigged = match rigged {
        Some(rigged) => rigged,
        None => rigged.insert(Rigged::with_rig(&draw.rig)?),
    };
    rigged.certify_reference(&draw.certificate)?;
    // The faults begin with the run, not with the handling of the button before it.
    rigged.mount(&draw.rig);
    let goes_on = |_: &session::Progress<'_>| ControlFlow::Continue(());
    let run = session::run(&mut rigged.client, &draw.points, labels(draw), goes_on)?;
    Ok(record::decode(&rigged.record(run.record_id)?)?)
}

/// Labels the operator tells.
fn labels(draw: &Draw) -> RunLabels {
    RunLabels {
        temperature_centi_c: Some((100.0 * draw.temperature_c) as i16),
        ..RunLabels::BLANK
    }
}

/// The record of a run of the core alone, told the exciter's transverse motion to 1 kHz and above; 0: told nothing.
fn by_core(draw: &Draw, transverse_motion_rel: [f64; 2]) -> Record {
    let mut settings = Settings::field_calibrator();
    let [to_1_khz, above] = transverse_motion_rel.map(|motion_rel| motion_rel.min(1.0) as f32);
    settings.point_influences.transverse_motion_to_1_khz_rel = to_1_khz;
    settings.point_influences.transverse_motion_above_1_khz_rel = above;
    settings.reference.points = draw.certificate.iter().map(reference_point).collect();
    let (points, closing) = boardless::measure_closed(&draw.rig, &settings, &draw.points);
    let mut record = Record::BLANK;
    record.head.sample_rate_hz = 50_000.0;
    record.head.labels = labels(draw);
    record.settings = settings;
    record.complete = true;
    record.closing = closing;
    record.points.extend(points);
    record
}

/// Counts what came of a run.
fn judge(draw: &Draw, record: &Record, seed: u64) -> Stratum {
    let mut counts = Stratum::default();
    let refused = record.points.iter().filter_map(|p| match p.state {
        PointState::Refused(reason) => Some(reason.to_string()),
        PointState::Valid => None,
    });
    refused.for_each(|reason| *counts.reasons.entry(reason).or_default() += 1);
    let mut particulars = Particulars::default();
    let untold = fates(draw, record, &particulars);
    particulars.item.mounted_resonance_hz = Some(draw.data_sheet_hz);
    let told = fates(draw, record, &particulars);
    for (result, fate) in record.points.iter().zip(&told) {
        counts.wrong.extend(fate.fault(draw, result, seed));
    }
    let bands = counts
        .bands
        .iter_mut()
        .chain(&mut counts.without_data_sheet);
    bands
        .zip(told.into_iter().chain(untold))
        .for_each(|(band, fate)| band.add(fate));
    counts
}

/// Outcomes of the points of a run by its certificate.
fn fates(draw: &Draw, record: &Record, particulars: &Particulars) -> [Fate; BANDS_HZ.len()] {
    let certificate = Certificate::from_record(record, particulars);
    let warned_from_hz = certificate.remarks.iter().filter_map(warned_from_hz);
    let warned_from_hz = warned_from_hz.fold(f64::INFINITY, f64::min);
    std::array::from_fn(|index| {
        // A run that ended has no results for the rest of its list.
        let Some(result) = record.points.get(index) else {
            return Fate::Refused;
        };
        let certified = certificate.points.iter().find(|p| p.measured == *result);
        let told = certified.is_some_and(|point| point.nominal_frequency_hz >= warned_from_hz);
        fate(draw, result, certified.and_then(Point::values), told)
    })
}

/// Frequency in Hz from which on a remark says what may be wrong; none of one that says nothing of the kind.
fn warned_from_hz(remark: &Remark) -> Option<f64> {
    match (remark.key, remark.values.get(1)) {
        ("mount_unseen", Some(Value::Exact(hz, "Hz"))) => Some(*hz),
        (key, _) => WARNINGS.contains(&key).then_some(0.0),
    }
}

impl Fate {
    /// In words, when the point is wrong.
    fn fault(self, draw: &Draw, result: &PointResult, seed: u64) -> Option<String> {
        let Self::Stated {
            magnitude,
            phase,
            told,
            ..
        } = self
        else {
            return None;
        };
        let right = magnitude <= 1.0 && phase <= 1.0;
        (!right && !told).then(|| {
            format!(
                "seed {seed}, {:.2} Hz, {:.2} m/s2: {magnitude:.2} and {phase:.2} of U; {:?} {:?}",
                result.spec.frequency_hz,
                result.spec.acceleration_rms_ms2,
                draw.rig.effects,
                draw.rig.faults
            )
        })
    }
}

/// Outcome of a point.
fn fate(draw: &Draw, result: &PointResult, certified: Option<&PointValues>, told: bool) -> Fate {
    let Some(certified) = certified else {
        return Fate::Refused;
    };
    let frequency_hz =
        f64::from(result.tone.cycles) * 50_000.0 / f64::from(result.tone.period_samples);
    let deviation = from_truth(result, draw.truth(frequency_hz));
    let expanded_rel = certified.expanded_uncertainty_percent / 100.0;
    Fate::Stated {
        magnitude: deviation.magnitude_rel.abs() / expanded_rel,
        phase: deviation.phase_rad.abs() / certified.expanded_uncertainty_phase_deg.to_radians(),
        expanded_rel,
        known_rel: draw.known_rel(result, frequency_hz),
        told,
    }
}
