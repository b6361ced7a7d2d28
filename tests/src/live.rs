//! An emulated calibrator at the pace of the wall, behind a TCP port whose plug can
//! be pulled, with an eye on its drive output.

use crate::rigged::Fault;
use calib_host::emulated::EmulatedBoard;
use calib_twin::rig::Rig;
use calib_twin::runner::{Door, HostLine, TcpDoor, run_paced};
use std::collections::VecDeque;
use std::io;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Arc, mpsc};
use std::thread::JoinHandle;
use std::time::{Duration, SystemTime, UNIX_EPOCH};

/// Long enough to be no zero crossing of a tone.
const REST: Duration = Duration::from_millis(5);

/// State shared by the board's thread and its user.
#[derive(Default)]
struct Shared {
    ended: AtomicBool,
    unplugged: AtomicBool,
    /// Virtual time for which the drive output has rested, ms.
    silent_ms: AtomicU64,
    /// When that began, by the wall, us since 1970; 0 while it moves.
    rest_began_us: AtomicU64,
    /// How far the board was behind the wall then, us.
    behind_us: AtomicU64,
}

/// Steps of the board that are remembered: more than [`REST`] has.
const REMEMBERED: usize = 64;

/// When a step of the board was over.
#[derive(Clone, Copy)]
struct Step {
    virtual_time: Duration,
    /// By the wall, since 1970.
    at: Duration,
    /// How far the board was behind the wall.
    behind: Duration,
}

impl Shared {
    /// After the last of these steps the drive has rested for `silent`. The rest began in one of them: a computer
    /// that is busy may take long from there to this look.
    fn look(&self, silent: Duration, steps: &VecDeque<Step>) {
        self.silent_ms
            .store(whole(silent.as_millis()), Ordering::SeqCst);
        let Some(last) = steps.back().filter(|_| silent >= REST) else {
            self.rest_began_us.store(0, Ordering::SeqCst);
            return;
        };
        if self.rest_began_us.load(Ordering::SeqCst) == 0 {
            let began = last.virtual_time.saturating_sub(silent);
            let in_it = |step: &&Step| step.virtual_time >= began;
            let first = steps.iter().find(in_it).unwrap_or(last);
            self.behind_us
                .store(whole(first.behind.as_micros()), Ordering::SeqCst);
            self.rest_began_us
                .store(whole(first.at.as_micros()), Ordering::SeqCst);
        }
    }
}

fn whole(count: u128) -> u64 {
    u64::try_from(count).unwrap_or(u64::MAX)
}

/// The calibrator; switched off when it is dropped.
pub struct Live {
    /// Address for `--device`.
    pub address: String,
    shared: Arc<Shared>,
    thread: Option<JoinHandle<()>>,
}

impl Live {
    /// Boots the shipping image with `rig` and tells it what is certified about
    /// the rig's reference.
    ///
    /// # Errors
    /// The image is missing, or there is no port.
    pub fn power_on(rig: Rig) -> Result<Self, Fault> {
        let shared = Arc::new(Shared::default());
        let (ready, begun) = mpsc::channel();
        let board_side = Arc::clone(&shared);
        let thread = std::thread::spawn(move || {
            if let Err(fault) = run(&rig, &board_side, &ready) {
                // Nobody may be left to hear it.
                let _ = ready.send(Err(fault));
            }
        });
        Ok(Self {
            address: begun.recv()??,
            shared,
            thread: Some(thread),
        })
    }

    /// Pulls the plug of its link, or puts it in again. The calibrator goes on.
    pub fn unplug(&self, unplugged: bool) {
        self.shared.unplugged.store(unplugged, Ordering::SeqCst);
    }

    /// How long the drive output has rested at its middle.
    pub fn silent_for(&self) -> Duration {
        Duration::from_millis(self.shared.silent_ms.load(Ordering::SeqCst))
    }

    /// Since when, as time since 1970, the drive output has rested; `None` while it moves.
    ///
    /// The end of the step of the board in which it began, a millisecond; where the computer does not keep the board
    /// at pace, later by what [`Self::behind_at_rest`] says, and never earlier than it was.
    pub fn at_rest_since(&self) -> Option<Duration> {
        let began = self.shared.rest_began_us.load(Ordering::SeqCst);
        (began != 0).then_some(Duration::from_micros(began))
    }

    /// How far this computer was behind with the board when that rest began; a board of its own never is.
    pub fn behind_at_rest(&self) -> Duration {
        Duration::from_micros(self.shared.behind_us.load(Ordering::SeqCst))
    }
}

impl Drop for Live {
    fn drop(&mut self) {
        self.shared.ended.store(true, Ordering::SeqCst);
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }
}

fn run(
    rig: &Rig,
    shared: &Arc<Shared>,
    ready: &mpsc::Sender<Result<String, Fault>>,
) -> Result<(), Fault> {
    let board = EmulatedBoard::power_on_calibrated(rig, None)?;
    let socket = Socket::new(Arc::clone(shared))?;
    let silent = board.emulator().silent_for();
    let now = || SystemTime::now().duration_since(UNIX_EPOCH);
    let mut steps = VecDeque::from([Step {
        virtual_time: Duration::ZERO,
        at: now()?,
        behind: Duration::ZERO,
    }]);
    shared.look(silent.unwrap_or_default(), &steps);
    ready.send(Ok(socket.address()))?;
    let line = board.emulator().serial().clone();
    let mut doors: [Box<dyn Door>; 1] = [Box::new(socket)];
    // What was given up as lost since the last look was behind before.
    let mut lost = Duration::ZERO;
    let begun = now()?;
    run_paced(
        &mut board.emulator(),
        &line,
        &mut doors,
        |emulator, pace| {
            let behind = pace.wall_time.saturating_sub(pace.virtual_time + lost);
            lost = pace.lost;
            steps.push_back(Step {
                virtual_time: pace.virtual_time,
                at: begun + pace.wall_time,
                behind,
            });
            if steps.len() > REMEMBERED {
                steps.pop_front();
            }
            shared.look(emulator.silent_for().unwrap_or_default(), &steps);
            !shared.ended.load(Ordering::SeqCst)
        },
    )?;
    Ok(())
}

/// A TCP port with a plug.
struct Socket {
    port: u16,
    door: Option<TcpDoor>,
    shared: Arc<Shared>,
}

impl Socket {
    fn new(shared: Arc<Shared>) -> io::Result<Self> {
        let door = TcpDoor::listen(0)?;
        Ok(Self {
            port: door.port(),
            door: Some(door),
            shared,
        })
    }
}

impl Door for Socket {
    fn address(&self) -> String {
        format!("tcp:127.0.0.1:{}", self.port)
    }

    fn serve(&mut self, line: &dyn HostLine, from_board: &[u8]) -> io::Result<()> {
        if self.shared.unplugged.load(Ordering::SeqCst) {
            self.door = None;
            return Ok(());
        }
        if self.door.is_none() {
            self.door = Some(TcpDoor::listen(self.port)?);
        }
        match &mut self.door {
            Some(door) => door.serve(line, from_board),
            None => Ok(()),
        }
    }
}
