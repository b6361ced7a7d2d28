//! One row of `points.csv`, and the file.

use std::fmt::Write as _;

/// A harmonic over its fundamental.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Harmonic {
    /// Amplitude over that of the fundamental.
    pub amplitude: f64,
    /// Phase relative to n times the fundamental's, degrees.
    pub phase_deg: f64,
}

/// One measured point; amplitudes r.m.s., phases in degrees of `A cos(2 pi f t + phase)`.
///
/// Fields are named as the columns.
#[derive(Clone, Debug, Default, PartialEq)]
#[expect(
    missing_docs,
    reason = "columns are documented by the format, field by field"
)]
pub struct Point {
    pub run: usize,
    pub frequency_hz: f64,
    pub time_s: Option<f64>,
    pub temperature_c: Option<f64>,
    pub rotation_deg: Option<f64>,
    pub tilt_deg: Option<f64>,
    pub payload_kg: Option<f64>,
    pub acceleration_ms2: Option<f64>,
    pub coil_v: Option<f64>,
    pub coil_a: Option<f64>,
    pub coil_a_deg: Option<f64>,
    pub ref_v: Option<f64>,
    pub ref_deg: Option<f64>,
    pub dut_v: Option<f64>,
    pub dut_deg: Option<f64>,
    pub ratio: Option<f64>,
    /// Harmonics 2 to 5 of the reference.
    pub ref_harmonics: Option<[Harmonic; 4]>,
    /// Harmonics 2 to 5 of the device under test.
    pub dut_harmonics: Option<[Harmonic; 4]>,
    pub ref_dc_v: Option<f64>,
    pub dut_dc_v: Option<f64>,
    pub ref_noise_v: Option<f64>,
    pub dut_noise_v: Option<f64>,
    pub u_ratio: Option<f64>,
    pub u_phase_deg: Option<f64>,
    pub u_drive: Option<f64>,
    pub u_current: Option<f64>,
    pub u_harmonic: Option<f64>,
    pub u_dc_v: Option<f64>,
}

/// Which columns a dataset has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Columns {
    /// All.
    #[default]
    All,
    /// All but the coil current.
    NoCurrent,
    /// Frequency, conditions, ratio and its phase: what most laboratories keep.
    RatioOnly,
}

impl Columns {
    /// Leaves out what is not measured.
    pub(super) fn restrict(self, point: &mut Point) {
        match self {
            Self::All => {}
            Self::NoCurrent => {
                point.coil_a = None;
                point.coil_a_deg = None;
                point.u_current = None;
            }
            Self::RatioOnly => {
                let full = std::mem::take(point);
                let ratio = full
                    .dut_v
                    .zip(full.ref_v)
                    .map(|(dut, reference)| dut / reference);
                *point = Point {
                    run: full.run,
                    frequency_hz: full.frequency_hz,
                    time_s: full.time_s,
                    temperature_c: full.temperature_c,
                    rotation_deg: full.rotation_deg,
                    tilt_deg: full.tilt_deg,
                    payload_kg: full.payload_kg,
                    acceleration_ms2: full.acceleration_ms2,
                    ratio,
                    dut_deg: full.dut_deg,
                    u_ratio: full.u_ratio,
                    u_phase_deg: full.u_phase_deg,
                    ..Point::default()
                };
            }
        }
    }
}

impl Point {
    /// All cells with their column names.
    fn cells(&self) -> Vec<(String, Option<f64>)> {
        let mut cells: Vec<(String, Option<f64>)> = [
            ("frequency_hz", Some(self.frequency_hz)),
            ("time_s", self.time_s),
            ("temperature_c", self.temperature_c),
            ("rotation_deg", self.rotation_deg),
            ("tilt_deg", self.tilt_deg),
            ("payload_kg", self.payload_kg),
            ("acceleration_ms2", self.acceleration_ms2),
            ("coil_v", self.coil_v),
            ("coil_a", self.coil_a),
            ("coil_a_deg", self.coil_a_deg),
            ("ref_v", self.ref_v),
            ("ref_deg", self.ref_deg),
            ("dut_v", self.dut_v),
            ("dut_deg", self.dut_deg),
            ("ratio", self.ratio),
            ("ref_dc_v", self.ref_dc_v),
            ("dut_dc_v", self.dut_dc_v),
            ("ref_noise_v", self.ref_noise_v),
            ("dut_noise_v", self.dut_noise_v),
            ("u_ratio", self.u_ratio),
            ("u_phase_deg", self.u_phase_deg),
            ("u_drive", self.u_drive),
            ("u_current", self.u_current),
            ("u_harmonic", self.u_harmonic),
            ("u_dc_v", self.u_dc_v),
        ]
        .map(|(name, value)| (name.to_owned(), value))
        .into();
        for (channel, harmonics) in [("ref", self.ref_harmonics), ("dut", self.dut_harmonics)] {
            for index in 0..4 {
                let harmonic = harmonics.map(|all| all[index]);
                let name = format!("{channel}_h{}", index + 2);
                cells.push((format!("{name}_deg"), harmonic.map(|value| value.phase_deg)));
                cells.push((name, harmonic.map(|value| value.amplitude)));
            }
        }
        cells
    }
}

/// The text of `points.csv`: columns that hold no value at all are left out.
pub fn points_csv(points: &[Point]) -> String {
    let rows: Vec<_> = points.iter().map(Point::cells).collect();
    let Some(first) = rows.first() else {
        return String::from("frequency_hz,run\n");
    };
    let used: Vec<usize> = (0..first.len())
        .filter(|&column| rows.iter().any(|row| row[column].1.is_some()))
        .collect();
    let mut text = String::from("run");
    for &column in &used {
        text.push(',');
        text.push_str(&first[column].0);
    }
    text.push('\n');
    for (point, row) in points.iter().zip(&rows) {
        text.push_str(&point.run.to_string());
        for &column in &used {
            text.push(',');
            if let Some(value) = row[column].1 {
                // Writing to a string cannot fail.
                let _ = write!(text, "{value}");
            }
        }
        text.push('\n');
    }
    text
}
