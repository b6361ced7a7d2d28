//! Attacks with bytes.

use super::fire::{Ammunition, frame};
use super::two_hosts::TwoHosts;
use super::{End, Siege, Toll};
use crate::rigged::Fault;
use calib_core::point::PointSpec;
use calib_protocol::frame::SERIAL_BAUD;
use calib_protocol::message::Request;
use std::time::Duration;

/// Rate of a host that has set its port wrong.
const OTHER_BAUD: u32 = 3_000_000;
/// Bytes kept queued for a USB port that is to have no pause: 16 ms of the bus.
const USB_QUEUE: usize = 20_000;
/// Time after a damaged byte from which requests are heard again (docs/protocol.md): 2 ms, and the
/// evaluation of a block, which is over when the next one comes, 10 ms later.
pub const AFTER_DAMAGE: Duration = Duration::from_millis(12);
/// Every so many blows the attack pauses, and the attacked link is asked something.
const PAUSE: u32 = 10;

/// Attack on the calibrator while it measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Assault {
    /// Frames at 3 Mbaud without a pause on the serial line, whose receiver is at 115 200.
    OtherRate,
    /// Requests without a pause on the serial line.
    Requests,
    /// A frame that never ends on the serial line.
    EndlessFrame,
    /// A line of text that never ends on the serial line.
    EndlessLine,
    /// Frames at the full speed of the USB without a pause.
    UsbFrames,
    /// A frame that never ends at the full speed of the USB.
    UsbEndless,
    /// Both hosts ask at once, all the time.
    TwoHosts,
}

impl Assault {
    /// All of them.
    pub const ALL: [Self; 7] = [
        Self::OtherRate,
        Self::Requests,
        Self::EndlessFrame,
        Self::EndlessLine,
        Self::UsbFrames,
        Self::UsbEndless,
        Self::TwoHosts,
    ];

    /// In words.
    pub fn name(self) -> &'static str {
        match self {
            Self::OtherRate => "serial: frames at 3 Mbaud without a pause",
            Self::Requests => "serial: requests without a pause",
            Self::EndlessFrame => "serial: a frame that never ends",
            Self::EndlessLine => "serial: a line that never ends",
            Self::UsbFrames => "USB: frames at full speed without a pause",
            Self::UsbEndless => "USB: a frame that never ends, full speed",
            Self::TwoHosts => "both: two hosts ask at once",
        }
    }

    /// The link that holds the session: the other one is attacked.
    pub fn holder(self) -> End {
        match self {
            Self::UsbFrames | Self::UsbEndless | Self::TwoHosts => End::Serial,
            _ => End::Usb,
        }
    }
}

/// Attacks for the length of a run; what it has come to. `quiet` is the record of the same run
/// without an attack.
///
/// # Errors
/// Promises that did not hold.
pub fn run(assault: Assault, points: &[PointSpec], quiet: &[u8]) -> Result<Toll, Fault> {
    let mut siege = Siege::begin(assault.holder(), points)?;
    let mut fire = Ammunition::new(5);
    let mut hosts = TwoHosts::default();
    while !siege.is_over()? {
        siege.toll.blows += 1;
        match assault {
            Assault::OtherRate => siege.other_rate(&mut fire)?,
            Assault::Requests => siege.requests()?,
            Assault::EndlessFrame => siege.endless(0x55)?,
            Assault::EndlessLine => siege.endless(b'A')?,
            Assault::UsbFrames => siege.usb(|| fire.no_stop(USB_QUEUE))?,
            Assault::UsbEndless => siege.usb(|| vec![0x55; USB_QUEUE])?,
            Assault::TwoHosts => hosts.ask_at_once(&mut siege)?,
        }
    }
    siege.pause()?;
    siege.judge(quiet)?;
    if assault == Assault::TwoHosts {
        hosts.race(&mut siege)?;
    }
    Ok(siege.toll)
}

impl Siege {
    /// 100 ms of the line, heard at another rate.
    fn other_rate(&mut self, fire: &mut Ammunition) -> Result<(), Fault> {
        let bytes = fire.no_stop(OTHER_BAUD as usize / 10 / 10);
        self.toll.bytes += bytes.len();
        let line = self.rigged.board().serial().clone();
        line.send_at(&bytes, OTHER_BAUD, SERIAL_BAUD);
        self.ask_while_sending()?;
        self.rigged.client.wait(AFTER_DAMAGE)?;
        let answers = self.rigged.board().read_serial();
        if !answers.is_empty() {
            return Err(format!("noise was answered: {answers:x?}").into());
        }
        self.ask(End::Serial)
    }

    /// 90 ms of questions whose answers take the line ten times as long: what the receiver has no
    /// room for is lost.
    fn requests(&mut self) -> Result<(), Fault> {
        let bytes: Vec<u8> = (0..90).flat_map(|n| frame(n, &Request::Info)).collect();
        self.toll.bytes += bytes.len();
        self.rigged.board().write_serial(&bytes);
        self.ask_while_sending()?;
        let _ = self.rigged.board().read_serial();
        match self.toll.blows.is_multiple_of(PAUSE) {
            true => self.pause(),
            false => Ok(()),
        }
    }

    /// 87 ms of a byte that ends nothing.
    fn endless(&mut self, byte: u8) -> Result<(), Fault> {
        let bytes = [byte; 1000];
        self.toll.bytes += bytes.len();
        self.rigged.board().write_serial(&bytes);
        self.ask_while_sending()?;
        match self.toll.blows.is_multiple_of(PAUSE) {
            true => self.ask(End::Serial),
            false => Ok(()),
        }
    }

    /// 50 ms of the bus, its queue never empty.
    fn usb(&mut self, mut more: impl FnMut() -> Vec<u8>) -> Result<(), Fault> {
        let port = self.port();
        for _ in 0..5 {
            while port.waiting() < USB_QUEUE {
                let bytes = more();
                self.toll.bytes += bytes.len();
                port.send(&bytes);
            }
            self.rigged.client.wait(Duration::from_millis(10))?;
            let _ = port.receive();
        }
        self.ask(End::Serial)?;
        match self.toll.blows.is_multiple_of(PAUSE) {
            true => self.pause(),
            false => Ok(()),
        }
    }

    /// Asks over USB until the serial line has had all that was queued.
    fn ask_while_sending(&mut self) -> Result<(), Fault> {
        while self.rigged.board().serial().is_sending() {
            self.ask(End::Usb)?;
            self.rigged.client.wait(Duration::from_millis(10))?;
        }
        Ok(())
    }

    /// Lets both links take and answer what is on its way, and asks each something.
    fn pause(&mut self) -> Result<(), Fault> {
        let port = self.port();
        let mut quiet = 0;
        while quiet < 3 {
            self.rigged.client.wait(Duration::from_millis(20))?;
            let heard = self.rigged.board().read_serial().len() + port.receive().len();
            let busy = heard > 0 || port.waiting() > 0 || self.rigged.board().serial().is_sending();
            quiet = if busy { 0 } else { quiet + 1 };
        }
        self.ask(End::Serial)?;
        self.ask(End::Usb)
    }
}
