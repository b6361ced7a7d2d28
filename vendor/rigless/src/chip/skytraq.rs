// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! A SkyTraq GNSS receiver on a serial line: [`Receiver`], which answers the binary messages of
//! SkyTraq's application note AN0037 and writes NMEA 0183 sentences of the fix the world hands it.
//! It's the receiver Ex-Alta 2 flies, an S1216F8, as its flight software's driver talks to it.
//!
//! **The world says where the antenna is.** The board hands the receiver its position and velocity
//! in the Earth's frame, how many satellites it sees, and the GPS time the run's clock starts from.
//! The receiver turns the position into latitude, longitude and height on the WGS-84 ellipsoid and
//! the velocity into a speed and a course over the ground, and writes them at whole GPS seconds.
//!
//! **A command is a binary message.** `A0 A1`, the payload's length in two bytes, most significant
//! first, the payload, the exclusive OR of the payload's bytes, and `0D 0A`. The receiver answers
//! each one it takes with an ACK, `83` and the message's ID, then any reply the message asks for, and
//! each one it refuses with a NACK, `84` and the ID. A message whose ID carries a sub-ID is
//! acknowledged with both.
//!
//! The Source column cites AN0037, "Binary Messages of SkyTraq Phoenix GNSS Receiver", Ver 1.4.69, by
//! section title, and NMEA 0183 for the sentences.
//!
//! | Register or section | Behavior | Source | Test |
//! |---|---|---|---|
//! | Message format | `A0 A1`, a big-endian length, the payload, its XOR checksum and `0D 0A`. Bytes before `A0 A1` are skipped. A length of zero or past the longest input message is not a message | Binary Message Structure | `a_frame_is_found_among_other_bytes` |
//! | Message flow | An input message taken is answered with ACK `83`, then its reply. One with the wrong length, a bad checksum, a wrong value or an ID the receiver doesn't know is answered with NACK `84`. Both carry the sub-ID of an ID that has one | Message Flow, ACK (0x83), NACK (0x84) | `a_message_taken_is_acked_and_one_refused_is_nacked` |
//! | `01` system restart | Fifteen bytes. Start modes 1 to 3 are acked. The fix carries on | System Restart (0x1) | `a_restart_is_acked_and_the_fix_carries_on` |
//! | `02` software version | Reply `80`: kernel, ODM version and revision | Query Software Version (0x2), Software Version (0x80) | `the_queries_answer_with_their_replies` |
//! | `03` software CRC | Reply `81`: the CRC | Query Software CRC (0x3), Software CRC (0x81) | `the_queries_answer_with_their_replies` |
//! | `04` factory defaults | Every setting back to the factory's | Set Factory Defaults (0x4) | `factory_defaults_put_the_output_back` |
//! | `05` serial port | Port `00`, which AN0037 calls COM 1, a baud code of 0 to 8 and an attribute of 0 to 2 are acked | Configure Serial Port (0x5) | `a_wrong_value_is_nacked` |
//! | `09`, `16` message type | No output, NMEA or binary. Only NMEA writes sentences. `16` replies `8C` | Configure Message Type (0x9), Query Message Type (0x16), GNSS Message Type (0x8C) | `a_message_type_other_than_nmea_stops_the_sentences` |
//! | `0C`, `15` power mode | Normal or power save, kept and reported by `B9` | Configure System Power Mode (0xC), Query Power Mode (0x15), GNSS Power Mode Status (0xB9) | `the_queries_answer_with_their_replies` |
//! | `0E`, `10` position rate | 1, 2, 4, 5, 8, 10, 20, 25, 40 or 50 fixes a second, reported by `86` | Configure System Position Rate (0xE), Query Position Update Rate (0x10), Position Update Rate (0x86) | `the_queries_answer_with_their_replies`, `a_wrong_value_is_nacked` |
//! | `4B`, `4F` talker ID | GP, GN or auto. In GN mode `GGA`, `GLL`, `RMC`, `VTG` and `ZDA` are `GN`, and `GSA` stays `GP` when only GPS satellites fix. Auto with GPS alone is GP. `4F` replies `93` | Configure NMEA Talker ID (0x4B), Query NMEA Talker ID (0x4F), GNSS NMEA Talker ID (0x93) | `the_talker_follows_its_setting` |
//! | `64 01` boot status | Two bytes, reply `64 80` | Query GNSS Boot Status, GNSS Boot Status | `the_flight_drivers_interval_command_is_a_boot_status_query_of_the_wrong_length` |
//! | `64 20` GPS time | Reply `64 8E`: time of week in milliseconds and the nanoseconds past it, the week, the leap seconds and which are valid | Query GPS Time, GPS Time | `gps_time_is_the_runs_clock_from_the_epoch` |
//! | `64 3B`, `64 3C` NMEA string interval | One of the fourteen strings, its interval in seconds, 0 for off. `64 3C` replies `64 9D` | Configure NMEA String Interval, Query NMEA String Interval, NMEA String Interval | `an_interval_sets_how_often_a_sentence_comes` |
//! | Sentences | `GGA`, `GSA`, `GLL`, `RMC`, `VTG` and `ZDA` at each whole GPS second their interval divides, in that order, `$` to `*`, the XOR checksum and `CR LF`. Handing the receiver the epoch it has doesn't write the second's fix again | NMEA 0183 | `the_fix_is_written_where_the_antenna_is`, `sensing_again_within_a_second_writes_nothing_until_the_next` |
//! | Fix | Four satellites or more is a 3D fix, three a 2D fix, fewer none: quality 0, status `V`, mode `N` and empty position fields, with the time still kept | NMEA 0183 `GGA`, `GSA`, `RMC` | `with_too_few_satellites_there_is_no_fix` |
//! | Power | When its supply goes the receiver forgets its settings and whatever it was sending or hearing, and it starts from its factory settings when the supply comes back. What the board hands it stays | assumption: AN0037 doesn't say what a setting outlives | `power_on_starts_from_the_factory_settings` |
//! | Snapshot | Everything it keeps | not applicable | `a_snapshot_keeps_the_settings_and_the_line` |
//!
//! **Left out.**
//!
//! | Behavior | Reason |
//! |---|---|
//! | `GNS`, `GSV`, `DTM`, `GBS`, `GRS`, `GST`, `THS`, `HDT` | Their intervals are kept and reported, and nothing is written. They need a sky, a datum or a heading the world doesn't hand the receiver |
//! | The rest of AN0037's messages | They're answered with NACK, as a receiver whose firmware doesn't support a message is |
//! | The baud a serial port command sets | The serial seam hands a chip each word whole and times it for the controller, so the code is kept and the line doesn't change |
//! | Binary navigation output | Message type 2 stops the sentences and writes nothing in their place |
//! | Acquisition and power save | A restart keeps the fix, and power save changes nothing on the line |
//! | Geoid separation | Written as zero, so the altitude is the height above the ellipsoid |
//! | Dilution of precision | A fixed 1.4, 0.8 and 1.1 |

