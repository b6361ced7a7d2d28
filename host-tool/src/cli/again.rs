//! A run whose link breaks goes on in the calibrator: it is followed on once the link is there again.

use super::Context;
use calib_core::point::PointSpec;
use calib_host::Result;
use calib_link::session::{self, Outcome, Progress};
use calib_link::{Client, Error, StopSwitch};
use std::ops::ControlFlow;
use std::time::{Duration, Instant};

/// How long a broken link is tried again: to find the cable, or for a computer that slept.
const PATIENCE: Duration = Duration::from_secs(60);
/// Between two tries.
const PAUSE: Duration = Duration::from_millis(500);

/// A run that goes on in a calibrator.
pub(super) struct Followed<'a> {
    pub(super) context: &'a Context,
    pub(super) points: &'a [PointSpec],
    pub(super) switch: &'a StopSwitch,
    pub(super) record_id: u32,
    /// Of the calibrator: another at the same port is not taken for it.
    pub(super) serial: &'a str,
}

impl Followed<'_> {
    /// Follows it to its end, over as many links as that takes.
    pub(super) fn to_its_end(
        &self,
        client: &mut Client,
        mut observe: impl FnMut(&Progress<'_>) -> ControlFlow<()>,
    ) -> Result<Outcome> {
        loop {
            match session::follow(client, self.record_id, self.points, &mut observe) {
                Err(broken @ Error::Link(_)) => *client = self.found_again(broken)?,
                done => return Ok(done?),
            }
        }
    }

    /// Connects the same calibrator over a new link; without one, the error of the link that broke.
    fn found_again(&self, broken: Error) -> Result<Client> {
        let id = self.record_id;
        // A board that this program itself emulates has no link that could come back.
        if !self.context.is_outside() {
            return Err(broken.into());
        }
        self.context.remark(&format!(
            "{broken}: the run goes on if the calibrator has power, and is followed when the link is there again"
        ));
        let begun = Instant::now();
        while begun.elapsed() < PATIENCE {
            if let Some(client) = self.look() {
                return Ok(client);
            }
            std::thread::sleep(PAUSE);
        }
        self.context.remark(&format!(
            "a calibrator that kept its power stores the run as record {id}, which `calib sync` fetches once the \
             link is there; one that lost it has to run again"
        ));
        Err(broken.into())
    }

    fn look(&self) -> Option<Client> {
        let mut client = self.context.connect().ok()?;
        // Asked before a stop is passed on, which is for this calibrator alone.
        let info = client.info().ok()?;
        if info.serial != *self.serial {
            return None;
        }
        client.heed(self.switch.clone());
        Some(client)
    }
}
