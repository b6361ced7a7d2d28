//! A session with the archive, what a host was told in it, and whether that is
//! true after a restart. The bench of storage includes this file too.

use super::desk;
use super::flash::MockFlash;
use calib_core::point::PointSpec;
use calib_core::settings::Settings;
use calib_core::stored_list::{Band, Base, ListTerms, Rule, StoredList, StoredLists};
use calib_firmware::archive::{Archive, ArchiveError};
use calib_firmware::device_key::RANDOM_BYTES;
use calib_protocol::lists::ListChange;
use calib_protocol::message::Refusal;
use calib_protocol::record::{self, RecordKind};
use calib_protocol::signature::DeviceKey;
use embassy_futures::block_on;
use std::collections::BTreeMap;

/// Everything a host was told: records stored, settings in force, records released, the key, the lists.
#[derive(Clone, Default)]
pub(crate) struct Told {
    pub(crate) records: BTreeMap<u32, Vec<u8>>,
    settings: Option<Settings>,
    /// A change that was begun may or may not have come through.
    attempted: Option<Settings>,
    released: u32,
    key: Option<DeviceKey>,
    /// A key that was begun may or may not have come through.
    attempted_key: bool,
    lists: StoredLists,
    /// As they would be after a change that may or may not have come through.
    attempted_lists: Option<StoredLists>,
}

/// One step of a session; `Err` when the power failed.
pub(crate) fn step<const SECTOR: usize>(
    archive: &mut Archive<'_, MockFlash<SECTOR>>,
    told: &mut Told,
    number: u32,
) -> Result<(), ArchiveError> {
    let settings = told.settings.clone();
    let mut settings = settings.unwrap_or_else(Settings::field_calibrator);
    match number % 8 {
        1 if archive.public_key().is_none() => {
            told.attempted_key = true;
            block_on(archive.make_key(&[number as u8; RANDOM_BYTES]))?;
            told.key = archive.public_key();
        }
        3 | 5 => {
            match number % 8 {
                3 => settings.blocks = 2 + (number % 60_000) as u16,
                _ => settings.reference.due_day = number,
            }
            told.attempted = Some(settings.clone());
            let id = desk::log_change(archive, number, &settings)?;
            let bytes = desk::download(archive, id).map_err(|_| ArchiveError::Flash)?;
            told.records.insert(id, bytes);
            told.settings = Some(settings);
        }
        7 => {
            let change = list_change(number / 8);
            let mut after = told.lists.clone();
            // What is not there is neither removed nor chosen, here as there.
            let expected = change.carry_out(&mut after).is_ok();
            told.attempted_lists = Some(after.clone());
            match block_on(archive.change_lists(&change)) {
                Ok(()) if expected => told.lists = after,
                Err(Refusal::ListUnknown) if !expected => {}
                _ => return Err(ArchiveError::Flash),
            }
        }
        6 => {
            // What may be gone after a cut is what the host has let go.
            told.released = archive.next_id() - 1;
            block_on(archive.release(told.released))?;
        }
        _ => {
            let points = [2, 9, 31][number as usize % 3];
            let (id, bytes) = desk::store(archive, points, number, &settings)?;
            told.records.insert(id, bytes);
        }
    }
    Ok(())
}

/// Lists come, are chosen, change and go.
fn list_change(number: u32) -> ListChange {
    let name = heapless::String::try_from(["a", "b"][number as usize / 4 % 2]).unwrap_or_default();
    match number % 4 {
        0 | 2 => ListChange::Store(list(name, number)),
        1 => ListChange::Choose { name },
        _ => ListChange::Remove { name },
    }
}

fn list(name: heapless::String<24>, number: u32) -> StoredList {
    let band = Band::everywhere(Base::Nominal, 0.05);
    let point = PointSpec {
        frequency_hz: 160.0,
        acceleration_rms_ms2: 1.0 + number as f32,
    };
    StoredList {
        terms: ListTerms {
            name,
            nominal_v_per_ms2: 0.01,
            rule: Rule::GuardBand,
            bands: [band].into_iter().collect(),
            ..ListTerms::NONE
        },
        points: core::iter::repeat_n(point, 1 + number as usize % 30).collect(),
    }
}

impl Told {
    /// Everything told is there, nothing is half there, and no change of the
    /// settings is without its log; how many records were compared.
    pub(crate) fn check<const SECTOR: usize>(
        &mut self,
        archive: &mut Archive<'_, MockFlash<SECTOR>>,
    ) -> Result<u64, String> {
        let listed = desk::list(archive).map_err(|error| error.to_string())?;
        let mut logged = None;
        for summary in &listed {
            let id = summary.id;
            let bytes = desk::download(archive, id).map_err(|why| format!("{id}: {why:?}"))?;
            record::inspect(&bytes).map_err(|error| format!("record {id}: {error}"))?;
            if self.records.get(&id).is_some_and(|told| *told != bytes) {
                return Err(format!("record {id} is another one"));
            }
            if summary.kind == RecordKind::ReferenceChange {
                let change = calib_protocol::change::decode(&bytes);
                logged = Some(change.map_err(|error| format!("record {id}: {error}"))?);
            }
        }
        let found = |id: &u32| listed.iter().any(|summary| summary.id == *id);
        let lost = |id: &&u32| **id > self.released && !found(id);
        if let Some(id) = self.records.keys().find(lost) {
            return Err(format!("record {id} is lost"));
        }
        let kept = archive.settings();
        let expected = kept == self.settings.as_ref() || kept == self.attempted.as_ref();
        if self.settings.is_some() && !expected {
            return Err("the settings are others".into());
        }
        let key = archive.public_key();
        if key != self.key && (self.key.is_some() || !self.attempted_key) {
            return Err("the key is another".into());
        }
        if *archive.lists() != self.lists && Some(archive.lists()) != self.attempted_lists.as_ref()
        {
            return Err("the lists are others".into());
        }
        if let (Some(kept), Some(logged)) = (kept, &logged)
            && *kept != logged.settings
        {
            return Err("the settings are others than were logged last".into());
        }
        // What came through is in force from here on, and what is gone is gone.
        self.settings = kept.cloned();
        self.lists = archive.lists().clone();
        self.key = key;
        self.records.retain(|id, _| found(id));
        Ok(listed.len() as u64)
    }
}
