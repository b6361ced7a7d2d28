//! Which points a diagnosis asks for.

use super::Nominal;
use crate::oracle::ONE_THIRD_OCTAVES_HZ;

/// Under which conditions one point is measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setting {
    /// Frequency, Hz.
    pub frequency_hz: f64,
    /// Level to be held, m/s2 r.m.s.
    pub level_ms2: f64,
    /// Number of the run: one mounting and power-up.
    pub run: usize,
    /// Time since the first point, s.
    pub time_s: f64,
    /// Temperature of the transducers, degC.
    pub temperature_c: f64,
    /// Rotation of the device under test about the axis, degrees.
    pub rotation_deg: f64,
    /// Angle between the axis and the vertical, degrees.
    pub tilt_deg: f64,
    /// Mass mounted, kg.
    pub payload_kg: f64,
}

/// Seconds a point takes with settling.
const POINT_S: f64 = 20.0;
/// Seconds between two runs: mounting and warming up.
const PAUSE_S: f64 = 900.0;
/// Travel that is not exceeded, m peak.
const TRAVEL_M: f64 = 0.004;
/// Coil voltage that is not exceeded, V peak.
const COIL_V: f64 = 20.0;
/// Payload of most points, kg.
const USUAL_PAYLOAD_KG: f64 = 0.040;

/// Collects points in the order in which they are measured.
struct Session {
    settings: Vec<Setting>,
    usual: Setting,
}

impl Session {
    fn run(&mut self) {
        self.usual.run += 1;
        self.usual.time_s += PAUSE_S;
    }

    fn point(&mut self, frequency_hz: f64, level_ms2: f64, change: impl Fn(&mut Setting)) {
        let mut setting = Setting {
            frequency_hz,
            level_ms2,
            ..self.usual
        };
        change(&mut setting);
        self.settings.push(setting);
        self.usual.time_s += POINT_S;
    }
}

/// The usual diagnostic session: 214 points.
///
/// | run | points | what is varied |
/// |---|---|---|
/// | 0, 1 | 34 each | frequency in one-third octaves, 10 m/s2, two mountings |
/// | 2 | 36 | six levels at six frequencies |
/// | 3 | 36 | four rotations at nine frequencies |
/// | 4 | 16 | two tilts at eight frequencies |
/// | 5, 6 | 14 each | two payloads at 14 frequencies |
/// | 7, 8 | 8 each | two temperatures at eight frequencies |
/// | 9 | 14 | two frequencies, seven times over two hours |
///
/// Levels are lowered where travel (4 mm peak) or coil voltage (20 V peak) would be exceeded.
pub fn standard_design(nominal: &Nominal) -> Vec<Setting> {
    let mut session = Session {
        settings: Vec::new(),
        usual: Setting {
            frequency_hz: 0.0,
            level_ms2: 0.0,
            run: 0,
            time_s: 0.0,
            temperature_c: nominal.environment.reference_temperature_c,
            rotation_deg: 0.0,
            tilt_deg: 0.0,
            payload_kg: USUAL_PAYLOAD_KG,
        },
    };
    for _ in 0..2 {
        for frequency_hz in ONE_THIRD_OCTAVES_HZ {
            session.point(frequency_hz, 10.0, |_| {});
        }
        session.run();
    }
    levels_and_directions(&mut session);
    payloads_and_temperatures(&mut session);
    for _ in 0..7 {
        for frequency_hz in [160.0, 8000.0] {
            session.point(frequency_hz, 10.0, |_| {});
        }
        session.usual.time_s += 1000.0;
    }
    for setting in &mut session.settings {
        setting.level_ms2 = setting.level_ms2.min(highest_level_ms2(nominal, setting));
    }
    session.settings
}

fn levels_and_directions(session: &mut Session) {
    for level_ms2 in [1.0, 2.0, 5.0, 20.0, 50.0, 100.0] {
        for frequency_hz in [16.0, 40.0, 80.0, 160.0, 1000.0, 5000.0] {
            session.point(frequency_hz, level_ms2, |_| {});
        }
    }
    session.run();
    for rotation_deg in [0.0, 90.0, 180.0, 270.0] {
        for frequency_hz in [
            5.0, 10.0, 40.0, 160.0, 1000.0, 2500.0, 4000.0, 6300.0, 10_000.0,
        ] {
            session.point(frequency_hz, 10.0, |setting| {
                setting.rotation_deg = rotation_deg
            });
        }
    }
    session.run();
    for tilt_deg in [45.0, 90.0] {
        for frequency_hz in [5.0, 8.0, 16.0, 31.5, 50.0, 63.0, 160.0, 1000.0] {
            session.point(frequency_hz, 10.0, |setting| setting.tilt_deg = tilt_deg);
        }
    }
    session.run();
}

fn payloads_and_temperatures(session: &mut Session) {
    for payload_kg in [0.020, 0.100] {
        for frequency_hz in [
            5.0, 8.0, 12.5, 20.0, 31.5, 50.0, 80.0, 160.0, 500.0, 1600.0, 3150.0, 5000.0, 8000.0,
            10_000.0,
        ] {
            session.point(frequency_hz, 10.0, |setting| {
                setting.payload_kg = payload_kg
            });
        }
        session.run();
    }
    for warmer_k in [-8.0, 10.0] {
        for frequency_hz in [16.0, 40.0, 80.0, 160.0, 500.0, 1600.0, 5000.0, 10_000.0] {
            session.point(frequency_hz, 10.0, |setting| {
                setting.temperature_c += warmer_k
            });
        }
        session.run();
    }
}

/// The highest level the nominal exciter reaches within its travel and voltage, m/s2 r.m.s.
fn highest_level_ms2(nominal: &Nominal, setting: &Setting) -> f64 {
    let omega = std::f64::consts::TAU * setting.frequency_hz;
    let coil = nominal.exciter.model(setting.payload_kg);
    let [_, travel_m_per_v] = coil.linear_response(omega, 0.0);
    let travel_m = TRAVEL_M.min(COIL_V * travel_m_per_v.norm());
    travel_m * omega * omega / std::f64::consts::SQRT_2
}
