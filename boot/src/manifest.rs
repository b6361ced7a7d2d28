//! Statements of an image about itself, signed (Ed25519, RFC 8032).
//!
//! | bytes | content, little endian |
//! |---|---|
//! | 0 to 7 | `calibimg` |
//! | 8, 9 | form of the manifest, 1 |
//! | 10 | slot the image is linked for: 0 is A, 1 is B |
//! | 11 | 0 |
//! | 12 to 15 | length of the image, bytes |
//! | 16 to 21 | version: major, minor, patch |
//! | 22, 23 | 0 |
//! | 24 to 47 | name of the board it is for, filled with zeros |
//! | 48 to 79 | SHA-256 of the image |
//! | 80 to 191 | 0 |
//! | 192 to 255 | signature of bytes 0 to 191 |
//!
//! The signature covers length and digest, the digest every byte of the image.

use crate::BootFlash;
use crate::layout::{LONGEST_IMAGE, MANIFEST_BYTES, Slot, WORD};
use ed25519_dalek::{Signature, Signer, SigningKey, VerifyingKey};
use sha2::{Digest, Sha256};

/// A public key.
pub type PublicKey = [u8; 32];
/// The secret half of a key (RFC 8032, 5.1.5).
pub type Seed = [u8; 32];

const MAGIC: &[u8; 8] = b"calibimg";
const FORM: u16 = 1;
const SIGNED: usize = 192;
/// Bytes for the name of a board.
pub const BOARD_BYTES: usize = 24;

/// A version of the firmware; later ones are greater.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Version(pub [u16; 3]);

impl Version {
    /// Of `1.2.3`; what follows the third number is passed over.
    pub fn parse(text: &str) -> Option<Self> {
        let mut numbers = text.split(['.', '-', '+']);
        let mut next = || numbers.next()?.parse().ok();
        Some(Self([next()?, next()?, next()?]))
    }
}

impl core::fmt::Display for Version {
    fn fmt(&self, formatter: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let Self([major, minor, patch]) = self;
        write!(formatter, "{major}.{minor}.{patch}")
    }
}

/// Content of a manifest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Manifest {
    /// Slot the image is linked for.
    pub slot: Slot,
    /// Length of the image, bytes.
    pub length: u32,
    /// Its version.
    pub version: Version,
    /// Name of its board, filled with zeros.
    pub board: [u8; BOARD_BYTES],
    /// SHA-256 of the image.
    pub sha256: [u8; 32],
}

/// Why a manifest is none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ManifestError {
    /// It is no manifest, or one of another form.
    Form,
    /// It was changed, or signed with a key that is not trusted.
    Signature,
}

impl Manifest {
    /// Of an image; none when it is empty, too long, or the board's name is.
    pub fn of(image: &[u8], slot: Slot, version: Version, board: &str) -> Option<Self> {
        let mut name = [0; BOARD_BYTES];
        name.get_mut(..board.len())?
            .copy_from_slice(board.as_bytes());
        let length = u32::try_from(image.len()).ok()?;
        (1..=LONGEST_IMAGE).contains(&length).then(|| Self {
            slot,
            length,
            version,
            board: name,
            sha256: Sha256::digest(image).into(),
        })
    }

    /// Reads a manifest without asking who signed it.
    ///
    /// # Errors
    /// [`ManifestError::Form`].
    pub fn parse(bytes: &[u8; MANIFEST_BYTES]) -> Result<Self, ManifestError> {
        Self::fields(bytes).ok_or(ManifestError::Form)
    }

    /// Reads a manifest that `trusted` has signed.
    ///
    /// # Errors
    /// See [`ManifestError`].
    pub fn verify(
        bytes: &[u8; MANIFEST_BYTES],
        trusted: &PublicKey,
    ) -> Result<Self, ManifestError> {
        let manifest = Self::parse(bytes)?;
        let (signed, signature) = bytes.split_at(SIGNED);
        let key = VerifyingKey::from_bytes(trusted);
        let signature = Signature::from_slice(signature);
        match (key, signature) {
            // Strict: no second signature of the same content (RFC 8032, 5.1.7).
            (Ok(key), Ok(signature)) if key.verify_strict(signed, &signature).is_ok() => {
                Ok(manifest)
            }
            _ => Err(ManifestError::Signature),
        }
    }

    fn fields(bytes: &[u8; MANIFEST_BYTES]) -> Option<Self> {
        let u16_at = |at: usize| Some(u16::from_le_bytes(*bytes.get(at..)?.first_chunk()?));
        let known = bytes.starts_with(MAGIC) && u16_at(8)? == FORM;
        let length = u32::from_le_bytes(*bytes.get(12..)?.first_chunk()?);
        if !known || !(1..=LONGEST_IMAGE).contains(&length) {
            return None;
        }
        Some(Self {
            slot: Slot::of(*bytes.get(10)?)?,
            length,
            version: Version([u16_at(16)?, u16_at(18)?, u16_at(20)?]),
            board: *bytes.get(24..)?.first_chunk()?,
            sha256: *bytes.get(48..)?.first_chunk()?,
        })
    }

