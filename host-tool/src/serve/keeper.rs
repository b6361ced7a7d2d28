//! The thread that enters records into the logbook: another program may hold it for as long as it likes.

use super::view::Shared;
use crate::{Error, Result};
use calib_logbook::Logbook;
use calib_logbook::waiting::{self, Stated};
use std::path::PathBuf;
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::time::{Duration, Instant};

/// Time between two tries at a logbook that somebody else holds.
const AGAIN: Duration = Duration::from_secs(1);
/// A logbook that is free has the record by then, and the end of the run is told with its number.
const USUALLY: Duration = Duration::from_secs(2);
/// One look at whether it has.
const LOOK: Duration = Duration::from_millis(10);

/// A record that waits, and who wants to know when it is entered.
struct Waiting {
    path: PathBuf,
    run: u32,
    /// Key of the instrument, if it has one.
    key: Option<Stated>,
    entered: Sender<()>,
}

/// The thread, from outside.
pub(super) struct Keeper {
    logbook: PathBuf,
    shared: Shared,
    orders: Sender<Waiting>,
}

/// The wait for a record to be entered.
pub(super) struct Wait {
    begun: Instant,
    entered: Receiver<()>,
}

impl Wait {
    /// Looks for a moment; true once it is entered, or that takes unusually long.
    pub(super) fn is_over(&self) -> bool {
        let heard = self.entered.recv_timeout(LOOK);
        !matches!(heard, Err(RecvTimeoutError::Timeout)) || self.begun.elapsed() > USUALLY
    }
}

impl Keeper {
    pub(super) fn start(logbook: PathBuf, shared: Shared) -> Self {
        let (orders, incoming) = channel();
        let keeping = Keeping {
            logbook: logbook.clone(),
            shared: shared.clone(),
            latest: None,
            told: None,
        };
        std::thread::spawn(move || keeping.work(&incoming));
        Self {
            logbook,
            shared,
            orders,
        }
    }

    /// Puts a record where it waits for the logbook, on disk: it gets there, be it after a restart.
    pub(super) fn keep(&self, bytes: &[u8], key: Option<Stated>) -> Result<Wait> {
        let run = self.shared.snapshot().run.map_or(0, |run| run.number);
        let path = waiting::put(&self.logbook, bytes)?;
        let (entered, heard) = channel();
        let _ = self.orders.send(Waiting {
            path,
            run,
            key,
            entered,
        });
        Ok(Wait {
            begun: Instant::now(),
            entered: heard,
        })
    }
}

struct Keeping {
    logbook: PathBuf,
    shared: Shared,
    latest: Option<Waiting>,
    /// Remark made about a logbook that cannot be written.
    told: Option<String>,
}

impl Keeping {
    fn work(mut self, orders: &Receiver<Waiting>) {
        loop {
            // What an earlier run of this program left is entered first of all.
            let is_done = self.enter();
            let next = match is_done {
                true => orders.recv().map_err(|_| RecvTimeoutError::Disconnected),
                false => orders.recv_timeout(AGAIN),
            };
            match next {
                Ok(waiting) => self.latest = Some(waiting),
                Err(RecvTimeoutError::Timeout) => {}
                Err(RecvTimeoutError::Disconnected) => return,
            }
        }
    }

    /// Enters what waits; false when that has to be tried again.
    fn enter(&mut self) -> bool {
        let key = self.latest.as_ref().and_then(|latest| latest.key.clone());
        match Logbook::enter_waiting(&self.logbook, key.as_slice()) {
            Ok(entered) => {
                self.take_back();
                // It stays until the next trouble: somebody is to look at what was put aside.
                if let Some(objection) = entered.objection() {
                    let text = objection.to_string();
                    self.shared.change(|snapshot| snapshot.trouble = Some(text));
                }
                let Some(latest) = self.latest.take() else {
                    return true;
                };
                let number = entered
                    .numbers
                    .iter()
                    .find(|(path, _)| *path == latest.path);
                if let Some((_, id)) = number {
                    self.shared.note_logbook_record(latest.run, *id);
                }
                let _ = latest.entered.send(());
                true
            }
            Err(error) => {
                self.tell(&error.into());
                false
            }
        }
    }

    fn tell(&mut self, error: &Error) {
        let folder = waiting::folder(&self.logbook);
        let text = format!(
            "{error}: the record waits in {} until then",
            folder.display()
        );
        if self.told.as_ref() != Some(&text) {
            self.shared
                .change(|snapshot| snapshot.trouble = Some(text.clone()));
            self.told = Some(text);
        }
    }

    fn take_back(&mut self) {
        let Some(told) = self.told.take() else { return };
        self.shared.change(|snapshot| {
            if snapshot.trouble.as_ref() == Some(&told) {
                snapshot.trouble = None;
            }
        });
    }
}