use std::collections::VecDeque;
use std::fmt::Write;
use std::num::NonZeroU8;

use crate::chip::Timeline;
use crate::chip::earth::{Geodetic, GpsTime, LEAP_SECONDS, nearest};
use crate::chip::uart::Peer;
use crate::snapshot::store;
use crate::time::{NANOS_PER_SECOND, VirtualNanos};

const START: [u8; 2] = [0xA0, 0xA1];
const END: [u8; 2] = [0x0D, 0x0A];
/// The longest input message AN0037 lists is under this.
// ceiling: AN0037 gives no longest message; upgrade when a command past it is modeled
const LONGEST_PAYLOAD: usize = 256;
/// The bytes around a payload: the start, the length, the checksum and the end.
const FRAMING: usize = 7;

const ACK: u8 = 0x83;
const NACK: u8 = 0x84;

/// The IDs whose messages carry a sub-ID, AN0037's message list.
const WITH_SUB_ID: [u8; 9] = [0x62, 0x63, 0x64, 0x65, 0x67, 0x6A, 0x6E, 0x6F, 0x7A];

/// The input messages the receiver answers.
mod id {
    pub(super) const RESTART: u8 = 0x01;
    pub(super) const SOFTWARE_VERSION: u8 = 0x02;
    pub(super) const SOFTWARE_CRC: u8 = 0x03;
    pub(super) const FACTORY_DEFAULTS: u8 = 0x04;
    pub(super) const SERIAL_PORT: u8 = 0x05;
    pub(super) const MESSAGE_TYPE: u8 = 0x09;
    pub(super) const POWER_MODE: u8 = 0x0C;
    pub(super) const POSITION_RATE: u8 = 0x0E;
    pub(super) const QUERY_POSITION_RATE: u8 = 0x10;
    pub(super) const QUERY_POWER_MODE: u8 = 0x15;
    pub(super) const QUERY_MESSAGE_TYPE: u8 = 0x16;
    pub(super) const TALKER: u8 = 0x4B;
    pub(super) const QUERY_TALKER: u8 = 0x4F;
    pub(super) const EXTENDED: u8 = 0x64;
    pub(super) const BOOT_STATUS: u8 = 0x01;
    pub(super) const GPS_TIME: u8 = 0x20;
    pub(super) const STRING_INTERVAL: u8 = 0x3B;
    pub(super) const QUERY_STRING_INTERVAL: u8 = 0x3C;
}

