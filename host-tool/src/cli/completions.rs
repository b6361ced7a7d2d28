//! `calib completions SHELL` and `calib man`: generated from the command line itself.

use super::Context;
use calib_host::{Error, Result};
use clap::Args;
use clap_complete::Shell;
use schemars::JsonSchema;
use serde::Serialize;
use std::path::PathBuf;

/// `calib completions SHELL`.
#[derive(Debug, Args)]
#[command(after_help = "\
bash: calib completions bash > ~/.local/share/bash-completion/completions/calib
zsh:  calib completions zsh > ~/.zfunc/_calib
fish: calib completions fish > ~/.config/fish/completions/calib.fish")]
pub(crate) struct Completions {
    /// The shell.
    shell: Shell,
}

#[derive(Serialize, JsonSchema)]
pub(super) struct Script {
    shell: String,
    script: String,
}

impl Completions {
    /// Prints the script of `calib`.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let (mut calib, mut script) = ((context.command_line)(), Vec::new());
        clap_complete::generate(self.shell, &mut calib, "calib", &mut script);
        let script = Script {
            shell: self.shell.to_string(),
            script: String::from_utf8_lossy(&script).into_owned(),
        };
        context.print(&script, || script.script.clone())
    }
}

/// `calib man`.
#[derive(Debug, Args)]
pub(crate) struct Man {
    /// Directory for `calib.1` and one page per verb.
    #[arg(long, short, default_value = "man", value_name = "DIR")]
    out: PathBuf,
}

#[derive(Serialize, JsonSchema)]
pub(super) struct Pages {
    files: Vec<PathBuf>,
}

impl Man {
    /// Writes the pages of `calib`.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let failed = |error| Error::file("write", &self.out, error);
        std::fs::create_dir_all(&self.out)
            .map_err(|error| Error::file("create", &self.out, error))?;
        let command = (context.command_line)().disable_help_subcommand(true);
        clap_mangen::generate_to(command, &self.out).map_err(failed)?;
        let entries = std::fs::read_dir(&self.out).map_err(failed)?;
        let mut files: Vec<_> = entries.flatten().map(|entry| entry.path()).collect();
        files.retain(|file| file.extension().is_some_and(|extension| extension == "1"));
        files.sort();
        let pages = Pages { files };
        context.print(&pages, || {
            format!(
                "{} pages; man -l {}",
                pages.files.len(),
                self.out.join("calib.1").display()
            )
        })
    }
}
