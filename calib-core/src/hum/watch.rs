//! At rest: which lines of the mains there are.

use crate::correlation::{OUTLINE, Outline};
use core::f32::consts::{PI, TAU};
use num_complex::Complex32;

/// Multiples of the mains frequency that are looked at: rectifiers and dimmers have little beyond.
pub const LINES: usize = 10;
/// Blocks of 0.1 s: 1 s tells the mains frequency to some mHz.
pub const WATCH_BLOCKS: usize = 10;
/// Length of a block, s: whole cycles of every multiple of 50 and of 60 Hz.
const BLOCK_S: f32 = 0.1;
/// Nominal frequencies of the mains, Hz.
const NOMINAL_HZ: [f32; 2] = [50.0, 60.0];
/// Furthest from nominal that is searched, Hz: isolated grids and generator sets.
const FURTHEST_HZ: f32 = 0.5;
/// Steps of the search, Hz: the tenth line has a peak 0.4 Hz / 10 wide at half its height.
const STEPS_HZ: [f32; 2] = [0.02, 0.002];
/// Square of a line over that of its noise, from which on it is one: chance passes it once in 8 000.
const SIGNIFICANT: f32 = 9.0;

/// Complex amplitudes of both channels.
type Pair = [Complex32; 2];

/// The mains, as the inputs see it at rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hum {
    /// Frequency of the mains, Hz.
    pub mains_hz: f32,
    /// Amplitude of its multiples 1 to 10 in both channels, codes peak; 0 of what is no line.
    pub lines_peak: [[f32; 2]; LINES],
}

/// Collects blocks of samples at rest, one after another without a gap.
#[derive(Clone, Debug)]
pub struct Watch {
    count: usize,
    /// For both nominal frequencies, line by line.
    blocks: [[[Pair; LINES]; 2]; WATCH_BLOCKS],
}

impl Watch {
    /// Nothing collected.
    pub const fn new() -> Self {
        const NONE: Complex32 = Complex32::new(0.0, 0.0);
        Self {
            count: 0,
            blocks: [[[[NONE; 2]; LINES]; 2]; WATCH_BLOCKS],
        }
    }

    /// Begins anew, after a gap.
    pub fn restart(&mut self) {
        self.count = 0;
    }

    /// Blocks collected, at most those of a second.
    pub fn count(&self) -> usize {
        self.count
    }

    /// True when a second was collected; later blocks take the place of the first.
    pub fn is_full(&self) -> bool {
        self.count == WATCH_BLOCKS
    }

    /// Adds the next block of 0.1 s.
    #[inline(never)]
    pub fn add(&mut self, outline: &Outline) {
        if self.is_full() {
            self.blocks.rotate_left(1);
            self.count -= 1;
        }
        if let Some(block) = self.blocks.get_mut(self.count) {
            for (family, nominal_hz) in block.iter_mut().zip(NOMINAL_HZ) {
                for (line, n) in family.iter_mut().zip(1_u16..) {
                    *line = line_of(outline, f32::from(n) * nominal_hz);
                }
            }
            self.count += 1;
        }
    }

    /// The mains; none before a second was collected, and where there are no lines.
    #[inline(never)]
    pub fn hum(&self) -> Option<Hum> {
        if !self.is_full() {
            return None;
        }
        let window = core::array::from_fn(hann);
        let families = [0, 1].map(|family| {
            let beside_hz = self.beside_nominal_hz(&window, family);
            let (lines_peak, energy) = self.lines(&window, family, beside_hz);
            let mains_hz = NOMINAL_HZ.get(family).copied().unwrap_or_default() + beside_hz;
            (
                Hum {
                    mains_hz,
                    lines_peak,
                },
                energy,
            )
        });
        let [fifty, sixty] = families;
        let (hum, energy) = if sixty.1 > fifty.1 { sixty } else { fifty };
        (energy > 0.0).then_some(hum)
    }

