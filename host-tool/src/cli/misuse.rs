//! Messages of the command-line reader: help, the version, or what is wrong.

use super::context::Failure;
use super::sink::nobody_reads;
use calib_output::json;
use clap::error::{ContextKind, ContextValue};
use std::io::Write;
use std::process::ExitCode;

/// Exit codes as in [`calib_host::Error`].
const NOT_WRITTEN: u8 = 1;
const MISUSED: u8 = 2;

/// Prints it, for programs a complaint as one document like all others.
pub(crate) fn tell(mut said: clap::Error) -> ExitCode {
    name_the_logbook(&mut said);
    if !said.use_stderr() {
        return match said.print() {
            Err(error) if !nobody_reads(&error) => {
                let _ = writeln!(
                    std::io::stderr(),
                    "error: cannot write standard output: {error}"
                );
                ExitCode::from(NOT_WRITTEN)
            }
            _ => ExitCode::SUCCESS,
        };
    }
    let for_program = |argument| argument == "--json" || argument == "--json-lines";
    if std::env::args_os().any(for_program) {
        let line = json::line(&in_parts(&said.to_string())).unwrap_or_default();
        let _ = write!(std::io::stderr(), "{line}");
    } else {
        let _ = said.print();
    }
    ExitCode::from(MISUSED)
}

/// The logbook was the bench of records once: hands and scripts may still say so.
fn name_the_logbook(said: &mut clap::Error) {
    let asked =
        |kind, word: &str| matches!(said.get(kind), Some(ContextValue::String(it)) if it == word);
    let now = match () {
        () if asked(ContextKind::InvalidSubcommand, "bench") => "calib logbook",
        () if asked(ContextKind::InvalidArg, "--bench") => "--logbook FILE",
        () => return,
    };
    let tip = format!("the bench of records is the logbook: `{now}`").into();
    said.remove(ContextKind::SuggestedSubcommand);
    said.remove(ContextKind::SuggestedArg);
    said.insert(ContextKind::Suggested, ContextValue::StyledStrs(vec![tip]));
}

/// A complaint, for a program that asked.
pub(crate) fn failure(mut said: clap::Error) -> Failure {
    name_the_logbook(&mut said);
    in_parts(&said.to_string())
}

/// The first paragraph is what is wrong, the rest the way out.
fn in_parts(text: &str) -> Failure {
    let (problem, rest) = text.trim().split_once("\n\n").unwrap_or((text.trim(), ""));
    Failure {
        error: problem.trim_start_matches("error: ").to_owned(),
        hint: Some(rest.to_owned()),
        exit_code: MISUSED,
    }
}
