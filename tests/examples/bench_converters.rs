//! Errors of the sensitivity by those of the part's converters: `./run bench converters [UNITS]`.
//!
//! The core on the plant, without a board between; the reference is known exactly, and nothing else is
//! wrong, so that the whole deviation is the converters'.

use calib_core::point_state::PointState;
use calib_core::points::default_points;
use calib_core::settings::Settings;
use calib_tests::boardless::{Acquisition, measure_by};
use calib_tests::judge::deviation;
use calib_tests::rigged::{Fault, point, true_certificate};
use calib_twin::converters::{SHEET, Shape};
use calib_twin::rig::Rig;
use calib_twin::rig_port::Conversions;

/// One conversion of 64.5 cycles at 30 MHz: nothing done about it.
const PLAIN: Acquisition = Acquisition {
    conversions: Conversions {
        count: 1,
        apart_ps: 2_433_334,
        sampling_ns: 2_150,
    },
    dither_hz: 0.0,
    drive_buffer: false,
};
/// Eight conversions, and no dither.
const EIGHT: Acquisition = Acquisition {
    dither_hz: 0.0,
    ..Acquisition::SHIPPING
};
const DITHERED: Acquisition = Acquisition::SHIPPING;
const LEVELS_MS2: [f32; 2] = [10.0, 1.0];

/// A row of the table: a name, the converters' errors and shape, how they are set.
type Row = (&'static str, f64, Shape, Acquisition);

const ROWS: [Row; 12] = [
    ("ideal, one conversion", 0.0, Shape::Bits, PLAIN),
    ("one conversion", 1.0, Shape::Bits, PLAIN),
    ("8 conversions", 1.0, Shape::Bits, EIGHT),
    (
        "the same, steps of sixteenths",
        1.0,
        Shape::Sixteenths,
        EIGHT,
    ),
    ("the same, wall", 1.0, Shape::Wall, EIGHT),
    ("8 conversions, dither", 1.0, Shape::Bits, DITHERED),
    (
        "the same, steps and bow halved",
        1.0,
        Shape::BitsHalved,
        DITHERED,
    ),
    (
        "the same, steps and bow doubled",
        1.0,
        Shape::BitsDoubled,
        DITHERED,
    ),
    (
        "the same, steps of sixteenths",
        1.0,
        Shape::Sixteenths,
        DITHERED,
    ),
    ("the same, wall", 1.0, Shape::Wall, DITHERED),
    (
        "the same, what is assumed halved",
        0.5,
        Shape::Bits,
        DITHERED,
    ),
    (
        "the same, what is assumed doubled",
        2.0,
        Shape::Bits,
        DITHERED,
    ),
];

/// Worst deviations of some points.
#[derive(Default)]
struct Worst {
    magnitude_percent: f64,
    phase_deg: f64,
    /// Largest share of its own U that a deviation takes.
    of_u: f64,
    refused: usize,
    points: usize,
}

fn main() -> Result<(), Fault> {
    let units = std::env::args()
        .nth(1)
        .and_then(|text| text.parse().ok())
        .unwrap_or(4);
    for entry in SHEET {
        println!(
            "{:<75} {:>8} {:<6} {:?}",
            entry.what, entry.value, entry.unit, entry.basis
        );
    }
    println!(
        "\n{:<34} {:>6} {:>9} {:>9} {:>8} {:>8}",
        "converters", "m/s2", "S, %", "phase", "of U", "refused"
    );
    let mut rows = Vec::new();
    for (name, errors, shape, acquisition) in ROWS {
        for level_ms2 in LEVELS_MS2 {
            let worst = measure((errors, shape), acquisition, level_ms2, units);
            println!(
                "{name:<34} {level_ms2:>6} {:>9.4} {:>9.4} {:>8.2} {:>5}/{}",
                worst.magnitude_percent, worst.phase_deg, worst.of_u, worst.refused, worst.points
            );
            rows.push(serde_json::json!({
                "converters": name,
                "errors": errors,
                "shape": shape,
                "dither_hz": acquisition.dither_hz,
                "level_ms2": level_ms2,
                "worst_magnitude_percent": worst.magnitude_percent,
                "worst_phase_deg": worst.phase_deg,
                "worst_over_u": worst.of_u,
                "refused": worst.refused,
                "points": worst.points,
            }));
        }
    }
    if let Some(path) = std::env::var_os("CALIB_BENCH_JSON") {
        std::fs::write(path, serde_json::to_string_pretty(&rows)?)?;
    }
    Ok(())
}

/// The default list at one level by so many units.
fn measure(
    (errors, shape): (f64, Shape),
    acquisition: Acquisition,
    level_ms2: f32,
    units: u64,
) -> Worst {
    let mut worst = Worst::default();
    for unit in 0..units {
        let mut rig = Rig::standard();
        rig.converter.unit = unit;
        rig.noise_seed = unit;
        (rig.converter.errors, rig.converter.shape) = (errors, shape);
        let mut settings = settings(&rig);
        if acquisition.dither_hz == 0.0 {
            settings.point_influences.dither_peak_v = 0.0;
        }
        let points = default_points();
        let list: Vec<_> = points
            .iter()
            .filter(|spec| spec.frequency_hz >= 20.0)
            .map(|spec| point(spec.frequency_hz, level_ms2))
            .collect();
        for result in measure_by(acquisition, &rig, &settings, &list) {
            worst.points += 1;
            if result.state != PointState::Valid {
                worst.refused += 1;
                eprintln!(
                    "unit {unit}, {} Hz: {}",
                    result.spec.frequency_hz, result.state
                );
                continue;
            }
            let off = deviation(&result, &rig, 50_000.0);
            let magnitude_rel = off.magnitude_rel.abs();
            worst.magnitude_percent = worst.magnitude_percent.max(100.0 * magnitude_rel);
            worst.phase_deg = worst.phase_deg.max(off.phase_rad.to_degrees().abs());
            let of_u = magnitude_rel / f64::from(result.expanded_uncertainty_rel);
            worst.of_u = worst.of_u.max(of_u);
        }
    }
    worst
}

/// A field calibrator that knows its reference exactly.
fn settings(rig: &Rig) -> Settings {
    let mut settings = Settings::field_calibrator();
    settings.reference.points = true_certificate(rig)
        .iter()
        .map(|line| calib_core::settings::ReferencePoint {
            frequency_hz: line.frequency_hz as f32,
            sensitivity_v_per_ms2: line.sensitivity_v_per_ms2 as f32,
            phase_rad: line.phase_rad as f32,
            expanded_uncertainty_rel: line.expanded_uncertainty_rel as f32,
            expanded_uncertainty_phase_rad: line.expanded_uncertainty_phase_rad as f32,
        })
        .collect();
    settings
}
