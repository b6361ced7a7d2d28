// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! A UHF transceiver module on a serial line, as its text command interface shows it:
//! [`Transceiver`], which answers `ES+R` and `ES+W` commands, keeps what a write set, and passes bytes
//! between the serial line and the air in transparent mode.
//!
//! **A command is a line.** `ES+R<address><register>` reads and `ES+W<address><register><value>`
//! writes, then a space, eight uppercase hexadecimal digits of the CRC-32 of everything before that
//! space, and `CR`. The radio answers a command it accepts with `OK`, and a read with `OK+` and the
//! register's text, each followed by its own CRC and `CR`. It answers a line it refuses with one of
//! the error strings, also with a CRC. The reply goes out a configurable processing time after the
//! line's `CR`, on the run's own clock.
//!
//! **What a write set, a read gives back.** The registers hold their values across commands. The
//! board sets the one that's a measurement, the temperature, with [`Transceiver::set_temperature`].
//!
//! **Transparent mode.** A write of the status word with its pipe bit set is answered, and then the
//! radio writes the `+PIPE` notice and passes every byte from the serial line to the air side and
//! every byte from the air side to the serial line. The air speaking while it takes commands opens a
//! pipe the same way. After the pipe timeout with nothing heard over the air, it writes the `+ESTTC` notice, clears the bit and takes commands again. The air side is a
//! second [`Peer`] a ground station or a host socket attaches with [`Transceiver::with_air`], or
//! with [`Transceiver::attach_air`] once the module is built. While the status word's beacon bit is
//! set, the radio writes the stored beacon message to the air side every beacon period.
//!
//! **Handled here:** every register in the table below. There is no register file, since the module's
//! interface is text, and the serial port the module hangs on keeps its own.
//!
//! The Source column says where a row is the best this model can do. No public copy of the vendor's manual
//! for the module was found, so what's here is what a driver is seen to send and accept.
//!
//! | Register or section | Behavior | Source | Test |
//! |---|---|---|---|
//! | CRC | CRC-32 of the body, reflected polynomial `0xEDB88320`, initial value and final XOR `0xFFFFFFFF`, as eight uppercase hexadecimal digits after a space | ISO 3309, IEEE 802.3 | `the_crc_is_the_ethernet_crc_in_the_wire_form` |
//! | Line | Bytes gather until `CR`. A line with no space, a CRC field not eight digits, a body too short or a line past 256 bytes is `E_CRC_ERR_LEN`. A CRC that doesn't match is `E_CRC_ERR`. A body that isn't `ES+R` or `ES+W`, another address, a register the radio doesn't have, or a value it refuses is `ERR` | ceiling: no public document gives this, so it's what a driver accepts | `a_bad_crc_is_refused_with_its_error_string`, `the_other_refusals_have_their_error_strings` |
//! | Reply | `OK` and the CRC for a write, `OK+` and the register's text for a read, a processing time after the `CR` | ceiling: no public document gives this, so it's what a driver accepts | `a_reply_comes_a_processing_time_after_the_line`, `a_write_is_answered_ok` |
//! | `00` status control word | Sixteen bits written as four digits. Bits 13:12 the UART baud, 10:8 the RF mode, 7 echo, 6 beacon, 5 pipe. The reply is six zero digits then the word | ceiling: no public document gives this, so it's what a driver accepts | `a_status_word_reads_back_what_was_written`, `the_status_read_has_the_shape_a_driver_parses` |
//! | `00` echo bit | With echo on, each byte received in command mode is sent back as it arrives | ceiling: no public document gives this, so it's what a driver accepts | `echo_repeats_the_line_before_the_reply` |
//! | `01` frequency | Eight digits as written, `FRAC` low byte first then `N`, which are `(N + FRAC / 2^19) * 6.5 MHz`. Read as `OK+00` then the digits | ceiling: no public document gives this, so it's what a driver accepts | `the_frequency_reads_back_and_decodes` |
//! | `02` uptime | Seconds since the module last had power, which is the run's start unless its supply was switched, as eight digits after two | ceiling: no public document gives this, so it's what a driver accepts | `uptime_counts_seconds_of_the_run` |
//! | `03` packets out | How many times the beacon message was sent | ceiling: no public document gives this, so it's what a driver accepts | `the_beacon_is_sent_every_period` |
//! | `04`, `05` packets in, CRC16 errors | Read zero, since the air side carries bytes and not packets | ceiling: no public document gives this, so it's what a driver accepts | `the_counters_read_as_the_driver_parses_them` |
//! | `06` pipe timeout | Seconds, 1 to 255, four digits written and eight read | ceiling: no public document gives this, so it's what a driver accepts | `a_pipe_goes_back_to_commands_after_its_silence` |
//! | `07` beacon period | Seconds, four digits written and eight read. Zero stops the beacon | ceiling: no public document gives this, so it's what a driver accepts | `the_beacon_is_sent_every_period` |
//! | `08` audio beacon period | Seconds, four digits written and eight read | ceiling: no public document gives this, so it's what a driver accepts | `the_other_registers_read_back_what_was_written` |
//! | `09` restore | Puts every register a write can set back to its default | ceiling: no public document gives this, so it's what a driver accepts | `restore_puts_the_defaults_back` |
//! | `0A` temperature | Read as a sign, the degrees and one place, from what the board set | ceiling: no public document gives this, so it's what a driver accepts | `the_temperature_is_what_the_board_set` |
//! | `ED` CRC16 enable | Two digits written, `0` then the flag, and read the same | ceiling: no public document gives this, so it's what a driver accepts | `the_other_registers_read_back_what_was_written` |
//! | `F5`, `F6` call signs | Six characters, written and read raw | ceiling: no public document gives this, so it's what a driver accepts | `the_other_registers_read_back_what_was_written` |
//! | `F7` Morse call sign | Two decimal digits of length then that many of `-`, `.` and space | ceiling: no public document gives this, so it's what a driver accepts | `the_other_registers_read_back_what_was_written` |
//! | `F8` audio beacon notes | Two decimal digits of count then three characters a note | ceiling: no public document gives this, so it's what a driver accepts | `the_other_registers_read_back_what_was_written`, `the_other_refusals_have_their_error_strings` |
//! | `F9` firmware version | Three decimal digits read as `a.b.c` | ceiling: no public document gives this, so it's what a driver accepts | `the_boot_sequence_is_answered` |
//! | `FA` payload size | Four digits | ceiling: no public document gives this, so it's what a driver accepts | `the_boot_sequence_is_answered` |
//! | `FB` beacon message | Two digits of length, under 78, then that many raw bytes. Read as the length and each byte in two digits | ceiling: no public document gives this, so it's what a driver accepts | `the_other_registers_read_back_what_was_written` |
//! | Boot and health check | Every command a driver sends at start and in its periodic check is answered `OK` | ceiling: no public document gives this, so it's what a driver accepts | `the_boot_sequence_is_answered` |
//! | Transparent mode | A status write with the pipe bit set is answered and then `+PIPE` is written. Bytes go both ways. After the pipe timeout with nothing heard over the air since it opened or since the air last spoke, `+ESTTC` is written and the pipe bit clears. What the serial line sends doesn't hold it open, so a firmware that restarted mid-pipe gets its module back. The silence is checked again whenever the line is used, so a check a controller reset dropped still ends it | ceiling: no public document gives this, so it's what a driver accepts | `a_pipe_passes_bytes_both_ways`, `a_pipe_goes_back_to_commands_after_its_silence`, `a_pipe_whose_check_was_lost_ends_when_the_line_is_next_used` |
//! | Beacon | While bit 6 is set and the period isn't zero, the stored message goes to the air side every period from the write that made it so, and not while a pipe is open | ceiling: no public document gives this, so it's what a driver accepts | `the_beacon_is_sent_every_period` |
//! | Address | The module answers commands for its own address, `0x22` unless the board gives another. A command for another address is `ERR` | ceiling: no public document gives this, so it's what a driver accepts | `a_different_address_is_the_modules_own_to_answer_at` |
//! | Air side in command mode | The air speaking to a module taking commands opens a pipe: the pipe bit sets, `+PIPE` is written, then the air's bytes follow, and serial bytes go to the air until the air's silence ends it | ceiling: no public document gives this, so it's what a driver accepts | `the_air_speaking_opens_a_pipe` |
//! | Beacon timing | A write that leaves the period as it was doesn't move the next beacon. A pipe open at the instant suppresses it | ceiling: no public document gives this, so it's what a driver accepts | `a_beacon_period_written_again_does_not_move_the_beacon_unless_it_changed`, `no_beacon_goes_out_while_a_pipe_is_open` |
//! | Power | When the supply goes, the module forgets everything a write set, the line, the replies in flight, the pipe and the beacon, and it starts from its defaults when the supply comes back. The temperature is the board's and stays. The air side is the board's too | ceiling: no public document gives this, so it's a module with no memory that outlives its supply | `losing_power_forgets_everything_and_power_on_starts_from_the_defaults` |
//! | Snapshot and restart | The registers, the line, the replies in flight and the timers are kept, and the air side keeps itself. A restart of the part schedules the replies, the pipe check and the beacon again | ceiling: no public document gives this, so it's what a driver accepts | `a_snapshot_keeps_a_reply_in_flight`, `a_restart_of_the_part_schedules_what_was_waiting_again` |
//!
//! **What the model leaves out, and why.**
//!
//! | Behavior | Reason |
//! |---|---|
//! | Garbling bytes sent at the wrong baud | The serial seam hands a chip each word whole and times it for the controller, so a chip can't tell what rate it was sent at. The baud field reads back what was written and changes nothing |
//! | Registers `EF`, `F1`, `F4`, `FD`, `FF` | No driver reads or writes them, and nothing public says what they hold. They're refused with `ERR` |
//! | The audio beacon and the Morse call sign on the air | The air side carries bytes. Their registers hold what's written |
//! | The CRC16 flag's effect on air packets | The air side carries the beacon message and pipe bytes as they are |
//! | `ERR+REMOTE` | There's no remote radio to refuse |
//! | The packet counters in and CRC16 errors | Counting needs packets and the air side has bytes, so they read zero |
//! | Lower case digits | A driver sends upper case, so the radio reads only upper case |

