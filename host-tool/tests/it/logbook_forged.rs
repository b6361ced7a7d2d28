//! The logbook attacked: bits that flip in the file, and hands that change it with another program.

use crate::command_line::{calib, serve, text};
use crate::device::Device;
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
        sensitivity: Some(0.01),
        resonance_hz: Some(36_000.0),
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
        "UPDATE points SET state = 'refused: Noise' WHERE record = 1",
        "UPDATE points SET expanded_uncertainty_rel = 0.001",
        "DELETE FROM points WHERE record = 3",
        "UPDATE operators SET last_s = 1",
        "UPDATE instruments SET reference_certificate = 'X'",
        "UPDATE sensors SET sensitivity = 0.011",
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

/// Serial number of the instrument of these records.
fn serial() -> String {
    let record = decode(&later(1, "S-1", 0, 1.0)).expect("a record");
    record.head.instrument_serial.as_str().to_owned()
}

/// The key of this seed, and the first record it signed.
fn key_since(seed: &[u8; 32], since: u32) -> DeviceKey {
    let public = device_key(seed).public;
    DeviceKey { public, since }
}

/// The memory of an instrument is erased: it makes another key and counts its records anew. A person says so; what it
/// has measured before stays, and who is not it gets in no more than before.
#[test]
fn a_key_in_place_of_another_is_taken_from_a_person_alone_and_keeps_what_was() {
    let folder = tempfile::tempdir().expect("folder");
    let (mut logbook, serial) = (logbook(folder.path()), serial());
    let [own, forger] = &SEEDS;
    let (new, third) = ([7; 32], [8; 32]);
    logbook
        .enter_key(&serial, &device_key(own))
        .expect("entered");
    let old = [
        later(1, "S-1", 0, 1.0),
        signed_record(2, 1.0, own),
        signed_record(3, 1.0, own),
    ];
    logbook
        .keep_all(old.iter().map(Vec::as_slice))
        .expect("kept");
    // Nobody has said anything: neither the erased instrument nor a forger.
    let renewed = key_since(&new, 1);
    for key in [&renewed, &key_since(forger, 1)] {
        let said = logbook
            .enter_key(&serial, key)
            .expect_err("another")
            .hint()
            .map(str::to_owned);
        assert!(said.expect("a way out").contains("--replaced"));
    }
    let again = [signed_record(1, 1.01, &new), signed_record(2, 1.02, &new)];
    assert!(logbook.keep(&again[0]).is_err());
    let waits = waiting::put(logbook.path(), &again[0]).expect("put");
    assert!(Logbook::enter_waiting(logbook.path(), &[(serial.clone(), renewed)]).is_err());
    assert!(waits.exists(), "it waits for the statement");
    // That of another instrument does not.
    let mut other = decode(&later(1, "S-1", 0, 1.0)).expect("a record");
    other.head.instrument_serial = sample::text("CAL-0043");
    let other = waiting::put(logbook.path(), &sample::bytes(&other)).expect("put");
    assert!(Logbook::enter_waiting(logbook.path(), &[(serial.clone(), renewed)]).is_err());
    assert!(waits.exists() && !other.exists());

    for (reason, why) in [("", "nothing says"), ("one\ntwo", "one line")] {
        let said = logbook
            .replace_key(&serial, &renewed, reason, 1)
            .expect_err(why);
        assert!(said.to_string().contains(why), "{said}");
    }
    assert_eq!(
        logbook
            .replace_key(&serial, &renewed, "memory erased", 1)
            .expect("said"),
        1
    );
    for key in [&renewed, &device_key(own)] {
        assert!(
            logbook.replace_key(&serial, key, "once more", 2).is_err(),
            "it had this one"
        );
    }
    assert!(
        logbook.enter_key(&serial, &device_key(own)).is_err(),
        "two instruments of one number"
    );
    let entered =
        Logbook::enter_waiting(logbook.path(), &[(serial.clone(), renewed)]).expect("entered");
    assert_eq!(entered.numbers.len(), 1);
    logbook.keep(&again[1]).expect("its next");
    // What was measured before is taken as before, be it found late.
    logbook
        .keep(&signed_record(4, 1.0, own))
        .expect("of before");
    for (forged, words) in [
        (signed_record(3, 1.05, &new), ""),
        (signed_record(3, 1.05, forger), "is not the instrument's"),
        (signed_record(9, 1.05, &third), "is not the instrument's"),
        (later(3, "S-1", 0, 1.05), "is not signed"),
        (later(1, "S-1", 0, 1.05), "is there already"),
        (signed_record(2, 1.05, &new), "is there already"),
        (signed_record(2, 1.05, own), "is there already"),
    ] {
        match logbook.keep(&forged) {
            // The one that is none: its number is free in the new series.
            Ok(_) => assert!(words.is_empty()),
            Err(error) => assert!(
                !words.is_empty() && error.to_string().contains(words),
                "{error}"
            ),
        }
    }
    assert_eq!(logbook.inspect().expect("read"), [""; 0]);
    let number = |series, number| logbook.numbered(&serial, series, number).expect("read");
    assert_eq!(number(0, 2).as_deref(), Some(&old[1][..]));
    assert_eq!(number(1, 2).as_deref(), Some(&again[1][..]));
    // By its number it is one of two, each of which can be named.
    let of = |series| logbook.record_of(2, Some(&serial), series);
    let said = of(None).expect_err("two");
    assert!(said.to_string().contains("in its series 1"), "{said}");
    assert!(said.hint().expect("a way out").contains("--series"));
    assert_eq!(of(Some(0)).expect("of before"), old[1]);
    assert_eq!(of(Some(1)).expect("since"), again[1]);
    let path = logbook.path().to_owned();
    drop(logbook);
    its_series_names_a_record_of_the_command_line(&path, &serial);
    a_statement_is_none_by_another_program(&path, &serial);
}

