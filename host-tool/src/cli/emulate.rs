//! `calib emulate`: an emulated calibrator that other programs use like hardware.

use super::{Context, run};
use calib_host::emulated::EmulatedBoard;
use calib_host::{Error, Result};
use calib_twin::rig::Rig;
use calib_twin::runner::{Door, PtyDoor, TcpDoor, run_paced};
use clap::Args;
use serde::Serialize;
use std::path::PathBuf;

/// `calib emulate`.
#[derive(Debug, Args)]
pub(crate) struct Emulate {
    /// Rig file; without it the rig of the demo.
    #[arg(long, value_name = "FILE")]
    rig: Option<PathBuf>,
    /// TCP port on this computer, 0 for any free one.
    #[arg(long, value_name = "PORT", default_value_t = 5025)]
    tcp: u16,
    /// A pseudo terminal instead, as a serial port would look.
    #[arg(long, conflicts_with = "tcp")]
    pty: bool,
}

#[derive(Serialize)]
struct Listening {
    address: String,
}

impl Emulate {
    /// Runs the board at the pace of the wall until it is interrupted.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let rig = match &self.rig {
            Some(path) => Rig::load(path).map_err(|error| {
                Error::input(
                    path.display().to_string(),
                    error.to_string(),
                    "twin/rigs/default.toml is an example with all keys",
                )
            })?,
            None => Rig::standard(),
        };
        let door = self.door()?;
        let board = EmulatedBoard::power_on(&rig)?;
        let address = door.address();
        context.print(
            &Listening {
                address: address.clone(),
            },
            || address.clone(),
        )?;
        context.remark(&format!(
            "an emulated calibrator listens; in another terminal: calib --device {address} info\n\
             Ctrl-C switches it off"
        ));
        let stop = run::stop_on_interrupt();
        let mut emulator = board.emulator();
        let paced = run_paced(&mut emulator, &mut [door], |_, _| stop().is_continue());
        let pace = paced
            .map_err(|error| Error::input("emulated board", error.to_string(), "start it again"))?;
        if !pace.lost.is_zero() {
            context.remark(&format!(
                "this computer was too slow for {:.1} s of {:.1} s",
                pace.lost.as_secs_f64(),
                pace.wall_time.as_secs_f64()
            ));
        }
        Ok(())
    }

    fn door(&self) -> Result<Box<dyn Door>> {
        let refused = |what: String, error: std::io::Error| Error::Usage {
            problem: format!("cannot open {what}: {error}"),
            hint: "choose another port with --tcp PORT; 0 takes any free one".to_owned(),
        };
        if self.pty {
            let door =
                PtyDoor::open().map_err(|error| refused("a pseudo terminal".into(), error))?;
            return Ok(Box::new(door));
        }
        let door = TcpDoor::listen(self.tcp)
            .map_err(|error| refused(format!("TCP port {}", self.tcp), error))?;
        Ok(Box::new(door))
    }
}
