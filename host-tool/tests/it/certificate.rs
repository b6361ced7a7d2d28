//! `calib certificate` as a technician or a laboratory meets it: from a file
//! to files, and every way that can go wrong.

use crate::command_line::text;
use crate::{tool, words};
use calib_protocol::record::Record;
use calib_record::sample;
use std::path::Path;
use std::process::Output;

fn calib(folder: &Path, arguments: &[&str]) -> Output {
    let output = tool(folder).args(arguments).output();
    output.expect("calib starts")
}

/// A folder with `record.bin`.
fn folder(record: &Record) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("folder");
    std::fs::write(folder.path().join("record.bin"), sample::bytes(record)).expect("written");
    // A DCC cannot be without it.
    let house = "[laboratory]\ncountry = 'DE'\n";
    std::fs::write(folder.path().join("house.toml"), house).expect("written");
    folder
}

fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).into_iter().flatten();
    let name = |entry: std::io::Result<std::fs::DirEntry>| {
        entry
            .expect("entry")
            .file_name()
            .to_string_lossy()
            .into_owned()
    };
    let mut names: Vec<_> = entries.map(name).collect();
    names.sort();
    names
}

const ALL: [&str; 8] = [
    "certificate",
    "record.bin",
    "--out",
    "out",
    "--format",
    "pdf,dcc,html,csv,json,uff",
    "--particulars",
    "house.toml",
];

#[test]
fn strict_refuses_a_draft_and_names_what_is_missing() {
    let folder = folder(&sample::record(&[160.0]));
    let usual = words("certificate record.bin --out out --format json");
    let strict = calib(folder.path(), &[&usual[..], &["--strict"]].concat());
    assert_eq!(strict.status.code(), Some(6));
    let said = text(&strict.stderr);
    assert!(
        said.contains("Authorised by") && said.contains("Customer"),
        "{said}"
    );
    assert!(!folder.path().join("out").exists());
    let draft = calib(folder.path(), &usual);
    assert!(draft.status.success());
    assert!(text(&draft.stderr).contains("DRAFT"));
}

/// The kept record is of the emulated instrument, which reports the id of its processor.
#[test]
fn what_the_emulated_instrument_measured_says_so() {
    let record = include_bytes!("../../../tests/frozen/records/demo.calibrec");
    let folder = tempfile::tempdir().expect("folder");
    std::fs::write(folder.path().join("record.bin"), record).expect("written");
    let arguments = ["certificate", "record.bin", "--format", "csv"];
    let output = calib(folder.path(), &arguments);
    assert!(text(&output.stderr).contains("SIMULATED"), "{output:?}");
    let name = "certificate-23004100075457494E303120-000002.csv";
    let csv = std::fs::read_to_string(folder.path().join(name)).expect("written");
    assert!(
        csv.lines()
            .skip(1)
            .all(|line| line.contains(",simulated draft,")),
        "{csv}"
    );
}

#[test]
fn without_a_country_a_dcc_is_left_out_unless_it_is_asked_for() {
    let folder = folder(&sample::record(&[160.0]));
    let usual = ["certificate", "record.bin", "--out", "out"];
    let output = calib(folder.path(), &usual);
    assert!(output.status.success(), "{}", text(&output.stderr));
    assert!(text(&output.stderr).contains("no DCC"), "{output:?}");
    let out = folder.path().join("out");
    let stem = "certificate-CAL-0042-000017";
    let expected = ["csv", "html", "json", "pdf"].map(|e| format!("{stem}.{e}"));
    assert_eq!(names(&out), expected);
    let asked = calib(folder.path(), &[&usual[..], &["--format", "dcc"]].concat());
    assert_eq!(asked.status.code(), Some(6));
    let said = text(&asked.stderr);
    assert!(
        said.contains("country") && said.contains("[laboratory]"),
        "{said}"
    );
    assert_eq!(names(&out), expected);
}

#[test]
fn a_template_begins_as_the_built_in_page() {
    let folder = folder(&sample::record(&sample::THIRD_OCTAVES_HZ));
    let write = ["certificate", "--write-template", "page"];
    let written = calib(folder.path(), &write);
    assert!(written.status.success(), "{}", text(&written.stderr));
    assert_eq!(names(&folder.path().join("page")), ["certificate.typ"]);
    let own = "[layout]\ntemplate = 'page/certificate.typ'\n";
    std::fs::write(folder.path().join("own.toml"), own).expect("written");
    let certificate = |out: &str, extra: &[&str]| {
        let arguments = ["certificate", "record.bin", "--format", "pdf", "--out", out];
        let output = calib(folder.path(), &[&arguments, extra].concat());
        assert!(output.status.success(), "{}", text(&output.stderr));
        let name = "certificate-CAL-0042-000017.pdf";
        std::fs::read(folder.path().join(out).join(name)).expect("read")
    };
    let (ours, theirs) = (certificate("a", &[]), certificate("b", &["-p", "own.toml"]));
    assert!(ours == theirs, "the written page gives another document");
    // What the laboratory made of it is not written over.
    std::fs::write(folder.path().join("page/certificate.typ"), "= Ours").expect("written");
    assert_eq!(calib(folder.path(), &write).status.code(), Some(6));
}

