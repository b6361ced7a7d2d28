//! Messages: what a host asks and what the calibrator answers.
//!
//! | request | response | path |
//! |---|---|---|
//! | `Info` | `Info` | info/get |
//! | `Status` | `Status` | status/get |
//! | `Point` | `Point` | run/point |
//! | `Start` | `Started` or `Refused` | run/start |
//! | `Stop` | `Done` | run/stop |
//! | `Records` | `Records` | record/list |
//! | `ReadRecord` | `RecordData` | record/read |
//! | `SettingsRead` | `Settings` | settings/get |
//! | `SettingsWrite` | `Done` or `Refused` | settings/set |
//! | `Reset` | `Done`, then the board resets | device/reset |
//! | `Release` | `Done` or `Refused` | record/release |
//! | `Capture` | `Done` or `Refused` | capture/take |
//! | `ReadCapture` | `CaptureData` or `Refused` | capture/read |
//! | `Health` | `Health` | health/get |
//! | `SelfTest` | `SelfTest` or `Refused` | device/self-test |
//! | `StopRun` | `Done` | run/stop |
//! | `Key` | `Key` or `Refused` | key/get |
//! | `MakeKey` | `Key` or `Refused` | key/make |
//! | `Image` | `Image` | image/get |
//! | `Update` | `Done` or `Refused` | image/update |
//! | `List` | `List` or `Refused` | list/get |
//! | `ChangeLists` | `Done` or `Refused` | list/set |
//! | `Clock` | `Done` | clock/set |

use crate::capture::CapturePart;
use crate::health::{Defects, Health};
use crate::lists::{KeptList, ListChange};
use crate::record::{MAX_POINTS, RecordSummary, RunLabels};
use crate::signature::DeviceKey;
use crate::update::{RunningImage, UpdateStep};
use calib_core::point::{ExcitationKind, PointResult, PointSpec};
use calib_core::point_state::Reason;
use calib_core::self_test::{Line, MAX_LINES};
use calib_core::settings::Settings;
use heapless::{String, Vec};
use serde::{Deserialize, Serialize};

/// Bytes of a record in one answer.
pub const RECORD_CHUNK: usize = 1024;

/// Request of a host.
// A request is built once and encoded: its size never matters.
#[allow(clippy::large_enum_variant)]
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Request {
    /// Who are you?
    Info,
    /// Asks for the state of the instrument.
    Status,
    /// Result of one point of the running or last run, from 0.
    Point {
        /// Index of the point in the list.
        index: u16,
    },
    /// Measure these points.
    ///
    /// A host whose answer got lost sends the same frame again, with the same
    /// sequence number. The device recognises the frame of the start it last
    /// accepted by sequence number and checksum, and answers `Started` again
    /// instead of `Refused(Busy)`. All other requests may simply be repeated.
    Start(RunSpec),
    /// Silence the exciter and end the run.
    Stop,
    /// Summaries of stored records, from this running number on.
    Records {
        /// First running number wanted.
        from: u32,
    },
    /// Bytes of a stored record.
    ReadRecord {
        /// Running number of the record.
        id: u32,
        /// First byte wanted.
        offset: u32,
    },
    /// The settings in force.
    SettingsRead,
    /// New settings, stored in flash. They need the button held on the
    /// instrument, and are logged as a record ([`crate::change`]).
    SettingsWrite(SettingsChange),
    /// Reset the board.
    Reset,
    /// The host keeps every record up to this running number: they may make
    /// room when the record area is full.
    Release {
        /// Last running number kept.
        through: u32,
    },
    /// Take this many consecutive sample pairs, from the next block on. What
    /// was captured before is forgotten.
    Capture {
        /// 1 to [`crate::capture::MAX_CAPTURE_PAIRS`].
        pairs: u16,
    },
    /// Pairs of the capture, or how far it is.
    ReadCapture {
        /// First pair wanted, from 0.
        offset: u16,
    },
    /// Defects of the instrument, and what it went through.
    Health,
    /// Test the board. The exciter is cut off on the chip first: the table does not move.
    SelfTest,
    /// Silence the exciter and end the run whose record has this number, if it goes on: a stop that
    /// comes late ends no other run.
    StopRun {
        /// Running number of its record, as `Started` told it.
        record_id: u32,
    },
    /// The public key of the instrument.
    Key,
    /// Make the key of the instrument, which signs every record from then on. It needs the button held, and
    /// an instrument has one key in its life.
    MakeKey,
    /// The image that runs.
    Image,
    /// A step of an update. Not while a run goes on; an image older than the one that runs needs the
    /// button held at `Begin`.
    Update(UpdateStep),
    /// A list kept on the instrument.
    List {
        /// Its place, from 0.
        place: u8,
    },
    /// Store, remove or choose a list. It needs the button held: a list decides what the lamps say.
    ChangeLists(ListChange),
    /// Take this time: runs without a host are dated by it until the next restart.
    Clock {
        /// Seconds since 1970-01-01 UTC by the host's clock; 0 tells nothing.
        unix_time_s: u64,
    },
}

