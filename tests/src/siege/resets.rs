//! Hosts that reset, leave or die in the middle of a download.

use super::fire::frame;
use super::{End, Siege, Toll};
use crate::rigged::Fault;
use calib_core::point::PointSpec;
use calib_core::point_state::PointState;
use calib_host::emulated::EmulatedUsbTransport;
use calib_link::Client;
use calib_protocol::message::Request;
use calib_twin::usb_host::{Enumerated, UsbHost};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use std::time::Duration;

/// Every so many resets a download is left alone and compared.
const WHOLE: u32 = 25;
/// Rate of the serial port of a computer.
const BAUD: u32 = 115_200;

/// How a host goes.
const WAYS: [Way; 6] = [
    Way::BusReset,
    Way::CableOut,
    Way::CableOutAfterPackets,
    Way::PortClosed,
    Way::Asleep,
    Way::SerialClosed,
];

#[derive(Clone, Copy, Debug)]
enum Way {
    /// Resets the bus and sets the device up again.
    BusReset,
    /// Pulls the cable some time after the question.
    CableOut,
    /// Pulls it after so many packets.
    CableOutAfterPackets,
    /// Stops reading, drops DTR, and comes back.
    PortClosed,
    /// Suspends the bus, wakes up and asks something else.
    Asleep,
    /// Closes the serial port; another program opens it.
    SerialClosed,
}

/// `count` resets in the middle of downloads while runs of `points` go on. `quiet` is the record of
/// the first of them without a reset.
///
/// # Errors
/// Promises that did not hold.
pub fn run(count: u32, points: &[PointSpec], quiet: &[u8]) -> Result<Toll, Fault> {
    let mut siege = Siege::begin(End::Serial, points)?;
    let host = UsbHost::new(siege.rigged.shared());
    let mut device = siege.replug()?;
    let mut random = ChaCha8Rng::seed_from_u64(1);
    loop {
        if siege.is_over()? {
            siege.judge(quiet)?;
            siege.expect_pass()?;
            if siege.toll.blows >= count {
                return Ok(siege.toll);
            }
            siege.start()?;
        }
        let way = WAYS[siege.toll.blows as usize % WAYS.len()];
        siege.toll.blows += 1;
        let done = siege.reset(way, &host, &mut device, &mut random);
        done.map_err(|fault| format!("reset {}, {way:?}: {fault}", siege.toll.blows))?;
        siege.ask(End::Serial)?;
        siege.ask(End::Usb)?;
        if siege.toll.blows.is_multiple_of(WHOLE) && siege.record(1)? != siege.first {
            return Err("a record came over as another".into());
        }
    }
}

fn below(end: u64, random: &mut ChaCha8Rng) -> u64 {
    random.next_u64() % end
}

impl Siege {
    /// Asks for a part of the record and goes before, while or after it comes.
    fn reset(
        &mut self,
        way: Way,
        host: &UsbHost,
        device: &mut Enumerated,
        random: &mut ChaCha8Rng,
    ) -> Result<(), Fault> {
        let offset = below(self.first.len() as u64, random) as u32;
        let question = frame(
            below(1 << 16, random) as u16,
            &Request::ReadRecord { id: 1, offset },
        );
        self.toll.bytes += question.len();
        // An answer of 1 kB takes the bus 1 ms and the serial line 90.
        let micros = Duration::from_micros(below(1500, random));
        if let Way::SerialClosed = way {
            return self.close_serial(&question, Duration::from_millis(20) + 50 * micros);
        }
        let port = self.port();
        if let Way::CableOutAfterPackets = way {
            port.pull_after(below(25, random) as u32);
        }
        port.send(&question);
        host.wait(micros)?;
        self.leave(way, host, device, micros)
    }

    /// Asks over the serial line, and throws away what came by `then`.
    fn close_serial(&mut self, question: &[u8], then: Duration) -> Result<(), Fault> {
        self.rigged.board().write_serial(question);
        self.rigged.client.wait(then)?;
        self.rigged.board().serial().clear();
        Ok(())
    }

    /// Goes, `micros` after the question, and comes back.
    fn leave(
        &mut self,
        way: Way,
        host: &UsbHost,
        device: &mut Enumerated,
        micros: Duration,
    ) -> Result<(), Fault> {
        let port = self.port();
        match way {
            Way::BusReset => {
                *device = host.enumerate()?;
                let _ = host.open_serial(device, BAUD)?;
            }
            Way::CableOut => {
                host.unplug();
                host.wait(10 * micros)?;
                *device = self.replug()?;
            }
            Way::CableOutAfterPackets => {
                host.wait(Duration::from_millis(5))?;
                host.unplug();
                *device = self.replug()?;
            }
            Way::PortClosed => {
                port.set_reading(false);
                host.set_ready(device, false)?;
                host.wait(100 * micros)?;
                port.set_reading(true);
                host.set_ready(device, true)?;
            }
            Way::Asleep => {
                port.suspend(true);
                host.wait(100 * micros)?;
                port.suspend(false);
                host.wait(Duration::from_millis(20))?;
            }
            Way::SerialClosed => {}
        }
        Ok(())
    }

    /// Plugs the cable in again; what the device says it is.
    fn replug(&mut self) -> Result<Enumerated, Fault> {
        let usb = EmulatedUsbTransport::plug_in(self.rigged.shared())?;
        let device = usb.device().clone();
        self.usb = Client::new(Box::new(usb));
        Ok(device)
    }

    /// Fails unless every point of the last run passed.
    fn expect_pass(&mut self) -> Result<(), Fault> {
        for index in 0..self.points.len() {
            let point = self.rigged.client.point(index as u16)?;
            if point.as_ref().map(|point| point.state) != Some(PointState::Valid) {
                return Err(format!("point {index}: {point:?}").into());
            }
        }
        Ok(())
    }
}
