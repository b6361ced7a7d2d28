//! Which kind of deviation a gap is: observables and courses of each kind, and the kind that accounts
//! for most of it.

use super::pattern::{Course, Kind, Parts, Pattern, bands, column, smooth};
use crate::calibrator::fit::{Fit, Workspace};
use crate::calibrator::linear::Linearised;
use crate::calibrator::nuisance::Nuisance;
use crate::calibrator::problem::{Column, Problem, Tangent};
use crate::calibrator::settled::Settled;
use crate::model::row::Row;
use crate::observable::Observable::{
    Current, CurrentPhase, Drive, DrivePhase, DutNoise, Ratio, RatioPhase, RefNoise,
};

/// Orders of the smooth courses that are tried, before bands.
const ORDERS: [usize; 3] = [0, 2, 5];

const IN_RATIO: [&Parts; 2] = [&[(Ratio, 1.0)], &[(RatioPhase, 1.0)]];
const SIZE_OF_RATIO: [&Parts; 1] = [&[(Ratio, 1.0)]];
const PHASE_OF_RATIO: [&Parts; 1] = [&[(RatioPhase, 1.0)]];
const IN_BOTH: [&Parts; 2] = [
    &[(Ratio, -1.0), (Drive, 1.0)],
    &[(RatioPhase, -1.0), (DrivePhase, 1.0)],
];
const IN_DRIVE: [&Parts; 1] = [&[(Drive, 1.0)]];
const IN_EXCITER: [&Parts; 4] = [
    &[(Drive, 1.0)],
    &[(DrivePhase, 1.0)],
    &[(Current, 1.0)],
    &[(CurrentPhase, 1.0)],
];

/// All rules with all courses.
pub(super) struct Rules<'a> {
    problem: &'a Problem,
    weight: &'a [f64],
    tangent: &'a Tangent,
    pub(super) patterns: Vec<Pattern>,
}

impl<'a> Rules<'a> {
    pub(super) fn new(
        problem: &'a Problem,
        weight: &'a [f64],
        tangent: &'a Tangent,
        fit: &Fit,
    ) -> Self {
        let mut rules = Self {
            problem,
            weight,
            tangent,
            patterns: Vec::new(),
        };
        for order in ORDERS {
            let course = smooth(problem, order);
            rules.add_sharp(&course);
            rules.add_smooth(&course);
        }
        rules.add_sharp(&bands(problem));
        rules.add_values(fit);
        rules.add_noise();
        rules
    }

    /// Rules whose course may have a resonance.
    fn add_sharp(&mut self, course: &Course) {
        let turning: [fn(&Row) -> f64; 2] = [|r| r.rotation.0, |r| r.rotation.1];
        let twice: [fn(&Row) -> f64; 2] = [|r| r.rotation_twice().0, |r| r.rotation_twice().1];
        self.add(Kind::Ratio, &IN_RATIO, course, &[|_| 1.0]);
        self.add(Kind::Mirrored, &IN_BOTH, course, &[|_| 1.0]);
        self.add(Kind::Rotation, &IN_RATIO, course, &turning);
        self.add(Kind::Rotation, &IN_RATIO, course, &twice);
        self.add(Kind::Payload, &IN_RATIO, course, &[|r| r.payload_kg]);
        self.add(Kind::Exciter, &IN_EXCITER, course, &[|_| 1.0]);
        self.add(Kind::Exciter, &IN_EXCITER[..2], course, &[|_| 1.0]);
    }

    /// Rules that depend on time, temperature or level, without sharp features.
    fn add_smooth(&mut self, course: &Course) {
        let warmer: fn(&Row) -> f64 = |r| r.warmer_k;
        // Alone, and with a curvature: what settles.
        let settling: [fn(&Row) -> f64; 2] = [|r| r.time_s, |r| r.time_s * r.time_s];
        let level: [fn(&Row) -> f64; 2] = [|r| r.level_ms2, |r| 1.0 / r.level_ms2];
        self.add(Kind::PhaseInTime, &PHASE_OF_RATIO, course, &settling[..1]);
        self.add(Kind::Temperature, &SIZE_OF_RATIO, course, &[warmer]);
        for time in [&settling[..1], &settling] {
            self.add(Kind::Time, &SIZE_OF_RATIO, course, time);
            self.add(Kind::DriveInTime, &IN_DRIVE, course, time);
            self.add(Kind::ExciterInTime, &IN_EXCITER, course, time);
            self.add(Kind::MirroredSlow, &IN_BOTH[..1], course, time);
        }
        self.add(Kind::MirroredSlow, &IN_BOTH[..1], course, &[warmer]);
        for one in level {
            self.add(Kind::Level, &SIZE_OF_RATIO, course, &[one]);
            self.add(Kind::MirroredLevel, &IN_BOTH[..1], course, &[one]);
            self.add(Kind::Exciter, &IN_EXCITER, course, &[one]);
        }
    }

