//! Reading: the list, and records to the byte.

use super::layout::LONGEST_LISTED;
use super::{Archive, ArchiveError, CheckedFlash, Directory, Entry, mark_of, read, sector_of};
use crate::command::{RecordPage, RecordPart};
use calib_protocol::message::{RECORD_CHUNK, Refusal};
use calib_protocol::record::digest;
use calib_protocol::stored;
use core::ops::Range;
use embassy_futures::yield_now;
use heapless::Vec;

impl<F: CheckedFlash> Archive<'_, F> {
    /// Summaries from running number `from` on.
    ///
    /// # Errors
    /// [`ArchiveError::Flash`].
    pub async fn page(&mut self, from: u32) -> Result<RecordPage, ArchiveError> {
        let start = self
            .memory
            .directory
            .partition_point(|entry| entry.id < from);
        let rest = self.memory.directory.get(start..).unwrap_or_default();
        let mut page = RecordPage::default();
        for entry in rest {
            if page.records.is_full() {
                page.more = true;
                break;
            }
            let mut bytes = [0; LONGEST_LISTED];
            let length = LONGEST_LISTED.min(usize::from(entry.length));
            let bytes = bytes.split_at_mut(length).0;
            read(&mut self.queue.flash().inner().0, entry.address, bytes).await?;
            let head = mark_of(bytes).and_then(|(_, rest)| stored::head(rest).ok());
            let (head, body) = head.ok_or(ArchiveError::Flash)?;
            let summary = head.summary(body).map_err(|_| ArchiveError::Flash)?;
            // Not full, as checked above.
            let _ = page.records.push(summary);
        }
        Ok(page)
    }

    /// Bytes of record `id` from `offset` on.
    ///
    /// # Errors
    /// [`Refusal::RecordNotFound`], [`Refusal::OffsetOutOfRange`],
    /// [`Refusal::StorageFailed`].
    pub async fn read(&mut self, id: u32, offset: u32) -> Result<RecordPart, Refusal> {
        let total = match self.unpacked {
            Some((unpacked, total)) if unpacked == id => total,
            _ => self.unpack(id).await?,
        };
        let record = self.memory.scratch.get(..total as usize);
        let rest = record.and_then(|record| record.get(offset as usize..));
        let rest = rest.ok_or(Refusal::OffsetOutOfRange)?;
        let part = rest.get(..RECORD_CHUNK).unwrap_or(rest);
        let data = Vec::from_slice(part).map_err(|_| Refusal::StorageFailed)?;
        Ok(RecordPart { total, data })
    }

    /// How many stored records cannot be read to the byte.
    pub async fn unreadable(&mut self) -> u32 {
        let mut unreadable = 0;
        for place in 0..self.memory.directory.len() {
            let id = self.memory.directory.get(place).map(|entry| entry.id);
            if let Some(id) = id
                && self.unpack(id).await.is_err()
            {
                unreadable += 1;
            }
            // A sum takes a millisecond, and there may be thousands.
            yield_now().await;
        }
        unreadable
    }

    /// Puts a whole record into the scratch memory; its length.
    async fn unpack(&mut self, id: u32) -> Result<u32, Refusal> {
        self.unpacked = None;
        let failed = |_| Refusal::StorageFailed;
        let entry = find(self.memory.directory, id).ok_or(Refusal::RecordNotFound)?;
        let length = usize::from(entry.length);
        self.fetch(0..length, entry.address).await?;
        let item = self.memory.scratch.get(..length);
        let (_, rest) = item.and_then(mark_of).ok_or(Refusal::StorageFailed)?;
        let (head, body) = stored::head(rest).map_err(failed)?;
        let body_at = length - body.len();
        self.memory.scratch.copy_within(body_at..length, 0);
        let gap = stored::open_up(&head, self.memory.scratch).map_err(failed)?;
        if !gap.is_empty() {
            let sector = sector_of::<F>(entry.address);
            let settings = self.settings_address(sector, head.settings_mark, gap.len());
            let settings = settings.ok_or(Refusal::StorageFailed)?;
            self.fetch(gap, settings).await?;
        }
        let length = head.record_bytes();
        let record = self.memory.scratch.get(..length).unwrap_or_default();
        if digest(record) != head.sha256 {
            return Err(Refusal::StorageFailed);
        }
        self.unpacked = Some((id, length as u32));
        Ok(length as u32)
    }

    /// Where settings lie that a record shares with a state of its sector.
    fn settings_address(&self, sector: u32, mark: u32, length: usize) -> Option<u32> {
        let known = self.known_settings.find(sector, mark)?;
        (usize::from(known.length) == length).then_some(known.address)
    }

    /// Reads into a range of the scratch memory.
    async fn fetch(&mut self, range: Range<usize>, address: u32) -> Result<(), ArchiveError> {
        let bytes = self.memory.scratch.get_mut(range);
        read(
            &mut self.queue.flash().inner().0,
            address,
            bytes.ok_or(ArchiveError::TooLong)?,
        )
        .await
    }
}

fn find(directory: &Directory, id: u32) -> Option<Entry> {
    let index = directory.binary_search_by_key(&id, |entry| entry.id).ok()?;
    directory.get(index).copied()
}
