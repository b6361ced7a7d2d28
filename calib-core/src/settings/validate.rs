//! Settings that make no sense are refused before anything is driven.

use super::{Distribution, Limits, Settings};
use core::fmt;

/// The first thing that is wrong with a set of settings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum SettingsError {
    /// The reference table has no row.
    NoReference,
    /// Row of the reference table (from 0): a value is not finite, not positive
    /// where it must be, or an uncertainty is zero.
    ReferenceRow(u8),
    /// Row of the reference table (from 0) whose frequency does not rise.
    ReferenceOrder(u8),
    /// Scale of an input, full scale of the drive or a limit is not positive
    /// and finite; the name is that of the field.
    Positive(&'static str),
    /// The drive limit exceeds the full scale of the drive.
    DriveLimit,
    /// Full scale of the drive or a limit exceeds its ceiling ([`Limits::CEILINGS`]); the name is that of
    /// the field.
    Ceiling(&'static str),
    /// Fewer than two blocks have no scatter.
    Blocks,
    /// Influence (from 0): row outside 1..=18, value negative or not finite,
    /// or a divisor that is not positive.
    Influence(u8),
    /// A coefficient of an influence that differs from point to point is negative, not finite, or a transverse
    /// motion above 1; the name is that of the field.
    PointInfluence(&'static str),
    /// Row of the ratio of the channels (from 0): a value is not finite, its frequency does not rise, or
    /// it is no ratio of equal channels: 0.9 to 1.1 and 10 degrees either way.
    ChannelRatio(u8),
}

/// Ratios of channels that are built alike: what lies outside is a wrong lead or a wrong range.
const RATIO_RANGE: core::ops::RangeInclusive<f32> = 0.9..=1.1;
/// Largest phase of such a ratio, either way, rad: 10 degrees.
const RATIO_PHASE_RAD: f32 = 0.174_533;

impl fmt::Display for SettingsError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let nth = |index: u8| u16::from(index) + 1;
        match *self {
            Self::NoReference => f.write_str("the reference table is empty"),
            Self::ReferenceRow(i) => write!(
                f,
                "reference table, row {}: values must be finite, frequency, sensitivity and \
                 uncertainties positive",
                nth(i)
            ),
            Self::ReferenceOrder(i) => write!(
                f,
                "reference table, row {}: frequencies must rise and occur once",
                nth(i)
            ),
            Self::Positive(name) => write!(f, "{name} must be positive and finite"),
            Self::DriveLimit => f.write_str("limits.drive_peak_v exceeds drive_full_scale_peak_v"),
            Self::Ceiling(name) => write!(
                f,
                "{name} exceeds what no setting may: 42 V, 1415 m/s2, 1.5 m/s, 0.0127 m peak"
            ),
            Self::Blocks => f.write_str("blocks must be at least 2"),
            Self::Influence(i) => write!(
                f,
                "influence {}: row must be 1 to 18, values finite and not negative, divisors \
                 positive",
                nth(i)
            ),
            Self::PointInfluence(name) => write!(
                f,
                "point_influences.{name} must be finite and not negative, a transverse motion at \
                 most 1"
            ),
            Self::ChannelRatio(i) => write!(
                f,
                "channel_ratio, row {}: frequencies must rise, magnitudes lie from 0.9 to 1.1, \
                 phases within 0.17 rad, uncertainties be positive",
                nth(i)
            ),
        }
    }
}

impl core::error::Error for SettingsError {}

fn positive(value: f32) -> bool {
    value.is_finite() && value > 0.0
}

fn not_negative(value: f32) -> bool {
    value.is_finite() && value >= 0.0
}

impl Settings {
    /// Checks everything a measurement relies on.
    ///
    /// # Errors
    /// The first [`SettingsError`] in the order of the fields.
    pub fn validate(&self) -> Result<(), SettingsError> {
        self.validate_reference()?;
        self.validate_scales()?;
        if self.blocks < 2 {
            return Err(SettingsError::Blocks);
        }
        self.validate_influences()?;
        if let Some(name) = self.point_influences.impossible() {
            return Err(SettingsError::PointInfluence(name));
        }
        self.validate_channel_ratio()
    }

    fn validate_channel_ratio(&self) -> Result<(), SettingsError> {
        let mut last_hz = 0.0;
        for (row, index) in self.channel_ratio.points.iter().zip(0_u8..) {
            let valid = row.frequency_hz.is_finite()
                && row.frequency_hz > last_hz
                && RATIO_RANGE.contains(&row.magnitude)
                && row.phase_rad.abs() <= RATIO_PHASE_RAD
                && positive(row.expanded_uncertainty_rel)
                && positive(row.expanded_uncertainty_phase_rad);
            if !valid {
                return Err(SettingsError::ChannelRatio(index));
            }
            last_hz = row.frequency_hz;
        }
        Ok(())
    }

    fn validate_reference(&self) -> Result<(), SettingsError> {
        if self.reference.points.is_empty() {
            return Err(SettingsError::NoReference);
        }
        let mut last_hz = 0.0;
        for (row, index) in self.reference.points.iter().zip(0_u8..) {
            let valid = positive(row.frequency_hz)
                && positive(row.sensitivity_v_per_ms2)
                && row.phase_rad.is_finite()
                && positive(row.expanded_uncertainty_rel)
                && positive(row.expanded_uncertainty_phase_rad);
            if !valid {
                return Err(SettingsError::ReferenceRow(index));
            }
            if row.frequency_hz <= last_hz {
                return Err(SettingsError::ReferenceOrder(index));
            }
            last_hz = row.frequency_hz;
        }
        Ok(())
    }

