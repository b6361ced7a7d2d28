//! The thread the emulated core runs on, and how its owner talks to it.
//!
//! The emulator owns its thread from power-on to power-off and calls back whenever virtual time has
//! reached the instant it was asked for. There it waits for the next command: look at or change
//! something, run on, or switch off.

use std::sync::mpsc::{Receiver, Sender, channel};
use std::thread::JoinHandle;

use rigless::emulator::{self, Driver, Hit, HitKind, Host, Resume, Settled, Start, Stop};
use rigless::image::Image;
use rigless::session::Session;
use rigless::soc::Width;
use rigless::time::VirtualNanos;

use super::log::{self, Log};
use super::{Error, Execution, Firmware, memory, torn};
use crate::board::{CalibratorBoard, FlashWatch, Pins, SerialLine, WORD_BYTES, WriteBuffer};

/// Symbol of the firmware's RTT control block.
const LOG_CONTROL: &str = "_SEGGER_RTT";
/// How often, in virtual time, the log is drained and a wait for serial bytes looks.
const STEP_NS: u64 = 1_000_000;

/// Something to do with the board between two instructions.
type Act = Box<dyn FnOnce(&mut Session<CalibratorBoard>, &mut dyn Host, Stop) + Send>;

enum Command {
    Act(Act),
    Run { until: VirtualNanos, wake: bool },
    PowerOff,
}

/// State of the callbacks.
struct Callbacks {
    execution: Execution,
    commands: Receiver<Command>,
    reached: Sender<Stop>,
    goal: VirtualNanos,
    wake: bool,
    serial: SerialLine,
    flash: FlashWatch,
    write_buffer: WriteBuffer,
    log_control: Option<u64>,
    log: Sender<Log>,
    hits: Sender<Hit>,
}

/// A running core and the lines to it.
pub(super) struct CoreThread {
    commands: Sender<Command>,
    reached: Receiver<Stop>,
    log: Receiver<Log>,
    hits: Receiver<Hit>,
    thread: Option<JoinHandle<Result<(), String>>>,
    last: Stop,
}

impl Driver<CalibratorBoard> for Callbacks {
    fn on_settled(
        &mut self,
        session: &mut Session<CalibratorBoard>,
        host: &mut dyn Host,
        settled: Settled,
    ) {
        for (address, value) in self.write_buffer.take_lost() {
            // Refused only where there is no memory.
            host.write(address, Width::W64, value).ok();
        }
        if let Some(sprung) = self.see_to_flash(host) {
            self.goal = sprung;
            session.run_until(sprung);
        }
        if let Settled::Hit(hit) = settled
            && hit.kind == HitKind::Write
            && WriteBuffer::covers(hit.address)
        {
            let double = host.read(hit.address & !7, Width::W64).unwrap_or_default();
            self.write_buffer.on_write(hit.address, double, hit.at);
        } else if let Settled::Hit(hit) = settled {
            // Nobody listening means nobody asked: a watch left over from before.
            self.hits.send(hit).ok();
        }
    }

    fn hears_every_stop(&self) -> bool {
        self.execution == Execution::Plain
    }

    fn on_stop(
        &mut self,
        session: &mut Session<CalibratorBoard>,
        stop: Stop,
        host: &mut dyn Host,
    ) -> Option<VirtualNanos> {
        if let Some(control) = self.log_control {
            let mut log = Log::default();
            if log::drain(host, control, &mut log).is_some() {
                self.log.send(log).ok();
            }
        }
        if stop.at < self.goal && !(self.wake && self.serial.has_received()) {
            return Some(self.next(stop.at));
        }
        self.reached.send(stop).ok()?;
        loop {
            match self.commands.recv().ok()? {
                Command::Act(act) => {
                    act(session, host, stop);
                    self.see_to_flash(host);
                }
                Command::PowerOff => return None,
                Command::Run { until, wake } => {
                    (self.goal, self.wake) = (until, wake);
                    return Some(self.next(stop.at));
                }
            }
        }
    }
}

impl Callbacks {
    /// Leaves in the memory what operations on the flash do to it beyond the emulator's model; the
    /// instant the trap asks for a stop at.
    fn see_to_flash(&mut self, host: &mut dyn Host) -> Option<VirtualNanos> {
        let news = self.flash.take_news()?;
        // A memory that refuses is none of the part's: there is nothing to be left in it.
        if let Some(word) = news.begun
            && memory::read(host, word, WORD_BYTES)
                .is_ok_and(|old| old.iter().any(|byte| *byte != 0xFF))
        {
            self.flash.note_overwritten(word);
        }
        for cut in news.cut {
            torn::leave(host, &self.flash, cut).ok();
        }
        news.sprung
    }

    /// The next instant to stop at on the way to the goal: whole steps, so that the same run stops
    /// at the same instants however it is cut into pieces.
    fn next(&self, now: VirtualNanos) -> VirtualNanos {
        let step = (now.0 / STEP_NS + 1) * STEP_NS;
        VirtualNanos(step.min(self.goal.0))
    }
}

impl CoreThread {
    /// Starts the core of a new board with `records` in its record flash, and waits until it stands
    /// before its first instruction.
    pub(super) fn start(
        execution: Execution,
        firmware: &Firmware,
        records: Image,
        pins: &Pins,
    ) -> Result<Self, Error> {
        let images = vec![firmware.image().clone(), records];
        let session = session(execution, pins)?;
        Self::run_images(execution, firmware, images, pins, session, None)
    }

