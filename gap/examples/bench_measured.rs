//! Measured sets of known cause: what the diagnosis says of them. `bench_measured [DIR]`
//!
//! `DIR` holds dataset folders, one set each. A set is measured data from elsewhere and no part of
//! the repository; its known cause stands here, or in a file `cause.txt` of its folder: names of the
//! library joined by "+". The table says whether the leading cause is the known one or has it in it,
//! how much of the gap is closed on rows that took no part, the verdict and the first stage.

use calib_gap::{Answer, Options, diagnose};
use std::path::{Path, PathBuf};

/// Sets whose cause is published, or was built in.
const KNOWN: [(&str, &str); 10] = [
    ("ptb_accelerometer_sine", "dut_resonance"),
    ("real_emps_spring1", "coulomb_friction"),
    ("real_opamp_highpass", "dut_highpass"),
    ("real_opamp_lowpass", "dut_lowpass_1"),
    ("real_rc_highpass", "dut_highpass"),
    ("real_rc_lowpass", "dut_lowpass_1"),
    ("shaker_drive", "lossy_inductance|shorted_inductance"),
    ("silverbox_arrow", "cubic_stiffness"),
    ("silverbox_fit", "cubic_stiffness"),
    ("silverbox_multisine", "cubic_stiffness"),
];

/// Where measured sets lie beside the repository.
const USUAL: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../shared/data");

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = std::env::args().nth(1);
    let folder = PathBuf::from(folder.unwrap_or_else(|| USUAL.into()));
    let mut sets: Vec<PathBuf> = std::fs::read_dir(&folder)
        .map_err(|error| format!("{}: {error}; name a folder of datasets", folder.display()))?
        .filter_map(|entry| Some(entry.ok()?.path()))
        .filter(|path| path.join("rig.toml").is_file())
        .collect();
    sets.sort();
    println!(
        "{:<26} {:<18} {:>5} {:>8} {:>6} {:<17} {:<13} leading",
        "set", "known", "right", "closed", "chi", "verdict", "stage"
    );
    let (mut right, mut of, mut lines) = (0, 0, Vec::new());
    for set in &sets {
        let name = set.file_name().unwrap_or_default().to_string_lossy();
        let known = known(set, &name);
        let line = match diagnose(set, &Options::default()) {
            Ok(answer) => {
                let found = known.as_deref().map(|known| leads(&answer, known));
                right += usize::from(found == Some(true));
                of += usize::from(found.is_some());
                row(&name, known.as_deref(), found, &answer)
            }
            Err(error) => serde_json::json!({"set": name, "error": error.to_string()}),
        };
        println!("{}", text(&line));
        lines.push(line);
    }
    println!("leading cause right in {right} of {of}");
    if let Ok(path) = std::env::var("CALIB_BENCH_JSON") {
        let all = serde_json::json!({"right": right, "of": of, "sets": lines});
        std::fs::write(path, serde_json::to_string_pretty(&all)?)?;
    }
    Ok(())
}

fn known(set: &Path, name: &str) -> Option<String> {
    let stated = std::fs::read_to_string(set.join("cause.txt")).ok();
    let of_table = KNOWN.iter().find(|(set, _)| *set == name);
    stated
        .map(|text| text.trim().to_owned())
        .or_else(|| of_table.map(|(_, known)| (*known).to_owned()))
}

/// Whether every known effect is in the leading set, in one of the forms that are possible.
fn leads(answer: &Answer, known: &str) -> bool {
    let leading = answer.causes.first();
    leading.is_some_and(|cause| {
        let contains = |forms: &str| forms.split('|').any(|name| cause.effects.contains(&name));
        known.split('+').all(contains)
    })
}

fn row(name: &str, known: Option<&str>, right: Option<bool>, answer: &Answer) -> serde_json::Value {
    let leading = answer.causes.first();
    serde_json::json!({
        "set": name,
        "known": known,
        "right": right,
        "closed": answer.gap.size.closed,
        "chi_after": answer.gap.size.chi_after,
        "verdict": answer.verdict,
        "stage": answer.r#where.first().map(|place| place.stage.name()),
        "leading": leading.map(|cause| cause.effects.join("+")),
        "probability": leading.map(|cause| cause.probability),
        "next": answer.next_measurement,
    })
}

/// A line of the table.
fn text(line: &serde_json::Value) -> String {
    let word = |key: &str| line[key].as_str().unwrap_or("-").to_owned();
    if line["error"].is_string() {
        return format!("{:<26} refused: {}", word("set"), word("error"));
    }
    let right = match line["right"].as_bool() {
        Some(true) => "yes",
        Some(false) => "NO",
        None => "-",
    };
    let closed = line["closed"].as_f64();
    let closed = closed.map_or("-".into(), |share| format!("{:.1} %", 100.0 * share));
    format!(
        "{:<26} {:<18} {right:>5} {closed:>8} {:>6.3} {:<17} {:<13} {} ({:.3})",
        word("set"),
        word("known"),
        line["chi_after"].as_f64().unwrap_or(f64::NAN),
        word("verdict"),
        word("stage"),
        word("leading"),
        line["probability"].as_f64().unwrap_or(0.0),
    )
}
