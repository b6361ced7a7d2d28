//! The archive: records and settings in NOR flash.
//!
//! `sequential-storage` keeps a queue of items over all sectors of the record
//! area: it survives a power cut at any write, checks every item and uses the
//! sectors in turn, so they wear alike. On top of it, this module keeps a
//! directory in memory: a record is read from where it lies. [`layout`] has the form of an item.
//!
//! A sector stands alone: records share settings only with a state item of
//! their own sector, and a state item follows the first record of each. So
//! erasing the oldest sector loses its own records and nothing else, and there
//! are as many copies of the state as there are sectors in use.
//!
//! The log of a change of settings is a record too, always with its settings:
//! they are in force from it on, whether or not the state item behind it was
//! written.
//!
//! A power cut leaves words whose check bits do not fit, and a read of one fails
//! ([`CheckedFlash`]). Such a word counts as torn: [`sector`] shows it to the queue
//! as what no mark, head or check sum is, and nothing is ever programmed there.
//!
//! The area is a ring. A sector is only erased when the host has said that it
//! keeps every record in it ([`Archive::release`]); otherwise the area is full
//! and the next run is refused before it begins.

mod known;
mod layout;
mod located;
mod reading;
mod sector;
mod state;
mod writing;

#[cfg(test)]
mod tests;

pub use layout::{MAX_ITEM, SECTORS};
pub use located::LastAccess;
pub use sector::CheckedFlash;
pub use state::State;

use crate::device_key::DeviceKey;
use calib_core::settings::Settings;
use calib_core::stored_list::StoredLists;
use calib_protocol::lists::{self, KeptList};
use calib_protocol::message::Refusal;
use calib_protocol::provenance::LoggedChange;
use calib_protocol::record::{Record, RecordKind};
use calib_protocol::signature::{DeviceKey as PublicDeviceKey, Message, Signature};
use calib_protocol::stored::{self, settings_mark};
use core::ops::Range;
use embassy_futures::yield_now;
use embedded_storage_async::nor_flash::NorFlash;
use heapless::Vec;
use known::{Known, KnownSettings};
use layout::{RECORD_ITEM, STATE_ITEM, STATE_ITEM_1};
use located::Located;
use sector::Marked;
use sequential_storage::cache::page_pointers::ArrayPagePointers;
use sequential_storage::cache::page_states::ArrayPageStates;
use sequential_storage::cache::{Cache, Uncached};
use sequential_storage::queue::{QueueConfig, QueueStorage};
use state::Form;

/// Most records the directory holds: more than the shortest ones that fit.
pub const MAX_RECORDS: usize = 3072;

/// Where a record lies.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    id: u32,
    address: u32,
    length: u16,
}

/// Directory of all records, in rising running number.
pub type Directory = Vec<Entry, MAX_RECORDS>;

/// Memory of an archive, too large for a stack.
pub struct Memory<'m> {
    /// Every record.
    pub directory: &'m mut Directory,
    /// One item on its way from or to flash.
    pub scratch: &'m mut [u8; MAX_ITEM],
    /// The record to be stored.
    pub record: &'m mut Record,
    /// The lists a tap of the button may measure.
    pub lists: &'m mut StoredLists,
    /// Those before a change that may fail.
    pub lists_before: &'m mut StoredLists,
    /// Where the flash was used last.
    pub last_access: &'m LastAccess,
    /// Settings of an instrument that was never told any.
    pub factory: fn() -> Settings,
}

/// Why something could not be stored or read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ArchiveError {
    /// No room: download records and release them.
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
pub struct Archive<'m, F: CheckedFlash> {
    queue: QueueStorage<Located<'m, Marked<'m, F>>, PageCache>,
    memory: Memory<'m>,
    state: State,
    known_settings: KnownSettings,
    /// The settings stored last could not be read.
    settings_unreadable: bool,
    /// First byte behind the item written or found last; none yet: no sector.
    end: Option<u32>,
    /// Record whose full encoding is in the scratch memory, and its length.
    unpacked: Option<(u32, u32)>,
    /// Signs every record, once there is one.
    key: Option<DeviceKey>,
    /// The last signature, and what it is of.
    signed: Option<(Message, Signature)>,
}

impl<'m, F: CheckedFlash> Archive<'m, F> {
    /// Reads the whole area once.
    ///
    /// `area` is in offsets of the flash and must be [`SECTORS`] whole sectors.
    ///
    /// # Errors
    /// [`ArchiveError::Flash`] when the area cannot be read or repaired.
    pub async fn open(
        flash: F,
        area: Range<u32>,
        memory: Memory<'m>,
    ) -> Result<Self, ArchiveError> {
        let config = QueueConfig::try_new(area.clone()).map_err(|_| ArchiveError::Flash)?;
        let cache = Cache::new(ArrayPageStates::new(), ArrayPagePointers::new(), Uncached);
        let mut flash = Marked(flash, memory.last_access);
        let mended = sector::mend(&mut flash, area.clone()).await;
        mended.map_err(|_| ArchiveError::Flash)?;
        let flash = Located::new(flash, memory.last_access);
        let mut archive = Self {
            queue: QueueStorage::new(flash, config, cache),
            memory,
            state: State::default(),
            known_settings: KnownSettings::default(),
            settings_unreadable: false,
            end: None,
            unpacked: None,
            key: None,
            signed: None,
        };
        archive.scan().await?;
        archive.key = archive.state.secret().map(DeviceKey::new);
        Ok(archive)
    }

