//! An update as a file: both slots' images, each with its manifest.
//!
//! | bytes | content |
//! |---|---|
//! | 8 | `calibupd` |
//! | 256 | manifest of the image for slot A |
//! | its length | that image |
//! | 256 | manifest of the image for slot B |
//! | its length | that image |

use crate::layout::{MANIFEST_BYTES, Slot};
use crate::manifest::Manifest;

/// First bytes of the file.
pub const MAGIC: &[u8; 8] = b"calibupd";

/// An image and what it says of itself.
#[derive(Clone, Copy, Debug)]
pub struct Part<'a> {
    /// Content of the manifest.
    pub told: Manifest,
    /// The manifest.
    pub manifest: &'a [u8; MANIFEST_BYTES],
    /// The image.
    pub image: &'a [u8],
}

/// The parts of a file, for slots A and B; none where it is no update, or not all of one. Who signed it is
/// the instrument's to ask.
pub fn parts(file: &[u8]) -> Option<[Part<'_>; 2]> {
    let rest = file.strip_prefix(MAGIC)?;
    let (a, rest) = part(rest, Slot::A)?;
    let (b, rest) = part(rest, Slot::B)?;
    rest.is_empty().then_some([a, b])
}

fn part(bytes: &[u8], slot: Slot) -> Option<(Part<'_>, &[u8])> {
    let (manifest, rest) = bytes.split_first_chunk::<MANIFEST_BYTES>()?;
    let told = Manifest::parse(manifest).ok()?;
    let (image, rest) = rest.split_at_checked(told.length as usize)?;
    let part = Part {
        told,
        manifest,
        image,
    };
    (told.slot == slot).then_some((part, rest))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::manifest::{Version, sign};

    fn file() -> Vec<u8> {
        let mut file = MAGIC.to_vec();
        for (slot, image) in [(Slot::A, &b"one"[..]), (Slot::B, b"other")] {
            let manifest = Manifest::of(image, slot, Version([1, 0, 0]), "board");
            file.extend(sign(&manifest.expect("fits"), &[1; 32]));
            file.extend(image);
        }
        file
    }

    #[test]
    fn both_parts_are_found() {
        let file = file();
        let [a, b] = parts(&file).expect("an update");
        assert_eq!((a.image, b.image), (&b"one"[..], &b"other"[..]));
        assert_eq!((a.told.slot, b.told.slot), (Slot::A, Slot::B));
    }

    #[test]
    fn a_file_of_another_length_is_none() {
        let mut file = file();
        for length in 0..file.len() {
            assert!(parts(&file[..length]).is_none(), "{length}");
        }
        file.push(0);
        assert!(parts(&file).is_none());
    }
}
