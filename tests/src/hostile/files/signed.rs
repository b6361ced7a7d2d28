//! Certificates that say they are signed.

use calib_signing::{Certificate, Kind, LaboratoryKey, sign, verify};
use jiff::Timestamp;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

/// 23 November 2026.
fn now() -> Timestamp {
    Timestamp::from_second(1_795_392_000).unwrap_or_default()
}

fn file(name: &str) -> PathBuf {
    let keys = Path::new(env!("CARGO_MANIFEST_DIR")).join("../host-tool/signing/test-keys");
    keys.join(name)
}

static KNOWN: LazyLock<Vec<Certificate>> =
    LazyLock::new(|| Certificate::read(&file("rsa.pem")).expect("a certificate"));
static SEEDS: LazyLock<Vec<(&'static str, Vec<u8>)>> = LazyLock::new(seeds);

/// A file is taken for the laboratory's only if the laboratory signed it: a PDF to the byte but for the case of the
/// digits of its signature, a DCC to the same text in canonical form, which begins with its root.
pub fn signed(data: &[u8]) {
    let Some(kind) = Kind::of(data) else {
        return;
    };
    // Whether there is one is asked of any file.
    let _ = kind.is_signed(data);
    let Ok(signature) = verify(kind, data) else {
        return;
    };
    if kind == Kind::Pdf && signature.is_of(&KNOWN, now()) {
        let own = SEEDS
            .iter()
            .any(|(_, seed)| seed.eq_ignore_ascii_case(data));
        assert!(own, "a PDF the laboratory never signed");
    }
}

/// A small DCC and the smallest PDF there is, signed: RSA, so the same bytes each time.
pub(super) fn seeds() -> Vec<(&'static str, Vec<u8>)> {
    let key = LaboratoryKey::open(&file("rsa.p12"), "test", now()).expect("a key");
    let dcc = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<dcc:c xmlns:dcc=\"https://ptb.de/dcc\">\
               <dcc:s>10.017 9.98</dcc:s></dcc:c>\n";
    let sign = |kind, content: &[u8]| sign(kind, content, &key, now()).expect("signs");
    vec![
        ("dcc", sign(Kind::Dcc, dcc.as_bytes())),
        ("pdf", sign(Kind::Pdf, &smallest_pdf())),
    ]
}

fn smallest_pdf() -> Vec<u8> {
    let objects = [
        "<</Type/Catalog/Pages 2 0 R>>",
        "<</Type/Pages/Count 1/Kids[3 0 R]>>",
        "<</Type/Page/Parent 2 0 R/MediaBox[0 0 9 9]>>",
    ];
    let mut pdf = "%PDF-1.7\n".to_owned();
    let mut table = "xref\n0 4\n0000000000 65535 f \n".to_owned();
    for (at, object) in objects.iter().enumerate() {
        table += &format!("{:010} 00000 n \n", pdf.len());
        pdf += &format!("{} 0 obj\n{object}\nendobj\n", at + 1);
    }
    let start = pdf.len();
    format!("{pdf}{table}trailer\n<</Size 4/Root 1 0 R>>\nstartxref\n{start}\n%%EOF\n").into()
}
