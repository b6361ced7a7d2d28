//! An emulated calibrator with a rig on its connectors, and a client.

use calib_core::point::{ExcitationKind, PointSpec};
use calib_core::settings::{ReferencePoint, Settings};
use calib_host::emulated::EmulatedTransport;
use calib_link::Client;
use calib_link::session::{self, Outcome};
use calib_protocol::record::RunLabels;
use calib_twin::oracle::{self, CalibrationPoint};
use calib_twin::plant::Plant;
use calib_twin::rig::Rig;
use calib_twin::rig_port::RigPort;
use calib_twin::runner::{Emulator, Execution, Firmware, SharedEmulator};
use std::ops::ControlFlow;
use std::path::Path;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

/// A fault of the set-up ends a test: there is nothing to recover.
pub type Fault = Box<dyn std::error::Error + Send + Sync>;

/// Time from power-on after which the firmware must answer.
const BOOT: Duration = Duration::from_millis(300);

/// Time after which the firmware has seen the button go up or down.
const BUTTON_SEEN: Duration = Duration::from_millis(60);

/// First request number of a conversation, so that every run sends the same bytes; a later one
/// not from where an earlier one stands, or the device takes its first start for a repetition.
const FIRST: u16 = 0x1000;
const AFTER_KEEPING: u16 = 0x8000;

/// A byte of `cortex_m_rt::STACK_PAINT_VALUE`.
const PAINT: u8 = 0xCC;

/// Bytes of the stack that are in use while every task sleeps, and some.
const IDLE_STACK: usize = 2048;

/// An emulated calibrator with its rig, and a client that speaks to it.
pub struct Rigged {
    emulator: SharedEmulator,
    /// The host tool's client.
    pub client: Client,
}

impl Rigged {
    /// Boots the shipping image with `rig` on its connectors.
    ///
    /// # Errors
    /// The image is missing or does not answer.
    pub fn with_rig(rig: &Rig) -> Result<Self, Fault> {
        Self::with_port(Box::new(Plant::new(rig)))
    }

    /// Boots the shipping image with anything on its connectors.
    ///
    /// # Errors
    /// As [`Rigged::with_rig`].
    pub fn with_port(port: Box<dyn RigPort>) -> Result<Self, Fault> {
        Self::with_image(&Firmware::shipping()?, port)
    }

    /// Boots another image, on the board it is for.
    ///
    /// # Errors
    /// As [`Rigged::with_rig`].
    pub fn with_image(firmware: &Firmware, port: Box<dyn RigPort>) -> Result<Self, Fault> {
        Self::speak_to(Emulator::power_on(firmware, port)?)
    }

    /// As [`Rigged::with_rig`], executed as `execution` says.
    ///
    /// # Errors
    /// As there.
    pub fn executed(execution: Execution, rig: &Rig) -> Result<Self, Fault> {
        let port = Box::new(Plant::new(rig));
        let board = Emulator::power_on_as(execution, &Firmware::shipping()?, port)?;
        Self::speak_to(board)
    }

    fn speak_to(board: Emulator) -> Result<Self, Fault> {
        let emulator = Arc::new(Mutex::new(board));
        let mut client = conversation(&emulator, FIRST);
        client.wait(BOOT)?;
        client.info()?;
        Ok(Self { emulator, client })
    }

    /// A board that was switched on, whatever becomes of it: nothing is asked yet.
    pub fn of(board: Emulator) -> Self {
        let emulator = Arc::new(Mutex::new(board));
        let client = conversation(&emulator, FIRST);
        Self { emulator, client }
    }

    /// Keeps the run in a file, for [`Rigged::go_on`]. A new conversation begins, here as there, so that
    /// both go on alike.
    ///
    /// # Errors
    /// The run cannot be kept, or the board does not answer.
    pub fn keep(&mut self, path: &Path) -> Result<(), Fault> {
        self.board().keep(path)?;
        self.client = conversation(&self.emulator, AFTER_KEEPING);
        self.client.info()?;
        Ok(())
    }

    /// Goes on with a run that was kept with `rig` on the connectors.
    ///
    /// # Errors
    /// The file is none, or of another image; the board does not answer.
    pub fn go_on(rig: &Rig, path: &Path) -> Result<Self, Fault> {
        let firmware = Firmware::shipping()?;
        let board = Emulator::go_on(&firmware, Box::new(Plant::new(rig)), path)?;
        let emulator = Arc::new(Mutex::new(board));
        let mut client = conversation(&emulator, AFTER_KEEPING);
        client.info()?;
        Ok(Self { emulator, client })
    }

    /// Puts another rig on the connectors of the running instrument.
    pub fn mount(&mut self, rig: &Rig) {
        let _ = self.board().replace_rig(Box::new(Plant::new(rig)));
    }

    /// Paints the stack anew but for its first [`IDLE_STACK`] bytes, as soon as the processor sleeps:
    /// what it is used for from here on shows.
    ///
    /// # Errors
    /// As [`Rigged::unused_stack_bytes`], and when the processor does not sleep within 10 ms.
    pub fn paint_stack(&self) -> Result<(), Fault> {
        let mut board = self.board();
        let (end, start) = (board.symbol("_stack_end")?, board.symbol("_stack_start")?);
        for _ in 0..1000 {
            let before = board.instructions();
            board.run_for(Duration::from_micros(10))?;
            if board.instructions() == before {
                let length = (start - end) as usize - IDLE_STACK;
                return Ok(board.fill_memory(end, length, PAINT)?);
            }
        }
        Err("the processor never sleeps".into())
    }

