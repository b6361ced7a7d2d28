//! Handle of requests to the thread that speaks to the calibrator: the view, and ways to order and to stop.

use super::stops::{Asked, NotStopped, StopState};
use super::view::{RunView, Shared};
use crate::in_unit::StatedPoint;
use calib_core::point::PointSpec;
use calib_link::{STOP_ALARM, StopSwitch};
use calib_output::SetPoint;
use calib_protocol::record::RunLabels;
use std::sync::mpsc::Sender;
use std::time::{Duration, Instant};

/// Time between two looks at it.
const LOOK: Duration = Duration::from_millis(5);
/// Time between two looks at one that is late.
const LATE_LOOK: Duration = Duration::from_millis(20);

/// Request of a page.
#[derive(Debug)]
pub enum Order {
    /// Use this calibrator.
    Connect {
        /// Its address, as typed.
        device: String,
    },
    /// Measure a list; the run was accepted under this number.
    Run {
        /// Number of the run.
        number: u32,
        /// The list.
        points: Vec<PointSpec>,
        /// Labels of the operator.
        labels: Box<RunLabels>,
    },
    /// A stop waits.
    Heed,
    /// Nothing more will come.
    End,
}

/// State shared by requests.
#[derive(Clone)]
pub(super) struct Handle {
    pub(super) shared: Shared,
    orders: Sender<Order>,
    switch: StopSwitch,
}

impl Handle {
    pub(super) fn new(shared: Shared, orders: Sender<Order>, switch: StopSwitch) -> Self {
        Self {
            shared,
            orders,
            switch,
        }
    }

    pub(super) fn order(&self, order: Order) {
        // The thread ends with the server: nobody is left to be told.
        let _ = self.orders.send(order);
    }

    /// Accepts a run, unless one is accepted or goes on: one look and one change, so that of two that come
    /// at once one is refused. A stop from here on is meant for this run.
    /// Of a retry, `kept` is what the last run measured already.
    pub(super) fn accept_run(
        &self,
        points: &[PointSpec],
        kept: Option<Vec<StatedPoint>>,
    ) -> Option<u32> {
        let list = points.iter().map(SetPoint::from).collect();
        let run = RunView {
            running: true,
            list,
            points: kept.clone().unwrap_or_default(),
            ..RunView::default()
        };
        self.shared.accept_run(run, kept.is_some())
    }

    /// Changes the calibrator, unless a run goes on.
    pub(super) fn connect(&self, device: String) -> bool {
        let free = !self.shared.is_running();
        if free {
            self.order(Order::Connect { device });
        }
        free
    }

    /// Stops, and says whether the calibrator confirmed it. What is asked is seen to though nobody waits.
    pub(super) async fn stop(self, asked: Asked) -> Result<(), NotStopped> {
        let number = self.ask_stop(asked.run)?;
        match tokio::spawn(self.watch(number)).await {
            Ok(true) => Ok(()),
            _ => Err(NotStopped::Unconfirmed),
        }
    }

    async fn watch(self, number: u64) -> bool {
        let begun = Instant::now();
        while begun.elapsed() < STOP_ALARM {
            if self.note_if_confirmed(number, begun) {
                return true;
            }
            tokio::time::sleep(LOOK).await;
        }
        self.shared.note_stop(number, StopState::Unconfirmed, None);
        tokio::spawn(self.watch_late(number, begun));
        false
    }

    /// A confirmation that comes late is told too, unless there was another stop.
    async fn watch_late(self, number: u64, begun: Instant) {
        while self.shared.is_latest_stop(number) && !self.note_if_confirmed(number, begun) {
            tokio::time::sleep(LATE_LOOK).await;
        }
    }

    /// Counts a stop of this run, or of whatever goes on, and sees that it is heeded; returns its number.
    pub(super) fn ask_stop(&self, run: Option<u32>) -> Result<u64, NotStopped> {
        let number = self.shared.ask_stop(run, &self.switch)?;
        self.order(Order::Heed);
        Ok(number)
    }

    /// Tells everybody, once the calibrator has confirmed this stop; whether it has.
    fn note_if_confirmed(&self, stop: u64, asked_at: Instant) -> bool {
        let confirmed = self.switch.is_confirmed(stop);
        if confirmed {
            let after_s = asked_at.elapsed().as_secs_f64();
            self.shared
                .note_stop(stop, StopState::Confirmed, Some(after_s));
        }
        confirmed
    }
}
