//! Verdicts in words, for tables, JSON and messages.

use calib_core::verdict::{Reason, Verdict};

/// A verdict for tables and JSON: `pass`, or `refused: ...`.
pub fn verdict(verdict: Verdict) -> String {
    match verdict {
        Verdict::Pass => "pass".to_owned(),
        Verdict::Refused(reason) => format!("refused: {}", self::reason(reason)),
    }
}

/// A refusal in words.
pub fn reason(reason: Reason) -> &'static str {
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
        Reason::BudgetInvalid => "the uncertainty budget makes no sense here",
        Reason::TooFewAverages => "too few spectra were averaged",
        Reason::LowCoherence => "the coherence is below 0.98",
        Reason::LevelNotFollowing => {
            "the level does not follow the drive: reference, cable or amplifier"
        }
        Reason::DutDistortion => "the device under test distorts",
        Reason::TemperatureOutOfRange => "the instrument is too cold or too hot",
        _ => "for a reason this tool does not know",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_reason_has_words() {
        // Reasons are numbered without gaps, so the bytes 0, 1, 2 ... are all.
        let reasons: Vec<Reason> = (0..=u8::MAX)
            .map_while(|number| postcard::from_bytes(&[number]).ok())
            .collect();
        assert!(reasons.len() >= 16);
        for known in reasons {
            assert!(!reason(known).contains("does not know"), "{known:?}");
        }
    }
}
