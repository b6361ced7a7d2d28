//! Many draws on emulated instruments, on all cores.

use crate::rigged::{Fault, Rigged};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Mutex, PoisonError};

/// Draws that share an instrument, one after the other. A whole number of them
/// is a worker's turn, so that what an instrument saw before a draw depends on
/// no core and no clock.
const TURN: u64 = 25;

/// Carries out draws 0 to `draws` by `one` and adds what comes of them; `progress` hears how many are
/// done. The first call of `one` in a turn gets no instrument and leaves the one it booted.
///
/// # Errors
/// The first draw that could not be carried out.
pub fn all<T: Default + Send>(
    draws: u64,
    one: impl Fn(&mut Option<Rigged>, u64) -> Result<T, Fault> + Sync,
    add: impl Fn(&mut T, T) + Sync,
    progress: impl Fn(u64) + Sync,
) -> Result<T, Fault> {
    let (next, done) = (AtomicU64::new(0), AtomicU64::new(0));
    let total = Mutex::new((T::default(), None));
    let work = || {
        loop {
            let first = TURN * next.fetch_add(1, Ordering::Relaxed);
            if first >= draws {
                return;
            }
            // One instrument sees many devices, as in life; booting it for each
            // would take as long as the measurement.
            let mut rigged = None;
            for draw in first..draws.min(first + TURN) {
                let outcome = one(&mut rigged, draw);
                let mut total = total.lock().unwrap_or_else(PoisonError::into_inner);
                match outcome {
                    Ok(tally) => add(&mut total.0, tally),
                    Err(fault) => total.1 = total.1.take().or(Some(fault)),
                }
                progress(1 + done.fetch_add(1, Ordering::Relaxed));
            }
        }
    };
    let workers = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        for _ in 0..workers {
            scope.spawn(work);
        }
    });
    match total.into_inner().unwrap_or_else(PoisonError::into_inner) {
        (_, Some(fault)) => Err(fault),
        (tally, None) => Ok(tally),
    }
}
