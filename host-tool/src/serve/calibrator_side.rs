//! The thread that alone speaks to the calibrator.
//!
//! Orders come in over a channel and are carried out one after the other. A stop
//! is no order: the client looks at its switch all the time, be it in the middle of
//! an answer, so that nothing can be in the way of one. A run that was stopped
//! before its turn does not begin.

use super::handle::{Handle, Order};
use super::keeper::Keeper;
use super::view::{Connection, KeptListView, RunView, Shared};
use super::waveforms::Eye;
use crate::clock::unix_time_s;
use crate::in_unit::{StatedPoint, Stating};
use crate::refusals::{self, Refused};
use crate::{Device, Error, Result};
use calib_core::point::{ExcitationKind, PointResult, PointSpec};
use calib_link::session::{self, Outcome, Progress};
use calib_link::{Client, StopSwitch};
use calib_output::{InfoView, StatusView};
use calib_protocol::lists::KeptList;
use calib_protocol::message::RunState;
use calib_protocol::record::RunLabels;
use calib_record::signature::short;
use std::ops::ControlFlow;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// Time between two looks at a lost link.
const LOOK: Duration = Duration::from_millis(200);

/// Time a thread that has no link is given to end.
const GRACE: Duration = Duration::from_millis(500);

/// The thread, from outside.
pub(super) struct CalibratorSide {
    handle: Handle,
    ending: Arc<AtomicBool>,
    thread: JoinHandle<()>,
}

impl CalibratorSide {
    pub(super) fn start(logbook: PathBuf) -> Self {
        let (orders, incoming) = channel();
        let (shared, switch) = (Shared::new(), StopSwitch::default());
        let ending = Arc::new(AtomicBool::new(false));
        let worker = Worker {
            shared: shared.clone(),
            switch: switch.clone(),
            ending: Arc::clone(&ending),
            orders: incoming,
            keeper: Keeper::start(logbook, shared.clone()),
            client: None,
        };
        let handle = Handle::new(shared, orders, switch);
        let thread = std::thread::spawn(move || worker.work());
        Self {
            handle,
            ending,
            thread,
        }
    }

    pub(super) fn handle(&self) -> Handle {
        self.handle.clone()
    }

    pub(super) fn order(&self, order: Order) {
        self.handle.order(order);
    }

    /// Stops a run and waits for its end: the exciter is silent. What it measured
    /// is in the calibrator; it is not fetched any more.
    ///
    /// Over a link that is lost nothing can be stopped: then it is not waited for.
    pub(super) fn end(self) {
        self.ending.store(true, Ordering::SeqCst);
        // For whatever goes on, so it cannot come late.
        let _ = self.handle.ask_stop(None);
        self.handle.order(Order::End);
        let begun = Instant::now();
        while !self.thread.is_finished() {
            let lost = self.handle.shared.snapshot().link != Connection::Connected;
            if lost && begun.elapsed() > GRACE {
                return;
            }
            std::thread::sleep(Duration::from_millis(10));
        }
    }
}

struct Worker {
    shared: Shared,
    switch: StopSwitch,
    /// Set when the server ends.
    ending: Arc<AtomicBool>,
    orders: Receiver<Order>,
    keeper: Keeper,
    client: Option<Client>,
}

impl Worker {
    fn work(mut self) {
        loop {
            match self.orders.recv_timeout(LOOK) {
                Ok(Order::Connect { device }) => self.connect(device),
                Ok(Order::Run {
                    number,
                    points,
                    labels,
                }) => self.run(number, &points, *labels),
                Ok(Order::End) | Err(RecvTimeoutError::Disconnected) => {
                    self.pass_stop();
                    return;
                }
                Ok(Order::Heed) => self.pass_stop(),
                Err(RecvTimeoutError::Timeout) => {
                    self.reconnect_if_lost();
                    self.pass_stop();
                }
            }
        }
    }

    fn connect(&mut self, device: String) {
        self.client = None;
        self.shared.change(|snapshot| {
            snapshot.device = device;
            snapshot.info = None;
            snapshot.key = None;
            snapshot.lists.clear();
            snapshot.link = Connection::None;
        });
        if let Err(error) = self.open() {
            self.trouble(&error);
        }
    }