/// The output messages its replies are.
mod reply {
    pub(super) const SOFTWARE_VERSION: u8 = 0x80;
    pub(super) const SOFTWARE_CRC: u8 = 0x81;
    pub(super) const POSITION_RATE: u8 = 0x86;
    pub(super) const MESSAGE_TYPE: u8 = 0x8C;
    pub(super) const TALKER: u8 = 0x93;
    pub(super) const POWER_MODE: u8 = 0xB9;
    pub(super) const BOOT_STATUS: u8 = 0x80;
    pub(super) const GPS_TIME: u8 = 0x8E;
    pub(super) const STRING_INTERVAL: u8 = 0x9D;
}

/// The NMEA strings a string interval names, in AN0037's order.
pub const STRINGS: [&str; 14] = [
    "GGA", "GNS", "GSA", "GSV", "GLL", "RMC", "VTG", "ZDA", "DTM", "GBS", "GRS", "GST", "THS",
    "HDT",
];
const GGA: usize = 0;
const GSA: usize = 2;
const GSV: usize = 3;
const GLL: usize = 4;
const RMC: usize = 5;
const VTG: usize = 6;
const ZDA: usize = 7;
/// The sentences the receiver writes, in the order it writes them.
const WRITTEN: [usize; 6] = [GGA, GSA, GLL, RMC, VTG, ZDA];

/// The position rates a `0E` takes, fixes a second.
const RATES: [u8; 10] = [1, 2, 4, 5, 8, 10, 20, 25, 40, 50];
/// The baud codes and attributes a `05` takes.
const BAUD_CODES: u8 = 8;
const MOST_ATTRIBUTE: u8 = 2;
/// What the receiver writes, Configure Message Type's codes in order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
enum Output {
    Nothing,
    Nmea,
    Binary,
}

/// The talker ID, Configure NMEA Talker ID's codes in order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
enum Talker {
    Gp,
    Gn,
    Auto,
}

impl Output {
    const ALL: [Self; 3] = [Self::Nothing, Self::Nmea, Self::Binary];
}

impl Talker {
    const ALL: [Self; 3] = [Self::Gp, Self::Gn, Self::Auto];
}

/// The setting `code` names in `all`, which lists them in the order of their codes.
fn coded<T: Copy>(all: &[T], code: u8) -> Option<T> {
    all.get(usize::from(code)).copied()
}

/// The code of `setting` in `all`.
fn code_of<T: PartialEq>(all: &[T], setting: &T) -> u8 {
    let index = all.iter().position(|each| each == setting).expect("listed");
    u8::try_from(index).expect("a few settings")
}

