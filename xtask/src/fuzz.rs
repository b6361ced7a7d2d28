//! `./run bench fuzz [MINUTES [TARGET ...]]`: the fuzz targets with libFuzzer.
//!
//! The pinned compiler instruments the crates of this project ([`rustc.sh`]), so
//! neither a nightly one nor cargo-fuzz is needed. What a run finds new is kept in
//! `target/fuzz/TARGET` and is where the next one begins.
//!
//! [`rustc.sh`]: ../../fuzz/rustc.sh

use crate::shell::{self, cargo, root, target_dir};
use anyhow::{Context, Result, bail};
use std::fs::File;
use std::path::Path;
use std::process::Command;

/// Time for each target when nothing else is said.
const MINUTES: f64 = 10.0;

/// Summary of a target's run, as libFuzzer prints it.
struct Figures {
    target: String,
    executions: u64,
    edges: u64,
    inputs: u64,
}

/// Fuzzes each target for so many minutes.
pub(crate) fn run(arguments: &[String]) -> Result<()> {
    let minutes = arguments.first().and_then(|text| text.parse().ok());
    let named = &arguments[usize::from(minutes.is_some())..];
    let known = targets()?;
    if let Some(other) = named.iter().find(|name| !known.contains(name)) {
        bail!("no fuzz target {other}; there are {}", known.join(", "));
    }
    let chosen = if named.is_empty() { &known } else { named };
    let seconds = (minutes.unwrap_or(MINUTES) * 60.0) as u64;
    build()?;
    println!(
        "{:<12} {:>12} {:>8} {:>8}",
        "target", "executions", "edges", "inputs"
    );
    let mut all = Vec::new();
    for target in chosen {
        let figures = fuzz(target, seconds)?;
        println!(
            "{target:<12} {:>12} {:>8} {:>8}",
            figures.executions, figures.edges, figures.inputs
        );
        all.push(figures);
    }
    write_json(&all, seconds)
}

/// Names of the files in `fuzz/fuzz_targets`.
fn targets() -> Result<Vec<String>> {
    let folder = root().join("fuzz").join("fuzz_targets");
    let files = std::fs::read_dir(&folder).context("fuzz/fuzz_targets")?;
    let stems = files.flatten().filter_map(|file| {
        let path = file.path();
        Some(path.file_stem()?.to_string_lossy().into_owned())
    });
    let mut names: Vec<String> = stems.collect();
    names.sort();
    Ok(names)
}

fn build() -> Result<()> {
    let mut build = cargo("build");
    build
        .args(["--release", "--package", "calib-fuzz"])
        .args(["--features", "libfuzzer"])
        .env("RUSTC_WORKSPACE_WRAPPER", root().join("fuzz/rustc.sh"));
    shell::run(&mut build)
}

fn fuzz(target: &str, seconds: u64) -> Result<Figures> {
    let folder = target_dir().join("fuzz").join(target);
    let corpus = folder.join("corpus");
    std::fs::create_dir_all(&corpus)?;
    let log = folder.join("log");
    let mut fuzzer = Command::new(target_dir().join("release").join(target));
    fuzzer
        .args([
            format!("-max_total_time={seconds}"),
            format!("-artifact_prefix={}/", folder.display()),
        ])
        // Longer than any frame; a second is long for the slowest, a diagnosis.
        .args(["-max_len=8192", "-timeout=20", "-print_final_stats=1"])
        .arg(&corpus)
        .arg(root().join("fuzz").join("corpus").join(target))
        .current_dir(&folder)
        .stdout(File::create(folder.join("out"))?)
        .stderr(File::create(&log)?);
    let status = fuzzer
        .status()
        .with_context(|| format!("the fuzz target {target}"))?;
    if !status.success() {
        bail!(
            "{target} has found an input that fails: {} tells which and why; mend it, and put the \
             input into fuzz/corpus/{target}",
            log.display()
        );
    }
    figures(target, &log)
}

/// The last figures in what a fuzzer has printed.
fn figures(target: &str, log: &Path) -> Result<Figures> {
    // Bytes of an input may be printed as they are.
    let log = std::fs::read(log)?;
    let text = String::from_utf8_lossy(&log);
    let after = |words: &str| -> u64 {
        let rest = text.rsplit_once(words).map_or("", |(_, rest)| rest);
        let digits: String = rest
            .trim_start()
            .chars()
            .take_while(char::is_ascii_digit)
            .collect();
        digits.parse().unwrap_or(0)
    };
    Ok(Figures {
        target: target.to_owned(),
        executions: after("stat::number_of_executed_units:"),
        edges: after(" cov:"),
        inputs: after(" corp:"),
    })
}

fn write_json(all: &[Figures], seconds: u64) -> Result<()> {
    let lines: Vec<String> = all
        .iter()
        .map(|figures| {
            let Figures {
                target,
                executions,
                edges,
                inputs,
            } = figures;
            format!(
                "{{\"target\":\"{target}\",\"executions\":{executions},\"edges\":{edges},\
                 \"inputs\":{inputs}}}"
            )
        })
        .collect();
    let json = format!(
        "{{\"seconds_each\":{seconds},\"targets\":[{}]}}",
        lines.join(",")
    );
    let folder = target_dir().join("bench");
    std::fs::create_dir_all(&folder)?;
    Ok(std::fs::write(folder.join("fuzz.json"), json)?)
}
