//! Flash that remembers where it was used last.
//!
//! The queue does not say where an item lies; the address of its data is the
//! start of the last read, or of the longest write of a push. The archive
//! compares before it believes.

use core::sync::atomic::{AtomicBool, AtomicU32, Ordering};
use embedded_storage_async::nor_flash::{ErrorType, NorFlash, ReadNorFlash};

/// Where flash was read last, and where the longest write began.
#[derive(Debug, Default)]
pub struct LastAccess {
    read: AtomicU32,
    write: AtomicU32,
    write_length: AtomicU32,
    /// The last read met a word that cannot be read.
    met_poison: AtomicBool,
}

impl LastAccess {
    /// No access yet.
    pub const fn new() -> Self {
        Self {
            read: AtomicU32::new(0),
            write: AtomicU32::new(0),
            write_length: AtomicU32::new(0),
            met_poison: AtomicBool::new(false),
        }
    }

    /// Start of the last read.
    pub(super) fn read(&self) -> u32 {
        self.read.load(Ordering::Relaxed)
    }

    /// Start of the longest write since [`Self::forget_writes`].
    pub(super) fn longest_write(&self) -> u32 {
        self.write.load(Ordering::Relaxed)
    }

    pub(super) fn forget_writes(&self) {
        self.write_length.store(0, Ordering::Relaxed);
    }

    /// Whether the last read met a word that cannot be read.
    pub(super) fn met_poison(&self) -> bool {
        self.met_poison.load(Ordering::Relaxed)
    }

    pub(super) fn note_poison(&self, met: bool) {
        self.met_poison.store(met, Ordering::Relaxed);
    }

    fn note_read(&self, offset: u32) {
        self.read.store(offset, Ordering::Relaxed);
    }

    fn note_write(&self, offset: u32, length: u32) {
        if length > self.write_length.load(Ordering::Relaxed) {
            self.write.store(offset, Ordering::Relaxed);
            self.write_length.store(length, Ordering::Relaxed);
        }
    }
}

/// `F`, with its accesses noted.
pub(super) struct Located<'l, F> {
    flash: F,
    last: &'l LastAccess,
}

impl<'l, F> Located<'l, F> {
    pub(super) fn new(flash: F, last: &'l LastAccess) -> Self {
        Self { flash, last }
    }

    /// The flash itself; what is done with it is not noted.
    pub(super) fn inner(&mut self) -> &mut F {
        &mut self.flash
    }
}

impl<F: ErrorType> ErrorType for Located<'_, F> {
    type Error = F::Error;
}

impl<F: ReadNorFlash> ReadNorFlash for Located<'_, F> {
    const READ_SIZE: usize = F::READ_SIZE;

    async fn read(&mut self, offset: u32, bytes: &mut [u8]) -> Result<(), F::Error> {
        self.last.note_read(offset);
        self.flash.read(offset, bytes).await
    }

    fn capacity(&self) -> usize {
        self.flash.capacity()
    }
}

impl<F: NorFlash> NorFlash for Located<'_, F> {
    const WRITE_SIZE: usize = F::WRITE_SIZE;
    const ERASE_SIZE: usize = F::ERASE_SIZE;

    async fn erase(&mut self, from: u32, to: u32) -> Result<(), F::Error> {
        self.flash.erase(from, to).await
    }

    async fn write(&mut self, offset: u32, bytes: &[u8]) -> Result<(), F::Error> {
        self.last.note_write(offset, bytes.len() as u32);
        self.flash.write(offset, bytes).await
    }
}