    async fn scan(&mut self) -> Result<(), ArchiveError> {
        self.memory.directory.clear();
        self.memory.lists.clear();
        let mut items = self.queue.iter().await?;
        while let Some(item) = items.next(self.memory.scratch).await? {
            // To read the whole area takes longer than others can wait.
            yield_now().await;
            let address = self.memory.last_access.read();
            let length = item.len() as u16;
            self.end = Some(end_of::<F>(address, length));
            if self.memory.last_access.met_poison() {
                // Its sum fits by chance: its store was cut off in its last word.
                continue;
            }
            match mark_of(&item) {
                Some((RECORD_ITEM, body)) => {
                    let Ok((head, body)) = stored::head(body) else {
                        continue;
                    };
                    let Ok(summary) = head.summary(body) else {
                        continue;
                    };
                    let (id, kind) = (summary.id, summary.kind);
                    let sector = sector_of::<F>(address);
                    let known = &self.known_settings;
                    if !head.with_settings && known.find(sector, head.settings_mark).is_none() {
                        // Its store was cut off before it came to its place.
                        continue;
                    }
                    self.state.note_record(id, head.sha256);
                    if kind == RecordKind::ReferenceChange
                        && let Some(settings) = head.settings_in(body)
                    {
                        let change = LoggedChange {
                            record_id: id,
                            unix_time_s: summary.unix_time_s,
                        };
                        let after = self.state.after(&settings, change, self.memory.factory);
                        self.state.change_settings(&settings, after);
                        self.settings_unreadable = false;
                    }
                    insert(
                        self.memory.directory,
                        Entry {
                            id,
                            address,
                            length,
                        },
                    );
                }
                Some((mark @ (STATE_ITEM | STATE_ITEM_1), body)) => {
                    let form = match mark {
                        STATE_ITEM_1 => Form::Plain,
                        _ => Form::Sections,
                    };
                    let Ok((state, range)) = State::read(form, body) else {
                        self.settings_unreadable = true;
                        continue;
                    };
                    self.settings_unreadable = false;
                    if let Some(content) = state::lists_in(form, body)
                        && lists::read(content, self.memory.lists).is_err()
                    {
                        self.memory.lists.clear();
                    }
                    let Some(settings) = body.get(range.clone()) else {
                        continue;
                    };
                    self.state.merge(state);
                    let before = item.len() - body.len() + range.start;
                    self.known_settings.found(Known {
                        sector: sector_of::<F>(address),
                        mark: settings_mark(settings),
                        address: address + before as u32,
                        length: settings.len() as u16,
                    });
                }
                _ => {}
            }
        }
        Ok(())
    }

    /// The newest settings, if any were ever stored.
    pub fn settings(&self) -> Option<&Settings> {
        self.state.settings()
    }

    /// Whether the settings stored last could not be read: [`Self::settings`] are
    /// older ones, or none.
    pub fn settings_are_unreadable(&self) -> bool {
        self.settings_unreadable
    }

    /// The public key of the instrument, once there is one.
    pub fn public_key(&self) -> Option<PublicDeviceKey> {
        let (key, secret) = (self.key.as_ref()?, self.state.secret()?);
        Some(PublicDeviceKey {
            public: key.public(),
            since: secret.since,
        })
    }

    /// The lists a tap of the button may measure.
    pub fn lists(&self) -> &StoredLists {
        self.memory.lists
    }

    /// The list at this place, from 0.
    pub fn list(&self, place: u8) -> Option<KeptList> {
        let list = self.lists().all().get(usize::from(place))?;
        Some(KeptList {
            list: list.clone(),
            chosen: self.lists().chosen() == Some(list),
        })
    }

    /// Running number the next record will have.
    pub fn next_id(&self) -> u32 {
        self.state.next_id()
    }

    /// Stored records.
    pub fn len(&self) -> u32 {
        self.memory.directory.len() as u32
    }

    /// Whether there is no record.
    pub fn is_empty(&self) -> bool {
        self.memory.directory.is_empty()
    }
}

/// Reads bytes from any address: the flash is mapped into memory.
///
/// # Errors
/// [`ArchiveError::Flash`], also when one of the words is poisoned.
async fn read<F: NorFlash>(
    flash: &mut F,
    address: u32,
    bytes: &mut [u8],
) -> Result<(), ArchiveError> {
    const { assert!(F::READ_SIZE == 1, "the archive reads single bytes") };
    let read = flash.read(address, bytes).await;
    read.map_err(|_| ArchiveError::Flash)
}

fn mark_of(item: &[u8]) -> Option<(u16, &[u8])> {
    let (mark, body) = item.split_first_chunk::<2>()?;
    Some((u16::from_le_bytes(*mark), body))
}

fn sector_of<F: NorFlash>(address: u32) -> u32 {
    address / F::ERASE_SIZE as u32
}

/// First byte behind the item whose data begin at `address`.
fn end_of<F: NorFlash>(address: u32, length: u16) -> u32 {
    address + u32::from(length).next_multiple_of(F::WRITE_SIZE as u32)
}

/// Adds an entry in its place; a record found again replaces the one before.
fn insert(directory: &mut Directory, entry: Entry) {
    match directory.binary_search_by_key(&entry.id, |entry| entry.id) {
        Ok(index) => {
            if let Some(before) = directory.get_mut(index) {
                *before = entry;
            }
        }
        // The directory holds more than the area; `store` checks as well.
        Err(index) => {
            let _ = directory.insert(index, entry);
        }
    }
}
