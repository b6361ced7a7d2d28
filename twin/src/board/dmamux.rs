//! DMAMUX1, the request multiplexer in front of both DMA controllers, with what this board uses.
//!
//! RM0433 Rev 9, chapter 17: each channel's output follows the request line its `DMAREQ_ID` selects.
//! Only the lines in [`LINES`] exist. Synchronisation, request generators and the second controller are
//! left out, and told to the run when a firmware asks for them; events have no listener.
//!
//! The converters set their lines themselves ([`RequestLines`]); those of the emulator's peripherals
//! come over its bus.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use rigless::device::{Device, DeviceContext, Level, RegisterFile, RequestChange};
use rigless::snapshot::{self, Reader, Store, Writer};
use rigless::soc::Layout;
use rigless::soc::stm32h743::generated::dmamux1::{Register, dmamux_c0cr};
use rigless::soc::stm32h743::peripherals::usart::{RECEIVE_REQUEST, TRANSMIT_REQUEST};

use super::dac;

/// The instance's name, as listeners see it.
pub(super) const NAME: &str = "DMAMUX1";
const CHANNELS: usize = 16;
/// Channels of the first controller. The second is not wired: each listener costs speed.
const DMA1_STREAMS: usize = 8;

/// `DMAREQ_ID` of the lines the converters set (RM0433 Rev 9, table 124). The two input converters'
/// line is driven by their common block: in dual mode the pair has one.
pub(super) const ADC1: usize = 9;
pub(super) const DAC_CHANNELS: [usize; 2] = [67, 68];

/// Request lines that come over the bus, by instance, its own numbering, and `DMAREQ_ID`.
const LINES: [(&str, usize, usize); 8] = [
    (dac::NAME, dac::SOFTWARE_REQUESTS[0], DAC_CHANNELS[0]),
    (dac::NAME, dac::SOFTWARE_REQUESTS[1], DAC_CHANNELS[1]),
    ("USART1", RECEIVE_REQUEST, 41),
    ("USART1", TRANSMIT_REQUEST, 42),
    ("USART2", RECEIVE_REQUEST, 43),
    ("USART2", TRANSMIT_REQUEST, 44),
    ("USART3", RECEIVE_REQUEST, 45),
    ("USART3", TRANSMIT_REQUEST, 46),
];

const IDS: usize = 128;

/// Every request line's level, and the line each channel listens to: a handle for those who drive a
/// line and those who serve it.
#[derive(Debug, Clone)]
pub(super) struct RequestLines(Arc<Shared>);

#[derive(Debug)]
struct Shared {
    /// By `DMAREQ_ID`.
    levels: [AtomicBool; IDS],
    selected: [AtomicUsize; CHANNELS],
}

impl RequestLines {
    pub(super) fn new() -> Self {
        Self(Arc::new(Shared {
            levels: std::array::from_fn(|_| AtomicBool::new(false)),
            selected: std::array::from_fn(|_| AtomicUsize::new(0)),
        }))
    }

    /// Sets the level of line `id`.
    pub(super) fn drive(&self, id: usize, high: bool) {
        self.0.levels[id].store(high, Ordering::Relaxed);
    }

    /// Whether the line `channel` listens to is high.
    pub(super) fn stands(&self, channel: usize) -> bool {
        self.0.levels[self.selected(channel)].load(Ordering::Relaxed)
    }

    fn selected(&self, channel: usize) -> usize {
        self.0.selected[channel].load(Ordering::Relaxed)
    }

    pub(super) fn select(&self, channel: usize, id: usize) {
        self.0.selected[channel].store(id, Ordering::Relaxed);
    }
}

impl Store for RequestLines {
    fn store(&self, to: &mut Writer) -> Result<(), snapshot::Error> {
        let Shared { levels, selected } = &*self.0;
        let levels = levels.iter().map(|level| level.load(Ordering::Relaxed));
        let selected = selected.iter().map(|id| id.load(Ordering::Relaxed));
        to.put(&levels.collect::<Vec<bool>>())?;
        to.put(&selected.collect::<Vec<usize>>())
    }

    fn load(&mut self, from: &mut Reader) -> Result<(), snapshot::Error> {
        let (levels, selected): (Vec<bool>, Vec<usize>) = (from.take()?, from.take()?);
        for (id, level) in levels.into_iter().enumerate().take(IDS) {
            self.drive(id, level);
        }
        for (channel, id) in selected.into_iter().enumerate().take(CHANNELS) {
            self.select(channel, id.min(IDS - 1));
        }
        Ok(())
    }
}

/// The model's state beside the registers.
#[derive(Debug)]
pub(super) struct Dmamux {
    lines: RequestLines,
}

rigless::store!(Dmamux {
    values: [],
    parts: [lines],
    built: [],
});

impl Dmamux {
    pub(super) fn new(lines: RequestLines) -> Self {
        Self { lines }
    }

    /// Tells the controller of a channel whose line stands.
    fn wake(&self, channel: usize, context: &mut DeviceContext<'_>) {
        if self.lines.stands(channel) {
            context.request(channel, Level::High);
        }
    }
}

impl Device for Dmamux {
    type Register = Register;

    fn write(
        &mut self,
        register: Register,
        value: u64,
        _registers: &mut RegisterFile,
        context: &mut DeviceContext<'_>,
    ) {
        let channel = register.index();
        if channel >= CHANNELS {
            if register.spec().name.contains("_RG") && value != 0 {
                context.tell("RGxCR", "request generators are not modelled");
            }
            return;
        }
        if dmamux_c0cr::SE.is_set(value) {
            context.tell("CxCR", "synchronisation is not modelled");
        }
        let id = dmamux_c0cr::DMAREQ_ID.get(value) as usize;
        let known = id == ADC1 || LINES.iter().any(|&(_, _, known)| known == id);
        if id != 0 && !known {
            context.tell("CxCR", "no such request line on this board's multiplexer");
        }
        if id != 0 && channel >= DMA1_STREAMS {
            context.tell("CxCR", "DMA2 hears no requests on this board: use DMA1");
        }
        self.lines.select(channel, id);
        self.wake(channel, context);
    }

    fn on_request(
        &mut self,
        request: RequestChange,
        _registers: &mut RegisterFile,
        context: &mut DeviceContext<'_>,
    ) {
        let line = LINES
            .iter()
            .find(|(instance, number, _)| {
                *number == request.request && *instance == request.instance
            })
            .map(|&(_, _, id)| id);
        let Some(id) = line else { return };
        self.lines.drive(id, request.level == Level::High);
        for channel in (0..CHANNELS).filter(|channel| self.lines.selected(*channel) == id) {
            self.wake(channel, context);
        }
    }

    /// The lines are the peripherals': they stay as they are.
    fn reset(&mut self) {
        for channel in 0..CHANNELS {
            self.lines.select(channel, 0);
        }
    }
}