/// No calibrator is there to be asked.
fn its_series_names_a_record_of_the_command_line(logbook: &Path, serial: &str) {
    let folder = logbook.parent().expect("a folder");
    let file = logbook.to_str().expect("text");
    let go = |line: &str, which: [&str; 2]| {
        let words: Vec<&str> = line.split(' ').chain(which).collect();
        calib(folder, &[&words[..], &["--logbook", file]].concat())
    };
    let said = |line: &str, which: [&str; 2]| text(&go(line, which).stderr);
    let certificate = "certificate 2 --format csv --out c";
    let several = said(certificate, ["--instrument", &serial[1..]]);
    let named = several.contains("there are 2") && several.contains("--series");
    assert!(named, "{several}");
    let none = said(certificate, ["--instrument", "no-such"]);
    assert!(none.contains("is not there"), "{none}");
    let made = go(certificate, ["--series", "1"]);
    assert_eq!(made.status.code(), Some(0), "{}", text(&made.stderr));
    let shown = ["0", "1"].map(|series| text(&go("show 2 --json", ["--series", series]).stdout));
    assert!(!shown[0].is_empty(), "the one of before");
    assert_ne!(shown[0], shown[1], "each is its own");
}

/// A statement that another program writes, or changes, is noticed.
fn a_statement_is_none_by_another_program(path: &Path, serial: &str) {
    let whole = std::fs::read(path).expect("file");
    for change in [
        format!("INSERT INTO later_keys VALUES ('{serial}', 2, zeroblob(32), 1, 'x', 1)"),
        "DROP TRIGGER later_keys_stay; UPDATE later_keys SET reason = 'sold'".to_owned(),
        "DROP TRIGGER later_keys_are_kept; DELETE FROM later_keys".to_owned(),
        "UPDATE records SET series = 1 WHERE series = 0 AND number = 3".to_owned(),
        "UPDATE records SET series = 0".to_owned(),
    ] {
        std::fs::write(path, &whole).expect("written");
        let file = Connection::open(path).expect("a database");
        file.execute_batch(&change).expect(&change);
        drop(file);
        assert!(is_noticed(path), "{change}");
    }
}

/// Another logbook that says so is a file: whoever wrote it, a person says it here too.
#[test]
fn a_statement_in_another_logbook_lets_nobody_in() {
    let (here, there) = (
        tempfile::tempdir().expect("folder"),
        tempfile::tempdir().expect("folder"),
    );
    let (mut ours, mut theirs, serial) = (logbook(here.path()), logbook(there.path()), serial());
    let [own, forger] = &SEEDS;
    for logbook in [&ours, &theirs] {
        logbook
            .enter_key(&serial, &device_key(own))
            .expect("entered");
    }
    let forged = signed_record(1, 1.05, forger);
    let said = theirs.replace_key(&serial, &key_since(forger, 1), "board changed", 1);
    assert_eq!(said.expect("in his own"), 1);
    theirs.keep(&forged).expect("in his own");
    theirs.keep(&signed_record(4, 1.0, own)).expect("kept");
    let merged = ours.merge(&theirs).expect("merged");
    assert_eq!(
        (merged.records, merged.conflicts.len()),
        (1, 2),
        "{merged:?}"
    );
    assert!(merged.conflicts[0].contains("board changed"), "{merged:?}");
    assert!(ours.keep(&forged).is_err());
    // It was true, and is said here too.
    ours.replace_key(&serial, &key_since(forger, 1), "board changed", 2)
        .expect("said");
    let merged = ours.merge(&theirs).expect("merged");
    assert_eq!(
        (merged.records, merged.conflicts.len()),
        (1, 0),
        "{merged:?}"
    );
    assert_eq!(ours.inspect().expect("read"), [""; 0]);
}

