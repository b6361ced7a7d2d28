//! The instrument's part: from the first byte of a stop on its line to a drive at rest, in virtual time.

use calib_core::point::ExcitationKind;
use calib_protocol::frame::{MAX_FRAME, encode};
use calib_protocol::message::{Request, RunSpec};
use calib_protocol::record::RunLabels;
use calib_tests::rigged::{Fault, Rigged, point};
use calib_twin::rig::Rig;
use rand_chacha::ChaCha20Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use std::time::Duration;

/// One look at the drive.
const LOOK: Duration = Duration::from_millis(1);
/// A drive that does not rest by then never does.
const LONGEST: Duration = Duration::from_millis(500);
/// Long enough to be no zero crossing of a tone.
const REST: Duration = Duration::from_millis(5);

/// Times of so many stops, at random instants of settling and measuring.
pub(crate) fn times(tries: usize) -> Result<Vec<Duration>, Fault> {
    let mut draws = ChaCha20Rng::seed_from_u64(18);
    let mut rigged = Rigged::with_rig(&Rig::standard())?;
    let mut times = Vec::new();
    for _ in 0..tries {
        rigged.client.start(RunSpec {
            points: [point(160.0, 10.0); 20].into_iter().collect(),
            excitation: ExcitationKind::SingleSine,
            labels: RunLabels::default(),
        })?;
        let after_ms = 200 + draws.next_u32() % 1500;
        rigged.client.wait(Duration::from_millis(after_ms.into()))?;
        times.push(stop(&rigged)?);
        rigged.client.wait(Duration::from_millis(300))?;
        let stored = rigged.client.records()?;
        rigged
            .client
            .release(stored.last().map_or(0, |last| last.id))?;
    }
    Ok(times)
}

fn stop(rigged: &Rigged) -> Result<Duration, Fault> {
    let mut frame = [0; 1 + MAX_FRAME];
    let length = encode(0x7000, &Request::Stop, &mut frame[1..])?;
    let mut board = rigged.board();
    let begun = board.elapsed();
    board.write_serial(&frame[..=length]);
    while board.elapsed() - begun < LONGEST {
        board.run_for(LOOK)?;
        if let Some(silent) = board.silent_for().filter(|silent| *silent >= REST) {
            return Ok((board.elapsed() - begun).saturating_sub(silent));
        }
    }
    Err("the drive does not rest".into())
}