use std::any::Any;
use std::collections::VecDeque;

use crate::chip::Timeline;
use crate::chip::uart::Peer;
use crate::snapshot::{Error, Reader, Store, Writer};
use crate::time::{EventId, NANOS_PER_SECOND, VirtualNanos};

/// The address a module answers to unless its board sets another.
pub const DEFAULT_ADDRESS: u8 = 0x22;

/// How long after a line's `CR` its reply starts, unless the board sets another.
// ceiling: no public document gives this, so it's well under the 300 ms a driver waits
pub const DEFAULT_PROCESSING: VirtualNanos = VirtualNanos(5_000_000);

/// The fields of the status control word.
pub mod scw {
    use crate::soc::{Access, FieldSpec};

    /// The UART baud code.
    pub const BAUD: FieldSpec = FieldSpec::new("BAUD", 12, 2, Access::ReadWrite);
    /// The RF mode.
    pub const RF_MODE: FieldSpec = FieldSpec::new("RF_MODE", 8, 3, Access::ReadWrite);
    /// Each byte received in command mode is sent back.
    pub const ECHO: FieldSpec = FieldSpec::new("ECHO", 7, 1, Access::ReadWrite);
    /// The stored beacon message is sent every beacon period.
    pub const BEACON: FieldSpec = FieldSpec::new("BEACON", 6, 1, Access::ReadWrite);
    /// The module is in transparent mode.
    pub const PIPE: FieldSpec = FieldSpec::new("PIPE", 5, 1, Access::ReadWrite);
}

