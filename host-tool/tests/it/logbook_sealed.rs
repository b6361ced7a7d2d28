//! The journal signed by the laboratory, copied, and put together from two computers.

use crate::command_line::{calib, text};
use crate::logbook::{later, logbook};
use calib_logbook::{CheckStandard, Filter, Issue, Kept, Logbook, Sensor};
use calib_protocol::record::digest;
use calib_signing::{Certificate, LaboratoryKey};
use jiff::Timestamp;
use rusqlite::types::ValueRef;
use rusqlite::{Connection, params};
use sha2::{Digest, Sha256};
use std::path::{Path, PathBuf};

fn file(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("signing/test-keys")
        .join(name)
}

/// 23 November 2026.
pub(crate) fn now() -> Timestamp {
    Timestamp::from_second(1_795_392_000).expect("a time")
}

pub(crate) fn key(name: &str) -> LaboratoryKey {
    LaboratoryKey::open(&file(name), "test", now()).expect(name)
}

fn known(names: &[&str]) -> Vec<Certificate> {
    let read = |name: &&str| Certificate::read(&file(name)).expect(name);
    names.iter().flat_map(read).collect()
}

fn sensor(serial: &str, owner: &str) -> Sensor {
    Sensor {
        serial: serial.to_owned(),
        owner: Some(owner.to_owned()),
        sensitivity: Some(0.01),
        ..Sensor::default()
    }
}

fn issue(logbook: &mut Logbook, number: &str, content: &str, record: &[u8]) {
    let issue = Issue {
        certificate: number,
        format: "pdf",
        file: "certificate.pdf",
        content: content.as_bytes(),
        record: digest(record),
        signed: None,
        joined: &[],
        replaces: None,
    };
    logbook.issue(&[issue], 1_700_000_000).expect("issued");
}

/// A logbook with a sensor, a record and two certificates, signed once, closed.
fn signed(folder: &Path) -> PathBuf {
    let mut logbook = logbook(folder);
    logbook
        .add_sensor(&sensor("S-1", "Plant 3"))
        .expect("added");
    let record = later(1, "S-1", 0, 1.0);
    logbook.keep(&record).expect("kept");
    issue(&mut logbook, "C-1", "one", &record);
    issue(&mut logbook, "C-2", "two", &record);
    logbook.seal(&key("rsa.p12"), now(), "").expect("signed");
    logbook.path().to_owned()
}

/// Findings of the check with this key known, and with none.
fn said(path: &Path, names: &[&str]) -> Vec<String> {
    let logbook = Logbook::open(path).expect("opens");
    let mut wrong = logbook.inspect().expect("read");
    wrong.extend(logbook.inspect_seals(&known(names)).expect("read"));
    wrong
}

/// A forger who has read the program: writes sums and chain of the journal anew, after what the tables say now.
fn rewrite_journal(file: &Connection) {
    file.execute_batch("DROP TRIGGER journal_stays")
        .expect("dropped");
    let mut statement = file
        .prepare("SELECT number, subject, name FROM journal ORDER BY number")
        .expect("prepared");
    let rows = statement.query_map([], |row| Ok((row.get(0)?, row.get(1)?, row.get(2)?)));
    let rows: Vec<(i64, String, String)> =
        rows.expect("rows").map(|row| row.expect("row")).collect();
    let mut before = Vec::new();
    for (number, subject, name) in rows {
        let table = match subject.as_str() {
            "sensor" => {
                "SELECT serial, manufacturer, model, sensitivity, range_ms2, iepe, mounting, owner, \
                 due_day, teds, tolerance, unit FROM sensors WHERE serial = ?1"
            }
            "record" => "SELECT sha256 FROM records WHERE id = CAST(?1 AS INTEGER)",
            _ => "SELECT * FROM certificates WHERE number = CAST(?1 AS INTEGER)",
        };
        let sum = file
            .query_row(table, [&name], |row| Ok(sum(&name, row)))
            .expect("there");
        let mut chain = Sha256::new();
        for part in [&before[..], subject.as_bytes(), name.as_bytes(), &sum] {
            chain.update((part.len() as u64).to_le_bytes());
            chain.update(part);
        }
        before = chain.finalize().to_vec();
        file.execute(
            "UPDATE journal SET sum = ?1, chain = ?2 WHERE number = ?3",
            params![sum, before, number],
        )
        .expect("updated");
    }
    let again = "CREATE TRIGGER journal_stays BEFORE UPDATE ON journal\n\
                 BEGIN SELECT RAISE(ABORT, 'an entry of the journal is not changed'); END";
    file.execute_batch(again).expect("made");
}

