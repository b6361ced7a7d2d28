//! Certificates of kept records, as the program writes them: SHA-256 of each file, and of each line of
//! those that are text, so that a difference has a place.

use super::{Fault, Frozen};
use calib_gap_challenge::truth::sha256;
use serde_json::{Value, json};
use std::path::Path;
use std::process::Command;

/// A laboratory that states enough for every format.
const HOUSE: &str = "[laboratory]\nname = 'Example Calibration Ltd'\ncountry = 'GB'\n";

/// Digests by record, language and file.
pub(super) fn digests(records: &Path) -> Result<Frozen, Fault> {
    let tool =
        std::env::var_os("CALIB_TOOL").ok_or("CALIB_TOOL names no program: start by ./run")?;
    let folder = tempfile::tempdir()?;
    let house = folder.path().join("house.toml");
    std::fs::write(&house, HOUSE)?;
    let mut all = Frozen::new();
    for entry in std::fs::read_dir(records)? {
        let record = entry?.path();
        for language in ["en", "de"] {
            let stem = record
                .file_stem()
                .unwrap_or_default()
                .to_string_lossy()
                .into_owned();
            let out = folder.path().join(format!("{stem}-{language}"));
            let mut command = Command::new(&tool);
            command
                .arg("certificate")
                .arg(&record)
                .arg("--out")
                .arg(&out);
            command.args([
                "--language",
                language,
                "--format",
                "pdf,dcc,html,csv,json,uff",
            ]);
            command
                .arg("--laboratory")
                .arg(&house)
                .current_dir(folder.path());
            command
                .env("CALIB_BENCH", "none")
                .env("CALIB_LOGBOOK", "none");
            let output = command.output()?;
            if !output.status.success() {
                return Err(String::from_utf8_lossy(&output.stderr).into_owned().into());
            }
            all.extend(files(&format!("certificate-{stem}-{language}"), &out)?);
        }
    }
    Ok(all)
}

fn files(prefix: &str, folder: &Path) -> Result<Frozen, Fault> {
    let mut digests = Frozen::new();
    for entry in std::fs::read_dir(folder)? {
        let path = entry?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let kind = name.split_once('.').map_or("", |(_, kind)| kind);
        digests.insert(format!("{prefix}.{kind}"), digest(&std::fs::read(&path)?));
    }
    Ok(digests)
}

/// SHA-256 of the file, and eight digits of that of each line of a text.
fn digest(bytes: &[u8]) -> Value {
    let lines: Vec<String> = match std::str::from_utf8(bytes) {
        Ok(text) => text
            .lines()
            .map(|line| sha256(line.as_bytes())[..8].to_owned())
            .collect(),
        Err(_) => Vec::new(),
    };
    json!({ "sha256": sha256(bytes), "lines": lines.join(" ") })
}
