//! What the instrument must not forget, beside its records.

use calib_core::settings::Settings;
use calib_protocol::record::Sha256Sum;
use postcard::{take_from_bytes, to_slice};

/// Settings, running number, chain and release.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct State {
    /// Records up to this number may make room.
    released: u32,
    /// Highest running number ever given.
    last_id: u32,
    /// SHA-256 of the record with that number.
    last_sha256: Sha256Sum,
    settings: Option<Settings>,
}

/// The part of a state item before the settings.
type Head = (u32, u32, Sha256Sum);

impl State {
    /// The settings in force.
    pub fn settings(&self) -> Option<&Settings> {
        self.settings.as_ref()
    }

    pub(super) fn set_settings(&mut self, settings: &Settings) {
        self.settings = Some(settings.clone());
    }

    /// Records up to this running number may make room.
    pub fn released(&self) -> u32 {
        self.released
    }

    /// Takes note of what a host keeps; what does not exist cannot be kept.
    pub(super) fn release(&mut self, through: u32) {
        self.released = self.released.max(through.min(self.last_id));
    }

    pub(super) fn next_id(&self) -> u32 {
        self.last_id.saturating_add(1)
    }

    pub(super) fn last_sha256(&self) -> Sha256Sum {
        self.last_sha256
    }

    /// Takes note of a stored record.
    pub(super) fn note_record(&mut self, id: u32, sha256: Sha256Sum) {
        if id >= self.last_id {
            (self.last_id, self.last_sha256) = (id, sha256);
        }
    }

    /// Takes note of a state found later in the queue.
    pub(super) fn merge(&mut self, newer: Self) {
        self.released = self.released.max(newer.released);
        self.note_record(newer.last_id, newer.last_sha256);
        self.settings = newer.settings.or(self.settings.take());
    }

    /// Reads an item; the bytes of the settings are returned as well.
    pub(super) fn read(bytes: &[u8]) -> Option<(Self, &[u8])> {
        let ((released, last_id, last_sha256), settings_bytes) =
            take_from_bytes::<Head>(bytes).ok()?;
        let settings = postcard::from_bytes(settings_bytes).ok()?;
        let state = Self {
            released,
            last_id,
            last_sha256,
            settings: Some(settings),
        };
        Some((state, settings_bytes))
    }

    /// Writes an item; where its settings begin, and its length.
    pub(super) fn write(&self, buffer: &mut [u8]) -> Option<(usize, usize)> {
        let settings = self.settings.as_ref()?;
        let head: Head = (self.released, self.last_id, self.last_sha256);
        let start = to_slice(&head, buffer).ok()?.len();
        let length = to_slice(settings, buffer.get_mut(start..)?).ok()?.len();
        Some((start, start + length))
    }
}
