//! The emulator over real time, fast and plain, in one run: the same records, sooner.

use calib_core::point::PointResult;
use calib_link::session;
use calib_protocol::record::{self, Sha256Sum};
use calib_tests::rigged::{Fault, Rigged};
use calib_twin::rig::Rig;
use calib_twin::runner::Execution;
use serde_json::{Value, json};
use std::time::{Duration, Instant};

/// Runs of the default list after the first, of which the median is stated.
const WARM_RUNS: usize = 3;

/// Times of runs of the default list, and what they did.
struct Speed {
    /// Virtual time over the wall's: the first run, with the translation of the image; one after it.
    cold: f64,
    warm: f64,
    /// Virtual time over that of the processor, which other work on the computer moves less.
    warm_of_processor: f64,
    instructions_per_s: f64,
    done: Done,
}

/// Results that both must have in common.
#[derive(Debug, PartialEq)]
struct Done {
    /// SHA-256 of every record, chained.
    records: Sha256Sum,
    elapsed: Duration,
    instructions: u64,
}

/// One run.
struct Lap {
    points: Vec<PointResult>,
    of_wall: f64,
    of_processor: f64,
    instructions_per_s: f64,
}

/// Prints the rows; hands over them and the points of the last run.
///
/// # Errors
/// A run fails, or the two executions differ.
pub(crate) fn measure() -> Result<(Value, Vec<PointResult>), Fault> {
    let (fast, points) = speed(Execution::Fast)?;
    let (plain, _) = speed(Execution::Plain)?;
    if fast.done != plain.done {
        return Err(format!("{:?} is not {:?}", fast.done, plain.done).into());
    }
    println!("emulator, x real time         first    later  of processor  Minstr/s");
    for (name, speed) in [("fast, aim 15", &fast), ("plain", &plain)] {
        println!(
            "  {name:<25} {:>8.2} {:>8.2} {:>13.2} {:>9.1}",
            speed.cold,
            speed.warm,
            speed.warm_of_processor,
            speed.instructions_per_s / 1e6,
        );
    }
    let sum = hex::encode(&fast.done.records[..8]);
    println!(
        "  both: records {sum}, {} instructions in {:?}",
        fast.done.instructions, fast.done.elapsed
    );
    let row = |speed: &Speed| {
        json!({
            "first_run_x_real_time": speed.cold,
            "x_real_time": speed.warm,
            "x_processor_time": speed.warm_of_processor,
            "instructions_per_s": speed.instructions_per_s,
        })
    };
    Ok((json!({ "fast": row(&fast), "plain": row(&plain) }), points))
}

fn speed(execution: Execution) -> Result<(Speed, Vec<PointResult>), Fault> {
    let mut rigged = Rigged::executed(execution, &Rig::standard())?;
    let mut records = Sha256Sum::default();
    let cold = lap(&mut rigged, &mut records)?;
    let mut laps = (0..WARM_RUNS)
        .map(|_| lap(&mut rigged, &mut records))
        .collect::<Result<Vec<Lap>, Fault>>()?;
    laps.sort_by(|a, b| a.of_processor.total_cmp(&b.of_processor));
    let median = laps.swap_remove(WARM_RUNS / 2);
    let (elapsed, instructions) = stand(&rigged);
    let speed = Speed {
        cold: cold.of_wall,
        warm: median.of_wall,
        warm_of_processor: median.of_processor,
        instructions_per_s: median.instructions_per_s,
        done: Done {
            records,
            elapsed,
            instructions,
        },
    };
    Ok((speed, median.points))
}

/// Runs the default list, and adds its record to the sum.
fn lap(rigged: &mut Rigged, records: &mut Sha256Sum) -> Result<Lap, Fault> {
    let (from, before) = stand(rigged);
    let (start, processor_s) = (Instant::now(), processor_s()?);
    let outcome = rigged.run(&session::default_points(10.0))?;
    let wall_s = start.elapsed().as_secs_f64();
    let processor_s = self::processor_s()? - processor_s;
    let (to, after) = stand(rigged);
    let (virtual_s, instructions) = ((to - from).as_secs_f64(), after - before);
    let content = rigged.record(outcome.record_id)?;
    *records = record::digest(&[records.as_slice(), &content].concat());
    Ok(Lap {
        points: outcome.points,
        of_wall: virtual_s / wall_s,
        of_processor: virtual_s / processor_s,
        instructions_per_s: instructions as f64 / wall_s,
    })
}

/// Virtual time and instructions since power came.
fn stand(rigged: &Rigged) -> (Duration, u64) {
    let board = rigged.board();
    (board.elapsed(), board.instructions())
}

/// Time the processor has worked for this program, s, to 10 ms.
fn processor_s() -> Result<f64, Fault> {
    let stat = std::fs::read_to_string("/proc/self/stat")?;
    // After the name in brackets: user and system time are the 12th and 13th, in ticks of 10 ms.
    let fields = stat.rsplit(')').next().unwrap_or_default();
    let ticks: Vec<f64> = fields
        .split_whitespace()
        .skip(11)
        .take(2)
        .map(str::parse)
        .collect::<Result<_, _>>()?;
    Ok(ticks.iter().sum::<f64>() / 100.0)
}