    /// Where the lines of a family together are largest.
    #[inline(never)]
    fn beside_nominal_hz(&self, window: &Window, family: usize) -> f32 {
        let mut centre_hz = 0.0;
        let mut reach_hz = FURTHEST_HZ;
        for step_hz in STEPS_HZ {
            let steps = libm::roundf(reach_hz / step_hz) as i32;
            let mut best = (0.0, centre_hz);
            for step in -steps..=steps {
                let at_hz = centre_hz + step as f32 * step_hz;
                let energy = self.energy(window, family, at_hz);
                if energy > best.0 {
                    best = (energy, at_hz);
                }
            }
            centre_hz = best.1;
            reach_hz = step_hz;
        }
        centre_hz
    }

    fn energy(&self, window: &Window, family: usize, beside_hz: f32) -> f32 {
        (0..LINES)
            .flat_map(|line| self.means(window, family, line, beside_hz))
            .map(|mean| mean.norm_sqr())
            .sum()
    }

    /// Amplitudes, in both channels, of a line of a mains frequency so far beside nominal.
    ///
    /// # Equation
    /// `sum w_b X_b exp(-j 2 pi n d T b)`, `w` Hann's window over the blocks: what vibrates beside the
    /// mains has other phases from block to block and cancels.
    #[inline(never)]
    fn means(&self, window: &Window, family: usize, line: usize, beside_hz: f32) -> Pair {
        let turn = turn(line, beside_hz);
        let mut phasor = Complex32::new(1.0, 0.0);
        let mut sums = [Complex32::new(0.0, 0.0); 2];
        for (pair, weight) in self.values(family, line).zip(window) {
            for (sum, value) in sums.iter_mut().zip(pair) {
                *sum += value * phasor * weight;
            }
            phasor *= turn;
        }
        sums
    }

    /// A line in both channels, block by block.
    fn values(&self, family: usize, line: usize) -> impl Iterator<Item = Pair> + '_ {
        self.blocks.iter().map(move |block| {
            let pair = block.get(family).and_then(|lines| lines.get(line));
            pair.copied().unwrap_or_default()
        })
    }

    /// Amplitudes of the lines that are some, and the sum of their squares.
    #[inline(never)]
    fn lines(&self, window: &Window, family: usize, beside_hz: f32) -> ([[f32; 2]; LINES], f32) {
        let mut lines = [[0.0; 2]; LINES];
        let mut energy = 0.0;
        for (line, peaks) in lines.iter_mut().enumerate() {
            let means = self.means(window, family, line, beside_hz);
            let noise = self.noise_squares(window, family, line, beside_hz);
            for ((peak, mean), noise_square) in peaks.iter_mut().zip(means).zip(noise) {
                let square = mean.norm_sqr();
                if square > SIGNIFICANT * noise_square {
                    *peak = libm::sqrtf(square);
                    energy += square;
                }
            }
        }
        (lines, energy)
    }

    /// Variances of [`Self::means`] by what differs from block to block.
    #[inline(never)]
    fn noise_squares(
        &self,
        window: &Window,
        family: usize,
        line: usize,
        beside_hz: f32,
    ) -> [f32; 2] {
        let turn = turn(line, beside_hz);
        let (mut before, mut differences) = (None::<Pair>, [0.0; 2]);
        for pair in self.values(family, line) {
            if let Some(before) = before {
                for ((sum, value), before) in differences.iter_mut().zip(pair).zip(before) {
                    *sum += (value * turn - before).norm_sqr();
                }
            }
            before = Some(pair);
        }
        let squares: f32 = window.iter().map(|weight| weight * weight).sum();
        differences.map(|sum: f32| sum / (2 * (WATCH_BLOCKS - 1)) as f32 * squares)
    }
}

impl Default for Watch {
    fn default() -> Self {
        Self::new()
    }
}

/// How a line turns from block to block, taken back.
fn turn(line: usize, beside_hz: f32) -> Complex32 {
    Complex32::from_polar(1.0, -TAU * (line + 1) as f32 * beside_hz * BLOCK_S)
}

/// Weights of the blocks.
type Window = [f32; WATCH_BLOCKS];

