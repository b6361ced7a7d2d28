//! Every test there is, in the order that fails soonest.

use crate::shell::{self, cargo, target_dir};
use crate::{browser, demo, deny, elf, no_panic, packages, python, update, wheel};
use anyhow::{Context, Result, anyhow, bail, ensure};
use serde_json::Value;
use std::cmp::Reverse;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Mutex;

/// Programs that are not ours and judge what we make: the variable that names one to the tests, its name, and what
/// it judges.
const JUDGES: [(&str, &str, &str); 4] = [
    ("CALIB_TSHARK", "tshark", "the USB capture"),
    ("CALIB_NGSPICE", "ngspice", "the front end"),
    ("CALIB_XMLSEC1", "xmlsec1", "the DCC's signature"),
    ("CALIB_STRACE", "strace", "kills in every write"),
];

/// Format, lints, images, tool, tests. With a filter: only tests of that name.
pub(crate) fn run(filter: &[String]) -> Result<()> {
    if filter.is_empty() {
        shell::run(cargo_plain("fmt").args(["--all", "--check"]))?;
        no_test_is_skipped()?;
    }
    let images = shell::beside(images, || shell::run(&mut rust_tests()))?;
    if filter.is_empty() {
        images.iter().try_for_each(|image| no_panic::check(image))?;
    }
    let image = images.last().context("no board")?;
    let interpreter = python::interpreter()?;
    if filter.is_empty() {
        deny::check(interpreter.as_deref())?;
    }
    let mut programs = Vec::new();
    // By name, a test of Rust is meant: the package is tested as a whole, or by `./run test python`.
    if let Some(interpreter) = &interpreter
        && (filter.is_empty() || filter == ["python"])
    {
        programs.push(wheel::tests(interpreter, image)?);
    }
    let surroundings = surroundings(image, interpreter)?;
    for mut program in test_programs()? {
        program.args(filter).envs(surroundings.iter().cloned());
        programs.push(program);
    }
    run_together(programs)?;
    if filter.is_empty() {
        shell::run(cargo("test").args(["--release", "--workspace", "--doc", "--quiet"]))?;
        lint()?;
    }
    eprintln!(
        "all tests passed; the host tool is {}",
        demo::tool().display()
    );
    Ok(())
}

/// Variables that name the image, the tool, and programs of others where they are installed.
fn surroundings(
    image: &Path,
    interpreter: Option<PathBuf>,
) -> Result<Vec<(&'static str, PathBuf)>> {
    let mut all = vec![
        ("CALIB_FIRMWARE_ELF", image.to_owned()),
        ("CALIB_TOOL", demo::tool()),
    ];
    all.extend(interpreter.map(|path| ("CALIB_PYTHON", path)));
    for (variable, program, about) in JUDGES {
        let judge = packages::for_tests(program, about)?;
        all.extend(judge.map(|path| (variable, path)));
    }
    let driver = browser::driver()?;
    all.extend(driver.map(|path| ("CALIB_CHROMEDRIVER", path)));
    Ok(all)
}

/// Programs that run at a time, each with a test per core: one waits for a calibrator whose time passes as on a clock,
/// for a browser or for a disk while the others compute.
const AT_A_TIME: usize = 3;

/// Runs all to their ends.
fn run_together(programs: Vec<Command>) -> Result<()> {
    let queue = Mutex::new(programs.into_iter());
    let next = || queue.lock().ok()?.next();
    let lane = || -> Vec<anyhow::Error> {
        let each = std::iter::from_fn(next);
        each.filter_map(|mut program| shell::run(&mut program).err())
            .collect()
    };
    let panicked = |_| vec![anyhow!("what runs programs panicked")];
    let failed: Vec<anyhow::Error> = std::thread::scope(|scope| {
        let lanes = [(); AT_A_TIME].map(|()| scope.spawn(lane));
        let ended = lanes.into_iter().map(|lane| lane.join());
        ended
            .flat_map(|lane| lane.unwrap_or_else(panicked))
            .collect()
    });
    for error in &failed {
        eprintln!("{error:#}");
    }
    ensure!(failed.is_empty(), "{} test programs failed", failed.len());
    Ok(())
}

/// Builds the images of all boards, the loader and an update, and returns the paths of the images.
fn images() -> Result<Vec<PathBuf>> {
    let images = elf::build_all()?;
    update::build_loader()?;
    update::build(None)?;
    Ok(images)
}

/// Builds the tests in Rust. Those of the tool need it, so cargo builds and places it with them; the programs
/// of the benches are left to the lints: each would be linked here and never run.
fn rust_tests() -> Command {
    let mut tests = cargo("test");
    tests.args(["--release", "--workspace", "--no-run"]);
    tests.args(["--lib", "--bins", "--tests"]);
    tests
}

/// Their programs, each in the folder of its package, as cargo runs them.
fn test_programs() -> Result<Vec<Command>> {
    let mut programs = Vec::new();
    for line in shell::said(rust_tests().arg("--message-format=json"))?.lines() {
        let built: Value = serde_json::from_str(line)?;
        let [program, manifest] = ["executable", "manifest_path"].map(|key| built[key].as_str());
        if let (Some(program), Some(manifest)) = (program, manifest)
            && built["profile"]["test"] == true
        {
            let mut command = Command::new(program);
            command.current_dir(Path::new(manifest).parent().context("no folder")?);
            programs.push(command);
        }
    }
    ensure!(!programs.is_empty(), "cargo built no tests");
    // Those that hold everything take the longest; the short ones fill what is left at the end.
    programs.sort_by_cached_key(|program| {
        let size = fs::metadata(program.get_program()).map_or(0, |file| file.len());
        Reverse(size)
    });
    Ok(programs)
}

/// Lints with warnings denied. After the tests: clippy shares no build with
/// them, and a failing test is the more urgent news.
fn lint() -> Result<()> {
    let mut clippy = cargo("clippy");
    clippy.args([
        "--release",
        "--workspace",
        "--all-targets",
        "--",
        "-D",
        "warnings",
    ]);
    shell::run(&mut clippy)
}

/// `cargo fmt` knows no `--ignore-rust-version`.
fn cargo_plain(subcommand: &str) -> Command {
    let mut command = Command::new("cargo");
    command.current_dir(shell::root()).arg(subcommand);
    command
}

/// A skipped test is a behaviour nobody watches.
fn no_test_is_skipped() -> Result<()> {
    let needle = concat!("#[", "ignore");
    let mut folders = vec![shell::root()];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(&folder)?.flatten() {
            let path = entry.path();
            let name = entry.file_name();
            if path.is_dir() && name != "target" && name != ".git" && path != target_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|e| e == "rs")
                && std::fs::read_to_string(&path)?.contains(needle)
            {
                bail!("{} skips a test: fix it or take it out", path.display());
            }
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_programs_run_and_each_that_fails_is_counted() {
        let folder = tempfile::tempdir().expect("a folder");
        let shell = |script: &str| {
            let mut command = Command::new("sh");
            command.args(["-c", script]).current_dir(folder.path());
            command
        };
        let all = ["exit 3", "touch first", "exit 1", "touch second"].map(shell);
        let failed = run_together(all.into()).expect_err("two fail");
        assert_eq!(failed.to_string(), "2 test programs failed");
        assert!(["first", "second"].map(|name| folder.path().join(name).exists()) == [true; 2]);
        run_together(vec![shell("true")]).expect("none fails");
    }
}
