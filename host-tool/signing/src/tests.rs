//! Keys and signatures, and what is done to them. Verifiers of others look at the same in `host-tool/tests`.

use crate::{Certificate, Kind, LaboratoryKey, sign, verify};
use jiff::Timestamp;
use std::path::{Path, PathBuf};

fn file(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("test-keys")
        .join(name)
}

/// 23 November 2026.
fn now() -> Timestamp {
    Timestamp::from_second(1_795_392_000).expect("a time")
}

fn key(name: &str) -> LaboratoryKey {
    LaboratoryKey::open(&file(name), "test", now()).expect(name)
}

fn known(name: &str) -> Vec<Certificate> {
    Certificate::read(&file(name)).expect(name)
}

const DCC: &str = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
    <dcc:c xmlns:dcc=\"https://ptb.de/dcc\" schemaVersion=\"3.3.0\">\n  \
    <dcc:name>R&amp;D &#214;l \u{b5}V</dcc:name>\n  <dcc:s unit='\\volt'>10.017 9.98</dcc:s>\n</dcc:c>\n";

#[test]
fn a_key_signs_what_its_certificate_or_its_authority_proves() {
    for (name, own, other) in [
        ("p256.p12", "p256.pem", "rsa.pem"),
        ("rsa.p12", "rsa.pem", "p256.pem"),
        ("issued.p12", "authority.pem", "p256.pem"),
    ] {
        let signed = sign(Kind::Dcc, DCC.as_bytes(), &key(name), now()).expect(name);
        let signature = verify(Kind::Dcc, &signed).expect(name);
        assert!(signature.is_of(&known(own), now()), "{name}");
        assert!(!signature.is_of(&known(other), now()), "{name}");
        assert!(!signature.is_of(&[], now()), "{name}");
        let again = sign(Kind::Dcc, &signed, &key(name), now()).expect_err("twice");
        assert!(again.to_string().contains("already"), "{again}");
    }
}

/// The authority ends in 2120: what it issued is nobody's after that.
#[test]
fn an_authority_that_is_not_in_force_proves_nothing() {
    let signed = sign(Kind::Dcc, DCC.as_bytes(), &key("issued.p12"), now()).expect("signs");
    let signature = verify(Kind::Dcc, &signed).expect("holds");
    let later = Timestamp::from_second(4_735_000_000).expect("2120");
    assert!(!signature.is_of(&known("authority.pem"), later));
    assert!(!signature.is_in_force(later));
}

#[test]
fn a_key_that_may_not_sign_says_why() {
    let long_ago = Timestamp::from_second(1_500_000_000).expect("a time");
    for (name, password, at, reason) in [
        ("p256.p12", "Test", now(), "password"),
        ("p256.p12", "", now(), "password"),
        ("p256.p12", "test", long_ago, "begins on"),
        ("expired.p12", "test", now(), "ended on 2025-01-01"),
        ("p521.p12", "test", now(), "P-256"),
        ("old.p12", "test", now(), "old way"),
        ("authority.p12", "test", now(), "not for signatures"),
        ("p256.pem", "test", now(), "no PKCS#12 file"),
        ("README.md", "test", now(), "no PKCS#12 file"),
        ("missing.p12", "test", now(), "read"),
    ] {
        let error = LaboratoryKey::open(&file(name), password, at).expect_err(name);
        assert!(error.to_string().contains(reason), "{name}: {error}");
    }
}

/// A sum under the password is over key and certificates: an altered file opens to these or to nothing, and
/// none brings the tool down.
#[test]
fn an_altered_key_opens_to_no_other() {
    let whole = std::fs::read(file("p256.p12")).expect("key");
    let own = known("p256.pem");
    let folder = tempfile::tempdir().expect("folder");
    let path = folder.path().join("altered.p12");
    for at in (0..whole.len()).step_by(13) {
        let mut altered = whole.clone();
        altered[at] ^= 1 << (at % 8);
        std::fs::write(&path, &altered).expect("written");
        if let Ok(opened) = LaboratoryKey::open(&path, "test", now()) {
            assert_eq!(opened.certificates(), own, "byte {at}");
        }
        let short = std::fs::write(&path, &whole[..at]);
        short.expect("written");
        assert!(
            LaboratoryKey::open(&path, "test", now()).is_err(),
            "{at} bytes"
        );
    }
}

/// Every bit of the document, its signature and its certificate but for the XML declaration, which no
/// signature of XML covers: not one is taken for the laboratory's.
#[test]
fn no_bit_of_a_document_can_be_turned() {
    let signed = sign(Kind::Dcc, DCC.as_bytes(), &key("p256.p12"), now()).expect("signs");
    let known = known("p256.pem");
    let root = DCC.find("<dcc:c").expect("root");
    let end = signed.iter().rposition(|byte| *byte == b'>').expect("end") + 1;
    for bit in 8 * root..8 * end {
        let mut altered = signed.clone();
        altered[bit / 8] ^= 1 << (bit % 8);
        let taken = verify(Kind::Dcc, &altered).is_ok_and(|one| one.is_of(&known, now()));
        assert!(!taken, "bit {} of byte {}", bit % 8, bit / 8);
    }
}

