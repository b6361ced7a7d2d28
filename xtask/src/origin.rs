//! Where an image is built does not show in it: folders of the builder get other names.
//!
//! Paths in panics and for debuggers begin with the names below instead. The same sources
//! built elsewhere give the same bytes, which [`check`] holds by building them there.

use crate::shell::{cargo_for_board, root, run, target_dir};
use anyhow::{Context, Result, bail};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

/// Name of the workspace: debuggers that are started there find the sources.
const WORKSPACE: &str = ".";
/// Name of the folder of built things, wherever it is.
const TARGET: &str = "./target";
/// Name of the folder of fetched sources; below it are `NAME-VERSION/src/...`.
const FETCHED: &str = "registry";

/// The folders a build reads from and writes to.
pub(crate) struct Place {
    pub(crate) workspace: PathBuf,
    pub(crate) target: PathBuf,
    /// Cargo's own folder, with the sources it fetched.
    pub(crate) cargo_home: PathBuf,
    /// Folders of sources in it, one for each registry.
    fetched: Vec<PathBuf>,
}

impl Place {
    /// That of this workspace, with every dependency fetched.
    pub(crate) fn here() -> Result<Self> {
        // Folders of sources are called after the registry or mirror they came from: they have to be there.
        run(cargo_for_board("fetch").arg("--quiet"))?;
        Self::of(root(), target_dir(), cargo_home()?)
    }

    fn of(workspace: PathBuf, target: PathBuf, cargo_home: PathBuf) -> Result<Self> {
        let sources = cargo_home.join("registry/src");
        let folders = fs::read_dir(&sources).with_context(|| sources.display().to_string())?;
        let mut fetched: Vec<PathBuf> = folders
            .map(|folder| Ok(folder?.path()))
            .collect::<Result<_>>()?;
        fetched.sort();
        Ok(Self {
            workspace,
            target,
            cargo_home,
            fetched,
        })
    }

    /// The line of cargo's configuration with which a build for `target` says none of its folders.
    pub(crate) fn flags(&self, target: &str) -> String {
        let fetched = self.fetched.iter().map(|folder| (folder, FETCHED));
        // Of several that fit the compiler takes the last: the target folder is often in the workspace.
        let renamed = fetched.chain([(&self.workspace, WORKSPACE), (&self.target, TARGET)]);
        let flags: Vec<String> = renamed
            .flat_map(|(folder, name)| paths(folder).map(move |path| rename(&path, name)))
            .collect();
        format!("target.{target}.rustflags=[{}]", flags.join(","))
    }
}

fn rename(folder: &Path, name: &str) -> String {
    format!("'--remap-path-prefix={}={name}'", folder.display())
}

/// A folder as it is called, and as the compiler finds itself in it where that goes by a link.
fn paths(folder: &Path) -> impl Iterator<Item = PathBuf> {
    let found = folder.canonicalize().ok();
    let found = found.filter(|found| found != folder);
    std::iter::once(folder.to_owned()).chain(found)
}

pub(crate) fn cargo_home() -> Result<PathBuf> {
    if let Some(home) = std::env::var_os("CARGO_HOME") {
        return Ok(PathBuf::from(home));
    }
    let home = std::env::var_os("HOME").context("neither CARGO_HOME nor HOME is set")?;
    Ok(PathBuf::from(home).join(".cargo"))
}

/// The commit the sources are of, short, `-dirty` when tracked files differ; "unknown" without git. Asked once: two
/// builds that are compared are of one.
pub(crate) fn git_hash() -> &'static str {
    static COMMIT: OnceLock<String> = OnceLock::new();
    COMMIT.get_or_init(ask_git)
}

fn ask_git() -> String {
    let mut describe = Command::new("git");
    describe.current_dir(root()).args([
        "describe",
        "--always",
        "--dirty",
        "--abbrev=12",
        "--exclude=*",
    ]);
    let said = describe
        .output()
        .ok()
        .filter(|output| output.status.success());
    said.and_then(|output| String::from_utf8(output.stdout).ok())
        .map_or_else(|| "unknown".into(), |hash| hash.trim().to_owned())
}

/// How an image is built at a place.
type Build = fn(&Place) -> Result<PathBuf>;

/// Builds `image` once more, from a copy of the sources in other folders, and compares every byte.
pub(crate) fn check(image: &Path, build: Build) -> Result<()> {
    let elsewhere = std::env::temp_dir().join(format!("calib-elsewhere-{}", std::process::id()));
    let built = build_elsewhere(&elsewhere, build);
    let second = built.inspect_err(|_| drop(fs::remove_dir_all(&elsewhere)))?;
    // Where they differ both are kept, to be looked at.
    same_bytes(image, &second)?;
    Ok(fs::remove_dir_all(&elsewhere)?)
}

fn build_elsewhere(folder: &Path, build: Build) -> Result<PathBuf> {
    eprintln!("building the image again in {} ...", folder.display());
    let workspace = folder.join("the/same/sources");
    let home = folder.join("home-of-cargo");
    copy_sources(&workspace)?;
    link_entries(&cargo_home()?, &home)?;
    build(&Place::of(workspace, folder.join("built"), home)?)
}

/// Copies the files that version control would put into a commit.
fn copy_sources(to: &Path) -> Result<()> {
    fs::create_dir_all(to)?;
    let mut list = Command::new("git");
    list.current_dir(root()).args([
        "ls-files",
        "-z",
        "--cached",
        "--others",
        "--exclude-standard",
    ]);
    let names = list.output().context("cannot start git")?.stdout;
    let names = String::from_utf8(names)?;
    for name in names.split_terminator('\0') {
        let (from, to) = (root().join(name), to.join(name));
        if let (true, Some(folder)) = (from.is_file(), to.parent()) {
            fs::create_dir_all(folder)?;
            fs::copy(from, to)?;
        }
    }
    Ok(())
}

/// A folder that has what `from` has, under another path.
fn link_entries(from: &Path, to: &Path) -> Result<()> {
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(from)? {
        run(Command::new("ln").arg("-s").arg(entry?.path()).arg(to))?;
    }
    Ok(())
}

fn same_bytes(first: &Path, second: &Path) -> Result<()> {
    let (a, b) = (fs::read(first)?, fs::read(second)?);
    let differing = a.iter().zip(&b).filter(|(a, b)| a != b).count() + a.len().abs_diff(b.len());
    if differing > 0 {
        bail!(
            "{differing} of {} bytes differ between {} and {}",
            a.len(),
            first.display(),
            second.display()
        );
    }
    println!(
        "built in two places, the image has the same {} bytes",
        a.len()
    );
    Ok(())
}
