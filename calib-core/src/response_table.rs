//! A complex response by a table of frequencies: interpolation, and what it may be off.

/// A frequency this close to a row of the table is that row (a tone is at most
/// 0.01 % off).
const SAME_FREQUENCY_REL: f32 = 5.0e-4;

/// A row of a table in rising frequency.
pub(crate) trait Row {
    /// Frequency, Hz.
    fn frequency_hz(&self) -> f32;
    /// Response there, without any interpolation.
    fn response(&self) -> Response;
}

/// A response at one frequency.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Response {
    /// Magnitude, in the unit of the table.
    pub(crate) magnitude: f32,
    /// Phase, rad.
    pub(crate) phase_rad: f32,
    /// Relative expanded uncertainty (k = 2) of the magnitude: that of the row, or the larger of the
    /// two neighbours.
    pub(crate) expanded_uncertainty_rel: f32,
    /// Expanded uncertainty (k = 2) of the phase, rad, likewise.
    pub(crate) expanded_uncertainty_phase_rad: f32,
    /// Half-width of the error by interpolation, relative; 0 at a row.
    pub(crate) interpolation_rel: f32,
    /// Half-width of the error by interpolation of the phase, rad.
    pub(crate) interpolation_phase_rad: f32,
}

/// The response at `frequency_hz`; none outside the table.
///
/// Between rows, magnitude and phase are linear in the logarithm of the
/// frequency, the phase the short way round. The error of that is at most `t (1 - t) / 2` times the
/// second difference at the place `t` between two rows; it is taken from
/// the neighbouring rows (the larger of both sides) and stated as the
/// half-width of a rectangular distribution. A table of two rows says
/// nothing of its curvature: there the second difference is taken as
/// large as the first.
pub(crate) fn at<R: Row>(rows: &[R], frequency_hz: f32) -> Option<Response> {
    let same = |row: &&R| (row.frequency_hz() / frequency_hz - 1.0).abs() <= SAME_FREQUENCY_REL;
    if let Some(row) = rows.iter().find(same) {
        return Some(row.response());
    }
    let above = rows
        .iter()
        .position(|row| row.frequency_hz() > frequency_hz)?;
    between(rows, above.checked_sub(1)?, frequency_hz)
}

fn between<R: Row>(rows: &[R], below: usize, frequency_hz: f32) -> Option<Response> {
    let (low_row, high_row) = (rows.get(below)?, rows.get(below + 1)?);
    let (low, high) = (low_row.response(), high_row.response());
    let place = libm::logf(frequency_hz / low_row.frequency_hz())
        / libm::logf(high_row.frequency_hz() / low_row.frequency_hz());
    let magnitude = low.magnitude + (high.magnitude - low.magnitude) * place;
    let phase_rad = low.phase_rad + angle_between(low.phase_rad, high.phase_rad) * place;
    let bow = 0.5 * place * (1.0 - place);
    Some(Response {
        magnitude,
        phase_rad,
        expanded_uncertainty_rel: low
            .expanded_uncertainty_rel
            .max(high.expanded_uncertainty_rel),
        expanded_uncertainty_phase_rad: low
            .expanded_uncertainty_phase_rad
            .max(high.expanded_uncertainty_phase_rad),
        interpolation_rel: bow * curvature(rows, below, |a, b| b.magnitude - a.magnitude)
            / magnitude.abs(),
        interpolation_phase_rad: bow
            * curvature(rows, below, |a, b| angle_between(a.phase_rad, b.phase_rad)),
    })
}

/// From one angle to another the short way round, rad: rows at +179 and -179 degrees are 2 degrees apart.
fn angle_between(from_rad: f32, to_rad: f32) -> f32 {
    libm::remainderf(to_rad - from_rad, core::f32::consts::TAU)
}

/// Largest second difference beside the interval that begins at `below`,
/// per interval squared.
fn curvature<R: Row>(rows: &[R], below: usize, step: fn(Response, Response) -> f32) -> f32 {
    let step = |from: &R, to: &R| step(from.response(), to.response());
    let triple = |first: usize| {
        let [a, b, c] = rows.get(first..first + 3)? else {
            return None;
        };
        let log = |row: &R| libm::logf(row.frequency_hz());
        let (left, right) = (log(b) - log(a), log(c) - log(b));
        let slopes = step(b, c) / right - step(a, b) / left;
        let interval = if first == below { left } else { right };
        Some((2.0 * slopes / (left + right) * interval * interval).abs())
    };
    let beside = [below.checked_sub(1).and_then(triple), triple(below)];
    let largest = beside.into_iter().flatten().reduce(f32::max);
    let difference = || match rows.get(below..below + 2) {
        Some([a, b]) => step(a, b).abs(),
        _ => 0.0,
    };
    largest.unwrap_or_else(difference)
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::f32::consts::PI;

    struct Line(f32, f32);

    impl Row for Line {
        fn frequency_hz(&self) -> f32 {
            self.0
        }

        fn response(&self) -> Response {
            Response {
                magnitude: 1.0,
                phase_rad: self.1,
                expanded_uncertainty_rel: 0.0,
                expanded_uncertainty_phase_rad: 0.0,
                interpolation_rel: 0.0,
                interpolation_phase_rad: 0.0,
            }
        }
    }

    /// A reference wired the other way round: +179, -180, -179 degrees at 100, 200, 400 Hz fall on a line.
    #[test]
    fn a_phase_goes_the_short_way_round() {
        let degree = PI / 180.0;
        let rows = [
            Line(100.0, 179.0 * degree),
            Line(200.0, -180.0 * degree),
            Line(400.0, -179.0 * degree),
        ];
        let found = at(&rows, 200.0 * core::f32::consts::SQRT_2).expect("inside");
        let off = angle_between(-179.5 * degree, found.phase_rad);
        // A phase near pi is a multiple of 2.4e-7 rad.
        assert!(off.abs() < 1.0e-6, "{off}");
        assert!(found.interpolation_phase_rad < 1.0e-5);
    }
}
