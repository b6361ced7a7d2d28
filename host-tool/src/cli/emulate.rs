//! `calib emulate`: an emulated calibrator that other programs use like hardware.

use super::{Context, run};
use calib_host::emulated::EmulatedBoard;
use calib_host::{Error, Result, file};
use calib_twin::rig::Rig;
use calib_twin::runner::{Door, Pace, TcpDoor, run_paced};
use clap::Args;
use serde::Serialize;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::time::Duration;

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
    /// A pseudo terminal instead, as a serial port would look.
    #[arg(long, conflicts_with = "tcp")]
    pty: bool,
    /// Keeps the record flash in this file from one call to the next.
    #[arg(long, value_name = "FILE")]
    flash: Option<PathBuf>,
}

#[derive(Serialize)]
struct Listening {
    address: String,
}

impl Emulate {
    /// Runs the board at the pace of the wall until Ctrl-C.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let rig = self.rig()?;
        let board = self.board(&rig)?;
        let door = self.door()?;
        let address = door.address();
        let listening = Listening {
            address: address.clone(),
        };
        context.print(&listening, || address.clone())?;
        context.remark(&format!(
            "an emulated calibrator listens; in another terminal: calib --device {address} info\n\
             Ctrl-C switches it off"
        ));
        let stop = run::stop_on_interrupt();
        let mut behind = Duration::ZERO;
        let ended = run_paced(&mut board.emulator(), &mut [door], |_, pace| {
            warn_if_behind(context, &mut behind, pace);
            stop().is_continue()
        });
        if let Some(path) = &self.flash {
            file::replace(path, &board.record_flash()?)?;
        }
        ended.map_err(|error| {
            Error::input("emulated board", error.to_string(), "start it once more")
        })?;
        Ok(())
    }

    fn rig(&self) -> Result<Rig> {
        match &self.rig {
            None => Ok(Rig::draw(self.seed.unwrap_or(0))),
            Some(path) => Rig::load(path).map_err(|error| {
                Error::input("rig", error.to_string(), "docs/twin.md lists the values")
            }),
        }
    }

    fn board(&self, rig: &Rig) -> Result<EmulatedBoard> {
        let kept = match &self.flash {
            None => None,
            Some(path) => read_if_there(path)?,
        };
        match kept {
            Some(flash) => EmulatedBoard::power_on_with_flash(rig, &flash),
            None => EmulatedBoard::power_on_calibrated(rig, self.seed),
        }
    }

    fn door(&self) -> Result<Box<dyn Door>> {
        if self.pty {
            return pseudo_terminal();
        }
        let door = TcpDoor::listen(self.tcp).map_err(|error| Error::Usage {
            problem: format!("cannot listen on TCP port {}: {error}", self.tcp),
            hint: "choose another port with --tcp PORT; 0 takes any free one".to_owned(),
        })?;
        Ok(Box::new(door))
    }
}

#[cfg(unix)]
fn pseudo_terminal() -> Result<Box<dyn Door>> {
    let door = calib_twin::runner::PtyDoor::open().map_err(|error| Error::Usage {
        problem: format!("this system gives no pseudo terminal: {error}"),
        hint: "use --tcp PORT".to_owned(),
    })?;
    Ok(Box::new(door))
}

#[cfg(not(unix))]
fn pseudo_terminal() -> Result<Box<dyn Door>> {
    Err(Error::Usage {
        problem: "this system has no pseudo terminals".to_owned(),
        hint: "use --tcp PORT".to_owned(),
    })
}

fn read_if_there(path: &Path) -> Result<Option<Vec<u8>>> {
    match std::fs::read(path) {
        Ok(content) => Ok(Some(content)),
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(None),
        Err(error) => Err(Error::file("read", path, error)),
    }
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
