//! A logbook whose file was damaged.

use super::{folder, put, read_or_refused};
use crate::hostile::seeds::record as example_record;
use calib_logbook::{Filter, Logbook};
use std::sync::LazyLock;

/// Serial number of a sensor that is in no record: the history of one that is there is asked
/// for by what the file says.
const SENSOR: &str = "";

/// A logbook with one record, as it lies on the disk.
static WHOLE: LazyLock<Vec<u8>> = LazyLock::new(|| {
    let path = folder().join("whole.sqlite");
    let mut logbook = Logbook::open(&path).expect("a new logbook");
    logbook.keep(&example_record()).expect("a record");
    drop(logbook);
    std::fs::read(&path).expect("its file")
});

/// Four bytes are one damage: place (u24) and the bits flipped there; an odd rest
/// cuts the file off. All that is asked of the logbook ends in an answer or in an
/// error that names the file, and a record is the one that was kept, or none.
pub fn logbook(data: &[u8]) {
    let path = put("logbook.sqlite", &damaged(data));
    for journal in [
        "logbook.sqlite-journal",
        "logbook.sqlite-wal",
        "logbook.sqlite-shm",
    ] {
        let _ = std::fs::remove_file(folder().join(journal));
    }
    let Some(logbook) = read_or_refused(&path, Logbook::open(&path)) else {
        return;
    };
    let listed = read_or_refused(&path, logbook.records(&Filter::default())).unwrap_or_default();
    let mut whole = true;
    for line in &listed {
        match read_or_refused(&path, logbook.record(line.id)) {
            Some(bytes) => assert!(bytes == example_record(), "another record than was kept"),
            None => whole = false,
        }
    }
    let inspected = read_or_refused(&path, logbook.inspect());
    if inspected.is_some_and(|wrong| wrong.is_empty()) {
        assert!(whole, "a damaged record, and nothing found");
    }
    let _ = read_or_refused(&path, logbook.certificates());
    let _ = read_or_refused(&path, logbook.instruments());
    let _ = read_or_refused(&path, logbook.operators());
    let _ = read_or_refused(&path, logbook.sensors(""));
    let _ = read_or_refused(&path, logbook.history(SENSOR, 160.0));
}

fn damaged(data: &[u8]) -> Vec<u8> {
    let mut file = WHOLE.clone();
    let (places, rest) = data.as_chunks::<4>();
    for [high, middle, low, flipped] in places {
        let at = u32::from_be_bytes([0, *high, *middle, *low]) as usize % file.len();
        file[at] ^= flipped;
    }
    if let [.., last] = rest {
        file.truncate(file.len() * usize::from(*last) / 256);
    }
    file
}
