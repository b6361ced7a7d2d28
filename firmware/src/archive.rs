//! The archive: records and settings in NOR flash, append only.
//!
//! `sequential-storage` keeps a queue of items over all sectors of the record
//! area: it survives a power cut at any write, checks every item and uses the
//! sectors in turn. On top of it, this module keeps a directory in memory, so
//! that listing costs nothing and a record is read from where it lies.
//!
//! | bytes of an item | content |
//! |---|---|
//! | 2 | u16 LE: below 0x8000 a record version, else 0x8000 + settings version |
//! | n | the rest of a stored record, or postcard [`Settings`] |
//!
//! Nothing is ever removed: when the area is full, the next run is refused.

mod located;

pub use located::LastAccess;

use crate::command::{RecordPage, RecordPart};
use calib_core::settings::Settings;
use calib_core::verdict::Verdict;
use calib_protocol::message::{RECORD_CHUNK, Refusal};
use calib_protocol::record::{self, Record, RecordSummary};
use embedded_storage_async::nor_flash::{NorFlash, ReadNorFlash};
use heapless::Vec;
use located::Located;
use sequential_storage::cache::page_pointers::ArrayPagePointers;
use sequential_storage::cache::page_states::ArrayPageStates;
use sequential_storage::cache::{Cache, Uncached};
use sequential_storage::queue::{QueueConfig, QueueStorage};

/// Sectors of the record area.
pub const SECTORS: usize = 8;
/// Most records the directory holds; the area takes some 500 of 31 points.
pub const MAX_RECORDS: usize = 1024;
/// Longest item: a record of the most points with the fullest settings.
pub const MAX_ITEM: usize = 24 * 1024;

const SETTINGS_MARK: u16 = 0x8000;
const SETTINGS_VERSION: u16 = 1;

/// Where a record lies.
#[derive(Clone, Debug)]
pub struct Entry {
    summary: RecordSummary,
    address: u32,
}

/// Directory of all records, in rising running number.
pub type Directory = Vec<Entry, MAX_RECORDS>;

/// Memory of an archive, too large for a stack.
pub struct Memory {
    /// Every record.
    pub directory: &'static mut Directory,
    /// One item on its way from or to flash.
    pub scratch: &'static mut [u8; MAX_ITEM],
    /// Where the flash was used last.
    pub last_access: &'static LastAccess,
}

/// Why something could not be stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ArchiveError {
    /// No room: neither in flash nor in the directory.
    Full,
    /// The item is longer than [`MAX_ITEM`].
    TooLong,
    /// The flash failed, or did not hold what was written.
    Flash,
}

impl From<ArchiveError> for Refusal {
    fn from(error: ArchiveError) -> Self {
        match error {
            ArchiveError::Full => Self::StorageFull,
            ArchiveError::TooLong | ArchiveError::Flash => Self::StorageFailed,
        }
    }
}

impl core::fmt::Display for ArchiveError {
    fn fmt(&self, formatter: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        formatter.write_str(match self {
            Self::Full => "the record area is full",
            Self::TooLong => "the record is too long to be stored",
            Self::Flash => "the flash failed",
        })
    }
}

impl core::error::Error for ArchiveError {}

impl<E> From<sequential_storage::Error<E>> for ArchiveError {
    fn from(error: sequential_storage::Error<E>) -> Self {
        match error {
            sequential_storage::Error::FullStorage => Self::Full,
            sequential_storage::Error::ItemTooBig => Self::TooLong,
            _ => Self::Flash,
        }
    }
}

type PageCache = Cache<ArrayPageStates<SECTORS>, ArrayPagePointers<SECTORS>, Uncached>;

/// Records and settings in flash.
pub struct Archive<F: NorFlash> {
    queue: QueueStorage<Located<F>, PageCache>,
    memory: Memory,
    next_id: u32,
}