/// Sum of a row, its name before it.
fn sum(name: &str, row: &rusqlite::Row<'_>) -> Vec<u8> {
    let mut sum = Sha256::new();
    let mut part = |kind: u8, value: &[u8]| {
        sum.update([kind]);
        sum.update((value.len() as u64).to_le_bytes());
        sum.update(value);
    };
    part(b't', name.as_bytes());
    for column in 0..row.as_ref().column_count() {
        match row.get_ref(column).expect("a value") {
            ValueRef::Null => part(b'n', &[]),
            ValueRef::Integer(value) => part(b'i', &value.to_le_bytes()),
            ValueRef::Real(value) => part(b'r', &value.to_bits().to_le_bytes()),
            ValueRef::Text(value) => part(b't', value),
            ValueRef::Blob(value) => part(b'b', value),
        }
    }
    sum.finalize().to_vec()
}

fn attack(path: &Path, whole: &[u8], change: &str, rewrites: bool) {
    std::fs::write(path, whole).expect("written");
    let file = Connection::open(path).expect("a database");
    file.execute_batch(change).expect(change);
    if rewrites {
        rewrite_journal(&file);
    }
}

const REPLACED: &str = "DROP TRIGGER certificates_stay;
    UPDATE certificates SET sha256 = x'00' WHERE number = 1;
    CREATE TRIGGER certificates_stay BEFORE UPDATE ON certificates
BEGIN SELECT RAISE(ABORT, 'an issued certificate is not changed'); END";
const CUT: &str = "DROP TRIGGER certificates_are_kept; DROP TRIGGER journal_is_kept;
    DELETE FROM certificates WHERE number = 2; UPDATE sqlite_sequence SET seq = 1;
    DELETE FROM journal WHERE number = 4;
    CREATE TRIGGER certificates_are_kept BEFORE DELETE ON certificates
BEGIN SELECT RAISE(ABORT, 'an issued certificate is not removed'); END;
    CREATE TRIGGER journal_is_kept BEFORE DELETE ON journal
BEGIN SELECT RAISE(ABORT, 'an entry of the journal is not removed'); END";
const UNSIGNED: &str = "DROP TRIGGER seals_are_kept; DELETE FROM seals;
    CREATE TRIGGER seals_are_kept BEFORE DELETE ON seals
BEGIN SELECT RAISE(ABORT, 'a signature of the journal is not removed'); END";

/// A forger who knows the form of the journal passed every check of before; a signature he cannot write.
#[test]
fn a_journal_written_by_somebody_else_is_told_by_its_signature() {
    let folder = tempfile::tempdir().expect("folder");
    let path = signed(folder.path());
    let whole = std::fs::read(&path).expect("file");
    assert_eq!(said(&path, &["rsa.pem"]), [""; 0]);
    let owner = "UPDATE sensors SET owner = 'Somebody', tolerance = '50:nominal'";
    for (change, rewrites, words) in [
        (owner, true, "bytes were altered"),
        (REPLACED, true, "bytes were altered"),
        (CUT, false, "the journal ends before its entry 4"),
        (UNSIGNED, false, "nothing in it is signed"),
    ] {
        attack(&path, &whole, change, rewrites);
        let without = Logbook::open(&path)
            .expect("opens")
            .inspect()
            .expect("read");
        assert_eq!(without, [""; 0], "the forger knows the form: {change}");
        let found = said(&path, &["rsa.pem"]);
        assert!(
            found.iter().any(|line| line.contains(words)),
            "{change}: {found:?}"
        );
    }
}

/// Open, and stated in docs/safety.md: who has an older copy of the file, or removes all that was
/// entered since the last signature, shows nothing but its number and day.
#[test]
fn what_was_entered_since_the_last_signature_is_counted() {
    let folder = tempfile::tempdir().expect("folder");
    let path = signed(folder.path());
    let logbook = Logbook::open(&path).expect("opens");
    assert_eq!(logbook.signed_entries().expect("read"), (4, 4));
    logbook
        .add_sensor(&sensor("S-2", "Plant 4"))
        .expect("added");
    assert_eq!(logbook.signed_entries().expect("read"), (5, 4));
    drop(logbook);
    let whole = std::fs::read(&path).expect("file");
    attack(
        &path,
        &whole,
        "UPDATE sensors SET owner = 'X' WHERE serial = 'S-2'",
        true,
    );
    assert_eq!(said(&path, &["rsa.pem"]), [""; 0]);
}

