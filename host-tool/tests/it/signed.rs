//! Certificates a laboratory signed, as verifiers see them that are not ours: pyHanko and xmlsec1.

use crate::command_line::{schemas, text};
use crate::python;
use crate::{tool, typed, words};
use calib_output::conforms::check_output;
use calib_record::sample;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use rayon::iter::{IndexedParallelIterator, IntoParallelIterator, ParallelIterator};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const STEM: &str = "certificate-CAL-0042-000017";

pub(crate) fn key(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("signing/test-keys")
        .join(name)
}

fn calib(folder: &Path, password: &str, arguments: &[&str]) -> Output {
    let mut tool = tool(folder);
    tool.env("CALIB_KEY_PASSWORD", password);
    let output = tool.args(arguments).output().expect("calib starts");
    if output.status.success() || arguments[0] == "verify" {
        check_output(&schemas(), arguments, &output.stdout).expect("as in its schema");
    }
    output
}

/// A folder with a record, and what a DCC cannot be without.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("folder");
    let record = sample::bytes(&sample::record(&sample::THIRD_OCTAVES_HZ));
    std::fs::write(folder.path().join("record.bin"), record).expect("written");
    let house = "[laboratory]\ncountry = 'DE'\nname = 'Käse & Söhne'\n";
    std::fs::write(folder.path().join("house.toml"), house).expect("written");
    folder
}

/// PDF and DCC signed by this key as they were made.
fn certificates(folder: &Path, name: &str) -> [PathBuf; 2] {
    let key = key(name);
    let arguments = [
        "certificate",
        "record.bin",
        "--format",
        "pdf,dcc",
        "--particulars",
        "house.toml",
        "--sign",
        key.to_str().expect("UTF-8"),
    ];
    let output = calib(folder, "test", &arguments);
    assert!(output.status.success(), "{}", text(&output.stderr));
    ["pdf", "dcc.xml"].map(|extension| folder.join(format!("{STEM}.{extension}")))
}

/// Verdict of pyHanko on a PDF and on copies of it with one bit turned; the DCC inside goes to a file.
const PYHANKO: &str = "\
import sys, io, json, logging, pypdf
from pyhanko.keys import load_cert_from_pemder
from pyhanko.pdf_utils.reader import PdfFileReader
from pyhanko.sign.validation import validate_pdf_signature
from pyhanko_certvalidator import ValidationContext
logging.disable(logging.CRITICAL)
pdf, root, turned, attached = sys.argv[1:]
root = load_cert_from_pemder(root)
def status(file):
    reader = PdfFileReader(io.BytesIO(file))
    signature, = reader.embedded_signatures
    return signature, validate_pdf_signature(signature, ValidationContext(trust_roots=[root]))
def accepts(file):
    try:
        return status(file)[1].bottom_line
    except Exception:
        return False