impl<F: NorFlash> Archive<F> {
    /// Reads the whole area once; returns the archive and the newest settings.
    ///
    /// `area` is in offsets of the flash and must be whole sectors.
    ///
    /// # Errors
    /// [`ArchiveError::Flash`] when the area cannot be read or repaired.
    pub async fn open(
        flash: F,
        area: core::ops::Range<u32>,
        memory: Memory,
    ) -> Result<(Self, Option<Settings>), ArchiveError> {
        let config = QueueConfig::try_new(area).map_err(|_| ArchiveError::Flash)?;
        let cache = Cache::new(ArrayPageStates::new(), ArrayPagePointers::new(), Uncached);
        let flash = Located::new(flash, memory.last_access);
        let mut archive = Self {
            queue: QueueStorage::new(flash, config, cache),
            memory,
            next_id: 1,
        };
        let settings = archive.scan().await?;
        Ok((archive, settings))
    }

    async fn scan(&mut self) -> Result<Option<Settings>, ArchiveError> {
        let mut settings = None;
        self.memory.directory.clear();
        let mut items = self.queue.iter().await?;
        while let Some(item) = items.next(self.memory.scratch).await? {
            let address = self.memory.last_access.read();
            if let Ok(summary) = record::summarise(&item) {
                self.next_id = self.next_id.max(summary.id.saturating_add(1));
                // A fuller area than the directory holds cannot come about:
                // `store` refuses before.
                let _ = self.memory.directory.push(Entry { summary, address });
            } else if let Some(found) = settings_of(&item) {
                settings = Some(found);
            }
        }
        Ok(settings)
    }

    /// Running number the next record will have.
    pub fn next_id(&self) -> u32 {
        self.next_id
    }

    /// Stored records.
    pub fn len(&self) -> u32 {
        self.memory.directory.len() as u32
    }

    /// Whether there is no record.
    pub fn is_empty(&self) -> bool {
        self.memory.directory.is_empty()
    }

    /// Whether a record of `bytes` will find room.
    ///
    /// # Errors
    /// [`ArchiveError::Full`] when not, so that nothing is measured in vain.
    pub async fn check_room(&mut self, bytes: usize) -> Result<(), ArchiveError> {
        let fit = self.queue.find_max_fit().await?;
        let room = fit.is_some_and(|largest| largest as usize >= bytes);
        if !room || self.memory.directory.is_full() {
            return Err(ArchiveError::Full);
        }
        Ok(())
    }

    /// Stores a record, which must carry [`Self::next_id`], and reads it back.
    ///
    /// # Errors
    /// See [`ArchiveError`]; the record is then not in the directory.
    pub async fn store(&mut self, record: &Record) -> Result<(), ArchiveError> {
        if self.memory.directory.is_full() {
            return Err(ArchiveError::Full);
        }
        let length =
            record::encode(record, self.memory.scratch).map_err(|_| ArchiveError::TooLong)?;
        let address = self.push(length).await?;
        let summary = summary_of(record, length);
        self.next_id = self.next_id.max(record.id.saturating_add(1));
        self.memory
            .directory
            .push(Entry { summary, address })
            .map_err(|_| ArchiveError::Full)
    }

    /// Stores settings, twice: one damaged item never loses them.
    ///
    /// # Errors
    /// See [`ArchiveError`].
    pub async fn store_settings(&mut self, settings: &Settings) -> Result<(), ArchiveError> {
        for _copy in 0..2 {
            let (mark, rest) = self.memory.scratch.split_at_mut(2);
            mark.copy_from_slice(&(SETTINGS_MARK | SETTINGS_VERSION).to_le_bytes());
            let body = postcard::to_slice(settings, rest).map_err(|_| ArchiveError::TooLong)?;
            let length = 2 + body.len();
            self.push(length).await?;
        }
        Ok(())
    }

