//! A calibrator that notes when a stop reaches it, behind a TCP port that can misbehave.

use calib_core::settings::Settings;
use calib_protocol::frame::{Frame, MAX_FRAME, Receiver, encode};
use calib_protocol::health::Health;
use calib_protocol::message::{Refusal, Request, Response, RunState, Status};
use calib_tests::hostile::info;
use calib_tests::rigged::Fault;
use std::io::{Read, Write};
use std::net::{TcpListener, TcpStream};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// Way in which it answers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Way {
    /// Whole, at once.
    Plain,
    /// A byte at a time, each of which once renewed the time limit.
    Drip,
    /// Whole frames with the number of an earlier question, without end.
    OldFrames,
}

/// Pause between two bytes of a link that drips.
pub(crate) const DRIP: Duration = Duration::from_millis(600);
/// Pause between two old frames.
pub(crate) const REPEAT: Duration = Duration::from_millis(10);

struct State {
    way: Way,
    /// Running number of the last run, and whether it goes on.
    run: u32,
    running: bool,
    stopped_at: Option<Instant>,
}

/// The device.
#[derive(Clone)]
pub(crate) struct Device {
    state: Arc<Mutex<State>>,
    /// Address for `--device`.
    pub(crate) address: String,
}

impl Device {
    pub(crate) fn listen() -> Result<Self, Fault> {
        let listener = TcpListener::bind("127.0.0.1:0")?;
        let device = Self {
            state: Arc::new(Mutex::new(State {
                way: Way::Plain,
                run: 0,
                running: false,
                stopped_at: None,
            })),
            address: format!("tcp:{}", listener.local_addr()?),
        };
        let served = device.clone();
        std::thread::spawn(move || {
            for stream in listener.incoming().flatten() {
                let device = served.clone();
                // A host that goes ends its thread.
                std::thread::spawn(move || device.serve(stream));
            }
        });
        Ok(device)
    }

    /// From now on its answers are like this.
    pub(crate) fn behave(&self, way: Way) {
        self.state().way = way;
    }

    /// Whether a run goes on.
    pub(crate) fn is_running(&self) -> bool {
        self.state().running
    }

    /// When the last run was stopped, if it was.
    pub(crate) fn stopped_at(&self) -> Option<Instant> {
        self.state().stopped_at
    }

    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn serve(&self, mut stream: TcpStream) -> std::io::Result<()> {
        stream.set_nodelay(true)?;
        let mut receiver = Receiver::new();
        let mut bytes = [0; 512];
        loop {
            let count = stream.read(&mut bytes)?;
            if count == 0 {
                return Ok(());
            }
            for byte in &bytes[..count] {
                let Some(raw) = receiver.push(*byte) else {
                    continue;
                };
                let mut raw = raw.to_vec();
                let Ok(frame) = Frame::check(&mut raw) else {
                    continue;
                };
                let answer = frame.message().map(|request| self.answer(&request));
                let answer = answer.unwrap_or(Response::Refused(Refusal::Unknown));
                self.send(stream.try_clone()?, frame.sequence, &answer)?;
            }
        }
    }

    /// Sends an answer as the way is; what takes its time is done beside the ear.
    fn send(&self, mut stream: TcpStream, sequence: u16, answer: &Response) -> std::io::Result<()> {
        let way = self.state().way;
        let sequence = match way {
            Way::OldFrames => sequence.wrapping_sub(1),
            Way::Plain | Way::Drip => sequence,
        };
        let mut frame = vec![0; MAX_FRAME];
        let length = encode(sequence, answer, &mut frame).unwrap_or(0);
        frame.truncate(length);
        let device = self.clone();
        match way {
            Way::Plain => stream.write_all(&frame)?,
            Way::Drip => drop(std::thread::spawn(move || {
                for byte in frame {
                    if device.state().way != Way::Drip || stream.write_all(&[byte]).is_err() {
                        return;
                    }
                    std::thread::sleep(DRIP);
                }
            })),
            Way::OldFrames => drop(std::thread::spawn(move || {
                while device.state().way == Way::OldFrames && stream.write_all(&frame).is_ok() {
                    std::thread::sleep(REPEAT);
                }
            })),
        }
        Ok(())
    }

    fn answer(&self, request: &Request) -> Response {
        let mut state = self.state();
        match request {
            Request::Info => Response::Info(info()),
            Request::Health => Response::Health(Health::default()),
            Request::SettingsRead => Response::Settings(Settings::field_calibrator()),
            Request::Status => Response::Status(Status {
                // Nothing to be downloaded: the next try may begin.
                state: match state.running {
                    true => RunState::Measuring,
                    false => RunState::Failed,
                },
                points: 1,
                blocks: 10,
                ..Status::IDLE
            }),
            Request::Point { index } => Response::Point {
                index: *index,
                result: None,
            },
            Request::Start(_) => {
                state.run += 1;
                (state.running, state.stopped_at) = (true, None);
                Response::Started {
                    record_id: state.run,
                }
            }
            Request::Stop => stop(&mut state),
            Request::StopRun { record_id } if *record_id == state.run => stop(&mut state),
            Request::StopRun { .. } => Response::Done,
            // It knows no more, as an older release.
            _ => Response::Refused(Refusal::Unknown),
        }
    }
}

fn stop(state: &mut State) -> Response {
    if std::mem::take(&mut state.running) {
        state.stopped_at = Some(Instant::now());
    }
    Response::Done
}
