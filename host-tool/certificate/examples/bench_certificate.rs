//! Time for the certificates of one record: the program as a user starts it,
//! and each form alone.
//!
//! `./run bench certificate` runs it; `CALIB_TOOL` names the program,
//! `CALIB_BENCH_JSON` a file for the numbers.
#![expect(clippy::print_stdout, reason = "a benchmark prints its table")]

use calib_certificate::{Certificate, Format, Language, Particulars, render};
use calib_protocol::record::Record;
use calib_record::sample;
use std::error::Error;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

/// One-third octaves from 10 Hz to 10 kHz.
const POINTS: usize = 31;
/// Longest time for a certificate set.
const LIMIT_S: f64 = 0.5;
const RUNS: usize = 11;

fn main() -> Result<(), Box<dyn Error>> {
    let frequencies: Vec<f32> = [10.0, 12.5, 16.0]
        .into_iter()
        .chain(sample::THIRD_OCTAVES_HZ)
        .collect();
    assert_eq!(frequencies.len(), POINTS);
    let record = sample::record(&frequencies);
    let mut rows = Vec::new();
    if let Some(tool) = std::env::var_os("CALIB_TOOL") {
        let seconds = set(Path::new(&tool), &record)?;
        rows.push(("set: pdf, dcc, html, csv (program)".to_owned(), seconds));
    }
    let mut particulars = Particulars::default();
    particulars.laboratory.country = Some("DE".to_owned());
    let certificate = Certificate::from_record(&record, &particulars);
    for format in Format::ALL {
        let seconds = median(|| render(&certificate, format, Language::En).map(drop))?;
        rows.push((format!("{} alone (library)", format.name()), seconds));
    }
    for (name, seconds) in &rows {
        println!("{name:<36} {:>8.1} ms", 1000.0 * seconds);
    }
    if let Some(path) = std::env::var_os("CALIB_BENCH_JSON") {
        let fields: Vec<_> = rows
            .iter()
            .map(|(name, seconds)| serde_json::json!({ "case": name, "seconds": seconds }))
            .collect();
        std::fs::write(path, serde_json::to_string_pretty(&fields)?)?;
    }
    match rows.first() {
        Some((name, seconds)) if *seconds > LIMIT_S => {
            Err(format!("{name} takes {seconds:.2} s, more than {LIMIT_S} s").into())
        }
        _ => Ok(()),
    }
}

/// Time of the whole program, files written and synchronised.
fn set(tool: &Path, record: &Record) -> Result<f64, Box<dyn Error>> {
    let folder = tempfile::tempdir()?;
    let path = folder.path().join("record.bin");
    let mut buffer = vec![0; 64 * 1024];
    let length = calib_protocol::record::encode(record, &mut buffer).map_err(|e| e.to_string())?;
    std::fs::write(&path, &buffer[..length])?;
    let house = folder.path().join("house.toml");
    std::fs::write(&house, "[laboratory]\ncountry = 'DE'\n")?;
    let mut run = 0;
    median(|| -> Result<(), Box<dyn Error>> {
        run += 1;
        let out = folder.path().join(run.to_string());
        let mut command = Command::new(tool);
        command.arg("certificate").arg(&path).arg("--out").arg(out);
        command.args(["--format", "pdf,dcc,html,csv", "--particulars"]);
        let output = command.arg(&house).output()?;
        match output.status.success() {
            true => Ok(()),
            false => Err(String::from_utf8_lossy(&output.stderr).into_owned().into()),
        }
    })
}

fn median<E>(mut run: impl FnMut() -> Result<(), E>) -> Result<f64, E> {
    let mut seconds = Vec::with_capacity(RUNS);
    for _ in 0..RUNS {
        let start = Instant::now();
        run()?;
        seconds.push(start.elapsed().as_secs_f64());
    }
    seconds.sort_by(f64::total_cmp);
    Ok(seconds[RUNS / 2])
}
