//! A board with power: run it, look at it, and do to it what a person at the bench can.

use std::sync::{Arc, Mutex};
use std::time::Duration;

use rigless::image::Image;
use rigless::time::VirtualNanos;

use super::core_thread::CoreThread;
use super::memory::RECORD_FLASH_BYTES;
use super::passages::{Mark, Passages};
use super::{Error, Execution, Firmware, Log, memory};
use crate::board::usb::UsbPort;
use crate::board::{FlashWatch, Leds, PartFault, Pins, RECORD_FLASH, SerialLine};
use crate::rig_port::{DRIVE_MID_CODE, RigPort};

/// Longest virtual time of one step: the emulator's clock is 64 bit nanoseconds.
const FOREVER: Duration = Duration::from_secs(1 << 32);

/// An emulator several owners share: a test that presses the button, and the link it tests.
pub type SharedEmulator = Arc<Mutex<Emulator>>;

/// Something the firmware asked of the emulated part that no model answers for.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Gap(pub String);

/// An emulated board with power, running a firmware image on a rig.
///
/// Time stands still between calls. The same image, rig and calls give the same run.
pub struct Emulator {
    pub(super) core: CoreThread,
    pub(super) firmware: Firmware,
    pub(super) pins: Pins,
    pub(super) log: Log,
    pub(super) power_ons: u64,
    /// Virtual time at which the supply last came.
    pub(super) powered_at: Duration,
}

impl std::fmt::Debug for Emulator {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter
            .debug_struct("Emulator")
            .field("firmware", &self.firmware.path())
            .field("uptime", &self.uptime())
            .finish_non_exhaustive()
    }
}

impl Emulator {
    /// A new board, the one the image is for, with erased record flash, switched on: it stands before its first instruction.
    ///
    /// # Errors
    ///
    /// An image the board cannot run.
    pub fn power_on(firmware: &Firmware, rig: Box<dyn RigPort>) -> Result<Self, Error> {
        Self::power_on_with_flash(firmware, rig, &[0xFF; RECORD_FLASH_BYTES])
    }

    /// As [`Emulator::power_on`], with `flash` as content of the record flash.
    ///
    /// # Errors
    ///
    /// As there, and [`Error::FlashSize`].
    pub fn power_on_with_flash(
        firmware: &Firmware,
        rig: Box<dyn RigPort>,
        flash: &[u8],
    ) -> Result<Self, Error> {
        Self::assemble(Execution::asked(), firmware, rig, flash)
    }

    /// As [`Emulator::power_on`], executed as `execution` says.
    ///
    /// # Errors
    ///
    /// As there.
    pub fn power_on_as(
        execution: Execution,
        firmware: &Firmware,
        rig: Box<dyn RigPort>,
    ) -> Result<Self, Error> {
        Self::assemble(execution, firmware, rig, &[0xFF; RECORD_FLASH_BYTES])
    }

    fn assemble(
        execution: Execution,
        firmware: &Firmware,
        rig: Box<dyn RigPort>,
        flash: &[u8],
    ) -> Result<Self, Error> {
        let pins = firmware.pins(rig);
        let core = start(execution, firmware, &pins, flash)?;
        Ok(Self {
            core,
            firmware: firmware.clone(),
            pins,
            log: Log::default(),
            power_ons: 1,
            powered_at: Duration::ZERO,
        })
    }

    /// Runs for `duration` of virtual time.
    ///
    /// # Errors
    ///
    /// [`Error::Ended`] when the emulator fails.
    pub fn run_for(&mut self, duration: Duration) -> Result<(), Error> {
        let until = self.after(duration);
        self.run(until, false)
    }

    /// Runs until the board has sent something, at most for `limit`; answers whether it has.
    ///
    /// # Errors
    ///
    /// [`Error::Ended`] when the emulator fails.
    pub fn run_until_received(&mut self, limit: Duration) -> Result<bool, Error> {
        if !self.pins.serial.has_received() {
            let until = self.after(limit);
            self.run(until, true)?;
        }
        Ok(self.pins.serial.has_received())
    }

    /// Virtual time since power-on.
    #[must_use]
    pub fn uptime(&self) -> Duration {
        self.elapsed() - self.powered_at
    }

    /// Virtual time since the first power-on.
    #[must_use]
    pub fn elapsed(&self) -> Duration {
        Duration::from_nanos(self.core.stop().at.0)
    }

    /// Instructions executed since the first power-on.
    #[must_use]
    pub fn instructions(&self) -> u64 {
        self.core.stop().instruction_count
    }

    /// The serial line: any thread may send and receive on it.
    #[must_use]
    pub fn serial(&self) -> &SerialLine {
        &self.pins.serial
    }

    /// The USB connector.
    #[must_use]
    pub fn usb(&self) -> &UsbPort {
        &self.pins.usb
    }

    /// Queues `bytes` for the board.
    pub fn write_serial(&mut self, bytes: &[u8]) {
        self.pins.serial.send(bytes);
    }

