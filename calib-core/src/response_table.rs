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
/// frequency. The error of that is at most `t (1 - t) / 2` times the
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
    let mix = |a: f32, b: f32| a + (b - a) * place;
    let magnitude = mix(low.magnitude, high.magnitude);
    let bow = 0.5 * place * (1.0 - place);
    Some(Response {
        magnitude,
        phase_rad: mix(low.phase_rad, high.phase_rad),
        expanded_uncertainty_rel: low
            .expanded_uncertainty_rel
            .max(high.expanded_uncertainty_rel),
        expanded_uncertainty_phase_rad: low
            .expanded_uncertainty_phase_rad
            .max(high.expanded_uncertainty_phase_rad),
        interpolation_rel: bow * curvature(rows, below, |r| r.magnitude) / magnitude.abs(),
        interpolation_phase_rad: bow * curvature(rows, below, |r| r.phase_rad),
    })
}

/// Largest second difference beside the interval that begins at `below`,
/// per interval squared.
fn curvature<R: Row>(rows: &[R], below: usize, of: fn(Response) -> f32) -> f32 {
    let value = |row: &R| of(row.response());
    let triple = |first: usize| {
        let [a, b, c] = rows.get(first..first + 3)? else {
            return None;
        };
        let log = |row: &R| libm::logf(row.frequency_hz());
        let (left, right) = (log(b) - log(a), log(c) - log(b));
        let slopes = (value(c) - value(b)) / right - (value(b) - value(a)) / left;
        let interval = if first == below { left } else { right };
        Some((2.0 * slopes / (left + right) * interval * interval).abs())
    };
    let beside = [below.checked_sub(1).and_then(triple), triple(below)];
    let largest = beside.into_iter().flatten().reduce(f32::max);
    let difference = || match rows.get(below..below + 2) {
        Some([a, b]) => (value(b) - value(a)).abs(),
        _ => 0.0,
    };
    largest.unwrap_or_else(difference)
}
