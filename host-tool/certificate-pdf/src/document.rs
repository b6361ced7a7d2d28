//! Compiles a template to PDF/A-3b.

use crate::fonts;
use typst::diag::SourceDiagnostic;
use typst::foundations::Smart;
use typst::syntax::{DiagSpanKind, Source};
use typst_as_lib::{TypstAsLibError, TypstEngine};
use typst_layout::PagedDocument;
use typst_pdf::{PdfOptions, PdfStandard, PdfStandards};

/// Name of the template among the files.
const MAIN: &str = "certificate.typ";

/// A file the template reads, such as a picture or its data.
#[derive(Clone, Copy, Debug)]
pub struct File<'a> {
    /// Name in the template.
    pub name: &'a str,
    /// Content.
    pub bytes: &'a [u8],
}

/// Why there is no document.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("line {line}: {problem}")]
pub struct Error {
    /// Line of the template, from 1; 0 when the problem has no place there.
    pub line: usize,
    /// Problem.
    pub problem: String,
    /// Suggestion of the typesetter; may be empty.
    pub hint: String,
}

/// Sets `template` with `files` as PDF/A-3b.
///
/// `identifier` must be stable for the document: with it, the same input gives
/// the same bytes. The document's date is the template's affair (`set
/// document(date: ...)`); no clock is read.
///
/// # Errors
/// [`Error`] with the line of the template.
///
/// # Accuracy
/// Same bytes for the same input: test `the_same_input_gives_the_same_bytes`.
pub fn render(template: &str, files: &[File<'_>], identifier: &str) -> Result<Vec<u8>, Error> {
    let engine = TypstEngine::builder()
        .fonts(fonts::all().iter().cloned())
        .with_static_source_file_resolver([(MAIN, template)])
        .with_static_file_resolver(files.iter().map(|file| (file.name, file.bytes)))
        // What one document needed is there for the next: a signed one is set twice, with another DCC inside.
        .comemo_evict_max_age(Some(1))
        .build();
    let compiled = engine.compile::<_, PagedDocument>(MAIN).output;
    let document = compiled.map_err(|error| located(template, &error))?;
    let standards = PdfStandards::new(&[PdfStandard::A_3b]);
    let options = PdfOptions {
        ident: Smart::Custom(identifier.to_owned()),
        creator: Smart::Custom(Some("calib".to_owned())),
        standards: standards.map_err(|error| unlocated(error.message().as_str()))?,
        ..PdfOptions::default()
    };
    typst_pdf::pdf(&document, &options).map_err(|errors| first(template, &errors))
}

fn located(template: &str, error: &TypstAsLibError) -> Error {
    match error {
        TypstAsLibError::TypstSource(errors) => first(template, errors),
        other => unlocated(&other.to_string()),
    }
}

fn unlocated(problem: &str) -> Error {
    Error {
        line: 0,
        problem: problem.to_owned(),
        hint: String::new(),
    }
}

/// The first diagnostic: the others usually follow from it.
fn first(template: &str, errors: &[SourceDiagnostic]) -> Error {
    let Some(error) = errors.first() else {
        return unlocated("the typesetter gave no reason");
    };
    let hint = error.hints.first().map(|hint| hint.v.to_string());
    Error {
        line: line(template, error).unwrap_or(0),
        problem: error.message.to_string(),
        hint: hint.unwrap_or_default(),
    }
}

fn line(template: &str, error: &SourceDiagnostic) -> Option<usize> {
    let (id, range) = match error.span.get() {
        DiagSpanKind::Detached => return None,
        // A place in a file that is read, not in the template.
        DiagSpanKind::Range { .. } => return None,
        DiagSpanKind::Number { id, num, sub_range } => (id, (num, sub_range)),
    };
    let source = Source::new(id, template.to_owned());
    let range = source.range(range.0, range.1)?;
    Some(source.lines().byte_to_line(range.start)? + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEMPLATE: &str = r#"#set document(title: "Test", date: datetime(year: 2026, month: 11, day: 20))
#set text(font: "Liberation Sans")
#let data = json("data.json")
#pdf.attach("data.xml", read("data.xml", encoding: none), relationship: "data", mime-type: "application/xml", description: "data")
Hello #data.name
"#;

    fn files() -> [File<'static>; 2] {
        [
            File {
                name: "data.json",
                bytes: br#"{"name": "world"}"#,
            },
            File {
                name: "data.xml",
                bytes: b"<certificate/>",
            },
        ]
    }

    #[test]
    fn a_document_is_pdf_a_3b_with_its_attachment() {
        let pdf = render(TEMPLATE, &files(), "test").expect("compiles");
        assert!(pdf.starts_with(b"%PDF-1.7"));
        let text = String::from_utf8_lossy(&pdf);
        assert!(text.contains("data.xml") && text.contains("/AFRelationship"));
        // The metadata of PDF/A are not compressed.
        assert!(text.contains("pdfaid:part>3<") && text.contains("pdfaid:conformance>B<"));
    }

    #[test]
    fn the_same_input_gives_the_same_bytes() {
        let once = render(TEMPLATE, &files(), "test").expect("compiles");
        assert_eq!(once, render(TEMPLATE, &files(), "test").expect("compiles"));
    }

    #[test]
    fn a_template_loads_no_plugin() {
        let plugin = File {
            name: "plugin.wasm",
            bytes: b"\0asm\x01\0\0\0",
        };
        let error = render("#plugin(\"plugin.wasm\")", &[plugin], "test").expect_err("a plugin");
        assert_eq!(error.line, 1, "{error:?}");
        assert!(error.problem.contains("runs no WebAssembly"), "{error:?}");
    }

    #[test]
    fn a_template_that_does_not_compile_names_its_line() {
        let error = render("Hello\n\n#lett x = 1\n", &[], "test").expect_err("misspelt");
        assert_eq!(error.line, 3, "{error:?}");
        let error = render("#read(\"none.txt\")", &[], "test").expect_err("no such file");
        assert_eq!(error.line, 1, "{error:?}");
    }
}
