//! The logbook under programs that are killed, disks that are full, clocks that go backwards, and several at once.
#![cfg(unix)]

use crate::alone;
use crate::command_line::text;
use crate::logbook::{later, logbook};
use crate::logbook_sealed::{key, now};
use calib_logbook::{Issue, Kept, Logbook};
use calib_protocol::record::digest;
use std::collections::BTreeSet;
use std::path::Path;
use std::process::Output;

/// Runs the tool where no file may grow beyond so many blocks of 512 bytes. The write that would go beyond is where
/// it is killed, or, where that signal is not heeded, where its disk is full.
fn limited(folder: &Path, blocks: usize, is_killed: bool, arguments: &[&str]) -> Output {
    let heed = if is_killed { "" } else { "trap '' XFSZ; " };
    let script = format!("{heed}ulimit -c 0; ulimit -f {blocks}; exec \"$0\" \"$@\"");
    let mut shell = alone("sh", folder);
    shell
        .args(["-c", &script, env!("CARGO_BIN_EXE_calib")])
        .env("CALIB_LOGBOOK", folder.join("logbook.sqlite"));
    shell.args(arguments).output().expect("sh starts")
}

/// Whole, with the record of before.
fn is_whole(folder: &Path, before: &[u8]) -> Logbook {
    let logbook = logbook(folder);
    assert_eq!(logbook.inspect().expect("readable"), [""; 0]);
    assert_eq!(logbook.record(1).expect("the one of before"), before);
    logbook
}

/// A record is entered, and a certificate issued, by a program that dies in any of its writes, or whose disk is full
/// there. What was there stays; what it did is there or not; and the same once more does the rest.
#[test]
fn no_kill_and_no_full_disk_in_any_write_harms_what_was_kept() {
    let (before, new) = (later(1, "A", 0, 1.0), later(2, "A", 0, 1.0));
    for is_killed in [true, false] {
        let mut ends = BTreeSet::new();
        for blocks in (0..400).step_by(24) {
            let folder = tempfile::tempdir().expect("folder");
            let at = folder.path();
            std::fs::write(at.join("new.calibrec"), &new).expect("written");
            logbook(at).keep(&before).expect("kept");
            for arguments in [
                &["logbook", "add", "new.calibrec"][..],
                &["certificate", "new.calibrec", "--format", "csv,json,html"],
            ] {
                let cut = limited(at, blocks, is_killed, arguments);
                ends.insert(cut.status.success());
                if !is_killed {
                    // A failure in words, and no panic.
                    assert!(matches!(cut.status.code(), Some(0 | 1 | 6)), "{cut:?}");
                }
                let kept = is_whole(at, &before).certificates().expect("read").len();
                // All of its formats, or none.
                assert!(kept == 0 || kept == 3, "{blocks}: {kept}");
                drop(is_whole(at, &before));
                let again = limited(at, 1 << 20, true, arguments);
                assert!(again.status.success(), "{blocks}: {}", text(&again.stderr));
            }
            let logbook = is_whole(at, &before);
            assert_eq!(logbook.record(2).expect("entered"), new);
            assert_eq!(logbook.certificates().expect("read").len(), 3);
        }
        assert_eq!(ends.len(), 2, "some were cut, and some were not");
    }
}

/// Records, certificates and signatures whose times go back are kept in the order they were made.
#[test]
fn a_clock_that_goes_backwards_loses_nothing() {
    let folder = tempfile::tempdir().expect("folder");
    let mut logbook = logbook(folder.path());
    let key = key("rsa.p12");
    for (id, years) in [(1, 2), (2, 0), (3, 1)] {
        let record = later(id, "A", years, 1.0);
        assert!(matches!(
            logbook.keep(&record).expect("kept"),
            Kept::Added(_)
        ));
        let at = now() - jiff::SignedDuration::from_hours(i64::from(id));
        issue(&mut logbook, &format!("C-{id}"), &record, at.as_second());
        logbook.seal(&key, at, "").expect("signed");
    }
    let certificates = logbook.certificates().expect("read");
    let numbers: Vec<_> = certificates.iter().map(|c| &*c.certificate).collect();
    assert_eq!(numbers, ["C-1", "C-2", "C-3"]);
    assert_eq!(logbook.inspect().expect("readable"), [""; 0]);
    assert_eq!(logbook.inspect_seals(&[]).expect("readable"), [""; 0]);
    assert_eq!(logbook.signed_entries().expect("read"), (6, 6));
}

/// Four programs enter, issue and sign in one logbook at once: all of it is there, in one chain.
#[test]
fn several_programs_enter_issue_and_sign_at_once_and_nothing_is_lost() {
    let folder = tempfile::tempdir().expect("folder");
    drop(logbook(folder.path()));
    let rounds = 6;
    std::thread::scope(|scope| {
        for program in 0..4 {
            let at = folder.path();
            scope.spawn(move || {
                let mut logbook = logbook(at);
                let key = key("rsa.p12");
                for round in 0..rounds {
                    let id = 1 + program * rounds + round;
                    let record = later(id, "A", 0, 1.0);
                    logbook.keep(&record).expect("kept");
                    issue(&mut logbook, &format!("C-{id}"), &record, 1_700_000_000);
                    logbook.seal(&key, now(), "").expect("signed");
                }
            });
        }
    });
    let logbook = logbook(folder.path());
    assert_eq!(logbook.inspect().expect("readable"), [""; 0]);
    assert_eq!(logbook.inspect_seals(&[]).expect("readable"), [""; 0]);
    assert_eq!(logbook.certificates().expect("read").len(), 24);
    assert_eq!(logbook.signed_entries().expect("read"), (48, 48));
}

fn issue(logbook: &mut Logbook, number: &str, record: &[u8], issued_s: i64) {
    let issue = Issue {
        certificate: number,
        format: "pdf",
        file: "certificate.pdf",
        content: number.as_bytes(),
        record: digest(record),
        signed: None,
        joined: &[],
        replaces: None,
    };
    logbook.issue(&[issue], issued_s).expect("issued");
}
