//! The logbook attacked: bits that flip in the file, and hands that change it with another program.

use crate::command_line::{calib, text};
use crate::logbook::{later, logbook};
use crate::logbook_sealed::{key, now};
use calib_logbook::{Filter, Issue, Logbook, Sensor, waiting};
use calib_protocol::record::{decode, digest};
use calib_protocol::signature::DeviceKey;
use calib_record::sample;
use calib_record::signature::{Signed, signed};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use rusqlite::Connection;
use rusqlite::types::Value;
use std::path::{Path, PathBuf};

/// A logbook with all there is, closed.
fn kept(folder: &Path) -> PathBuf {
    let mut logbook = logbook(folder);
    let sensor = Sensor {
        serial: "S-1".to_owned(),
        model: "352C33".to_owned(),
        owner: Some("Plant 3".to_owned()),
        sensitivity_v_per_ms2: Some(0.01),
        tolerance: Some("5:nominal".to_owned()),
        ..Sensor::default()
    };
    logbook.add_sensor(&sensor).expect("added");
    for (id, year) in [(1, 0), (2, 1), (3, 2)] {
        let record = later(id, "S-1", year, 1.0 + 0.001 * id as f32);
        logbook.keep(&record).expect("kept");
        let number = format!("C-{id}");
        let issue = |format| Issue {
            certificate: &number,
            format,
            file: "certificate",
            content: number.as_bytes(),
            record: digest(&record),
            signed: None,
            joined: &[],
            replaces: None,
        };
        let both = [issue("pdf"), issue("csv")];
        logbook.issue(&both, 1_700_000_000).expect("issued");
    }
    // RSA: the same signature in every run.
    logbook.seal(&key("rsa.p12"), now(), "").expect("signed");
    logbook.path().to_owned()
}

/// Everything the file says, or nothing when it cannot be read.
fn content(path: &Path) -> Option<Vec<Vec<Value>>> {
    let file = Connection::open(path).ok()?;
    let names = "SELECT name FROM sqlite_schema WHERE type = 'table' ORDER BY name";
    let names: Vec<String> = file
        .prepare(names)
        .ok()?
        .query_map([], |row| row.get(0))
        .ok()?
        .collect::<Result<_, _>>()
        .ok()?;
    let mut all = Vec::new();
    for name in names.iter().map(String::as_str).chain(["sqlite_schema"]) {
        let mut rows = file.prepare(&format!("SELECT * FROM {name}")).ok()?;
        let columns = rows.column_count();
        let rows = rows.query_map([], |row| (0..columns).map(|at| row.get(at)).collect());
        let mut rows: Vec<Vec<Value>> = rows.ok()?.collect::<Result<_, _>>().ok()?;
        // Where a table begins in the file is no content.
        if name == "sqlite_schema" {
            rows.iter_mut().for_each(|row| drop(row.remove(3)));
        }
        all.push(vec![Value::Text(name.to_owned())]);
        all.extend(rows);
    }
    Some(all)
}

fn is_noticed(path: &Path) -> bool {
    let check = |logbook: Logbook| {
        let mut wrong = logbook.inspect()?;
        wrong.extend(logbook.inspect_seals(&[])?);
        Ok(wrong)
    };
    let wrong = Logbook::open(path).and_then(check);
    wrong.map_or(true, |wrong| !wrong.is_empty())
}

#[test]
fn a_bit_that_changes_what_the_logbook_says_is_noticed() {
    let folder = tempfile::tempdir().expect("folder");
    let path = kept(folder.path());
    assert!(!is_noticed(&path));
    let (whole, said) = (std::fs::read(&path).expect("file"), content(&path));
    let mut generator = ChaCha8Rng::seed_from_u64(18);
    let mut passed = Vec::new();
    let mut changed = 0;
    for _ in 0..500 {
        let bit = generator.next_u64() as usize % (8 * whole.len());
        let mut flipped = whole.clone();
        flipped[bit / 8] ^= 1 << (bit % 8);
        std::fs::write(&path, &flipped).expect("written");
        if content(&path) != said {
            changed += 1;
            if !is_noticed(&path) {
                passed.push(bit / 8);
            }
        }
    }
    assert!(changed > 30, "{changed}");
    assert!(
        passed.is_empty(),
        "{} of {changed} passed: {passed:?}",
        passed.len()
    );
}

