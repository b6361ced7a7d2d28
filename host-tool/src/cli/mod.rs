//! Arguments of `calib`: one struct per verb, each in its own file.
//!
//! A verb is a struct that derives `clap::Args` with
//! `run(self, context) -> Result<()>`. Data goes to standard output (tables,
//! or JSON with `--json` and `--json-lines`), everything else to standard error.

mod adjust;
mod again;
mod alarm;
mod answer;
mod budget;
mod capture;
mod certificate;
mod check;
mod completions;
mod config;
mod context;
mod convert;
mod demo;
mod devices;
mod doctor;
mod download;
mod emulate;
mod gap;
mod hand;
mod help;
mod identify;
mod info;
mod key;
mod laboratory_key;
mod linking;
mod lists;
mod logbook;
mod measure;
mod misuse;
mod nomogram;
mod number;
mod phase;
mod points;
mod predict;
mod progress;
mod records;
mod reference;
mod release;
mod remount;
mod risk;
mod run;
mod schema;
mod selfcheck;
mod selftest;
mod sensitivity;
mod serve;
mod settings;
mod show;
mod sign;
mod sink;
mod source;
mod stop;
mod substitute;
mod sync;
mod text;
mod time;
mod turnover;
mod update;
mod verify;
mod version;

pub use answer::answer;
pub use context::Failure;
pub(crate) use context::{Context, GlobalOptions};
pub use measure::ask_for_silence;
pub use sink::Said;

use calib_host::Result;
use calib_host::config::Config;
use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};
use std::ffi::OsString;
use std::process::ExitCode;

/// Exit codes, printed at the end of `calib --help`.
const EXIT_CODES: &str = "\
Exit codes:
  0  done
  1  a file could not be read or written, or the tool itself failed
  2  wrong use of the command line
  3  link: no such device, no answer, damaged answers
  4  the device speaks another protocol version, or answers nonsense
  5  the device understood and refused
  6  an input file (points, record, settings, ...) is not usable
  7  done, but a point was refused, a conformity is not \"pass\", or a check failed";

/// Carries out what was typed, says how it ended, and returns it.
pub fn main() -> ExitCode {
    // What is wrong with them is said in the form that was asked for, which the arguments tell.
    let (defaults, broken) = match Config::load(&calib_host::config::path()) {
        Ok(defaults) => (defaults, None),
        Err(error) => (Config::default(), Some(error)),
    };
    let arguments = match Arguments::read(std::env::args_os(), &defaults) {
        Ok(arguments) => arguments,
        Err(said) => return misuse::tell(said),
    };
    let context = Context::new(&arguments.global, defaults);
    let done = broken.map_or_else(|| arguments.command.run(&context), Err);
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            context.report(&error);
            ExitCode::from(error.exit_code())
        }
    }
}

/// Calibrates vibration transducers with the open field calibrator.
#[derive(Debug, Parser)]
#[command(name = "calib", version, about, after_help = EXIT_CODES, max_term_width = 100)]
pub(crate) struct Arguments {
    /// Options every verb knows.
    #[command(flatten)]
    pub(crate) global: GlobalOptions,
    /// Verb.
    #[command(subcommand)]
    pub(crate) command: Command,
}

impl Arguments {
    /// Reads the command line.
    ///
    /// # Errors
    /// Text to print instead: help, the version, or what is wrong.
    pub(crate) fn read(
        words: impl IntoIterator<Item = OsString>,
        defaults: &Config,
    ) -> Result<Self, clap::Error> {
        let calib = number::signed(help::described(Self::command()));
        let mut calib = config::with_defaults(calib, defaults);
        let matches = calib.try_get_matches_from_mut(words)?;
        Self::from_arg_matches(&matches).map_err(|error| error.format(&mut calib))
    }
}