    fn validate_scales(&self) -> Result<(), SettingsError> {
        let limits = &self.limits;
        let fields = [
            (
                self.reference_input.volt_per_code,
                "reference_input.volt_per_code",
            ),
            (self.dut_input.volt_per_code, "dut_input.volt_per_code"),
            (self.drive_full_scale_peak_v, "drive_full_scale_peak_v"),
            (limits.drive_peak_v, "limits.drive_peak_v"),
            (limits.acceleration_peak_ms2, "limits.acceleration_peak_ms2"),
            (limits.velocity_peak_ms, "limits.velocity_peak_ms"),
            (limits.displacement_peak_m, "limits.displacement_peak_m"),
        ];
        if let Some((_, name)) = fields.into_iter().find(|(value, _)| !positive(*value)) {
            return Err(SettingsError::Positive(name));
        }
        if limits.drive_peak_v > self.drive_full_scale_peak_v {
            return Err(SettingsError::DriveLimit);
        }
        self.validate_ceilings()
    }

    fn validate_ceilings(&self) -> Result<(), SettingsError> {
        let (limits, most) = (&self.limits, &Limits::CEILINGS);
        let fields = [
            (
                self.drive_full_scale_peak_v,
                most.drive_peak_v,
                "drive_full_scale_peak_v",
            ),
            (
                limits.acceleration_peak_ms2,
                most.acceleration_peak_ms2,
                "limits.acceleration_peak_ms2",
            ),
            (
                limits.velocity_peak_ms,
                most.velocity_peak_ms,
                "limits.velocity_peak_ms",
            ),
            (
                limits.displacement_peak_m,
                most.displacement_peak_m,
                "limits.displacement_peak_m",
            ),
        ];
        match fields.into_iter().find(|(value, most, _)| value > most) {
            Some((_, _, name)) => Err(SettingsError::Ceiling(name)),
            None => Ok(()),
        }
    }

    fn validate_influences(&self) -> Result<(), SettingsError> {
        for (influence, index) in self.influences.iter().zip(0_u8..) {
            let divisor = match influence.distribution {
                Distribution::Normal { coverage_factor } => positive(coverage_factor),
                Distribution::Special { divisor } => positive(divisor),
                _ => true,
            };
            let valid = (1..=18).contains(&influence.row)
                && not_negative(influence.value_rel)
                && not_negative(influence.value_phase_rad);
            if !(valid && divisor) {
                return Err(SettingsError::Influence(index));
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::channel_ratio::ChannelRatioPoint;

    #[test]
    fn what_waits_in_memory_is_no_setting() {
        assert!(Settings::BLANK.validate().is_err());
    }

    #[test]
    fn every_impossible_setting_is_named() {
        type Change = fn(&mut Settings);
        let wrong: [(Change, SettingsError); 15] = [
            (|s| s.reference.points.clear(), SettingsError::NoReference),
            (
                |s| s.reference.points[3].sensitivity_v_per_ms2 = f32::NAN,
                SettingsError::ReferenceRow(3),
            ),
            (
                |s| s.reference.points[0].expanded_uncertainty_rel = 0.0,
                SettingsError::ReferenceRow(0),
            ),
            (
                |s| s.reference.points[5].frequency_hz = 10.0,
                SettingsError::ReferenceOrder(5),
            ),
            (
                |s| s.dut_input.volt_per_code = 0.0,
                SettingsError::Positive("dut_input.volt_per_code"),
            ),
            (
                |s| s.limits.velocity_peak_ms = f32::INFINITY,
                SettingsError::Positive("limits.velocity_peak_ms"),
            ),
            (|s| s.limits.drive_peak_v = 11.0, SettingsError::DriveLimit),
            (
                |s| s.drive_full_scale_peak_v = 42.5,
                SettingsError::Ceiling("drive_full_scale_peak_v"),
            ),
            (
                |s| s.limits.acceleration_peak_ms2 = 1416.0,
                SettingsError::Ceiling("limits.acceleration_peak_ms2"),
            ),
            (
                |s| s.limits.velocity_peak_ms = 1.0e30,
                SettingsError::Ceiling("limits.velocity_peak_ms"),
            ),
            (
                |s| s.limits.displacement_peak_m = 0.013,
                SettingsError::Ceiling("limits.displacement_peak_m"),
            ),
            (|s| s.blocks = 1, SettingsError::Blocks),
            (
                |s| {
                    let row = ChannelRatioPoint {
                        frequency_hz: 160.0,
                        magnitude: 0.85,
                        phase_rad: 0.0,
                        expanded_uncertainty_rel: 1.0e-4,
                        expanded_uncertainty_phase_rad: 1.0e-4,
                    };
                    s.channel_ratio.points.extend([row]);
                },
                SettingsError::ChannelRatio(0),
            ),
            (|s| s.influences[2].row = 19, SettingsError::Influence(2)),
            (
                |s| {
                    s.influences[1].distribution = Distribution::Normal {
                        coverage_factor: 0.0,
                    };
                },
                SettingsError::Influence(1),
            ),
        ];
        for (change, expected) in wrong {
            let mut settings = Settings::field_calibrator();
            change(&mut settings);
            assert_eq!(settings.validate(), Err(expected));
            assert!(!expected.to_string().is_empty());
        }
    }
}
