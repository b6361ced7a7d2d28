//! A session with the archive, and what a host was told in it.

use super::flash::MockFlash;
use calib_core::point::{PointResult, PointSpec};
use calib_core::points::PREFERRED_HZ;
use calib_core::settings::Settings;
use calib_core::tone::Tone;
use calib_core::verdict::Reason;
use calib_firmware::archive::{
    Archive, ArchiveError, Directory, LastAccess, MAX_ITEM, Memory, SECTORS,
};
use calib_protocol::record::{self, Record, RunLabels};
use embassy_futures::block_on;
use std::collections::BTreeMap;

/// What an archive works in.
pub(crate) struct Desk {
    directory: Box<Directory>,
    scratch: Box<[u8; MAX_ITEM]>,
    record: Box<Record>,
    last_access: LastAccess,
}

impl Desk {
    pub(crate) fn new() -> Self {
        Self {
            directory: Box::default(),
            scratch: Box::new([0; MAX_ITEM]),
            record: Box::new(Record {
                id: 0,
                previous_sha256: [0; 32],
                instrument_serial: Default::default(),
                firmware: Default::default(),
                sample_rate_hz: 50_000.0,
                labels: RunLabels::default(),
                settings: Settings::field_calibrator(),
                incident: None,
                complete: true,
                points: Default::default(),
            }),
            last_access: LastAccess::new(),
        }
    }

    /// What a boot does.
    pub(crate) fn open<const SECTOR: usize>(
        &mut self,
        flash: &MockFlash<SECTOR>,
    ) -> Result<Archive<'_, MockFlash<SECTOR>>, ArchiveError> {
        let memory = Memory {
            directory: &mut self.directory,
            scratch: &mut self.scratch,
            record: &mut self.record,
            last_access: &self.last_access,
        };
        let area = 0..(SECTORS * SECTOR) as u32;
        block_on(Archive::open(flash.clone(), area, memory))
    }
}

/// Stores a record; its number and its bytes as a host must get them.
pub(crate) fn store<const SECTOR: usize>(
    archive: &mut Archive<'_, MockFlash<SECTOR>>,
    points: usize,
    seed: u32,
    settings: &Settings,
) -> Result<(u32, Vec<u8>), ArchiveError> {
    let draft = archive.draft();
    draft.settings = settings.clone();
    draft.labels.unix_time_s = u64::from(seed);
    draft.points.clear();
    for frequency_hz in PREFERRED_HZ.iter().rev().take(points) {
        let spec = PointSpec {
            frequency_hz: *frequency_hz,
            acceleration_rms_ms2: 10.0,
        };
        let tone = Tone::nearest(*frequency_hz, 50_000.0);
        let mut point = PointResult::refused(spec, tone, Reason::Clipped);
        point.sensitivity_v_per_ms2 = 0.01 + seed as f32 * 1e-6;
        point.phase_rad = -0.01 * seed as f32;
        // As many fit as are asked for here.
        let _ = draft.points.push(point);
    }
    let id = draft.id;
    let mut bytes = vec![0; MAX_ITEM];
    let length = record::encode(draft, &mut bytes).map_err(|_| ArchiveError::TooLong)?;
    bytes.truncate(length);
    block_on(archive.store())?;
    Ok((id, bytes))
}

/// What a host was told.
#[derive(Default)]
pub(crate) struct Told {
    records: BTreeMap<u32, Vec<u8>>,
    settings: Option<Settings>,
    /// A change that was begun may or may not have come through.
    attempted: Option<Settings>,
    released: u32,
}

/// One step of a session; `Err` when the power failed.
pub(crate) fn step<const SECTOR: usize>(
    archive: &mut Archive<'_, MockFlash<SECTOR>>,
    told: &mut Told,
    number: u32,
) -> Result<(), ArchiveError> {
    let mut settings = told
        .settings
        .clone()
        .unwrap_or_else(Settings::field_calibrator);
    match number % 8 {
        3 => {
            settings.blocks = 2 + (number % 60_000) as u16;
            told.attempted = Some(settings.clone());
            block_on(archive.store_settings(&settings))?;
            told.settings = Some(settings);
        }
        6 => {
            // What may be gone after a cut is what the host has let go.
            told.released = archive.next_id() - 1;
            block_on(archive.release(told.released))?;
        }
        _ => {
            let points = [2, 9, 31][number as usize % 3];
            let (id, bytes) = store(archive, points, number, &settings)?;
            told.records.insert(id, bytes);
        }
    }
    Ok(())
}

impl Told {
    /// Everything told is there, and nothing is half there; how many records
    /// were compared.
    pub(crate) fn check<const SECTOR: usize>(
        &mut self,
        archive: &mut Archive<'_, MockFlash<SECTOR>>,
    ) -> Result<u64, String> {
        let mut found = Vec::new();
        let mut from = 0;
        loop {
            let page = block_on(archive.page(from)).map_err(|error| error.to_string())?;
            found.extend(page.records.iter().map(|summary| summary.id));
            from = found.last().map_or(0, |id| id + 1);
            if !page.more {
                break;
            }
        }
        for id in &found {
            let bytes = download(archive, *id)?;
            record::decode(&bytes).map_err(|error| format!("record {id}: {error}"))?;
            if self.records.get(id).is_some_and(|told| *told != bytes) {
                return Err(format!("record {id} is another one"));
            }
        }
        let lost = |id: &&u32| **id > self.released && !found.contains(id);
        if let Some(id) = self.records.keys().find(lost) {
            return Err(format!("record {id} is lost"));
        }
        let kept = archive.settings();
        if self.settings.is_some()
            && kept != self.settings.as_ref()
            && kept != self.attempted.as_ref()
        {
            return Err("the settings are others".into());
        }
        // What came through is in force from here on, and what is gone is gone.
        self.settings = kept.cloned();
        self.records.retain(|id, _| found.contains(id));
        Ok(found.len() as u64)
    }
}

fn download<const SECTOR: usize>(
    archive: &mut Archive<'_, MockFlash<SECTOR>>,
    id: u32,
) -> Result<Vec<u8>, String> {
    let mut bytes = Vec::new();
    loop {
        let part = block_on(archive.read(id, bytes.len() as u32));
        let part = part.map_err(|refusal| format!("record {id}: {refusal:?}"))?;
        bytes.extend_from_slice(&part.data);
        if bytes.len() as u32 >= part.total {
            return Ok(bytes);
        }
    }
}

/// SplitMix64 (Steele, Lea and Flood 2014).
pub(crate) fn splitmix(state: &mut u64) -> u64 {
    *state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
    let mut mixed = *state;
    mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    mixed ^ (mixed >> 31)
}
