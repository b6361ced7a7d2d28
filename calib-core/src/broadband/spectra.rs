//! Averaged cross spectra of reference and device under test.

use super::{LINES, RECORD_SAMPLES};
use crate::converter::MID_SAMPLE;
use crate::point_state::Reason;
use core::fmt;
use microfft::complex::cfft_4096;
use num_complex::Complex32;

/// Averages the standard's note relies on.
pub const LEAST_AVERAGES: u32 = 64;

/// Coherence below which the note's 0.9 % no longer holds.
pub const LEAST_COHERENCE: f32 = 0.98;

/// Averaged spectra of one line.
#[derive(Clone, Copy, Debug)]
struct Line {
    reference: f32,
    dut: f32,
    cross: Complex32,
}

const NO_LINE: Line = Line {
    reference: 0.0,
    dut: 0.0,
    cross: Complex32::new(0.0, 0.0),
};

/// Room for the record in work and for all lines; 64 KB.
pub struct SpectraMemory {
    record: [Complex32; RECORD_SAMPLES],
    lines: [Line; LINES],
}

impl SpectraMemory {
    /// Empty memory, for a static.
    pub const fn new() -> Self {
        Self {
            record: [Complex32::new(0.0, 0.0); RECORD_SAMPLES],
            lines: [NO_LINE; LINES],
        }
    }
}

impl Default for SpectraMemory {
    fn default() -> Self {
        Self::new()
    }
}

/// Frequency response of one line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Response {
    /// H1: cross spectrum over the reference's spectrum; device under test per
    /// reference, in codes per code.
    pub ratio: Complex32,
    /// Coherence, 0 to 1.
    pub coherence: f32,
    /// Standard uncertainty of the magnitude, relative, and of the phase, rad,
    /// by noise that is not common to both channels.
    pub standard_uncertainty_rel: f32,
}

/// Why a line has no response.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum ResponseError {
    /// Fewer than 64 averages so far.
    Averages(u32),
    /// Coherence below 0.98: noise, distortion or no excitation at this line.
    Coherence,
    /// No such line.
    Line,
}

impl fmt::Display for ResponseError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Averages(count) => {
                write!(f, "{count} of {LEAST_AVERAGES} averages: measure on")
            }
            Self::Coherence => write!(f, "coherence is below {LEAST_COHERENCE}"),
            Self::Line => f.write_str("no such line in the spectrum"),
        }
    }
}

impl core::error::Error for ResponseError {}

impl From<ResponseError> for Reason {
    fn from(error: ResponseError) -> Self {
        match error {
            ResponseError::Averages(_) => Self::TooFewAverages,
            ResponseError::Coherence => Self::LowCoherence,
            ResponseError::Line => Self::FrequencyUnavailable,
        }
    }
}

/// Streams sample pairs into averaged spectra.
///
/// Both channels go through one complex transform, the reference as real and
/// the device as imaginary part. Records follow each other without overlap and
/// without a window: the excitation must repeat with the record.
pub struct CrossSpectra<'m> {
    memory: &'m mut SpectraMemory,
    filled: usize,
    averages: u32,
}

impl<'m> CrossSpectra<'m> {
    /// Starts with no average.
    pub fn new(memory: &'m mut SpectraMemory) -> Self {
        memory.lines.fill(NO_LINE);
        Self {
            memory,
            filled: 0,
            averages: 0,
        }
    }

    /// Records averaged so far.
    pub fn averages(&self) -> u32 {
        self.averages
    }

    /// Forgets everything.
    pub fn restart(&mut self) {
        self.memory.lines.fill(NO_LINE);
        self.filled = 0;
        self.averages = 0;
    }

    /// Takes pairs in offset binary, reference in the low half, at most to the
    /// end of the record in work; returns how many were taken.
    pub fn push(&mut self, pairs: &[u32]) -> usize {
        let room = RECORD_SAMPLES - self.filled;
        let taken = room.min(pairs.len());
        let slots = self.memory.record.iter_mut().skip(self.filled);
        for (slot, &pair) in slots.zip(pairs.iter().take(taken)) {
            *slot = Complex32::new(centred(pair & 0xFFFF), centred(pair >> 16));
        }
        self.filled += taken;
        if self.filled == RECORD_SAMPLES {
            self.average();
        }
        taken
    }

    /// True at the end of a record.
    pub fn is_at_end_of_record(&self) -> bool {
        self.filled == 0 && self.averages > 0
    }

