//! The record of a calibration, whatever form it is written in.

use crate::clock::ClockReading;
use crate::head::{RecordHead, Sha256Sum};
use crate::provenance::Provenance;
use crate::signature::PublicKey;
use crate::update::ImageOrigin;
use calib_core::closing::Closing;
use calib_core::point::{PointResult, PointSpec};
use calib_core::settings::Settings;
use calib_core::stored_list::ListTerms;
use heapless::{String, Vec};

/// Most points of one run.
pub const MAX_POINTS: usize = 200;

/// One calibration, as stored.
#[derive(Clone, Debug, PartialEq)]
pub struct Record {
    /// Number, place in the hash chain, instrument and labels.
    pub head: RecordHead,
    /// Settings and reference calibration the run was made with.
    pub settings: Settings,
    /// Cause of the restart since the record before, if that was a
    /// panic or a fault.
    pub incident: Option<String<160>>,
    /// True when every point of the list was attempted.
    pub complete: bool,
    /// Digest of the settings, and since when they are those.
    pub provenance: Provenance,
    /// The image that measured, as its loader found it.
    pub image: ImageOrigin,
    /// The list that a tap of the button chose, and what it is judged by; none where a host began the run.
    pub list: ListTerms,
    /// Where the time comes from of a run that no host began.
    pub clock: ClockReading,
    /// Outcome of repeating the first valid point at the end.
    pub closing: Closing,
    /// Results in the order measured.
    pub points: Vec<PointResult, MAX_POINTS>,
    /// Points of the list that were never attempted, because the run ended before.
    pub untried: Vec<PointSpec, MAX_POINTS>,
    /// [Digest](crate::record::digest) of the bytes it was read from; none of a record that was not read.
    pub sha256: Option<Sha256Sum>,
    /// Key that the bytes it was read from are said to be signed by; whether they are is for a host to verify.
    pub signed_by: Option<PublicKey>,
}

impl Record {
    /// A record of nothing, for memory that waits for one.
    pub const BLANK: Self = Self {
        head: RecordHead::BLANK,
        settings: Settings::BLANK,
        incident: None,
        complete: false,
        provenance: Provenance::UNKNOWN,
        image: ImageOrigin::UNKNOWN,
        list: ListTerms::NONE,
        clock: ClockReading::NONE,
        closing: Closing::None,
        points: Vec::new(),
        untried: Vec::new(),
        sha256: None,
        signed_by: None,
    };
}