    /// The values of the exciter, beyond their stated uncertainty.
    fn add_values(&mut self, fit: &Fit) {
        let of_exciter = |i: &usize| matches!(self.problem.free[*i].kind, Nuisance::Exciter(_));
        let every: Vec<usize> = (0..fit.theta.len()).filter(of_exciter).collect();
        let columns = |list: &[usize]| -> Vec<Column> {
            let columns = list.iter().map(|i| self.tangent.columns[*i].clone());
            columns.collect()
        };
        let mut sets: Vec<Vec<Column>> = every.iter().map(|i| columns(&[*i])).collect();
        sets.push(columns(&every));
        for set in sets {
            self.push(Kind::Exciter, set);
        }
    }

    fn add_noise(&mut self) {
        let shapes: [fn(&Row) -> f64; 3] = [
            |_| 1.0,
            |r| r.frequency_hz.ln(),
            |r| {
                if r.level_ms2 > 0.0 {
                    r.level_ms2.ln()
                } else {
                    0.0
                }
            },
        ];
        for count in [1, 3] {
            for (kind, channels) in [
                (Kind::NoiseOfDut, &[DutNoise][..]),
                (Kind::NoiseOfBoth, &[RefNoise]),
                (Kind::NoiseOfBoth, &[RefNoise, DutNoise]),
            ] {
                let columns = channels.iter().flat_map(|noise| {
                    let parts = [(*noise, 1.0)];
                    let of = |shape: &fn(&Row) -> f64| self.column(&parts, shape);
                    shapes[..count].iter().map(of).collect::<Vec<_>>()
                });
                let columns = columns.collect();
                self.push(kind, columns);
            }
        }
    }

    fn add(&mut self, kind: Kind, parts: &[&Parts], course: &Course, along: &[fn(&Row) -> f64]) {
        let mut columns = Vec::new();
        for part in parts {
            for shape in course {
                for condition in along {
                    let value = |row: &Row| shape(row.frequency_hz) * condition(row);
                    columns.push(self.column(part, &value));
                }
            }
        }
        self.push(kind, columns);
    }

    fn column(&self, parts: &Parts, shape: &dyn Fn(&Row) -> f64) -> Column {
        column(self.problem, self.weight, parts, shape)
    }

    fn push(&mut self, kind: Kind, mut columns: Vec<Column>) {
        columns.retain(|c| c.norm2() > 0.0);
        if columns.is_empty() {
            return;
        }
        self.patterns
            .extend(Pattern::new(self.problem, self.tangent, kind, columns));
    }
}

/// A class of deviation with the chi-square it accounts for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Found {
    pub(crate) kind: Kind,
    pub(crate) gain: f64,
}

/// The two classes that account for most of what a fit leaves, the second of what the first leaves.
pub(crate) fn classes(problem: &Problem, fit: &Fit, work: &mut Workspace) -> Vec<Found> {
    let Some((evaluation, tangent)) = Linearised::new(problem, fit, work).tangent() else {
        return Vec::new();
    };
    let rules = Rules::new(problem, &evaluation.weight, &tangent, fit);
    let mut residual = Settled::new(problem, fit, &tangent, evaluation.residual).left;
    let mut found: Vec<Found> = Vec::new();
    for _ in 0..2 {
        let others = rules
            .patterns
            .iter()
            .filter(|p| found.iter().all(|f| f.kind != p.kind));
        let gains = others.map(|p| (p, p.fit(problem, &residual).1));
        let best = gains.max_by(|a, b| (a.1 - a.0.cost).total_cmp(&(b.1 - b.0.cost)));
        let Some((pattern, gain)) = best.filter(|(p, gain)| *gain > p.cost) else {
            break;
        };
        let kind = pattern.kind;
        found.push(Found { kind, gain });
        pattern.take_out(problem, &tangent, &mut residual);
    }
    found
}