    /// Mean square of the reference at a line, codes squared: of a sine of
    /// amplitude `a`, `a^2 / 2`.
    pub fn reference_mean_square(&self, line: usize) -> f32 {
        let square = self.memory.lines.get(line).map_or(0.0, |l| l.reference);
        let samples = RECORD_SAMPLES as f32;
        2.0 * square / (samples * samples * self.averages.max(1) as f32)
    }

    /// Coherence of a line, 0 to 1; 0 where nothing was seen.
    pub fn coherence(&self, line: usize) -> f32 {
        let seen = self.memory.lines.get(line).map_or(0.0, |line| {
            line.cross.norm_sqr() / (line.reference * line.dut)
        });
        if seen >= 0.0 { seen.min(1.0) } else { 0.0 }
    }

    /// Transforms the record and adds its spectra.
    fn average(&mut self) {
        self.filled = 0;
        self.averages += 1;
        let spectrum = cfft_4096(&mut self.memory.record);
        let ahead = spectrum.iter().skip(1);
        let back = spectrum.iter().rev();
        let lines = self.memory.lines.iter_mut().skip(1);
        for (line, (z, mirrored)) in lines.zip(ahead.zip(back)) {
            let reference = 0.5 * (z + mirrored.conj());
            // (z - conj(mirrored)) / 2j
            let difference = 0.5 * (z - mirrored.conj());
            let dut = Complex32::new(difference.im, -difference.re);
            line.reference += reference.norm_sqr();
            line.dut += dut.norm_sqr();
            line.cross += reference.conj() * dut;
        }
    }

    /// Response of a line.
    ///
    /// # Equation
    /// `H1 = Gxy / Gxx`, `g2 = |Gxy|^2 / (Gxx Gyy)`, and for `n` averages
    /// `u(|H1|)/|H1| = sqrt((1 - g2) / (2 n g2))` (Bendat and Piersol, Random
    /// Data, table 9.6).
    ///
    /// # Errors
    /// [`ResponseError`]: the line is refused.
    pub fn response(&self, index: usize) -> Result<Response, ResponseError> {
        let seen = self.memory.lines.get(index).filter(|_| index > 0);
        let line = seen.ok_or(ResponseError::Line)?;
        if self.averages < LEAST_AVERAGES {
            return Err(ResponseError::Averages(self.averages));
        }
        let coherence = self.coherence(index);
        if coherence < LEAST_COHERENCE {
            return Err(ResponseError::Coherence);
        }
        let spread = (1.0 - coherence) / (2.0 * self.averages as f32 * coherence);
        Ok(Response {
            ratio: line.cross / line.reference,
            coherence,
            standard_uncertainty_rel: libm::sqrtf(spread),
        })
    }
}

/// A sample about mid-scale.
fn centred(sample: u32) -> f32 {
    sample as f32 - f32::from(MID_SAMPLE)
}

#[cfg(test)]
mod tests {
    use super::super::{Excitation, Phases, line_frequency_hz, nearest_line};
    use super::*;

    struct Noise(u64);

    impl Noise {
        fn normal(&mut self) -> f64 {
            let mut sum = -2.0;
            for _ in 0..4 {
                self.0 ^= self.0 << 13;
                self.0 ^= self.0 >> 7;
                self.0 ^= self.0 << 17;
                sum += (self.0 >> 11) as f64 / (1_u64 << 53) as f64;
            }
            sum * 3.0_f64.sqrt()
        }
    }

