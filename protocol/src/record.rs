//! Stored records: what a calibration leaves behind.
//!
//! | bytes | content |
//! |---|---|
//! | 2 | record version, u16 LE ([`RECORD_VERSION`]) |
//! | n | [`Record`], postcard |
//! | 4 | CRC-32 of everything before, LE |

use calib_core::point::PointResult;
use calib_core::settings::Settings;
use heapless::{String, Vec};
use serde::{Deserialize, Serialize};

/// Version of the stored form.
pub const RECORD_VERSION: u16 = 1;
/// Most points of one run.
pub const MAX_POINTS: usize = 200;

/// What the operator says about a run.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct RunLabels {
    /// Seconds since 1970-01-01 UTC by the host's clock; 0 = not known.
    pub unix_time_s: u64,
    /// Device under test: manufacturer and model.
    pub dut_model: String<48>,
    /// Device under test: serial number.
    pub dut_serial: String<48>,
    /// Who calibrates.
    pub operator: String<48>,
    /// Temperature of the transducer in hundredths of a degree Celsius.
    pub temperature_centi_c: Option<i16>,
    /// Mounting, in the operator's words.
    pub mounting: String<96>,
}

/// One calibration, as stored.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// Running number of the instrument, from 1, never used twice.
    pub id: u32,
    /// Serial number of the instrument.
    pub instrument_serial: String<32>,
    /// Firmware version and git hash.
    pub firmware: String<40>,
    /// Samples per second and channel, Hz.
    pub sample_rate_hz: f32,
    /// What the operator said.
    pub labels: RunLabels,
    /// Settings and reference calibration the run was made with.
    pub settings: Settings,
    /// True when every point of the list was attempted.
    pub complete: bool,
    /// Results in the order measured.
    pub points: Vec<PointResult, MAX_POINTS>,
}

/// One line of the record list.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RecordSummary {
    /// Running number.
    pub id: u32,
    /// Stored bytes.
    pub bytes: u32,
    /// Seconds since 1970-01-01 UTC; 0 = not known.
    pub unix_time_s: u64,
    /// Serial number of the device under test.
    pub dut_serial: String<48>,
    /// Points in the record.
    pub points: u16,
    /// Points refused.
    pub refused: u16,
}
