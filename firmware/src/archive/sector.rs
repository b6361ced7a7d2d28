//! Sector marks on flash whose words can be programmed only once.
//!
//! The queue marks a sector as begun by its first word and as closed by its
//! last. It takes a mark that was cut off for no mark and would program the
//! word again, which this flash forbids: its check bits are fixed by the first
//! write (RM0433 Rev 8, 4.3.9). Here a mark is there as soon as any bit of it
//! is, and is written once.
//!
//! An erase that was cut off can leave any part of a sector erased. [`mend`]
//! finds what no finished operation leaves behind and erases it again:
//!
//! | first word | last word | between | |
//! |---|---|---|---|
//! | erased | erased | erased | free |
//! | erased | any | any | erase was cut off |
//! | partly programmed | any | any | erase or mark was cut off |
//! | marked | erased | any | in use; a second one just behind it: cut off |
//! | marked | marked | any | closed |
//!
//! A word that cannot be read counts as programmed, and as torn where that is asked: a mark in it is
//! there, a sector with one is not free, and what of it belongs to an item is [`POISON`].
//!
//! Since a first word that is partly programmed is erased at once, none has anything behind it that
//! counts. What an erase has just begun to damage keeps its marks and is told by its checks; what
//! looks like the head of an item longer than any is none ([`Marked::read`]).

use super::layout::MAX_ITEM;
use super::located::LastAccess;
use core::ops::Range;
use embassy_futures::yield_now;
use embedded_storage_async::nor_flash::{ErrorType, NorFlash, ReadNorFlash};

/// Longest word that is handled.
const MAX_WORD: usize = 32;

/// Every byte of a poisoned word, for the queue. As a head it says that the item is longer than any
/// (54 741 bytes), so it is refused; as data it fails the item's CRC-32, unless that is what the item
/// was to hold there, which one byte in the last word easily is: [`LastAccess`] tells.
const POISON: u8 = 0xD5;
const _: () = assert!(u16::from_le_bytes([POISON; 2]) as usize > MAX_ITEM);

/// Flash whose words carry check bits, read in a way that survives where they do not fit.
pub trait CheckedFlash: NorFlash {
    /// Whether a read failed because the check bits of a word do not fit, and for no other reason:
    /// its programming or the erase of its sector was cut. Nothing but an erase changes that, and a
    /// word like this must not be programmed.
    fn is_poisoned(error: &Self::Error) -> bool;
}

/// `F` with marks that are never torn.
pub(super) struct Marked<'l, F>(pub(super) F, pub(super) &'l LastAccess);

impl<F: CheckedFlash> Marked<'_, F> {
    /// Whether these bytes lie in the first or last word of a sector.
    fn is_mark(offset: u32, length: usize) -> bool {
        let within = offset as usize % F::ERASE_SIZE;
        let in_first = within + length <= F::WRITE_SIZE;
        let in_last = within >= F::ERASE_SIZE - F::WRITE_SIZE;
        length <= F::WRITE_SIZE && (in_first || in_last)
    }

    /// Whether any bit of the word around `offset` is programmed.
    async fn is_programmed(&mut self, offset: u32) -> Result<bool, F::Error> {
        let found = self.word(offset).await?;
        Ok(found.is_none_or(|(word, length)| word.iter().take(length).any(|byte| *byte != 0xFF)))
    }

    /// Whether some bits of that word are programmed and others are not: marks are all zeros.
    async fn is_torn(&mut self, offset: u32) -> Result<bool, F::Error> {
        let found = self.word(offset).await?;
        Ok(found.is_none_or(|(word, length)| {
            let ones: u32 = word.iter().take(length).map(|byte| byte.count_ones()).sum();
            ones != 0 && ones != 8 * length as u32
        }))
    }

    /// The word around `offset` and its length; none when it is poisoned.
    async fn word(&mut self, offset: u32) -> Result<Option<([u8; MAX_WORD], usize)>, F::Error> {
        const { assert!(F::WRITE_SIZE <= MAX_WORD) };
        let mut word = [0; MAX_WORD];
        let start = offset - offset % F::WRITE_SIZE as u32;
        let bytes = word.split_at_mut(F::WRITE_SIZE).0;
        let read = self.0.read(start, bytes).await;
        Ok(is_readable::<F>(read)?.then_some((word, F::WRITE_SIZE)))
    }

    /// Reads what is not a mark; poisoned words read as [`POISON`].
    async fn read_content(&mut self, offset: u32, bytes: &mut [u8]) -> Result<(), F::Error> {
        let read = self.0.read(offset, bytes).await;
        let readable = is_readable::<F>(read)?;
        self.1.note_poison(!readable);
        if readable {
            return Ok(());
        }
        let mut at = offset;
        let mut rest = bytes;
        while !rest.is_empty() {
            let to_end_of_word = F::WRITE_SIZE - at as usize % F::WRITE_SIZE;
            let (part, behind) = rest.split_at_mut(to_end_of_word.min(rest.len()));
            let read = self.0.read(at, part).await;
            if !is_readable::<F>(read)? {
                part.fill(POISON);
            }
            at += part.len() as u32;
            rest = behind;
        }
        Ok(())
    }
}

