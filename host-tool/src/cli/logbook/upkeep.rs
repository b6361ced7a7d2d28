//! `calib logbook check`, `sign`, `backup`, `merge`: that nothing in it is lost or forged.

use crate::cli::laboratory_key::{self, Password};
use crate::cli::{Context, time};
use calib_host::{Error, Result};
use calib_logbook::{Logbook, Seal};
use calib_signing::Certificate;
use clap::Args;
use jiff::Timestamp;
use schemars::JsonSchema;
use serde::Serialize;
use std::path::{Path, PathBuf};

/// Something that is not as it was entered.
#[derive(Serialize, JsonSchema)]
pub(in crate::cli) struct Problem {
    /// Kind, in words.
    problem: String,
}

/// A copy that was made.
#[derive(Serialize, JsonSchema)]
pub(in crate::cli) struct Backup {
    file: PathBuf,
}

/// The laboratory's key, for the journal.
#[derive(Debug, Args)]
pub(super) struct Signing {
    /// The laboratory's key with its certificate: a PKCS#12 file [default: that of `calib config key`].
    #[arg(long, env = "CALIB_LABORATORY_KEY", value_name = "FILE")]
    key: Option<PathBuf>,
    /// Reason why the key is another than before, such as `the old one was lost`; it is signed with the rest.
    #[arg(long, value_name = "TEXT", default_value = "")]
    new_key: String,
    #[command(flatten)]
    password: Password,
}

impl Signing {
    pub(super) fn run(self, context: &Context, logbook: &Logbook) -> Result<()> {
        let now = Timestamp::now();
        let key = laboratory_key::required(self.key.as_deref(), context)?;
        let key = self.password.open(&key, now)?;
        let seal = logbook.seal(&key, now, &self.new_key)?;
        context.print(&seal, || line(&seal))
    }
}

fn line(seal: &Seal) -> String {
    let when = time::date_and_minute(u64::try_from(seal.signed_s).unwrap_or(0));
    let why = match seal.statement.as_str() {
        "" => String::new(),
        statement => format!(" (another key: {statement})"),
    };
    format!(
        "signature {}: the journal up to entry {}, by {}, {when}{why}",
        seal.seal, seal.journal_entry, seal.signed_by
    )
}

/// Every sum and number once more, and every signature.
pub(super) fn check(context: &Context, logbook: &Logbook, certificates: &[PathBuf]) -> Result<()> {
    let known = certificates.iter().map(|path| Certificate::read(path));
    let known: calib_files::Result<Vec<_>> = known.collect();
    let known = known?.concat();
    let mut wrong = logbook.inspect()?;
    wrong.extend(logbook.inspect_seals(&known)?);
    let problem = |problem: String| Problem { problem };
    let problems: Vec<_> = wrong.iter().cloned().map(problem).collect();
    context.print(&problems, || match wrong.is_empty() {
        true => "every record and number is as it was entered".to_owned(),
        false => wrong.join("\n"),
    })?;
    say_what_is_signed(context, logbook, known.is_empty())?;
    let count = wrong.len();
    Error::not_passed((count > 0).then(|| format!("{count} entries are damaged")))
}

fn say_what_is_signed(context: &Context, logbook: &Logbook, unknown: bool) -> Result<()> {
    let seals = logbook.seals()?;
    for seal in seals.iter().filter(|seal| !seal.statement.is_empty()) {
        context.remark(&line(seal));
    }
    let (all, signed) = logbook.signed_entries()?;
    let Some(last) = seals.last() else {
        context.remark(&format!(
            "{all} entries, none signed: who knows this program can have written them; `calib logbook sign`"
        ));
        return Ok(());
    };
    context.remark(&format!("{}; {} entries since", line(last), all - signed));
    if unknown {
        context.remark(&format!(
            "whose key that is, --certificate proves; SHA-256 of its certificate: {}",
            last.signer_certificate_sha256
        ));
    }
    Ok(())
}

pub(super) fn backup(context: &Context, logbook: &Logbook, file: &Path) -> Result<()> {
    let wrong = logbook.backup(file)?;
    let backup = Backup {
        file: file.to_owned(),
    };
    context.print(&backup, || backup.file.display().to_string())?;
    match &wrong[..] {
        [] => Ok(()),
        [first, ..] => Err(Error::NotPassed(format!(
            "the copy was made, and is damaged as the logbook is, in {} entries: {first}",
            wrong.len()
        ))),
    }
}

pub(super) fn merge(context: &Context, mut logbook: Logbook, file: &Path) -> Result<()> {
    let merged = logbook.merge(&Logbook::open_existing(file)?)?;
    context.print(&merged, || {
        let mut lines = vec![format!(
            "{} records, {} sensors and check standards, {} certificates taken over; {} were known",
            merged.records, merged.sensors, merged.certificates, merged.known
        )];
        lines.extend(merged.conflicts.iter().cloned());
        lines.join("\n")
    })?;
    match merged.conflicts.len() {
        0 => Ok(()),
        count => Err(Error::NotPassed(format!(
            "{count} entries of {} are other ones here: they stay there alone, keep that file",
            file.display()
        ))),
    }
}
