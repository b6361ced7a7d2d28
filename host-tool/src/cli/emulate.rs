//! `calib emulate`: an emulated calibrator that other programs use like hardware.

use super::{Context, measure};
use calib_files::file;
use calib_host::emulated::{EmulatedBoard, FlashFile, rig_file};
use calib_host::{Error, Result};
use calib_twin::board::usb::UsbPort;
use calib_twin::rig::Rig;
use calib_twin::runner::{Door, Emulator, HostLine, Pace, TcpDoor, run_paced};
use calib_twin::usb_host::capture;
use clap::Args;
use schemars::JsonSchema;
use serde::Serialize;
use std::ops::ControlFlow;
use std::path::PathBuf;
use std::time::{Duration, Instant};

/// `calib emulate`.
#[derive(Debug, Args)]
pub(crate) struct Emulate {
    /// Rig file: exciter, transducers, conditioners; default: the standard rig.
    #[arg(long, value_name = "FILE")]
    rig: Option<PathBuf>,
    /// Draws another device under test and another exciter, as `calib demo` does.
    #[arg(long, value_name = "N", conflicts_with = "rig")]
    seed: Option<u64>,
    /// TCP port on this computer, 0 for any free one.
    #[arg(long, value_name = "PORT", default_value_t = 5025)]
    tcp: u16,
    /// Uses a pseudo terminal, which looks like a serial port, instead of TCP.
    #[arg(long, conflicts_with = "tcp")]
    pty: bool,
    /// Uses the board's USB port instead of its serial line.
    #[arg(long)]
    usb: bool,
    /// Writes what crosses the USB into a capture for Wireshark.
    #[arg(long, value_name = "FILE.pcap", requires = "usb")]
    usb_pcap: Option<PathBuf>,
    /// Holds the button for the first minute: the calibration of the reference
    /// can be changed meanwhile.
    #[arg(long)]
    hold_button: bool,
    /// Keeps the record flash in this file, from one call to the next.
    #[arg(long, value_name = "FILE")]
    flash: Option<PathBuf>,
}

#[derive(Serialize, JsonSchema)]
pub(super) struct Listening {
    address: String,
}

impl Emulate {
    /// Runs the board at the pace of the wall until Ctrl-C.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let rig = self.rig()?;
        let flash = self.flash.as_deref().map(FlashFile::hold).transpose()?;
        let board = self.board(&rig, flash.as_ref())?;
        let usb = self.usb_port(&board)?;
        if self.hold_button {
            board.hold_button_once_up()?;
        }
        let door = self.door()?;
        let address = door.address();
        let listening = Listening {
            address: address.clone(),
        };
        // Whoever knows the address may switch it off.
        let stop = measure::stop_on_interrupt(context);
        context.print(&listening, || address.clone())?;
        context.remark(&format!(
            "an emulated calibrator listens; in another terminal: calib --device {address} info\n\
             Ctrl-C switches it off"
        ));
        let mut keeper = Keeper::of(flash.as_ref());
        let ended = serve(context, &board, usb.as_ref(), door, &mut keeper, &stop);
        keeper.kept?;
        if let Some(flash) = &flash {
            flash.keep(&board)?;
        }
        if let (Some(path), Some(usb)) = (&self.usb_pcap, &usb) {
            let mut content = Vec::new();
            // Writing into memory does not fail.
            let _ = capture::write(&usb.transferred(), &mut content);
            file::replace(path, &content)?;
        }
        ended
    }

    /// The USB port with its serial port opened, if it is to be used.
    fn usb_port(&self, board: &EmulatedBoard) -> Result<Option<UsbPort>> {
        if !self.usb {
            return Ok(None);
        }
        let port = board.emulator().usb().clone();
        if self.usb_pcap.is_some() {
            port.start_capture();
        }
        board.usb_link()?;
        Ok(Some(port))
    }

    fn rig(&self) -> Result<Rig> {
        match &self.rig {
            None => Ok(Rig::draw(self.seed.unwrap_or(0))),
            Some(path) => Ok(rig_file::load(path)?),
        }
    }

    fn board(&self, rig: &Rig, flash: Option<&FlashFile>) -> Result<EmulatedBoard> {
        let kept = flash.map(|flash| flash.power_on(rig)).transpose()?;
        match kept.flatten() {
            Some(board) => Ok(board),
            None => EmulatedBoard::power_on_calibrated(rig, self.seed),
        }
    }

    fn door(&self) -> Result<Box<dyn Door>> {
        if self.pty {
            return pseudo_terminal();
        }
        let door = TcpDoor::listen(self.tcp).map_err(|error| {
            Error::usage(
                format!("cannot listen on TCP port {}: {error}", self.tcp),
                "choose another port with --tcp PORT; 0 takes any free one",
            )
        })?;
        Ok(Box::new(door))
    }
}

