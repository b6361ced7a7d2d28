//! Records for tests, with numbers that follow from physics.
//!
//! The object is a damped oscillator (ISO 16063-43, formula (1)) of 10.2 mV per
//! m/s2, resonance 32 kHz, delta 0.02; the reference is flat, 10 mV/(m/s2), with
//! U = 0.5 % at all frequencies. U of each point is computed here in f64 from
//! the influence quantities, independently of calib-core.

use calib_core::channel_ratio::ChannelRatio;
use calib_core::point::{PointResult, PointSpec};
use calib_core::point_state::{PointState, Reason};
use calib_core::settings::{
    Distribution, Example, Influence, InputScale, Limits, Method, PointInfluences,
    ReferenceCalibration, ReferencePoint, Settings,
};
use calib_core::tone::Tone;
use calib_protocol::frame::CRC;
use calib_protocol::record::{self, Record, RecordHead, RunLabels};
use calib_protocol::signature::{self, Message, SIGNATURE_BYTES, Signature};
use ed25519_dalek::{Signer, SigningKey};
use heapless::{String, Vec};

/// One-third-octave frequencies of the default list, 20 Hz to 10 kHz (ISO 266).
pub const THIRD_OCTAVES_HZ: [f32; 28] = [
    20.0, 25.0, 31.5, 40.0, 50.0, 63.0, 80.0, 100.0, 125.0, 160.0, 200.0, 250.0, 315.0, 400.0,
    500.0, 630.0, 800.0, 1000.0, 1250.0, 1600.0, 2000.0, 2500.0, 3150.0, 4000.0, 5000.0, 6300.0,
    8000.0, 10_000.0,
];

/// Sensitivity of the object far below its resonance, V/(m/s2).
pub const SENSITIVITY_V_PER_MS2: f64 = 10.2e-3;
const RESONANCE_HZ: f64 = 32_000.0;
const DAMPING: f64 = 0.02;
const BLOCKS: u16 = 20;
const REPEATABILITY_REL: f64 = 1.5e-4;
/// Half-widths of rectangular influences by row of Table A.1: Table D.1's.
const RECTANGULAR_REL: [(u8, f64); 5] = [
    (2, 0.25e-2),
    (3, 0.2e-2),
    (8, 0.05e-2),
    (10, 0.15e-2),
    (11, 0.36e-2),
];

/// Magnitude (V/(m/s2)) and phase (rad) of the object at a frequency.
pub fn truth(frequency_hz: f64) -> (f64, f64) {
    let ratio = frequency_hz / RESONANCE_HZ;
    let (real, imaginary) = (1.0 - ratio * ratio, 2.0 * DAMPING * ratio);
    let magnitude = SENSITIVITY_V_PER_MS2 / real.hypot(imaginary);
    (magnitude, -imaginary.atan2(real))
}

/// A record of passing points at these frequencies, 10 m/s2.
pub fn record(frequencies_hz: &[f32]) -> Record {
    let mut points = Vec::new();
    for frequency_hz in frequencies_hz {
        points
            .push(point(*frequency_hz))
            .expect("at most 200 points");
    }
    Record {
        head: RecordHead {
            id: 17,
            instrument_serial: text("CAL-0042"),
            firmware: text("0.1.0 (1a2b3c4)"),
            sample_rate_hz: 50_000.0,
            labels: RunLabels {
                unix_time_s: 1_763_683_200, // 2025-11-21 00:00 UTC
                dut_model: text("Examplia 352C33"),
                dut_serial: text("LW 12345"),
                operator: text("M. Beispiel"),
                temperature_centi_c: Some(2310),
                mounting: text("stud M5, 2 Nm, light oil, vertical"),
            },
            ..RecordHead::BLANK
        },
        settings: settings(),
        complete: true,
        points,
        ..Record::BLANK
    }
}

/// The bytes of a record.
///
/// # Panics
/// When they do not fit.
pub fn bytes(record: &Record) -> std::vec::Vec<u8> {
    let mut bytes = vec![0; 16 * 1024];
    let length = record::encode(record, &mut bytes).expect("fits");
    bytes.truncate(length);
    bytes
}

/// The bytes of a record that the key of this seed signed, as an instrument does.
///
/// # Panics
/// When they do not fit.
pub fn signed(record: &Record, seed: &[u8; 32]) -> std::vec::Vec<u8> {
    let key = SigningKey::from_bytes(seed);
    let mut bytes = bytes(record);
    let length = bytes.len();
    bytes.resize(length + SIGNATURE_BYTES, 0);
    let sign = |message: &Message| {
        let signature = key.sign(message);
        Signature {
            key: key.verifying_key().to_bytes(),
            halves: [*signature.r_bytes(), *signature.s_bytes()],
        }
    };
    signature::append(&mut bytes, length, sign).expect("there is room");
    bytes
}

