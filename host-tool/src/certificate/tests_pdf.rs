//! The printed certificate.

use super::model::Certificate;
use super::python::python;
use super::testing::{THIRD_OCTAVES_HZ, record, text};
use super::tests_dcc::FULL;
use super::{Format, Language, Particulars, render};
use std::ffi::OsStr;

fn full() -> Particulars {
    toml::from_str(FULL).expect("TOML")
}

fn pdf(
    record: &calib_protocol::record::Record,
    particulars: &Particulars,
) -> crate::Result<Vec<u8>> {
    render(
        &Certificate::from_record(record, particulars),
        Format::Pdf,
        Language::De,
    )
}

#[test]
fn the_same_record_gives_the_same_document() {
    let record = record(&THIRD_OCTAVES_HZ);
    let once = pdf(&record, &full()).expect("renders");
    assert_eq!(once, pdf(&record, &full()).expect("renders"));
    let text = String::from_utf8_lossy(&once);
    assert!(text.contains("pdfaid:part>3<") && text.contains("certificate.dcc.xml"));
}

/// Saves the attachment and prints text and embedded fonts of every page.
const READ: &str = "\
import sys, json, pypdf
pdf = pypdf.PdfReader(sys.argv[1])
open(sys.argv[2], 'wb').write(pdf.attachments['certificate.dcc.xml'][0])
fonts = [f.get_object() for p in pdf.pages for f in p['/Resources']['/Font'].values()]
files = [f['/DescendantFonts'][0].get_object()['/FontDescriptor'].get_object() for f in fonts]
print(json.dumps({'pages': [p.extract_text() for p in pdf.pages],
  'embedded': [any(k.startswith('/FontFile') for k in f) for f in files]}))
";

#[test]
fn a_reader_of_others_finds_number_pages_fonts_and_the_same_dcc() {
    let certificate = Certificate::from_record(&record(&THIRD_OCTAVES_HZ), &full());
    let dcc = render(&certificate, Format::Dcc, Language::De).expect("renders");
    let folder = tempfile::tempdir().expect("folder");
    let (path, attached) = (folder.path().join("c.pdf"), folder.path().join("dcc.xml"));
    let pdf = render(&certificate, Format::Pdf, Language::De).expect("renders");
    std::fs::write(&path, pdf).expect("written");
    let arguments = [
        OsStr::new("-c"),
        OsStr::new(READ),
        path.as_os_str(),
        attached.as_os_str(),
    ];
    let Some(output) = python("pypdf", &arguments) else {
        return;
    };
    let complaint = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{complaint}");
    assert_eq!(std::fs::read(attached).expect("attached"), dcc);
    let read: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let pages = read["pages"].as_array().expect("pages");
    for (index, page) in pages.iter().enumerate() {
        let page = page.as_str().expect("text");
        assert!(page.contains(&certificate.number), "page {index}: {page}");
        let number = format!("Seite {} von {}", index + 1, pages.len());
        assert!(page.contains(&number), "page {index}: {page}");
    }
    let first = pages[0].as_str().expect("text");
    assert!(
        first.contains("10,200") && first.contains("0,079"),
        "{first}"
    );
    let embedded = read["embedded"].as_array().expect("fonts");
    assert!(!embedded.is_empty() && embedded.iter().all(|e| e == true));
}

#[test]
fn every_size_and_every_gap_renders() {
    let many: Vec<f32> = (0..200).map(|n| 20.0 * 1.03_f32.powi(n)).collect();
    let mut bare = record(&[160.0]);
    bare.labels = Default::default();
    bare.labels.dut_serial = text("O'Neil \"#emph[x]\" $1 🎛 中");
    for record in [record(&[]), record(&[160.0]), record(&many), bare] {
        pdf(&record, &Particulars::default()).expect("renders");
    }
}

#[test]
fn a_template_of_the_laboratory_takes_the_place_of_ours() {
    let folder = tempfile::tempdir().expect("folder");
    let path = folder.path().join("ours.typ");
    let mut particulars = full();
    particulars.layout.template = Some(path.clone());
    std::fs::write(
        &path,
        "#set document(date: datetime(year: 2026, month: 1, day: 1))\n#json(\"certificate.json\").number",
    )
    .expect("written");
    pdf(&record(&[160.0]), &particulars).expect("renders");
    std::fs::write(&path, "= Title\n#let x = (\n").expect("written");
    let error = pdf(&record(&[160.0]), &particulars).expect_err("open parenthesis");
    assert!(error.to_string().contains("ours.typ:2"), "{error}");
}

#[test]
fn a_logo_that_is_no_picture_is_refused() {
    let mut particulars = full();
    particulars.layout.logo = Some("logo.docx".into());
    let error = pdf(&record(&[160.0]), &particulars).expect_err("no picture");
    assert!(error.to_string().contains("logo.docx"), "{error}");
}
