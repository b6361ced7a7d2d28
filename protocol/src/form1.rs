//! Records and settings of version 1, before there were sections: read for ever, written no more.
//!
//! All fields stand one behind the other, postcard, without a length of their own. Nothing can be added
//! to this form and nothing in it changes: where a type that is read whole gets another field, its fields of
//! today are listed here.
//!
//! | part | fields in their order |
//! |---|---|
//! | head | [`head`] |
//! | settings | [`settings`] |
//! | calibration | incident, complete, list of [`point`] |
//! | change of the reference | the channel before: identity, table, scale of the input |

use crate::calibration::Record;
use crate::error::RecordError;
use crate::head::{RecordHead, RunLabels};
use crate::kind::RecordKind;
use crate::sections::Fields;
use crate::settings_form::{read_identity, read_rows};
use crate::stored_point::{LEVEL_PARTS, Round, Temperature, from_upper};
use calib_core::channel_ratio::ChannelRatio;
use calib_core::point::{PointResult, PointSpec};
use calib_core::point_state::{PointState, Reason};
use calib_core::settings::{Distribution, PointInfluences, ReferenceChannel, Settings};
use calib_core::tone::Tone;
use core::ops::Range;
use serde::Deserialize;

/// Reads the head of a record.
pub(crate) fn head(fields: &mut Fields<'_>) -> Result<RecordHead, RecordError> {
    Ok(RecordHead {
        id: fields.take()?,
        previous_sha256: fields.take()?,
        instrument_serial: fields.take()?,
        firmware: fields.take()?,
        sample_rate_hz: fields.take()?,
        labels: RunLabels {
            unix_time_s: fields.take()?,
            dut_model: fields.take()?,
            dut_serial: fields.take()?,
            operator: fields.take()?,
            temperature_centi_c: fields.take()?,
            mounting: fields.take()?,
        },
    })
}

/// Reads settings that stand alone.
///
/// # Errors
/// [`RecordError::Content`]; what was read until then is in `settings`.
pub fn read_settings(bytes: &[u8], settings: &mut Settings) -> Result<(), RecordError> {
    self::settings(&mut Fields(bytes), settings)
}

/// Reads settings.
fn settings(fields: &mut Fields<'_>, settings: &mut Settings) -> Result<(), RecordError> {
    settings.method = fields.take()?;
    settings.example = fields.take()?;
    read_identity(fields, &mut settings.reference)?;
    read_rows(fields, &mut settings.reference.points)?;
    settings.reference_input = fields.take()?;
    settings.dut_input = fields.take()?;
    settings.drive_full_scale_peak_v = fields.take()?;
    settings.limits = fields.take()?;
    settings.blocks = fields.take()?;
    settings.point_influences = PointInfluences::NONE;
    settings.channel_ratio = ChannelRatio::UNKNOWN;
    settings.lease_s = 0;
    read_rows(fields, &mut settings.influences)?;
    for influence in &mut settings.influences {
        // The number of a special distribution was the factor, its reciprocal.
        if let Distribution::Special { divisor } = &mut influence.distribution {
            *divisor = 1.0 / *divisor;
        }
    }
    Ok(())
}

/// Reads what was in force of the reference's channel before a change.
fn channel(fields: &mut Fields<'_>, channel: &mut ReferenceChannel) -> Result<(), RecordError> {
    read_identity(fields, &mut channel.calibration)?;
    read_rows(fields, &mut channel.calibration.points)?;
    channel.input = fields.take()?;
    channel.ratio = ChannelRatio::UNKNOWN;
    Ok(())
}

/// Reads the whole of a calibration.
pub(crate) fn record(content: &[u8], record: &mut Record) -> Result<(), RecordError> {
    let mut fields = Fields(content);
    record.head = head(&mut fields)?;
    settings(&mut fields, &mut record.settings)?;
    record.incident = fields.take()?;
    record.complete = fields.take()?;
    let count: usize = fields.take()?;
    record.points.clear();
    for _ in 0..count {
        let pushed = record.points.push(point(&mut fields)?);
        pushed.map_err(|_| RecordError::Content)?;
    }
    ended(fields)
}

/// Reads settings and channel of the log of a change.
pub(crate) fn change(
    content: &[u8],
    after: &mut Settings,
    before: &mut ReferenceChannel,
) -> Result<(), RecordError> {
    let mut fields = Fields(content);
    head(&mut fields)?;
    settings(&mut fields, after)?;
    channel(&mut fields, before)?;
    ended(fields)
}

