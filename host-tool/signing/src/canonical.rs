//! Exclusive canonical XML 1.0 without comments (W3C, 18 July 2002): a document as bytes that do not depend on
//! how it is written, so that a sum of it can be compared.
//!
//! Parts it leaves out could say something else to another reader: a document type, a processing instruction
//! or a comment is refused, in a number or a name as anywhere.

use crate::Problem;
use quick_xml::Reader;
use quick_xml::events::{BytesDecl, BytesStart, Event};
use std::collections::{BTreeMap, BTreeSet};

/// Namespace of XML signatures.
pub(crate) const SIGNATURE: &str = "http://www.w3.org/2000/09/xmldsig#";

/// Part of a document that is put into canonical form.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Part {
    /// All but the signatures within the root: what an enveloped signature is over.
    Enveloping,
    /// Statements of the signature, `ds:SignedInfo`.
    SignedInfo,
}

/// Each element has a copy of those around it: a document made to take hours is refused.
const MOST_PREFIXES: usize = 100;

/// Namespaces by their prefixes; the empty one is the default.
pub(crate) type Bound = BTreeMap<String, String>;

/// An element on its way to its end.
struct Open {
    name: String,
    bound: Bound,
    /// Of these, what is written already.
    rendered: Bound,
    written: bool,
    /// A signature right below the root.
    is_signature: bool,
}

/// The part in canonical form, UTF-8.
///
/// # Errors
/// [`Problem`] when it is no XML, or holds what a signature would not cover.
pub(crate) fn canonical(xml: &str, part: Part) -> Result<String, Problem> {
    let mut reader = Reader::from_str(xml);
    reader.config_mut().expand_empty_elements = true;
    let mut writer = Writer {
        part,
        open: Vec::new(),
        text: String::with_capacity(xml.len()),
    };
    let mut roots = 0;
    loop {
        let event = reader.read_event().map_err(malformed)?;
        roots += usize::from(writer.open.is_empty() && matches!(event, Event::Start(_)));
        match event {
            Event::Start(start) => writer.start(&start)?,
            Event::End(_) => writer.end(),
            Event::Text(text) => writer.content(&text.xml10_content())?,
            Event::CData(text) => writer.content(&text.xml10_content())?,
            Event::GeneralRef(reference) => writer.content(&entity(&reference)?)?,
            Event::Decl(declaration) if roots == 0 => check_declaration(&declaration)?,
            Event::Eof => break,
            _ => {
                return Err(Problem::new(
                    "holds a comment, an instruction or a document type, which no signature covers",
                ));
            }
        }
    }
    match writer.open.is_empty() && roots == 1 {
        true => Ok(writer.text),
        false => Err(Problem::new("is no XML: it has not one whole root")),
    }
}

/// The declared form is not signed: only one form is accepted.
fn check_declaration(declaration: &BytesDecl<'_>) -> Result<(), Problem> {
    let version = declaration.version().map_err(malformed)?;
    let encoding = declaration.encoding().transpose().map_err(malformed)?;
    let utf8 = encoding.is_none_or(|encoding| encoding.eq_ignore_ascii_case("UTF-8"));
    match version == "1.0" && utf8 && declaration.standalone().is_none() {
        true => Ok(()),
        false => Err(Problem::new("is not XML 1.0 in UTF-8")),
    }
}

pub(crate) fn malformed(error: impl std::fmt::Display) -> Problem {
    Problem::new(format!("is no XML: {error}"))
}

/// The text of a reference; there are no entities but those of XML itself.
fn entity(name: &str) -> Result<String, Problem> {
    let number = match name.strip_prefix('#') {
        Some(digits) => match digits.strip_prefix('x') {
            Some(digits) => u32::from_str_radix(digits, 16).ok(),
            None => digits.parse().ok(),
        },
        None => None,
    };
    let text = match (number.and_then(char::from_u32), name) {
        (Some(c), _) => c,
        (None, "amp") => '&',
        (None, "lt") => '<',
        (None, "gt") => '>',
        (None, "quot") => '"',
        (None, "apos") => '\'',
        _ => return Err(malformed(format!("&{name}; is not known"))),
    };
    Ok(text.to_string())
}

