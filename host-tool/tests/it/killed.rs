//! Programs that are killed at each of the system's calls that change a file, one after the other.
//!
//! strace counts these calls, SQLite's among them, and kills the program where it is about to make the one that is
//! asked for. After every one of them what was kept is whole, nothing has its name that the logbook does not know,
//! and the same request once more completes what was begun.
#![cfg(target_os = "linux")]

use crate::command_line::{serve, text};
use crate::device::Device;
use crate::logbook::{later, logbook};
use crate::{alone, tool};
use calib_logbook::Logbook;
use calib_protocol::record::{decode, digest};
use calib_protocol::signature::DeviceKey;
use calib_record::sample;
use calib_record::signature::signer;
use calib_signing::Kind;
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// Calls that change a file, or make a change stay. That a file is made, or emptied, has happened by the call that
/// follows; a call that this system has not is passed over.
const CALLS: &str = "?write,?writev,?pwrite64,?pwritev,?pwritev2,?copy_file_range,?sendfile,?truncate,?ftruncate,\
    ?fallocate,?fsync,?fdatasync,?rename,?renameat,?renameat2,?link,?linkat,?symlink,?symlinkat,?unlink,?unlinkat,\
    ?mkdir,?mkdirat,?rmdir,?chmod,?fchmod,?fchmodat,?fchmodat2";
/// Where certificates go.
const OUT: &str = "out";
/// Asks for a certificate of the record that is new.
const ISSUE: [&str; 6] = [
    "certificate",
    "new.calibrec",
    "--out",
    OUT,
    "--particulars",
    "house.toml",
];

/// strace; `None`, after saying so, where it is not installed. In CI that is a failure.
fn strace() -> Option<PathBuf> {
    let program = std::env::var_os("CALIB_STRACE").map(PathBuf::from);
    if program.is_none() {
        assert!(std::env::var_os("CI").is_none(), "CALIB_STRACE is not set");
        println!("CALIB_STRACE is not set: no write is cut off");
    }
    program
}

/// With the logbook that is kept in the folder, and a place of its own for what is not.
fn kept(mut command: Command, folder: &Path) -> Command {
    command
        .env("TMPDIR", folder.join("temporary"))
        .env("CALIB_LOGBOOK", folder.join("logbook.sqlite"))
        .env("CALIB_KEY_PASSWORD", "test");
    command
}

fn calib(folder: &Path, arguments: &[&str]) -> Output {
    let output = kept(tool(folder), folder).args(arguments).output();
    output.expect("calib starts")
}

/// Fate of a call.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Fate {
    /// The program is killed when it is about to make it.
    Kill,
    /// It fails: the disk is full.
    Full,
}

/// Calls that ask a disk for room, or learn that there was none.
const ROOM: [&str; 8] = [
    "write",
    "pwrite64",
    "fsync",
    "fdatasync",
    "mkdir",
    "rename",
    "renameat",
    "renameat2",
];

/// Runs the tool with this fate of one of its calls, by name and number in its thread. Every call goes to a log.
fn traced(
    strace: &Path,
    cut: Option<(Fate, &str, usize)>,
    folder: &Path,
    arguments: &[&str],
) -> Output {
    let mut command = kept(alone(strace, folder), folder);
    command
        .args(["-f", "-qq", "-y", "-s", "4096", "-e", "signal=none", "-o"])
        .arg(log(folder))
        .arg(format!("--trace={CALLS}"));
    if let Some((fate, call, number)) = cut {
        let fate = match fate {
            Fate::Kill => "signal=KILL",
            Fate::Full => "error=ENOSPC",
        };
        command.arg(format!("--inject={call}:{fate}:when={number}"));
    }
    command.arg(env!("CARGO_BIN_EXE_calib")).args(arguments);
    command.output().expect("strace starts")
}

fn log(folder: &Path) -> PathBuf {
    folder.join("temporary/calls")
}

/// Calls of a run, in order: thread, name and arguments.
fn called(folder: &Path) -> Vec<(String, String, String)> {
    let log = std::fs::read_to_string(log(folder)).expect("a log");
    let line = |line: &str| {
        // "4711 pwrite64(3</path>, ..."
        let (thread, rest) = line.split_once(' ')?;
        let (call, rest) = rest.trim_start().split_once('(')?;
        Some((thread.to_owned(), call.to_owned(), rest.to_owned()))
    };
    log.lines().filter_map(line).collect()
}

/// Every call, each by its name and its number among those of this name in its thread.
fn calls(folder: &Path) -> BTreeSet<(String, usize)> {
    let mut counts: BTreeMap<(String, String), usize> = BTreeMap::new();
    let mut all = BTreeSet::new();
    for (thread, call, _) in called(folder) {
        let count = counts.entry((thread, call.clone())).or_default();
        *count += 1;
        all.insert((call, *count));
    }
    all
}

