//! The lake: added to once, whole or not at all, and read with what an older release wrote.

use crate::command_line::text;
use crate::device::record;
use crate::logbook::{later, logbook};
use crate::python;
use calib_logbook::{CheckStandard, Logbook, Sensor, add_to_lake};
use std::path::{Path, PathBuf};

/// Tables of a lake.
const TABLES: [&str; 5] = ["points", "settings", "budgets", "checks", "records"];

fn with_records(folder: &Path, ids: std::ops::Range<u32>) -> Logbook {
    let mut logbook = logbook(folder);
    for id in ids {
        let years = u64::from(id % 2);
        logbook.keep(&later(id, "D 1", years, 1.0)).expect("kept");
    }
    logbook
}

/// Files of a table, by their names.
fn files(lake: &Path, table: &str) -> Vec<PathBuf> {
    let mut folders = vec![lake.join(table)];
    let mut files = Vec::new();
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).expect("there").flatten() {
            match entry.path() {
                path if path.is_dir() => folders.push(path),
                path => files.push(path),
            }
        }
    }
    files.sort();
    files
}

#[test]
fn a_record_is_in_the_lake_once_whoever_adds_it() {
    let folder = tempfile::tempdir().expect("folder");
    let lake = folder.path().join("lake");
    let mut first = with_records(folder.path(), 1..4);
    let added = add_to_lake(&first, &lake, "Lab/1").expect("added");
    // Two years, five tables.
    assert_eq!((added.records, added.files.len()), (3, 10));
    assert!(added.files.iter().all(|file| file.is_file()));
    let again = add_to_lake(&first, &lake, "Lab/1").expect("nothing new");
    assert_eq!((again.records, again.files.len()), (0, 0));
    // Another copy of the logbook, in which the records have other numbers.
    let other = folder.path().join("other");
    std::fs::create_dir(&other).expect("folder");
    let mut copy = logbook(&other);
    for id in [3, 2, 1] {
        copy.keep(&later(id, "D 1", u64::from(id % 2), 1.0))
            .expect("kept");
    }
    let from_copy = add_to_lake(&copy, &lake, "Lab/1").expect("nothing new");
    assert_eq!(from_copy.records, 0);
    // A laboratory that goes by another name now.
    let renamed = add_to_lake(&copy, &lake, "Laboratory One").expect("nothing new");
    assert_eq!(renamed.records, 0);
    first.keep(&later(4, "D 1", 0, 1.0)).expect("kept");
    let more = add_to_lake(&first, &lake, "Lab/1").expect("one more");
    assert_eq!((more.records, more.files.len()), (1, 5));
    assert_eq!(
        add_to_lake(&first, &lake, " ")
            .expect_err("no name")
            .exit_code(),
        2
    );
}

#[test]
fn an_addition_that_was_cut_off_leaves_nothing_twice() {
    // Two instruments' years, five tables: ten files, after each of which the power may fail.
    for written in 0..=10 {
        let folder = tempfile::tempdir().expect("folder");
        let lake = folder.path().join("lake");
        let mut logbook = with_records(folder.path(), 1..3);
        let cut = add_to_lake(&logbook, &lake, "Lab").expect("added");
        for file in &cut.files[written..] {
            std::fs::remove_file(file).expect("removed");
        }
        let whole = written / 5;
        // The next call adds more records, so its files have other names.
        logbook.keep(&later(3, "D 1", 1, 1.0)).expect("kept");
        logbook.keep(&later(4, "D 1", 0, 1.0)).expect("kept");
        // It may also be the first by another name of the laboratory.
        let name = ["Lab", "Laboratory"][written % 2];
        let added = add_to_lake(&logbook, &lake, name).expect("added");
        assert_eq!(added.records, 4 - whole, "cut after {written}");
        let below = |table| -> Vec<PathBuf> {
            let found = files(&lake, table).into_iter();
            let inside = |file: PathBuf| file.strip_prefix(lake.join(table)).map(Path::to_owned);
            found.map(|file| inside(file).expect("below")).collect()
        };
        assert_eq!(below("records").len(), 2 + whole);
        for table in TABLES {
            assert_eq!(
                below(table),
                below("records"),
                "{table}, cut after {written}"
            );
        }
    }
}

#[test]
fn engines_read_the_lake_and_an_older_one_beside_it() {
    let folder = tempfile::tempdir().expect("folder");
    let lake = folder.path().join("lake");
    let logbook = with_records(folder.path(), 1..3);
    let sensor = Sensor {
        serial: "D 1".to_owned(),
        ..Sensor::default()
    };
    logbook.add_sensor(&sensor).expect("added");
    let standard = CheckStandard {
        serial: sensor.serial,
        frequency_hz: f64::from(record(1, 1).points[0].spec.frequency_hz),
        every_days: 30,
        certified: None,
    };
    logbook.put_check_standard(&standard).expect("stated");
    add_to_lake(&logbook, &lake, "Lab ä/1").expect("added");
    let script = "
import duckdb, json, polars, sys
d = sys.argv[1]
def table(name):
    return f\"read_parquet('{d}/{name}/**/*.parquet', hive_partitioning = true, union_by_name = true)\"
# A release before: fewer columns, in a partition of its own.
import os
old = f'{d}/records/laboratory=Old/instrument=X/year=2020'
os.makedirs(old)
duckdb.sql(f\"copy (select 'aa' as record_sha256, 'X' as instrument_serial, 7::BIGINT as record_id) to '{old}/a.parquet'\")
print(json.dumps({
    'laboratories': duckdb.sql(f'select distinct laboratory from {table(\"records\")} order by 1').fetchall(),
    'records': duckdb.sql(f'select count(*), count(dut_serial), count(distinct record_sha256) from {table(\"records\")}').fetchone(),
    'points': duckdb.sql(f'select count(*), count(distinct record_sha256) from {table(\"points\")}').fetchone(),
    'range': duckdb.sql(f\"select count(*) from {table('settings')} where key like 'reference%'\").fetchone()[0] > 0,
    'budget': duckdb.sql(f'select count(distinct record_sha256), min(contribution_rel) >= 0 from {table(\"budgets\")}').fetchone(),
    'checks': duckdb.sql(f'select count(*), min(every_days) from {table(\"checks\")}').fetchone(),
    'polars': polars.read_parquet(f'{d}/points/**/*.parquet', hive_partitioning=True).height,
}))";
    let Some(output) = python::run(script, &[&lake]) else {
        return;
    };
    assert!(output.status.success(), "{}", text(&output.stderr));
    let read: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!(
        read["laboratories"],
        serde_json::json!([["Lab ä/1"], ["Old"]])
    );
    assert_eq!(read["records"], serde_json::json!([3, 2, 3]));
    assert_eq!(read["points"], serde_json::json!([6, 2]), "{read}");
    assert_eq!(read["range"], true);
    assert_eq!(read["checks"], serde_json::json!([2, 30]));
    assert_eq!(read["polars"], 6);
}
