//! Storing: records, settings, releases.

use super::known::Known;
use super::layout::{BODY_AT, LONGEST_HEAD, RECORD_ITEM, STATE_ITEM};
use super::{Archive, ArchiveError, CheckedFlash, Entry, Memory, end_of, insert, read, sector_of};
use crate::device_key::{DeviceKey, RANDOM_BYTES, Secret};
use calib_core::settings::Settings;
use calib_core::stored_list::NoPlace;
use calib_protocol::change;
use calib_protocol::lists::ListChange;
use calib_protocol::message::Refusal;
use calib_protocol::provenance::LoggedChange;
use calib_protocol::record::{self, Record, RecordError};
use calib_protocol::settings_form::LONGEST_SETTINGS;
use calib_protocol::signature::{self, Message, SIGNATURE_BYTES, Signature};
use calib_protocol::stored::{self, StoredHead, settings_mark};
use calib_protocol::stored_point::LONGEST_POINT;
use core::ops::Range;

impl<F: CheckedFlash> Archive<'_, F> {
    /// Whether a record of so many points will find room.
    ///
    /// # Errors
    /// [`ArchiveError::Full`] when not, so that nothing is measured in vain.
    pub async fn check_room(&mut self, points: usize) -> Result<(), ArchiveError> {
        let bytes = LONGEST_HEAD + LONGEST_SETTINGS + points * LONGEST_POINT + SIGNATURE_BYTES;
        let fit = self.queue.find_max_fit().await?;
        let fits = fit.is_some_and(|largest| largest as usize >= bytes);
        if !fits && !self.may_erase_next() || self.memory.directory.is_full() {
            return Err(ArchiveError::Full);
        }
        Ok(())
    }

    /// The record to be stored next, with its number and its place in the
    /// hash chain, its settings and their provenance; the caller fills in the rest.
    pub fn draft(&mut self, settings: &Settings) -> &mut Record {
        self.unpacked = None;
        let record = &mut *self.memory.record;
        record.head.id = self.state.next_id();
        record.head.previous_sha256 = self.state.last_sha256();
        record.settings.clone_from(settings);
        record.provenance = self.state.provenance(settings);
        record
    }

    /// Stores the draft and reads it back.
    ///
    /// # Errors
    /// See [`ArchiveError`]; the record is then not in the directory.
    pub async fn store(&mut self) -> Result<(), ArchiveError> {
        if self.memory.directory.is_full() {
            return Err(ArchiveError::Full);
        }
        let (mut head, mut item) = self.pack_draft(false)?;
        if self.sector_has(head.settings_mark) {
            let (short_head, short) = self.pack_draft(true)?;
            if self.fits(short.len()) {
                (head, item) = (short_head, short);
            } else {
                self.pack_draft(false)?;
            }
        }
        let sector = self.sector();
        let mut address = self.push(item.clone()).await?;
        if !head.with_settings && self.sector() != sector {
            // Remains of a cut-off write made it move on, away from the
            // settings it shares.
            (head, item) = self.pack_draft(false)?;
            address = self.push(item.clone()).await?;
        }
        self.enter(self.memory.record.head.id, &head, address, item.len());
        if head.with_settings {
            let settings = &self.memory.record.settings;
            if self.state.settings().is_none() {
                self.state.set_settings(settings);
            }
            let sector = sector_of::<F>(address);
            if !self.known_settings.is_full(sector) {
                // The record is stored whatever becomes of this: without it, the
                // next one carries its settings as well.
                let _ = self.push_state().await;
            }
        }
        Ok(())
    }

    /// Logs that the settings of the draft are others than those in force, and
    /// stores them, twice.
    ///
    /// The record is the change: once it is there, the settings in it are in
    /// force, also when the supply fails before they are stored beside it.
    ///
    /// # Errors
    /// See [`ArchiveError`]; the settings before stay in force.
    pub async fn log_change(&mut self) -> Result<(), ArchiveError> {
        if self.memory.directory.is_full() {
            return Err(ArchiveError::Full);
        }
        let record = &mut *self.memory.record;
        let (id, unix_time_s) = (record.head.id, record.head.labels.unix_time_s);
        let change = LoggedChange {
            record_id: id,
            unix_time_s,
        };
        let factory = self.memory.factory;
        record.provenance = self.state.after(&record.settings, change, factory);
        let (head, item) = self.pack_change()?;
        let address = self.push(item.clone()).await?;
        self.enter(id, &head, address, item.len());
        let record = &*self.memory.record;
        self.state
            .change_settings(&record.settings, record.provenance);
        for _copy in 0..2 {
            // The next record carries its settings whatever becomes of this.
            let _ = self.push_state().await;
        }
        Ok(())
    }

    /// Notes a record that lies in flash.
    fn enter(&mut self, id: u32, head: &StoredHead, address: u32, length: usize) {
        self.state.note_record(id, head.sha256);
        insert(
            self.memory.directory,
            Entry {
                id,
                address,
                length: length as u16,
            },
        );
    }

    /// Lets every record up to this running number make room when it is
    /// needed: a host keeps them.
    ///
    /// # Errors
    /// See [`ArchiveError`].
    pub async fn release(&mut self, through: u32) -> Result<(), ArchiveError> {
        self.state.release(through);
        self.have_settings();
        self.push_state().await
    }

    /// Makes the key of the instrument of bytes that nobody knows, and stores it twice. An instrument that has
    /// one keeps it.
    ///
    /// # Errors
    /// See [`ArchiveError`]; there is no key then.
    pub async fn make_key(&mut self, random: &[u8; RANDOM_BYTES]) -> Result<(), ArchiveError> {
        if self.key.is_some() {
            return Ok(());
        }
        let secret = Secret::new(random, self.state.next_id());
        let key = DeviceKey::new(&secret);
        self.have_settings();
        self.state.set_secret(Some(secret));
        if let Err(error) = self.push_state().await {
            self.state.set_secret(None);
            return Err(error);
        }
        self.key = Some(key);
        // There is one in flash, and every sector gets its own.
        let _ = self.push_state().await;
        Ok(())
    }

    /// Changes the lists and stores them, twice.
    ///
    /// # Errors
    /// [`Refusal::ListUnknown`], [`Refusal::ListsFull`], and those of the storage; the lists are then as before.
    pub async fn change_lists(&mut self, change: &ListChange) -> Result<(), Refusal> {
        let memory = &mut self.memory;
        memory.lists_before.clone_from(memory.lists);
        change.carry_out(memory.lists).map_err(|why| match why {
            NoPlace::Unknown => Refusal::ListUnknown,
            NoPlace::Full => Refusal::ListsFull,
        })?;
        self.have_settings();
        if let Err(error) = self.push_state().await {
            let memory = &mut self.memory;
            memory.lists.clone_from(memory.lists_before);
            return Err(error.into());
        }
        // There is one in flash, and every sector gets its own.
        let _ = self.push_state().await;
        Ok(())
    }

    /// A state is stored with settings: those of an instrument that was told none.
    fn have_settings(&mut self) {
        if self.state.settings().is_none() {
            self.state.set_settings(&(self.memory.factory)());
        }
    }

    fn pack_draft(&mut self, share: bool) -> Result<(StoredHead, Range<usize>), ArchiveError> {
        let signer = Signer(self.key.as_ref(), &mut self.signed);
        pack(&mut self.memory, !share, signer, record::encode)
    }

    fn pack_change(&mut self) -> Result<(StoredHead, Range<usize>), ArchiveError> {
        let factory;
        let before = match self.state.settings() {
            Some(settings) => settings,
            None => {
                factory = (self.memory.factory)();
                &factory
            }
        };
        let signer = Signer(self.key.as_ref(), &mut self.signed);
        pack(&mut self.memory, true, signer, |record, body| {
            let (settings, provenance) = (&record.settings, &record.provenance);
            change::encode(&record.head, settings, before, provenance, body)
        })
    }

    async fn push_state(&mut self) -> Result<(), ArchiveError> {
        self.unpacked = None;
        let (kind, body) = self.memory.scratch.split_at_mut(2);
        kind.copy_from_slice(&STATE_ITEM.to_le_bytes());
        let (range, length) = self
            .state
            .write(self.memory.lists, body)
            .ok_or(ArchiveError::TooLong)?;
        let settings = body.get(range.clone()).ok_or(ArchiveError::TooLong)?;
        let mark = settings_mark(settings);
        let address = self.push(0..2 + length).await?;
        self.known_settings.written(Known {
            sector: sector_of::<F>(address),
            mark,
            address: address + 2 + range.start as u32,
            length: range.len() as u16,
        });
        Ok(())
    }

    /// Appends a range of the scratch memory as an item; where its bytes lie.
    async fn push(&mut self, range: Range<usize>) -> Result<u32, ArchiveError> {
        let item = self.memory.scratch.get(range.clone());
        let item = item.ok_or(ArchiveError::TooLong)?;
        let may_erase = self.may_erase_next();
        let sector = self.sector();
        self.memory.last_access.forget_writes();
        self.queue.push(item, may_erase).await?;
        let address = self.memory.last_access.longest_write();
        if sector != Some(sector_of::<F>(address)) {
            self.forget_sector(sector_of::<F>(address));
        }
        self.end = Some(end_of::<F>(address, range.len() as u16));
        self.verify(address, range).await?;
        Ok(address)
    }

    /// Drops what was in a sector that has been erased.
    fn forget_sector(&mut self, sector: u32) {
        let elsewhere = |address| sector_of::<F>(address) != sector;
        self.memory
            .directory
            .retain(|entry| elsewhere(entry.address));
        self.known_settings.forget(sector);
    }

    /// Compares flash with the scratch memory.
    async fn verify(&mut self, address: u32, range: Range<usize>) -> Result<(), ArchiveError> {
        let written = self.memory.scratch.get(range);
        let written = written.ok_or(ArchiveError::TooLong)?;
        let mut at = address;
        for expected in written.chunks(64) {
            let mut found = [0; 64];
            let found = found.split_at_mut(expected.len()).0;
            read(&mut self.queue.flash().inner().0, at, found).await?;
            if found != expected {
                return Err(ArchiveError::Flash);
            }
            at += 64;
        }
        Ok(())
    }

    /// Sector of the last item.
    fn sector(&self) -> Option<u32> {
        self.end.map(|end| sector_of::<F>(end - 1))
    }

    /// Whether settings with this mark lie in the sector of the last item.
    fn sector_has(&self, mark: u32) -> bool {
        self.sector()
            .is_some_and(|sector| self.known_settings.find(sector, mark).is_some())
    }

    /// Whether an item of this length finds room in the sector of the last.
    fn fits(&self, length: usize) -> bool {
        self.end.is_some_and(|end| {
            let sector_end = (sector_of::<F>(end - 1) + 1) * F::ERASE_SIZE as u32;
            let word = F::WRITE_SIZE as u32;
            // Head of the item, and the word that closes the sector.
            end_of::<F>(end + word, length as u16) + word <= sector_end
        })
    }

    /// Whether the sector after that of the last item may be erased.
    fn may_erase_next(&self) -> bool {
        let range = self.queue.flash_range();
        let sectors = sector_of::<F>(range.start)..sector_of::<F>(range.end);
        let next = match self.sector() {
            Some(sector) if sector + 1 < sectors.end => sector + 1,
            _ => sectors.start,
        };
        let released = self.state.released();
        let mut records = self.memory.directory.iter();
        records.all(|entry| sector_of::<F>(entry.address) != next || entry.id <= released)
    }
}