    /// Whether it is for the board of this name.
    pub fn is_for(&self, board: &str) -> bool {
        let name = self.board.split(|byte| *byte == 0).next();
        name == Some(board.as_bytes())
    }

    fn to_bytes(self) -> [u8; SIGNED] {
        let mut bytes = [0; SIGNED];
        let Version([major, minor, patch]) = self.version;
        let fields: [(usize, &[u8]); 9] = [
            (0, MAGIC),
            (8, &FORM.to_le_bytes()),
            (10, &[self.slot as u8]),
            (12, &self.length.to_le_bytes()),
            (16, &major.to_le_bytes()),
            (18, &minor.to_le_bytes()),
            (20, &patch.to_le_bytes()),
            (24, &self.board),
            (48, &self.sha256),
        ];
        for (at, field) in fields {
            let places = bytes.iter_mut().skip(at);
            places.zip(field).for_each(|(place, byte)| *place = *byte);
        }
        bytes
    }
}

/// The manifest as it is stored, signed with the key of `seed`.
pub fn sign(manifest: &Manifest, seed: &Seed) -> [u8; MANIFEST_BYTES] {
    let signed = manifest.to_bytes();
    let signature = SigningKey::from_bytes(seed).sign(&signed).to_bytes();
    let mut bytes = [0; MANIFEST_BYTES];
    let content = signed.iter().chain(&signature);
    bytes
        .iter_mut()
        .zip(content)
        .for_each(|(place, byte)| *place = *byte);
    bytes
}

/// The public key of a secret one.
pub fn public_key(seed: &Seed) -> PublicKey {
    SigningKey::from_bytes(seed).verifying_key().to_bytes()
}

/// The bytes of the manifest of a slot; none where one of its words cannot be read.
pub fn stored(flash: &mut impl BootFlash, slot: Slot) -> Option<[u8; MANIFEST_BYTES]> {
    let mut bytes = [0; MANIFEST_BYTES];
    let addresses = (slot.manifest()..).step_by(WORD);
    let (words, _) = bytes.as_chunks_mut::<WORD>();
    for (place, address) in words.iter_mut().zip(addresses) {
        *place = flash.read(address)?;
    }
    Some(bytes)
}

/// SHA-256 of the first `length` bytes of a slot; none where one of its words cannot be read.
pub fn digest(flash: &mut impl BootFlash, slot: Slot, length: u32) -> Option<[u8; 32]> {
    let mut sum = Sha256::new();
    for offset in (0..length).step_by(WORD) {
        let word = flash.read(slot.start() + offset)?;
        let rest = (length - offset) as usize;
        sum.update(word.get(..rest.min(WORD))?);
    }
    Some(sum.finalize().into())
}

/// The manifest of a slot whose image is whole, linked for it, and signed with the trusted key.
pub fn of_whole(flash: &mut impl BootFlash, slot: Slot, trusted: &PublicKey) -> Option<Manifest> {
    let bytes = stored(flash, slot)?;
    let manifest = Manifest::verify(&bytes, trusted).ok()?;
    let is_whole = manifest.slot == slot
        && digest(flash, slot, manifest.length).is_some_and(|sum| sum == manifest.sha256);
    is_whole.then_some(manifest)
}

#[cfg(test)]
mod tests {
    use super::*;

    const SEED: Seed = [7; 32];

    fn signed() -> [u8; MANIFEST_BYTES] {
        let version = Version::parse("1.2.3-rc1").expect("a version");
        let manifest = Manifest::of(b"image", Slot::B, version, "nucleo").expect("fits");
        sign(&manifest, &SEED)
    }

    #[test]
    fn what_was_signed_is_read_again() {
        let manifest = Manifest::verify(&signed(), &public_key(&SEED)).expect("signed");
        assert_eq!(manifest.slot, Slot::B);
        assert_eq!(manifest.length, 5);
        assert_eq!(manifest.version, Version([1, 2, 3]));
        assert!(manifest.is_for("nucleo") && !manifest.is_for("nucle"));
        let sum: [u8; 32] = Sha256::digest(b"image").into();
        assert_eq!(manifest.sha256, sum);
    }

    #[test]
    fn every_flipped_bit_is_noticed() {
        for bit in 0..MANIFEST_BYTES * 8 {
            let mut bytes = signed();
            bytes[bit / 8] ^= 1 << (bit % 8);
            assert!(
                Manifest::verify(&bytes, &public_key(&SEED)).is_err(),
                "bit {bit}"
            );
        }
    }

    #[test]
    fn another_key_is_not_trusted() {
        let other = public_key(&[8; 32]);
        let refused = Manifest::verify(&signed(), &other);
        assert_eq!(refused, Err(ManifestError::Signature));
    }

    #[test]
    fn versions_are_ordered_by_their_numbers() {
        let version = |text| Version::parse(text).expect("a version");
        assert!(version("0.9.10") < version("0.10.0"));
        assert!(version("1.0.0") > version("0.99.99"));
        assert_eq!(Version::parse("1.2"), None);
    }
}