/// Records of an instrument without a key stay valid when it is erased and makes one; before, the check of the
/// logbook named every one of them for ever.
#[test]
fn a_first_key_that_contradicts_what_is_there_wants_a_statement_too() {
    let folder = tempfile::tempdir().expect("folder");
    let (mut logbook, serial) = (logbook(folder.path()), serial());
    let (first, seed) = (key_since(&SEEDS[0], 1), &SEEDS[0]);
    let of_nothing = logbook
        .replace_key(&serial, &first, "erased", 1)
        .expect_err("no key yet");
    assert!(
        of_nothing.to_string().contains("no other key"),
        "{of_nothing}"
    );
    logbook.keep(&later(1, "S-1", 0, 1.0)).expect("not signed");
    let said = logbook
        .enter_key(&serial, &first)
        .expect_err("did not sign it")
        .to_string();
    assert!(said.contains("record 1 that it did not sign"), "{said}");
    // Kept before anybody knew the key: of its series since it is said.
    logbook
        .keep(&signed_record(2, 1.0, seed))
        .expect("nothing speaks against it");
    logbook
        .replace_key(&serial, &first, "erased", 1)
        .expect("said");
    logbook
        .keep(&signed_record(1, 1.0, seed))
        .expect("the first of the new series");
    assert!(logbook.numbered(&serial, 1, 2).expect("read").is_some());
    assert_eq!(logbook.inspect().expect("read"), [""; 0]);
}

/// Forged records, and a key, by the commands a person uses.
#[test]
fn the_commands_take_another_key_with_a_reason_alone() {
    let folder = tempfile::tempdir().expect("folder");
    let at = folder.path();
    let (mut logbook, serial) = (logbook(at), serial());
    logbook
        .enter_key(&serial, &device_key(&SEEDS[0]))
        .expect("entered");
    logbook
        .keep(&signed_record(2, 1.0, &SEEDS[0]))
        .expect("kept");
    drop(logbook);
    let new = signed_record(2, 1.02, &[7; 32]);
    std::fs::write(at.join("old"), signed_record(2, 1.0, &SEEDS[0])).expect("written");
    let mut device = Device::new();
    device.key = Some(key_since(&[7; 32], 1));
    device.records.insert(2, new.clone());
    let (_device, address) = serve(device);
    let calib = |arguments: &[&str]| {
        let logbook = ["--logbook", "logbook.sqlite", "--device", &address];
        calib(at, &[&logbook[..], arguments].concat())
    };
    let refused = calib(&["key"]);
    assert_eq!(refused.status.code(), Some(6));
    assert!(
        text(&refused.stderr).contains("--replaced"),
        "{}",
        text(&refused.stderr)
    );
    let waits = calib(&["sync"]);
    assert!(
        text(&waits.stderr).contains("waits"),
        "{}",
        text(&waits.stderr)
    );
    let said = calib(&["key", "--json", "--replaced", "memory erased, order 4711"]);
    assert!(said.status.success(), "{}", text(&said.stderr));
    let view: serde_json::Value = serde_json::from_slice(&said.stdout).expect("JSON");
    assert_eq!(view["replaced_because"], "memory erased, order 4711");
    assert!(calib(&["sync"]).status.success());
    let opened = Logbook::open(&at.join("logbook.sqlite")).expect("opens");
    assert!(opened.has(&digest(&new)).expect("read"));
    assert_eq!(opened.inspect().expect("read"), [""; 0]);
    // The one of before is proven by the key of before, and that it has another since is said.
    let proven = calib(&["verify", "old"]);
    let words = text(&proven.stdout);
    assert_eq!(proven.status.code(), Some(0), "{words}");
    assert!(
        words.contains("another key since: memory erased, order 4711"),
        "{words}"
    );
}

/// Signs that end a line or turn one round are no word of a sensor, and none of a statement.
#[test]
fn words_that_are_kept_forge_no_line() {
    let folder = tempfile::tempdir().expect("folder");
    let logbook = logbook(folder.path());
    logbook
        .enter_key(&serial(), &device_key(&SEEDS[0]))
        .expect("entered");
    for bad in ["S\n1", "S\u{2028}1", "S\u{202e}1", "S\u{1b}[2J"] {
        let by_serial = Sensor {
            serial: bad.to_owned(),
            ..Sensor::default()
        };
        let by_owner = Sensor {
            serial: "S".to_owned(),
            owner: Some(bad.to_owned()),
            ..Sensor::default()
        };
        for sensor in [by_serial, by_owner] {
            assert!(logbook.add_sensor(&sensor).is_err(), "{bad:?}");
        }
        let key = key_since(&[7; 32], 1);
        assert!(
            logbook.replace_key(&serial(), &key, bad, 1).is_err(),
            "{bad:?}"
        );
    }
}

/// No logbook and no instrument: exit code and words follow from file and key.
#[test]
fn a_record_is_verified_by_its_file_and_the_key_alone() {
    let folder = tempfile::tempdir().expect("folder");
    let digits = hex::encode(device_key(&SEEDS[0]).public);
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
