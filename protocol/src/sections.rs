//! Sections: how what is stored or sent can grow.
//!
//! | bytes | content |
//! |---|---|
//! | 1 | id of the section |
//! | 1 | version of its content |
//! | 1 to 3 | length of its content, as postcard writes a `usize` |
//! | n | content, postcard |
//!
//! | change | how an old reader takes it | how a new reader takes what is old |
//! |---|---|---|
//! | another section | passes over an id it does not know | does not find it: defaults |
//! | another field | reads its own and passes over the rest | the content ends before it: its default |
//! | another meaning of what stands there | the version is above its own: says so | reads the version it finds |
//!
//! So fields are added at the end, none is taken away, and no id is used twice.

use crate::error::RecordError;
use postcard::experimental::serialized_size;
use postcard::take_from_bytes;
use serde::ser::Error;
use serde::{Deserialize, Serialize, Serializer};

/// A section to be written.
#[derive(Clone, Copy, Debug)]
pub struct Section<T> {
    /// Description.
    pub id: u8,
    /// Version of its content.
    pub version: u8,
    /// Content, as it is.
    pub content: T,
}

/// A section of the first version of its content.
pub const fn section<T>(id: u8, content: T) -> Section<T> {
    Section {
        id,
        version: 1,
        content,
    }
}

impl<T: Serialize> Serialize for Section<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let length = serialized_size(&self.content).map_err(S::Error::custom)?;
        (self.id, self.version, length, &self.content).serialize(serializer)
    }
}

/// A section, or nothing.
#[derive(Clone, Copy, Debug)]
pub struct Optional<T>(Option<Section<T>>);

/// A section of the first version, written where it says something.
pub fn section_unless<T>(nothing: bool, id: u8, content: T) -> Optional<T> {
    Optional((!nothing).then_some(section(id, content)))
}

impl<T: Serialize> Serialize for Optional<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match &self.0 {
            None => ().serialize(serializer),
            Some(section) => section.serialize(serializer),
        }
    }
}

/// A section as it is read: id, version, content.
pub(crate) type Read<'a> = (u8, u8, &'a [u8]);

/// Section of this id; where its content begins.
///
/// # Errors
/// [`RecordError::Content`] when the bytes are no sections, [`RecordError::Section`] when its version
/// is above `newest`.
pub fn find(sections: &[u8], id: u8, newest: u8) -> Result<Option<(usize, &[u8])>, RecordError> {
    let mut rest = sections;
    while !rest.is_empty() {
        let ((found, version, content), after) =
            take_from_bytes::<Read<'_>>(rest).map_err(|_| RecordError::Content)?;
        rest = after;
        if found == id && version > newest {
            return Err(RecordError::Section { id, version });
        }
        if found == id {
            let at = sections.len() - after.len() - content.len();
            return Ok(Some((at, content)));
        }
    }
    Ok(None)
}

/// Content of the section of this id, version 1, which must be there.
///
/// # Errors
/// As [`find`], and [`RecordError::Content`] when it is missing.
pub fn needed(sections: &[u8], id: u8) -> Result<Fields<'_>, RecordError> {
    let found = find(sections, id, 1)?;
    let (_, content) = found.ok_or(RecordError::Content)?;
    Ok(Fields(content))
}

/// Reads the section of this id, version 1, into a field, which stays as it is where there is none.
///
/// # Errors
/// As [`find`] and [`Fields::take`].
pub fn fill<'a, T: Deserialize<'a>>(
    sections: &'a [u8],
    id: u8,
    field: &mut T,
) -> Result<(), RecordError> {
    if let Some((_, content)) = find(sections, id, 1)? {
        *field = Fields(content).take()?;
    }
    Ok(())
}

/// Fields read one after the other.
#[derive(Clone, Copy, Debug)]
pub struct Fields<'a>(pub &'a [u8]);

impl<'a> Fields<'a> {
    /// The next field.
    ///
    /// # Errors
    /// [`RecordError::Content`] when it is none, or the content ends before it.
    pub fn take<T: Deserialize<'a>>(&mut self) -> Result<T, RecordError> {
        let (value, rest) = take_from_bytes(self.0).map_err(|_| RecordError::Content)?;
        self.0 = rest;
        Ok(value)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Serialize)]
    struct Newer {
        known: u16,
        added: [u8; 3],
    }

    fn written(content: &impl Serialize) -> Vec<u8> {
        let mut bytes = vec![0; 64];
        let length = postcard::to_slice(content, &mut bytes).expect("fits").len();
        bytes.truncate(length);
        bytes
    }

    #[test]
    fn the_form_is_the_documented_one() {
        // 300 as a variable-length integer: AC 02.
        let bytes = written(&(section(7, 300_u16), section(8, ())));
        assert_eq!(bytes, [7, 1, 2, 0xAC, 0x02, 8, 1, 0]);
    }

    #[test]
    fn an_old_reader_passes_over_what_is_new() {
        let newer = Newer {
            known: 300,
            added: [1, 2, 3],
        };
        let bytes = written(&(section(99, [0xFF_u8; 5]), section(7, newer)));
        assert_eq!(needed(&bytes, 7).and_then(|mut f| f.take()), Ok(300_u16));
        let (at, content) = find(&bytes, 7, 1).expect("sections").expect("there");
        assert_eq!(&bytes[at..], content);
        assert_eq!(find(&bytes, 8, 1), Ok(None));
    }

    #[test]
    fn a_content_of_another_meaning_is_not_guessed() {
        let newer = Section {
            id: 7,
            version: 2,
            content: 300_u16,
        };
        let bytes = written(&newer);
        let error = RecordError::Section { id: 7, version: 2 };
        assert_eq!(find(&bytes, 7, 1), Err(error));
        assert_eq!(find(&bytes, 6, 1), Ok(None));
        assert!(find(&bytes, 7, 2).is_ok_and(|found| found.is_some()));
    }

    #[test]
    fn sections_that_end_early_are_none() {
        let bytes = written(&(section(7, 300_u16), section(8, [1_u8; 4])));
        for length in 1..bytes.len() {
            let end_of_first = length == 5;
            assert_eq!(
                find(&bytes[..length], 8, 1).is_ok(),
                end_of_first,
                "{length}"
            );
        }
    }
}