/// Whether a read gave bytes; false when it met a poisoned word.
fn is_readable<F: CheckedFlash>(read: Result<(), F::Error>) -> Result<bool, F::Error> {
    match read {
        Ok(()) => Ok(true),
        Err(error) if F::is_poisoned(&error) => Ok(false),
        Err(error) => Err(error),
    }
}

impl<F: ErrorType> ErrorType for Marked<'_, F> {
    type Error = F::Error;
}

impl<F: CheckedFlash> ReadNorFlash for Marked<'_, F> {
    const READ_SIZE: usize = F::READ_SIZE;

    async fn read(&mut self, offset: u32, bytes: &mut [u8]) -> Result<(), F::Error> {
        if !Self::is_mark(offset, bytes.len()) {
            self.read_content(offset, bytes).await?;
            if bytes.len() == F::WRITE_SIZE {
                refuse_too_long(bytes);
            }
            return Ok(());
        }
        let programmed = self.is_programmed(offset).await?;
        bytes.fill(if programmed { 0 } else { 0xFF });
        Ok(())
    }

    fn capacity(&self) -> usize {
        self.0.capacity()
    }
}

impl<F: CheckedFlash> NorFlash for Marked<'_, F> {
    const WRITE_SIZE: usize = F::WRITE_SIZE;
    const ERASE_SIZE: usize = F::ERASE_SIZE;

    async fn erase(&mut self, from: u32, to: u32) -> Result<(), F::Error> {
        self.0.erase(from, to).await
    }

    async fn write(&mut self, offset: u32, bytes: &[u8]) -> Result<(), F::Error> {
        if Self::is_mark(offset, bytes.len()) && self.is_programmed(offset).await? {
            return Ok(());
        }
        self.0.write(offset, bytes).await
    }
}

/// The queue reads heads of items as single words: CRC-32 of the data, length, CRC-16 of the length.
/// Of the words of a torn sector, one in 65 536 has the right CRC-16; the queue gives up when such
/// a length is more than its caller has room for. The CRC-16 here is one that no length has.
fn refuse_too_long(word: &mut [u8]) {
    let length = word.get(4..6).and_then(|field| field.try_into().ok());
    let is_erased = word.iter().all(|byte| *byte == 0xFF);
    if !is_erased && length.is_some_and(|field| usize::from(u16::from_le_bytes(field)) > MAX_ITEM) {
        word.fill(0);
        word.iter_mut()
            .skip(6)
            .take(2)
            .for_each(|byte| *byte = 0xFF);
    }
}

/// State of a sector by its marks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Sector {
    Free,
    Torn,
    InUse,
    Closed,
}

/// Erases again what a power cut left half erased.
pub(super) async fn mend<F: CheckedFlash>(
    flash: &mut Marked<'_, F>,
    area: Range<u32>,
) -> Result<(), F::Error> {
    let size = F::ERASE_SIZE as u32;
    let sectors = (area.end - area.start) / size;
    let mut before = classify(flash, area.end - size).await?;
    for sector in 0..sectors {
        let start = area.start + sector * size;
        let mut found = classify(flash, start).await?;
        let doubled = found == Sector::InUse && before == Sector::InUse;
        if doubled || found == Sector::Torn {
            flash.erase(start, start + size).await?;
            found = Sector::Free;
        }
        before = found;
    }
    Ok(())
}

async fn classify<F: CheckedFlash>(
    flash: &mut Marked<'_, F>,
    start: u32,
) -> Result<Sector, F::Error> {
    let size = F::ERASE_SIZE as u32;
    let last = start + size - F::WRITE_SIZE as u32;
    if flash.is_torn(start).await? {
        return Ok(Sector::Torn);
    }
    let begun = flash.is_programmed(start).await?;
    let closed = flash.is_programmed(last).await?;
    Ok(match (begun, closed) {
        (true, true) => Sector::Closed,
        (true, false) => Sector::InUse,
        (false, false) if is_blank(flash, start..start + size).await? => Sector::Free,
        (false, _) => Sector::Torn,
    })
}

async fn is_blank<F: CheckedFlash>(
    flash: &mut Marked<'_, F>,
    range: Range<u32>,
) -> Result<bool, F::Error> {
    let mut bytes = [0; 256];
    for start in range.step_by(bytes.len()) {
        // A blank area is read whole at every start, and others have to run meanwhile.
        yield_now().await;
        let read = flash.0.read(start, &mut bytes).await;
        if !is_readable::<F>(read)? || bytes.iter().any(|byte| *byte != 0xFF) {
            return Ok(false);
        }
    }
    Ok(true)
}
