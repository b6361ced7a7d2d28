//! Rigs and datasets.

use super::{folder, put};
use calib_gap::{Answer, GapError, Options};
use calib_twin::rig::Rig;

/// A rig file of the twin: what is read is written and read again as the same.
pub fn rig(data: &[u8]) {
    let Ok(text) = std::str::from_utf8(data) else {
        return;
    };
    match Rig::parse(text, "mine.toml") {
        Ok(rig) => {
            let again = rig.to_toml().expect("plain numbers");
            assert_eq!(Rig::parse(&again, "mine.toml").ok(), Some(rig));
        }
        Err(error) => assert!(error.to_string().contains("mine.toml"), "{error}"),
    }
}

/// A dataset: `rig.toml`, a zero, then its table. Refused, or diagnosed with
/// probabilities that are some.
pub fn dataset(data: &[u8]) {
    let mut parts = data.splitn(2, |byte| *byte == 0);
    let rig = parts.next().unwrap_or_default();
    let table = parts.next().unwrap_or_default();
    put("rig.toml", rig);
    // Rows cost a diagnosis time, and one more tells nothing of the reader.
    if table.iter().filter(|byte| **byte == b'\n').count() > 40 {
        return;
    }
    for name in ["points.csv", "record.csv"] {
        put(name, table);
    }
    match calib_gap::diagnose(&folder(), &Options::default()) {
        Ok(answer) => expect_sense(&answer),
        Err(error) => expect_blame(&error),
    }
}

fn expect_sense(answer: &Answer) {
    for cause in &answer.causes {
        assert!((0.0..=1.0 + 1e-9).contains(&cause.probability), "{cause:?}");
    }
    let written = serde_json::to_string(answer);
    assert!(written.is_ok(), "{written:?}");
}

fn expect_blame(error: &GapError) {
    let said = error.to_string();
    let named = ["rig.toml", "points.csv", "record.csv"];
    assert!(named.iter().any(|file| said.contains(file)), "{said}");
}