/// The verbs.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Runs a whole calibration on an emulated calibrator.
    Demo(demo::Demo),
    /// Lists serial ports, the likely calibrators first.
    Devices(devices::Devices),
    /// Shows identity and health of the calibrator.
    Info(info::Info),
    /// Tests the board, with the table at rest: each line with its limits.
    Selftest(selftest::SelfTest),
    /// Shows or makes the key with which the calibrator signs its records.
    Key(key::Key),
    /// Shows or changes the lists the calibrator keeps for a tap of its button.
    Lists(lists::Lists),
    /// Installs other firmware: sends it to the calibrator, tries it, confirms it.
    Update(update::Update),
    /// Measures a point list.
    Run(run::Run),
    /// Prints or replaces the calibrator's settings.
    Settings(settings::Settings),
    /// Reads the certificate of the reference, shows it beside the one in force, and stores it.
    Reference(reference::Reference),
    /// Measures by how much the channels differ, and corrects for it.
    Adjust(adjust::Adjust),
    /// Checks the reference on site by reciprocity: a mass and two voltages.
    Selfcheck(selfcheck::SelfcheckVerb),
    /// Checks a reference that responds to d.c. by turning it over in gravity.
    Turnover(turnover::Turnover),
    /// Captures waveforms of both channels: d.c., harmonics, noise, spectrum.
    Capture(capture::CaptureVerb),
    /// Stops a run and silences the exciter.
    Stop(stop::Stop),
    /// Lists the records stored in the calibrator.
    Records(records::Records),
    /// Lets downloaded records make room for new ones.
    Release(release::Release),
    /// Downloads a stored record into a file.
    Download(download::Download),
    /// Fetches records the logbook lacks from every connected calibrator.
    Sync(sync::Sync),
    /// Draws a record in the terminal: S over f with U.
    Show(show::Show),
    /// Says what the signature of a record or a certificate proves.
    Verify(verify::Verify),
    /// Signs certificates with the laboratory's key.
    Sign(sign::Sign),
    /// Writes the certificate of a record.
    Certificate(certificate::CertificateVerb),
    /// Runs an emulated calibrator that other programs use like hardware.
    Emulate(emulate::Emulate),
    /// Evaluates an uncertainty budget (ISO 16063-21 Annex A, GUM).
    Budget(budget::BudgetVerb),
    /// Diagnoses the gap between simulation and measurement.
    Gap(gap::Gap),
    /// Identifies the model of an accelerometer (ISO 16063-43).
    Identify(identify::Identify),
    /// Converts a sensitivity to acceleration, velocity or displacement (clause 6).
    Convert(convert::Convert),
    /// Computes risks of decision rules over many sensors (JCGM 106:2012, clause 9).
    Risk(risk::Risk),
    /// Computes sensitivity from readings: comparison, consecutive, calibrator (clause 6).
    Sensitivity(sensitivity::Sensitivity),
    /// Converts between acceleration, velocity and displacement (Annex C).
    Nomogram(nomogram::Nomogram),
    /// Computes phase by comparison, with the uncertainty of ISO 5347-9.
    Phase(phase::Phase),
    /// Writes lists of points by ISO 16063-21 clause 5.
    Points(points::Points),
    /// Judges a record by Tables 1 to 6 and clause 7 of ISO 16063-21.
    Check(check::Check),
    /// Predicts the output for a record, or the input behind it.
    Predict(predict::Predict),
    /// Links comparisons, judges degrees of equivalence.
    Link(linking::Linking),
    /// Lists, adds and changes sensors of the logbook.
    Sensors(logbook::Sensors),
    /// Shows the drift of a sensor over the years, with U.
    History(logbook::History),
    /// Judges a check standard by its own results, before a job.
    Assure(logbook::Assure),
    /// Keeps records, certificates, instruments and operators, and checks them.
    Logbook(logbook::LogbookVerb),
    /// Exports the logbook for other programs.
    Export(logbook::Export),
    /// Serves a local web page to start, watch and stop calibrations.
    Serve(serve::Serve),
    /// Finds what keeps this computer from talking to a calibrator.
    Doctor(doctor::Doctor),
    /// Shows or sets this user's defaults: device, level, operator ...
    Config(config::ConfigVerb),
    /// Prints the completion script of a shell.
    Completions(completions::Completions),
    /// Writes the man pages.
    Man(completions::Man),
    /// Prints versions of the tool, the protocol and the stored records.
    Version(version::Version),
    /// Writes the JSON Schemas of all outputs.
    #[command(hide = true)]
    Schema(schema::SchemaVerb),
}

impl Command {
    /// Carries the verb out.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        match self {
            Self::Demo(verb) => verb.run(context),
            Self::Devices(verb) => verb.run(context),
            Self::Info(verb) => verb.run(context),
            Self::Selftest(verb) => verb.run(context),
            Self::Key(verb) => verb.run(context),
            Self::Lists(verb) => verb.run(context),
            Self::Update(verb) => verb.run(context),
            Self::Run(verb) => verb.run(context),
            Self::Settings(verb) => verb.run(context),
            Self::Reference(verb) => verb.run(context),
            Self::Adjust(verb) => verb.run(context),
            Self::Selfcheck(verb) => verb.run(context),
            Self::Turnover(verb) => verb.run(context),
            Self::Capture(verb) => verb.run(context),
            Self::Stop(verb) => verb.run(context),
            Self::Records(verb) => verb.run(context),
            Self::Release(verb) => verb.run(context),
            Self::Download(verb) => verb.run(context),
            Self::Sync(verb) => verb.run(context),
            Self::Config(verb) => verb.run(context),
            Self::Show(verb) => verb.run(context),
            Self::Certificate(verb) => verb.run(context),
            Self::Emulate(verb) => verb.run(context),
            Self::Budget(verb) => verb.run(context),
            Self::Gap(verb) => verb.run(context),
            Self::Identify(verb) => verb.run(context),
            Self::Convert(verb) => verb.run(context),
            Self::Risk(verb) => verb.run(context),
            Self::Sensitivity(verb) => verb.run(context),
            Self::Nomogram(verb) => verb.run(context),
            Self::Phase(verb) => verb.run(context),
            Self::Points(verb) => verb.run(context),
            Self::Check(verb) => verb.run(context),
            Self::Predict(verb) => verb.run(context),
            Self::Link(verb) => verb.run(context),
            Self::Sensors(verb) => verb.run(context),
            Self::History(verb) => verb.run(context),
            Self::Assure(verb) => verb.run(context),
            Self::Logbook(verb) => verb.run(context),
            Self::Export(verb) => verb.run(context),
            Self::Serve(verb) => verb.run(context),
            Self::Doctor(verb) => verb.run(context),
            Self::Completions(verb) => verb.run(context, help::described(Arguments::command())),
            Self::Man(verb) => verb.run(context, help::described(Arguments::command())),
            Self::Verify(verb) => verb.run(context),
            Self::Sign(verb) => verb.run(context),
            Self::Version(verb) => verb.run(context),
            Self::Schema(verb) => verb.run(context),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_command_line_is_consistent() {
        Arguments::command().debug_assert();
    }
}
