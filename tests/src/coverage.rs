//! Does U (k = 2) contain the truth? Simulated calibrations with known truth.
//!
//! Each draw is a rig that is wrong in every way its budget admits, by as much
//! as the stated distributions admit. The instrument is told the budget, not
//! the errors, and states its uncertainty; the oracle knows the truth.

use crate::judge::from_truth;
use crate::rigged::{Fault, Rigged, point, reference_point};
use crate::turns;
use calib_core::point_state::PointState;
use calib_core::settings::{Distribution as Stated, Influence as StatedInfluence, PointInfluences};
use calib_twin::influence::{Distribution as Drawn, Influence, InfluenceDraw};
use calib_twin::rig::Rig;

/// Frequencies of a draw, Hz: all but the last have an exact tone at 50 kS/s.
const FREQUENCIES_HZ: [f32; 3] = [80.0, 160.0, 2000.0];

/// The budget both sides are told: row of Table A.1, half-width in percent,
/// half-width of the phase in mrad. After Table D.1, widened to the field.
const BUDGET: [(u8, f32, f32, Kind); 13] = [
    (2, 0.25, 2.0, Kind::Rectangular),
    (3, 0.20, 2.0, Kind::Rectangular),
    (4, 0.03, 0.3, Kind::Rectangular),
    (6, 0.539, 2.0, Kind::Transverse),
    (7, 0.05, 0.5, Kind::Rectangular),
    (8, 0.10, 0.5, Kind::Triangular),
    (9, 0.05, 0.5, Kind::Rectangular),
    (10, 0.15, 1.0, Kind::Rectangular),
    (11, 0.36, 1.0, Kind::Rectangular),
    (13, 0.03, 0.3, Kind::Rectangular),
    (14, 0.03, 0.3, Kind::UShaped),
    (16, 0.03, 0.3, Kind::Rectangular),
    (17, 0.03, 0.3, Kind::Rectangular),
];

/// Relative motion that both sides are told, beside row 9: 0.2 % at 2 kHz.
const MOTION_AT_10_KHZ_REL: f64 = 0.05;

#[derive(Clone, Copy)]
enum Kind {
    Rectangular,
    Triangular,
    UShaped,
    Transverse,
}

impl Kind {
    /// In the instrument's words; sqrt(18) is the divisor of Table D.1, note 3.
    fn stated(self) -> Stated {
        match self {
            Self::Rectangular => Stated::Rectangular,
            Self::Triangular => Stated::Triangular,
            Self::UShaped => Stated::UShaped,
            Self::Transverse => Stated::Special {
                divisor: 18.0_f32.sqrt(),
            },
        }
    }

    /// In the twin's.
    fn drawn(self) -> Drawn {
        match self {
            Self::Rectangular => Drawn::Rectangular,
            Self::Triangular => Drawn::Triangular,
            Self::UShaped => Drawn::UShaped,
            Self::Transverse => Drawn::Transverse,
        }
    }
}

/// How often the stated interval contained the truth.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// Points that passed their checks.
    pub points: u64,
    /// Points refused (seed, frequency in Hz, why): they state nothing, so they
    /// count for nothing.
    pub refused: Vec<(u64, u32, PointState)>,
    /// Points whose magnitude was inside.
    pub magnitude: u64,
    /// Points whose phase was inside.
    pub phase: u64,
}

impl Tally {
    /// Share of points whose magnitude was inside, in percent.
    pub fn magnitude_percent(&self) -> f64 {
        100.0 * self.magnitude as f64 / self.points as f64
    }

    /// Share of points whose phase was inside, in percent.
    pub fn phase_percent(&self) -> f64 {
        100.0 * self.phase as f64 / self.points as f64
    }

    fn add(&mut self, other: Self) {
        self.points += other.points;
        self.refused.extend(other.refused);
        self.magnitude += other.magnitude;
        self.phase += other.phase;
    }
}

/// Runs `draws` simulated calibrations, seeded from `first_seed` on, on all
/// cores; `progress` hears how many are done.
///
/// # Errors
/// The first draw that could not be carried out.
pub fn run(draws: u64, first_seed: u64, progress: impl Fn(u64) + Sync) -> Result<Tally, Fault> {
    turns::all(
        draws,
        |rigged, draw| one(rigged, first_seed + draw),
        Tally::add,
        progress,
    )
}

/// One calibration with known truth, on the worker's instrument.
fn one(rigged: &mut Option<Rigged>, seed: u64) -> Result<Tally, Fault> {
    let frequencies_hz = FREQUENCIES_HZ.map(f64::from);
    let draw = InfluenceDraw::new(&Rig::draw(seed), &frequencies_hz, &drawn_budget(), seed);
    let rigged = match rigged {
        Some(rigged) => rigged,
        None => rigged.insert(Rigged::with_rig(&draw.rig)?),
    };
    rigged.mount(&draw.rig);
    rigged.adjust(|settings| {
        settings.reference.points = draw.certificate.iter().map(reference_point).collect();
        settings.influences = stated_budget();
        // Nothing else is wrong with the rigs drawn here, but for what dither leaves of the converters: a tenth of U.
        settings.point_influences = PointInfluences {
            relative_motion_at_10_khz_rel: MOTION_AT_10_KHZ_REL as f32,
            ..PointInfluences::NONE
        };
    })?;
    let outcome = rigged.run(&FREQUENCIES_HZ.map(|frequency_hz| point(frequency_hz, 10.0)))?;
    // Each rig is a change of settings, and so a record: they make room.
    rigged.client.release(outcome.record_id)?;
    let mut tally = Tally::default();
    for (result, frequency_hz) in outcome.points.iter().zip(frequencies_hz) {
        if result.state != PointState::Valid {
            let refusal = (seed, frequency_hz.round() as u32, result.state);
            tally.refused.push(refusal);
            continue;
        }
        let deviation = from_truth(result, draw.truth(frequency_hz));
        let inside = |deviation: f64, expanded: f32| deviation.abs() <= f64::from(expanded);
        tally.points += 1;
        tally.magnitude += u64::from(inside(
            deviation.magnitude_rel,
            result.expanded_uncertainty_rel,
        ));
        tally.phase += u64::from(inside(
            deviation.phase_rad,
            result.expanded_uncertainty_phase_rad,
        ));
    }
    Ok(tally)
}

fn stated_budget() -> heapless::Vec<StatedInfluence, { calib_core::settings::MAX_INFLUENCES }> {
    BUDGET
        .iter()
        .map(|&(row, percent, mrad, kind)| StatedInfluence {
            row,
            value_rel: percent / 100.0,
            value_phase_rad: mrad / 1000.0,
            distribution: kind.stated(),
        })
        .collect()
}

fn drawn_budget() -> Vec<Influence> {
    BUDGET
        .iter()
        .map(|&(row, percent, mrad, kind)| Influence {
            row,
            bound_rel: f64::from(percent) / 100.0,
            bound_phase_rad: f64::from(mrad) / 1000.0,
            distribution: kind.drawn(),
            square_from_hz: None,
        })
        .chain(std::iter::once(Influence {
            row: 9,
            bound_rel: MOTION_AT_10_KHZ_REL,
            bound_phase_rad: MOTION_AT_10_KHZ_REL,
            distribution: Drawn::Rectangular,
            square_from_hz: Some(10_000.0),
        }))
        .collect()
}
