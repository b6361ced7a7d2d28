//! The calibrator, what it is doing, and what it keeps.

use crate::{code, unix_time_s};
use calib_core::self_test::OptionBytes;
use calib_core::settings::{ReferenceChannel, Settings};
use calib_protocol::change::ReferenceChange;
use calib_protocol::health::{Deadline, Defect, Health, Work};
use calib_protocol::message::{Info, Status};
use calib_protocol::record::{RecordKind, RecordSummary};
use calib_protocol::update::RunningImage;
use schemars::JsonSchema;
use serde::Serialize;

/// Identity and health of a calibrator.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct InfoView {
    /// Version of the protocol the firmware speaks.
    pub protocol_version: u16,
    /// Firmware version.
    pub firmware_version: String,
    /// Git hash of the firmware; `-dirty` when it was changed.
    pub git_hash: String,
    /// Serial number of the instrument.
    pub instrument_serial: String,
    /// Samples per second and channel, Hz.
    pub sample_rate_hz: f32,
    /// Why the board last started: `power_on`, `pin`, `software`, `watchdog`, `brown_out`, `other`.
    pub reset_cause: String,
    /// Message of the panic before the last start, if there was one.
    pub last_panic: Option<String>,
    /// Stored records.
    pub records: u32,
    /// Time since the start, s.
    pub uptime_s: f64,
    /// Bytes of the stack that were never used since the start.
    pub stack_unused_bytes: u32,
    /// Temperature of the instrument's processor, degrees Celsius; none when not read.
    pub instrument_temperature_c: Option<f32>,
    /// Defects; while there is one, no run is started: `archive`, `settings`, `converters`, `clock`,
    /// `restarts`. None from a release that does not say.
    pub defects: Option<Vec<String>>,
    /// Defects in words, each with its remedy.
    pub defect_texts: Vec<String>,
    /// Why it restarted, each time within a minute of the one before, oldest first.
    pub restarts: Vec<String>,
    /// Work that must be done in time.
    pub deadlines: Vec<DeadlineView>,
    /// How much faster its clock is than the frames of the USB host, as a fraction; none without a
    /// host at its USB port.
    pub timebase_deviation_rel: Option<f64>,
    /// Level of the brown-out reset in the option bytes of its processor; 3 on a board that was set up, 0 as
    /// the factory leaves it. None from a release that does not say.
    pub brown_out_level: Option<u8>,
    /// Other option bytes that are not as delivered, in words.
    pub option_byte_texts: Vec<String>,
    /// The image that runs; none where no loader has checked it, or from a release that does not say.
    pub image: Option<ImageView>,
}

/// The image that an instrument runs.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ImageView {
    /// SHA-256 of the image, in hexadecimal digits.
    pub sha256: String,
    /// Who signed it: `development` is anybody, for that key is public; `release` whoever holds the secret half
    /// of the key its loader trusts.
    pub signer: String,
    /// Slot of the flash it runs from: `a` or `b`.
    pub slot: String,
    /// It is an update on trial, and not confirmed.
    pub on_trial: bool,
    /// The other slot holds an update that was tried and not confirmed.
    pub rolled_back: bool,
}

impl From<&RunningImage> for ImageView {
    fn from(image: &RunningImage) -> Self {
        Self {
            sha256: hex::encode(image.origin.sha256),
            signer: code(&image.origin.signer),
            slot: code(&image.slot),
            on_trial: image.on_trial,
            rolled_back: image.rolled_back,
        }
    }
}

impl ImageView {
    /// In words, on one line.
    pub fn text(&self) -> String {
        let signer = match self.signer.as_str() {
            "development" => "DEVELOPMENT: signed with the key everybody has",
            _ => "signed with the key its loader trusts",
        };
        let standing = match (self.on_trial, self.rolled_back) {
            (true, _) => "; on trial, not confirmed",
            (false, true) => "; an update was tried and not confirmed",
            (false, false) => "",
        };
        format!("{signer}, SHA-256 {}{standing}", self.sha256)
    }
}

/// How long a piece of work took at most since the start, and how long it may take.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct DeadlineView {
    /// A block: `acquire`, `drive`, `evaluate`. A turn of a task: `measure_task`, `acquire_task`, `drive_task`,
    /// `serial_task`, `usb_task`, `supervise_task`, `store_task`, `sensor_task`, `timebase_task`. An
    /// interrupt: `dma_interrupt`, `usb_interrupt`, `uart_interrupt`. `unknown` from a newer release.
    pub work: String,
    /// Longest so far with all that interrupted it, s; 0 before it was done once.
    pub longest_s: f64,
    /// Time allowed, s.
    pub allowed_s: f64,
}

impl From<&Deadline> for DeadlineView {
    fn from(deadline: &Deadline) -> Self {
        let work = Work::ALL.get(usize::from(deadline.work));
        Self {
            work: work.map_or_else(|| "unknown".to_owned(), code),
            longest_s: f64::from(deadline.longest_us) * 1e-6,
            allowed_s: f64::from(deadline.allowed_us) * 1e-6,
        }
    }
}