whole = open(pdf, 'rb').read()
signature, found = status(whole)
open(attached, 'wb').write(pypdf.PdfReader(pdf).attachments['certificate.dcc.xml'][0])
taken = []
for bit in json.load(open(turned)):
    altered = bytearray(whole)
    altered[bit // 8] ^= 1 << bit % 8
    if accepts(bytes(altered)):
        taken.append(bit)
print(json.dumps({'good': found.bottom_line, 'coverage': found.coverage.name,
  'filter': str(signature.sig_object['/SubFilter']), 'signed': [a['type'].native for a in signature.signer_info['signed_attrs']],
  'unchanged': accepts(whole), 'taken': taken}))
";

/// Bits of the file from its seed, `count` of them, outside of these bytes.
fn bits(length: usize, count: usize, without: std::ops::Range<usize>) -> Vec<usize> {
    let mut generator = ChaCha8Rng::seed_from_u64(18);
    let any = std::iter::repeat_with(|| generator.next_u64() as usize % (8 * length));
    any.filter(|bit| !without.contains(&(bit / 8)))
        .take(count)
        .collect()
}

/// The digits of the signature of a PDF, with their brackets.
fn digits(pdf: &[u8]) -> std::ops::Range<usize> {
    let start = pdf
        .windows(10)
        .rposition(|found| found == b"/Contents<")
        .expect("signed")
        + 9;
    let end = pdf[start..]
        .iter()
        .position(|byte| *byte == b'>')
        .expect("end");
    start..start + end + 1
}

fn proof(folder: &Path, file: &Path, certificate: Option<&str>) -> (Option<i32>, String) {
    let certificate = certificate.map(key);
    let mut arguments = vec!["verify", file.to_str().expect("UTF-8"), "--json"];
    if let Some(certificate) = &certificate {
        arguments.extend(["--certificate", certificate.to_str().expect("UTF-8")]);
    }
    let output = calib(folder, "", &arguments);
    let said: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let proof = said[0]["proof"].as_str().expect("a proof").to_owned();
    (output.status.code(), proof)
}

/// Each key: pyHanko takes the PDF as valid and whole, and none of 150 copies with one bit turned.
#[test]
fn pyhanko_takes_a_signed_pdf_and_no_altered_one() {
    for (name, root) in [
        ("p256.p12", "p256.pem"),
        ("rsa.p12", "rsa.pem"),
        ("issued.p12", "authority.pem"),
    ] {
        let folder = folder();
        let [pdf, dcc] = certificates(folder.path(), name);
        let (turned, attached) = (folder.path().join("bits"), folder.path().join("inside.xml"));
        let whole = std::fs::read(&pdf).expect("PDF");
        let bits = bits(whole.len(), 150, digits(&whole));
        std::fs::write(&turned, serde_json::to_vec(&bits).expect("JSON")).expect("written");
        let Some(output) = python::run(PYHANKO, &[&pdf, &key(root), &turned, &attached]) else {
            return;
        };
        assert!(output.status.success(), "{}", text(&output.stderr));
        let found: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
        assert_eq!(found["good"], true, "{name}: {found}");
        assert_eq!(found["coverage"], "ENTIRE_FILE");
        assert_eq!(found["filter"], "/ETSI.CAdES.detached");
        let signed = ["content_type", "message_digest", "signing_certificate_v2"];
        assert_eq!(found["signed"], serde_json::json!(signed));
        assert_eq!(found["taken"], serde_json::json!([]), "{name}");
        // The DCC inside is the signed one beside it.
        let inside = std::fs::read(attached).expect("attached");
        assert!(inside == std::fs::read(dcc).expect("DCC"), "{name}");
    }
}

/// xmlsec1's verdict; `None`, after saying so, where it is not installed. In CI that is a failure.
fn xmlsec(root: &str, file: &Path) -> Option<bool> {
    let Some(program) = std::env::var_os("CALIB_XMLSEC1") else {
        assert!(std::env::var_os("CI").is_none(), "CALIB_XMLSEC1 is not set");
        println!("CALIB_XMLSEC1 is not set: not verified by another program");
        return None;
    };
    let output = Command::new(program)
        .args(["--verify", "--enabled-key-data", "x509", "--trusted-pem"])
        .args([&key(root), file])
        // It trusts this certificate and none of the computer's, whose reading takes most of a start.
        .env("SSL_CERT_FILE", "/dev/null")
        .env("SSL_CERT_DIR", "/dev/null")
        .output()
        .expect("xmlsec1 starts");
    Some(output.status.success())
}

/// Bits of a signed DCC that its signature is over: every byte of what the object is, and others anywhere.
fn signed_bits(dcc: &str) -> Vec<usize> {
    let place = |what: &str| dcc.find(what).expect(what);
    let items = place("<dcc:items>")..place("</dcc:items>");
    let every_byte = items.map(|byte| 8 * byte + byte % 8);
    let root = place("<dcc:digital");
    let stated = place("<ds:SignedInfo>")..place("</ds:SignedInfo>");
    let value = stated.end..place("</ds:Signature>") + 1;
    let covered = |bit: &usize| bit / 8 >= root && !value.contains(&(bit / 8));
    let anywhere = bits(dcc.trim_end().len(), 300, 0..root);
    let in_stated = stated.map(|byte| 8 * byte + byte % 7);
    every_byte
        .chain(anywhere)
        .chain(in_stated)
        .filter(covered)
        .collect()
}

/// Each key: xmlsec1 takes the DCC, and none with one bit turned; no more does `calib verify`.
#[test]
fn xmlsec_takes_a_signed_dcc_and_no_altered_one() {
    for (name, root, every) in [
        ("p256.p12", "p256.pem", 1),
        ("issued.p12", "authority.pem", 16),
    ] {
        let folder = folder();
        let [_, path] = certificates(folder.path(), name);
        let dcc = std::fs::read_to_string(&path).expect("DCC");
        let known = calib_signing::Certificate::read(&key(root)).expect("certificate");
        match xmlsec(root, &path) {
            Some(taken) => assert!(taken, "{name}"),
            None => return,
        }
        let bits = signed_bits(&dcc);
        assert!(bits.len() > 1000, "{}", bits.len());
        // A start of the program for each bit, which takes the longest of all these tests.
        bits.into_par_iter().step_by(every).for_each(|bit| {
            let mut altered = dcc.clone().into_bytes();
            altered[bit / 8] ^= 1 << (bit % 8);
            let file = folder.path().join(format!("altered-{bit}.xml"));
            std::fs::write(&file, &altered).expect("written");
            assert_eq!(xmlsec(root, &file), Some(false), "{name}: bit {bit}");
            std::fs::remove_file(&file).expect("removed");
            let ours = calib_signing::verify(calib_signing::Kind::Dcc, &altered);
            let now = jiff::Timestamp::now();
            assert!(
                !ours.is_ok_and(|one| one.is_of(&known, now)),
                "{name}: bit {bit}"
            );
        });
    }
}

/// Findings of the tool itself, without another program: of the certificate, of none, of another, and of one that was
/// altered, added to, cut off or never signed.
#[test]
fn the_tool_says_what_is_proven_and_what_is_not() {
    let folder = folder();
    let at = folder.path();
    let files = certificates(at, "issued.p12");
    for file in &files {
        let of = |certificate| proof(at, file, certificate);
        assert_eq!(of(Some("authority.pem")), (Some(0), "proven".into()));
        assert_eq!(of(None), (Some(7), "key_not_known".into()));
        assert_eq!(of(Some("p256.pem")), (Some(7), "key_not_known".into()));
        let whole = std::fs::read(file).expect("file");
        let altered = at.join("altered");
        let half = whole.len() / 2;
        let more = [&whole[..], b"\n% more"].concat();
        for (content, is_pdf) in [
            (&whole[..half], true),
            (&more, true),
            (&whole[..half], false),
        ] {
            std::fs::write(&altered, content).expect("written");
            let (code, proof) = proof(at, &altered, Some("authority.pem"));
            assert!(code == Some(7) && proof != "proven", "{proof} {is_pdf}");
        }
        // What a signature's own digits and the blanks of its element may be written as is no statement.
        let turned = match file.extension().is_some_and(|end| end == "pdf") {
            true => bits(whole.len(), 20, digits(&whole)),
            false => signed_bits(&String::from_utf8_lossy(&whole)),
        };
        for bit in turned.into_iter().take(20) {
            let mut turned = whole.clone();
            turned[bit / 8] ^= 1 << (bit % 8);
            std::fs::write(&altered, turned).expect("written");
            let (code, proof) = proof(at, &altered, Some("authority.pem"));
            assert!(code == Some(7) && proof != "proven", "bit {bit}: {proof}");
        }
    }
    let words = calib(at, "", &["verify", files[0].to_str().expect("UTF-8")]);
    let words = text(&words.stdout);
    assert!(
        words.contains("nobody here knows") && words.contains("SHA-256"),
        "{words}"
    );
}

/// Both kinds as they are given out today, signed afterwards, once.
#[test]
fn what_was_issued_is_signed_afterwards_once() {
    let folder = folder();
    let at = folder.path();
    let usual = ["certificate", "record.bin", "--format", "pdf,dcc,csv"];
    let made = calib(
        at,
        "",
        &[&usual[..], &["--particulars", "house.toml"]].concat(),
    );
    assert!(made.status.success(), "{}", text(&made.stderr));
    let (pdf, dcc) = (format!("{STEM}.pdf"), format!("{STEM}.dcc.xml"));
    let key = key("p256.p12");
    let key = key.to_str().expect("UTF-8");
    let before = std::fs::read(at.join(&pdf)).expect("PDF");
    let both = ["sign", &pdf, &dcc, "--key", key];
    let signed = calib(at, "test", &both);
    assert!(signed.status.success(), "{}", text(&signed.stderr));
    assert!(
        std::fs::read(at.join(&pdf)).expect("PDF") == before,
        "stays"
    );
    let signed_pdf = at.join(format!("{STEM}.signed.pdf"));
    // Appended: every byte of before is still there.
    assert!(
        std::fs::read(&signed_pdf)
            .expect("signed")
            .starts_with(&before)
    );
    for file in [signed_pdf, at.join(format!("{STEM}.signed.dcc.xml"))] {
        assert_eq!(
            proof(at, &file, Some("p256.pem")),
            (Some(0), "proven".into())
        );
    }
    assert_eq!(
        proof(at, &at.join(&pdf), None),
        (Some(7), "not_signed".into())
    );
    for (arguments, password, code, said) in [
        (
            ["sign", &format!("{STEM}.signed.pdf"), "--key", key],
            "test",
            6,
            "signed already",
        ),
        (
            ["sign", &format!("{STEM}.csv"), "--key", key],
            "test",
            6,
            "neither PDF nor DCC",
        ),
        (["sign", &pdf, "--key", key], "wrong", 6, "password"),
        (["sign", &pdf, "--key", "none.p12"], "test", 1, "none.p12"),
    ] {
        let refused = calib(at, password, &arguments);
        assert_eq!(
            refused.status.code(),
            Some(code),
            "{}",
            text(&refused.stderr)
        );
        assert!(
            text(&refused.stderr).contains(said),
            "{}",
            text(&refused.stderr)
        );
    }
}

/// The commands of docs/certificate.md, with the lines shown for each; `...` stands for lines left out.
fn shown() -> Vec<(Vec<String>, Vec<String>)> {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/certificate.md");
    let page = std::fs::read_to_string(page).expect("the page");
    let blocks = page.split("```console\n$ ").skip(1);
    let block = |block: &str| {
        let mut lines = block.split("\n```").next().unwrap_or_default().lines();
        let command = lines.next().unwrap_or_default();
        let words = command.split_whitespace().map(str::to_owned);
        (words.collect(), lines.map(str::to_owned).collect())
    };
    blocks.map(block).collect()
}

/// A verifier by its name, as `./run test` has set it up; `None`, after saying so, where it has not. In CI that is a
/// failure.
fn verifier(name: &str) -> Option<PathBuf> {
    let found = match name {
        "xmlsec1" => std::env::var_os("CALIB_XMLSEC1").map(PathBuf::from),
        name => {
            std::env::var_os("CALIB_PYTHON").map(|python| Path::new(&python).with_file_name(name))
        }
    };
    if found.is_none() {
        assert!(std::env::var_os("CI").is_none(), "{name} is not there");
        println!("{name} is not there: nobody looks what it prints");
    }
    found
}

#[test]
fn what_verifiers_of_others_print_is_what_the_page_shows() {
    let folder = folder();
    let at = folder.path();
    let (pdf, _) = issued(
        at,
        "17",
        &["--sign", key("p256.p12").to_str().expect("UTF-8")],
    );
    let dcc = ["--format", "dcc", "--particulars", "job.toml", "--sign"];
    let sealed = key("p256.p12");
    let dcc = calib(
        at,
        "test",
        &[
            &["certificate", "record.bin"],
            &dcc[..],
            &[sealed.to_str().expect("UTF-8")],
        ]
        .concat(),
    );
    assert!(dcc.status.success(), "{}", text(&dcc.stderr));
    std::fs::copy(key("p256.pem"), at.join("laboratory.pem")).expect("copied");
    let mut altered = std::fs::read(pdf).expect("PDF");
    let middle = altered.len() / 2;
    altered[middle] ^= 1;
    std::fs::write(at.join("altered.pdf"), altered).expect("written");
    let dcc = std::fs::read_to_string(at.join("certificate-17.dcc.xml")).expect("DCC");
    let result = dcc
        .find("<si:value")
        .and_then(|at| Some(at + dcc[at..].find(|c: char| c.is_ascii_digit())?));
    let mut altered = dcc.into_bytes();
    // One digit of a number.
    altered[result.expect("a result")] ^= 1;
    std::fs::write(at.join("altered.dcc.xml"), altered).expect("written");
    let shown = shown();
    assert_eq!(shown.len(), 4, "two verifiers, of two files each");
    for (command, lines) in shown {
        let Some(program) = verifier(&command[0]) else {
            return;
        };
        let output = Command::new(program)
            .args(&command[1..])
            .current_dir(at)
            .output();
        let output = output.expect("it starts");
        let is_sound = !command.iter().any(|word| word.starts_with("altered"));
        assert_eq!(output.status.success(), is_sound, "{command:?}");
        let printed = text(&output.stdout) + &text(&output.stderr);
        let mut rest = printed.lines();
        for line in lines.iter().filter(|line| *line != "...") {
            assert!(
                rest.any(|found| found.trim_end() == line),
                "{command:?}: {line}\n{printed}"
            );
        }
    }
}

/// A certificate made twice is the same files, with a logbook and without, be they there or not; before, an elliptic
/// curve's and the time in a PDF made others, which were refused.
#[test]
fn the_same_certificate_signed_again_is_the_same_files() {
    for (name, kept) in [
        ("p256.p12", true),
        ("p256.p12", false),
        ("rsa.p12", true),
        ("rsa.p12", false),
    ] {
        let folder = folder();
        let at = folder.path();
        if kept {
            assert!(
                calib(at, "", &["logbook", "add", "record.bin"])
                    .status
                    .success()
            );
        }
        let files = certificates(at, name);
        let read = || {
            files
                .clone()
                .map(|path| std::fs::read(path).expect("there"))
        };
        let first = read();
        // A PDF states the second it was signed in.
        std::thread::sleep(std::time::Duration::from_millis(1100));
        certificates(at, name);
        assert!(read() == first, "{name}");
        let (lost, stays) = (&files[0], &files[1]);
        std::fs::remove_file(if kept { lost } else { stays }).expect("removed");
        certificates(at, name);
        assert!(read() == first, "{name}: made again");
        // Of another key it is another file, and is not overwritten.
        let key = key("issued.p12");
        let other = words("certificate record.bin --format pdf --particulars house.toml");
        let other = calib(
            at,
            "test",
            &[&other[..], &["--sign", key.to_str().expect("UTF-8")]].concat(),
        );
        assert_eq!(other.status.code(), Some(6), "{}", text(&other.stderr));
        assert!(read() == first, "{name}: stays");
    }
}

/// The password comes from a file too; without one and without a terminal nobody is asked.
#[test]
fn a_password_is_never_an_argument() {
    let folder = folder();
    let at = folder.path();
    std::fs::write(at.join("password"), "test\n").expect("written");
    let key = key("rsa.p12");
    let usual = ["certificate", "record.bin", "--format", "pdf"];
    let sign = ["--sign", key.to_str().expect("UTF-8")];
    let nobody = typed(tool(at).args(usual).args(sign), "");
    assert_eq!(nobody.status.code(), Some(2));
    assert!(
        text(&nobody.stderr).contains("--password-file"),
        "{nobody:?}"
    );
    let file = ["--password-file", "password"];
    let signed = calib(at, "wrong", &[&usual[..], &sign, &file].concat());
    assert!(signed.status.success(), "{}", text(&signed.stderr));
}

/// Finding of `verify` about a file, with the laboratory's certificate known: exit code, and the one line.
fn verified(folder: &Path, file: &Path) -> (Option<i32>, serde_json::Value) {
    let (file, known) = (file.to_str().expect("UTF-8"), key("p256.pem"));
    let known = known.to_str().expect("UTF-8");
    let output = calib(
        folder,
        "",
        &["verify", file, "--json", "--certificate", known],
    );
    let said: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    (output.status.code(), said[0].clone())
}

/// Remarks of the check of the logbook, with the laboratory's certificate known.
fn checked(folder: &Path) -> String {
    let known = key("p256.pem");
    let known = known.to_str().expect("UTF-8");
    let output = calib(folder, "", &["logbook", "check", "--certificate", known]);
    let said = text(&output.stderr);
    assert!(output.status.success(), "{said}{}", text(&output.stdout));
    said
}

/// A certificate of this number, as PDF alone, by what else is said.
fn issued(folder: &Path, number: &str, more: &[&str]) -> (PathBuf, String) {
    let house = format!("[laboratory]\ncountry = 'DE'\n[calibration]\nnumber = '{number}'\n");
    std::fs::write(folder.join("job.toml"), house).expect("written");
    let usual = words("certificate record.bin --format pdf --particulars job.toml");
    let output = calib(folder, "test", &[&usual[..], more].concat());
    let said = text(&output.stderr);
    assert!(output.status.success(), "{said}");
    (folder.join(format!("certificate-{number}.pdf")), said)
}

/// A signed file is entered with its signer and found again, and the journal is signed with it; without a key it
/// is told how much waits; what is signed afterwards is entered too. Before, `verify` said nothing of a logbook and
/// each certificate left an entry that nobody had signed.
#[test]
fn what_is_signed_is_entered_with_its_signer_and_the_journal_is_signed_too() {
    let folder = folder();
    let at = folder.path();
    assert!(
        calib(at, "", &["logbook", "add", "record.bin"])
            .status
            .success()
    );
    let [pdf, dcc] = certificates(at, "p256.p12");
    for (file, format) in [(&pdf, "pdf"), (&dcc, "dcc")] {
        let (code, said) = verified(at, file);
        assert_eq!(
            (code, &said["proof"]),
            (Some(0), &"proven".into()),
            "{said}"
        );
        assert_eq!(said["issued"]["format"], format);
        let of = &said["issued"]["signed"][0];
        assert_eq!(
            of["signer_certificate_sha256"],
            said["signer_certificate_sha256"]
        );
        assert_eq!(of["signed_by"], said["signed_by"]);
    }
    assert!(checked(at).contains("; 0 entries since"), "{}", checked(at));

    // Without a key.
    let (unsigned, said) = issued(at, "C-2", &[]);
    assert!(
        said.contains("1 entry of the logbook is not signed"),
        "{said}"
    );
    let (code, said) = verified(at, &unsigned);
    assert_eq!((code, &said["proof"]), (Some(7), &"not_signed".into()));
    assert_eq!(said["issued"]["certificate"], "C-2");
    assert_eq!(said["issued"]["signed"], serde_json::json!([]));
    // Signed afterwards: the same certificate, and nothing waits any more.
    let key = key("p256.p12");
    let key = key.to_str().expect("UTF-8");
    let sign = ["sign", unsigned.to_str().expect("UTF-8"), "--key", key];
    assert!(calib(at, "test", &sign).status.success());
    let (code, said) = verified(at, &at.join("certificate-C-2.signed.pdf"));
    assert_eq!(
        (code, &said["issued"]["certificate"]),
        (Some(0), &"C-2".into()),
        "{said}"
    );
    assert!(checked(at).contains("; 0 entries since"), "{}", checked(at));

    // What nobody issued is told, though it is signed by the laboratory.
    let elsewhere = ["--logbook", "another.sqlite"];
    let (stranger, _) = issued(at, "C-3", &[&elsewhere[..], &["--sign", key]].concat());
    let (code, said) = verified(at, &stranger);
    assert_eq!((code, &said["issued"]), (Some(0), &serde_json::Value::Null));
    assert!(
        said["words"]
            .as_str()
            .expect("words")
            .contains("no such file"),
        "{said}"
    );

    // Named once and for all.
    assert!(calib(at, "", &["config", "key", key]).status.success());
    let (signed, _) = issued(at, "C-4", &[]);
    assert_eq!(verified(at, &signed).1["issued"]["certificate"], "C-4");
    let sums = calib(at, "", &["logbook", "certificates", "--json"]);
    let sums: serde_json::Value = serde_json::from_slice(&sums.stdout).expect("JSON");
    let signatures = |row: &serde_json::Value| row["signed"].as_array().map(Vec::len);
    let counts: Vec<_> = sums
        .as_array()
        .expect("rows")
        .iter()
        .map(signatures)
        .collect();
    assert_eq!(counts, [Some(1); 4], "{sums}");
}