#[test]
fn a_stored_record_gives_every_form_and_the_same_bytes_again() {
    let folder = folder(&sample::record(&sample::THIRD_OCTAVES_HZ));
    let output = calib(folder.path(), &ALL);
    assert!(output.status.success(), "{}", text(&output.stderr));
    let out = folder.path().join("out");
    let stem = "certificate-CAL-0042-000017";
    let expected = ["csv", "dcc.xml", "html", "json", "pdf", "uff"].map(|e| format!("{stem}.{e}"));
    assert_eq!(names(&out), expected);
    assert_eq!(text(&output.stdout).lines().count(), 6);
    // Again: the same bytes are no other certificate.
    assert!(calib(folder.path(), &ALL).status.success());
    let pdf = std::fs::read(out.join(format!("{stem}.pdf"))).expect("read");
    assert!(pdf.starts_with(b"%PDF-1.7"));
}

#[test]
fn a_date_of_issue_that_is_still_to_come_is_refused() {
    let folder = folder(&sample::record(&[160.0]));
    let house = folder.path().join("lab.toml");
    std::fs::write(house, "[calibration]\nissued = 2999-01-01\n").expect("written");
    let output = calib(
        folder.path(),
        &[&ALL[..], &["--particulars", "lab.toml"]].concat(),
    );
    assert_eq!(output.status.code(), Some(6), "{}", text(&output.stderr));
    let said = text(&output.stderr);
    assert!(
        said.contains("2999-01-01, which is still to come"),
        "{said}"
    );
    assert!(!folder.path().join("out").exists());
}

#[test]
fn a_certificate_that_was_issued_is_not_overwritten() {
    let folder = folder(&sample::record(&[160.0]));
    assert!(calib(folder.path(), &ALL).status.success());
    let issued = folder.path().join("out/certificate-CAL-0042-000017.pdf");
    let before = std::fs::read(&issued).expect("issued");
    std::fs::write(
        folder.path().join("lab.toml"),
        "[laboratory]\nname = 'Another'\n",
    )
    .expect("written");
    let output = calib(
        folder.path(),
        &[&ALL[..], &["--particulars", "lab.toml"]].concat(),
    );
    assert_eq!(output.status.code(), Some(6), "{}", text(&output.stderr));
    assert!(
        text(&output.stderr).contains("not overwritten"),
        "{}",
        text(&output.stderr)
    );
    assert_eq!(std::fs::read(&issued).expect("issued"), before);
    assert_eq!(names(&folder.path().join("out")).len(), 6);
}

#[test]
fn what_is_no_record_is_refused_with_the_way_out() {
    let whole = sample::bytes(&sample::record(&[160.0, 1000.0]));
    let mut newer = whole.clone();
    newer[0] += 1;
    let end = newer.len() - 4;
    let sum = calib_protocol::frame::CRC.checksum(&newer[..end]);
    newer[end..].copy_from_slice(&sum.to_le_bytes());
    let mut flipped = whole.clone();
    flipped[whole.len() / 2] ^= 0x10;
    let cases = [
        (newer, "record version 3", "install a newer calib"),
        (flipped, "checksum", "download it again"),
        (
            whole[..whole.len() - 9].to_vec(),
            "checksum",
            "download it again",
        ),
        (vec![], "length", "download it again"),
        (
            b"frequency_hz,level\n160,10\n".to_vec(),
            "checksum",
            "download it again",
        ),
    ];
    for (bytes, problem, hint) in cases {
        let folder = tempfile::tempdir().expect("folder");
        std::fs::write(folder.path().join("record.bin"), bytes).expect("written");
        let output = calib(folder.path(), &ALL);
        let said = text(&output.stderr);
        assert_eq!(output.status.code(), Some(6), "{said}");
        assert!(
            said.contains("record.bin") && said.contains(problem) && said.contains(hint),
            "{said}"
        );
        assert!(names(&folder.path().join("out")).is_empty());
    }
}

#[test]
fn a_template_that_does_not_compile_names_its_line_and_leaves_nothing() {
    let folder = folder(&sample::record(&[160.0]));
    let write = |name: &str, content: &str| {
        std::fs::write(folder.path().join(name), content).expect("written");
    };
    write("lab.toml", "[layout]\ntemplate = 'ours.typ'\n");
    write("ours.typ", "= Title\n\n#unknown\n");
    let output = calib(
        folder.path(),
        &[&ALL[..], &["--particulars", "lab.toml"]].concat(),
    );
    let said = text(&output.stderr);
    assert_eq!(output.status.code(), Some(6), "{said}");
    assert!(
        said.contains("ours.typ:3") && said.contains("unknown"),
        "{said}"
    );
    assert!(names(&folder.path().join("out")).is_empty());
}

