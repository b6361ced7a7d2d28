//! An archive and what a host does with it. The bench of storage includes this
//! file too.

use super::flash::MockFlash;
use calib_core::point::{PointResult, PointSpec};
use calib_core::point_state::{PointState, Reason};
use calib_core::preferred::PREFERRED_HZ;
use calib_core::settings::Settings;
use calib_core::stored_list::StoredLists;
use calib_core::tone::Tone;
use calib_firmware::archive::{
    Archive, ArchiveError, Directory, LastAccess, MAX_ITEM, Memory, SECTORS,
};
use calib_protocol::message::Refusal;
use calib_protocol::record::{self, Record, RecordHead, RecordSummary};
use calib_protocol::signature;
use ed25519_dalek::{Signature, VerifyingKey};
use embassy_futures::block_on;

/// Buffers an archive works in.
pub(crate) struct Desk {
    directory: Box<Directory>,
    scratch: Box<[u8; MAX_ITEM]>,
    record: Box<Record>,
    lists: Box<[StoredLists; 2]>,
    last_access: LastAccess,
}

impl Desk {
    pub(crate) fn new() -> Self {
        Self {
            directory: Box::default(),
            scratch: Box::new([0; MAX_ITEM]),
            record: Box::new(blank()),
            lists: Box::default(),
            last_access: LastAccess::new(),
        }
    }

    /// Opens the archive as a boot does.
    pub(crate) fn open<const SECTOR: usize>(
        &mut self,
        flash: &MockFlash<SECTOR>,
    ) -> Result<Archive<'_, MockFlash<SECTOR>>, ArchiveError> {
        let [lists, lists_before] = &mut *self.lists;
        let memory = Memory {
            directory: &mut self.directory,
            scratch: &mut self.scratch,
            record: &mut self.record,
            lists,
            lists_before,
            last_access: &self.last_access,
            factory: Settings::field_calibrator,
        };
        let area = 0..(SECTORS * SECTOR) as u32;
        block_on(Archive::open(flash.clone(), area, memory))
    }
}

fn blank() -> Record {
    Record {
        head: RecordHead {
            instrument_serial: "SN-1".try_into().expect("short"),
            firmware: "0.1.0 0123456789ab".try_into().expect("short"),
            sample_rate_hz: 50_000.0,
            ..RecordHead::BLANK
        },
        settings: Settings::field_calibrator(),
        complete: true,
        ..Record::BLANK
    }
}

/// A result that depends on `seed` alone.
pub(crate) fn result(frequency_hz: f32, seed: u32) -> PointResult {
    let spec = PointSpec {
        frequency_hz,
        acceleration_rms_ms2: 10.0,
    };
    let tone = Tone::nearest(frequency_hz, 50_000.0);
    let mut point = PointResult::refused(spec, tone, Reason::Clipped);
    point.state = PointState::Valid;
    point.sensitivity_v_per_ms2 = 0.01 + seed as f32 * 1e-6;
    point.phase_rad = -0.01 * seed as f32;
    point.distortion_dut_rel = 0.001 * (seed % 7) as f32;
    // No two points have one of these in common, as in life.
    let of_its_own = |value: f32| value * frequency_hz.powf(0.3);
    point.acceleration_rms_ms2 = 10.0 + of_its_own(1.0e-4);
    point.expanded_uncertainty_rel = of_its_own(0.001);
    point.expanded_uncertainty_phase_rad = of_its_own(0.002);
    point.coverage_factor = 2.0 + of_its_own(0.001);
    point.effective_degrees_of_freedom = of_its_own(100.0);
    point.repeatability_rel = of_its_own(1.0e-5);
    point.repeatability_phase_rad = of_its_own(1.1e-5);
    point.distortion_reference_rel = of_its_own(0.001);
    point.signal_to_noise_reference_db = of_its_own(10.0);
    point.signal_to_noise_dut_db = of_its_own(9.0);
    point.amplitude_stability_rel = of_its_own(1.0e-5);
    point.drive_peak_v = of_its_own(0.1);
    point.settling_s = of_its_own(0.01);
    point.overshoot_rel = of_its_own(0.001);
    calib_protocol::stored_point::as_stored(&point)
}

