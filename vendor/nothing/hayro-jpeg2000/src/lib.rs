//! In the place of the published `hayro-jpeg2000`, which decodes JPEG 2000 images of a PDF file that is shown in a
//! document.
#![no_std]

extern crate alloc;
use alloc::vec::Vec;

/// An image that was read: there is none.
pub enum Image {}

/// Every image is refused.
#[derive(Debug)]
pub struct Unreadable;

/// How an image is to be decoded.
pub struct DecodeSettings {
    /// Colours for the indices of a palette.
    pub resolve_palette_indices: bool,
    /// No leniency.
    pub strict: bool,
    /// Pixels wanted, across and down.
    pub target_resolution: Option<(u32, u32)>,
}

/// Meaning of an image's channels.
pub enum ColorSpace {
    /// One channel.
    Gray,
    /// Three channels.
    RGB,
    /// Four channels.
    CMYK,
    /// Channels of no stated meaning.
    Unknown {
        /// How many.
        num_channels: u8,
    },
    /// Channels of a profile.
    Icc {
        /// The profile, as in the file.
        profile: Vec<u8>,
        /// How many.
        num_channels: u8,
    },
}

impl Image {
    /// Refuses the image.
    pub fn new(_data: &[u8], _settings: &DecodeSettings) -> Result<Self, Unreadable> {
        Err(Unreadable)
    }

    /// Pixels in a row.
    pub fn width(&self) -> u32 {
        match *self {}
    }

    /// Rows.
    pub fn height(&self) -> u32 {
        match *self {}
    }

    /// Bits a channel has in the file.
    pub fn original_bit_depth(&self) -> u8 {
        match *self {}
    }

    /// Meaning of the channels.
    pub fn color_space(&self) -> &ColorSpace {
        match *self {}
    }

    /// One more channel: how opaque a pixel is.
    pub fn has_alpha(&self) -> bool {
        match *self {}
    }

    /// Pixels, eight bits a channel.
    pub fn decode(&self) -> Result<Vec<u8>, Unreadable> {
        match *self {}
    }
}
