//! Where the core answers in the address map, and how it lives in virtual time.

use std::num::NonZeroU64;

use rigless::device::{DeviceContext, ErasedDevice, Level, RegisterFile, RequestChange};
use rigless::soc::{Bus, Error, Gate, RegisterSpec, Width, Window};
use rigless::time::{EventId, VirtualNanos};

use super::UsbPort;
use super::bus::SLOT_NS;

/// OTG FS, which the vendor's file calls the second high-speed core.
const BASE: u64 = 0x4008_0000;
const SIZE: NonZeroU64 = NonZeroU64::new(0x4_0000).expect("not zero");
/// `OTG_FS` (RM0433 Rev 9, table 147).
const LINES: &[u16] = &[101];
const GLOBAL_LINE: usize = 0;

/// The core on the bus of the part.
#[derive(Debug)]
pub(crate) struct UsbWindow {
    port: UsbPort,
    layout: &'static [RegisterSpec],
    /// Level last driven on the interrupt line.
    line: bool,
    slot: Option<EventId>,
}

rigless::store!(UsbWindow {
    values: [line, slot],
    parts: [port],
    built: [layout],
});

impl UsbWindow {
    /// Adds the window to `bus`; its slot and its model.
    pub(crate) fn add_to(bus: &mut Bus, port: UsbPort) -> Result<(usize, Self), Error> {
        let clock = Gate::by("RCC", "AHB1ENR", "USB2OTGHSEN");
        let window = Window::new("OTG_FS", BASE, SIZE)
            .gated(clock)
            .raising(LINES);
        let slot = bus.add_window(window)?;
        let model = Self {
            port,
            layout: bus.slots()[slot].peripheral().registers,
            line: false,
            slot: None,
        };
        Ok((slot, model))
    }

    /// Drives what has changed: the interrupt line, and the next slot of the bus.
    fn settle(&mut self, context: &mut DeviceContext<'_>) {
        let usb = self.port.lock();
        let level = usb.controller.interrupt();
        if level != self.line {
            self.line = level;
            context.interrupt(GLOBAL_LINE, Level::from(level));
        }
        if self.slot.is_none() && usb.bus.wants_slot(&usb.controller) {
            let next = (context.now().0 / SLOT_NS + 1) * SLOT_NS;
            self.slot = Some(context.schedule(VirtualNanos(next)));
        }
    }
}

impl ErasedDevice for UsbWindow {
    fn layout(&self) -> &'static [RegisterSpec] {
        self.layout
    }

    fn read(
        &mut self,
        _row: usize,
        _registers: &mut RegisterFile,
        _context: &mut DeviceContext<'_>,
    ) -> Option<u64> {
        None
    }

    fn write(
        &mut self,
        _row: usize,
        _value: u64,
        _registers: &mut RegisterFile,
        _context: &mut DeviceContext<'_>,
    ) {
    }

    fn read_window(&mut self, offset: u64, width: Width, context: &mut DeviceContext<'_>) -> u64 {
        let word = self
            .port
            .lock()
            .controller
            .read(offset & !0b11, context.now().0);
        self.settle(context);
        (u64::from(word) >> (8 * (offset & 0b11))) & width.mask()
    }

    fn write_window(
        &mut self,
        offset: u64,
        width: Width,
        value: u64,
        context: &mut DeviceContext<'_>,
    ) {
        if width == Width::W32 {
            self.port.lock().controller.write(offset, value as u32);
        } else {
            context.tell("OTG_FS", "only words are written to the core");
        }
        self.settle(context);
    }

    fn on_event(
        &mut self,
        event: EventId,
        _registers: &mut RegisterFile,
        context: &mut DeviceContext<'_>,
    ) {
        if self.slot != Some(event) {
            return;
        }
        self.slot = None;
        self.port.lock().use_slot(context.now().0);
        self.settle(context);
    }

    fn on_request(
        &mut self,
        _request: RequestChange,
        _registers: &mut RegisterFile,
        _context: &mut DeviceContext<'_>,
    ) {
    }

    fn on_clock(
        &mut self,
        _hz: u64,
        _registers: &mut RegisterFile,
        _context: &mut DeviceContext<'_>,
    ) {
    }

    fn on_access(
        &mut self,
        _token: u64,
        _value: u64,
        _registers: &mut RegisterFile,
        _context: &mut DeviceContext<'_>,
    ) {
    }

    fn on_refused(
        &mut self,
        _token: u64,
        _registers: &mut RegisterFile,
        _context: &mut DeviceContext<'_>,
    ) {
    }

    /// The host may have plugged, reset or queued something since.
    fn poll(&mut self, _registers: &mut RegisterFile, context: &mut DeviceContext<'_>) {
        self.settle(context);
    }

    fn reset(&mut self) {
        self.port.part_reset();
        self.line = false;
        self.slot = None;
    }
}