/// The registers a command names.
pub mod register {
    /// The status control word.
    pub const STATUS: u8 = 0x00;
    /// The frequency.
    pub const FREQUENCY: u8 = 0x01;
    /// Seconds since the run began.
    pub const UPTIME: u8 = 0x02;
    /// Beacons sent.
    pub const PACKETS_OUT: u8 = 0x03;
    /// Packets received.
    pub const PACKETS_IN: u8 = 0x04;
    /// Packets received with a CRC16 error.
    pub const PACKETS_BAD: u8 = 0x05;
    /// Seconds of serial silence that end a transparent mode.
    pub const PIPE_TIMEOUT: u8 = 0x06;
    /// Seconds between beacons.
    pub const BEACON_PERIOD: u8 = 0x07;
    /// Seconds between audio beacons.
    pub const AUDIO_PERIOD: u8 = 0x08;
    /// Put the defaults back.
    pub const RESTORE: u8 = 0x09;
    /// The temperature.
    pub const TEMPERATURE: u8 = 0x0A;
    /// The CRC16 enable flag.
    pub const CRC16: u8 = 0xED;
    /// The destination call sign.
    pub const DESTINATION: u8 = 0xF5;
    /// The source call sign.
    pub const SOURCE: u8 = 0xF6;
    /// The Morse call sign.
    pub const MORSE: u8 = 0xF7;
    /// The audio beacon notes.
    pub const MIDI: u8 = 0xF8;
    /// The firmware version.
    pub const VERSION: u8 = 0xF9;
    /// The payload size.
    pub const PAYLOAD: u8 = 0xFA;
    /// The beacon message.
    pub const BEACON_MESSAGE: u8 = 0xFB;
}

const CARRIAGE_RETURN: u8 = b'\r';
/// The longest line the radio gathers.
// ceiling: no public document gives this, so it's past the longest command a driver sends
const MAX_LINE: usize = 256;
const CRC_DIGITS: usize = 8;
/// A beacon message is shorter than this.
const BEACON_LIMIT: usize = 78;
/// What the payload size register reads: the fixed packet a driver frames by.
// ceiling: no public document gives this, so it's the packet a driver sends
const PAYLOAD_SIZE: u16 = 128;
const CALL_SIGN: usize = 6;
const NOTE: usize = 3;
const MAX_TEMPERATURE: i16 = 999;
const PIPE_TIMEOUTS: std::ops::RangeInclusive<u16> = 1..=255;
const ENTER_NOTICE: &str = "+PIPE";
const EXIT_NOTICE: &str = "+ESTTC";
const ACCEPTED: &str = "OK";
const BAD_CRC: &str = "E_CRC_ERR";
const BAD_LENGTH: &str = "E_CRC_ERR_LEN";
const REFUSED: &str = "ERR";
const BAD_MIDI: &str = "ERR+MIDI";

/// The CRC-32 of `bytes` that the module puts after a space: reflected polynomial `0xEDB88320`,
/// initial value and final XOR `0xFFFFFFFF`.
#[must_use]
pub fn crc32(bytes: &[u8]) -> u32 {
    const POLYNOMIAL: u32 = 0xEDB8_8320;
    !bytes.iter().fold(u32::MAX, |crc, &byte| {
        (0..u8::BITS).fold(crc ^ u32::from(byte), |crc, _| {
            if crc & 1 == 0 {
                crc >> 1
            } else {
                (crc >> 1) ^ POLYNOMIAL
            }
        })
    })
}

/// `text`, a space, its CRC and `CR`: how every line on the wire ends.
fn framed(text: impl AsRef<[u8]>) -> Vec<u8> {
    let text = text.as_ref();
    let mut line = text.to_vec();
    line.extend(format!(" {:08X}\r", crc32(text)).bytes());
    line
}

/// Why the radio refused a line, which picks the error string.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Refusal {
    Length,
    Refused,
    Midi,
}

impl Refusal {
    fn reply(self) -> Vec<u8> {
        framed(match self {
            Self::Length => BAD_LENGTH,
            Self::Refused => REFUSED,
            Self::Midi => BAD_MIDI,
        })
    }
}

/// The digits of `value` as a number, or `None` if there are none, more than eight, or any isn't an
/// upper case hexadecimal digit.
fn hex(value: &[u8]) -> Option<u32> {
    if value.is_empty() || value.len() > CRC_DIGITS {
        return None;
    }
    value.iter().try_fold(0_u32, |sum, &digit| {
        let nibble = match digit {
            b'0'..=b'9' => digit - b'0',
            b'A'..=b'F' => digit - b'A' + 10,
            _ => return None,
        };
        Some(sum << 4 | u32::from(nibble))
    })
}

