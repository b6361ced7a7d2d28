//! Advice on the data (8.3) and on the propagation used (7.2.2).

use super::identification::Identification;
use super::points::Points;
use crate::text::significant;

/// Rise over S0 the data should reach (8.3 b).
const WANTED_RISE: f64 = 1.10;
/// Resonance below which a transducer is no accelerometer for vibration, Hz: large seismic ones of 10 V/g begin at
/// some hundred.
const LOWEST_RESONANCE_HZ: f64 = 100.0;

/// Advice to the metrologist before the parameters are used.
pub(super) fn advise(points: &Points, result: &Identification) -> Vec<String> {
    let mut advice = points.remarks.clone();
    let oscillator = &result.oscillator;
    let highest = points
        .points
        .iter()
        .map(|point| oscillator.response(point.frequency_hz).norm() / oscillator.s0)
        .fold(0.0, f64::max);
    if highest < WANTED_RISE {
        advice.push(format!(
            "the range is too low for the resonance: the sensitivity rises by {} % over S0, \
             less than the 10 % of 8.3 b; f0 and delta are poorly determined",
            significant(100.0 * (highest - 1.0), 2)
        ));
    }
    if oscillator.f0_hz < LOWEST_RESONANCE_HZ {
        advice.push(format!(
            "a resonance of {} Hz is that of a seismometer: is the frequency in Hz, not kHz?",
            significant(oscillator.f0_hz, 3)
        ));
    }
    advice.extend(near_resonance(points, result));
    if oscillator.delta < 0.0 {
        advice.push(
            "delta is negative: the phase has the opposite sign; an output that lags has a \
             negative phase"
                .into(),
        );
    }
    if points.has_uncertainties && too_large_for_first_order(points) {
        advice.push(
            "expanded uncertainties exceed 1 % or 2 degrees: first-order propagation is outside \
             7.2.2; use the Monte Carlo uncertainties"
                .into(),
        );
    }
    advice
}

/// Points in the immediate neighbourhood of the resonance, which 8.3 b wants
/// excluded: within its half-power bandwidth, but at least 5 %.
fn near_resonance(points: &Points, result: &Identification) -> Option<String> {
    let width = result.oscillator.delta.abs().max(0.05);
    let near: Vec<String> = points
        .points
        .iter()
        .map(|point| point.frequency_hz)
        .filter(|f| (f / result.oscillator.f0_hz - 1.0).abs() <= width)
        .map(|f| significant(f, 5))
        .collect();
    (!near.is_empty()).then(|| {
        format!(
            "points next to the resonance ({} Hz): leave them out (8.3 b), their uncertainty is \
             usually underrated",
            near.join(", ")
        )
    })
}

fn too_large_for_first_order(points: &Points) -> bool {
    points.points.iter().any(|point| {
        2.0 * point.u_magnitude / point.magnitude >= 0.01
            || 2.0 * point.u_phase_rad.to_degrees() >= 2.0
    })
}