impl InfoView {
    /// View of the answers of a calibrator; a release that does not know its health has none.
    pub fn new(info: &Info, health: Option<&Health>, image: Option<&RunningImage>) -> Self {
        let defects = || health.into_iter().flat_map(|health| health.defects.iter());
        let text = |defect: Defect| format!("{}: {}", defect.text(), defect.remedy());
        let deadlines = health.into_iter().flat_map(|health| &health.deadlines);
        let timebase = health.and_then(|health| health.timebase_ppm);
        let options = health.and_then(|health| health.option_bytes);
        let restarts = health.into_iter().flat_map(|health| &health.restarts);
        Self {
            protocol_version: info.protocol_version,
            firmware_version: info.firmware_version.to_string(),
            git_hash: info.git_hash.to_string(),
            instrument_serial: info.serial.to_string(),
            sample_rate_hz: info.sample_rate_hz,
            reset_cause: code(&info.reset_cause),
            last_panic: info.last_panic.as_ref().map(ToString::to_string),
            records: info.records,
            uptime_s: info.uptime_ms as f64 / 1000.0,
            stack_unused_bytes: info.stack_unused_bytes,
            instrument_temperature_c: info.instrument_temperature_c,
            defects: health.map(|_| defects().map(|defect| code(&defect)).collect()),
            defect_texts: defects().map(text).collect(),
            restarts: restarts.map(ToString::to_string).collect(),
            deadlines: deadlines.map(DeadlineView::from).collect(),
            timebase_deviation_rel: timebase.map(|ppm| f64::from(ppm) * 1e-6),
            brown_out_level: options.map(OptionBytes::brown_out_level),
            option_byte_texts: options
                .into_iter()
                .flat_map(OptionBytes::deviations)
                .map(|deviation| deviation.text().to_owned())
                .collect(),
            image: image.map(ImageView::from),
        }
    }
}

/// State of a calibrator.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct StatusView {
    /// Phase of the run: `idle`, `settling`, `measuring`, `storing`, `finished`, `stopped`, `failed`.
    pub state: String,
    /// Point in work, from 0.
    pub point: u16,
    /// Points of the run.
    pub points: u16,
    /// Frequency in work, Hz; 0 when idle.
    pub frequency_hz: f32,
    /// Set acceleration, m/s2 r.m.s.
    pub set_acceleration_rms_ms2: f32,
    /// Acceleration of the last block, m/s2 r.m.s.
    pub acceleration_rms_ms2: f32,
    /// Drive voltage, V peak.
    pub drive_peak_v: f32,
    /// Block in work at this point.
    pub block: u16,
    /// Blocks wanted at this point.
    pub blocks: u16,
}

impl From<&Status> for StatusView {
    fn from(status: &Status) -> Self {
        Self {
            state: code(&status.state),
            point: status.point,
            points: status.points,
            frequency_hz: status.frequency_hz,
            set_acceleration_rms_ms2: status.target_rms_ms2,
            acceleration_rms_ms2: status.acceleration_rms_ms2,
            drive_peak_v: status.drive_peak_v,
            block: status.block,
            blocks: status.blocks,
        }
    }
}

/// One line of the record list of a calibrator.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct RecordView {
    /// Running number of the instrument.
    pub record_id: u32,
    /// `calibration`, or `reference_change`: the log of a change of settings, the reference's or others.
    pub kind: String,
    /// Stored bytes.
    pub bytes: u32,
    /// Seconds since 1970-01-01 UTC; none when the time was not known.
    pub unix_time_s: Option<u64>,
    /// Serial number of the device under test.
    pub dut_serial: String,
    /// Points in the record.
    pub points: u16,
    /// Points refused.
    pub refused: u16,
    /// SHA-256 of the record, 64 hexadecimal digits.
    pub sha256: String,
}

impl From<&RecordSummary> for RecordView {
    fn from(record: &RecordSummary) -> Self {
        Self {
            record_id: record.id,
            kind: code(&record.kind),
            bytes: record.bytes,
            unix_time_s: unix_time_s(record.unix_time_s),
            dut_serial: record.dut_serial.to_string(),
            points: record.points,
            refused: record.refused,
            sha256: hex::encode(record.sha256),
        }
    }
}

/// A change of settings.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ChangeView {
    /// Running number of the instrument.
    pub record_id: u32,
    /// `reference_change`, whichever settings they are.
    pub kind: String,
    /// Serial number of the instrument.
    pub instrument_serial: String,
    /// Firmware version and git hash.
    pub firmware_version: String,
    /// SHA-256 of the record before; none for the first of the instrument.
    pub previous_sha256: Option<String>,
    /// Seconds since 1970-01-01 UTC; none when the time was not known.
    pub unix_time_s: Option<u64>,
    /// Who changed it.
    pub operator: String,
    /// Settings of the reference's channel in force before.
    pub before: ReferenceChannel,
    /// All settings in force before; none from a release that logged those of the reference alone.
    pub settings_before: Option<Settings>,
    /// All settings in force since, as in the settings file.
    pub settings: Settings,
}

impl From<&ReferenceChange> for ChangeView {
    fn from(change: &ReferenceChange) -> Self {
        let head = &change.head;
        let is_first = head.previous_sha256 == [0; 32];
        Self {
            record_id: head.id,
            kind: code(&RecordKind::ReferenceChange),
            instrument_serial: head.instrument_serial.to_string(),
            firmware_version: head.firmware.to_string(),
            previous_sha256: (!is_first).then(|| hex::encode(head.previous_sha256)),
            unix_time_s: unix_time_s(head.labels.unix_time_s),
            operator: head.labels.operator.to_string(),
            before: change.before.clone(),
            settings_before: change.all_before.clone(),
            settings: change.settings.clone(),
        }
    }
}
