//! `calib config`: what need not be said each time.

use super::Context;
use calib_host::config::Config;
use calib_host::{Result, config};
use clap::{Arg, Args, Command};
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;
use std::path::PathBuf;

/// `calib config`.
#[derive(Debug, Args)]
#[command(after_help = "\
device     as --device takes it
level      m/s2 r.m.s. of points that state none, for run and adjust
tolerance  of sensors that are added, as --tolerance takes it
operator   as --operator takes it
language   en or de, of certificates
key        the laboratory's key, a PKCS#12 file: it signs what is given out

The command line, the environment (CALIB_DEVICE, CALIB_OPERATOR, CALIB_LABORATORY_KEY) and a file of the job
come before these defaults. CALIB_CONFIG names another file.")]
pub(crate) struct ConfigVerb {
    /// Default to set; without it all are shown.
    #[arg(requires = "value")]
    key: Option<String>,
    /// Its value.
    #[arg(allow_hyphen_values = true)]
    value: Option<String>,
    /// Removes this default.
    #[arg(long, value_name = "KEY", conflicts_with = "key")]
    unset: Option<String>,
}

/// Defaults that are set.
#[derive(Serialize, JsonSchema)]
pub(super) struct ConfigView {
    /// The file, there or not.
    file: PathBuf,
    /// Everything that is set, as text.
    set: BTreeMap<String, String>,
}

impl ConfigVerb {
    /// Sets what is to be set, and shows what is.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let file = config::path();
        if let Some(key) = &self.unset {
            config::set(&file, key, None)?;
        } else if let Some(key) = &self.key {
            config::set(&file, key, self.value.as_deref())?;
        }
        let set = config::shown(&file)?;
        let view = ConfigView { file, set };
        context.print(&view, || view.text())
    }
}

/// The command line with these values in place of its own defaults, so that help shows them.
pub(super) fn with_defaults(calib: Command, defaults: &Config) -> Command {
    let level = defaults.level_rms_ms2.map(|level| level.to_string());
    let stated = [("operator", defaults.operator.clone()), ("level", level)];
    let replace = |verb: Command| {
        stated.iter().fold(verb, |verb, (name, value)| {
            let its_own = |arg: &Arg| arg.get_id() == name && !arg.get_default_values().is_empty();
            let is_there = verb.get_arguments().any(its_own);
            match value.clone().filter(|_| is_there) {
                // Kept for as long as the program runs, as its own defaults are.
                Some(value) => verb.mut_arg(name, |arg| arg.default_value(&*value.leak())),
                None => verb,
            }
        })
    };
    calib.mut_subcommands(replace)
}

impl ConfigView {
    fn text(&self) -> String {
        let mut text = format!("{}\n", self.file.display());
        if self.set.is_empty() {
            text.push_str("nothing is set: `calib config --help` says what may be\n");
        }
        for (key, value) in &self.set {
            text.push_str(&format!("{key:<10} {value}\n"));
        }
        text
    }
}