#[test]
fn what_another_program_changes_is_noticed() {
    let folder = tempfile::tempdir().expect("folder");
    let path = kept(folder.path());
    let whole = std::fs::read(&path).expect("file");
    for change in [
        "UPDATE records SET sensitivity_v_per_ms2 = 0.02 WHERE id = 2",
        "UPDATE records SET expanded_uncertainty_rel = 0.001",
        "UPDATE sqlite_sequence SET seq = 9",
        "UPDATE records SET refused = 0, operator = 'Somebody' WHERE id = 1",
        "UPDATE points SET verdict = 'refused: Noise' WHERE record = 1",
        "UPDATE points SET expanded_uncertainty_rel = 0.001",
        "DELETE FROM points WHERE record = 3",
        "UPDATE operators SET last_s = 1",
        "UPDATE instruments SET reference_certificate = 'X'",
        "UPDATE sensors SET sensitivity_v_per_ms2 = 0.011",
        "UPDATE sensors SET owner = 'Somebody', tolerance = '50:nominal'",
        "DELETE FROM sensors",
        "INSERT INTO sensors (serial, manufacturer, model) VALUES ('S-2', '', '')",
        "INSERT INTO certificates (certificate, format, record_sha256, issued_s, file, sha256)
         SELECT 'C-9', format, record_sha256, issued_s, file, sha256 FROM certificates WHERE number = 1",
        "DROP TRIGGER certificates_stay; UPDATE certificates SET issued_s = 1",
        "DROP TRIGGER certificates_are_kept; DELETE FROM certificates WHERE number = 6;
         UPDATE sqlite_sequence SET seq = 5",
        "DELETE FROM points WHERE record = 3; DELETE FROM contents WHERE record = 3;
         DELETE FROM records WHERE id = 3",
    ] {
        std::fs::write(&path, &whole).expect("written");
        let file = Connection::open(&path).expect("a database");
        file.execute_batch(change).expect(change);
        drop(file);
        assert!(is_noticed(&path), "{change}");
    }
}

/// Seed of the instrument's key, and of a forger's.
const SEEDS: [[u8; 32]; 2] = [[5; 32], [6; 32]];

/// Record `id`, signed by the key of this seed.
fn signed_record(id: u32, factor: f32, seed: &[u8; 32]) -> Vec<u8> {
    let record = decode(&later(id, "S-1", 0, factor)).expect("a record");
    sample::signed(&record, seed)
}

fn device_key(seed: &[u8; 32]) -> DeviceKey {
    let bytes = signed_record(1, 1.0, seed);
    let Ok(Signed::By(public)) = signed(&bytes) else {
        panic!("it was signed");
    };
    DeviceKey { public, since: 2 }
}