/// How often the flash is looked at.
const LOOK: Duration = Duration::from_millis(250);

/// Writes the flash whenever it changed, so that a program that is killed leaves what was stored before.
struct Keeper<'a> {
    flash: Option<&'a FlashFile>,
    looked: Instant,
    /// Content of the file.
    content: Vec<u8>,
    /// How the last writing went.
    kept: Result<()>,
}

impl<'a> Keeper<'a> {
    fn of(flash: Option<&'a FlashFile>) -> Self {
        Self {
            flash,
            looked: Instant::now(),
            content: Vec::new(),
            kept: Ok(()),
        }
    }

    /// Looks, if it is time; false where the file cannot be written.
    fn look(&mut self, emulator: &mut Emulator) -> bool {
        let Some(flash) = self.flash.filter(|_| self.looked.elapsed() >= LOOK) else {
            return true;
        };
        self.looked = Instant::now();
        match emulator.record_flash() {
            Ok(content) if content != self.content => {
                self.kept = flash.write(&content);
                self.content = content;
            }
            // An emulator that fails says so itself.
            _ => {}
        }
        self.kept.is_ok()
    }
}

/// Runs the board until `stop` says so; a device that leaves the USB, as at a reset, is
/// set up again.
fn serve(
    context: &Context,
    board: &EmulatedBoard,
    usb: Option<&UsbPort>,
    door: Box<dyn Door>,
    keeper: &mut Keeper<'_>,
    stop: &dyn Fn() -> ControlFlow<()>,
) -> Result<()> {
    let mut behind = Duration::ZERO;
    let serial = board.emulator().serial().clone();
    let line: &dyn HostLine = usb.map_or(&serial, |usb| usb);
    let mut doors = [door];
    loop {
        let mut stopped = false;
        let ended = run_paced(&mut board.emulator(), line, &mut doors, |emulator, pace| {
            warn_if_behind(context, &mut behind, pace);
            stopped = stop().is_break() || !keeper.look(emulator);
            !stopped && usb.is_none_or(|usb| usb.pipe_error().is_none())
        });
        ended.map_err(|error| {
            Error::input("emulated board", error.to_string(), "start it once more")
        })?;
        if stopped {
            return Ok(());
        }
        board.usb_link()?;
    }
}

#[cfg(unix)]
fn pseudo_terminal() -> Result<Box<dyn Door>> {
    let door = calib_twin::runner::PtyDoor::open().map_err(|error| {
        Error::usage(
            format!("this system gives no pseudo terminal: {error}"),
            "use --tcp PORT",
        )
    })?;
    Ok(Box::new(door))
}

#[cfg(not(unix))]
fn pseudo_terminal() -> Result<Box<dyn Door>> {
    Err(Error::usage(
        "this system has no pseudo terminals",
        "use --tcp PORT",
    ))
}

/// Says when this computer cannot keep up, each time another second is lost.
fn warn_if_behind(context: &Context, behind: &mut Duration, pace: Pace) {
    if pace.lost > *behind + Duration::from_secs(1) {
        *behind = pace.lost;
        context.remark(&format!(
            "this computer is too slow: {:.0} s of {:.0} s lost",
            pace.lost.as_secs_f64(),
            pace.wall_time.as_secs_f64()
        ));
    }
}
