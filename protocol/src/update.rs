//! The image that runs, and updates of it.
//!
//! | step | of an update |
//! |---|---|
//! | `Begin` | the manifest of the new image, which is checked before anything is erased |
//! | `Block` | the image, in order; the first block of a sector waits for its erase, 2.2 s at most |
//! | `Finish` | what was written is compared with the manifest; the next start tries it |
//! | `Confirm` | of the new image, once it runs: without it the old one starts again after some starts |
//!
//! Manifest and slots are those of the crate `calib-boot`.

use crate::head::Sha256Sum;
use heapless::Vec;
use serde::{Deserialize, Serialize};

/// Bytes of a manifest.
pub const MANIFEST_BYTES: usize = 256;
/// Bytes of an image in one block.
pub const UPDATE_CHUNK: usize = 1024;

/// Who signed an image.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum ImageSigner {
    /// Nobody was asked: the image was started without a loader.
    Nobody,
    /// Anybody: the development key is part of the source tree.
    Development,
    /// Whoever holds the secret half of the key the instrument trusts.
    Release,
}

/// Which image a loader has checked and started.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct ImageOrigin {
    /// SHA-256 of the image.
    pub sha256: Sha256Sum,
    /// Who signed it.
    pub signer: ImageSigner,
}

impl ImageOrigin {
    /// No loader has checked it.
    pub const UNKNOWN: Self = Self {
        sha256: [0; 32],
        signer: ImageSigner::Nobody,
    };
}

impl Default for ImageOrigin {
    fn default() -> Self {
        Self::UNKNOWN
    }
}

/// A slot of the flash for an image.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum ImageSlot {
    /// The first.
    A,
    /// The second.
    B,
}

/// The image that runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct RunningImage {
    /// Which it is.
    pub origin: ImageOrigin,
    /// Slot it runs from.
    pub slot: ImageSlot,
    /// It is on trial: it wants to be confirmed.
    pub on_trial: bool,
    /// The other slot holds an update that was tried and not confirmed.
    pub rolled_back: bool,
}

/// A step of an update.
// A step is encoded or carried out at once: its size never matters.
#[allow(clippy::large_enum_variant)]
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum UpdateStep {
    /// Begin an update with this manifest; one that was begun before is forgotten.
    Begin {
        /// [`MANIFEST_BYTES`] of them.
        manifest: Vec<u8, MANIFEST_BYTES>,
    },
    /// The next bytes of the image. A block that is there already is not written again.
    Block {
        /// Place of the first in the image; a multiple of 32.
        offset: u32,
        /// A multiple of 32 of them, but for the last block.
        data: Vec<u8, UPDATE_CHUNK>,
    },
    /// Compare, and try the new image at the next start.
    Finish,
    /// The image that runs is good.
    Confirm,
}