/// Files that a power cut would take: those that got their name before their content was on disk, and names that were
/// never put there.
fn unsynced(folder: &Path) -> Vec<String> {
    let mut dirty: BTreeSet<PathBuf> = BTreeSet::new();
    let (mut wrong, mut named) = (Vec::new(), BTreeMap::new());
    for (_, call, arguments) in called(folder) {
        let of_file = arguments
            .split_once('<')
            .and_then(|(_, rest)| rest.split_once('>'));
        let of_file = of_file.map(|(path, _)| PathBuf::from(path));
        let quoted = arguments.split('"').skip(1).step_by(2);
        match (call.as_str(), of_file) {
            ("fsync" | "fdatasync", Some(path)) => {
                dirty.remove(&path);
                named.remove(&path);
            }
            ("rename" | "renameat" | "renameat2" | "link" | "linkat", _) => {
                let paths: Vec<PathBuf> = quoted.map(|path| folder.join(path)).collect();
                let [from, to] = &paths[..] else { continue };
                wrong.extend(
                    dirty
                        .iter()
                        .filter(|path| path.starts_with(from))
                        .map(|path| {
                            format!(
                                "{} is named {} before it is on disk",
                                path.display(),
                                to.display()
                            )
                        }),
                );
                named.insert(to.parent().expect("a folder").to_owned(), to.clone());
            }
            (call, Some(path)) if call.contains("write") && path.starts_with(folder) => {
                dirty.insert(path);
            }
            _ => {}
        }
    }
    let lost = named
        .into_values()
        .map(|to| format!("{} is never on disk", to.display()));
    wrong.extend(lost);
    wrong.retain(|line| !line.contains("/temporary/"));
    wrong
}

fn copied(from: &Path) -> tempfile::TempDir {
    // As strace names it.
    let place = std::env::temp_dir().canonicalize().expect("a place");
    let folder = tempfile::tempdir_in(place).expect("folder");
    std::fs::create_dir(folder.path().join("temporary")).expect("made");
    copy(from, folder.path());
    folder
}

fn copy(from: &Path, to: &Path) {
    for file in std::fs::read_dir(from).expect("listed").flatten() {
        let (path, to) = (file.path(), to.join(file.file_name()));
        if path.is_dir() {
            std::fs::create_dir(&to).expect("made");
            copy(&path, &to);
        } else {
            std::fs::copy(path, to).expect("copied");
        }
    }
}

/// Looks at what is there afterwards; several folders at once.
type Look<'a> = &'a (dyn Fn(&Path) + Sync);

/// A request that changes files, and completes itself when it is made once more.
struct Request<'a> {
    arguments: &'a [&'a str],
    /// Folder it begins with.
    from: &'a Path,
    /// Looks at what is there afterwards.
    done: Look<'a>,
}

/// Cuts it off at every call, and has it completed; how many calls there were.
fn cut_everywhere(strace: &Path, fate: Fate, request: &Request<'_>) -> usize {
    let whole = copied(request.from);
    let run = traced(strace, None, whole.path(), request.arguments);
    assert!(run.status.success(), "{}", text(&run.stderr));
    (request.done)(whole.path());
    assert_eq!(unsynced(whole.path()), [""; 0], "{:?}", request.arguments);
    let mut calls = calls(whole.path());
    calls.retain(|(call, _)| fate == Fate::Kill || ROOM.contains(&call.as_str()));
    let each = calls.par_iter();
    each.for_each(|(call, number)| cut_at(strace, (fate, call, *number), request));
    println!(
        "{fate:?} {}: {} calls",
        request.arguments.join(" "),
        calls.len()
    );
    calls.len()
}

/// Cuts it off at this call, and has it completed.
fn cut_at(strace: &Path, cut: (Fate, &str, usize), request: &Request<'_>) {
    let (fate, call, number) = cut;
    let folder = copied(request.from);
    let at = folder.path();
    let what = format!("{} {fate:?} {call} {number}", request.arguments.join(" "));
    let run = traced(strace, Some(cut), at, request.arguments);
    match fate {
        Fate::Kill => assert!(!run.status.success(), "{what} was not"),
        // In words, and no panic.
        Fate::Full => assert!(
            matches!(run.status.code(), Some(0 | 1 | 6)),
            "{what}: {run:?}"
        ),
    }
    is_whole(at, &what);
    let completed = calib(at, request.arguments);
    // What was done to its end, but for the word of it, is there already.
    let said = text(&completed.stderr);
    let words = ["already", "is there, and not empty"];
    let is_there = words.iter().any(|words| said.contains(words));
    assert!(completed.status.success() || is_there, "{what}: {said}");
    is_whole(at, &what);
    (request.done)(at);
}