    /// Takes what the board has sent since the last call.
    #[must_use]
    pub fn read_serial(&mut self) -> Vec<u8> {
        self.pins.serial.receive()
    }

    /// Log of the firmware since the first power-on.
    #[must_use]
    pub fn log(&self) -> &Log {
        &self.log
    }

    /// Which lamps are lit.
    ///
    /// # Errors
    ///
    /// [`Error::Ended`] when the emulator fails.
    pub fn leds(&mut self) -> Result<Leds, Error> {
        self.core.act(|session, _, _| session.board().part.leds())
    }

    /// Presses or releases the button.
    ///
    /// # Errors
    ///
    /// [`Error::Ended`] when the emulator fails.
    pub fn press_button(&mut self, pressed: bool) -> Result<(), Error> {
        self.core.act(move |session, _, stop| {
            session.board_mut().part.press_button(stop.at, pressed);
        })
    }

    /// Code on the drive output at this instant.
    #[must_use]
    pub fn drive_code(&self) -> u16 {
        self.pins.analog.drive_code()
    }

    /// Sample pairs the converters have taken.
    #[must_use]
    pub fn sample_pairs(&self) -> u64 {
        self.pins.analog.samples()
    }

    /// How long the drive output has been at mid-scale without interruption, `None` while it is not.
    #[must_use]
    pub fn silent_for(&self) -> Option<Duration> {
        let since = self.pins.analog.silent_since()?;
        debug_assert_eq!(self.pins.analog.drive_code(), DRIVE_MID_CODE);
        Some(self.elapsed().saturating_sub(Duration::from_nanos(since.0)))
    }

    /// Puts another rig on the connectors at this instant and hands the old one back.
    pub fn replace_rig(&mut self, rig: Box<dyn RigPort>) -> Box<dyn RigPort> {
        self.pins.analog.advance(self.core.stop().at);
        self.pins.analog.replace_rig(rig)
    }

    /// Pulls the reset pin: memory stays, the part starts afresh.
    ///
    /// # Errors
    ///
    /// [`Error::Ended`] when the emulator fails.
    pub fn reset(&mut self) -> Result<(), Error> {
        self.core.act(|session, host, stop| {
            session.reset_by_pin(stop.at, stop.instruction_count, host);
        })
    }

    /// Lets something fail in the part at this instant.
    ///
    /// # Errors
    ///
    /// [`Error::Ended`] when the emulator fails.
    pub fn fail(&mut self, fault: PartFault) -> Result<(), Error> {
        self.core
            .act(move |session, _, stop| session.board_mut().part.fail(stop.at, fault))
    }

    /// Makes whole what [`Emulator::fail`] broke for good; a converter and a clock answer from the next
    /// start on.
    ///
    /// # Errors
    ///
    /// [`Error::Ended`] when the emulator fails.
    pub fn mend(&mut self) -> Result<(), Error> {
        self.core
            .act(|session, _, _| session.board_mut().part.mend())
    }

    /// Changes halfwords of code or of the vector table where they lie in flash, as a fault of the
    /// memory would, and hands back what was there.
    ///
    /// # Errors
    ///
    /// [`Error::Ended`] when the emulator fails or there is no flash at `address`.
    pub fn patch(&mut self, address: u64, halfwords: &[u16]) -> Result<Vec<u16>, Error> {
        let new = halfwords.to_vec();
        self.core
            .act(move |_, host, _| memory::patch(host, address, &new))?
            .map_err(|error| Error::Ended(error.to_string()))
    }

    /// Puts `bytes` into flash at `address`, a multiple of 8, as a debug probe on the bench does.
    ///
    /// # Errors
    ///
    /// [`Error::Ended`] when the emulator fails or there is no flash at `address`.
    pub fn load_flash(&mut self, address: u64, bytes: &[u8]) -> Result<(), Error> {
        let mut bytes = bytes.to_vec();
        bytes.resize(bytes.len().next_multiple_of(8), 0xFF);
        self.core
            .act(move |_, host, _| memory::program(host, address, &bytes))?
            .map_err(|error| Error::Ended(error.to_string()))
    }

    /// Address of a function or variable of the image.
    ///
    /// # Errors
    ///
    /// [`Error::NoSymbol`] when the image has no such name.
    pub fn symbol(&self, name: &str) -> Result<u64, Error> {
        self.firmware.symbol(name)
    }

    /// Operations on the record flash, and the wear of its sectors.
    #[must_use]
    pub fn flash_watch(&self) -> &FlashWatch {
        &self.pins.flash
    }

    /// Content of the record flash (bank 2).
    ///
    /// # Errors
    ///
    /// [`Error::Ended`] when the emulator fails.
    pub fn record_flash(&mut self) -> Result<Vec<u8>, Error> {
        self.core
            .act(|_, host, _| memory::read(host, RECORD_FLASH, RECORD_FLASH_BYTES))?
            .map_err(|error| Error::Ended(error.to_string()))
    }

