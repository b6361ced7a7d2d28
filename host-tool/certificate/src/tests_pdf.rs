//! The printed certificate.

use super::model::Certificate;
use super::python::python;
use super::tests_dcc::{FULL, seal};
use super::{Format, Language, Options, Particulars, prepare, render};
use calib_record::sample::{THIRD_OCTAVES_HZ, record, text};
use std::ffi::OsStr;

fn full() -> Particulars {
    toml::from_str(FULL).expect("TOML")
}

fn pdf(
    record: &calib_protocol::record::Record,
    particulars: &Particulars,
) -> calib_files::Result<Vec<u8>> {
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

/// Saves the attachment; prints the text of every page, and what ISO 19005-3 wants of
/// the file's structure as another program reads it.
const READ: &str = "\
import sys, json, pypdf
pdf = pypdf.PdfReader(sys.argv[1])
root = pdf.trailer['/Root']
open(sys.argv[2], 'wb').write(pdf.attachments['certificate.dcc.xml'][0])
fonts = [f.get_object() for p in pdf.pages for f in p['/Resources']['/Font'].values()]
files = [f['/DescendantFonts'][0].get_object()['/FontDescriptor'].get_object() for f in fonts]
attached = [f.get_object() for f in root.get('/AF', [])]
intents = [i.get_object() for i in root.get('/OutputIntents', [])]
everything = [o.get_object() for n in range(1, pdf.trailer['/Size']) for o in [pdf.get_object(n)] if o is not None]
dictionaries = [o for o in everything if isinstance(o, dict)]
print(json.dumps({'pages': [p.extract_text() for p in pdf.pages],
  'embedded': [any(k.startswith('/FontFile') for k in f) for f in files],
  'to_unicode': all('/ToUnicode' in f for f in fonts),
  'metadata': root['/Metadata'].get_data().decode(),
  'metadata_filtered': '/Filter' in root['/Metadata'],
  'intents': [[i['/S'], i['/DestOutputProfile'].get_object()['/N']] for i in intents],
  'attached': [[f['/AFRelationship'], f['/UF'], f['/EF']['/F'].get_object()['/Subtype']] for f in attached],
  'encrypted': pdf.is_encrypted, 'identified': len(pdf.trailer['/ID']),
  'active': [o['/S'] for o in dictionaries if o.get('/S') in ('/JavaScript', '/Launch', '/Movie', '/Sound')],
  'lzw': any('/LZWDecode' in str(o.get('/Filter')) for o in dictionaries)}))
";

#[test]
fn a_reader_of_others_finds_number_pages_fonts_and_the_same_dcc() {
    let certificate = Certificate::from_record(&record(&THIRD_OCTAVES_HZ), &full());
    let dcc = render(&certificate, Format::Dcc, Language::De).expect("renders");
    let pdf = render(&certificate, Format::Pdf, Language::De).expect("renders");
    is_read_by_others(&certificate, &pdf, &dcc);
}

/// A signature is appended: what was PDF/A stays so, and all that was there is found again.
#[test]
fn a_signed_one_is_read_like_any_other() {
    let record = record(&THIRD_OCTAVES_HZ);
    let certificate = Certificate::from_record(&record, &full());
    let options = Options {
        particulars: full(),
        seal: Some(seal()),
        ..Options::default()
    };
    let prepared = prepare(&record, &[Format::Pdf, Format::Dcc], &options).expect("prepared");
    let [pdf, dcc] = &prepared.files[..] else {
        panic!("two files");
    };
    is_read_by_others(&certificate, &pdf.content, &dcc.content);
}

fn is_read_by_others(certificate: &Certificate, pdf: &[u8], dcc: &[u8]) {
    let folder = tempfile::tempdir().expect("folder");
    let (path, attached) = (folder.path().join("c.pdf"), folder.path().join("dcc.xml"));
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
        first.contains("10,200") && first.contains("0,069"),
        "{first}"
    );
    let embedded = read["embedded"].as_array().expect("fonts");
    assert!(!embedded.is_empty() && embedded.iter().all(|e| e == true));
    is_pdf_a_3b(&read);
}

