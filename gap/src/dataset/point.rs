//! One steady-state sine point, as it was measured.

use super::record::Record;
use num_complex::Complex64;

/// A harmonic relative to its fundamental; without a phase column only the amplitude is known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Harmonic {
    /// Amplitude over the fundamental's.
    pub(crate) amplitude: f64,
    /// Phase relative to n times the fundamental's phase, in rad.
    pub(crate) phase_rad: Option<f64>,
}

/// One row of `points.csv`; phases in rad, amplitudes r.m.s., absent values `None`.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Point {
    /// Excitation frequency.
    pub(crate) frequency_hz: f64,
    /// Index of the run's label.
    pub(crate) run: usize,
    /// Time since the first point.
    pub(crate) time_s: Option<f64>,
    /// Transducer temperature.
    pub(crate) temperature_c: Option<f64>,
    /// Rotation of the device under test about the axis of motion.
    pub(crate) rotation_rad: Option<f64>,
    /// Angle between the axis of motion and the vertical.
    pub(crate) tilt_rad: Option<f64>,
    /// Mass on the armature.
    pub(crate) payload_kg: Option<f64>,
    /// Level the rig held, r.m.s.
    pub(crate) acceleration_ms2: Option<f64>,
    /// Coil voltage, r.m.s.
    pub(crate) coil_v: Option<f64>,
    /// Coil current, r.m.s.
    pub(crate) coil_a: Option<f64>,
    /// Phase of the current relative to the coil voltage.
    pub(crate) coil_a_rad: Option<f64>,
    /// Reference channel, r.m.s.
    pub(crate) ref_v: Option<f64>,
    /// Phase of the reference channel relative to the coil voltage.
    pub(crate) ref_rad: Option<f64>,
    /// Device under test, r.m.s.
    pub(crate) dut_v: Option<f64>,
    /// Phase of the device under test relative to the reference channel.
    pub(crate) dut_rad: Option<f64>,
    /// Ratio dut/ref, when only that was recorded.
    pub(crate) ratio: Option<f64>,
    /// Harmonics 2..5 of the reference channel.
    pub(crate) ref_harmonics: [Option<Harmonic>; 4],
    /// Harmonics 2..5 of the device under test.
    pub(crate) dut_harmonics: [Option<Harmonic>; 4],
    /// Mean of the reference channel, in V.
    pub(crate) ref_dc_v: Option<f64>,
    /// Mean of the device under test, in V.
    pub(crate) dut_dc_v: Option<f64>,
    /// Noise of the reference channel, r.m.s.
    pub(crate) ref_noise_v: Option<f64>,
    /// Noise of the device under test, r.m.s.
    pub(crate) dut_noise_v: Option<f64>,
    /// Relative standard uncertainty of the ratio.
    pub(crate) u_ratio: Option<f64>,
    /// Standard uncertainty of `dut_rad`.
    pub(crate) u_phase_rad: Option<f64>,
    /// Relative standard uncertainty of ref/coil voltage.
    pub(crate) u_drive: Option<f64>,
    /// Relative standard uncertainty of coil current/voltage.
    pub(crate) u_current: Option<f64>,
    /// Standard uncertainty of the real and the imaginary part of each harmonic.
    pub(crate) u_harmonic: Option<f64>,
    /// Standard uncertainty of the d.c. values.
    pub(crate) u_dc_v: Option<f64>,
}

impl Harmonic {
    /// Complex value, when the phase is known.
    #[must_use]
    pub(crate) fn complex(&self) -> Option<Complex64> {
        self.phase_rad
            .map(|phase| Complex64::from_polar(self.amplitude, phase))
    }
}

/// The measured part of a dataset.
#[derive(Debug, Clone)]
pub(crate) enum Measured {
    /// Steady-state sine points of a calibrator, and the names of the columns that held values.
    Points {
        /// One entry per row of `points.csv`.
        points: Vec<Point>,
        /// Columns that were present.
        columns: Vec<String>,
    },
    /// A uniformly sampled record of an oscillator.
    Record(Record),
}