/// The value of an attribute: references resolved, white space as blanks (XML 1.0, 3.3.3).
pub(crate) fn attribute(raw: &str) -> Result<String, Problem> {
    let raw = raw.replace("\r\n", "\n");
    let mut parts = raw.split('&');
    let mut value = blanks(parts.next().unwrap_or_default());
    for part in parts {
        let (name, rest) = part
            .split_once(';')
            .ok_or_else(|| malformed("an & without its end"))?;
        value += &entity(name)?;
        value += &blanks(rest);
    }
    Ok(value)
}

fn blanks(text: &str) -> String {
    text.replace(['\t', '\n', '\r'], " ")
}

struct Writer {
    part: Part,
    open: Vec<Open>,
    text: String,
}

impl Writer {
    fn start(&mut self, start: &BytesStart<'_>) -> Result<(), Problem> {
        let name = start.name().0.to_owned();
        let outer = self.open.last();
        let bound = outer.map(|open| open.bound.clone()).unwrap_or_default();
        let (bound, attributes) = read_attributes(start, bound)?;
        let (prefix, local) = split(&name);
        let of_signature = namespace(&bound, prefix)? == SIGNATURE;
        let is_signature = self.open.len() == 1 && of_signature && local == "Signature";
        let written = match self.part {
            Part::Enveloping => outer.is_none_or(|open| open.written) && !is_signature,
            // Of the signature itself: one that was moved elsewhere states nothing.
            Part::SignedInfo => outer.is_some_and(|open| {
                open.written || (open.is_signature && of_signature && local == "SignedInfo")
            }),
        };
        let outer = outer.filter(|open| open.written);
        let rendered = outer.map(|open| open.rendered.clone()).unwrap_or_default();
        let mut open = Open {
            name,
            bound,
            rendered,
            written,
            is_signature,
        };
        if written {
            write_start(&mut self.text, &mut open, attributes)?;
        }
        self.open.push(open);
        Ok(())
    }

    fn end(&mut self) {
        // The reader has compared the names.
        if let Some(Open { name, .. }) = self.open.pop().filter(|open| open.written) {
            self.text += &format!("</{name}>");
        }
    }

    fn content(&mut self, content: &str) -> Result<(), Problem> {
        match self.open.last() {
            Some(open) if open.written => self.text += &escaped(content, false),
            Some(_) => (),
            None if content.trim().is_empty() => (),
            None => return Err(malformed("text outside of its root")),
        }
        Ok(())
    }
}

/// Prefixes bound within an element, and its other attributes.
pub(crate) fn read_attributes(
    start: &BytesStart<'_>,
    mut bound: Bound,
) -> Result<(Bound, Vec<(String, String)>), Problem> {
    let mut attributes = Vec::new();
    for found in start.attributes() {
        let found = found.map_err(malformed)?;
        let (key, value) = (found.key.0, attribute(&found.value)?);
        match key.strip_prefix("xmlns:") {
            Some(prefix) => drop(bound.insert(prefix.to_owned(), value)),
            None if key == "xmlns" => drop(bound.insert(String::new(), value)),
            None => attributes.push((key.to_owned(), value)),
        }
    }
    match bound.len() <= MOST_PREFIXES {
        true => Ok((bound, attributes)),
        false => Err(malformed("more namespaces than any certificate has")),
    }
}

/// Prefix and local part of a name.
pub(crate) fn split(name: &str) -> (&str, &str) {
    name.split_once(':').unwrap_or(("", name))
}

pub(crate) fn namespace<'a>(bound: &'a Bound, prefix: &str) -> Result<&'a str, Problem> {
    match (bound.get(prefix), prefix) {
        (Some(uri), _) => Ok(uri),
        (None, "") => Ok(""),
        (None, "xml") => Ok("http://www.w3.org/XML/1998/namespace"),
        (None, _) => Err(malformed(format!(
            "the prefix {prefix} is bound to nothing"
        ))),
    }
}

/// A start tag: namespaces that are used and not yet written, by prefix; attributes by namespace and name.
fn write_start(
    text: &mut String,
    open: &mut Open,
    attributes: Vec<(String, String)>,
) -> Result<(), Problem> {
    *text += &format!("<{}", open.name);
    let mut used = BTreeSet::from([split(&open.name).0.to_owned()]);
    let mut sorted = BTreeMap::new();
    for (name, value) in attributes {
        let (prefix, local) = split(&name);
        // An attribute without prefix is in no namespace.
        let mut uri = "";
        if !prefix.is_empty() {
            uri = namespace(&open.bound, prefix)?;
            used.insert(prefix.to_owned());
        }
        let key = (uri.to_owned(), local.to_owned());
        if sorted.insert(key, (name, value)).is_some() {
            return Err(malformed("an attribute that is there twice"));
        }
    }
    write_namespaces(text, open, used)?;
    for (name, value) in sorted.into_values() {
        *text += &format!(" {name}=\"{}\"", escaped(&value, true));
    }
    *text += ">";
    Ok(())
}