/// Where the settings lie in the content of a record; points, and of them refused.
pub(crate) fn survey(
    kind: RecordKind,
    content: &[u8],
) -> Result<(Range<usize>, (u16, u16)), RecordError> {
    let mut fields = Fields(content);
    head(&mut fields)?;
    let start = content.len() - fields.0.len();
    let mut skipped = Settings::BLANK;
    settings(&mut fields, &mut skipped)?;
    let range = start..content.len() - fields.0.len();
    let counted = match kind {
        RecordKind::Calibration => count(&mut fields)?,
        RecordKind::ReferenceChange => {
            channel(&mut fields, &mut skipped.reference_channel())?;
            (0, 0)
        }
    };
    ended(fields).map(|()| (range, counted))
}

/// Points and refused points of what follows the settings.
fn count(fields: &mut Fields<'_>) -> Result<(u16, u16), RecordError> {
    let _: (Option<&str>, bool) = fields.take()?;
    let points: u16 = fields.take()?;
    let mut refused = 0;
    for _ in 0..points {
        refused += u16::from(point(fields)?.state != PointState::Valid);
    }
    Ok((points, refused))
}

/// Nothing may follow.
fn ended(fields: Fields<'_>) -> Result<(), RecordError> {
    match fields.0 {
        [] => Ok(()),
        _ => Err(RecordError::Content),
    }
}

/// A point.
#[derive(Deserialize)]
struct StoredPoint {
    frequency: Round,
    level: Round,
    cycles: u16,
    period_samples: u16,
    state: PointState,
    /// Bit 0: inverted. Bit 1: the coverage factor is 2. Bit 2: a broadband
    /// point, which has no distortion; in its place is one less the coherence.
    flags: u8,
    coverage_factor: Option<[u8; 3]>,
    /// Millionths of the set level above it.
    acceleration: i32,
    sensitivity: [u8; 4],
    phase: [u8; 4],
    uncertainty: [u8; 3],
    uncertainty_phase: [u8; 3],
    blocks: u16,
    diagnostics: [[u8; 2]; 11],
    /// Hundredths of a degree Celsius; [`i16::MIN`] where none was read.
    temperature: [u8; 2],
}

/// Reads a point.
fn point(fields: &mut Fields<'_>) -> Result<PointResult, RecordError> {
    Ok(fields.take::<StoredPoint>()?.into())
}

impl From<StoredPoint> for PointResult {
    fn from(stored: StoredPoint) -> Self {
        let level: f32 = stored.level.into();
        let reached = f64::from(level) * (1.0 + f64::from(stored.acceleration) / LEVEL_PARTS);
        let [
            repeatability_rel,
            repeatability_phase_rad,
            effective_degrees_of_freedom,
            distortion_reference_rel,
            distortion_or_incoherence,
            signal_to_noise_reference_db,
            signal_to_noise_dut_db,
            amplitude_stability_rel,
            drive_peak_v,
            settling_s,
            overshoot_rel,
        ] = stored.diagnostics.map(from_upper);
        let (distortion_dut_rel, coherence) = match stored.flags & 4 {
            0 => (distortion_or_incoherence, None),
            _ => (0.0, Some(1.0 - distortion_or_incoherence)),
        };
        let spec = PointSpec {
            frequency_hz: stored.frequency.into(),
            acceleration_rms_ms2: level,
        };
        let tone = Tone {
            cycles: stored.cycles,
            period_samples: stored.period_samples,
        };
        let temperature = Temperature(i16::from_le_bytes(stored.temperature));
        Self {
            state: stored.state,
            acceleration_rms_ms2: reached as f32,
            sensitivity_v_per_ms2: f32::from_le_bytes(stored.sensitivity),
            phase_rad: f32::from_le_bytes(stored.phase),
            inverted: stored.flags & 1 != 0,
            repeatability_rel,
            repeatability_phase_rad,
            blocks: stored.blocks,
            expanded_uncertainty_rel: from_upper(stored.uncertainty),
            coverage_factor: stored.coverage_factor.map_or(2.0, from_upper),
            effective_degrees_of_freedom,
            expanded_uncertainty_phase_rad: from_upper(stored.uncertainty_phase),
            distortion_reference_rel,
            distortion_dut_rel,
            signal_to_noise_reference_db,
            signal_to_noise_dut_db,
            amplitude_stability_rel,
            drive_peak_v,
            settling_s,
            overshoot_rel,
            coherence,
            instrument_temperature_c: temperature.into(),
            // What was not measured then.
            ..Self::refused(spec, Some(tone), Reason::Stopped)
        }
    }
}