/// Answer of the calibrator.
// An answer is encoded at once and never stored in numbers.
#[allow(clippy::large_enum_variant)]
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Response {
    /// Answer to `Info`.
    Info(Info),
    /// Answer to `Status`.
    Status(Status),
    /// Answer to `Point`.
    Point {
        /// Index asked for.
        index: u16,
        /// Result, or `None` while it is not there yet.
        #[serde(with = "crate::stored_point::result")]
        result: Option<PointResult>,
    },
    /// The run has begun.
    Started {
        /// Running number the record will have.
        record_id: u32,
    },
    /// The request was carried out.
    Done,
    /// Answer to `Records`: at most 16, and whether there are more.
    Records {
        /// Summaries in rising running number.
        records: Vec<RecordSummary, 16>,
        /// True when a further request from the last number + 1 finds more.
        more: bool,
    },
    /// Answer to `ReadRecord`.
    RecordData {
        /// Running number.
        id: u32,
        /// Position of the first byte.
        offset: u32,
        /// Length of the whole record, in bytes.
        total: u32,
        /// Bytes from `offset` on.
        data: Vec<u8, RECORD_CHUNK>,
    },
    /// Answer to `SettingsRead`.
    Settings(#[serde(with = "crate::settings_form")] Settings),
    /// The device understood and declines.
    Refused(Refusal),
    /// Answer to `ReadCapture`.
    CaptureData(CapturePart),
    /// Answer to `Health`.
    Health(Health),
    /// Answer to `SelfTest`.
    SelfTest {
        /// Lines of the test, in the order of [`calib_core::self_test::Check`].
        lines: Vec<Line, MAX_LINES>,
    },
    /// Answer to `Key` and `MakeKey`; none: the instrument signs nothing.
    Key(Option<DeviceKey>),
    /// Answer to `Image`; none: no loader has checked it.
    Image(Option<RunningImage>),
    /// Answer to `List`; none: no list has this place.
    List(Option<KeptList>),
}

/// Protocol version in an `Info` answer of any version, from its message bytes.
///
/// `Request::Info` and `Response::Info` are number 0 and the version is the
/// first field, in every version there will be: that is how two peers find out
/// that they cannot talk.
pub fn version_of_info(message: &[u8]) -> Option<u16> {
    match postcard::take_from_bytes::<(u8, u16)>(message) {
        Ok(((0, version), _)) => Some(version),
        _ => None,
    }
}

/// Why a request is declined.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[non_exhaustive]
pub enum Refusal {
    /// A run is going on.
    Busy,
    /// No record with this running number.
    RecordNotFound,
    /// The offset lies behind the end of the record or capture.
    OffsetOutOfRange,
    /// The record area is full.
    StorageFull,
    /// The flash reported an error.
    StorageFailed,
    /// The list is empty, a value in it is not finite and positive, or a
    /// broadband run has points of different levels.
    PointList,
    /// A setting is outside its range; nothing was changed.
    Settings,
    /// The frame was whole but is no message of this protocol version.
    Unknown,
    /// The host on the other link holds the session: it alone may start,
    /// capture, reset, release and write settings until it has gone or been
    /// quiet.
    OtherHost,
    /// A capture of no pairs, or of more than there is room for.
    CaptureLength,
    /// Nothing was captured since the start.
    NotCaptured,
    /// Sample pairs were lost while the capture was taken.
    CaptureBroken,
    /// They are other settings, and the button on the instrument is not held;
    /// nothing was changed.
    ButtonNotHeld,
    /// The instrument is colder or hotter than it is made for
    /// ([`calib_core::thermometer`]).
    TemperatureOutOfRange,
    /// Since the converters were started, their two channels are not shown to be
    /// of the same instants ([`calib_core::alignment`]).
    ChannelsNotAligned,
    /// Something of the instrument does not work: it measures nothing, and does
    /// what is asked as far as it can.
    Degraded(Defects),
    /// A condition said for the run cannot be true: a temperature outside of -55 to
    /// 200 degrees Celsius.
    Conditions,
    /// The instrument has a key, and keeps it.
    KeyExists,
    /// The generator of random numbers gives none: no key was made.
    NoRandomness,
    /// The instrument has no loader: it is updated by a debug probe.
    NoLoader,
    /// The manifest is none, was changed, or is not signed with the key the instrument trusts.
    ImageSignature,
    /// The image is for another board, or for the slot that is in use.
    ImageNotForHere,
    /// The image is older than the one that runs, and the button on the instrument is not held.
    ImageOlder,
    /// The image that runs was not confirmed: the other slot holds what it may fall back to.
    ImageOnTrial,
    /// No update was begun, or this block is not the next.
    UpdateOrder,
    /// The image written is not the image of the manifest.
    ImageDamaged,
    /// The list cannot be measured or judged: a value is out of its range, a name, a point or a tolerance is
    /// missing, or a nominal sensitivity that a tolerance is stated of.
    List,
    /// There is no room for another list.
    ListsFull,
    /// There is no list of this name.
    ListUnknown,
    /// The exciter is still driven 100 ms after the stop.
    StillDriven,
    /// This point of the list cannot be measured: nothing was moved.
    PointImpossible {
        /// Its place in the list, from 0.
        index: u16,
        /// Why.
        reason: Reason,
    },
}

/// New settings, and what the log of a change says of it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SettingsChange {
    /// All of them.
    #[serde(with = "crate::settings_form")]
    pub settings: Settings,
    /// Seconds since 1970-01-01 UTC by the host's clock; 0 = not known.
    pub unix_time_s: u64,
    /// Who changes them.
    pub operator: String<48>,
}

