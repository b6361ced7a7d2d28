//! DMAMUX1, the request multiplexer in front of both DMA controllers, with what this board uses.
//!
//! RM0433 Rev 9, chapter 17: each channel's output follows the request line its `DMAREQ_ID` selects.
//! Only the lines in [`LINES`] exist. Synchronisation, request generators and the second controller are
//! left out, and told to the run when a firmware asks for them; events have no listener.

use rigless::device::{Device, DeviceContext, Level, RegisterFile, RequestChange};
use rigless::soc::Layout;
use rigless::soc::stm32h743::generated::dmamux1::{Register, dmamux_c0cr};
use rigless::soc::stm32h743::peripherals::usart::{RECEIVE_REQUEST, TRANSMIT_REQUEST};

use super::{adc, dac};

const CHANNELS: usize = 16;
/// Channels of the first controller. The second is not wired: each listener costs speed.
const DMA1_STREAMS: usize = 8;

/// Request lines by instance, its own numbering, and `DMAREQ_ID` (RM0433 Rev 9, table 124).
///
/// The two converters' line is driven by their common block: in dual mode the pair has one.
const LINES: [(&str, usize, usize); 8] = [
    (adc::NAME, adc::DMA_REQUEST, 9),
    ("USART1", RECEIVE_REQUEST, 41),
    ("USART1", TRANSMIT_REQUEST, 42),
    ("USART2", RECEIVE_REQUEST, 43),
    ("USART2", TRANSMIT_REQUEST, 44),
    ("USART3", RECEIVE_REQUEST, 45),
    ("USART3", TRANSMIT_REQUEST, 46),
    (dac::NAME, dac::DMA_REQUEST, 67),
];

const IDS: usize = 128;

/// The model's state beside the registers.
#[derive(Debug)]
pub(super) struct Dmamux {
    /// Level of each request line, by `DMAREQ_ID`.
    inputs: [Level; IDS],
    /// The line each channel listens to.
    selected: [usize; CHANNELS],
    /// Level last driven on each channel's output.
    outputs: [Level; CHANNELS],
}

impl Dmamux {
    pub(super) fn new() -> Self {
        Self {
            inputs: [Level::Low; IDS],
            selected: [0; CHANNELS],
            outputs: [Level::Low; CHANNELS],
        }
    }

    fn drive(&mut self, channel: usize, context: &mut DeviceContext<'_>) {
        let level = self.inputs[self.selected[channel]];
        if self.outputs[channel] != level {
            self.outputs[channel] = level;
            context.request(channel, level);
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
        if id != 0 && !LINES.iter().any(|&(_, _, known)| known == id) {
            context.tell("CxCR", "no such request line on this board's multiplexer");
        }
        if id != 0 && channel >= DMA1_STREAMS {
            context.tell("CxCR", "DMA2 hears no requests on this board: use DMA1");
        }
        self.selected[channel] = id;
        self.drive(channel, context);
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
        self.inputs[id] = request.level;
        for channel in 0..CHANNELS {
            if self.selected[channel] == id {
                self.drive(channel, context);
            }
        }
    }

    fn reset(&mut self) {
        *self = Self::new();
    }

    fn reset_line(&mut self, _registers: &mut RegisterFile, context: &mut DeviceContext<'_>) {
        context.lower_requests(&self.outputs);
        // The lines are the peripherals': they stay as they are.
        self.selected = [0; CHANNELS];
        self.outputs = [Level::Low; CHANNELS];
    }
}
