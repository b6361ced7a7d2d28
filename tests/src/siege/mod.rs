//! Hosts that do their worst to the shipping firmware while it measures.
//!
//! A [`Siege`] is a calibrator with a record in its flash and a run going on. One link holds the
//! session. What must hold, whatever the other one does:
//!
//! - a well-formed question is answered within [`PROMPT`], on the attacked link once the attack
//!   pauses, on the other one always;
//! - the run's record is, to the byte, that of a run nobody disturbed;
//! - no setting, record or sample is changed or lost, and nothing restarts.

mod assault;
mod fire;
mod resets;
mod two_hosts;

pub use assault::{AFTER_DAMAGE, Assault, run};
pub use fire::{Ammunition, frame};
pub use resets::run as run_resets;

use crate::rigged::{Fault, Rigged, point};
use calib_core::point::{ExcitationKind, PointSpec};
use calib_core::settings::Settings;
use calib_host::emulated::EmulatedUsbTransport;
use calib_link::Client;
use calib_protocol::message::{RunSpec, RunState};
use calib_protocol::record::RunLabels;
use calib_twin::board::usb::UsbPort;
use calib_twin::rig::Rig;
use serde::Serialize;
use std::time::Duration;

/// Longest time to an answer.
pub const PROMPT: Duration = Duration::from_millis(100);

/// One of the two links.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// USART3, the virtual COM port.
    Serial,
    /// The USB port.
    Usb,
}

/// Result of a siege.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct Toll {
    /// Attacks.
    pub blows: u32,
    /// Bytes of them on the line.
    pub bytes: usize,
    /// Questions meanwhile, each answered in time.
    pub asked: u32,
    /// Longest time to an answer, ms.
    pub slowest_ms: f64,
    /// Runs that went on meanwhile.
    pub runs: u32,
    /// Time on the board, s.
    pub virtual_s: f64,
}

/// A calibrator under attack.
pub struct Siege {
    /// The calibrator, with the client of its serial line.
    pub rigged: Rigged,
    usb: Client,
    holder: End,
    points: Vec<PointSpec>,
    before: Settings,
    /// The record that was there before.
    first: Vec<u8>,
    toll: Toll,
}

impl Siege {
    /// Switches a calibrator on, lets it make a record, and starts a run of `points`, all asked for
    /// by the link `holder`.
    ///
    /// # Errors
    /// The image is missing, or the instrument refuses.
    pub fn begin(holder: End, points: &[PointSpec]) -> Result<Self, Fault> {
        let mut rigged = Rigged::with_rig(&Rig::standard())?;
        let usb = Client::new(Box::new(EmulatedUsbTransport::plug_in(rigged.shared())?));
        let before = rigged.client.settings()?;
        let mut siege = Self {
            rigged,
            usb,
            holder,
            points: vec![point(160.0, 10.0)],
            before,
            first: Vec::new(),
            toll: Toll::default(),
        };
        siege.start()?;
        siege.rest()?;
        siege.first = siege.record(1)?;
        siege.points = points.to_vec();
        siege.toll = Toll::default();
        siege.start()?;
        Ok(siege)
    }

    /// Starts the next run.
    fn start(&mut self) -> Result<(), Fault> {
        let spec = RunSpec {
            points: self.points.iter().copied().collect(),
            excitation: ExcitationKind::SingleSine,
            labels: RunLabels::default(),
        };
        self.holder().start(spec)?;
        self.toll.runs += 1;
        Ok(())
    }

    /// Waits in peace until the run is over.
    fn rest(&mut self) -> Result<(), Fault> {
        while !self.is_over()? {
            self.rigged.client.wait(Duration::from_millis(100))?;
        }
        Ok(())
    }

    /// Record of the run without an attack.
    ///
    /// # Errors
    /// As [`Siege::begin`].
    pub fn quiet_record(holder: End, points: &[PointSpec]) -> Result<Vec<u8>, Fault> {
        let mut siege = Self::begin(holder, points)?;
        siege.rest()?;
        siege.record(2)
    }

    fn client(&mut self, end: End) -> &mut Client {
        match end {
            End::Serial => &mut self.rigged.client,
            End::Usb => &mut self.usb,
        }
    }

    fn holder(&mut self) -> &mut Client {
        self.client(self.holder)
    }

    fn port(&self) -> UsbPort {
        self.rigged.board().usb().clone()
    }

    /// Asks one question after another kind, and takes the time.
    fn ask(&mut self, end: End) -> Result<(), Fault> {
        let kind = self.toll.asked % 5;
        let before = self.rigged.board().elapsed();
        let client = self.client(end);
        match kind {
            0 => drop(client.info()?),
            1 => drop(client.point(0)?),
            2 => drop(client.records()?),
            3 => drop(client.read_record(7777, 0).expect_err("no such record")),
            _ => drop(client.status()?),
        }
        let took = self.rigged.board().elapsed() - before;
        if took > PROMPT {
            let (blows, state) = (self.toll.blows, self.holder().status()?.state);
            return Err(format!(
                "blow {blows}, {state:?}: question {kind} over {end:?} took {took:?}"
            )
            .into());
        }
        self.toll.asked += 1;
        self.toll.slowest_ms = self.toll.slowest_ms.max(took.as_secs_f64() * 1000.0);
        Ok(())
    }

    /// Asks the holder of the session whether the run is over.
    fn is_over(&mut self) -> Result<bool, Fault> {
        Ok(!self.holder().status()?.state.is_running())
    }

    /// All bytes of a record.
    fn record(&mut self, id: u32) -> Result<Vec<u8>, Fault> {
        let mut bytes = Vec::new();
        loop {
            let part = self.usb.read_record(id, bytes.len() as u32)?;
            bytes.extend_from_slice(&part.data);
            if bytes.len() >= part.total as usize {
                return Ok(bytes);
            }
        }
    }

    /// Ends a run of the siege: it came out, and nothing else changed. `quiet` is the record of the
    /// first run if nobody disturbs it.
    fn judge(&mut self, quiet: &[u8]) -> Result<(), Fault> {
        let runs = self.toll.runs + 1;
        let status = self.rigged.client.status()?;
        let came_out = status.state == RunState::Finished && status.overruns == 0;
        let restarts = self.rigged.board().resets()?;
        if !came_out || !restarts.is_empty() {
            return Err(format!("run {runs}: {status:?}, restarts {restarts:?}").into());
        }
        if self.record(1)? != self.first || self.record(2)? != quiet {
            return Err("a record is another than without the attack".into());
        }
        if self.rigged.client.records()?.len() != runs as usize {
            return Err("there are other records than were made".into());
        }
        if self.rigged.client.settings()? != self.before {
            return Err("settings were changed".into());
        }
        self.toll.virtual_s = self.rigged.board().elapsed().as_secs_f64();
        Ok(())
    }
}