    fn open(&mut self) -> Result<()> {
        let snapshot = self.shared.snapshot();
        let Ok(address) = snapshot.device.parse::<Device>();
        let client = Client::new(address.open()?).telling(unix_time_s());
        let mut client = client.heeding(self.switch.clone());
        // A stop that waited for the link is for the run that was followed, not for one that another host
        // has begun meanwhile.
        let followed = snapshot.run.filter(|run| run.running);
        client.stop_for(followed.and_then(|run| run.record_id));
        let (info, health, key) = (client.info()?, client.health()?, client.key()?);
        let image = client.image()?;
        let lists = kept_lists(&mut client)?;
        client.stop_for(None);
        self.client = Some(client);
        self.shared.change(|snapshot| {
            snapshot.info = Some(InfoView::new(&info, health.as_ref(), image.as_ref()));
            snapshot.key = key.map(|key| short(&key.public));
            snapshot.lists = lists;
            snapshot.link = Connection::Connected;
            snapshot.trouble = None;
        });
        Ok(())
    }

    /// A link that broke is tried again until it is there; a run that went on
    /// meanwhile is followed to its end.
    fn reconnect_if_lost(&mut self) {
        let snapshot = self.shared.snapshot();
        if snapshot.link != Connection::Lost || self.open().is_err() {
            return;
        }
        let Some(run) = snapshot.run.filter(|run| run.running) else {
            return;
        };
        if let Some(record) = run.record_id {
            let list: Vec<PointSpec> = run.list.iter().map(PointSpec::from).collect();
            self.follow(record, &list);
        }
    }

    /// Passes a stop on when no run is followed here: one that somebody else
    /// began, or one that ended in the meantime.
    fn pass_stop(&mut self) {
        let passed = self.client.as_mut().map(Client::pass_stop);
        if let Some(Err(error)) = passed {
            self.judge(&error.into());
        }
    }

    /// Points of a list that this calibrator cannot measure.
    fn impossible(&mut self, points: &[PointSpec]) -> calib_link::Result<Vec<Refused>> {
        let sample_rate_hz = self.shared.sample_rate_hz();
        let Some(client) = &mut self.client else {
            return Ok(Vec::new());
        };
        let settings = client.settings()?;
        Ok(refusals::impossible(points, &settings, sample_rate_hz))
    }

    fn run(&mut self, number: u32, points: &[PointSpec], labels: RunLabels) {
        // Stops from before are none of this run.
        self.pass_stop();
        if self.shared.is_stopped(number) {
            self.shared.not_begun("stopped before it began");
            return;
        }
        match self.impossible(points) {
            Ok(impossible) if impossible.is_empty() => {}
            Ok(impossible) => return self.shared.refuse_list(impossible),
            Err(error) => return self.did_not_begin(&error.into()),
        }
        let Some(client) = &mut self.client else {
            self.shared.not_begun("there is no calibrator: connect one");
            return;
        };
        match session::begin(client, points, ExcitationKind::SingleSine, labels) {
            Ok(record) => self.follow(record, points),
            Err(calib_link::Error::Stopped) => self.shared.not_begun("stopped before it began"),
            Err(error) => self.did_not_begin(&error.into()),
        }
    }

    fn did_not_begin(&mut self, error: &Error) {
        self.shared.not_begun("did not begin");
        self.judge(error);
    }