/// What the receiver reports of itself. The ODM version and the CRC are this model's: neither holds
/// `0A`, which a driver that splits lines there would take as an end.
// ceiling: no public document gives the S1216F8's versions or CRC
const KERNEL: [u8; 4] = [0, 1, 4, 33];
const ODM: [u8; 4] = [0, 1, 4, 33];
const REVISION: [u8; 4] = [0, 20, 7, 24];
const CRC: [u8; 2] = [0x5A, 0x3C];
/// Booted from flash, a Winbond-type flash.
const BOOT: [u8; 2] = [0, 1];
/// The valid bits of a GPS time reply: time of week, week and leap seconds.
const TIME_VALID: u8 = 0b111;

/// Satellites a 2D and a 3D fix take.
const FIX_2D: u8 = 3;
const FIX_3D: u8 = 4;
/// The most satellites a `GSA` lists.
const GSA_SATELLITES: u8 = 12;
const DILUTION: &str = "1.4,0.8,1.1";
const HDOP: &str = "0.8";

const KNOTS_PER_METER_SECOND: f64 = 3600.0 / 1852.0;
const KILOMETERS_HOUR_PER_METER_SECOND: f64 = 3.6;
const DEGREES_PER_RADIAN: f64 = 180.0 / std::f64::consts::PI;
/// Ten-thousandths of a minute in a degree, the precision of a written angle.
const TICKS_PER_DEGREE: f64 = 600_000.0;
const TICKS_PER_MINUTE: u64 = 10_000;
const MINUTES_PER_DEGREE: u64 = 60;
const CENTIMETERS_PER_METER: f64 = 100.0;
const MILLIMETERS_PER_METER: f64 = 1000.0;

/// What the host has set.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
struct Settings {
    /// Each string's interval in seconds, 0 for off, in the order of [`STRINGS`].
    intervals: [u8; 14],
    rate: NonZeroU8,
    talker: Talker,
    output: Output,
    power_save: bool,
    baud: u8,
}

impl Default for Settings {
    // ceiling: AN0037 gives no factory output, so it's GGA, GSA, GSV and RMC once a second, the NMEA
    // a receiver commonly starts with, on the GN talker Ex-Alta 2's flight software parses
    fn default() -> Self {
        let mut intervals = [0; 14];
        for string in [GGA, GSA, GSV, RMC] {
            intervals[string] = 1;
        }
        Self {
            intervals,
            rate: NonZeroU8::MIN,
            talker: Talker::Gn,
            output: Output::Nmea,
            power_save: false,
            baud: 5,
        }
    }
}

/// A SkyTraq receiver on the far end of a serial line.
#[derive(Debug, serde::Serialize, serde::Deserialize)]
pub struct Receiver {
    settings: Settings,
    epoch: GpsTime,
    position: [i32; 3],
    velocity: [i32; 3],
    satellites: u8,
    /// The GPS time of the last fix written.
    written: Option<GpsTime>,
    input: Vec<u8>,
    pending: VecDeque<u8>,
}

impl Receiver {
    /// A receiver with its factory settings at the GPS epoch, at the Earth's center and seeing
    /// nothing, until the board says otherwise.
    #[must_use]
    pub fn new() -> Self {
        Self {
            settings: Settings::default(),
            epoch: GpsTime::default(),
            position: [0; 3],
            velocity: [0; 3],
            satellites: 0,
            written: None,
            input: Vec::new(),
            pending: VecDeque::new(),
        }
    }

    /// The GPS time the run's clock starts from: `time_of_week` milliseconds into GPS week `week`.
    pub fn set_epoch(&mut self, week: u16, time_of_week: u32) {
        let epoch = GpsTime::from_week(week, time_of_week);
        if epoch != self.epoch {
            self.epoch = epoch;
            self.written = None;
        }
    }

    /// Where the antenna is from now on, in centimeters in the Earth's frame.
    pub fn set_position(&mut self, centimeters: [i32; 3]) {
        self.position = centimeters;
    }

    /// How fast the antenna moves from now on, in millimeters a second in the Earth's frame.
    pub fn set_velocity(&mut self, millimeters_a_second: [i32; 3]) {
        self.velocity = millimeters_a_second;
    }

    /// How many satellites the antenna sees from now on.
    pub fn set_satellites(&mut self, satellites: u8) {
        self.satellites = satellites;
    }

