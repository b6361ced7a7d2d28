//! A certificate with something wrong on it is replaced, not changed (ISO/IEC 17025, 7.8.8): the new one says what it
//! replaces and why, is made of the same records, and everybody who asks is told which one is in force.

use crate::command_line::{calib, text};
use crate::logbook::{logbook, on_day};
use crate::words;
use serde_json::Value;
use std::path::Path;
use std::process::Output;

const OLD: &str = "MEM-1-000001";
const JOB: &str = "language = 'en'\n[laboratory]\ncountry = 'DE'\n[customer]\nname = 'A. Ltd'\n";

/// A logbook with three records of one device, and a certificate of two of them as left and as found.
fn issued(folder: &Path) {
    let mut logbook = logbook(folder);
    for (id, factor) in [(1, 1.04), (2, 1.0), (3, 1.1)] {
        logbook
            .keep(&on_day(id, "S-1", u64::from(id), factor))
            .expect("kept");
    }
    std::fs::write(folder.join("job.toml"), JOB).expect("written");
    for (id, name) in [("1", "found"), ("2", "left"), ("3", "other")] {
        assert!(
            go(folder, &["logbook", "get", id, "--out", name])
                .status
                .success()
        );
    }
    let made = go(
        folder,
        &words("certificate left --as-found found --format pdf,dcc,json -p job.toml -o old"),
    );
    assert!(made.status.success(), "{}", text(&made.stderr));
}

fn go(folder: &Path, arguments: &[&str]) -> Output {
    calib(
        folder,
        &[arguments, &["--logbook", "logbook.sqlite"]].concat(),
    )
}

fn amend(folder: &Path, number: &str, reason: &str, more: &[&str]) -> Output {
    let usual = [
        "certificate",
        "--amend",
        number,
        "--reason",
        reason,
        "-p",
        "job.toml",
    ];
    go(folder, &[&usual, more].concat())
}

fn certificate(folder: &Path, path: &str) -> Value {
    let text = std::fs::read_to_string(folder.join(path)).expect(path);
    serde_json::from_str(&text).expect("JSON")
}

/// The document a verb printed, whatever its exit code.
fn printed(output: &Output) -> Value {
    serde_json::from_slice(&output.stdout).expect("JSON")
}

#[test]
fn a_wrong_customer_is_amended_and_what_was_measured_stays() {
    let folder = tempfile::tempdir().expect("folder");
    let folder = folder.path();
    issued(folder);
    let customer = [
        "--customer",
        "B. Ltd",
        "--format",
        "pdf,dcc,json",
        "-o",
        "new",
    ];
    let made = amend(folder, "MEM-1-000002", "name of the customer", &customer);
    assert!(made.status.success(), "{}", text(&made.stderr));
    let old = certificate(folder, "old/certificate-MEM-1-000002.json");
    let new = certificate(folder, "new/certificate-MEM-1-000002-A1.json");
    assert_eq!(new["certificate"], "MEM-1-000002-A1");
    let replaces =
        serde_json::json!({ "certificate": "MEM-1-000002", "reason": "name of the customer" });
    assert_eq!(new["replaces"], replaces);
    assert_eq!(old["replaces"], Value::Null);
    assert_eq!(new["laboratory"]["customer"], "B. Ltd");
    // The record as found came from the logbook: nobody named it.
    for same in ["points", "budget", "as_found", "conditions", "equipment"] {
        assert_eq!(old[same], new[same], "{same}");
    }
    let said = text(&go(folder, &["logbook", "certificates"]).stdout);
    let line = "MEM-1-000002 was replaced by MEM-1-000002-A1: name of the customer";
    assert_eq!(said.matches(line).count(), 1, "{said}");
    assert!(
        said.lines().all(|line| line.chars().count() <= 80),
        "{said}"
    );
    let verified = go(
        folder,
        &["verify", "old/certificate-MEM-1-000002.pdf", "--json"],
    );
    assert_eq!(verified.status.code(), Some(7));
    assert_eq!(
        printed(&verified)[0]["issued"]["replaced_by"],
        "MEM-1-000002-A1"
    );
    let verified = go(
        folder,
        &["verify", "new/certificate-MEM-1-000002-A1.pdf", "--json"],
    );
    assert_eq!(printed(&verified)[0]["issued"]["replaced_by"], Value::Null);
    // Another form of the amendment has its number; the same again changes nothing.
    for _again in 0..2 {
        let csv = ["--customer", "B. Ltd", "--format", "csv", "-o", "new"];
        let made = amend(folder, "MEM-1-000002", "name of the customer", &csv);
        assert!(made.status.success(), "{}", text(&made.stderr));
    }
    assert!(folder.join("new/certificate-MEM-1-000002-A1.csv").exists());
    let check = go(folder, &["logbook", "check"]);
    assert!(check.status.success(), "{}", text(&check.stdout));
}

