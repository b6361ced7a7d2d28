//! Lists kept on the instrument: asked for one by one, changed one by one, stored all together.
//!
//! | id | section of what is stored | fields |
//! |---|---|---|
//! | 1 | choice | name of the list that a tap of the button measures; empty: none |
//! | 2 | a list, once for each | [`StoredList`] |
//!
//! A list that only a newer release can read is passed over, and so is the choice of it.

use crate::error::RecordError;
use crate::sections::{Fields, Read, section};
use crate::text::{is_plain, tame};
use calib_core::stored_list::{ListTerms, NoPlace, StoredList, StoredLists};
use heapless::String;
use postcard::take_from_bytes;
use serde::de::Error;
use serde::ser::SerializeTuple;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

const CHOICE: u8 = 1;
const LIST: u8 = 2;

/// A list, and whether a tap of the button measures it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct KeptList {
    /// The list.
    #[serde(with = "one")]
    pub list: StoredList,
    /// It is the chosen one.
    pub chosen: bool,
}

/// A change of the lists. One that leaves them other than before needs the button held.
// It is built once and encoded: its size never matters.
#[allow(clippy::large_enum_variant)]
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum ListChange {
    /// Store a list, in place of the one of its name if there is one.
    Store(#[serde(with = "one")] StoredList),
    /// Remove the list of this name.
    Remove {
        /// Its name.
        name: String<24>,
    },
    /// Have a tap of the button measure the list of this name; with an empty one, the default list.
    Choose {
        /// Its name.
        name: String<24>,
    },
}

impl ListChange {
    /// Whether what is to be stored can be measured and judged, and its texts are words of one line.
    pub fn is_usable(&self) -> bool {
        match self {
            Self::Store(list) => {
                let terms = &list.terms;
                // A name stands between quotes, and in a line of commands.
                let nameable = !terms.name.contains(['"', '\'', ';']);
                list.is_usable() && nameable && is_plain(&terms.name) && is_plain(&terms.unit)
            }
            Self::Remove { .. } | Self::Choose { .. } => true,
        }
    }

    /// Whether the lists are as they would be after it.
    pub fn is_done_in(&self, lists: &StoredLists) -> bool {
        match self {
            Self::Store(list) => lists.find(&list.terms.name) == Some(list),
            Self::Remove { .. } => false,
            Self::Choose { name } => {
                let chosen = lists.chosen().map(|list| list.terms.name.as_str());
                chosen.unwrap_or_default() == name.as_str()
            }
        }
    }

    /// Carries it out.
    ///
    /// # Errors
    /// [`NoPlace`]; nothing was changed.
    pub fn carry_out(&self, lists: &mut StoredLists) -> Result<(), NoPlace> {
        match self {
            Self::Store(list) => lists.store(list),
            Self::Remove { name } => lists.remove(name),
            Self::Choose { name } => lists.choose(name),
        }
    }
}

/// Its texts as words of one line each ([`crate::text`]).
pub fn tame_terms(terms: &mut ListTerms) {
    tame(&mut terms.name);
    tame(&mut terms.unit);
}

/// For `#[serde(with)]`: one list, as a section.
mod one {
    use super::*;

    pub(super) fn serialize<S: Serializer>(
        list: &StoredList,
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        section(LIST, list).serialize(serializer)
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>>(
        deserializer: D,
    ) -> Result<StoredList, D::Error> {
        match Read::deserialize(deserializer)? {
            (_, 1, content) => Fields(content).take().map_err(D::Error::custom),
            _ => Err(D::Error::custom("a list of another version")),
        }
    }
}

/// All lists, to be written in sections.
pub struct InSections<'a>(pub &'a StoredLists);

impl Serialize for InSections<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let lists = self.0;
        let chosen = lists.chosen().map(|list| list.terms.name.as_str());
        // Without a length in front: sections tell their own.
        let mut all = serializer.serialize_tuple(1 + lists.all().len())?;
        all.serialize_element(&section(CHOICE, chosen.unwrap_or_default()))?;
        for list in lists.all() {
            all.serialize_element(&section(LIST, list))?;
        }
        all.end()
    }
}

