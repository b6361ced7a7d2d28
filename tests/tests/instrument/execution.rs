//! The emulator's shortcuts change nothing but how long a run takes.

use calib_protocol::record::{self, Sha256Sum};
use calib_tests::rigged::{Fault, Rigged, point};
use calib_twin::rig::Rig;
use calib_twin::runner::Execution;

/// All that two runs can differ in: the record, the instant, the instructions, the sample pairs.
#[derive(Debug, PartialEq)]
struct Trace {
    record: Sha256Sum,
    elapsed_ns: u128,
    instructions: u64,
    pairs: u64,
    drive_code: u16,
}

/// Calibrates two points, stores and reads the record, and releases it.
fn trace(execution: Execution) -> Result<Trace, Fault> {
    let mut rigged = Rigged::executed(execution, &Rig::standard())?;
    let outcome = rigged.run(&[point(160.0, 10.0), point(5000.0, 20.0)])?;
    let record = rigged.record(outcome.record_id)?;
    rigged.client.release(outcome.record_id)?;
    let board = rigged.board();
    Ok(Trace {
        record: record::digest(&record),
        elapsed_ns: board.elapsed().as_nanos(),
        instructions: board.instructions(),
        pairs: board.sample_pairs(),
        drive_code: board.drive_code(),
    })
}

#[test]
fn a_fast_run_is_the_plain_one() {
    let fast = trace(Execution::Fast).expect("runs");
    let plain = trace(Execution::Plain).expect("runs");
    assert_eq!(fast, plain);
    assert!(fast.pairs > 50_000, "{} pairs are no run", fast.pairs);
}