/// A two-digit decimal count.
fn decimal(value: &[u8]) -> Option<usize> {
    match value {
        [tens @ b'0'..=b'9', ones @ b'0'..=b'9'] => {
            Some(usize::from(tens - b'0') * 10 + usize::from(ones - b'0'))
        }
        _ => None,
    }
}

/// `word` with `field` set to `value`.
fn with_field(word: u16, field: &crate::soc::FieldSpec, value: u64) -> u16 {
    u16::try_from(field.set(u64::from(word), value)).expect("a field of the word stays in it")
}

fn printable(bytes: &[u8]) -> bool {
    bytes.iter().all(|byte| (b' '..=b'~').contains(byte))
}

/// What a write sets and a read gives back.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
struct Config {
    status: u16,
    frequency: u32,
    pipe_timeout: u16,
    beacon_period: u16,
    audio_period: u16,
    crc16: bool,
    destination: [u8; CALL_SIGN],
    source: [u8; CALL_SIGN],
    morse: Vec<u8>,
    midi: Vec<u8>,
    beacon_message: Vec<u8>,
}

impl Default for Config {
    // ceiling: no public document gives the defaults, so they're the values a driver sets at start
    fn default() -> Self {
        Self {
            status: with_field(with_field(0, &scw::RF_MODE, 3), &scw::BAUD, 3),
            frequency: 0x50EC_0A42,
            pipe_timeout: 20,
            beacon_period: 30,
            audio_period: 0,
            crc16: false,
            destination: *b"      ",
            source: *b"      ",
            morse: Vec::new(),
            midi: Vec::new(),
            beacon_message: Vec::new(),
        }
    }
}

/// A reply on its way: the bytes, and the instant they start.
#[derive(Debug, Clone, serde::Serialize, serde::Deserialize)]
struct Reply {
    id: EventId,
    due: VirtualNanos,
    bytes: Vec<u8>,
}

/// A transparent mode under way: when it opened or the air last spoke, and the check for the air's
/// silence.
#[derive(Debug, Clone, Copy, serde::Serialize, serde::Deserialize)]
struct Pipe {
    last: VirtualNanos,
    id: EventId,
    due: VirtualNanos,
}

/// The next beacon, and the period it was timed by.
#[derive(Debug, Clone, Copy, serde::Serialize, serde::Deserialize)]
struct Beacon {
    id: EventId,
    due: VirtualNanos,
    period: u16,
}

#[derive(Debug, serde::Serialize, serde::Deserialize)]
struct State {
    config: Config,
    temperature: i16,
    packets_out: u32,
    line: Vec<u8>,
    overflow: bool,
    out: VecDeque<u8>,
    replies: Vec<Reply>,
    pipe: Option<Pipe>,
    /// A pipe the air side opened at this instant, whose silence check isn't timed yet because the
    /// air is read where no timeline is at hand.
    #[serde(default)]
    heard: Option<VirtualNanos>,
    beacon: Option<Beacon>,
    powered_at: VirtualNanos,
}

impl State {
    fn at_power_on(temperature: i16, now: VirtualNanos) -> Self {
        Self {
            config: Config::default(),
            temperature,
            packets_out: 0,
            line: Vec::new(),
            overflow: false,
            out: VecDeque::new(),
            replies: Vec::new(),
            pipe: None,
            heard: None,
            beacon: None,
            powered_at: now,
        }
    }
}

/// A UHF transceiver module on the far end of a serial line.
#[derive(Debug)]
pub struct Transceiver {
    address: u8,
    processing: VirtualNanos,
    version: [u8; 3],
    state: State,
    air: Option<Box<dyn Peer>>,
}

impl Transceiver {
    /// A module that answers at `address`, with its defaults and nothing on the air side.
    #[must_use]
    pub fn new(address: u8) -> Self {
        Self {
            address,
            processing: DEFAULT_PROCESSING,
            version: [1, 0, 0],
            state: State::at_power_on(0, VirtualNanos(0)),
            air: None,
        }
    }

    /// The same module taking `processing` from a line's `CR` to the start of its reply.
    #[must_use]
    pub fn with_processing(mut self, processing: VirtualNanos) -> Self {
        self.processing = processing;
        self
    }

    /// The same module reporting firmware version `major.minor.patch`, each a single digit.
    #[must_use]
    pub fn with_version(mut self, major: u8, minor: u8, patch: u8) -> Self {
        self.version = [major.min(9), minor.min(9), patch.min(9)];
        self
    }

    /// The same module with `air` on its air side, in place of whatever was there.
    #[must_use]
    pub fn with_air(mut self, air: impl Peer) -> Self {
        self.air = Some(Box::new(air));
        self
    }

    /// The air side as the type it was attached as, to drive or to ask what it heard. `None` where
    /// nothing is attached or another type is.
    pub fn air_mut<P: Peer>(&mut self) -> Option<&mut P> {
        let air: &mut dyn Any = &mut **self.air.as_mut()?;
        air.downcast_mut()
    }

    /// Puts `air` on the air side in place of whatever was there, for a board that gets its host
    /// after the module is built.
    pub fn attach_air(&mut self, air: Box<dyn Peer>) {
        self.air = Some(air);
    }

    /// The air side whatever type it is, or `None` where nothing is attached.
    pub fn air(&mut self) -> Option<&mut dyn Peer> {
        self.air.as_deref_mut()
    }

    /// The temperature the module reports from now on, in tenths of a degree Celsius, held to
    /// plus or minus 99.9.
    pub fn set_temperature(&mut self, tenths: i16) {
        self.state.temperature = tenths.clamp(-MAX_TEMPERATURE, MAX_TEMPERATURE);
    }

