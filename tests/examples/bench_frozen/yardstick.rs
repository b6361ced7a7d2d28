//! A fixed amount of arithmetic, so that times of two computers can be compared at all.

use super::case::processor_s;

const REPEATS: usize = 9;
const STEPS: usize = 3_000_000;

/// Processor time of the fixed work, in s: the median of several.
pub(super) fn seconds() -> f64 {
    let mut times = [0.0; REPEATS];
    for time in &mut times {
        let start = processor_s();
        std::hint::black_box(work());
        *time = processor_s() - start;
    }
    times.sort_by(f64::total_cmp);
    times[REPEATS / 2]
}

/// Multiplications, divisions and a library function, in proportions like those of a fit.
fn work() -> f64 {
    let (mut re, mut im, mut sum) = (1.0_f64, 0.0_f64, 0.0_f64);
    let (cos, sin) = (0.3_f64.cos(), 0.3_f64.sin());
    for step in 0..STEPS {
        (re, im) = (re * cos - im * sin, re * sin + im * cos);
        sum += re / (1.0 + im * im);
        if step % 8 == 0 {
            sum += im.exp();
        }
    }
    sum
}
