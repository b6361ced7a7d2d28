//! Results in words and lines.

use calib_core::point::PointResult;
use calib_core::verdict::{Reason, Verdict};

/// One line about a measured point.
pub(crate) fn point_line(point: &PointResult) -> String {
    let frequency_hz = point.spec.frequency_hz;
    match point.verdict {
        Verdict::Pass => format!(
            "{frequency_hz:>7} Hz  {:.5e} V/(m/s2)  {:+8.3} deg  U = {:.2} %",
            point.sensitivity_v_per_ms2,
            f64::from(point.phase_rad).to_degrees(),
            100.0 * point.expanded_uncertainty_rel,
        ),
        Verdict::Refused(reason) => {
            format!("{frequency_hz:>7} Hz  refused: {}", reason_text(reason))
        }
    }
}

/// A verdict for tables and JSON: `pass`, or `refused: ...`.
pub(crate) fn verdict(verdict: Verdict) -> String {
    match verdict {
        Verdict::Pass => "pass".to_owned(),
        Verdict::Refused(reason) => format!("refused: {}", reason_text(reason)),
    }
}

/// A refusal in words.
pub(crate) fn reason_text(reason: Reason) -> &'static str {
    match reason {
        Reason::Clipped => "a channel is clipped",
        Reason::Distortion => "too much harmonic distortion",
        Reason::SignalToNoise => "too little signal over noise",
        Reason::AmplitudeUnstable => "the amplitude moved while measuring",
        Reason::FrequencyDeviation => "the frequency is off",
        Reason::NotSettled => "the level did not settle",
        Reason::DriveLimit => "the level needs more drive voltage than allowed",
        Reason::AccelerationLimit => "the level exceeds the acceleration limit",
        Reason::VelocityLimit => "the level exceeds the velocity limit",
        Reason::DisplacementLimit => "the level exceeds the displacement limit",
        Reason::ReferenceDead => "the reference gives no signal",
        Reason::DutOpen => "the device under test gives no signal",
        Reason::Overload => "the acceleration overshot dangerously",
        Reason::Overrun => "samples were lost",
        Reason::FrequencyUnavailable => "this frequency is not available",
        Reason::Stopped => "stopped",
        _ => "for a reason this tool does not know",
    }
}
