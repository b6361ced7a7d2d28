//! Which settings a record was made with, and since when they are those.
//!
//! The SHA-256 of all settings as [`crate::settings_form`] writes them is compared: of those in force now, and
//! of those the last change of the reference's calibration left. Settings that were changed and changed back
//! are the same.

use crate::head::{Sha256Sum, digest};
use crate::settings_form::{InSections, LONGEST_SETTINGS};
use calib_core::settings::Settings;
use serde::{Deserialize, Serialize};

/// The log of a change.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct LoggedChange {
    /// Running number of its record; 0 = there was none.
    pub record_id: u32,
    /// Seconds since 1970-01-01 UTC by the clock of the host that asked for it; 0 = not known.
    pub unix_time_s: u64,
}

impl LoggedChange {
    /// There was none.
    pub const NONE: Self = Self {
        record_id: 0,
        unix_time_s: 0,
    };
}

/// Digest of the settings in force, and where they come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Provenance {
    /// [`settings_digest`] of the settings in force; zeros in what a release before it wrote.
    pub sha256: Sha256Sum,
    /// Last change of any setting.
    pub changed: LoggedChange,
    /// Last change of the calibration of the reference.
    pub reference_changed: LoggedChange,
    /// [`settings_digest`] of what that change left; zeros where there was none.
    pub sha256_at_reference: Sha256Sum,
}

impl Provenance {
    /// Nothing is known.
    pub const UNKNOWN: Self = Self {
        sha256: [0; 32],
        changed: LoggedChange::NONE,
        reference_changed: LoggedChange::NONE,
        sha256_at_reference: [0; 32],
    };

    /// Whether the settings are others than those the last change of the reference's calibration left.
    pub fn differs_from_reference(&self) -> bool {
        self.reference_changed != LoggedChange::NONE && self.sha256 != self.sha256_at_reference
    }
}

impl Default for Provenance {
    fn default() -> Self {
        Self::UNKNOWN
    }
}

/// SHA-256 of all settings, as the section of a record holds them.
pub fn settings_digest(settings: &Settings) -> Sha256Sum {
    let mut room = [0; LONGEST_SETTINGS];
    // The fullest settings find room.
    let written = postcard::to_slice(&InSections(settings), &mut room);
    written.map_or([0; 32], |bytes| digest(bytes))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::{self, Record};
    use calib_core::channel_ratio::ChannelRatioPoint;

    #[test]
    fn the_digest_is_the_sum_of_the_section_in_a_record() {
        let settings = Settings::field_calibrator();
        let record = Record {
            settings: settings.clone(),
            ..Record::BLANK
        };
        let mut bytes = vec![0; 4096];
        let length = record::encode(&record, &mut bytes).expect("fits");
        let (_, place) = record::inspect(&bytes[..length]).expect("a record");
        assert_eq!(settings_digest(&settings), digest(&bytes[place]));
    }

    #[test]
    fn the_fullest_settings_have_a_digest() {
        let mut settings = Settings::field_calibrator();
        let (point, influence) = (settings.reference.points[0], settings.influences[0]);
        while settings.reference.points.push(point).is_ok() {}
        while settings.influences.push(influence).is_ok() {}
        let row = ChannelRatioPoint {
            frequency_hz: 160.0,
            magnitude: 1.0,
            phase_rad: 0.0,
            expanded_uncertainty_rel: 1.0e-4,
            expanded_uncertainty_phase_rad: 1.0e-4,
        };
        while settings.channel_ratio.points.push(row).is_ok() {}
        assert_ne!(settings_digest(&settings), [0; 32]);
    }

    #[test]
    fn every_setting_counts() {
        type Change = fn(&mut Settings);
        let changes: [Change; 10] = [
            |s| s.dut_input.volt_per_code *= 0.85,
            |s| s.reference_input.volt_per_code *= 0.85,
            |s| s.influences[3].value_rel = 0.0,
            |s| s.point_influences.channel_delay_s = 0.0,
            |s| s.limits.velocity_peak_ms *= 1.01,
            |s| s.drive_full_scale_peak_v *= 1.01,
            |s| s.blocks += 1,
            |s| s.channel_ratio.measured_day = 3,
            |s| s.reference.due_day = 3,
            |s| s.lease_s = 30,
        ];
        let before = settings_digest(&Settings::field_calibrator());
        for (number, change) in changes.into_iter().enumerate() {
            let mut settings = Settings::field_calibrator();
            change(&mut settings);
            assert_ne!(settings_digest(&settings), before, "{number}");
        }
    }
}
