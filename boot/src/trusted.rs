//! Whom the loader trusts.
//!
//! The loader has one public key, in sector 0 at a fixed place, where the firmware reads it: the same image
//! serves under any key. The key of the source tree is known to everybody and protects nothing.
//!
//! | bytes | content |
//! |---|---|
//! | 0 to 7 | `calibldr` |
//! | 8 to 39 | the public key |

use crate::BootFlash;
use crate::layout::{FLASH, WORD};
use crate::manifest::{PublicKey, Seed};

/// Where the note lies: behind the loader's vectors, two flash words.
pub const NOTE: u32 = FLASH + 0x400;
/// Bytes of the note.
pub const NOTE_BYTES: usize = 2 * WORD;
const MAGIC: &[u8; 8] = b"calibldr";

/// The secret half of the development key: `boot/keys/DEVELOPMENT.key`, public like all of this.
pub const DEVELOPMENT_SEED: Seed = seed_of(include_str!("../keys/DEVELOPMENT.key"));
/// Its public half, which a test compares.
pub const DEVELOPMENT_KEY: PublicKey = seed_of(include_str!("../keys/DEVELOPMENT.pub"));

/// Who signed what runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Signer {
    /// Anybody: the key is in the source tree.
    Development,
    /// Whoever holds the secret half of the loader's key.
    Release,
}

impl Signer {
    /// Whose key it is.
    pub fn of(key: &PublicKey) -> Self {
        match *key == DEVELOPMENT_KEY {
            true => Self::Development,
            false => Self::Release,
        }
    }
}

/// The note of a loader that trusts this key.
pub const fn note(key: &PublicKey) -> [u8; NOTE_BYTES] {
    let mut note = [0; NOTE_BYTES];
    let mut at = 0;
    while at < 40 {
        note[at] = if at < 8 { MAGIC[at] } else { key[at - 8] };
        at += 1;
    }
    note
}

/// The key that the loader of this part trusts; none where there is no loader.
pub fn key(flash: &mut impl BootFlash) -> Option<PublicKey> {
    let [first, second] = [flash.read(NOTE)?, flash.read(NOTE + WORD as u32)?];
    let key = first.strip_prefix(MAGIC)?;
    let mut bytes = key.iter().chain(&second).copied();
    Some(core::array::from_fn(|_| bytes.next().unwrap_or(0)))
}

/// The key of 64 hexadecimal digits at the beginning of a text, for keys that are part of a program: another
/// text does not compile.
pub const fn seed_of(text: &str) -> [u8; 32] {
    let digits = text.as_bytes();
    let mut bytes = [0; 32];
    let mut at = 0;
    while at < 32 {
        bytes[at] = digit(digits[2 * at]) << 4 | digit(digits[2 * at + 1]);
        at += 1;
    }
    bytes
}

const fn digit(digit: u8) -> u8 {
    match digit {
        b'0'..=b'9' => digit - b'0',
        b'a'..=b'f' => digit - b'a' + 10,
        _ => panic!("not a hexadecimal digit"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::manifest::public_key;
    use crate::model::Model;

    #[test]
    fn the_development_key_is_a_pair() {
        assert_eq!(public_key(&DEVELOPMENT_SEED), DEVELOPMENT_KEY);
        assert_eq!(Signer::of(&DEVELOPMENT_KEY), Signer::Development);
        assert_eq!(Signer::of(&[1; 32]), Signer::Release);
    }

    #[test]
    fn the_note_tells_the_key() {
        let mut flash = Model::erased();
        assert_eq!(key(&mut flash), None);
        flash.put(NOTE, &note(&[5; 32]));
        assert_eq!(key(&mut flash), Some([5; 32]));
    }
}
