//! The error queue and the event register.

use calib_protocol::message::Refusal;
use heapless::Deque;

/// Errors of SCPI-99 that this instrument reports.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(i16)]
pub enum ScpiError {
    /// No error.
    None = 0,
    /// A parameter is no number.
    DataType = -104,
    /// More than the command takes.
    ParameterNotAllowed = -108,
    /// Less than the command takes.
    MissingParameter = -109,
    /// No such command.
    UndefinedHeader = -113,
    /// A host at the other link holds the session.
    OtherHost = -203,
    /// A run is going on.
    InitIgnored = -213,
    /// The button on the instrument is not held.
    HandMissing = -221,
    /// A number outside its range.
    DataOutOfRange = -222,
    /// A name that nothing has.
    IllegalParameter = -224,
    /// No record has this number, or it is shorter than the offset.
    IllegalRecord = -256,
    /// The answer has no room.
    TooMuchData = -223,
    /// Something of the instrument does not work.
    Hardware = -240,
    /// No result: nothing was measured since the last change, or not yet.
    DataStale = -230,
    /// The point was refused; `FETCh:STATe?` has the reason.
    PointRefused = -300,
    /// The record area failed.
    StorageFault = -320,
    /// The record area is full.
    OutOfMemory = -321,
    /// More errors than the queue holds.
    QueueOverflow = -350,
    /// A line longer than the buffer.
    InputOverrun = -363,
    /// A line that waited for the end of a run gave way to another that waits.
    Interrupted = -410,
    /// The instrument is too cold or too hot to measure.
    Temperature = 201,
    /// Its channels are not of the same instants.
    NotAligned = 202,
}

/// Reason for which an order was declined, whichever command gave it.
impl From<Refusal> for ScpiError {
    fn from(refusal: Refusal) -> Self {
        match refusal {
            Refusal::Busy => Self::InitIgnored,
            Refusal::OtherHost => Self::OtherHost,
            Refusal::ButtonNotHeld => Self::HandMissing,
            Refusal::PointList | Refusal::PointImpossible { .. } | Refusal::Conditions => {
                Self::DataOutOfRange
            }
            Refusal::ListUnknown => Self::IllegalParameter,
            Refusal::RecordNotFound | Refusal::OffsetOutOfRange => Self::IllegalRecord,
            Refusal::StorageFull => Self::OutOfMemory,
            Refusal::TemperatureOutOfRange => Self::Temperature,
            Refusal::ChannelsNotAligned => Self::NotAligned,
            Refusal::Degraded(_) | Refusal::StillDriven => Self::Hardware,
            // Of orders that no command here gives, and of a flash that failed.
            _ => Self::StorageFault,
        }
    }
}

impl ScpiError {
    /// Number of the error.
    pub fn code(self) -> i16 {
        self as i16
    }

    /// Its text.
    pub fn text(self) -> &'static str {
        match self {
            Self::None => "No error",
            Self::DataType => "Data type error",
            Self::ParameterNotAllowed => "Parameter not allowed",
            Self::MissingParameter => "Missing parameter",
            Self::UndefinedHeader => "Undefined header",
            Self::OtherHost => "Command protected;a host at the other link holds the session",
            Self::InitIgnored => "Init ignored;a run is going on",
            Self::HandMissing => "Settings conflict;hold the button on the instrument",
            Self::DataOutOfRange => "Data out of range",
            Self::IllegalRecord => "File name not found;see MMEM:CAT?",
            Self::IllegalParameter => "Illegal parameter value;see LIST:CAT?",
            Self::TooMuchData => "Too much data",
            Self::Hardware => "Hardware error;see DIAG:DEF?",
            Self::DataStale => "Data corrupt or stale;INIT, then wait with *OPC?",
            Self::PointRefused => "Device-specific error;point refused, see FETC:STAT?",
            Self::StorageFault => "Storage fault",
            Self::OutOfMemory => "Out of memory;release downloaded records",
            Self::QueueOverflow => "Queue overflow",
            Self::InputOverrun => "Input buffer overrun",
            Self::Interrupted => "Query INTERRUPTED",
            Self::Temperature => "Device-specific error;too cold or too hot to measure",
            Self::NotAligned => "Device-specific error;channels not of the same instants, reset it",
        }
    }

    /// Its bit of the standard event register: command, execution, device, query.
    fn event(self) -> u8 {
        match self.code() {
            -199..=-100 => 32,
            -299..=-200 => 16,
            -399..=-300 | 1.. => 8,
            -499..=-400 => 4,
            _ => 0,
        }
    }
}

/// Bit of the event register: power came on.
const POWER_ON: u8 = 128;
/// Bit of the event register: the operation is complete.
const COMPLETE: u8 = 1;
/// Bit of the status byte (SCPI-99): there is an error to be asked for.
const ERROR_WAITS: u8 = 4;
/// Bit of the status byte: an event that its mask lets through.
const EVENT: u8 = 32;
/// Bit of the status byte: one of the others that its mask lets through. It has no mask of its own.
const SUMMARY: u8 = 64;

/// Errors not yet asked for, and the events since they were last asked for.
pub(super) struct Status {
    errors: Deque<ScpiError, 8>,
    events: u8,
    /// Events that the status byte tells of: `*ESE`.
    pub(super) event_mask: u8,
    service_mask: u8,
}

impl Status {
    pub(super) const fn new() -> Self {
        Self {
            errors: Deque::new(),
            events: POWER_ON,
            event_mask: 0,
            service_mask: 0,
        }
    }

    /// A new error; the last place of a full queue says that it overflowed.
    pub(super) fn push(&mut self, error: ScpiError) {
        self.events |= error.event();
        if self.errors.push_back(error).is_err() {
            self.errors.pop_back();
            let _ = self.errors.push_back(ScpiError::QueueOverflow);
        }
    }

    /// The oldest error, or none.
    pub(super) fn pop(&mut self) -> ScpiError {
        self.errors.pop_front().unwrap_or(ScpiError::None)
    }

    pub(super) fn operation_complete(&mut self) {
        self.events |= COMPLETE;
    }

    /// The event register, which is empty afterwards.
    pub(super) fn take_events(&mut self) -> u8 {
        core::mem::take(&mut self.events)
    }

    /// Errors not yet asked for.
    pub(super) fn count(&self) -> u8 {
        // At most eight.
        self.errors.len() as u8
    }

    /// Bits of the status byte that its summary tells of: `*SRE`.
    pub(super) fn service_mask(&self) -> u8 {
        self.service_mask
    }

    pub(super) fn set_service_mask(&mut self, mask: u8) {
        self.service_mask = mask & !SUMMARY;
    }

    /// The status byte. An answer is sent at once, so that none ever waits (bit 4).
    pub(super) fn byte(&self) -> u8 {
        let told = |bit: u8, is: bool| if is { bit } else { 0 };
        let byte = told(ERROR_WAITS, !self.errors.is_empty())
            | told(EVENT, self.events & self.event_mask != 0);
        byte | told(SUMMARY, byte & self.service_mask != 0)
    }

    pub(super) fn clear(&mut self) {
        self.errors.clear();
        self.events = 0;
    }
}
