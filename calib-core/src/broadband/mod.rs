//! Multisine and random excitation (ISO 16063-21, 4.4, Note 1).
//!
//! | file | what |
//! |---|---|
//! | [`excitation`] | one period of a multisine, or of noise that repeats |
//! | [`player`] | the period as codes, again and again |
//! | [`spectra`] | averaged cross spectra, H1 response and coherence |
//!
//! Both excitations repeat with the record, so no window is needed and nothing
//! leaks: every line of the spectrum is a whole number of cycles. Single-sine
//! remains the default; this is the quick look at many frequencies at once.

pub mod excitation;
pub mod player;
pub mod spectra;

pub use excitation::{Excitation, Phases};
pub use player::{BroadbandDrive, PeriodMemory, Player};
pub use spectra::{CrossSpectra, LEAST_AVERAGES, Response, ResponseError, SpectraMemory};

/// Samples of one record: 12.2 Hz between lines at 50 kS/s.
pub const RECORD_SAMPLES: usize = 4096;

/// Lines of a record below half the sample rate.
pub const LINES: usize = RECORD_SAMPLES / 2;

/// Frequency of a line, Hz.
pub fn line_frequency_hz(line: usize, sample_rate_hz: f32) -> f32 {
    line as f32 * sample_rate_hz / RECORD_SAMPLES as f32
}

/// The line nearest to a frequency, at least 1 and below [`LINES`].
pub fn nearest_line(frequency_hz: f32, sample_rate_hz: f32) -> usize {
    let line = libm::roundf(frequency_hz * RECORD_SAMPLES as f32 / sample_rate_hz);
    (line as usize).clamp(1, LINES - 1)
}