    /// Takes every whole message in what's come in and queues what it answers.
    fn take_messages(&mut self, now: VirtualNanos) {
        loop {
            let Some(start) = self.input.windows(2).position(|pair| pair == START) else {
                let keep = usize::from(self.input.last() == Some(&START[0]));
                self.input.drain(..self.input.len() - keep);
                return;
            };
            self.input.drain(..start);
            let Some(&[high, low]) = self.input.get(2..4) else {
                return;
            };
            let length = usize::from(u16::from_be_bytes([high, low]));
            if length == 0 || length > LONGEST_PAYLOAD {
                self.input.drain(..1);
                continue;
            }
            if self.input.len() < length + FRAMING {
                return;
            }
            let message: Vec<u8> = self.input.drain(..length + FRAMING).collect();
            let payload = &message[4..4 + length];
            let whole = message[4 + length] == checksum(payload) && message[5 + length..] == END;
            let answer = if whole {
                self.answer(payload, now)
            } else {
                Err(Refused)
            };
            let replies = answer.map_or_else(
                |Refused| vec![acknowledgement(NACK, payload)],
                |replies| {
                    let mut all = vec![acknowledgement(ACK, payload)];
                    all.extend(replies);
                    all
                },
            );
            for reply in replies {
                self.pending.extend(framed(&reply));
            }
        }
    }

    /// The replies after the ACK to a message taken, or why it's refused.
    fn answer(&mut self, payload: &[u8], now: VirtualNanos) -> Result<Vec<Vec<u8>>, Refused> {
        let none = Ok(Vec::new());
        match *payload {
            [id::RESTART, mode, ..] if payload.len() == 15 => {
                (1..=3).contains(&mode).then(Vec::new).ok_or(Refused)
            }
            [id::SOFTWARE_VERSION, kind] if kind <= 1 => Ok(vec![
                [
                    &[reply::SOFTWARE_VERSION, kind][..],
                    &KERNEL,
                    &ODM,
                    &REVISION,
                ]
                .concat(),
            ]),
            [id::SOFTWARE_CRC, kind] if kind <= 1 => {
                Ok(vec![[&[reply::SOFTWARE_CRC, kind][..], &CRC].concat()])
            }
            [id::FACTORY_DEFAULTS, _] => {
                self.settings = Settings::default();
                none
            }
            [id::SERIAL_PORT, 0, baud, attribute]
                if baud <= BAUD_CODES && attribute <= MOST_ATTRIBUTE =>
            {
                self.settings.baud = baud;
                none
            }
            [id::MESSAGE_TYPE, kind, attribute] if attribute <= 1 => {
                self.settings.output = coded(&Output::ALL, kind).ok_or(Refused)?;
                none
            }
            [id::QUERY_MESSAGE_TYPE] => Ok(vec![vec![
                reply::MESSAGE_TYPE,
                code_of(&Output::ALL, &self.settings.output),
            ]]),
            [id::POWER_MODE, mode, attribute] if mode <= 1 && attribute <= MOST_ATTRIBUTE => {
                self.settings.power_save = mode == 1;
                none
            }
            [id::QUERY_POWER_MODE] => Ok(vec![vec![
                reply::POWER_MODE,
                u8::from(self.settings.power_save),
            ]]),
            [id::POSITION_RATE, rate, attribute] if attribute <= 1 => {
                self.settings.rate = NonZeroU8::new(rate)
                    .filter(|rate| RATES.contains(&rate.get()))
                    .ok_or(Refused)?;
                none
            }
            [id::QUERY_POSITION_RATE] => {
                Ok(vec![vec![reply::POSITION_RATE, self.settings.rate.get()]])
            }
            [id::TALKER, talker, attribute] if attribute <= 1 => {
                self.settings.talker = coded(&Talker::ALL, talker).ok_or(Refused)?;
                none
            }
            [id::QUERY_TALKER] => Ok(vec![vec![
                reply::TALKER,
                code_of(&Talker::ALL, &self.settings.talker),
            ]]),
            [id::EXTENDED, id::BOOT_STATUS] => Ok(vec![
                [&[id::EXTENDED, reply::BOOT_STATUS][..], &BOOT].concat(),
            ]),
            [id::EXTENDED, id::GPS_TIME] => Ok(vec![self.gps_time(now)]),
            [
                id::EXTENDED,
                id::STRING_INTERVAL,
                a,
                b,
                c,
                interval,
                attribute,
            ] if attribute <= 1 => {
                let string = string_index([a, b, c]).ok_or(Refused)?;
                self.settings.intervals[string] = interval;
                none
            }
            [id::EXTENDED, id::QUERY_STRING_INTERVAL, a, b, c] => {
                let string = string_index([a, b, c]).ok_or(Refused)?;
                Ok(vec![vec![
                    id::EXTENDED,
                    reply::STRING_INTERVAL,
                    self.settings.intervals[string],
                ]])
            }
            _ => Err(Refused),
        }
    }