    /// Starts the core where `restore` puts a new session.
    pub(super) fn go_on(
        firmware: &Firmware,
        pins: &Pins,
        restore: impl FnOnce(&mut Session<CalibratorBoard>) -> Result<Resume<'static>, Error>,
    ) -> Result<Self, Error> {
        let execution = Execution::asked();
        let mut session = session(execution, pins)?;
        let resume = restore(&mut session)?;
        let images = vec![firmware.image().clone()];
        Self::run_images(execution, firmware, images, pins, session, Some(resume))
    }

    fn run_images(
        execution: Execution,
        firmware: &Firmware,
        images: Vec<Image>,
        pins: &Pins,
        session: Session<CalibratorBoard>,
        resume: Option<Resume<'static>>,
    ) -> Result<Self, Error> {
        let (commands, for_callbacks) = channel();
        let (reached, from_callbacks) = channel();
        let (log, logged) = channel();
        let (hits, hit) = channel();
        let callbacks = Callbacks {
            execution,
            commands: for_callbacks,
            reached,
            goal: VirtualNanos(0),
            wake: false,
            serial: pins.serial.clone(),
            flash: pins.flash.clone(),
            write_buffer: pins.write_buffer.clone(),
            log_control: firmware.symbol(LOG_CONTROL).ok(),
            log,
            hits,
        };
        let thread = std::thread::Builder::new()
            .name("emulated core".into())
            .spawn(move || {
                let mut start = Start::new(&images);
                start.resume = resume.as_ref();
                emulator::run(session, &start, callbacks)
                    .map(drop)
                    .map_err(|error| error.to_string())
            })
            .map_err(|error| Error::Ended(error.to_string()))?;
        let mut core = Self {
            commands,
            reached: from_callbacks,
            log: logged,
            hits: hit,
            thread: Some(thread),
            last: Stop {
                at: VirtualNanos(0),
                instruction_count: 0,
                reason: rigless::emulator::StopReason::Deadline,
            },
        };
        core.wait()?;
        let buffer = pins.write_buffer.clone();
        core.act(move |session, host, _| {
            session.watch(WriteBuffer::watch());
            session.settle_watches(host);
            memory::note_kept(host, &buffer);
        })?;
        Ok(core)
    }

    /// Where the core stands.
    pub(super) fn stop(&self) -> Stop {
        self.last
    }

    /// Runs to `until`, or with `wake` until the board has sent something.
    pub(super) fn run(&mut self, until: VirtualNanos, wake: bool) -> Result<(), Error> {
        self.send(Command::Run { until, wake })?;
        self.wait()
    }

    /// Does `act` where the core stands and hands its result back.
    pub(super) fn act<T: Send + 'static>(
        &mut self,
        act: impl FnOnce(&mut Session<CalibratorBoard>, &mut dyn Host, Stop) -> T + Send + 'static,
    ) -> Result<T, Error> {
        let (result, answer) = channel();
        self.send(Command::Act(Box::new(move |session, host, stop| {
            result.send(act(session, host, stop)).ok();
        })))?;
        match answer.recv() {
            Ok(value) => Ok(value),
            Err(_) => Err(self.why_ended()),
        }
    }

    /// Log bytes that came since the last call.
    pub(super) fn logged(&self) -> impl Iterator<Item = Log> + '_ {
        self.log.try_iter()
    }

    /// Hits on watched instructions since the last call.
    pub(super) fn hits(&self) -> impl Iterator<Item = Hit> + '_ {
        self.hits.try_iter()
    }

    fn send(&mut self, command: Command) -> Result<(), Error> {
        match self.commands.send(command) {
            Ok(()) => Ok(()),
            Err(_) => Err(self.why_ended()),
        }
    }

    fn wait(&mut self) -> Result<(), Error> {
        match self.reached.recv() {
            Ok(stop) => {
                self.last = stop;
                Ok(())
            }
            Err(_) => Err(self.why_ended()),
        }
    }

    /// The thread hung up: its result says why.
    fn why_ended(&mut self) -> Error {
        let result = self.thread.take().map(JoinHandle::join);
        Error::Ended(match result {
            Some(Ok(Err(error))) => error,
            Some(Ok(Ok(()))) => "the run ended".into(),
            Some(Err(panic)) => panic_message(panic.as_ref()),
            None => "it stopped before".into(),
        })
    }
}

/// A session of a new board.
fn session(execution: Execution, pins: &Pins) -> Result<Session<CalibratorBoard>, Error> {
    let ended = |error: &dyn std::fmt::Display| Error::Ended(error.to_string());
    let mut board = CalibratorBoard::new(pins.clone()).map_err(|error| ended(&error))?;
    board.shortcuts = execution == Execution::Fast;
    Session::new(Box::new(board), 0, VirtualNanos(0)).map_err(|error| ended(&error))
}

fn panic_message(panic: &(dyn std::any::Any + Send)) -> String {
    let text = panic
        .downcast_ref::<String>()
        .map(String::as_str)
        .or_else(|| panic.downcast_ref::<&str>().copied());
    format!("a model failed: {}", text.unwrap_or("no message"))
}

impl Drop for CoreThread {
    fn drop(&mut self) {
        // Either fails only when the thread has ended already, which is what is wanted.
        self.commands.send(Command::PowerOff).ok();
        if let Some(thread) = self.thread.take() {
            thread.join().ok();
        }
    }
}
