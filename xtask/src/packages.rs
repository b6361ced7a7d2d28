//! Programs of the system that tests use, from its packages.
//!
//! CI installs them; on a person's computer nothing is installed unasked.

use crate::shell;
use anyhow::{Context, Result, bail};
use std::path::PathBuf;
use std::process::Command;

/// Packages that go by another name than their program.
const PACKAGES: [(&str, &str); 1] = [("java", "default-jre-headless")];

/// The package a program is in.
fn package_of(program: &str) -> &str {
    let named = PACKAGES.iter().find(|(name, _)| *name == program);
    named.map_or(program, |(_, package)| package)
}

/// Where a program is, if it is in the path.
pub(crate) fn find(program: &str) -> Option<PathBuf> {
    let path = std::env::var_os("PATH")?;
    let candidates = std::env::split_paths(&path).map(|folder| folder.join(program));
    candidates.into_iter().find(|file| file.is_file())
}

/// A program that tests need; `None`, after saying what is not tested, where it is
/// missing on a person's computer.
pub(crate) fn for_tests(program: &str, tests: &str) -> Result<Option<PathBuf>> {
    if find(program).is_none() && std::env::var_os("CI").is_none() {
        let package = package_of(program);
        eprintln!("no {program}: tests of {tests} say so and pass (apt-get install {package})");
        return Ok(None);
    }
    installed(program).map(Some)
}

/// Finds a program that was asked for by name; installs it where it is missing.
pub(crate) fn installed(program: &str) -> Result<PathBuf> {
    if find(program).is_none() {
        install(&[package_of(program)])?;
    }
    find(program).with_context(|| format!("{program} is not there after it was installed"))
}

/// A program of the system, by the name of its Debian package; elsewhere there is no package to make.
pub(crate) fn needs(program: &str, package: &str) -> Result<()> {
    if find(program).is_some() {
        return Ok(());
    }
    if std::env::var_os("CI").is_some() {
        return install(&[package]);
    }
    bail!("{program} is missing: packages are made on Debian, with `apt-get install {package}`")
}

/// Installs Debian packages.
pub(crate) fn install(packages: &[&str]) -> Result<()> {
    eprintln!("installing {} ...", packages.join(", "));
    // An outdated list is no reason to give up: the packages may be there.
    let _ = shell::run(apt_get().args(["update", "-qq"]));
    let mut install = apt_get();
    install.args(["install", "-y", "-qq", "--no-install-recommends"]);
    shell::run(install.args(packages))
}

fn apt_get() -> Command {
    let mut command = as_root("env");
    command.args(["DEBIAN_FRONTEND=noninteractive", "apt-get"]);
    command
}

/// A program as root: at once, or by way of `sudo`.
pub(crate) fn as_root(program: &str) -> Command {
    let user = Command::new("id").arg("-u").output();
    if user.is_ok_and(|user| user.stdout.trim_ascii() == b"0") {
        return Command::new(program);
    }
    let mut sudo = Command::new("sudo");
    sudo.arg(program);
    sudo
}
