//! DMAMUX1, the request multiplexer in front of both DMA controllers, with what this board uses.
//!
//! RM0433 Rev 9, chapter 17: each channel's output follows the request line its `DMAREQ_ID` selects.
//! Only the lines in [`LINES`] exist. Synchronisation, request generators and the second controller are
//! left out, and told to the run when a firmware asks for them; events have no listener.
//!
//! The converters set their lines themselves ([`RequestLines`]); those of the emulator's peripherals
//! come over its bus.

use rigless::device::{Device, DeviceContext, Level, RegisterFile, RequestChange};
use rigless::soc::Layout;
use rigless::soc::stm32h743::generated::dmamux1::{Register, dmamux_c0cr};
use rigless::soc::stm32h743::peripherals::usart::{RECEIVE_REQUEST, TRANSMIT_REQUEST};

use super::dac;
use super::request_lines::{ADC1, CHANNELS, DAC_CHANNELS, RequestLines};

/// The instance's name, as listeners see it.
pub(super) const NAME: &str = "DMAMUX1";
/// Channels of the first controller. The second is not wired: each listener costs speed.
const DMA1_STREAMS: usize = 8;

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