/// The key, if there is one, and the last signature: a record that is packed once more is not signed once more.
struct Signer<'a>(Option<&'a DeviceKey>, &'a mut Option<(Message, Signature)>);

impl Signer<'_> {
    /// Signs the record of `length` bytes at the beginning of `buffer`; its length from then on.
    fn sign(self, buffer: &mut [u8], length: usize) -> Result<usize, RecordError> {
        let Self(Some(key), last) = self else {
            return Ok(length);
        };
        signature::append(buffer, length, |message| match *last {
            Some((signed, signature)) if signed == *message => signature,
            _ => last.insert((*message, key.sign(message))).1,
        })
    }
}

/// Puts a record as an item into the scratch memory; where it lies.
fn pack(
    memory: &mut Memory<'_>,
    with_settings: bool,
    signer: Signer<'_>,
    encode: impl FnOnce(&Record, &mut [u8]) -> Result<usize, RecordError>,
) -> Result<(StoredHead, Range<usize>), ArchiveError> {
    let too_long = |_| ArchiveError::TooLong;
    let (front, body) = memory.scratch.split_at_mut(BODY_AT);
    let length = encode(memory.record, body).map_err(|_| ArchiveError::TooLong)?;
    let length = signer.sign(body, length);
    let length = length.map_err(|_| ArchiveError::TooLong)?;
    let record = body.get(..length).ok_or(ArchiveError::TooLong)?;
    let head = stored::head_of(record, with_settings).map_err(too_long)?;
    stored::cut_out(&head, body).map_err(too_long)?;
    let written = stored::write_head(&head, front).map_err(too_long)?;
    let start = BODY_AT - written - 2;
    front.copy_within(..written, start + 2);
    let mark = front
        .get_mut(start..start + 2)
        .ok_or(ArchiveError::TooLong)?;
    mark.copy_from_slice(&RECORD_ITEM.to_le_bytes());
    Ok((head, start..BODY_AT + usize::from(head.body_bytes)))
}