impl From<Settings> for SettingsChange {
    /// Settings of nobody at no time.
    fn from(settings: Settings) -> Self {
        Self {
            settings,
            unix_time_s: 0,
            operator: String::new(),
        }
    }
}

/// A run to be measured.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RunSpec {
    /// Points in the order they are measured.
    pub points: Vec<PointSpec, MAX_POINTS>,
    /// Tone after tone, or all at once; then all points have one level, the
    /// total r.m.s. of the band from the lowest to the highest of them.
    pub excitation: ExcitationKind,
    /// Labels of the run for the record.
    pub labels: RunLabels,
}

/// Identity of the calibrator, and how it is.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Info {
    /// [`crate::frame::PROTOCOL_VERSION`] of the firmware.
    pub protocol_version: u16,
    /// Firmware version.
    pub firmware_version: String<16>,
    /// Git hash the firmware was built from; `-dirty` when it was changed.
    pub git_hash: String<24>,
    /// Serial number of the instrument, from the chip's unique id.
    pub serial: String<32>,
    /// Samples per second and channel, Hz.
    pub sample_rate_hz: f32,
    /// Why the board last started.
    pub reset_cause: ResetCause,
    /// Message of the panic before the last start, if there was one.
    pub last_panic: Option<String<160>>,
    /// Stored records.
    pub records: u32,
    /// Milliseconds since the start.
    pub uptime_ms: u64,
    /// Bytes of the stack that were never used since the start: what is left of
    /// it at its deepest.
    pub stack_unused_bytes: u32,
    /// Temperature of the processor, degrees Celsius, good to some kelvin
    /// ([`calib_core::thermometer`]); none when it could not be read.
    pub instrument_temperature_c: Option<f32>,
}

