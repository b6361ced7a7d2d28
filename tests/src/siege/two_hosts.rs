//! Two hosts that ask at the same time.

use super::fire::frame;
use super::{PROMPT, Siege};
use crate::rigged::Fault;
use calib_protocol::frame::{Frame, Receiver};
use calib_protocol::message::{Refusal, Request, Response};
use std::time::Duration;

/// Quiet after which nobody holds the session (docs/protocol.md), and some.
const SESSION_OVER: Duration = Duration::from_millis(5200);
/// Times the free session is asked for by both at once.
const RACES: u32 = 5;
/// How often the answers are looked for.
const LOOK: Duration = Duration::from_millis(1);

/// Questions whose answers take any link less than [`PROMPT`].
const READS: [Request; 5] = [
    Request::Info,
    Request::Status,
    Request::Point { index: 0 },
    Request::Records { from: 1 },
    Request::ReadRecord { id: 1, offset: 600 },
];

/// The conversation of both.
#[derive(Default)]
pub(super) struct TwoHosts {
    rounds: u16,
}

impl TwoHosts {
    /// The holder and the other host ask something at the same instant: reading is answered to
    /// both, and who does not hold the session changes nothing.
    pub(super) fn ask_at_once(&mut self, siege: &mut Siege) -> Result<(), Fault> {
        self.rounds = self.rounds.wrapping_add(1);
        let nth = usize::from(self.rounds);
        let changes = [
            Request::Capture { pairs: 64 },
            Request::Release { through: 9 },
            Request::Reset,
            Request::SettingsWrite(siege.before.clone().into()),
        ];
        // Periods without a common divisor: every pair comes up.
        let holders = [&READS[..], &[Request::Capture { pairs: 64 }]].concat();
        let others = [&READS[..], &changes].concat();
        let asked = [
            holders[nth % holders.len()].clone(),
            others[nth % 7 * 2 % others.len()].clone(),
        ];
        let [to_holder, to_other] = self.exchange(siege, &asked)?;
        expect(&asked[0], &to_holder, true)?;
        expect(&asked[1], &to_other, false)
    }

    /// Nobody holds the session, and both ask for it at once: one gets it.
    pub(super) fn race(&mut self, siege: &mut Siege) -> Result<(), Fault> {
        for _ in 0..RACES {
            siege.rigged.client.wait(SESSION_OVER)?;
            self.rounds = self.rounds.wrapping_add(1);
            let capture = Request::Capture { pairs: 64 };
            let answers = self.exchange(siege, &[capture.clone(), capture])?;
            let granted = answers.iter().filter(|answer| **answer == Response::Done);
            let refused = answers
                .iter()
                .filter(|answer| **answer == Response::Refused(Refusal::OtherHost));
            if (granted.count(), refused.count()) != (1, 1) {
                return Err(format!("a free session, asked for by both: {answers:?}").into());
            }
        }
        Ok(())
    }

    /// Sends the first request over the serial line and the second over USB; both answers.
    fn exchange(
        &mut self,
        siege: &mut Siege,
        asked: &[Request; 2],
    ) -> Result<[Response; 2], Fault> {
        let frames = [0, 1].map(|end: usize| frame(self.rounds, &asked[end]));
        siege.toll.bytes += frames.concat().len();
        let port = siege.port();
        siege.rigged.board().write_serial(&frames[0]);
        port.send(&frames[1]);
        let before = siege.rigged.board().elapsed();
        let mut receivers = [Receiver::new(), Receiver::new()];
        let mut answers = [None, None];
        while answers.iter().any(Option::is_none) {
            siege.rigged.client.wait(LOOK)?;
            let took = siege.rigged.board().elapsed() - before;
            if took > PROMPT {
                return Err(format!("{asked:?}: {answers:?} after {took:?}").into());
            }
            siege.toll.slowest_ms = siege.toll.slowest_ms.max(took.as_secs_f64() * 1000.0);
            let heard = [siege.rigged.board().read_serial(), port.receive()];
            for end in [0, 1] {
                for byte in &heard[end] {
                    if let Some(raw) = receivers[end].push(*byte) {
                        answers[end] = Some(Frame::check(raw)?.message::<Response>()?);
                    }
                }
            }
        }
        siege.toll.asked += 2;
        let [Some(first), Some(second)] = answers else {
            return Err("no answer".into());
        };
        Ok([first, second])
    }
}

fn expect(asked: &Request, answer: &Response, holds: bool) -> Result<(), Fault> {
    let right = match (asked, answer) {
        (Request::Info, Response::Info(_))
        | (Request::Status, Response::Status(_))
        | (Request::Point { .. }, Response::Point { .. })
        | (Request::Records { .. }, Response::Records { .. })
        | (Request::ReadRecord { .. }, Response::RecordData { .. }) => true,
        (Request::Capture { .. }, Response::Done) => holds,
        (
            Request::Capture { .. }
            | Request::Release { .. }
            | Request::Reset
            | Request::SettingsWrite(_),
            Response::Refused(Refusal::OtherHost),
        ) => !holds,
        _ => false,
    };
    match right {
        true => Ok(()),
        false => Err(format!("{asked:?} was answered by {answer:?}").into()),
    }
}