/// Reads what [`InSections`] writes, in place of what was there.
///
/// # Errors
/// [`RecordError::Content`] when the bytes are no sections; no list is there then.
pub fn read(sections: &[u8], lists: &mut StoredLists) -> Result<(), RecordError> {
    lists.clear();
    let (mut rest, mut chosen) = (sections, String::<24>::new());
    while !rest.is_empty() {
        let ((id, version, content), after) =
            take_from_bytes::<Read<'_>>(rest).map_err(|_| RecordError::Content)?;
        rest = after;
        match (id, version) {
            (CHOICE, 1) => chosen = Fields(content).take()?,
            (LIST, 1) => {
                let list: StoredList = Fields(content).take()?;
                // More than there is room for were never stored.
                let _ = lists.store(&list);
            }
            _ => {}
        }
    }
    // It may be one that was passed over.
    let _ = lists.choose(&chosen);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use calib_core::point::PointSpec;
    use calib_core::stored_list::{Band, Base, MAX_LISTS, Rule};
    use std::vec::Vec;

    fn list(name: &str, points: usize) -> StoredList {
        let band = Band {
            from_hz: 10.0,
            to_hz: f32::MAX,
            base: Base::Reference,
            lower_rel: -0.3,
            upper_rel: 0.4,
            reference_point_only: false,
        };
        let point = |number: usize| PointSpec {
            frequency_hz: 20.0 + number as f32,
            acceleration_rms_ms2: 10.0,
        };
        StoredList {
            terms: ListTerms {
                name: name.try_into().expect("short"),
                nominal_v_per_ms2: 0.0102,
                unit: "mV/g".try_into().expect("short"),
                rule: Rule::GuardBand,
                bands: core::iter::repeat_n(band, 6).collect(),
            },
            points: (0..points).map(point).collect(),
        }
    }

    fn written(content: &impl Serialize) -> Vec<u8> {
        let mut bytes = vec![0; 8192];
        let length = postcard::to_slice(content, &mut bytes).expect("fits").len();
        bytes.truncate(length);
        bytes
    }

    #[test]
    fn the_fullest_lists_come_back_with_their_choice() {
        let mut lists = StoredLists::NONE;
        for number in 0..MAX_LISTS {
            lists
                .store(&list(&format!("{number:024}"), 40))
                .expect("room");
        }
        let name = lists.all()[3].terms.name.clone();
        lists.choose(&name).expect("there");
        let bytes = written(&InSections(&lists));
        println!("{} bytes", bytes.len());
        let mut read_back = StoredLists::NONE;
        assert_eq!(read(&bytes, &mut read_back), Ok(()));
        assert_eq!(read_back, lists);
        for end in 0..bytes.len() {
            // Nothing that ends early is taken for all of it.
            let _ = read(&bytes[..end], &mut read_back);
            assert_ne!(read_back, lists, "{end}");
        }
    }

    #[test]
    fn a_list_of_a_newer_release_is_passed_over_and_a_new_field_too() {
        let newer = crate::sections::Section {
            id: LIST,
            version: 2,
            content: [1_u8; 4],
        };
        let known = list("a", 2);
        let bytes = written(&(
            section(CHOICE, "b"),
            newer,
            section(LIST, (&known, 7_u32)),
            section(9, 1_u8),
        ));
        let mut lists = StoredLists::NONE;
        assert_eq!(read(&bytes, &mut lists), Ok(()));
        assert_eq!(lists.all(), [known]);
        assert_eq!(lists.chosen(), None);
    }

    #[test]
    fn a_change_is_done_once_and_a_message_holds_the_longest_list() {
        let mut lists = StoredLists::NONE;
        let store = ListChange::Store(list("a", 40));
        let name = "a".try_into().expect("short");
        let choose = ListChange::Choose { name };
        assert_eq!(choose.carry_out(&mut lists), Err(NoPlace::Unknown));
        for change in [&store, &choose] {
            assert!(change.is_usable() && !change.is_done_in(&lists));
            assert_eq!(change.carry_out(&mut lists), Ok(()));
            assert!(change.is_done_in(&lists));
            let bytes = written(change);
            assert_eq!(postcard::from_bytes(&bytes), Ok(change.clone()));
        }
        for name in ["a\nb", "a;b", "a\"b", ""] {
            assert!(!ListChange::Store(list(name, 1)).is_usable(), "{name}");
        }
    }
}