#[test]
fn what_is_put_into_a_signed_document_is_noticed() {
    let signed = sign(Kind::Dcc, DCC.as_bytes(), &key("p256.p12"), now()).expect("signs");
    let signed = String::from_utf8(signed).expect("UTF-8");
    let with = |from: &str, to: &str| signed.replacen(from, to, 1);
    for altered in [
        with("10.017", "10.0<!-- -->17"),
        with("10.017", "10.<?x?>017"),
        with("<dcc:name>", "<dcc:name><![CDATA[x]]>"),
        with("</dcc:c>", "<dcc:more/></dcc:c>"),
        with("</dcc:c>", " </dcc:c>"),
        with("<dcc:c ", "<!DOCTYPE c><dcc:c "),
        with("URI=\"\"", "URI=\"#a\""),
        with("URI=\"\"", "URI=\"\" Id=\"a\""),
        with("#sha256", "#sha1"),
        with("ecdsa-sha256", "rsa-sha256"),
        with(
            "<ds:Transforms>",
            "<ds:Transforms><ds:Transform Algorithm=\"x\"/>",
        ),
        with("</ds:SignedInfo>", "<ds:Object/></ds:SignedInfo>"),
        with(
            "</ds:Signature>",
            "</ds:Signature><ds:Signature xmlns:ds=\"http://www.w3.org/2000/09/xmldsig#\"/>",
        ),
        with("version=\"1.0\"", "version=\"1.1\""),
    ] {
        assert_ne!(altered, signed);
        assert!(verify(Kind::Dcc, altered.as_bytes()).is_err(), "{altered}");
    }
}

/// The part the laboratory signed is moved to another place, and the part read in its own place is the forger's: of
/// another namespace, so that the canonical form of the one is not that of the other.
#[test]
fn nothing_is_wrapped_around_what_was_signed() {
    let signed = sign(Kind::Dcc, DCC.as_bytes(), &key("p256.p12"), now()).expect("signs");
    let signed = String::from_utf8(signed).expect("UTF-8");
    let part = |from: &str, to: &str| {
        let (start, end) = (signed.find(from).expect(from), signed.find(to).expect(to));
        &signed[start..end + to.len()]
    };
    let genuine = part("<ds:SignedInfo>", "</ds:SignedInfo>");
    let forged_text = DCC.replace("10.017", "99.999");
    let dsig = "xmlns:ds=\"http://www.w3.org/2000/09/xmldsig#\"";
    for (place, name) in [
        ("dcc:moved", "x:SignedInfo"),
        ("ds:Signature2", "x:SignedInfo"),
    ] {
        let wrapped = format!("<{place} {dsig}>{genuine}</{place}></dcc:c>");
        let document = forged_text.replace("</dcc:c>", &wrapped);
        let form = crate::canonical::canonical(&document, crate::canonical::Part::Enveloping);
        let sum = <sha2::Sha256 as sha2::Digest>::digest(form.expect("canonical"));
        let digest = base64::Engine::encode(&base64::engine::general_purpose::STANDARD, sum);
        let own = part("<ds:DigestValue>", "</ds:DigestValue>");
        let forged = genuine.replace(own, &format!("<ds:DigestValue>{digest}</ds:DigestValue>"));
        let forged = forged
            .replace("ds:SignedInfo>", &format!("{name}>"))
            .replacen('>', " xmlns:x=\"urn:forger\">", 1);
        let signature = part("<ds:Signature ", "</ds:Signature>").replace(genuine, &forged);
        let document = document.replace("</dcc:c>", &format!("{signature}</dcc:c>"));
        let found = verify(Kind::Dcc, document.as_bytes());
        assert!(found.is_err(), "{document}");
    }
}

#[test]
fn what_is_neither_pdf_nor_xml_is_refused_without_a_panic() {
    let key = key("p256.p12");
    for content in [
        &b"%PDF-1.7"[..],
        b"%PDF-1.7\nstartxref\n99999999999999999999\n%%EOF",
        b"%PDF-1.7\nxref\n0 1\ntrailer\n<</Size 1/Root 9 0 R>>\nstartxref\n9\n%%EOF",
        b"%PDF-1.7\nxref\n0 1\ntrailer\n<</Size 1/Root 4294967295 0 R>>\nstartxref\n9\n%%EOF",
        b"%PDF-1.7 /ByteRange [0 1 18446744073709551615 2] /Contents<00>",
        b"%PDF-1.7 /ByteRange [0 58 62 0] /Contents<>",
        b"%PDF-1.7 /ByteRange",
    ] {
        assert!(sign(Kind::Pdf, content, &key, now()).is_err());
        assert!(verify(Kind::Pdf, content).is_err());
    }
    for content in [
        "<",
        "<a",
        "<a></a",
        "<a/>",
        "</a>",
        "\u{0}",
        "<a>&#x110000;</a>",
    ] {
        let made = sign(Kind::Dcc, content.as_bytes(), &key, now());
        assert!(made.is_err(), "{content}");
        assert!(verify(Kind::Dcc, content.as_bytes()).is_err(), "{content}");
    }
}