fn write_namespaces(
    text: &mut String,
    open: &mut Open,
    used: BTreeSet<String>,
) -> Result<(), Problem> {
    for prefix in used.into_iter().filter(|prefix| prefix != "xml") {
        let uri = namespace(&open.bound, &prefix)?.to_owned();
        let before = open.rendered.get(&prefix);
        if before.map_or("", String::as_str) != uri {
            let colon = if prefix.is_empty() { "" } else { ":" };
            *text += &format!(" xmlns{colon}{prefix}=\"{}\"", escaped(&uri, true));
            open.rendered.insert(prefix, uri);
        }
    }
    Ok(())
}

/// Text, or the value of an attribute, as canonical XML writes it.
fn escaped(content: &str, attribute: bool) -> String {
    let mut text = String::with_capacity(content.len());
    for c in content.chars() {
        match (c, attribute) {
            ('&', _) => text += "&amp;",
            ('<', _) => text += "&lt;",
            ('>', false) => text += "&gt;",
            ('\r', _) => text += "&#xD;",
            ('"', true) => text += "&quot;",
            ('\t', true) => text += "&#x9;",
            ('\n', true) => text += "&#xA;",
            (c, _) => text.push(c),
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Examples 3.3 and 3.4 of Canonical XML 1.0 without what only a document type can declare, written by
    /// the rules of the exclusive form by hand.
    #[test]
    fn a_document_takes_the_form_of_the_recommendation() {
        for (xml, expected) in [
            ("<?xml version=\"1.0\"?>\n<e1   />\n", "<e1></e1>"),
            (
                "<e3   name = \"elem3\"   id=\"elem3\"   />",
                "<e3 id=\"elem3\" name=\"elem3\"></e3>",
            ),
            (
                "<e5 a:attr='out' b:attr='sorted' attr2='all' attr='I&#39;m' \
                 xmlns:b='http://b' xmlns:a='http://a' xmlns='http://e' xmlns:unused='http://u'/>",
                "<e5 xmlns=\"http://e\" xmlns:a=\"http://a\" xmlns:b=\"http://b\" attr=\"I'm\" \
                 attr2=\"all\" a:attr=\"out\" b:attr=\"sorted\"></e5>",
            ),
            (
                "<e xmlns='http://e'><f xmlns=''><g xmlns='http://e'/></f></e>",
                "<e xmlns=\"http://e\"><f xmlns=\"\"><g xmlns=\"http://e\"></g></f></e>",
            ),
            ("<t>First&#x0d;&#10;Second</t>", "<t>First&#xD;\nSecond</t>"),
            ("<t>a\r\nb\rc</t>", "<t>a\nb\nc</t>"),
            (
                "<v>&#x32;<![CDATA[value>\"0\" && value<\"10\" ?\"valid\":\"error\"]]></v>",
                "<v>2value&gt;\"0\" &amp;&amp; value&lt;\"10\" ?\"valid\":\"error\"</v>",
            ),
            (
                "<n attr='   &#x20;&#13;&#xa;&#9;   \t\n' b='&lt;&quot;>'/>",
                "<n attr=\"    &#xD;&#xA;&#x9;     \" b=\"&lt;&quot;>\"></n>",
            ),
        ] {
            let found = canonical(xml, Part::Enveloping).expect(xml);
            assert_eq!(found, expected);
        }
    }

    #[test]
    fn what_no_signature_covers_is_refused() {
        let many: String = (0..101).map(|n| format!(" xmlns:p{n}='u'")).collect();
        let many = format!("<a{many}/>");
        for xml in [
            "<a>10.0<!-- -->17</a>",
            "<a><?php?></a>",
            "<!DOCTYPE a [<!ENTITY e 'x'>]><a>&e;</a>",
            "<a>&unknown;</a>",
            "<a/><b/>",
            "<a>",
            "<a/>text",
            "<p:a/>",
            "<a b='1' b='2'/>",
            "<a b=1/>",
            "",
            &many,
        ] {
            assert!(canonical(xml, Part::Enveloping).is_err(), "{xml}");
        }
    }
}
