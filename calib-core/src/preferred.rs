//! Frequencies and accelerations that ISO 16063-21, 5.1 and 5.3 prefer.

/// One-third-octave midband frequencies of ISO 266 from 5 Hz to 10 kHz, Hz.
pub const PREFERRED_HZ: [f32; 34] = [
    5.0, 6.3, 8.0, 10.0, 12.5, 16.0, 20.0, 25.0, 31.5, 40.0, 50.0, 63.0, 80.0, 100.0, 125.0, 160.0,
    200.0, 250.0, 315.0, 400.0, 500.0, 630.0, 800.0, 1000.0, 1250.0, 1600.0, 2000.0, 2500.0,
    3150.0, 4000.0, 5000.0, 6300.0, 8000.0, 10_000.0,
];

/// Reference frequencies in the order 5.3 prefers them, Hz.
pub const REFERENCE_HZ: [f32; 2] = [160.0, 80.0];

/// Preferred accelerations 1, 2, 5 times powers of ten (5.1), m/s2.
pub const LEVELS_MS2: [f32; 13] = [
    0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0,
];

/// Reference accelerations in the order 5.3 prefers them, m/s2.
pub const REFERENCE_MS2: [f32; 4] = [100.0, 10.0, 20.0, 50.0];

/// Fewest points a calibration should have (5.1).
pub const FEWEST_POINTS: usize = 6;
