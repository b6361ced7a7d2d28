//! A core that waits for its flash: every deadline with one and with three cycles for an instruction.

use crate::row::Row;
use calib_core::point_state::PointState;
use calib_link::session;
use calib_protocol::health::{Deadline, Work};
use calib_tests::rigged::{Fault, Rigged};
use calib_twin::plant::Plant;
use calib_twin::rig::Rig;
use calib_twin::runner::Firmware;
use std::num::NonZeroU64;

/// Cycles for an instruction: tightly coupled memory or a cache that hits, and flash with wait states and none.
const CYCLES: [u64; 2] = [1, 3];

/// Course of a default list.
struct Course {
    deadlines: Vec<Deadline>,
    overruns: u32,
    /// Blocks of the drive without a command in time, or written late: each mutes the exciter.
    mutes: usize,
    refused: usize,
}

/// Longest times of blocks, turns of tasks and interrupts over a default list.
pub(crate) fn measure() -> Result<Vec<Row>, Fault> {
    let [quick, slow] = [course(CYCLES[0])?, course(CYCLES[1])?];
    let works = Work::ALL.iter().zip(&quick.deadlines);
    let mut rows: Vec<Row> = works
        .zip(&slow.deadlines)
        .map(|((work, quick), slow)| {
            let what = format!("{work:?}, longest at {} cycles", CYCLES[1]);
            let note = format!("at {} cycle {:.3} ms", CYCLES[0], 1e-3 * quick.longest_us);
            let longest_ms = f64::from(1e-3 * slow.longest_us);
            Row::new(what, longest_ms, "ms").limit(f64::from(1e-3 * slow.allowed_us), note)
        })
        .collect();
    for (what, value) in [
        ("lost blocks of samples", f64::from(slow.overruns)),
        ("mutes of the drive", slow.mutes as f64),
        ("points refused", slow.refused as f64),
    ] {
        let what = format!("{what} at {} cycles", CYCLES[1]);
        rows.push(Row::new(what, value, "").limit(0.0, "aim: none"));
    }
    Ok(rows)
}

fn course(cycles: u64) -> Result<Course, Fault> {
    let firmware = Firmware::shipping()?.at(NonZeroU64::new(cycles).ok_or("some cycles")?);
    let mut rigged = Rigged::with_image(&firmware, Box::new(Plant::new(&Rig::standard())))?;
    let outcome = rigged.run(&session::default_points(10.0))?;
    let refused = outcome.points.iter();
    let health = rigged.client.health()?.ok_or("it knows its health")?;
    Ok(Course {
        deadlines: health.deadlines.to_vec(),
        overruns: rigged.client.status()?.overruns,
        mutes: rigged.late_lines(&firmware).len(),
        refused: refused.filter(|p| p.state != PointState::Valid).count(),
    })
}