    /// The status control word as it stands.
    #[must_use]
    pub fn status(&self) -> u16 {
        self.state.config.status
    }

    /// Whether the module is passing bytes between the serial line and the air.
    #[must_use]
    pub fn piping(&self) -> bool {
        self.state.pipe.is_some() || self.state.heard.is_some()
    }

    /// Times the silence check of a pipe the air side opened.
    fn time_heard(&mut self, context: &mut Timeline<'_, '_>) {
        if let Some(last) = self.state.heard.take() {
            self.open_pipe(last, context);
        }
    }

    fn flag(&self, field: &crate::soc::FieldSpec) -> bool {
        field.is_set(u64::from(self.state.config.status))
    }

    /// Starts the pipe check one timeout after `last`.
    fn open_pipe(&mut self, last: VirtualNanos, context: &mut Timeline<'_, '_>) {
        let due = self.silence_end(last);
        let id = context.schedule(due);
        self.state.pipe = Some(Pipe { last, id, due });
    }

    fn silence_end(&self, last: VirtualNanos) -> VirtualNanos {
        VirtualNanos(
            last.0
                .saturating_add(u64::from(self.state.config.pipe_timeout) * NANOS_PER_SECOND),
        )
    }

    /// Times the beacon from now if it's on and isn't timed by the period it has, and drops it if it's
    /// off.
    fn arm_beacon(&mut self, context: &mut Timeline<'_, '_>) {
        let period = self.state.config.beacon_period;
        if !self.flag(&scw::BEACON) || period == 0 {
            self.state.beacon = None;
        } else if self
            .state
            .beacon
            .is_none_or(|beacon| beacon.period != period)
        {
            self.state.beacon = Some(Self::next_beacon(context, period));
        }
    }

    fn next_beacon(context: &mut Timeline<'_, '_>, period: u16) -> Beacon {
        let due = VirtualNanos(
            context
                .now()
                .0
                .saturating_add(u64::from(period) * NANOS_PER_SECOND),
        );
        Beacon {
            id: context.schedule(due),
            due,
            period,
        }
    }

    fn send_beacon(&mut self, context: &mut Timeline<'_, '_>) {
        if self.piping() || self.state.config.beacon_message.is_empty() {
            return;
        }
        self.state.packets_out = self.state.packets_out.saturating_add(1);
        if let Some(air) = &mut self.air {
            for &byte in &self.state.config.beacon_message {
                air.receive(u16::from(byte), context);
            }
        }
    }

    /// Ends a pipe whose silence ran out by `now`, so a check lost with its event still ends it the
    /// next time the line is used.
    fn end_silent_pipe(&mut self, now: VirtualNanos) {
        if let Some(pipe) = self.state.pipe
            && now >= self.silence_end(pipe.last)
        {
            self.leave_pipe();
        }
    }

    fn leave_pipe(&mut self) {
        self.state.pipe = None;
        self.state.config.status = with_field(self.state.config.status, &scw::PIPE, 0);
        self.state.out.extend(framed(EXIT_NOTICE));
    }

    /// A line gathered: checks it and starts its reply on its way.
    fn answer(&mut self, line: &[u8], overflow: bool, context: &mut Timeline<'_, '_>) {
        let bytes = if overflow {
            Refusal::Length.reply()
        } else {
            self.command(line, context)
        };
        let due = VirtualNanos(context.now().0.saturating_add(self.processing.0));
        let id = context.schedule(due);
        self.state.replies.push(Reply { id, due, bytes });
    }

    fn command(&mut self, line: &[u8], context: &mut Timeline<'_, '_>) -> Vec<u8> {
        let Some(split) = line.iter().rposition(|&byte| byte == b' ') else {
            return Refusal::Length.reply();
        };
        let (body, digits) = (&line[..split], &line[split + 1..]);
        if digits.len() != CRC_DIGITS {
            return Refusal::Length.reply();
        }
        if digits != format!("{:08X}", crc32(body)).as_bytes() {
            return framed(BAD_CRC);
        }
        self.execute(body, context).unwrap_or_else(Refusal::reply)
    }

    fn execute(&mut self, body: &[u8], context: &mut Timeline<'_, '_>) -> Result<Vec<u8>, Refusal> {
        let (head, rest) = body.split_at_checked(4).ok_or(Refusal::Length)?;
        let (address, rest) = rest.split_at_checked(2).ok_or(Refusal::Length)?;
        let (register, value) = rest.split_at_checked(2).ok_or(Refusal::Length)?;
        if head[..3] != *b"ES+" || hex(address) != Some(u32::from(self.address)) {
            return Err(Refusal::Refused);
        }
        let register =
            u8::try_from(hex(register).ok_or(Refusal::Refused)?).or(Err(Refusal::Refused))?;
        match head[3] {
            b'R' if value.is_empty() => self.read(register, context.now()),
            b'R' => Err(Refusal::Length),
            b'W' => self.write(register, value, context).map(|notice| {
                let mut reply = framed(ACCEPTED);
                reply.extend(notice);
                reply
            }),
            _ => Err(Refusal::Refused),
        }
    }

