//! The conditions of the rows of a case.

use super::random::Random;

#[derive(Clone, Copy)]
pub(crate) struct Condition {
    pub(crate) f: f64,
    pub(crate) level: f64,
    pub(crate) run: usize,
    pub(crate) time: f64,
    pub(crate) temperature: f64,
    pub(crate) rotation: f64,
    pub(crate) tilt: f64,
    pub(crate) payload: f64,
}

/// About 214 rows: several runs, levels, rotations, tilts, payloads, over 5 Hz .. 10 kHz.
pub(crate) fn full(random: &mut Random) -> Vec<Condition> {
    let mut rows = Vec::new();
    let grid: Vec<f64> = (0..26)
        .map(|i| 5.0 * (2000.0f64).powf(i as f64 / 25.0))
        .collect();
    let mut time = 0.0;
    let mut add = |random: &mut Random,
                   rows: &mut Vec<Condition>,
                   f: f64,
                   level: f64,
                   run: usize,
                   rot: f64,
                   tilt: f64,
                   payload: f64,
                   dt: f64| {
        let travel_limit = 0.0012 * (std::f64::consts::TAU * f).powi(2);
        let _ = random;
        time += 20.0;
        rows.push(Condition {
            f,
            level: level.min(travel_limit),
            run,
            time,
            temperature: 23.0 + dt,
            rotation: rot,
            tilt,
            payload,
        });
    };
    let payloads = [0.02, 0.04, 0.1];
    for run in 0..4 {
        let dt = [0.0, 4.0, -3.0, 8.0][run];
        for &f in &grid {
            add(
                random,
                &mut rows,
                f,
                10.0,
                run,
                90.0 * run as f64,
                0.0,
                payloads[run % 3],
                dt,
            );
        }
    }
    for &f in grid.iter().step_by(2) {
        for level in [1.0, 3.0, 30.0, 60.0] {
            add(random, &mut rows, f, level, 1, 0.0, 0.0, 0.04, 1.0);
        }
    }
    for &f in grid.iter().step_by(3) {
        for (rot, tilt) in [
            (0.0, 90.0),
            (45.0, 0.0),
            (180.0, 0.0),
            (270.0, 45.0),
            (135.0, 0.0),
            (0.0, 0.0),
        ] {
            add(random, &mut rows, f, 10.0, 3, rot, tilt, 0.04, 0.0);
        }
    }
    rows
}

/// A certificate: ratio only, one run, no conditions but frequency.
pub(crate) fn ratio_only(random: &mut Random) -> Vec<Condition> {
    let mut rows = Vec::new();
    for run in 0..2 {
        for i in 0..30 {
            let f = 5.0 * (2000.0f64).powf(i as f64 / 29.0);
            rows.push(Condition {
                f,
                level: 10.0_f64.min(0.0012 * (std::f64::consts::TAU * f).powi(2)),
                run,
                time: 20.0 * rows.len() as f64,
                temperature: 23.0 + random.between(-2.0, 2.0),
                rotation: 90.0 * run as f64,
                tilt: 0.0,
                payload: [0.02, 0.06][run],
            });
        }
    }
    rows
}
