//! A verb on a thread of its own, so that Python goes on meanwhile.

use calib_host::cli::{Failure, Said, answer};
use calib_link::StopSwitch;
use std::any::Any;
use std::ffi::OsString;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::thread::{Builder, JoinHandle};
use std::time::Duration;

/// Stack of a verb: what the main thread of the tool has.
const STACK_BYTES: usize = 8 << 20;
/// Exit code of what is a mistake of ours.
const DEFECT: u8 = 1;

/// Message of a verb.
#[derive(Debug)]
pub(crate) enum Heard {
    /// Its document, or a line of its stream.
    Output(String),
    /// A remark beside it.
    #[cfg_attr(test, expect(dead_code, reason = "the module reads it"))]
    Remark(String),
}

/// A verb that is being carried out.
pub(crate) struct Work {
    said: Receiver<Heard>,
    thread: JoinHandle<Result<(), Failure>>,
}

impl Work {
    /// Begins the verb of these words.
    pub(crate) fn begin(words: Vec<OsString>, switch: &StopSwitch) -> Result<Self, Failure> {
        let (tell, said) = channel();
        let inside = switch.clone();
        let listener = move |said: Said<'_>| {
            let heard = match said {
                Said::Output(text) => Heard::Output(text.to_owned()),
                Said::Remark(text) => Heard::Remark(text.to_owned()),
            };
            // Nobody listens to the rest of an interrupted verb.
            let _ = tell.send(heard);
        };
        let thread = Builder::new().name("calib".into()).stack_size(STACK_BYTES);
        let work = move || whole(|| answer(words, &inside, listener));
        let thread = thread.spawn(work).map_err(|error| Failure {
            error: format!("no thread for the work: {error}"),
            hint: Some("close other programs, and try again".into()),
            exit_code: DEFECT,
        })?;
        Ok(Self { said, thread })
    }

    /// Its next message, waited for so long; `None` once it has said everything.
    pub(crate) fn next(&mut self, wait: Duration) -> Result<Option<Heard>, Nothing> {
        match self.said.recv_timeout(wait) {
            Ok(heard) => Ok(Some(heard)),
            Err(RecvTimeoutError::Timeout) => Err(Nothing),
            Err(RecvTimeoutError::Disconnected) => Ok(None),
        }
    }

    /// How it ended.
    pub(crate) fn end(self) -> Result<(), Failure> {
        let joined = self.thread.join();
        joined.unwrap_or_else(|panic| Err(defect(panic.as_ref())))
    }
}

/// Nothing was said in time.
#[derive(Debug)]
pub(crate) struct Nothing;

/// Answer of a verb; its panic is a failure.
fn whole(verb: impl FnOnce() -> Result<(), Failure>) -> Result<(), Failure> {
    catch_unwind(AssertUnwindSafe(verb)).unwrap_or_else(|panic| Err(defect(panic.as_ref())))
}

fn defect(panic: &(dyn Any + Send)) -> Failure {
    let text = panic.downcast_ref::<&str>().copied();
    let text = text.or_else(|| panic.downcast_ref::<String>().map(String::as_str));
    Failure {
        error: format!("a defect of calib: {}", text.unwrap_or("it panicked")),
        hint: Some("report it with what you called; nothing stored was lost".into()),
        exit_code: DEFECT,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn said(mut work: Work) -> (Vec<Heard>, Result<(), Failure>) {
        let mut all = Vec::new();
        loop {
            match work.next(Duration::from_secs(60)) {
                Ok(Some(heard)) => all.push(heard),
                Ok(None) => return (all, work.end()),
                Err(Nothing) => panic!("a minute and no word"),
            }
        }
    }

    #[test]
    fn a_verb_says_its_document_and_ends() {
        let words = ["--json", "risk", "--ratio", "4"].map(OsString::from);
        let work = Work::begin(words.to_vec(), &StopSwitch::default()).expect("a thread");
        let (heard, ended) = said(work);
        ended.expect("computes");
        assert!(matches!(&heard[..], [Heard::Output(text)] if text.starts_with('[')));
    }

    #[test]
    fn a_panic_is_a_failure_that_says_what_to_do() {
        let failure = whole(|| panic!("index {} of {}", 3, 2)).expect_err("panics");
        assert_eq!(failure.error, "a defect of calib: index 3 of 2");
        assert!(failure.hint.is_some());
    }
}