#[test]
fn names_with_apostrophes_and_emoji_and_numbers_that_are_none_go_through() {
    let mut record = sample::record(&[80.0, 160.0, 1000.0]);
    record.head.labels.dut_model = sample::text("O'Brien \"#1\" <b> 🎛 $x$");
    record.points[0].sensitivity_v_per_ms2 = f32::NAN;
    record.points[2].signal_to_noise_dut_db = f32::NAN;
    let folder = folder(&record);
    let output = calib(folder.path(), &ALL);
    assert!(output.status.success(), "{}", text(&output.stderr));
    let read = |name: &str| {
        let path = folder
            .path()
            .join("out")
            .join(format!("certificate-CAL-0042-000017.{name}"));
        text(&std::fs::read(path).expect("read"))
    };
    assert!(read("json").contains("O'Brien \\\"#1\\\" <b> 🎛 $x$"));
    assert!(read("html").contains("&lt;b&gt; 🎛"));
    assert!(read("dcc.xml").contains("&lt;b&gt; 🎛"));
    for form in ["json", "html", "csv", "dcc.xml", "uff"] {
        assert!(!read(form).contains("NaN"), "{form}");
    }
}

#[test]
fn as_found_and_as_left_need_one_object() {
    let left = sample::record(&[80.0, 160.0]);
    let mut found = left.clone();
    found.head.id = 16;
    let folder = folder(&left);
    let write = |record: &Record| {
        std::fs::write(folder.path().join("found.bin"), sample::bytes(record)).expect("written");
        calib(
            folder.path(),
            &[&ALL[..], &["--as-found", "found.bin"]].concat(),
        )
    };
    found.head.labels.dut_serial = sample::text("another");
    let output = write(&found);
    assert_eq!(output.status.code(), Some(6), "{}", text(&output.stderr));
    found.head.labels.dut_serial = left.head.labels.dut_serial.clone();
    let output = write(&found);
    assert!(output.status.success(), "{}", text(&output.stderr));
}

// Elsewhere the configuration directory does not follow the environment.
#[cfg(target_os = "linux")]
#[test]
fn the_file_of_the_laboratory_is_read_without_being_named() {
    let folder = folder(&sample::record(&[160.0]));
    let config = folder.path().join("config/calib");
    std::fs::create_dir_all(&config).expect("folder");
    let house = "language = 'de'\n[laboratory]\nname = 'Haus'\ncity = 'Ort'\ncountry = 'DE'\n";
    std::fs::write(config.join("laboratory.toml"), house).expect("written");
    std::fs::write(
        folder.path().join("job.toml"),
        "[laboratory]\ncity = 'Feld'\n",
    )
    .expect("written");
    let arguments = words("certificate record.bin --format json -p job.toml");
    let output = calib(folder.path(), &arguments);
    assert!(output.status.success(), "{}", text(&output.stderr));
    let json = std::fs::read(folder.path().join("certificate-CAL-0042-000017.json")).expect("read");
    let json: serde_json::Value = serde_json::from_slice(&json).expect("JSON");
    assert_eq!(json["laboratory"]["name"], "Haus, Feld, DE");
    assert_eq!(json["language"], "de");
}

/// A disk that is full is a file that takes no more: the limit of the shell on
/// the size of files gives the same error in the middle of a file.
#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_leaves_nothing_half_written() {
    let folder = folder(&sample::record(&sample::THIRD_OCTAVES_HZ));
    // 8 blocks of 512 bytes: enough for the CSV, not for the PDF.
    let script = format!("trap '' XFSZ; ulimit -f 8; exec \"$0\" {}", ALL.join(" "));
    let output = crate::alone("sh", folder.path())
        .args(["-c", &script, env!("CARGO_BIN_EXE_calib")])
        .output()
        .expect("sh starts");
    let said = text(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(said.contains("certificate-CAL-0042-000017"), "{said}");
    assert!(names(&folder.path().join("out")).is_empty());
    // The list of files goes to a full device: said, not a panic.
    let script = format!("exec \"$0\" {} > /dev/full", ALL.join(" "));
    let output = crate::alone("sh", folder.path())
        .args(["-c", &script, env!("CARGO_BIN_EXE_calib")])
        .output()
        .expect("sh starts");
    assert_eq!(output.status.code(), Some(1));
    assert!(
        text(&output.stderr).contains("standard output"),
        "{}",
        text(&output.stderr)
    );
}
