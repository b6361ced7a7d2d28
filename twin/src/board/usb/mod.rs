//! USB OTG FS in device mode, and the cable to a host.
//!
//! RM0433 Rev 9, chapter 57, in slave mode as the firmware's driver uses it: FIFOs filled and emptied
//! by the core, receive status queue, endpoints with NAK, stall and data toggle, bus reset,
//! enumeration done, suspend, resume and VBUS sensing.
//!
//! | File | What |
//! |---|---|
//! | `registers` | offsets and bits |
//! | `endpoint` | one endpoint, in or out |
//! | `controller` | the device core: registers on one side, the bus on the other |
//! | `transfer` | a control transfer, transaction by transaction |
//! | `bus` | the host's end of the cable: what is transferred when |
//! | `window` | where the core answers in the address map |
//!
//! The host's end moves one transaction per slot of a full-speed bus and asks an endpoint only when
//! it has an answer: a real host's endless polling with NAK as the answer costs events and changes
//! nothing. Left out: isochronous endpoints, DMA, host mode, link power management, bit errors.
//!
//! Reception does not look at `EPENA`: the driver sets it once and re-arms by `CNAK` alone, and a
//! control endpoint's is never set, which hardware in slave mode accepts.

mod bus;
mod controller;
mod endpoint;
mod registers;
mod transfer;
mod window;

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

pub use bus::{Pipes, Transferred};
pub use transfer::{Setup, UsbError};
pub(super) use window::UsbWindow;

use rigless::snapshot::{self, Reader, Store, Writer};

use bus::Bus;
use controller::Controller;

/// The core and the host's end of its cable.
#[derive(Debug, Default)]
struct Usb {
    controller: Controller,
    bus: Bus,
    /// The host has changed something the board has not looked at.
    news: bool,
}

impl Usb {
    fn plug(&mut self, plugged: bool) {
        self.controller.vbus(plugged);
        if !plugged {
            self.bus.unplugged();
        }
    }

    /// One slot of the bus.
    fn use_slot(&mut self, now_ns: u64) {
        self.bus.use_slot(&mut self.controller, now_ns);
        match &mut self.bus.pull_after {
            Some(0) => {
                self.bus.pull_after = None;
                self.plug(false);
            }
            Some(left) => *left -= 1,
            None => {}
        }
    }
}

/// A handle of the USB port: the board holds one, a host holds others.
#[derive(Debug, Clone, Default)]
pub struct UsbPort(Arc<Mutex<Usb>>);

/// A run is kept with its cable out: what is under way on a bus belongs to the host as well.
impl Store for UsbPort {
    fn store(&self, to: &mut Writer) -> Result<(), snapshot::Error> {
        let usb = self.lock();
        match usb.controller.has_vbus() {
            true => Err(snapshot::Error::Unsaved("a USB port with its cable in")),
            false => to.put(&usb.controller),
        }
    }

    fn load(&mut self, from: &mut Reader) -> Result<(), snapshot::Error> {
        *self.lock() = Usb {
            controller: from.take()?,
            ..Usb::default()
        };
        Ok(())
    }
}

impl UsbPort {
    /// Plugs the cable in or pulls it out: VBUS comes or goes.
    pub fn plug(&self, plugged: bool) {
        self.change().plug(plugged);
    }

    /// Pulls the cable out after so many more transactions, as a user does: in the middle of anything.
    pub fn pull_after(&self, transactions: u32) {
        self.lock().bus.pull_after = Some(transactions);
    }

    /// Whether the cable is in. A pull still to come does not count.
    #[must_use]
    pub fn is_plugged(&self) -> bool {
        self.lock().controller.has_vbus()
    }

    /// Whether the device shows itself on the bus: VBUS is there and its pull-up is on.
    #[must_use]
    pub fn device_present(&self) -> bool {
        self.lock().controller.connected()
    }

    /// Drives a reset on the bus until [`UsbPort::end_reset`].
    pub fn begin_reset(&self) {
        let mut usb = self.change();
        usb.bus.close_pipes();
        usb.controller.begin_reset();
    }

    /// Ends a bus reset; the device finds the bus at full speed.
    pub fn end_reset(&self) {
        self.change().controller.end_reset();
    }

    /// Stops all traffic, which suspends the device, or resumes it.
    pub fn suspend(&self, suspended: bool) {
        let mut usb = self.change();
        usb.controller.suspend(suspended);
        usb.bus.suspended = suspended;
    }

    /// Starts a control transfer with the device at `address`; [`UsbPort::control_result`] has its
    /// outcome once enough virtual time has passed.
    pub fn start_control(&self, address: u8, setup: Setup, data: Vec<u8>) {
        self.change().bus.start_control(address, setup, data);
    }

    /// The data and outcome of the last control transfer, once.
    #[must_use]
    pub fn control_result(&self) -> Option<Result<Vec<u8>, UsbError>> {
        self.lock().bus.take_result()
    }

    /// Opens the bulk pipes of a configured device.
    pub fn open_pipes(&self, pipes: Pipes) {
        self.change().bus.open_pipes(pipes);
    }

    /// Queues `bytes` for the device's bulk endpoint.
    pub fn send(&self, bytes: &[u8]) {
        self.change().bus.outgoing.extend(bytes);
    }

    /// Bytes that still wait for the device.
    #[must_use]
    pub fn waiting(&self) -> usize {
        self.lock().bus.outgoing.len()
    }

    /// Takes what the device has sent.
    #[must_use]
    pub fn receive(&self) -> Vec<u8> {
        self.lock().bus.incoming.drain(..).collect()
    }

    /// Whether the device has sent something not yet taken.
    #[must_use]
    pub fn has_received(&self) -> bool {
        !self.lock().bus.incoming.is_empty()
    }

    /// Whether the host asks the device for data: one that opens the port and never reads does not.
    pub fn set_reading(&self, reading: bool) {
        self.change().bus.reading = reading;
    }

    /// Loses one of `every` handshakes of the bulk pipes, as a disturbed line does: the packet is sent
    /// again, and its receiver must drop the repetition. 0 loses none.
    pub fn lose_handshakes(&self, every: u32) {
        self.change().bus.lost_handshake = every;
    }

    /// Why the bulk pipes ended, if they did.
    #[must_use]
    pub fn pipe_error(&self) -> Option<UsbError> {
        self.lock().bus.pipe_error
    }

    /// Begins to keep what is transferred, for [`UsbPort::transferred`].
    pub fn start_capture(&self) {
        self.lock().bus.capture.get_or_insert_default();
    }

    /// Everything transferred since the last call or the start of the capture, oldest first.
    #[must_use]
    pub fn transferred(&self) -> Vec<Transferred> {
        let mut usb = self.lock();
        usb.bus
            .capture
            .as_mut()
            .map(std::mem::take)
            .unwrap_or_default()
    }

    /// The part has lost its state: the core is as after reset, the cable stays.
    pub(super) fn part_reset(&self) {
        let mut usb = self.lock();
        let vbus = usb.controller.has_vbus();
        usb.controller = Controller::default();
        usb.controller.vbus(vbus);
        usb.bus.device_gone();
    }

    /// Whether the host has changed something since the last call.
    pub(super) fn has_news(&self) -> bool {
        std::mem::take(&mut self.lock().news)
    }

    /// The port, to change it from the host's side.
    fn change(&self) -> MutexGuard<'_, Usb> {
        let mut usb = self.lock();
        usb.news = true;
        usb
    }

    fn lock(&self) -> MutexGuard<'_, Usb> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
