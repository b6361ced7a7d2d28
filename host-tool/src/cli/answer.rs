//! Verbs for other programs: the words of a command line in, its JSON out.

use super::context::Failure;
use super::sink::{Said, Sink};
use super::{Arguments, Context, misuse};
use calib_host::config::{self, Config};
use calib_link::StopSwitch;
use std::ffi::OsString;

/// Carries out the verb of these words (without the name of the program; `--json` or `--json-lines` among them)
/// and tells `listener` what it says. Nothing is printed, no signal is caught: whoever asks `switch` to stop
/// ends what the verb set moving.
///
/// # Errors
/// Carries out a command line. An error has the way out and the exit code the tool would end with. With 7 the work
/// was done, and `listener` has its document.
pub fn answer(
    words: impl IntoIterator<Item = OsString>,
    switch: &StopSwitch,
    listener: impl Fn(Said<'_>) + Send + Sync + 'static,
) -> Result<(), Failure> {
    let defaults = Config::load(&config::path())?;
    let words = std::iter::once(OsString::from("calib")).chain(words);
    let arguments = match Arguments::read(words, &defaults) {
        Ok(arguments) => arguments,
        Err(said) if said.use_stderr() => return Err(misuse::failure(said)),
        Err(help) => {
            listener(Said::Output(&help.to_string()));
            return Ok(());
        }
    };
    let context = Context {
        quiet: true,
        sink: Sink::Program(Box::new(listener)),
        switch: Some(switch.clone()),
        ..arguments.context(defaults)
    };
    Ok(arguments.command.run(&context)?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::{Arc, Mutex, PoisonError};

    fn asked(words: &[&str]) -> (Result<(), Failure>, String) {
        let heard = Arc::new(Mutex::new(String::new()));
        let kept = Arc::clone(&heard);
        let words = words.iter().map(OsString::from);
        let done = answer(words, &StopSwitch::default(), move |said| {
            if let Said::Output(text) = said {
                *kept.lock().unwrap_or_else(PoisonError::into_inner) += text;
            }
        });
        let heard = heard.lock().unwrap_or_else(PoisonError::into_inner).clone();
        (done, heard)
    }

    #[test]
    fn a_program_hears_the_document_and_is_told_the_way_out() {
        let (done, heard) = asked(&[
            "--json",
            "convert",
            "--frequency",
            "160",
            "--sensitivity",
            "0.01",
        ]);
        done.expect("converts");
        let document: serde_json::Value = serde_json::from_str(&heard).expect("JSON");
        assert_eq!(document["frequency_hz"], 160.0);
        let (done, heard) = asked(&[
            "--json",
            "convert",
            "--frequency",
            "-1",
            "--sensitivity",
            "1",
        ]);
        let failure = done.expect_err("no frequency");
        assert_eq!((failure.exit_code, heard.as_str()), (2, ""));
        assert!(failure.hint.is_some_and(|hint| !hint.is_empty()));
        let (done, _) = asked(&["--json", "convrt"]);
        let failure = done.expect_err("no verb");
        assert!(failure.error.contains("convrt"), "{}", failure.error);
        let (done, heard) = asked(&["--version"]);
        done.expect("is no error");
        assert!(heard.starts_with("calib "), "{heard}");
    }
}