    fn read(&self, register: u8, now: VirtualNanos) -> Result<Vec<u8>, Refusal> {
        use self::register as r;
        let config = &self.state.config;
        let number = |value: u32| format!("OK+00{value:08X}").into_bytes();
        let text = match register {
            r::STATUS => format!("OK+000000{:04X}", config.status).into_bytes(),
            r::FREQUENCY => number(config.frequency),
            r::UPTIME => number(
                u32::try_from(now.0.saturating_sub(self.state.powered_at.0) / NANOS_PER_SECOND)
                    .unwrap_or(u32::MAX),
            ),
            r::PACKETS_OUT => number(self.state.packets_out),
            r::PACKETS_IN | r::PACKETS_BAD => number(0),
            r::PIPE_TIMEOUT => number(config.pipe_timeout.into()),
            r::BEACON_PERIOD => number(config.beacon_period.into()),
            r::AUDIO_PERIOD => number(config.audio_period.into()),
            r::TEMPERATURE => {
                let tenths = self.state.temperature;
                let sign = if tenths < 0 { '-' } else { '+' };
                let degrees = tenths.unsigned_abs();
                format!("OK+{sign}{}.{}", degrees / 10, degrees % 10).into_bytes()
            }
            r::CRC16 => format!("OK+0{}", u8::from(config.crc16)).into_bytes(),
            r::DESTINATION => [b"OK+", config.destination.as_slice()].concat(),
            r::SOURCE => [b"OK+", config.source.as_slice()].concat(),
            r::MORSE => [
                format!("OK+{:02}", config.morse.len()).as_bytes(),
                &config.morse,
            ]
            .concat(),
            r::MIDI => [
                format!("OK+{:02}", config.midi.len() / NOTE).as_bytes(),
                &config.midi,
            ]
            .concat(),
            r::VERSION => {
                let [major, minor, patch] = self.version;
                format!("OK+{major}.{minor}.{patch}").into_bytes()
            }
            r::PAYLOAD => format!("OK+{PAYLOAD_SIZE:04X}").into_bytes(),
            r::BEACON_MESSAGE => {
                let mut text = format!("OK+{:02X}", config.beacon_message.len()).into_bytes();
                for byte in &config.beacon_message {
                    text.extend(format!("{byte:02X}").bytes());
                }
                text
            }
            _ => return Err(Refusal::Refused),
        };
        Ok(framed(text))
    }

    /// Sets a register from the `value` text of a write. Returns what follows the `OK`: the notice of
    /// a transparent mode just begun, or nothing.
    fn write(
        &mut self,
        register: u8,
        value: &[u8],
        context: &mut Timeline<'_, '_>,
    ) -> Result<Vec<u8>, Refusal> {
        use self::register as r;
        let word = |digits: usize| -> Result<u32, Refusal> {
            if value.len() != digits {
                return Err(Refusal::Length);
            }
            hex(value).ok_or(Refusal::Refused)
        };
        let half = || -> Result<u16, Refusal> { u16::try_from(word(4)?).or(Err(Refusal::Refused)) };
        let mut notice = Vec::new();
        match register {
            r::STATUS => {
                let status = half()?;
                let entering = scw::PIPE.is_set(status.into()) && !self.piping();
                self.state.config.status = status;
                if entering {
                    self.open_pipe(context.now(), context);
                    notice = framed(ENTER_NOTICE);
                }
                self.arm_beacon(context);
            }
            r::FREQUENCY => self.state.config.frequency = word(CRC_DIGITS)?,
            r::PIPE_TIMEOUT => {
                let timeout = half()?;
                if !PIPE_TIMEOUTS.contains(&timeout) {
                    return Err(Refusal::Refused);
                }
                self.state.config.pipe_timeout = timeout;
            }
            r::BEACON_PERIOD => {
                self.state.config.beacon_period = half()?;
                self.arm_beacon(context);
            }
            r::AUDIO_PERIOD => self.state.config.audio_period = half()?,
            r::RESTORE => {
                if !value.is_empty() && value != b"1" {
                    return Err(Refusal::Length);
                }
                self.state.config = Config::default();
                self.arm_beacon(context);
            }
            r::CRC16 => match value {
                [b'0', flag @ (b'0' | b'1')] => self.state.config.crc16 = *flag == b'1',
                [_, _] => return Err(Refusal::Refused),
                _ => return Err(Refusal::Length),
            },
            r::DESTINATION | r::SOURCE => {
                let sign: [u8; CALL_SIGN] = value.try_into().or(Err(Refusal::Length))?;
                if !printable(&sign) {
                    return Err(Refusal::Refused);
                }
                if register == r::DESTINATION {
                    self.state.config.destination = sign;
                } else {
                    self.state.config.source = sign;
                }
            }
            r::MORSE => {
                let (count, signs) = value.split_at_checked(2).ok_or(Refusal::Length)?;
                if decimal(count) != Some(signs.len()) {
                    return Err(Refusal::Length);
                }
                if !signs.iter().all(|sign| b"-. ".contains(sign)) {
                    return Err(Refusal::Refused);
                }
                self.state.config.morse = signs.to_vec();
            }
            r::MIDI => {
                let (count, notes) = value.split_at_checked(2).ok_or(Refusal::Midi)?;
                if decimal(count).map(|count| count * NOTE) != Some(notes.len())
                    || !printable(notes)
                {
                    return Err(Refusal::Midi);
                }
                self.state.config.midi = notes.to_vec();
            }
            r::BEACON_MESSAGE => {
                let (length, text) = value.split_at_checked(2).ok_or(Refusal::Length)?;
                let length = usize::try_from(hex(length).ok_or(Refusal::Refused)?)
                    .or(Err(Refusal::Refused))?;
                if length >= BEACON_LIMIT {
                    return Err(Refusal::Refused);
                }
                if length != text.len() {
                    return Err(Refusal::Length);
                }
                self.state.config.beacon_message = text.to_vec();
            }
            _ => return Err(Refusal::Refused),
        }
        Ok(notice)
    }
}

