//! In the place of the published `hayro-jbig2`, which decodes JBIG2 images of a PDF file that is shown in a document.
#![no_std]

/// An image that was read: there is none.
pub enum Image {}

/// Every image is refused.
#[derive(Debug)]
pub struct Unreadable;

impl Image {
    /// Refuses the image.
    pub fn new_embedded(_data: &[u8], _globals: Option<&[u8]>) -> Result<Self, Unreadable> {
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

    /// Hands the pixels on.
    pub fn decode(&self, _decoder: &mut impl Decoder) -> Result<(), Unreadable> {
        match *self {}
    }
}

/// What takes the pixels of an image.
pub trait Decoder {
    /// Takes one pixel.
    fn push_pixel(&mut self, black: bool);
    /// Takes eight pixels of one colour, `chunk_count` times.
    fn push_pixel_chunk(&mut self, black: bool, chunk_count: u32);
    /// Ends a row.
    fn next_line(&mut self);
}