#[test]
fn a_new_key_says_why_and_the_signatures_of_the_old_one_stay() {
    let folder = tempfile::tempdir().expect("folder");
    let path = signed(folder.path());
    let logbook = Logbook::open(&path).expect("opens");
    let (lost, new) = (key("rsa.p12"), key("p256.p12"));
    let refused = logbook
        .seal(&new, now(), " ")
        .expect_err("no reason")
        .to_string();
    assert!(refused.contains("Test seal RSA"), "{refused}");
    let seal = logbook.seal(&new, now(), "laptop stolen").expect("signed");
    assert_eq!((seal.seal, seal.statement.as_str()), (2, "laptop stolen"));
    logbook.seal(&new, now(), "").expect("signed");
    assert_eq!(said(&path, &["rsa.pem", "p256.pem"]), [""; 0]);
    assert_eq!(said(&path, &[]), [""; 0]);
    let found = said(&path, &["p256.pem"]);
    assert!(
        found.len() == 1 && found[0].contains("signature 1"),
        "{found:?}"
    );
    // A thief signs on without a word, or takes the statement away.
    let whole = std::fs::read(&path).expect("file");
    let silent = "DROP TRIGGER seals_stay; UPDATE seals SET statement = '' WHERE number = 2";
    attack(&path, &whole, silent, false);
    assert!(!said(&path, &["rsa.pem", "p256.pem"]).is_empty());
    drop((logbook, lost));
    // A signature out of the middle.
    attack(
        &path,
        &whole,
        "DROP TRIGGER seals_are_kept; DELETE FROM seals WHERE number = 2",
        false,
    );
    let found = said(&path, &["rsa.pem", "p256.pem"]);
    assert!(
        found.iter().any(|line| line.contains("is gone")),
        "{found:?}"
    );
}

/// A damaged logbook is not signed.
#[test]
fn a_damaged_logbook_is_not_signed() {
    let folder = tempfile::tempdir().expect("folder");
    let path = signed(folder.path());
    let whole = std::fs::read(&path).expect("file");
    attack(&path, &whole, "UPDATE sensors SET owner = 'X'", false);
    let logbook = Logbook::open(&path).expect("opens");
    let refused = logbook
        .seal(&key("rsa.p12"), now(), "")
        .expect_err("damaged");
    assert!(refused.to_string().contains("sensor S-1"), "{refused}");
}

#[test]
fn a_backup_is_the_logbook_and_never_in_the_place_of_another_file() {
    let folder = tempfile::tempdir().expect("folder");
    let path = signed(folder.path());
    let copy = folder.path().join("copy.sqlite");
    let logbook = Logbook::open(&path).expect("opens");
    assert_eq!(logbook.backup(&copy).expect("copied"), [""; 0]);
    assert_eq!(said(&copy, &["rsa.pem"]), [""; 0]);
    let backup = Logbook::open(&copy).expect("opens");
    assert_eq!(
        backup.certificates().expect("read"),
        logbook.certificates().expect("read")
    );
    assert_eq!(backup.signed_entries().expect("read"), (4, 4));
    let again = logbook.backup(&copy).expect_err("there").to_string();
    assert!(again.contains("is there already"), "{again}");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        let mode = std::fs::metadata(&copy)
            .expect("there")
            .permissions()
            .mode();
        assert_eq!(mode & 0o777, 0o600, "{mode:o}");
    }
}

