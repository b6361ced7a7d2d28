//! Running other programs and finding our own folders.

use anyhow::{Context, Result, bail};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The version of everything that is built.
pub(crate) const VERSION: &str = env!("CARGO_PKG_VERSION");

/// The top folder of the workspace.
pub(crate) fn root() -> PathBuf {
    let manifest = Path::new(env!("CARGO_MANIFEST_DIR"));
    manifest.parent().unwrap_or(manifest).to_path_buf()
}

/// Where cargo puts what it builds.
pub(crate) fn target_dir() -> PathBuf {
    std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root().join("target"), PathBuf::from)
}

/// Cargo for the host, in the one profile everything is built with.
pub(crate) fn cargo(subcommand: &str) -> Command {
    let program = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut command = Command::new(program);
    command.current_dir(root()).arg(subcommand);
    // Build scripts that watch the package's variables would run anew after each direct `cargo`.
    for (name, _) in std::env::vars_os() {
        let text = name.to_string_lossy();
        if text.starts_with("CARGO_PKG_") || text.starts_with("CARGO_MANIFEST_") {
            command.env_remove(&name);
        }
    }
    if std::env::var_os("CALIB_IGNORE_RUST_VERSION").is_some() {
        command.arg("--ignore-rust-version");
    }
    command
}

/// Cargo with the compiler for the board.
///
/// Where rustup has none it is Debian's, which has no library for the board: it builds core from source
/// and links with LLVM's own linker.
pub(crate) fn cargo_for_board(subcommand: &str) -> Command {
    if std::env::var("CALIB_ELF_TOOLCHAIN").as_deref() != Ok("debian") {
        return cargo(subcommand);
    }
    let mut command = Command::new("/usr/bin/cargo");
    command.current_dir(root()).arg(subcommand);
    if subcommand == "build" {
        command.args(["--ignore-rust-version", "-Zbuild-std=core"]);
    }
    command
        .env_remove("RUSTUP_TOOLCHAIN")
        .env("RUSTC", "/usr/bin/rustc")
        .env("RUSTC_BOOTSTRAP", "1")
        .env("CARGO_TARGET_THUMBV7EM_NONE_EABIHF_LINKER", "ld.lld");
    command
}

/// Runs a program to its end; a failure names the program.
pub(crate) fn run(command: &mut Command) -> Result<()> {
    let name = command.get_program().to_string_lossy().into_owned();
    let status = command
        .status()
        .with_context(|| format!("cannot start {name}"))?;
    if !status.success() {
        let arguments: Vec<_> = command.get_args().map(|a| a.to_string_lossy()).collect();
        bail!("{name} {} failed: {status}", arguments.join(" "));
    }
    Ok(())
}

/// Does two things side by side: either alone leaves a core idle now and then. Returns what `other` returns.
pub(crate) fn beside<T: Send>(
    other: impl FnOnce() -> Result<T> + Send,
    this: impl FnOnce() -> Result<()>,
) -> Result<T> {
    std::thread::scope(|scope| {
        let other = scope.spawn(other);
        this()?;
        other
            .join()
            .unwrap_or_else(|_| bail!("what runs beside it panicked"))
    })
}

/// Output of a program.
pub(crate) fn said(command: &mut Command) -> Result<String> {
    let name = command.get_program().to_string_lossy().into_owned();
    let output = command
        .output()
        .with_context(|| format!("cannot start {name}"))?;
    if !output.status.success() {
        bail!("{name} failed: {}", String::from_utf8_lossy(&output.stderr));
    }
    Ok(String::from_utf8_lossy(output.stdout.trim_ascii()).into_owned())
}

/// A `tar` that writes this file, of which nothing tells who made it.
pub(crate) fn tar_of(file: &Path) -> Command {
    let mut tar = Command::new("tar");
    tar.env("XZ_OPT", "-T0").arg("-cJf").arg(file);
    tar.args(["--owner=0", "--group=0", "--sort=name"]);
    tar
}

/// A folder with nothing in it.
pub(crate) fn empty(folder: &Path) -> Result<()> {
    if folder.exists() {
        fs::remove_dir_all(folder)?;
    }
    Ok(fs::create_dir_all(folder)?)
}
