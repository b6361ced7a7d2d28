//! Which settings lie in which sector, for records that share them.
//!
//! A record may share settings only when the next start will find them as well. So of each sector the
//! first [`PER_SECTOR`] different settings count, in the order they lie in, however many follow: whoever
//! reads the sector comes to the same table.

use heapless::Vec;

use super::layout::SECTORS;

/// Different settings of a sector that are known.
const PER_SECTOR: usize = 8;
/// How many of them are noted as they are written. Fewer: what was written and could not be
/// verified may be found whole at the next start.
const PER_SECTOR_WRITTEN: usize = 6;

/// Settings that a state item of a sector holds.
#[derive(Clone, Copy, Debug)]
pub(super) struct Known {
    pub(super) sector: u32,
    pub(super) mark: u32,
    pub(super) address: u32,
    pub(super) length: u16,
}

/// The settings known of all sectors.
#[derive(Debug, Default)]
pub(super) struct KnownSettings(Vec<Known, { SECTORS * PER_SECTOR }>);

impl KnownSettings {
    /// Takes note of settings that were found.
    pub(super) fn found(&mut self, known: Known) {
        self.note(known, PER_SECTOR);
    }

    /// Takes note of settings that were written.
    pub(super) fn written(&mut self, known: Known) {
        self.note(known, PER_SECTOR_WRITTEN);
    }

    fn note(&mut self, known: Known, most: usize) {
        if self.find(known.sector, known.mark).is_none() && self.count(known.sector) < most {
            // There is room for every sector's share.
            let _ = self.0.push(known);
        }
    }

    /// Settings of `sector` with this mark.
    pub(super) fn find(&self, sector: u32, mark: u32) -> Option<&Known> {
        let mut all = self.0.iter();
        all.find(|known| known.sector == sector && known.mark == mark)
    }

    /// Whether no other settings of `sector` will be known.
    pub(super) fn is_full(&self, sector: u32) -> bool {
        self.count(sector) >= PER_SECTOR_WRITTEN
    }

    /// Forgets a sector that has been erased.
    pub(super) fn forget(&mut self, sector: u32) {
        self.0.retain(|known| known.sector != sector);
    }

    fn count(&self, sector: u32) -> usize {
        let all = self.0.iter();
        all.filter(|known| known.sector == sector).count()
    }
}