/// Kept results are there, and each with a name is known.
fn is_whole(folder: &Path, what: &str) {
    let path = folder.join("logbook.sqlite");
    if !path.exists() {
        return;
    }
    let logbook = Logbook::open(&path).expect(what);
    assert_eq!(logbook.inspect().expect(what), [""; 0], "{what}");
    assert_eq!(logbook.inspect_seals(&[]).expect(what), [""; 0], "{what}");
    if folder.join("before").exists() {
        assert_eq!(
            logbook.record(1).expect(what),
            later(1, "A", 0, 1.0),
            "{what}"
        );
    }
    for (name, content) in certificates(folder) {
        let issued = logbook.issued_as(&content).expect(what);
        let issued =
            issued.unwrap_or_else(|| panic!("{what}: {name} is there, and nobody knows it"));
        if let Some(kind) = Kind::of(&content).filter(|kind| kind.is_signed(&content)) {
            calib_signing::verify(kind, &content).expect(what);
            assert!(!issued.signed.is_empty(), "{what}: {name}");
        }
    }
}

/// Files of certificates, by their names.
fn certificates(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let files = std::fs::read_dir(folder.join(OUT))
        .into_iter()
        .flatten()
        .flatten();
    let named = files.map(|file| (file.file_name().to_string_lossy().into_owned(), file.path()));
    let named = named.filter(|(name, _)| !name.starts_with('.'));
    named
        .map(|(name, path)| (name, std::fs::read(path).expect("read")))
        .collect()
}

/// A folder with a logbook that has one record, and the file of another.
fn begun() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("folder");
    let at = folder.path();
    logbook(at).keep(&later(1, "A", 0, 1.0)).expect("kept");
    for (name, content) in [
        ("before", &b""[..]),
        ("new.calibrec", &later(2, "A", 0, 1.0)),
        ("house.toml", b"[laboratory]\ncountry = 'DE'\nname = 'B'\n"),
    ] {
        std::fs::write(at.join(name), content).expect("written");
    }
    for key in ["p256.p12", "rsa.p12"] {
        std::fs::copy(crate::signed::key(key), at.join(key)).expect("copied");
    }
    folder
}

fn opened(folder: &Path) -> Logbook {
    Logbook::open(&folder.join("logbook.sqlite")).expect("a logbook")
}

#[test]
fn a_kill_in_every_write_of_the_logbook_leaves_it_whole() {
    let Some(strace) = strace() else { return };
    let (nothing, begun) = (tempfile::tempdir().expect("folder"), begun());
    let other = tempfile::tempdir().expect("folder");
    let mut of_other = logbook(other.path());
    of_other.keep(&later(3, "B", 0, 1.0)).expect("kept");
    drop(of_other);
    std::fs::copy(
        other.path().join("logbook.sqlite"),
        begun.path().join("other.sqlite"),
    )
    .expect("copied");
    let has = |number: i64| move |at: &Path| drop(opened(at).record(number).expect("entered"));
    for (from, arguments, done) in [
        (
            &nothing,
            &["sensors", "add", "--serial", "S-1"][..],
            &(|at: &Path| {
                assert!(opened(at).sensor("S-1").expect("read").is_some());
            }) as Look<'_>,
        ),
        (&begun, &["sensors", "add", "--serial", "S-1"], &|at| {
            assert!(opened(at).sensor("S-1").expect("read").is_some());
        }),
        (&begun, &["logbook", "add", "new.calibrec"], &has(2)),
        (&begun, &["logbook", "merge", "other.sqlite"], &has(2)),
        (&begun, &["logbook", "sign", "--key", "p256.p12"], &|at| {
            assert!(!opened(at).seals().expect("read").is_empty());
        }),
        (&begun, &["logbook", "backup", "copy.sqlite"], &|at| {
            let copy = Logbook::open_existing(&at.join("copy.sqlite")).expect("a copy");
            assert_eq!(copy.inspect().expect("read"), [""; 0]);
        }),
        (&begun, &["export", "--parquet", "set"], &|at| {
            assert!(at.join("set/records").is_dir());
        }),
        (
            &begun,
            &["export", "--lake", "lake", "--laboratory-name", "B"],
            &|at| {
                let again = calib_logbook::add_to_lake(&opened(at), &at.join("lake"), "B");
                assert_eq!(again.expect("whole").records, 0);
            },
        ),
        (&begun, &["config", "operator", "N."], &|at| {
            let config = std::fs::read_to_string(at.join("config.toml")).expect("there");
            assert_eq!(config, "operator = \"N.\"\n");
        }),
    ] {
        let request = Request {
            arguments,
            from: from.path(),
            done,
        };
        let calls = cut_everywhere(&strace, Fate::Kill, &request);
        assert!(calls >= 4, "{arguments:?}: {calls}");
    }
}

