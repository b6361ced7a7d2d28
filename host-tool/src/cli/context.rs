//! Context of every verb: output switches and the address of the device.

use super::sink::Sink;
use calib_host::clock::unix_time_s;
use calib_host::config::Config;
use calib_host::emulated::KeptBoard;
use calib_host::{Device, Error, Result};
use calib_link::{Client, LinkError, StopSwitch, port};
use calib_output::json;
use clap::Args;
use schemars::JsonSchema;
use serde::Serialize;
use std::io::{IsTerminal, Write};
use std::path::PathBuf;

/// Heading of [`GlobalOptions`] in every help.
const EVERYWHERE: &str = "Options of every verb";

/// Options every verb knows.
#[derive(Clone, Debug, Args)]
pub(crate) struct GlobalOptions {
    /// Machine-readable output: one JSON document on standard output.
    #[arg(long, global = true, help_heading = EVERYWHERE)]
    pub(crate) json: bool,
    /// Machine-readable stream: one JSON object per line, rows and points as they come.
    #[arg(long, global = true, help_heading = EVERYWHERE)]
    pub(crate) json_lines: bool,
    /// The calibrator: a serial port, `tcp:HOST:PORT`, `emulated`, or
    /// `emulated-usb`.
    #[arg(
        long,
        short,
        global = true,
        help_heading = EVERYWHERE,
        env = "CALIB_DEVICE",
        value_name = "ADDRESS"
    )]
    pub(crate) device: Option<String>,
    /// The logbook; default: that of this user.
    #[arg(long, global = true, help_heading = EVERYWHERE, env = "CALIB_LOGBOOK", value_name = "FILE")]
    pub(crate) logbook: Option<PathBuf>,
    /// No progress and no remarks; errors are still printed.
    #[arg(long, short, global = true, help_heading = EVERYWHERE)]
    pub(crate) quiet: bool,
}

/// Form of what a verb prints.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Form {
    /// Tables and sentences.
    Text,
    /// One JSON document.
    Json,
    /// One JSON object per line, as soon as it is known.
    JsonLines,
}

/// Output switches and the address of the device.
pub(crate) struct Context {
    /// `--json`, `--json-lines`.
    pub(crate) form: Form,
    /// `--quiet`.
    pub(crate) quiet: bool,
    /// `--device`, or `CALIB_DEVICE`.
    pub(crate) device: Option<String>,
    /// `--logbook`, or `CALIB_LOGBOOK`.
    pub(crate) logbook: Option<PathBuf>,
    /// Defaults of this user.
    pub(crate) defaults: Config,
    /// Colour and moving progress are welcome on standard error.
    pub(crate) color: bool,
    /// Where what it says goes.
    pub(crate) sink: Sink,
    /// Stops what moves; none where Ctrl-C does.
    pub(crate) switch: Option<StopSwitch>,
    /// Makes the whole command line, which completions and manual pages are made of.
    pub(crate) command_line: fn() -> clap::Command,
}