    /// The `64 8E` reply at `now`.
    fn gps_time(&self, now: VirtualNanos) -> Vec<u8> {
        let time = self.epoch.plus(now.0);
        let (week, millis) = time.week();
        let past = u32::try_from(time.0 % (NANOS_PER_SECOND / 1000)).expect("under a millisecond");
        let leap = i8::try_from(LEAP_SECONDS).expect("a few seconds");
        let valid = if self.satellites > 0 { TIME_VALID } else { 0 };
        let mut reply = vec![id::EXTENDED, reply::GPS_TIME];
        reply.extend(u32::try_from(millis).expect("a week").to_be_bytes());
        reply.extend(past.to_be_bytes());
        reply.extend(u16::try_from(week).unwrap_or(u16::MAX).to_be_bytes());
        reply.extend([leap.to_be_bytes()[0], leap.to_be_bytes()[0], valid]);
        reply
    }

    /// The sentences of the fix at `time`, those whose interval divides its second.
    fn write_fix(&self, time: GpsTime, into: &mut String) {
        let second = time.0 / NANOS_PER_SECOND;
        let due = |string: usize| {
            let interval = u64::from(self.settings.intervals[string]);
            interval > 0 && second.is_multiple_of(interval)
        };
        let fix = Fix::new(self, time);
        for string in WRITTEN.into_iter().filter(|&string| due(string)) {
            let talker = if string == GSA || self.settings.talker != Talker::Gn {
                "GP"
            } else {
                "GN"
            };
            let start = into.len();
            into.push('$');
            into.push_str(talker);
            into.push_str(STRINGS[string]);
            fix.body(string, into);
            let sum = checksum(&into.as_bytes()[start + 1..]);
            put(into, format_args!("*{sum:02X}\r\n"));
        }
    }
}

impl Default for Receiver {
    fn default() -> Self {
        Self::new()
    }
}

store!(Receiver);

impl Peer for Receiver {
    fn receive(&mut self, word: u16, context: &mut Timeline<'_, '_>) {
        self.input
            .push(u8::try_from(word & 0xFF).expect("masked to a byte"));
        self.take_messages(context.now());
    }

    fn power_changed(&mut self, _on: bool, _context: &mut Timeline<'_, '_>) {
        self.settings = Settings::default();
        self.written = None;
        self.input.clear();
        self.pending.clear();
    }

    fn transmit(&mut self, now: VirtualNanos) -> Option<u16> {
        let period = NANOS_PER_SECOND / u64::from(self.settings.rate.get());
        let time = self.epoch.plus(now.0);
        let fix = GpsTime(time.0 - time.0 % period);
        if self.pending.is_empty()
            && self.written.is_none_or(|written| fix > written)
            && self.settings.output == Output::Nmea
        {
            self.written = Some(fix);
            if fix.0.is_multiple_of(NANOS_PER_SECOND) {
                let mut text = String::new();
                self.write_fix(fix, &mut text);
                self.pending.extend(text.bytes());
            }
        }
        self.pending.pop_front().map(u16::from)
    }
}

/// A message refused, which a NACK answers.
#[derive(Debug, Clone, Copy)]
struct Refused;

/// The XOR of `bytes`.
fn checksum(bytes: &[u8]) -> u8 {
    bytes.iter().fold(0, |sum, byte| sum ^ byte)
}