/// Signed afterwards.
#[test]
fn a_kill_in_every_write_of_a_signature_leaves_none_that_nobody_knows() {
    let Some(strace) = strace() else { return };
    let begun = begun();
    let made = calib(
        begun.path(),
        &[&ISSUE[..], &["--format", "pdf,dcc"]].concat(),
    );
    assert!(made.status.success(), "{}", text(&made.stderr));
    let names = certificates(begun.path()).into_iter();
    let names: Vec<String> = names.map(|(name, _)| format!("{OUT}/{name}")).collect();
    let request = Request {
        arguments: &["sign", &names[0], &names[1], "--key", "p256.p12"],
        from: begun.path(),
        done: &|at| assert_eq!(certificates(at).len(), 4),
    };
    let calls = cut_everywhere(&strace, Fate::Kill, &request);
    assert!(calls > 10, "{calls}");
}

/// A record from an instrument: into a file, into the logbook by the place where records wait, and its key.
#[test]
fn a_kill_in_every_write_of_what_an_instrument_gives_loses_nothing() {
    let Some(strace) = strace() else { return };
    let begun = begun();
    let (seed, record) = ([5; 32], later(4, "A", 0, 1.0));
    let signed = sample::signed(&decode(&record).expect("a record"), &seed);
    let public = signer(&signed).expect("signed");
    let mut device = Device::new();
    device.records.insert(4, signed.clone());
    device.key = Some(DeviceKey { public, since: 4 });
    let (_device, address) = serve(device);
    let serial = decode(&record).expect("a record").head.instrument_serial;
    // An instrument has one holder.
    let one_by_one = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    let one_by_one = one_by_one.expect("a thread");
    for (verb, done) in [
        (
            &["download", "4"][..],
            &(|at: &Path| {
                assert_eq!(
                    std::fs::read(at.join("record-00004.calibrec")).expect("there"),
                    signed
                );
            }) as Look<'_>,
        ),
        (&["sync"], &|at| {
            assert!(opened(at).has(&digest(&signed)).expect("read"));
            assert!(
                Logbook::enter_waiting(&at.join("logbook.sqlite"), &[])
                    .expect("read")
                    .numbers
                    .is_empty()
            );
        }),
        (&["key"], &|at| {
            assert_eq!(opened(at).keys(&serial).expect("read").len(), 1)
        }),
    ] {
        let request = Request {
            arguments: &[&["--device", &address], verb].concat(),
            from: begun.path(),
            done,
        };
        let calls = one_by_one.install(|| cut_everywhere(&strace, Fate::Kill, &request));
        assert!(calls >= 4, "{verb:?}: {calls}");
    }
}

/// The disk is full at any call that asks for room.
#[test]
fn a_disk_that_is_full_at_any_call_leaves_what_was_kept_and_says_so() {
    let Some(strace) = strace() else { return };
    let begun = begun();
    let sealed = ["--format", "dcc,csv", "--sign", "rsa.p12"];
    let has = |at: &Path| drop(opened(at).record(2).expect("entered"));
    let issued = |at: &Path| assert_eq!(certificates(at).len(), 2);
    for (arguments, done) in [
        (&["logbook", "add", "new.calibrec"][..], &has as Look<'_>),
        (&[&ISSUE[..], &sealed].concat(), &issued),
    ] {
        let request = Request {
            arguments,
            from: begun.path(),
            done,
        };
        let calls = cut_everywhere(&strace, Fate::Full, &request);
        assert!(calls > 10, "{arguments:?}: {calls}");
    }
}

/// Every kind of certificate and key; a PDF takes its time to be made, so one key signs that.
#[test]
fn a_kill_in_every_write_of_a_certificate_leaves_none_that_nobody_knows() {
    let Some(strace) = strace() else { return };
    let begun = begun();
    let all = |count: usize| move |at: &Path| assert_eq!(certificates(at).len(), count);
    for (more, done) in [
        (&["--format", "csv,json"][..], &all(2) as Look<'_>),
        (&["--format", "dcc,csv", "--sign", "rsa.p12"], &all(2)),
        (&["--format", "pdf,dcc", "--sign", "p256.p12"], &all(2)),
    ] {
        let request = Request {
            arguments: &[&ISSUE[..], more].concat(),
            from: begun.path(),
            done,
        };
        let calls = cut_everywhere(&strace, Fate::Kill, &request);
        assert!(calls > 10, "{more:?}: {calls}");
    }
}