impl Default for Transceiver {
    fn default() -> Self {
        Self::new(DEFAULT_ADDRESS)
    }
}

impl Store for Transceiver {
    fn store(&self, to: &mut Writer) -> Result<(), Error> {
        to.put(&self.state)?;
        self.air.as_ref().map_or(Ok(()), |air| air.store(to))
    }

    fn load(&mut self, from: &mut Reader) -> Result<(), Error> {
        self.state = from.take()?;
        self.air.as_mut().map_or(Ok(()), |air| air.load(from))
    }
}

impl Peer for Transceiver {
    fn receive(&mut self, word: u16, context: &mut Timeline<'_, '_>) {
        let byte = u8::try_from(word & 0xFF).expect("masked to a byte");
        self.time_heard(context);
        self.end_silent_pipe(context.now());
        if self.state.pipe.is_some() {
            if let Some(air) = &mut self.air {
                air.receive(word & 0xFF, context);
            }
            return;
        }
        if self.flag(&scw::ECHO) {
            self.state.out.push_back(byte);
        }
        if byte != CARRIAGE_RETURN {
            if self.state.line.len() < MAX_LINE {
                self.state.line.push(byte);
            } else {
                self.state.overflow = true;
            }
            return;
        }
        let line = std::mem::take(&mut self.state.line);
        let overflow = std::mem::take(&mut self.state.overflow);
        self.answer(&line, overflow, context);
    }

    fn on_event(&mut self, event: EventId, context: &mut Timeline<'_, '_>) {
        if let Some(air) = &mut self.air {
            air.on_event(event, context);
        }
        self.time_heard(context);
        let (ready, waiting) = std::mem::take(&mut self.state.replies)
            .into_iter()
            .partition::<Vec<_>, _>(|reply| reply.id == event);
        self.state.replies = waiting;
        for reply in ready {
            self.state.out.extend(reply.bytes);
        }
        let now = context.now();
        if let Some(pipe) = self.state.pipe
            && pipe.id == event
        {
            let end = self.silence_end(pipe.last);
            if now >= end {
                self.leave_pipe();
            } else {
                self.state.pipe = Some(Pipe {
                    id: context.schedule(end),
                    due: end,
                    ..pipe
                });
            }
        }
        if let Some(beacon) = self.state.beacon
            && beacon.id == event
        {
            self.send_beacon(context);
            self.state.beacon = None;
            self.arm_beacon(context);
        }
    }

    fn restarted(&mut self, context: &mut Timeline<'_, '_>) {
        self.time_heard(context);
        for reply in &mut self.state.replies {
            reply.id = context.schedule(reply.due);
        }
        if let Some(pipe) = &mut self.state.pipe {
            pipe.id = context.schedule(pipe.due);
        }
        if let Some(beacon) = &mut self.state.beacon {
            beacon.id = context.schedule(beacon.due);
        }
        if let Some(air) = &mut self.air {
            air.restarted(context);
        }
    }

    fn power_changed(&mut self, _on: bool, context: &mut Timeline<'_, '_>) {
        self.state = State::at_power_on(self.state.temperature, context.now());
    }

    fn transmit(&mut self, now: VirtualNanos) -> Option<u16> {
        self.end_silent_pipe(now);
        if self.state.out.is_empty()
            && let Some(air) = &mut self.air
            && let Some(word) = air.transmit(now)
        {
            // The air speaking to a module taking commands opens a pipe, which the module
            // announces before the first byte it passes.
            if let Some(pipe) = &mut self.state.pipe {
                pipe.last = now;
            } else {
                if self.state.heard.is_none() {
                    self.state.config.status = with_field(self.state.config.status, &scw::PIPE, 1);
                    self.state.out.extend(framed(ENTER_NOTICE));
                }
                self.state.heard = Some(now);
            }
            self.state
                .out
                .push_back(u8::try_from(word & 0xFF).expect("masked to a byte"));
        }
        self.state.out.pop_front().map(u16::from)
    }