/// Two computers of one laboratory: what one has is taken over once; what both have otherwise is named, and
/// both keep theirs.
#[test]
fn two_logbooks_become_one_and_nothing_is_lost() {
    let folders = [(); 2].map(|()| tempfile::tempdir().expect("folder"));
    let [mut ours, mut theirs] = [0, 1].map(|at: usize| logbook(folders[at].path()));
    let record = |id| later(id, "S-1", u64::from(id), 1.0);
    ours.add_sensor(&sensor("S-1", "Plant 3")).expect("added");
    theirs.add_sensor(&sensor("S-1", "Plant 9")).expect("added");
    theirs.add_sensor(&sensor("S-2", "Plant 3")).expect("added");
    let standard = CheckStandard {
        serial: "S-2".to_owned(),
        frequency_hz: 160.0,
        every_days: 30,
        certified: None,
    };
    theirs.put_check_standard(&standard).expect("put");
    for id in [1, 2] {
        ours.keep(&record(id)).expect("kept");
    }
    for id in [2, 3] {
        theirs.keep(&record(id)).expect("kept");
    }
    // Number 1 of one instrument, measured otherwise.
    theirs.keep(&later(1, "S-1", 1, 1.05)).expect("kept");
    issue(&mut ours, "C-1", "one", &record(1));
    issue(&mut theirs, "C-1", "other", &record(1));
    issue(&mut theirs, "C-2", "two", &record(2));
    let before = std::fs::read(theirs.path()).expect("file");
    let merged = ours.merge(&theirs).expect("merged");
    assert_eq!(
        (merged.records, merged.sensors, merged.certificates),
        (1, 2, 1)
    );
    assert_eq!(merged.known, 1, "record 2");
    let named = ["record 1 of MEM-1", "sensor S-1", "certificate C-1 as pdf"];
    assert_eq!(
        merged.conflicts.len(),
        named.len(),
        "{:?}",
        merged.conflicts
    );
    for (found, name) in merged.conflicts.iter().zip(named) {
        assert!(found.contains(name), "{found}");
    }
    assert!(
        std::fs::read(theirs.path()).expect("file") == before,
        "stays as it is"
    );
    let owner = ours
        .sensor("S-1")
        .expect("read")
        .and_then(|sensor| sensor.owner);
    assert_eq!(owner.as_deref(), Some("Plant 3"), "ours stays");
    assert_eq!(ours.records(&Filter::default()).expect("listed").len(), 3);
    let again = ours.keep(&record(3)).expect("known");
    assert!(matches!(again, Kept::Known(_)));
    assert_eq!(ours.inspect().expect("read"), [""; 0]);
    let again = ours.merge(&theirs).expect("merged");
    assert_eq!(
        (again.records, again.sensors, again.certificates),
        (0, 0, 0)
    );
    assert_eq!((again.known, &again.conflicts), (5, &merged.conflicts));
    let itself = Logbook::open(ours.path()).expect("opens");
    assert!(ours.merge(&itself).is_err());
}

/// The verbs, with their exit codes.
#[test]
fn the_verbs_sign_check_copy_and_merge() {
    let folder = tempfile::tempdir().expect("folder");
    let path = signed(folder.path());
    let (rsa, p256) = (file("rsa.p12"), file("p256.p12"));
    let pems = ["rsa.pem", "p256.pem"].map(file);
    let name = |path: &PathBuf| path.to_str().expect("UTF-8").to_owned();
    std::fs::write(folder.path().join("password"), "test").expect("written");
    for (arguments, code, said) in [
        (
            format!("sign --key {} --password-file password", name(&rsa)),
            0,
            "signature 2",
        ),
        (
            format!("sign --key {} --password-file password", name(&p256)),
            6,
            "--new-key",
        ),
        (
            format!(
                "sign --key {} --password-file password --new-key lost",
                name(&p256)
            ),
            0,
            "another key: lost",
        ),
        ("check".to_owned(), 0, "0 entries since"),
        (
            format!("check --certificate {}", name(&pems[0])),
            7,
            "signature 3: is by",
        ),
        (
            format!(
                "check --certificate {} --certificate {}",
                name(&pems[0]),
                name(&pems[1])
            ),
            0,
            "as it was entered",
        ),
        ("backup copy.sqlite".to_owned(), 0, "copy.sqlite"),
        ("backup copy.sqlite".to_owned(), 6, "is there already"),
        ("merge copy.sqlite".to_owned(), 0, "0 records, 0 sensors"),
        ("merge none.sqlite".to_owned(), 6, "there is no logbook"),
    ] {
        let words: Vec<&str> = arguments.split(' ').collect();
        let logbook = ["--logbook", path.to_str().expect("UTF-8"), "logbook"];
        let output = calib(folder.path(), &[&logbook[..], &words].concat());
        let all = text(&output.stdout) + &text(&output.stderr);
        assert_eq!(output.status.code(), Some(code), "{arguments}: {all}");
        assert!(all.contains(said), "{arguments}: {all}");
    }
}