    /// Feeds `averages` records of an excitation through a two-tap filter
    /// `0.8 x[n] + 0.15 x[n-1]` with noise of `sigma` codes on the device.
    fn measure<'m>(
        memory: &'m mut SpectraMemory,
        averages: u32,
        sigma: f64,
        random: bool,
    ) -> CrossSpectra<'m> {
        let mut spectra = CrossSpectra::new(memory);
        let mut noise = Noise(99);
        let mut buffer = Box::new([Complex32::new(0.0, 0.0); RECORD_SAMPLES]);
        for average in 0..averages {
            let phases = if random {
                Phases::Random { seed: average }
            } else {
                Phases::Multisine
            };
            let excitation = Excitation {
                first: 2,
                last: 900,
                phases,
            };
            excitation.fill(&mut buffer).expect("lines in range");
            let x: Vec<f64> = buffer.iter().map(|v| 20_000.0 * f64::from(v.re)).collect();
            let pairs: Vec<u32> = (0..RECORD_SAMPLES)
                .map(|n| {
                    let last = x[(n + RECORD_SAMPLES - 1) % RECORD_SAMPLES];
                    let dut = 0.8 * x[n] + 0.15 * last + sigma * noise.normal();
                    let code = |value: f64| (value.round() + 32_768.0) as u32;
                    code(x[n] + 500.0) | (code(dut) << 16)
                })
                .collect();
            for piece in pairs.chunks(700) {
                let mut rest = piece;
                while !rest.is_empty() {
                    let taken = spectra.push(rest);
                    rest = &rest[taken..];
                }
            }
        }
        spectra
    }

    fn truth(line: usize) -> (f64, f64) {
        let angle = std::f64::consts::TAU * line as f64 / RECORD_SAMPLES as f64;
        (0.8 + 0.15 * angle.cos(), -0.15 * angle.sin())
    }

    #[test]
    fn the_response_of_a_known_filter_is_found() {
        for random in [false, true] {
            let mut memory = Box::new(SpectraMemory::new());
            let spectra = measure(&mut memory, 64, 0.0, random);
            for line in [2, 50, 500, 900] {
                let response = spectra.response(line).expect("coherent");
                let (re, im) = truth(line);
                let error =
                    (f64::from(response.ratio.re) - re).hypot(f64::from(response.ratio.im) - im);
                // Codes are rounded (0.29 r.m.s.) under lines of at least
                // 20 000 / 5 / sqrt(450) = 190 codes: sqrt(2) 0.29 sqrt(2 / 4096
                // / 64) / 190 = 6e-6 when it is noise; the same record rounds
                // alike every time, 8 times that. 4 sigma.
                assert!(error < 2.0e-4, "{random} {line}: {error}");
                assert!(response.coherence > 0.999_9);
            }
        }
    }

    #[test]
    fn noise_shows_in_coherence_and_uncertainty() {
        // Lines of a multisine at 20 000 codes peak, crest 1.7, 899 lines:
        // 20 000 / 1.7 sqrt(2 / 899) = 555 codes peak, 0.93 of it in the
        // device. Noise of sigma per sample has sigma^2 4 / N per line of peak
        // squared: 1500 codes give 46.9^2; g2 = 1 / (1 + (46.9 / 516)^2) =
        // 0.9918.
        let mut memory = Box::new(SpectraMemory::new());
        let spectra = measure(&mut memory, 64, 1_500.0, false);
        let (mut sum, mut stated, mut coherence, mut seen) = (0.0, 0.0, 0.0, 0.0);
        for line in 50..850 {
            let Ok(response) = spectra.response(line) else {
                continue;
            };
            let (re, im) = truth(line);
            let error = (f64::from(response.ratio.re) - re).powi(2)
                + (f64::from(response.ratio.im) - im).powi(2);
            sum += 0.5 * error / (re * re + im * im);
            stated += f64::from(response.standard_uncertainty_rel).powi(2);
            coherence += f64::from(response.coherence);
            seen += 1.0;
        }
        assert!(seen > 780.0, "{seen}");
        assert!(
            (coherence / seen - 0.9918).abs() < 0.002,
            "{}",
            coherence / seen
        );
        // 800 lines of two parts: the variance scatters by 1/sqrt(800) = 3.5 %;
        // the stated one by 1/sqrt(64 * 800), and is biased by 1/64.
        assert!((sum / stated - 1.0).abs() < 0.15, "{}", sum / stated);
    }

    #[test]
    fn few_averages_and_low_coherence_refuse() {
        let mut memory = Box::new(SpectraMemory::new());
        let spectra = measure(&mut memory, 63, 0.0, false);
        assert_eq!(spectra.response(100), Err(ResponseError::Averages(63)));
        let mut memory = Box::new(SpectraMemory::new());
        let spectra = measure(&mut memory, 64, 3_000.0, false);
        assert_eq!(spectra.response(100), Err(ResponseError::Coherence));
        // Lines that are not excited, none, and none there can be.
        assert_eq!(spectra.response(1_500), Err(ResponseError::Coherence));
        assert_eq!(spectra.response(0), Err(ResponseError::Line));
        assert_eq!(spectra.response(LINES), Err(ResponseError::Line));
    }

    #[test]
    fn lines_and_frequencies_belong_together() {
        assert_eq!(nearest_line(160.0, 50_000.0), 13);
        assert!((line_frequency_hz(13, 50_000.0) - 158.691_4).abs() < 1.0e-3);
        assert_eq!(nearest_line(0.1, 50_000.0), 1);
        assert_eq!(nearest_line(1.0e9, 50_000.0), LINES - 1);
    }
}