/// Fills in everything but number, hash chain and provenance.
pub(crate) fn fill(record: &mut Record, points: usize, seed: u32, settings: &Settings) {
    let (id, previous_sha256) = (record.head.id, record.head.previous_sha256);
    let provenance = record.provenance;
    record.clone_from(&blank());
    (record.head.id, record.head.previous_sha256) = (id, previous_sha256);
    record.settings = settings.clone();
    record.provenance = provenance;
    record.head.labels.unix_time_s = u64::from(seed);
    let list = PREFERRED_HZ.iter().rev().take(points);
    record.points = list.map(|hz| result(*hz, seed)).collect();
}

/// Stores a record; its number and its bytes as a host must get them.
pub(crate) fn store<const SECTOR: usize>(
    archive: &mut Archive<'_, MockFlash<SECTOR>>,
    points: usize,
    seed: u32,
    settings: &Settings,
) -> Result<(u32, Vec<u8>), ArchiveError> {
    let record = archive.draft(settings);
    fill(record, points, seed, settings);
    let mut bytes = vec![0; MAX_ITEM];
    let length = record::encode(record, &mut bytes).expect("fits");
    bytes.truncate(length);
    let id = record.head.id;
    block_on(archive.store())?;
    Ok((id, as_signed(archive, id, bytes)?))
}

/// The bytes of a record as a host must get them from an archive with a key: the same, and its signature.
fn as_signed<const SECTOR: usize>(
    archive: &mut Archive<'_, MockFlash<SECTOR>>,
    id: u32,
    bytes: Vec<u8>,
) -> Result<Vec<u8>, ArchiveError> {
    let Some(key) = archive.public_key() else {
        return Ok(bytes);
    };
    let stored = download(archive, id).map_err(|_| ArchiveError::Flash)?;
    let signed = signature::of(&stored).expect("a record");
    let (signature, message) = signed.expect("it is signed");
    assert_eq!(signature.key, key.public);
    let [r, s] = signature.halves;
    let public = VerifyingKey::from_bytes(&key.public).expect("a key");
    let fits = public.verify_strict(&message, &Signature::from_components(r, s));
    assert!(fits.is_ok(), "record {id}");
    let content = bytes.len() - 4;
    assert_eq!(stored[..content], bytes[..content]);
    assert_eq!(stored.len(), bytes.len() + signature::SIGNATURE_BYTES);
    Ok(stored)
}

/// Logs other settings.
pub(crate) fn log_change<const SECTOR: usize>(
    archive: &mut Archive<'_, MockFlash<SECTOR>>,
    seed: u32,
    settings: &Settings,
) -> Result<u32, ArchiveError> {
    let record = archive.draft(settings);
    fill(record, 0, seed, settings);
    let id = record.head.id;
    block_on(archive.log_change())?;
    Ok(id)
}

/// Downloads a record chunk by chunk.
pub(crate) fn download<const SECTOR: usize>(
    archive: &mut Archive<'_, MockFlash<SECTOR>>,
    id: u32,
) -> Result<Vec<u8>, Refusal> {
    let mut bytes = Vec::new();
    loop {
        let part = block_on(archive.read(id, bytes.len() as u32))?;
        bytes.extend_from_slice(&part.data);
        if bytes.len() as u32 >= part.total {
            return Ok(bytes);
        }
    }
}

/// Every summary, page by page.
pub(crate) fn list<const SECTOR: usize>(
    archive: &mut Archive<'_, MockFlash<SECTOR>>,
) -> Result<Vec<RecordSummary>, ArchiveError> {
    let mut all: Vec<RecordSummary> = Vec::new();
    let mut from = 0;
    loop {
        let page = block_on(archive.page(from))?;
        all.extend(page.records.iter().cloned());
        from = all.last().map_or(0, |summary| summary.id + 1);
        if !page.more {
            return Ok(all);
        }
    }
}
