//! The clock beside the frames of the USB host, which come once in a millisecond: two clocks that know
//! nothing of each other, so one that is wrong shows.

use crate::board::{FRAME_NUMBERS, frame_number, is_addressed};
use crate::state;
use embassy_time::{Duration, Instant, Timer};

/// Time between two looks. An edge is seen within [`GAP`]: 2 ppm of this.
const PERIOD: Duration = Duration::from_secs(10);
/// Two looks at the number must follow each other so closely: nothing came between.
const GAP: Duration = Duration::from_micros(20);
/// A frame begins within this, or there is no host.
const FRAME: Duration = Duration::from_micros(1_500);
const FRAME_US: i64 = 1_000;

/// A frame, and when it began.
#[derive(Clone, Copy)]
struct Stamp {
    number: u32,
    at: Instant,
}

/// Compares the clock with the frames while there are any.
#[embassy_executor::task]
pub(crate) async fn timebase() -> ! {
    let mut before: Option<Stamp> = None;
    loop {
        Timer::after(PERIOD).await;
        let now = if is_addressed() { next_frame() } else { None };
        let ppm = before
            .zip(now)
            .map(|(before, now)| deviation_ppm(before, now));
        // A look that something came between says nothing.
        if ppm.is_some() || !is_addressed() {
            state::TIMEBASE_PPM.set(ppm);
        }
        before = now;
    }
}

/// The beginning of the next frame; none when something came between two looks at it.
fn next_frame() -> Option<Stamp> {
    let (number, begun) = (frame_number(), Instant::now());
    let mut looked = begun;
    while begun.elapsed() < FRAME {
        let (found, at) = (frame_number(), Instant::now());
        if found != number {
            return (at - looked < GAP).then_some(Stamp { number: found, at });
        }
        looked = at;
    }
    None
}

/// How much faster the clock is than the frames between two of them, ppm. Their numbers begin anew
/// every two seconds: how often they did, the clock itself says well enough.
fn deviation_ppm(before: Stamp, now: Stamp) -> f32 {
    let elapsed_us = (now.at - before.at).as_micros() as i64;
    let numbers = i64::from(FRAME_NUMBERS);
    let beyond = i64::from(now.number) - i64::from(before.number);
    let rounds = (elapsed_us / FRAME_US - beyond + numbers / 2).div_euclid(numbers);
    let frames_us = (beyond + rounds * numbers).max(1) * FRAME_US;
    (elapsed_us - frames_us) as f32 / frames_us as f32 * 1e6
}
