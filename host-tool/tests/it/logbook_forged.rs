//! The logbook attacked: bits that flip in the file, and hands that change it with another program.

use crate::logbook::{later, logbook};
use calib_logbook::{Issue, Logbook, Sensor};
use calib_protocol::record::digest;
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
        };
        let both = [issue("pdf"), issue("csv")];
        logbook.issue(&both, 1_700_000_000).expect("issued");
    }
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
    Logbook::open(path)
        .and_then(|logbook| logbook.inspect())
        .map_or(true, |wrong| !wrong.is_empty())
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
    assert!(changed > 50, "{changed}");
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