    /// Restarts since the first power-on, with their cause, oldest first: a watchdog's reads
    /// `Model("IWDG")`, a supply that came back `PowerOn`.
    ///
    /// # Errors
    ///
    /// [`Error::Ended`] when the emulator fails.
    pub fn resets(&mut self) -> Result<Vec<String>, Error> {
        self.core.act(|session, _, _| {
            let resets = session.resets().iter();
            resets.map(|reset| format!("{:?}", reset.cause)).collect()
        })
    }

    /// Everything the firmware asked for since power-on that no model answers for.
    ///
    /// # Errors
    ///
    /// [`Error::Ended`] when the emulator fails.
    pub fn gaps(&mut self) -> Result<Vec<Gap>, Error> {
        self.core.act(|session, _, _| {
            let unmapped = session.unmapped();
            let unmapped = unmapped.iter().map(|gap| format!("unmapped: {gap:x?}"));
            let refused = session.refused().iter();
            let refused = refused.map(|(at, fault)| format!("refused at {at:#x}: {fault}"));
            let stored = session.unimplemented().iter();
            let stored = stored.map(|(at, gap)| format!("stored only at {at:#x}: {gap:x?}"));
            let part = &session.board().part;
            let told = session.told().filter(|told| !part.explains(told));
            let told =
                told.map(|told| format!("{}.{}: {}", told.instance, told.register, told.reason));
            let unrouted = session.unrouted().iter();
            let unrouted = unrouted.map(|gap| format!("interrupt without a line: {gap:?}"));
            unmapped
                .chain(refused)
                .chain(stored)
                .chain(told)
                .chain(unrouted)
                .map(Gap)
                .collect()
        })
    }

    /// Runs for `duration` and looks at the way of the program from each time it is at `from` to the
    /// next time it is at `to`. Interrupts taken on the way count as part of it.
    ///
    /// # Errors
    ///
    /// [`Error::Ended`] when the emulator fails.
    pub fn watch_passages(
        &mut self,
        from: Mark,
        to: Mark,
        duration: Duration,
    ) -> Result<Passages, Error> {
        let watches = [from, to].map(Mark::watch);
        self.core.act(move |session, host, _| {
            watches.into_iter().for_each(|watch| session.watch(watch));
            session.settle_watches(host);
        })?;
        self.core.hits().for_each(drop);
        let ran = self.run_for(duration);
        let mut passages = Passages::default();
        for hit in self.core.hits() {
            if from.is_hit(&hit) {
                passages.enter(&hit);
            } else if to.is_hit(&hit) {
                passages.leave(&hit);
            }
        }
        self.core.act(move |session, host, _| {
            watches.into_iter().for_each(|watch| session.unwatch(watch));
            session.settle_watches(host);
        })?;
        ran.map(|()| passages)
    }

    /// Reads `length` bytes of the board's memory.
    ///
    /// # Errors
    ///
    /// [`Error::Ended`] when the emulator fails or nothing is at `address`.
    pub fn read_memory(&mut self, address: u64, length: usize) -> Result<Vec<u8>, Error> {
        self.core
            .act(move |_, host, _| memory::read(host, address, length))?
            .map_err(|error| Error::Ended(error.to_string()))
    }

    /// Fills `length` bytes of the board's RAM with `byte`, as a debugger does.
    ///
    /// # Errors
    ///
    /// [`Error::Ended`] when the emulator fails or nothing is at `address`.
    pub fn fill_memory(&mut self, address: u64, length: usize, byte: u8) -> Result<(), Error> {
        self.core
            .act(move |_, host, _| memory::fill(host, address, length, byte))?
            .map_err(|error| Error::Ended(error.to_string()))
    }

    fn after(&self, duration: Duration) -> VirtualNanos {
        let until = self.elapsed() + duration.min(FOREVER);
        VirtualNanos(until.as_nanos() as u64)
    }

    fn run(&mut self, until: VirtualNanos, wake: bool) -> Result<(), Error> {
        self.core.run(until, wake)?;
        for logged in self.core.logged() {
            self.log.bytes.extend(logged.bytes);
        }
        Ok(())
    }
}

/// Builds the board and starts its core.
fn start(
    execution: Execution,
    firmware: &Firmware,
    pins: &Pins,
    flash: &[u8],
) -> Result<CoreThread, Error> {
    if flash.len() != RECORD_FLASH_BYTES {
        return Err(Error::FlashSize {
            expected: RECORD_FLASH_BYTES,
            found: flash.len(),
        });
    }
    let ended = |error: &dyn std::fmt::Display| Error::Ended(error.to_string());
    let name = std::path::Path::new("record flash");
    let records = Image::new(name, flash.to_vec(), Some(RECORD_FLASH));
    let records = records.map_err(|error| ended(&error))?;
    let mut core = CoreThread::start(execution, firmware, records, pins)?;
    let buffer = pins.write_buffer.clone();
    core.act(move |_, host, _| {
        let scrambled = memory::scramble(host, 0);
        memory::note_kept(host, &buffer);
        scrambled
    })?
    .map_err(|error| ended(&error))?;
    Ok(core)
}
