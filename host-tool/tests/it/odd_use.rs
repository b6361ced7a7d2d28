//! Effects of a program, a hostile file or a full disk on the tool.

use crate::command_line::{calib, text};
use crate::device::record;
use calib_protocol::record::Record;
use calib_record::sample;
use std::path::Path;

fn written(record: &Record, path: &Path) {
    std::fs::write(path, sample::bytes(record)).expect("written");
}

#[test]
fn with_json_a_misused_command_line_is_one_document_too() {
    for arguments in [
        &["frobnicate", "--json"][..],
        &["run", "--level", "nan", "--json"],
    ] {
        let output = calib(Path::new("."), arguments);
        assert_eq!(output.status.code(), Some(2));
        assert!(output.stdout.is_empty());
        let failure: serde_json::Value =
            serde_json::from_slice(&output.stderr).expect("a document");
        assert_eq!(failure["exit_code"], 2);
        let problem = failure["error"].as_str().expect("words");
        assert!(
            !problem.starts_with("error") && problem.contains(arguments[arguments.len() - 2]),
            "{failure}"
        );
    }
}

#[test]
fn words_of_a_record_do_not_steer_the_terminal() {
    let directory = tempfile::tempdir().expect("directory");
    let mut hostile = record(3, 2);
    // Clears the screen and renames the window.
    hostile.head.labels.dut_serial = "\u{1b}[2J\u{1b}]0;x\u{7}".try_into().expect("short");
    written(&hostile, &directory.path().join("hostile.calibrec"));
    let output = calib(directory.path(), &["show", "hostile.calibrec"]);
    assert!(output.status.success());
    let shown = text(&output.stdout);
    assert!(shown.contains("?[2J?]0;x?"), "{shown}");
    assert!(!shown.contains(['\u{1b}', '\u{7}']));
}

#[cfg(unix)]
#[test]
fn a_file_may_have_a_name_that_is_no_text() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;
    let directory = tempfile::tempdir().expect("directory");
    let name = OsStr::from_bytes(b"r\xff.calibrec");
    written(&record(3, 2), &directory.path().join(name));
    let mut tool = crate::tool(directory.path());
    let status = tool.arg("show").arg(name).status();
    assert!(status.expect("calib starts").success());
}

#[cfg(target_os = "linux")]
#[test]
fn what_could_not_be_printed_is_no_success() {
    for arguments in [&["version"][..], &["--help"]] {
        let full = std::fs::OpenOptions::new().write(true).open("/dev/full");
        let mut tool = crate::tool(Path::new("."));
        let tool = tool.args(arguments).stdout(full.expect("a full disk"));
        let output = tool.output();
        let output = output.expect("calib starts");
        assert_eq!(output.status.code(), Some(1), "{arguments:?}");
        assert!(text(&output.stderr).contains("cannot write standard output"));
    }
}
