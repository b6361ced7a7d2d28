//! Handle of requests to the thread that speaks to the calibrator: the view, and ways to order and to stop.

use super::stops::{NotStopped, StopState};
use super::view::{RunView, Shared};
use crate::in_unit::StatedPoint;
use calib_core::point::PointSpec;
use calib_link::StopSwitch;
use calib_output::SetPoint;
use calib_protocol::record::RunLabels;
use std::sync::mpsc::Sender;
use std::time::Instant;

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

    /// Counts a stop of this run, or of whatever goes on, and sees that it is heeded; returns its number.
    pub(super) fn stop(&self, run: Option<u32>) -> Result<u64, NotStopped> {
        let number = self.shared.ask_stop(run, &self.switch)?;
        self.order(Order::Heed);
        Ok(number)
    }

    /// Tells everybody, once the calibrator has confirmed this stop; whether it has.
    pub(super) fn note_if_confirmed(&self, stop: u64, asked_at: Instant) -> bool {
        let confirmed = self.switch.is_confirmed(stop);
        if confirmed {
            let after_s = asked_at.elapsed().as_secs_f64();
            self.shared
                .note_stop(stop, StopState::Confirmed, Some(after_s));
        }
        confirmed
    }
}
