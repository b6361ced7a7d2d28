//! The mains and the noise, as heard while the exciter rests.

use crate::correlation::{Block, Energy, Outline};
use crate::hum::{Hum, WATCH_BLOCKS, Watch};
use crate::tone::Tone;

/// Time for which the mains as heard hold for a point far from every line, s.
const GOOD_FOR_S: f32 = 60.0;
/// And for one beside a line: the grid moves by 10 mHz in such a time.
const GOOD_BESIDE_A_LINE_FOR_S: f32 = 5.0;
/// Beside a line, Hz: within the width of a block of 0.1 s.
const BESIDE_HZ: f32 = 10.0;
/// A line that is less of the set level does not need to be heard again.
const SMALL_REL: f32 = 2.0e-4;

/// The mains as last heard, and the noise.
#[derive(Clone, Debug)]
pub(super) struct Listening {
    watch: Watch,
    /// Mean square of both channels about their means over the last blocks, codes squared.
    noise_square: [f32; 2],
    /// `noise_square` when a point last took over what was heard.
    rest_square: [f32; 2],
    /// A second was heard, and this was in it.
    heard: Option<Option<Hum>>,
    /// Samples since.
    age: u32,
}

impl Listening {
    pub(super) const fn new() -> Self {
        Self {
            watch: Watch::new(),
            noise_square: [0.0; 2],
            rest_square: [0.0; 2],
            heard: None,
            age: 0,
        }
    }

    /// So many samples have passed.
    pub(super) fn pass(&mut self, samples: usize) {
        self.age = self.age.saturating_add(samples as u32);
    }

    /// The lines there are.
    pub(super) fn hum(&self) -> Option<Hum> {
        self.heard.flatten()
    }

    /// The largest line of a channel, codes; 0 as long as nobody listened.
    pub(super) fn largest_line_peak(&self, channel: usize) -> f32 {
        let hum = self.hum();
        let lines = hum.iter().flat_map(|hum| &hum.lines_peak);
        lines
            .filter_map(|peaks| peaks.get(channel))
            .fold(0.0, |a, b| a.max(*b))
    }

    /// Mean square of both channels with the exciter at rest, codes squared: what has nothing to do with
    /// the motion. 0 as long as nobody listened.
    pub(super) fn rest_square(&self) -> [f32; 2] {
        self.rest_square
    }

    /// Adds a block at rest.
    pub(super) fn add(&mut self, outline: &Outline, energy: Energy) {
        let weight = 1.0 / (self.watch.count() + 1).min(WATCH_BLOCKS) as f32;
        for (channel, square) in self.noise_square.iter_mut().enumerate() {
            let values = outline.iter().filter_map(|pair| pair.get(channel));
            let mean = values.sum::<f32>() / outline.len() as f32;
            *square += (energy.mean_square(channel) - mean * mean - *square) * weight;
        }
        self.watch.add(outline);
    }

    /// Forgets the blocks that were not taken over, and listens anew.
    pub(super) fn restart(&mut self) {
        self.watch.restart();
    }

    /// Enough was heard to be taken over.
    pub(super) fn is_full(&self) -> bool {
        self.watch.is_full()
    }

    /// Takes over what was heard.
    pub(super) fn understand(&mut self) {
        self.heard = Some(self.watch.hum());
        self.rest_square = self.noise_square;
        self.age = 0;
    }

    /// Takes over what was heard in full; whether what is known of the mains then is too old for a tone of `set_peak`
    /// codes, or too little.
    pub(super) fn is_stale(
        &mut self,
        frequency_hz: f32,
        set_peak: f32,
        sample_rate_hz: f32,
    ) -> bool {
        if self.watch.is_full() {
            self.understand();
        }
        let age_s = self.age as f32 / sample_rate_hz;
        match self.heard {
            None => true,
            Some(Some(hum)) if is_beside_a_line(&hum, frequency_hz, set_peak) => {
                age_s > GOOD_BESIDE_A_LINE_FOR_S
            }
            Some(_) => age_s > GOOD_FOR_S,
        }
    }
}

fn is_beside_a_line(hum: &Hum, frequency_hz: f32, set_peak: f32) -> bool {
    hum.lines_peak.iter().zip(1_u16..).any(|(peaks, multiple)| {
        let beside_hz = (frequency_hz - f32::from(multiple) * hum.mains_hz).abs();
        let largest = peaks.iter().fold(0.0_f32, |a, b| a.max(*b));
        beside_hz < BESIDE_HZ && largest > SMALL_REL * set_peak
    })
}

/// A block in which every multiple of 50 and 60 Hz has whole cycles.
pub(super) fn block(sample_rate_hz: f32) -> Block {
    let tone = Tone {
        cycles: 1,
        period_samples: (0.1 * sample_rate_hz) as u16,
    };
    Block::measuring(tone, 1)
}