    /// Bytes of the stack, used or not.
    ///
    /// # Errors
    /// When the image has no such symbol.
    pub fn stack_bytes(&self) -> Result<usize, Fault> {
        let board = self.board();
        Ok((board.symbol("_stack_start")? - board.symbol("_stack_end")?) as usize)
    }

    /// Bytes of the stack that still hold what the start-up code filled it with.
    ///
    /// # Errors
    /// When the image or the board cannot be read.
    pub fn unused_stack_bytes(&self) -> Result<usize, Fault> {
        let mut board = self.board();
        let (end, start) = (board.symbol("_stack_end")?, board.symbol("_stack_start")?);
        let stack = board.read_memory(end, (start - end) as usize)?;
        let unused = stack.iter().take_while(|byte| **byte == PAINT).count();
        println!("{unused} of {} bytes of stack never used", stack.len());
        Ok(unused)
    }

    /// The board itself.
    pub fn board(&self) -> MutexGuard<'_, Emulator> {
        self.emulator.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The board, to be shared with another host.
    pub fn shared(&self) -> SharedEmulator {
        Arc::clone(&self.emulator)
    }

    /// Tells the instrument what is certified about its reference, as a
    /// laboratory would after the reference came back from calibration.
    ///
    /// # Errors
    /// The instrument refuses.
    pub fn certify_reference(&mut self, certificate: &[CalibrationPoint]) -> Result<(), Fault> {
        let mut settings = self.client.settings()?;
        settings.reference.points = certificate.iter().map(reference_point).collect();
        self.under_a_hand(|client| Ok(client.write_settings(settings)?))
    }

    /// Does something with the button held, long enough to be seen before and after.
    ///
    /// # Errors
    /// Those of what is done.
    pub fn under_a_hand<T>(
        &mut self,
        act: impl FnOnce(&mut Client) -> Result<T, Fault>,
    ) -> Result<T, Fault> {
        self.board().press_button(true)?;
        self.client.wait(BUTTON_SEEN)?;
        let done = act(&mut self.client);
        self.board().press_button(false)?;
        self.client.wait(BUTTON_SEEN)?;
        done
    }

    /// Changes settings in place, with a hand on the button.
    ///
    /// # Errors
    /// The instrument refuses.
    pub fn adjust(&mut self, change: impl FnOnce(&mut Settings)) -> Result<(), Fault> {
        let mut settings = self.client.settings()?;
        change(&mut settings);
        self.under_a_hand(|client| Ok(client.write_settings(settings)?))
    }

    /// Runs a list to its end.
    ///
    /// # Errors
    /// The link or the instrument fails.
    pub fn run(&mut self, points: &[PointSpec]) -> Result<Outcome, Fault> {
        self.run_excited(points, ExcitationKind::SingleSine)
    }

    /// The stored bytes of a record.
    ///
    /// # Errors
    /// Those of the link.
    pub fn record(&mut self, id: u32) -> Result<Vec<u8>, Fault> {
        let mut bytes = Vec::new();
        loop {
            let chunk = self.client.read_record(id, bytes.len() as u32)?;
            bytes.extend_from_slice(&chunk.data);
            if bytes.len() >= chunk.total as usize {
                return Ok(bytes);
            }
        }
    }

    /// [`Self::run`], each point held for all of its blocks.
    ///
    /// # Errors
    /// As [`Self::run`].
    pub fn run_held(&mut self, points: &[PointSpec]) -> Result<Outcome, Fault> {
        self.run_excited(points, ExcitationKind::HeldSine)
    }

    fn run_excited(
        &mut self,
        points: &[PointSpec],
        excitation: ExcitationKind,
    ) -> Result<Outcome, Fault> {
        let (client, labels) = (&mut self.client, RunLabels::default());
        let go_on = |_: &session::Progress<'_>| ControlFlow::Continue(());
        Ok(session::run_excited(
            client, points, excitation, labels, go_on,
        )?)
    }

    /// Lines of the image's log that tell of a drive that had no command in time, or was written late.
    pub fn late_lines(&self, firmware: &Firmware) -> Vec<String> {
        let mut lines = self.board().log().lines(firmware);
        lines.retain(|line| line.contains("in time") || line.contains("late"));
        lines
    }

    /// Waits until the exciter is silent; fails when it is not within `limit`.
    ///
    /// # Errors
    /// The drive output still moves.
    pub fn expect_silence(&mut self, limit: Duration) -> Result<(), Fault> {
        self.client.wait(limit)?;
        let board = self.board();
        match board.silent_for() {
            Some(_) => Ok(()),
            None => Err(format!("the drive output is at code {}", board.drive_code()).into()),
        }
    }
}

fn conversation(emulator: &SharedEmulator, counted_from: u16) -> Client {
    let line = EmulatedTransport::new(emulator.clone());
    Client::new(Box::new(line)).counting_from(counted_from)
}

/// One point of a list.
pub fn point(frequency_hz: f32, acceleration_rms_ms2: f32) -> PointSpec {
    PointSpec {
        frequency_hz,
        acceleration_rms_ms2,
    }
}

/// The true certificate of a rig's reference, without error.
pub fn true_certificate(rig: &Rig) -> Vec<CalibrationPoint> {
    oracle::reference_calibration(rig, None)
}

/// A line of a certificate as the settings have it.
pub fn reference_point(line: &CalibrationPoint) -> ReferencePoint {
    ReferencePoint {
        frequency_hz: line.frequency_hz as f32,
        sensitivity_v_per_ms2: line.sensitivity_v_per_ms2 as f32,
        phase_rad: line.phase_rad as f32,
        expanded_uncertainty_rel: line.expanded_uncertainty_rel as f32,
        expanded_uncertainty_phase_rad: line.expanded_uncertainty_phase_rad as f32,
    }
}
