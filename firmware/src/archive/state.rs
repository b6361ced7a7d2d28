//! State the instrument must not forget, beside its records.

use crate::device_key::Secret;
use calib_core::settings::Settings;
use calib_core::stored_list::StoredLists;
use calib_protocol::form1;
use calib_protocol::lists;
use calib_protocol::provenance::{LoggedChange, Provenance, settings_digest};
use calib_protocol::record::{RecordError, Sha256Sum};
use calib_protocol::sections::{Fields, find, needed, section};
use calib_protocol::settings_form::{self, InSections};
use core::ops::Range;
use serde::{Serialize, Serializer};

/// Settings, running number, hash chain and release.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct State {
    /// Records up to this number may make room.
    released: u32,
    /// Highest running number ever given.
    last_id: u32,
    /// SHA-256 of the record with that number.
    last_sha256: Sha256Sum,
    settings: Option<Settings>,
    /// Where they come from; its digest of them is taken anew for each record.
    provenance: Provenance,
    /// Secret of the key of the instrument.
    secret: Option<Secret>,
}

/// Released, last number, its SHA-256.
type Counters = (u32, u32, Sha256Sum);

const COUNTERS: u8 = 1;
const SETTINGS: u8 = 2;
const PROVENANCE: u8 = 3;
const SECRET: u8 = 4;
const LISTS: u8 = 5;

/// How a state item is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Form {
    /// Version 1: [`Counters`], then settings of version 1. Read, and written no more.
    Plain,
    /// Version 2: sections 1, [`Counters`], 2, settings, 3, [`Provenance`], 4, [`Secret`], where there is one,
    /// and 5, [`lists`].
    Sections,
}

impl State {
    /// The settings in force.
    pub fn settings(&self) -> Option<&Settings> {
        self.settings.as_ref()
    }

    pub(super) fn set_settings(&mut self, settings: &Settings) {
        self.settings = Some(settings.clone());
    }

    /// Takes a change that is logged into force.
    pub(super) fn change_settings(&mut self, settings: &Settings, provenance: Provenance) {
        self.provenance = provenance;
        self.set_settings(settings);
    }

    /// Provenance of settings that `change` brings into force; before any, those of `factory` are.
    pub(super) fn after(
        &self,
        settings: &Settings,
        change: LoggedChange,
        factory: fn() -> Settings,
    ) -> Provenance {
        let mut after = self.provenance(settings);
        let of_reference = match &self.settings {
            Some(before) => !settings.has_reference_channel_of(before),
            None => !settings.has_reference_channel_of(&factory()),
        };
        after.changed = change;
        if of_reference {
            after.reference_changed = change;
            after.sha256_at_reference = after.sha256;
        }
        after
    }

    /// Provenance of a record that is made with `settings`.
    pub(super) fn provenance(&self, settings: &Settings) -> Provenance {
        Provenance {
            sha256: settings_digest(settings),
            ..self.provenance
        }
    }

    /// Secret of the key, once there is one.
    pub(super) fn secret(&self) -> Option<&Secret> {
        self.secret.as_ref()
    }

    pub(super) fn set_secret(&mut self, secret: Option<Secret>) {
        self.secret = secret;
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
        self.secret = newer.secret.or(self.secret.take());
        // A release without it wrote none.
        if newer.provenance.changed.record_id > self.provenance.changed.record_id {
            self.provenance = newer.provenance;
        }
    }

    /// Reads an item; where its settings lie is returned as well.
    pub(super) fn read(form: Form, bytes: &[u8]) -> Result<(Self, Range<usize>), RecordError> {
        let mut settings = Settings::BLANK;
        let (counters, range) = match form {
            Form::Plain => {
                let mut fields = Fields(bytes);
                let counters: Counters = fields.take()?;
                form1::read_settings(fields.0, &mut settings)?;
                (counters, bytes.len() - fields.0.len()..bytes.len())
            }
            Form::Sections => {
                let counters = needed(bytes, COUNTERS)?.take()?;
                let (at, content) = find(bytes, SETTINGS, 1)?.ok_or(RecordError::Content)?;
                settings_form::read(content, &mut settings)?;
                (counters, at..at + content.len())
            }
        };
        let added = |id| match form {
            Form::Plain => Ok(None),
            Form::Sections => find(bytes, id, 1),
        };
        let provenance = added(PROVENANCE)?.map(|(_, content)| Fields(content).take());
        let secret = added(SECRET)?.map(|(_, content)| Fields(content).take());
        let (released, last_id, last_sha256) = counters;
        let state = Self {
            released,
            last_id,
            last_sha256,
            settings: Some(settings),
            provenance: provenance.transpose()?.unwrap_or_default(),
            secret: secret.transpose()?,
        };
        Ok((state, range))
    }

    /// Writes an item of version 2, with these lists; where its settings lie, and its length.
    pub(super) fn write(
        &self,
        lists: &StoredLists,
        buffer: &mut [u8],
    ) -> Option<(Range<usize>, usize)> {
        let settings = InSections(self.settings.as_ref()?);
        let counters: Counters = (self.released, self.last_id, self.last_sha256);
        let content = (
            section(COUNTERS, counters),
            section(SETTINGS, settings),
            section(PROVENANCE, self.provenance),
            OfKey(self.secret.as_ref()),
            // Also where there are none: none may be left.
            section(LISTS, lists::InSections(lists)),
        );
        let written = postcard::to_slice(&content, buffer).ok()?;
        let (at, settings) = find(written, SETTINGS, 1).ok()??;
        Some((at..at + settings.len(), written.len()))
    }
}

/// The lists in an item; none in one of a release that knew of none.
pub(super) fn lists_in(form: Form, bytes: &[u8]) -> Option<&[u8]> {
    match form {
        Form::Plain => None,
        Form::Sections => Some(find(bytes, LISTS, 1).ok()??.1),
    }
}

/// The section of the secret; none where there is no key.
struct OfKey<'a>(Option<&'a Secret>);

impl Serialize for OfKey<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.0 {
            None => ().serialize(serializer),
            Some(secret) => section(SECRET, secret).serialize(serializer),
        }
    }
}
