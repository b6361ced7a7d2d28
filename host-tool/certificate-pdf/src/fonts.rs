//! The fonts a document may use, and what they can print.

use std::sync::LazyLock;
use typst::foundations::Bytes;
use typst::text::Font;

/// Liberation Sans (SIL Open Font License 1.1): text and figures of one width.
const OWN: [&[u8]; 3] = [
    include_bytes!("../fonts/LiberationSans-Regular.ttf"),
    include_bytes!("../fonts/LiberationSans-Bold.ttf"),
    include_bytes!("../fonts/LiberationSans-Italic.ttf"),
];

/// Our own fonts first, then those of the typesetter for rarer characters.
static FONTS: LazyLock<Vec<Font>> = LazyLock::new(|| {
    let data = OWN.into_iter().chain(typst_assets::fonts());
    data.flat_map(|bytes| Font::iter(Bytes::new(bytes)))
        .collect()
});

pub(crate) fn all() -> &'static [Font] {
    &FONTS
}

/// The text with every character no embedded font has replaced by `\u{25a1}`
/// (a hollow square): PDF/A forbids characters without a glyph.
pub fn printable(text: &str) -> String {
    let has = |c: char| {
        FONTS
            .iter()
            .any(|font| font.info().coverage.contains(c.into()))
    };
    let shown = |c: char| c.is_whitespace() || has(c);
    text.chars()
        .map(|c| if shown(c) { c } else { '\u{25a1}' })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_no_font_has_becomes_a_square() {
        assert_eq!(printable("O'Neil µV ± Ω ü 中"), "O'Neil µV ± Ω ü \u{25a1}");
        assert_eq!(
            printable("\u{25a1}"),
            "\u{25a1}",
            "the square itself is there"
        );
    }
}
