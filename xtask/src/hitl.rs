//! Tests on a board: `hitl/README.md` says what and why.

use crate::shell::{self, cargo, target_dir};
use crate::{demo, elf, program};
use anyhow::{Context, Result, bail};
use std::io::{BufRead, BufReader, Write};
use std::process::{Command, Stdio};

const NO_PROBE: &str = "no debug probe was found. Unplug the exciter, connect CN1 of the board (ST-LINK) by USB, \
    `cargo install probe-rs-tools`, look with `probe-rs list`, then run this again; `./run hitl emulated` needs \
    no board";

/// Tests on the part, then from its host; `emulated` on the emulated board.
pub(crate) fn run(arguments: &[String]) -> Result<()> {
    match arguments.first().map(String::as_str) {
        Some("emulated") => emulated(),
        None | Some("ratio") => on_board(arguments),
        Some(other) => bail!("`{other}`: ./run hitl [ratio | emulated]"),
    }
}

fn emulated() -> Result<()> {
    elf::build_on_target_tests()?;
    demo::build_tool()?;
    let mut tests = cargo("test");
    tests.args(["--release", "--workspace", "--test", "instrument"]);
    shell::run(tests.args(["--", "on_the_target", "--nocapture"]))?;
    shell::run(&mut loopback("emulated"))
}

fn on_board(arguments: &[String]) -> Result<()> {
    let listed = Command::new("probe-rs").arg("list").output();
    let listed = listed.ok().filter(|listed| listed.status.success());
    let listed = listed.map(|listed| String::from_utf8_lossy(&listed.stdout).into_owned());
    // A line for each probe, numbered in brackets.
    if !listed.is_some_and(|listed| listed.contains("[0]")) {
        bail!(NO_PROBE);
    }
    let folder = target_dir().join("hitl");
    std::fs::create_dir_all(&folder)?;
    let path = folder.join("report.txt");
    let mut report =
        std::fs::File::create(&path).with_context(|| format!("cannot write {}", path.display()))?;
    let image = elf::build_on_target_tests()?;
    let tested = reported(&mut program::tests(&image), &mut report)?;
    program::run(None)?;
    demo::build_tool()?;
    let device = serial_port()?;
    let mut host = loopback(&device);
    let looked = reported(host.args(arguments), &mut report)?;
    println!("\nreport: {}", path.display());
    match tested && looked {
        true => Ok(()),
        false => bail!("the board did not pass: see the report"),
    }
}

fn loopback(device: &str) -> Command {
    let mut command = Command::new("bash");
    command
        .current_dir(shell::root())
        .args(["hitl/loopback.sh", device])
        .env("CALIB_TOOL", demo::tool());
    command
}

/// The only serial port a calibrator may be at.
fn serial_port() -> Result<String> {
    let found = Command::new(demo::tool())
        .args(["devices", "--json"])
        .output()?;
    let text = String::from_utf8_lossy(&found.stdout).into_owned();
    let port = text
        .split('"')
        .find(|part| part.starts_with("/dev/") || part.starts_with("COM"));
    port.map(str::to_owned)
        .context("no serial port of an ST-LINK: `calib devices`")
}

/// Runs a program, its output shown and kept; whether it succeeded.
fn reported(command: &mut Command, report: &mut std::fs::File) -> Result<bool> {
    let mut child = command.stdout(Stdio::piped()).spawn()?;
    let output = child.stdout.take().context("no output")?;
    for line in BufReader::new(output).lines() {
        let line = line?;
        println!("{line}");
        writeln!(report, "{line}")?;
    }
    Ok(child.wait()?.success())
}