/// `payload` as a whole message.
fn framed(payload: &[u8]) -> Vec<u8> {
    let length = u16::try_from(payload.len()).expect("a reply is short");
    [
        &START[..],
        &length.to_be_bytes(),
        payload,
        &[checksum(payload)],
        &END,
    ]
    .concat()
}

/// The ACK or NACK of `payload`: its ID, and its sub-ID where the ID has one.
fn acknowledgement(kind: u8, payload: &[u8]) -> Vec<u8> {
    match payload {
        [id, sub, ..] if WITH_SUB_ID.contains(id) => vec![kind, *id, *sub],
        [id, ..] => vec![kind, *id],
        [] => vec![kind],
    }
}

fn string_index(name: [u8; 3]) -> Option<usize> {
    STRINGS.iter().position(|string| string.as_bytes() == name)
}

fn put(into: &mut String, text: std::fmt::Arguments<'_>) {
    into.write_fmt(text)
        .expect("a string takes what is written");
}

/// One fix as the sentences write it.
struct Fix {
    time: crate::chip::earth::Utc,
    place: Geodetic,
    /// 0 for none, 2 for 2D, 3 for 3D.
    dimensions: u8,
    satellites: u8,
    knots: f64,
    kilometers_an_hour: f64,
    course: f64,
}

impl Fix {
    fn new(receiver: &Receiver, time: GpsTime) -> Self {
        let place = Geodetic::from_ecef(
            receiver
                .position
                .map(|centimeters| f64::from(centimeters) / CENTIMETERS_PER_METER),
        );
        let [east, north, _] = place.east_north_up(
            receiver
                .velocity
                .map(|millimeters| f64::from(millimeters) / MILLIMETERS_PER_METER),
        );
        let ground = (east * east + north * north).sqrt();
        let course = crate::chip::earth::atan2(east, north) * DEGREES_PER_RADIAN;
        let dimensions = match receiver.satellites {
            0..FIX_2D => 0,
            FIX_2D => 2,
            FIX_3D.. => 3,
        };
        Self {
            time: time.utc(),
            place,
            dimensions,
            satellites: receiver.satellites,
            knots: ground * KNOTS_PER_METER_SECOND,
            kilometers_an_hour: ground * KILOMETERS_HOUR_PER_METER_SECOND,
            course: course.rem_euclid(360.0),
        }
    }

    fn fixed(&self) -> bool {
        self.dimensions > 0
    }

    /// `hhmmss.sss`.
    fn clock(&self, into: &mut String) {
        let time = &self.time;
        put(
            into,
            format_args!(
                "{:02}{:02}{:02}.{:03}",
                time.hour, time.minute, time.second, time.millisecond
            ),
        );
    }

    /// Latitude then longitude, each degrees and minutes to four places and a hemisphere, or four
    /// empty fields with no fix.
    fn position(&self, into: &mut String) {
        if !self.fixed() {
            into.push_str(",,,");
            return;
        }
        angle(into, self.place.latitude, 2, ['N', 'S']);
        into.push(',');
        angle(into, self.place.longitude, 3, ['E', 'W']);
    }