    /// Appends the first `length` bytes of the scratch memory; where they lie.
    async fn push(&mut self, length: usize) -> Result<u32, ArchiveError> {
        let item = self
            .memory
            .scratch
            .get(..length)
            .ok_or(ArchiveError::TooLong)?;
        self.memory.last_access.forget_writes();
        self.queue.push(item, false).await?;
        let address = self.memory.last_access.longest_write();
        self.verify(address, length).await?;
        Ok(address)
    }

    /// Compares flash with the scratch memory.
    async fn verify(&mut self, address: u32, length: usize) -> Result<(), ArchiveError> {
        let written = self
            .memory
            .scratch
            .get(..length)
            .ok_or(ArchiveError::TooLong)?;
        let mut at = address;
        for expected in written.chunks(64) {
            let mut found = [0; 64];
            let found = found
                .get_mut(..expected.len())
                .ok_or(ArchiveError::TooLong)?;
            read_unaligned(self.queue.flash(), at, found).await?;
            if found != expected {
                return Err(ArchiveError::Flash);
            }
            at += 64;
        }
        Ok(())
    }

    /// Summaries from running number `from` on.
    pub fn page(&self, from: u32) -> RecordPage {
        let directory = &self.memory.directory;
        let start = directory.partition_point(|entry| entry.summary.id < from);
        let rest = directory.get(start..).unwrap_or_default();
        let mut page = RecordPage::default();
        for entry in rest {
            if page.records.push(entry.summary.clone()).is_err() {
                page.more = true;
                break;
            }
        }
        page
    }

    /// Bytes of record `id` from `offset` on.
    ///
    /// # Errors
    /// [`Refusal::RecordNotFound`], [`Refusal::OffsetOutOfRange`],
    /// [`Refusal::StorageFailed`].
    pub async fn read(&mut self, id: u32, offset: u32) -> Result<RecordPart, Refusal> {
        let directory = &self.memory.directory;
        let entry = directory
            .binary_search_by_key(&id, |entry| entry.summary.id)
            .ok()
            .and_then(|index| directory.get(index))
            .ok_or(Refusal::RecordNotFound)?;
        let (total, address) = (entry.summary.bytes, entry.address);
        let rest = total.checked_sub(offset).ok_or(Refusal::OffsetOutOfRange)?;
        let mut data = Vec::new();
        data.resize(RECORD_CHUNK.min(rest as usize), 0)
            .map_err(|_| Refusal::StorageFailed)?;
        read_unaligned(self.queue.flash(), address + offset, &mut data)
            .await
            .map_err(Refusal::from)?;
        Ok(RecordPart { total, data })
    }
}

/// Reads bytes from any address of memory-mapped flash.
async fn read_unaligned<F: ReadNorFlash>(
    flash: &mut F,
    address: u32,
    bytes: &mut [u8],
) -> Result<(), ArchiveError> {
    const { assert!(F::READ_SIZE == 1, "the archive reads single bytes") };
    flash
        .read(address, bytes)
        .await
        .map_err(|_| ArchiveError::Flash)
}

fn mark_of(item: &[u8]) -> Option<(u16, &[u8])> {
    let (mark, body) = item.split_first_chunk::<2>()?;
    Some((u16::from_le_bytes(*mark), body))
}

fn settings_of(item: &[u8]) -> Option<Settings> {
    let (mark, body) = mark_of(item)?;
    if mark != SETTINGS_MARK | SETTINGS_VERSION {
        return None;
    }
    postcard::from_bytes(body).ok()
}

fn summary_of(record: &Record, length: usize) -> RecordSummary {
    let refused = |point: &&calib_core::point::PointResult| point.verdict != Verdict::Pass;
    RecordSummary {
        id: record.id,
        bytes: length as u32,
        unix_time_s: record.labels.unix_time_s,
        dut_serial: record.labels.dut_serial.clone(),
        points: record.points.len() as u16,
        refused: record.points.iter().filter(refused).count() as u16,
    }
}