/// Requirements of ISO 19005-3:2012 that another program can read, by its clauses. Not all
/// of it: veraPDF, which looks at more, is a Java program that no registry of ours has.
fn is_pdf_a_3b(read: &serde_json::Value) {
    use serde_json::json;
    // 6.6.4: part 3, conformance B, in metadata that is stored in clear (6.6.2.1).
    let metadata = read["metadata"].as_str().expect("XMP");
    for statement in ["<pdfaid:part>3<", "<pdfaid:conformance>B<"] {
        assert!(metadata.contains(statement), "{metadata}");
    }
    assert_eq!(read["metadata_filtered"], false);
    // 6.2.3: one intent, with a profile of red, green and blue.
    assert_eq!(read["intents"], json!([["/GTS_PDFA1", 3]]));
    // 6.8: a file inside says what it is to the document, and of which type it is.
    let attached = read["attached"].as_array().expect("files");
    assert_eq!(attached.len(), 1, "{read}");
    assert_eq!(attached[0][1], "certificate.dcc.xml");
    let relations = ["/Source", "/Data", "/Alternative", "/Supplement"];
    assert!(relations.contains(&attached[0][0].as_str().expect("a name")));
    let subtype = attached[0][2].as_str().expect("a name");
    assert!(subtype.contains("xml"), "{subtype}");
    // 6.1.3: an identifier, no encryption; 6.5.1: nothing that acts; 6.1.7.2: no LZW.
    assert_eq!(read["encrypted"], false);
    assert_eq!(read["identified"], 2);
    assert_eq!(read["active"], json!([]));
    assert_eq!(read["lzw"], false);
    assert_eq!(read["to_unicode"], true);
}

#[test]
fn every_size_and_every_gap_renders() {
    let many: Vec<f32> = (0..200).map(|n| 20.0 * 1.03_f32.powi(n)).collect();
    let mut bare = record(&[160.0]);
    bare.head.labels = Default::default();
    bare.head.labels.dut_serial = text("O'Neil \"#emph[x]\" $1 🎛 中");
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

/// Sets the first page as a printer would, 150 dots to the inch, and reads its square.
const SQUARE: &str = "\
import sys, pypdfium2, zxingcpp
page = pypdfium2.PdfDocument(sys.argv[1])[0].render(scale=150 / 72).to_pil()
codes = zxingcpp.read_barcodes(page)
print('\\n--\\n'.join(f'{c.format.name}\\n{c.text}' for c in codes), end='')
";

#[test]
fn a_reader_of_others_finds_number_sum_and_place_in_the_square() {
    let folder = tempfile::tempdir().expect("folder");
    let path = folder.path().join("c.pdf");
    let record = record(&THIRD_OCTAVES_HZ);
    let sum = super::digest(&record);
    let sum = hex::encode(sum);
    let mut stated = full();
    let long = format!("https://labor.example.org/prüfen?{}", "x".repeat(200));
    for place in [None, Some("https://labor.example.org/verify"), Some(&long)] {
        stated.laboratory.verify_at = place.map(str::to_owned);
        let options = Options {
            particulars: stated.clone(),
            ..Options::default()
        };
        let prepared = prepare(&record, &[Format::Pdf], &options).expect("prepared");
        std::fs::write(&path, &prepared.files[0].content).expect("written");
        let arguments = [OsStr::new("-c"), OsStr::new(SQUARE), path.as_os_str()];
        let Some(output) = python("zxingcpp", &arguments) else {
            return;
        };
        let number = &prepared.number;
        let place = place.unwrap_or("calib verify");
        let expected =
            format!("QRCode\nCERTIFICATE {number}\nRECORD SHA-256 {sum}\nVERIFY {place}");
        let found = String::from_utf8_lossy(&output.stdout);
        assert_eq!(
            found,
            expected,
            "{}",
            String::from_utf8_lossy(&output.stderr)
        );
    }
    stated.laboratory.verify_at = Some("x".repeat(3000));
    let error = pdf(&record, &stated).expect_err("no square is as large");
    assert!(error.to_string().contains("square"), "{error}");
}

/// Text of each page.
const PAGES: &str = "\
import sys, json, pypdf
print(json.dumps([p.extract_text() for p in pypdf.PdfReader(sys.argv[1]).pages]))
";

#[test]
fn a_mark_stands_on_every_page_also_of_a_laboratorys_own_template() {
    let folder = tempfile::tempdir().expect("folder");
    let own = folder.path().join("own.typ");
    let template = "#set document(title: \"own\", date: datetime(year: 2026, month: 1, day: 1))\n\
        = Own page\n#pagebreak()\nsecond\n";
    std::fs::write(&own, template).expect("written");
    let mut emulated = record(&THIRD_OCTAVES_HZ);
    emulated.head.instrument_serial = text("23004100075457494E303120");
    let mut draft = full();
    draft.calibration.approved_by = None;
    for template in [None, Some(own)] {
        draft.layout.template = template;
        let path = folder.path().join("marked.pdf");
        std::fs::write(&path, pdf(&emulated, &draft).expect("renders")).expect("written");
        let arguments = [OsStr::new("-c"), OsStr::new(PAGES), path.as_os_str()];
        let Some(output) = python("pypdf", &arguments) else {
            return;
        };
        let pages: Vec<String> = serde_json::from_slice(&output.stdout).expect("JSON");
        assert!(pages.len() >= 2);
        for (index, page) in pages.iter().enumerate() {
            assert!(
                page.contains("SIMULIERT") && page.contains("ENTWURF"),
                "{index}: {page}"
            );
        }
    }
}