#[test]
fn an_amendment_is_amended_in_turn_and_no_certificate_is_replaced_twice() {
    let folder = tempfile::tempdir().expect("folder");
    let folder = folder.path();
    issued(folder);
    let one = amend(folder, "MEM-1-000002", "customer", &["--format", "json"]);
    assert!(one.status.success(), "{}", text(&one.stderr));
    let twice = amend(folder, "MEM-1-000002", "address", &["--format", "json"]);
    assert_eq!(twice.status.code(), Some(6));
    let said = text(&twice.stderr);
    assert!(
        said.contains("replaced by MEM-1-000002-A1") && said.contains("--amend MEM-1-000002-A1"),
        "{said}"
    );
    let chain = amend(folder, "MEM-1-000002-A1", "address", &["--format", "json"]);
    assert!(chain.status.success(), "{}", text(&chain.stderr));
    let last = certificate(folder, "certificate-MEM-1-000002-A2.json");
    assert_eq!(last["replaces"]["certificate"], "MEM-1-000002-A1");
    // What is withdrawn appears in no further form.
    let withdrawn = words("certificate left --as-found found --format csv -p job.toml");
    let withdrawn = go(folder, &withdrawn);
    assert_eq!(withdrawn.status.code(), Some(6));
    assert!(!folder.join("certificate-MEM-1-000002.csv").exists());
    // A laboratory numbers as it likes.
    let own = format!("{JOB}[calibration]\nnumber = 'K-2026-18'\n");
    std::fs::write(folder.join("own.toml"), own).expect("written");
    let own = amend(
        folder,
        "MEM-1-000002-A2",
        "both",
        &["--format", "json", "-p", "own.toml"],
    );
    assert!(own.status.success(), "{}", text(&own.stderr));
    let own = certificate(folder, "certificate-K-2026-18.json");
    assert_eq!(own["replaces"]["certificate"], "MEM-1-000002-A2");
}

#[test]
fn what_was_measured_cannot_change_by_an_amendment() {
    let folder = tempfile::tempdir().expect("folder");
    let folder = folder.path();
    issued(folder);
    let before = std::fs::read_dir(folder).expect("folder").count();
    for (records, words) in [
        (&["other"][..], "other records"),
        (&["left", "--as-found", "left"], "other records"),
        (&["left", "--remounted", "other"], "other records"),
    ] {
        let more = [records, &["--format", "json"]].concat();
        let refused = amend(folder, "MEM-1-000002", "customer", &more);
        assert_eq!(refused.status.code(), Some(6), "{records:?}");
        assert!(
            text(&refused.stderr).contains(words),
            "{}",
            text(&refused.stderr)
        );
    }
    for (number, reason, code) in [(OLD, "customer", 6), ("MEM-1-000002", " ", 2)] {
        let refused = amend(folder, number, reason, &["--format", "json"]);
        assert_eq!(
            refused.status.code(),
            Some(code),
            "{}",
            text(&refused.stderr)
        );
    }
    let without = go(folder, &["certificate", "--amend", "MEM-1-000002"]);
    assert_eq!(without.status.code(), Some(2));
    assert_eq!(std::fs::read_dir(folder).expect("folder").count(), before);
}

#[test]
fn amendments_are_taken_over_and_a_forged_one_is_found() {
    let folder = tempfile::tempdir().expect("folder");
    let folder = folder.path();
    issued(folder);
    let made = amend(folder, "MEM-1-000002", "customer", &["--format", "json"]);
    assert!(made.status.success(), "{}", text(&made.stderr));
    let other = tempfile::tempdir().expect("folder");
    let mut merged = logbook(other.path());
    let theirs = logbook(folder);
    for _again in 0..2 {
        assert_eq!(merged.merge(&theirs).expect("merged").conflicts, [""; 0]);
    }
    let by = merged
        .replaced_by("MEM-1-000002")
        .expect("read")
        .expect("replaced");
    assert_eq!(by.certificate, "MEM-1-000002-A1");
    assert_eq!(
        merged.sources("MEM-1-000002").expect("read"),
        theirs.sources("MEM-1-000002").expect("read")
    );
    assert_eq!(merged.inspect().expect("read"), [""; 0]);
    let raw = rusqlite::Connection::open(theirs.path()).expect("the file");
    for table in ["amendments", "joined"] {
        raw.execute(&format!("DELETE FROM {table}"), [])
            .expect_err(table);
    }
    raw.execute(
        "INSERT INTO amendments VALUES ('X-1', 'MEM-1-000002-A1', 'forged')",
        [],
    )
    .expect("inserted");
    let wrong = theirs.inspect().expect("read");
    assert!(
        wrong.iter().any(|line| line.contains("amendment X-1")),
        "{wrong:?}"
    );
}
