//! Ceilings that no setting passes: the ends of the class of exciters this instrument is for.

use super::Limits;

impl Limits {
    /// Ceilings of the limits, whoever sets them. A calibrator that needs more is another one.
    ///
    /// | | | reason |
    /// |---|---|---|
    /// | drive | 42 V peak | below the 42.4 V peak that may be touched (IEC 61010-1, 6.3.1) |
    /// | acceleration | 1 415 m/s2 peak | 1 000 m/s2 r.m.s. ends the dynamic range of ISO 16063-21 (clause 3.2) |
    /// | velocity | 1.5 m/s peak | 1 m/s r.m.s., the most that is typical of the class (clause 3.2) |
    /// | displacement | 12.7 mm peak | stroke of one inch; 5 mm is typical (clause 3.2) |
    pub const CEILINGS: Self = Self {
        drive_peak_v: 42.0,
        acceleration_peak_ms2: 1415.0,
        velocity_peak_ms: 1.5,
        displacement_peak_m: 0.0127,
    };

    /// These limits, none above [`Self::CEILINGS`]: settings that a release without them stored are held
    /// by them as well.
    pub fn under_ceilings(&self) -> Self {
        let ceilings = &Self::CEILINGS;
        // Of a number and none, `min` takes the number.
        Self {
            drive_peak_v: ceilings.drive_peak_v.min(self.drive_peak_v),
            acceleration_peak_ms2: ceilings
                .acceleration_peak_ms2
                .min(self.acceleration_peak_ms2),
            velocity_peak_ms: ceilings.velocity_peak_ms.min(self.velocity_peak_ms),
            displacement_peak_m: ceilings.displacement_peak_m.min(self.displacement_peak_m),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::settings::Settings;

    #[test]
    fn nothing_passes_the_ceilings_and_what_lies_below_stays() {
        let field = Settings::field_calibrator().limits;
        assert_eq!(field.under_ceilings(), field);
        for absurd in [1.0e30, f32::INFINITY, f32::NAN] {
            let limits = Limits {
                drive_peak_v: absurd,
                acceleration_peak_ms2: absurd,
                velocity_peak_ms: absurd,
                displacement_peak_m: absurd,
            };
            assert_eq!(limits.under_ceilings(), Limits::CEILINGS, "{absurd}");
        }
    }
}