/// Why the board started.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum ResetCause {
    /// Power was switched on, or came back.
    PowerOn,
    /// Reset pin.
    Pin,
    /// Asked for by software.
    Software,
    /// The watchdog expired.
    Watchdog,
    /// Supply voltage too low.
    BrownOut,
    /// None of these.
    #[default]
    Other,
}

/// State of the instrument.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Status {
    /// Phase of the run.
    pub state: RunState,
    /// Point in work, from 0; as many as there are while the first valid one is repeated behind the last.
    pub point: u16,
    /// Points of the run.
    pub points: u16,
    /// Frequency in work, Hz; 0 when idle.
    pub frequency_hz: f32,
    /// Set acceleration, m/s2 r.m.s.
    pub target_rms_ms2: f32,
    /// Acceleration of the last block, m/s2 r.m.s.
    pub acceleration_rms_ms2: f32,
    /// Drive voltage, V peak.
    pub drive_peak_v: f32,
    /// Block in work at this point.
    pub block: u16,
    /// Blocks wanted at this point.
    pub blocks: u16,
    /// Sample pairs lost since the start.
    pub overruns: u32,
    /// Sample pairs taken since the start.
    pub samples: u64,
}

impl Status {
    /// An instrument that has done nothing yet.
    pub const IDLE: Self = Self {
        state: RunState::Idle,
        point: 0,
        points: 0,
        frequency_hz: 0.0,
        target_rms_ms2: 0.0,
        acceleration_rms_ms2: 0.0,
        drive_peak_v: 0.0,
        block: 0,
        blocks: 0,
        overruns: 0,
        samples: 0,
    };
}

/// Phase of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum RunState {
    /// Silent, waiting.
    Idle,
    /// The level is being approached.
    Settling,
    /// Blocks are being measured.
    Measuring,
    /// The record is being written.
    Storing,
    /// Ended; the record is stored.
    Finished,
    /// Ended early; the record of what was measured is stored.
    Stopped,
    /// The record could not be stored.
    Failed,
}

impl RunState {
    /// The exciter is at work for the run.
    pub const fn is_exciting(self) -> bool {
        matches!(self, Self::Settling | Self::Measuring)
    }

    /// The run has not ended: the exciter is at work or the record being written.
    pub const fn is_running(self) -> bool {
        self.is_exciting() || matches!(self, Self::Storing)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn info(protocol_version: u16) -> Info {
        Info {
            protocol_version,
            ..Info::default()
        }
    }

    #[test]
    fn the_version_is_found_whatever_follows_it() {
        for version in [0, 1, 127, 128, 40_000] {
            let mut bytes = [0; 128];
            let message = postcard::to_slice(&Response::Info(info(version)), &mut bytes);
            let message = message.expect("fits");
            assert_eq!(version_of_info(message), Some(version));
            assert_eq!(version_of_info(&message[..4]), Some(version));
        }
    }

    #[test]
    fn other_answers_have_no_version() {
        let mut bytes = [0; 16];
        let message = postcard::to_slice(&Response::Done, &mut bytes).expect("fits");
        assert_eq!(version_of_info(message), None);
        assert_eq!(version_of_info(&[]), None);
    }
}
