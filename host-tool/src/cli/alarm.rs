//! A stop that the calibrator does not confirm in time is told at once, and taken back when it does after all.

use calib_link::STOP_ALARM;
use std::io::Write;
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// Time between two looks.
const LOOK: Duration = Duration::from_millis(5);

/// From now on `confirmed` is looked at until it is true; [`STOP_ALARM`] without that is told on standard error,
/// `--quiet` or not.
pub(super) fn watch(confirmed: impl Fn() -> bool + Send + 'static) -> JoinHandle<()> {
    let asked = Instant::now();
    std::thread::spawn(move || {
        let mut is_late = false;
        while !confirmed() {
            let was_late = is_late;
            is_late = asked.elapsed() >= STOP_ALARM;
            if is_late && !was_late {
                let limit_ms = STOP_ALARM.as_millis();
                tell(&format!(
                    "NOT STOPPED: no confirmation within {limit_ms} ms. Use the button on the instrument, or \
                     the mute of the power amplifier"
                ));
            }
            std::thread::sleep(LOOK);
        }
        if is_late {
            let after_s = asked.elapsed().as_secs_f64();
            tell(&format!(
                "stopped after {after_s:.1} s: the exciter is silent"
            ));
        }
    })
}

fn tell(text: &str) {
    // Where nobody reads it, nobody can be told.
    let _ = writeln!(std::io::stderr(), "{text}");
}