    fn follow(&mut self, record: u32, points: &[PointSpec]) {
        self.shared.change_run(|run| run.record_id = Some(record));
        let Some(client) = &mut self.client else {
            return;
        };
        let (shared, ending) = (&self.shared, &self.ending);
        let begun = Instant::now();
        let mut eye = match Eye::open(client) {
            Ok(eye) => eye,
            Err(error) => return self.judge(&error.into()),
        };
        let outcome = session::follow_beside(client, record, points, |progress, client| {
            if ending.load(Ordering::SeqCst) {
                // Silent once this is answered; its record it stores by itself.
                client.stop()?;
                return Err(Error::NotPassed("the server ended".to_owned()));
            }
            show(shared, progress, begun);
            if let Some(waveforms) = eye.look(client, &progress.status)? {
                shared.keep_waveforms(waveforms);
            }
            Ok(match refusals::dead_from_the_start(progress.points) {
                Some(_) => ControlFlow::Break(()),
                None => ControlFlow::Continue(()),
            })
        });
        let outcome = outcome.and_then(|outcome| {
            if let Some(waveforms) = eye.rest(client)? {
                shared.keep_waveforms(waveforms);
            }
            Ok(outcome)
        });
        match outcome {
            Ok(outcome) => self.ended(&outcome),
            Err(error) => self.judge(&error),
        }
    }

    fn ended(&mut self, outcome: &Outcome) {
        if outcome.state != RunState::Failed
            && let Err(error) = self.fetch(outcome.record_id)
        {
            self.judge(&error);
        }
        let sample_rate_hz = self.shared.sample_rate_hz();
        self.shared.change_run(|run| {
            run.running = false;
            run.points = stated(run, sample_rate_hz, &outcome.points);
            run.fraction = 1.0;
            run.ended = match outcome.state {
                RunState::Finished => "finished",
                RunState::Stopped => "stopped, the exciter is silent",
                _ => "the record could not be stored",
            }
            .to_owned();
        });
    }

    /// Downloads the record: for the certificate, and into the logbook.
    fn fetch(&mut self, record: u32) -> Result<()> {
        let Some(client) = &mut self.client else {
            return Ok(());
        };
        let (_, bytes) = session::take(client, record)?;
        // Whatever becomes of the logbook, there is a certificate.
        self.shared.keep_record(bytes.clone());
        // A link that breaks here keeps no record from the logbook: the key enters with the next.
        let key = session::stated_key(client).ok().flatten();
        let waited = self.keeper.keep(&bytes, key)?;
        // A stop never waits for a file.
        while !waited.is_over() {
            self.pass_stop();
        }
        Ok(())
    }

    /// A broken link is tried again; the rest is told.
    fn judge(&mut self, error: &Error) {
        match error {
            Error::Calibrator(calib_link::Error::Link(_)) => self.lost(error),
            _ => {
                self.trouble(error);
                self.shared.change_run(|run| {
                    if run.running {
                        run.running = false;
                        run.ended = "given up".to_owned();
                    }
                });
            }
        }
    }

    fn lost(&mut self, error: &Error) {
        self.client = None;
        self.trouble(error);
        self.shared
            .change(|snapshot| snapshot.link = Connection::Lost);
    }

    fn trouble(&self, error: &Error) {
        self.shared
            .change(|snapshot| snapshot.trouble = Some(error.with_hint()));
    }
}

/// Shows where the run stands.
fn show(shared: &Shared, progress: &Progress<'_>, begun: Instant) {
    let left = session::time_left(begun.elapsed(), progress.fraction);
    let sample_rate_hz = shared.sample_rate_hz();
    shared.change_run(|run| {
        run.left_s = left.map(|left| left.as_secs_f64());
        run.status = Some(StatusView::from(&progress.status));
        run.fraction = progress.fraction;
        run.points = stated(run, sample_rate_hz, progress.points);
    });
}

/// Points in the unit of the sensor of a run.
fn stated(run: &RunView, sample_rate_hz: f32, points: &[PointResult]) -> Vec<StatedPoint> {
    let kept = &run.measured.kept;
    let stating = Stating::new(run.measured.kind, sample_rate_hz).following(kept);
    let new = stating.all(points);
    kept.iter().cloned().chain(new).collect()
}

/// Lists for a tap of the button, for the page; none while the record area is busy or dead.
fn kept_lists(client: &mut Client) -> Result<Vec<KeptListView>> {
    let lists = match client.lists() {
        Err(calib_link::Error::Refused(_)) => Vec::new(),
        lists => lists?,
    };
    let view = |kept: &KeptList| KeptListView {
        name: kept.list.terms.name.as_str().to_owned(),
        chosen: kept.chosen,
    };
    Ok(lists.iter().map(view).collect())
}