impl Context {
    /// From the command line and the environment (`NO_COLOR`, <https://no-color.org>).
    pub(crate) fn new(
        options: &GlobalOptions,
        defaults: Config,
        command_line: fn() -> clap::Command,
    ) -> Self {
        let no_color = std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty());
        Self {
            form: match (options.json, options.json_lines) {
                (_, true) => Form::JsonLines,
                (true, false) => Form::Json,
                (false, false) => Form::Text,
            },
            quiet: options.quiet,
            // An empty CALIB_DEVICE names none.
            device: given(&options.device).or(given(&defaults.device)),
            logbook: options.logbook.clone(),
            defaults,
            color: !no_color && std::io::stderr().is_terminal(),
            sink: Sink::Streams {
                quiet: options.quiet,
            },
            switch: None,
            command_line,
        }
    }

    /// Opens the link to the calibrator: the given one, or the only likely port.
    pub(crate) fn connect(&self) -> Result<Client> {
        match &self.device {
            Some(device) => self.connect_to(device),
            None => self.connect_to(&only_likely_port()?),
        }
    }

    /// Opens the link to the calibrator at this address.
    pub(crate) fn connect_to(&self, address: &str) -> Result<Client> {
        let Ok(address) = address.parse::<Device>();
        Ok(Client::new(address.open()?).telling(unix_time_s()))
    }

    /// The calibrator is no board that this program itself emulates: it has an exciter, and a link that can break.
    pub(crate) fn is_outside(&self) -> bool {
        let address = self.device.as_deref().unwrap_or_default();
        matches!(address.parse(), Ok(Device::At(_)))
    }

    /// The address that was given, or every likely port.
    pub(crate) fn devices(&self) -> Result<Vec<String>> {
        if let Some(device) = &self.device {
            return Ok(vec![device.clone()]);
        }
        let likely = port::list().into_iter().filter(|port| port.likely);
        let names: Vec<String> = likely.map(|port| port.name).collect();
        match names.is_empty() {
            true => Err(none_found()),
            false => Ok(names),
        }
    }

    /// Connects with a hand on the button, where this computer has one.
    pub(crate) fn connect_under_a_hand(&self) -> Result<Client> {
        let address = self.device.as_deref().unwrap_or_default();
        let kept = match address.parse() {
            Ok(Device::Emulated) => KeptBoard::power_on()?,
            Ok(Device::EmulatedUsb) => KeptBoard::power_on_with_usb()?,
            _ => {
                return Err(Error::usage(
                    "--hold-button holds that of `--device emulated` alone",
                    "hold the button on the instrument; `calib emulate` has a --hold-button \
                           of its own",
                ));
            }
        };
        kept.hold_button()?;
        Ok(Client::new(Box::new(kept)).telling(unix_time_s()))
    }

    /// Prints the result of a verb: `value` as JSON if asked to, else `text`.
    pub(crate) fn print<T: Serialize + JsonSchema>(
        &self,
        value: &T,
        text: impl FnOnce() -> String,
    ) -> Result<()> {
        let mut output = match self.form {
            Form::Text => shown(&text()),
            Form::Json => json::document(value).map_err(defect)?,
            Form::JsonLines => json::lines(value).map_err(defect)?,
        };
        if !output.ends_with('\n') && self.form == Form::Text {
            output.push('\n');
        }
        self.sink.write(&output)
    }

    /// With `--json-lines`, prints a line of a stream.
    pub(crate) fn stream<T: Serialize + JsonSchema>(&self, value: &T) -> Result<()> {
        match self.form {
            Form::JsonLines => self.sink.write(&json::line(value).map_err(defect)?),
            Form::Text | Form::Json => Ok(()),
        }
    }

    /// Prints one line of a text that comes bit by bit.
    pub(crate) fn line(&self, text: &str) -> Result<()> {
        match self.form {
            Form::Text => self.sink.write(&format!("{}\n", shown(text))),
            Form::Json | Form::JsonLines => Ok(()),
        }
    }

    /// True when a program reads the output: no progress is drawn.
    pub(crate) fn for_program(&self) -> bool {
        self.form != Form::Text
    }

    /// Prints a remark to standard error, unless `--quiet`.
    pub(crate) fn remark(&self, text: &str) {
        self.sink.remark(text);
    }

    /// Prints a failure and its way out to standard error; with `--json` as one
    /// JSON document, for programs.
    pub(crate) fn report(&self, error: &Error) {
        let mut stderr = std::io::stderr();
        if self.for_program() {
            let failure = Failure::from(error);
            let _ = write!(stderr, "{}", json::line(&failure).unwrap_or_default());
            return;
        }
        let (red, cyan, plain) = match self.color {
            true => ("\x1b[1;31m", "\x1b[1;36m", "\x1b[0m"),
            false => ("", "", ""),
        };
        let said = shown(&error.to_string());
        let _ = writeln!(stderr, "{red}error{plain}: {said}");
        if let Some(hint) = error.hint() {
            let _ = writeln!(stderr, " {cyan}hint{plain}: {hint}");
        }
    }
}

/// A failure, as programs read it from standard error.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Failure {
    /// Error.
    pub error: String,
    /// The way out, if there is one.
    pub hint: Option<String>,
    /// Exit code of the tool; `calib --help` lists them.
    pub exit_code: u8,
}

impl From<&Error> for Failure {
    fn from(error: &Error) -> Self {
        Self {
            error: error.to_string(),
            hint: error.hint().map(str::to_owned),
            exit_code: error.exit_code(),
        }
    }
}

impl From<Error> for Failure {
    fn from(error: Error) -> Self {
        Self::from(&error)
    }
}

pub(crate) fn defect(error: serde_json::Error) -> Error {
    Error::input("result", error.to_string(), "report this as a defect")
}

/// Text for a terminal: what a record, a file or a device holds must not steer it.
fn shown(text: &str) -> String {
    // Bidi controls (Unicode Annex 9) show a line in another order than it is in.
    let reorders = |c: char| matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    let steers = |c: char| (c.is_control() && !matches!(c, '\n' | '\t')) || reorders(c);
    text.replace(steers, "\u{fffd}")
}

fn given(device: &Option<String>) -> Option<String> {
    device.clone().filter(|device| !device.is_empty())
}

/// Nothing is wrong with the command line: there is no such device.
fn none_found() -> Error {
    let missing = LinkError::Open {
        address: "a calibrator".to_owned(),
        source: std::io::Error::new(std::io::ErrorKind::NotFound, "no calibrator found"),
        hint: "name its port with --device; `calib devices` lists the ports, and \
               `--device emulated` needs no hardware"
            .to_owned(),
    };
    calib_link::Error::from(missing).into()
}

fn only_likely_port() -> Result<String> {
    let mut likely = port::list().into_iter().filter(|port| port.likely);
    let usage = |problem: &str, hint: &str| Error::usage(problem, hint);
    match (likely.next(), likely.next()) {
        (Some(port), None) => Ok(port.name),
        (None, _) => Err(none_found()),
        _ => Err(usage(
            "more than one port may be the calibrator",
            "choose one with --device; `calib devices` lists them",
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_text_steers_a_terminal_or_turns_a_line_round() {
        let forged = "S 1.0\u{202e}0.9 S\u{2066}\u{1b}[2J\r ok";
        assert_eq!(
            shown(forged),
            "S 1.0\u{fffd}0.9 S\u{fffd}\u{fffd}[2J\u{fffd} ok"
        );
        assert_eq!(shown("a\tb\nc \u{5d0}"), "a\tb\nc \u{5d0}");
    }
}