/// Every way to hand in a record that the instrument never made, by what is said of it.
fn forgeries() -> [(Vec<u8>, &'static str); 4] {
    let [own, other] = &SEEDS;
    let mut altered = signed_record(4, 1.0, own);
    let at = altered.windows(3).position(|bytes| bytes == b"S-1");
    altered[at.expect("its sensor")] ^= 1;
    sample::mend(&mut altered);
    [
        (altered, "does not fit"),
        (later(4, "S-1", 0, 1.05), "is not signed"),
        (signed_record(4, 1.05, other), "is not the instrument's"),
        (later(1, "S-1", 0, 1.05), "is there already"),
    ]
}

#[test]
fn a_record_the_instrument_never_made_is_refused_and_put_aside() {
    let folder = tempfile::tempdir().expect("folder");
    let [own, other] = &SEEDS;
    let serial = decode(&later(1, "S-1", 0, 1.0)).expect("a record");
    let serial = serial.head.instrument_serial.as_str().to_owned();
    let mut logbook = logbook(folder.path());
    let path = logbook.path().to_owned();
    assert!(
        logbook
            .enter_key(&serial, &device_key(own))
            .expect("entered")
    );
    assert!(!logbook.enter_key(&serial, &device_key(own)).expect("known"));
    let another = logbook.enter_key(&serial, &device_key(other));
    let said = another.expect_err("it has one").to_string();
    assert!(said.contains("states the key"), "{said}");
    logbook
        .keep(&later(1, "S-1", 0, 1.0))
        .expect("from before the key");
    for (forged, words) in forgeries() {
        let said = logbook.keep(&forged).expect_err(words).to_string();
        assert!(said.contains(words), "{said}");
    }
    drop(logbook);
    // Among those that wait the true ones get in, and the others are no hindrance afterwards.
    let before = forgeries().map(|(forged, _)| waiting::put(&path, &forged).expect("put"));
    let true_one = waiting::put(&path, &signed_record(5, 1.0, own)).expect("put");
    // Ahead of them all, and no record.
    let garbage = waiting::folder(&path).join("aaa.calibrec");
    std::fs::write(&garbage, b"garbage").expect("written");
    let entered = Logbook::enter_waiting(&path, &[]).expect("entered");
    assert_eq!(entered.numbers.len(), 1);
    let said = entered.objection().expect("refused").to_string();
    assert!(!true_one.exists());
    for place in before.iter().chain([&garbage]) {
        let aside = place.with_extension("refused");
        assert!(!place.exists() && aside.exists());
        // Every one of them is named.
        assert!(said.contains(&aside.display().to_string()), "{said}");
    }
    let again = Logbook::enter_waiting(&path, &[]).expect("nothing waits");
    assert!(again.numbers.is_empty() && again.objection().is_none());
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        let folder = std::fs::metadata(waiting::folder(&path)).expect("a folder");
        assert_eq!(folder.permissions().mode() & 0o777, 0o700);
    }
    let logbook = Logbook::open(&path).expect("opens");
    let listed = logbook.records(&Filter::default()).expect("listed");
    let mut numbers: Vec<u32> = listed.iter().map(|line| line.number).collect();
    numbers.sort_unstable();
    assert_eq!(numbers, [1, 5]);
    assert_eq!(logbook.inspect().expect("read"), [""; 0]);
    // A key that somebody else enters with another program is noticed.
    drop(logbook);
    let file = Connection::open(&path).expect("a database");
    file.execute_batch("UPDATE keys SET since = 100")
        .expect("updated");
    drop(file);
    assert!(is_noticed(&path));
}

/// No logbook and no instrument: exit code and words follow from file and key.
#[test]
fn a_record_is_verified_by_its_file_and_the_key_alone() {
    let folder = tempfile::tempdir().expect("folder");
    let digits = calib_output::hex(&device_key(&SEEDS[0]).public);
    let whole = signed_record(4, 1.0, &SEEDS[0]);
    let [(altered, _), (unsigned, _), (of_other, _), _] = forgeries();
    let named = ["--key", digits.as_str()];
    let spaced = digits
        .as_bytes()
        .chunks(4)
        .map(|part| String::from_utf8_lossy(part));
    let spaced = spaced.collect::<Vec<_>>().join(" ");
    for (bytes, key, proof, code) in [
        (&whole, &named[..], "proven", 0),
        (&whole, &["--key", spaced.as_str()], "proven", 0),
        (&whole, &[], "key_not_known", 7),
        (&altered, &named, "altered", 7),
        (&unsigned, &named, "not_signed", 7),
        (&of_other, &named, "other_key", 7),
    ] {
        std::fs::write(folder.path().join("file"), bytes).expect("written");
        let arguments = [&["verify", "file", "--json"], key].concat();
        let output = calib(folder.path(), &arguments);
        let said = text(&output.stdout);
        assert_eq!(output.status.code(), Some(code), "{proof}: {said}");
        let document: serde_json::Value = serde_json::from_str(&said).expect("JSON");
        assert_eq!(document[0]["proof"], proof, "{said}");
    }
    let short_key = calib(folder.path(), &["verify", "file", "--key", "12ab"]);
    assert_eq!(short_key.status.code(), Some(2));
}
