//! Point lists of broadband runs: lines of the record, at one level.

use calib_core::broadband::{line_frequency_hz, nearest_line};
use calib_core::point::PointSpec;
use calib_files::{Error, Result};

/// Points moved to the lines of the record nearest to them, each line once, in
/// the order of the list.
///
/// The level is the total r.m.s. acceleration of the band (5.1), so all points
/// must state the same one.
///
/// # Errors
/// [`Error::Input`] when they do not.
pub fn on_lines(points: &[PointSpec], sample_rate_hz: f32) -> Result<Vec<PointSpec>> {
    let level = points.first().map(|point| point.acceleration_rms_ms2);
    let other = points
        .iter()
        .find(|point| Some(point.acceleration_rms_ms2) != level);
    if let Some(other) = other {
        return Err(Error::input(
            "point list",
            format!(
                "has another level at {} Hz than at its first point",
                other.frequency_hz
            ),
            "a broadband run has one level, the total r.m.s. of the band",
        ));
    }
    let mut moved: Vec<PointSpec> = Vec::new();
    for point in points {
        let line = nearest_line(point.frequency_hz, sample_rate_hz);
        let frequency_hz = line_frequency_hz(line, sample_rate_hz);
        if !moved.iter().any(|known| known.frequency_hz == frequency_hz) {
            moved.push(PointSpec {
                frequency_hz,
                ..*point
            });
        }
    }
    Ok(moved)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point(frequency_hz: f32, acceleration_rms_ms2: f32) -> PointSpec {
        PointSpec {
            frequency_hz,
            acceleration_rms_ms2,
        }
    }

    #[test]
    fn points_move_to_the_nearest_line_and_double_ones_go() {
        // Lines every 50 000 / 4096 = 12.207 Hz: 20 and 25 Hz share line 2.
        let moved = on_lines(&[160.0, 20.0, 25.0].map(|f| point(f, 10.0)), 50_000.0);
        let frequencies: Vec<f32> = moved
            .expect("one level")
            .iter()
            .map(|point| point.frequency_hz)
            .collect();
        let spacing_hz = 50_000.0 / 4096.0;
        assert_eq!(frequencies, [13.0 * spacing_hz, 2.0 * spacing_hz]);
    }

    #[test]
    fn two_levels_are_refused() {
        let error = on_lines(&[point(160.0, 10.0), point(80.0, 5.0)], 50_000.0);
        let message = error.expect_err("two levels").to_string();
        assert!(message.contains("80 Hz"), "{message}");
    }
}