/// Makes the checksum of altered bytes right, as a forger does.
///
/// # Panics
/// When they are too few.
pub fn mend(bytes: &mut [u8]) {
    let (content, checksum) = bytes.split_last_chunk_mut::<4>().expect("a record");
    *checksum = CRC.checksum(content).to_le_bytes();
}

/// Words as a record holds them.
///
/// # Panics
/// When they do not fit.
pub fn text<const N: usize>(words: &str) -> String<N> {
    String::try_from(words).expect("fits")
}

fn settings() -> Settings {
    let mut influences = Vec::new();
    for (row, value_rel) in RECTANGULAR_REL {
        let influence = Influence {
            row,
            value_rel: value_rel as f32,
            value_phase_rad: 1.0e-3,
            distribution: Distribution::Rectangular,
        };
        influences.push(influence).expect("at most 20");
    }
    Settings {
        method: Method::Comparison,
        example: Example::Example2,
        reference: reference(),
        reference_input: InputScale {
            volt_per_code: 10.0 / 65_536.0,
        },
        dut_input: InputScale {
            volt_per_code: 10.0 / 65_536.0,
        },
        drive_full_scale_peak_v: 10.0,
        limits: Limits {
            drive_peak_v: 8.0,
            acceleration_peak_ms2: 200.0,
            velocity_peak_ms: 0.5,
            displacement_peak_m: 5.0e-3,
        },
        blocks: BLOCKS,
        influences,
        point_influences: PointInfluences::NONE,
        channel_ratio: ChannelRatio::UNKNOWN,
        lease_s: 0,
    }
}

fn reference() -> ReferenceCalibration {
    let mut points = Vec::new();
    for frequency_hz in [5.0, 160.0, 20_000.0] {
        let point = ReferencePoint {
            frequency_hz,
            sensitivity_v_per_ms2: 10.0e-3,
            phase_rad: 0.0,
            expanded_uncertainty_rel: 0.5e-2,
            expanded_uncertainty_phase_rad: 5.0e-3,
        };
        points.push(point).expect("fits");
    }
    ReferenceCalibration {
        serial: text("REF 8305-901"),
        certificate: text("NMI 2025-0815"),
        calibrated_day: 20_200, // 2025-04-22
        due_day: 20_565,        // 2026-04-22
        points,
    }
}

/// A passing point: tone, level, the object's response and its uncertainty.
pub fn point(frequency_hz: f32) -> PointResult {
    let tone = Tone::nearest(frequency_hz, 50_000.0).expect("in the band");
    let (sensitivity, phase) = truth(f64::from(tone.frequency_hz(50_000.0)));
    let (u_rel, u_phase) = standard_uncertainties();
    let spec = PointSpec {
        frequency_hz,
        acceleration_rms_ms2: 10.0,
    };
    PointResult {
        state: PointState::Valid,
        acceleration_rms_ms2: 10.003,
        sensitivity_v_per_ms2: sensitivity as f32,
        phase_rad: phase as f32,
        repeatability_rel: REPEATABILITY_REL as f32,
        repeatability_phase_rad: 2.0e-4,
        blocks: BLOCKS,
        expanded_uncertainty_rel: (2.0 * u_rel) as f32,
        coverage_factor: 2.0,
        effective_degrees_of_freedom: f32::INFINITY,
        expanded_uncertainty_phase_rad: (2.0 * u_phase) as f32,
        distortion_reference_rel: 0.004,
        distortion_dut_rel: 0.0043,
        signal_to_noise_reference_db: 71.5,
        signal_to_noise_dut_db: 71.2,
        amplitude_stability_rel: 3.0e-4,
        drive_peak_v: 0.8,
        settling_s: 0.21,
        overshoot_rel: 0.01,
        instrument_temperature_c: Some(48.25),
        ..PointResult::refused(spec, Some(tone), Reason::Stopped)
    }
}

/// Root sum of squares of the reference (k = 2), the rectangular influences
/// and the repeatability; all sensitivity coefficients are 1.
fn standard_uncertainties() -> (f64, f64) {
    let rectangular: f64 = RECTANGULAR_REL
        .iter()
        .map(|(_, half)| half * half / 3.0)
        .sum();
    let magnitude = (0.25e-2_f64.powi(2) + rectangular + REPEATABILITY_REL.powi(2)).sqrt();
    let phase = (2.5e-3_f64.powi(2) + 5.0 * 1.0e-6 / 3.0 + 4.0e-8).sqrt();
    (magnitude, phase)
}