    fn forget_after(&mut self, now: VirtualNanos) {
        if let Some(air) = &mut self.air {
            air.forget_after(now);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chip::uart::Pattern;
    use crate::device::{DeviceContext, Effects};
    use crate::snapshot;
    use crate::soc::Peripheral;

    const PERIPHERAL: Peripheral = Peripheral {
        name: "test",
        base: 0,
        size: 0,
        interrupts: &[],
        registers: &[],
    };
    const MS: u64 = 1_000_000;

    fn radio() -> Transceiver {
        Transceiver::default().with_air(Pattern::default())
    }

    fn feed(radio: &mut Transceiver, effects: &mut Effects, now: u64, bytes: &[u8]) {
        let mut context = DeviceContext::new(VirtualNanos(now), 0, PERIPHERAL, effects);
        let mut timeline = Timeline::new(&mut context);
        for &byte in bytes {
            radio.receive(u16::from(byte), &mut timeline);
        }
    }

    /// Hands the radio every event due by `until` at its instant, and returns what it put on the
    /// line, which a controller would have taken at each.
    fn run_until(radio: &mut Transceiver, effects: &mut Effects, until: u64) -> Vec<u8> {
        let mut line = Vec::new();
        while let Some((id, _, at)) = effects.events.pop_due(VirtualNanos(until)) {
            let mut context = DeviceContext::new(at, 0, PERIPHERAL, effects);
            radio.on_event(id, &mut Timeline::new(&mut context));
            while let Some(word) = radio.transmit(at) {
                line.push(u8::try_from(word).expect("a byte"));
            }
        }
        line
    }

    fn air_heard(radio: &mut Transceiver) -> Vec<u16> {
        radio
            .air_mut::<Pattern>()
            .expect("a pattern on the air side")
            .received()
            .to_vec()
    }

    /// A radio that's been set up to beacon, with one reply in flight and half a line gathered at
    /// 20 ms, and the event queue that holds what it scheduled.
    fn midway() -> (Transceiver, Effects) {
        let mut effects = Effects::default();
        let mut radio = radio();
        for command in ["ES+W22FB02HI", "ES+W22070001", "ES+W22003340"] {
            feed(&mut radio, &mut effects, 0, &framed(command));
        }
        let replies = run_until(&mut radio, &mut effects, 20 * MS);
        assert_eq!(replies, framed("OK").repeat(3));
        feed(&mut radio, &mut effects, 20 * MS, &framed("ES+R2207"));
        feed(&mut radio, &mut effects, 20 * MS, b"ES+R2200 BD88");
        (radio, effects)
    }

    #[test]
    fn losing_power_forgets_everything_and_power_on_starts_from_the_defaults() {
        let (mut radio, mut effects) = midway();
        radio.set_temperature(253);
        let switch = |radio: &mut Transceiver, effects: &mut Effects, now: u64, on: bool| {
            let mut context = DeviceContext::new(VirtualNanos(now), 0, PERIPHERAL, effects);
            radio.power_changed(on, &mut Timeline::new(&mut context));
        };
        switch(&mut radio, &mut effects, 21 * MS, false);
        assert!(
            run_until(&mut radio, &mut effects, 3_000 * MS).is_empty(),
            "the reply in flight went with the power"
        );
        assert!(air_heard(&mut radio).is_empty(), "and so did the beacon");
        switch(&mut radio, &mut effects, 3_000 * MS, true);
        assert_eq!(radio.status(), Transceiver::default().status());
        feed(&mut radio, &mut effects, 5_000 * MS, &framed("ES+R2202"));
        feed(&mut radio, &mut effects, 5_000 * MS, &framed("ES+R220A"));
        assert_eq!(
            run_until(&mut radio, &mut effects, 6_000 * MS),
            [framed("OK+0000000002"), framed("OK++25.3")].concat(),
            "no half line in the way, two seconds up, and the board's temperature"
        );
        assert!(
            air_heard(&mut radio).is_empty(),
            "no beacon from the defaults"
        );
    }

    #[test]
    fn a_snapshot_keeps_a_reply_in_flight() {
        let (mut kept, mut kept_effects) = midway();
        let bytes = snapshot::stored(&kept).expect("the radio stores itself");
        // The queue of events comes back with the snapshot in a run. Here the same history builds it.
        let (_, mut restored_effects) = midway();
        let mut restored = radio();
        snapshot::load(&mut restored, snapshot::keep(bytes)).expect("and reads itself back");
        assert_eq!(
            snapshot::stored(&restored).expect("stores again"),
            snapshot::stored(&kept).expect("stores")
        );

        let mut heard = Vec::new();
        for (radio, effects) in [
            (&mut kept, &mut kept_effects),
            (&mut restored, &mut restored_effects),
        ] {
            let mut line = run_until(radio, effects, 30 * MS);
            feed(radio, effects, 30 * MS, b"8E1F\r");
            line.extend(run_until(radio, effects, 1_500 * MS));
            heard.push((line, air_heard(radio)));
        }
        let expected = [framed("OK+0000000001"), framed("OK+0000003340")].concat();
        assert_eq!(
            heard[0].0, expected,
            "the reply in flight, then the finished line"
        );
        assert_eq!(heard[1], heard[0], "the restored radio did the same");
        assert_eq!(
            heard[0].1,
            [u16::from(b'H'), u16::from(b'I')],
            "and beaconed at a second"
        );
    }

    #[test]
    fn a_restart_of_the_part_schedules_what_was_waiting_again() {
        let (mut radio, mut effects) = midway();
        effects.events.forget(0);
        let mut context = DeviceContext::new(VirtualNanos(21 * MS), 0, PERIPHERAL, &mut effects);
        radio.restarted(&mut Timeline::new(&mut context));
        let line = run_until(&mut radio, &mut effects, 1_500 * MS);
        assert_eq!(line, framed("OK+0000000001"));
        assert_eq!(air_heard(&mut radio).len(), 2, "and the beacon went on");
    }

    #[test]
    fn a_pipe_whose_check_was_lost_ends_when_the_line_is_next_used() {
        let mut effects = Effects::default();
        let mut radio = radio();
        feed(&mut radio, &mut effects, 0, &framed("ES+W22060001"));
        feed(&mut radio, &mut effects, 0, &framed("ES+W22003320"));
        let opened = run_until(&mut radio, &mut effects, 20 * MS);
        assert!(opened.ends_with(&framed("+PIPE")));
        assert!(radio.piping());
        // A controller reset drops every event it held, the silence check among them.
        effects.events.forget(0);
        feed(&mut radio, &mut effects, 1_500 * MS, &framed("ES+R2207"));
        assert!(!radio.piping());
        let line = run_until(&mut radio, &mut effects, 1_600 * MS);
        assert_eq!(
            line,
            [framed("+ESTTC"), framed("OK+000000001E")].concat(),
            "the pipe ends, then the line is a command"
        );
    }
}
