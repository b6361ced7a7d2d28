//! In the place of the published `typst-svg`, which draws pages, images and whole PDF files as SVG.
//!
//! `typst` depends on `typst-html`, and that on this, whatever a program asks for; a certificate is a PDF, and HTML
//! is an experimental target that only the features of a typst library turn on, which ours does not. What is here
//! satisfies the three calls of `typst-html`; should one be made, it shows nothing.

use comemo::Tracked;
use ecow::EcoString;
use typst_library::foundations::Smart;
use typst_library::layout::{Abs, Frame, Point};
use typst_library::model::LateLinkResolver;
use typst_library::visualize::{Image, ImageScaling};

/// A frame inside HTML: nothing.
pub fn svg_in_html(
    _frame: &Frame,
    _text_size: Abs,
    _pretty: bool,
    _id: Option<&str>,
    _styles: &str,
    _anchors: &[(Point, EcoString)],
    _link_resolver: Tracked<LateLinkResolver>,
) -> String {
    String::new()
}

/// An image inside HTML: empty.
pub struct WebImage;

impl WebImage {
    /// An image that has no data.
    pub fn new(_image: &Image) -> Self {
        Self
    }

    /// The URL of an empty image.
    pub fn to_base64_url(&self) -> EcoString {
        "data:,".into()
    }
}

/// How a browser would scale an image: as it likes.
pub fn convert_image_scaling(_scaling: Smart<ImageScaling>) -> Option<&'static str> {
    None
}
