//! Head of every record, of any kind, and the sum that the next one carries of it.

use crate::text::{is_plain, tame};
use heapless::String;
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

/// A SHA-256 sum (FIPS 180-4).
pub type Sha256Sum = [u8; 32];

/// SHA-256 of the bytes of a record, as [`crate::record::encode`] writes them.
///
/// Each record carries that of the one before: a record that was removed or
/// altered breaks the hash chain at the next.
pub fn digest(record: &[u8]) -> Sha256Sum {
    Sha256::digest(record).into()
}

/// Number, place in the hash chain, instrument and labels of a record.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RecordHead {
    /// Running number of the instrument, from 1, never used twice.
    pub id: u32,
    /// [`digest`] of the record with the number before; zero for
    /// the first.
    pub previous_sha256: Sha256Sum,
    /// Serial number of the instrument.
    pub instrument_serial: String<32>,
    /// Firmware version and git hash.
    pub firmware: String<40>,
    /// Samples per second and channel, Hz.
    pub sample_rate_hz: f32,
    /// Labels the operator gave; in the log of a change time and operator alone.
    pub labels: RunLabels,
}

impl RecordHead {
    /// Its texts as words of one line each ([`crate::text`]).
    pub(crate) fn tame(&mut self) {
        tame(&mut self.instrument_serial);
        tame(&mut self.firmware);
        let labels = &mut self.labels;
        tame(&mut labels.dut_model);
        tame(&mut labels.dut_serial);
        tame(&mut labels.operator);
        tame(&mut labels.mounting);
    }

    /// A head of nothing, for memory that waits for one.
    pub const BLANK: Self = Self {
        id: 0,
        previous_sha256: [0; 32],
        instrument_serial: String::new(),
        firmware: String::new(),
        sample_rate_hz: 0.0,
        labels: RunLabels::BLANK,
    };
}

/// Labels the operator gives a run.
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

impl RunLabels {
    /// Whether each text is words of one line.
    pub fn is_plain(&self) -> bool {
        let texts = [&self.dut_model, &self.dut_serial, &self.operator];
        texts.into_iter().all(|text| is_plain(text)) && is_plain(&self.mounting)
    }

    /// Labels of an operator who says nothing.
    pub const BLANK: Self = Self {
        unix_time_s: 0,
        dut_model: String::new(),
        dut_serial: String::new(),
        operator: String::new(),
        temperature_centi_c: None,
        mounting: String::new(),
    };
}