    /// What follows the sentence's name, from its first comma.
    fn body(&self, string: usize, into: &mut String) {
        let valid = if self.fixed() { 'A' } else { 'V' };
        let mode = if self.fixed() { 'A' } else { 'N' };
        into.push(',');
        match string {
            GGA => {
                self.clock(into);
                into.push(',');
                self.position(into);
                if self.fixed() {
                    put(
                        into,
                        format_args!(
                            ",1,{:02},{HDOP},{:.1},M,0.0,M,,",
                            self.satellites, self.place.height
                        ),
                    );
                } else {
                    put(into, format_args!(",0,{:02},,,M,,M,,", self.satellites));
                }
            }
            GSA => {
                let mode = self.dimensions.max(1);
                put(into, format_args!("A,{mode}"));
                for slot in 1..=GSA_SATELLITES {
                    if self.fixed() && slot <= self.satellites {
                        put(into, format_args!(",{slot:02}"));
                    } else {
                        into.push(',');
                    }
                }
                if self.fixed() {
                    put(into, format_args!(",{DILUTION}"));
                } else {
                    into.push_str(",,,");
                }
            }
            GLL => {
                self.position(into);
                into.push(',');
                self.clock(into);
                put(into, format_args!(",{valid},{mode}"));
            }
            RMC => {
                self.clock(into);
                put(into, format_args!(",{valid},"));
                self.position(into);
                let time = &self.time;
                if self.fixed() {
                    put(into, format_args!(",{:.1},{:.1}", self.knots, self.course));
                } else {
                    into.push_str(",,");
                }
                put(
                    into,
                    format_args!(
                        ",{:02}{:02}{:02},,,{mode}",
                        time.day,
                        time.month,
                        time.year % 100
                    ),
                );
            }
            VTG => {
                if self.fixed() {
                    put(
                        into,
                        format_args!(
                            "{:.1},T,,M,{:.1},N,{:.1},K,{mode}",
                            self.course, self.knots, self.kilometers_an_hour
                        ),
                    );
                } else {
                    put(into, format_args!(",T,,M,,N,,K,{mode}"));
                }
            }
            _ => {
                self.clock(into);
                let time = &self.time;
                put(
                    into,
                    format_args!(",{:02},{:02},{:04},00,00", time.day, time.month, time.year),
                );
            }
        }
    }
}

/// An angle in radians as degrees of `digits` places, minutes to four places, and its hemisphere,
/// `hemispheres` the positive then the negative.
fn angle(into: &mut String, radians: f64, digits: usize, hemispheres: [char; 2]) {
    let ticks = nearest((radians * DEGREES_PER_RADIAN).abs() * TICKS_PER_DEGREE).unsigned_abs();
    let per_degree = MINUTES_PER_DEGREE * TICKS_PER_MINUTE;
    let (degrees, minutes) = (ticks / per_degree, ticks % per_degree);
    let hemisphere = hemispheres[usize::from(radians < 0.0)];
    put(
        into,
        format_args!(
            "{degrees:0digits$}{:02}.{:04},{hemisphere}",
            minutes / TICKS_PER_MINUTE,
            minutes % TICKS_PER_MINUTE
        ),
    );
}

#[cfg(test)]
mod tests {
    use super::*;
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

    fn feed(receiver: &mut Receiver, bytes: &[u8]) {
        let mut effects = Effects::default();
        let mut context = DeviceContext::new(VirtualNanos(0), 0, PERIPHERAL, &mut effects);
        let mut timeline = Timeline::new(&mut context);
        for &byte in bytes {
            receiver.receive(u16::from(byte), &mut timeline);
        }
    }

    fn drained(receiver: &mut Receiver) -> Vec<u16> {
        std::iter::from_fn(|| receiver.transmit(VirtualNanos(0))).collect()
    }

    #[test]
    fn a_snapshot_keeps_the_settings_and_the_line() {
        let mut kept = Receiver::new();
        feed(&mut kept, &framed(&[id::MESSAGE_TYPE, 0, 0]));
        feed(&mut kept, &framed(&[id::POSITION_RATE, 5, 0]));
        drained(&mut kept);
        let query = framed(&[id::QUERY_POSITION_RATE]);
        feed(&mut kept, &query[..3]);
        let bytes = snapshot::stored(&kept).expect("the receiver stores itself");
        let mut restored = Receiver::new();
        snapshot::load(&mut restored, snapshot::keep(bytes.clone())).expect("and reads back");
        assert_eq!(snapshot::stored(&restored).expect("stores again"), bytes);
        for receiver in [&mut kept, &mut restored] {
            feed(receiver, &query[3..]);
        }
        let answer = drained(&mut kept);
        assert_eq!(
            answer,
            [
                framed(&[ACK, id::QUERY_POSITION_RATE]),
                framed(&[reply::POSITION_RATE, 5])
            ]
            .concat()
            .into_iter()
            .map(u16::from)
            .collect::<Vec<_>>()
        );
        assert_eq!(drained(&mut restored), answer);
    }
}