/// Hann's window over the blocks, of sum 1.
fn hann(index: usize) -> f32 {
    let angle = PI * (index as f32 + 0.5) / WATCH_BLOCKS as f32;
    let sine = libm::sinf(angle);
    // The squares of so many sines sum up to half their number.
    2.0 * sine * sine / WATCH_BLOCKS as f32
}

/// Complex peak amplitude of both channels at a frequency that has whole cycles in the block.
#[inline(never)]
fn line_of(outline: &Outline, frequency_hz: f32) -> Pair {
    let step_rad = TAU * frequency_hz * BLOCK_S / OUTLINE as f32;
    let turn = Complex32::from_polar(1.0, -step_rad);
    let mut phasor = Complex32::new(1.0, 0.0);
    let mut sums = [Complex32::new(0.0, 0.0); 2];
    for values in outline {
        for (sum, value) in sums.iter_mut().zip(values) {
            *sum += phasor * value;
        }
        phasor *= turn;
    }
    // A value is a mean over the step, which takes sin(x)/x of a line.
    let half_rad = 0.5 * step_rad;
    let scale = 2.0 / OUTLINE as f32 * half_rad / libm::sinf(half_rad);
    sums.map(|sum| sum * scale)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Ten blocks of lines `(n, peak)` of the device's channel, with a floor that shakes both.
    fn watched(mains_hz: f64, lines: &[(f64, f64)], floor: (f64, f64)) -> Watch {
        let mut watch = Watch::new();
        let rate_hz = OUTLINE as f64 / f64::from(BLOCK_S);
        let mut n = 0.0;
        for _ in 0..WATCH_BLOCKS {
            let outline = core::array::from_fn(|_| {
                let t = n / rate_hz;
                n += 1.0;
                let wave = |hz: f64| (std::f64::consts::TAU * hz * t + 0.7).sin();
                let hum: f64 = lines
                    .iter()
                    .map(|(k, peak)| peak * wave(k * mains_hz))
                    .sum();
                let shaken = floor.1 * wave(floor.0);
                [shaken as f32, (hum + shaken) as f32]
            });
            watch.add(&outline);
        }
        watch
    }

    /// Values of the outline here are instants, not means: what [`line_of`] makes up for is
    /// x / sin x with x = pi f / 5 kHz, 1.6e-4 at 50 Hz and 1.5e-3 at 150 Hz.
    #[test]
    fn mains_frequency_and_lines_are_found() {
        for mains_hz in [49.9, 49.98, 50.0, 50.01, 50.1, 59.9, 60.0, 60.1] {
            let watch = watched(mains_hz, &[(1.0, 2.8), (3.0, 0.4)], (23.0, 0.0));
            let hum = watch.hum().expect("lines");
            // A step of the search and the sidelobes of one line in another.
            assert!(
                (f64::from(hum.mains_hz) - mains_hz).abs() < 0.004,
                "{hum:?}"
            );
            for (line, expected) in [(0, 2.8), (2, 0.4)] {
                let [reference, dut] = hum.lines_peak[line];
                assert_eq!(reference, 0.0);
                assert!((dut / expected - 1.0).abs() < 0.02, "{mains_hz}: {hum:?}");
            }
        }
    }

    /// Within d = 1 Hz of a multiple of 10 Hz a neighbour's machine repeats from block to block nearly as
    /// lines do; `sin(pi d / 10 Hz) 10 Hz / (pi D)` of it remain in a line D away: 3.8 % for the worst of these,
    /// 29.2 Hz in 50 Hz.
    #[test]
    fn a_shaking_floor_is_no_hum() {
        for floor_hz in [9.7, 18.3, 23.0, 29.2] {
            let hum = watched(50.0, &[], (floor_hz, 5.0)).hum();
            let largest = hum.map_or(0.0, |hum| {
                hum.lines_peak
                    .as_flattened()
                    .iter()
                    .fold(0.0_f32, |a, b| a.max(*b))
            });
            assert!(largest < 0.038 * 5.0, "{floor_hz}: {hum:?}");
        }
        assert_eq!(watched(50.0, &[], (23.0, 0.0)).hum(), None);
        assert_eq!(Watch::new().hum(), None);
    }
}
