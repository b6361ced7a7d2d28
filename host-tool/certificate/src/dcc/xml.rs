//! A writer of nested elements: what is opened is closed.

use quick_xml::Writer;
use quick_xml::events::{BytesDecl, BytesEnd, BytesStart, BytesText, Event};

/// XML under construction. Writing to memory does not fail.
pub(super) struct Xml {
    writer: Writer<Vec<u8>>,
}

impl Xml {
    pub(super) fn new() -> Self {
        let mut xml = Self {
            writer: Writer::new_with_indent(Vec::new(), b' ', 2),
        };
        xml.event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)));
        xml
    }

    pub(super) fn finish(self) -> Vec<u8> {
        let mut bytes = self.writer.into_inner();
        bytes.push(b'\n');
        bytes
    }

    /// An element with attributes and content.
    pub(super) fn with(
        &mut self,
        name: &str,
        attributes: &[(&str, &str)],
        content: impl FnOnce(&mut Self),
    ) {
        let start = BytesStart::new(name).with_attributes(attributes.iter().copied());
        self.event(Event::Start(start));
        content(self);
        self.event(Event::End(BytesEnd::new(name)));
    }

    /// An element with content.
    pub(super) fn element(&mut self, name: &str, content: impl FnOnce(&mut Self)) {
        self.with(name, &[], content);
    }

    /// An element with text.
    pub(super) fn leaf(&mut self, name: &str, text: &str) {
        let text = clean(text);
        self.element(name, |xml| xml.event(Event::Text(BytesText::new(&text))));
    }

    /// An element with text, if there is any.
    pub(super) fn optional(&mut self, name: &str, text: Option<&str>) {
        if let Some(text) = text.map(str::trim).filter(|text| !text.is_empty()) {
            self.leaf(name, text);
        }
    }

    /// A text of PTB's `textType` in one language.
    pub(super) fn content(&mut self, name: &str, language: &str, text: &str) {
        let text = clean(text);
        self.element(name, |xml| {
            xml.with("dcc:content", &[("lang", language)], |xml| {
                xml.event(Event::Text(BytesText::new(&text)));
            });
        });
    }

    fn event(&mut self, event: Event<'_>) {
        // Note(unwrap): a Vec takes every byte.
        self.writer.write_event(event).expect("memory is written");
    }
}

/// XML 1.0 has no control characters, whatever an operator typed; PTB's texts
/// neither begin nor end with a blank, and are not empty.
fn clean(text: &str) -> String {
    let allowed = |c: &char| !c.is_control() && !matches!(c, '\u{fffe}' | '\u{ffff}');
    let kept: String = text.chars().filter(allowed).collect();
    match kept.trim() {
        "" => "\u{2013}".to_owned(),
        text => text.to_owned(),
    }
}
