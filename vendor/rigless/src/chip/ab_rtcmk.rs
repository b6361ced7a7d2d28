// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! The Abracon `AB-RTCMK-32.768kHz`, a real-time clock module on an I2C bus: a calendar in BCD from
//! seconds to years, an alarm on minute, hour and day or weekday, a fixed-cycle timer, a time update
//! interrupt by the second or the minute, a clock output, and an open-drain `/INT` pin that signals
//! the three interrupts.
//!
//! **Where the facts come from.** Abracon publishes a short form of this part's datasheet, revised
//! 09.30.12, with its features, its electrical characteristics, its pins and its block diagram, and
//! a note that the full datasheet comes from Abracon's support on request. The part is end of
//! life, last time buy 11/30/2021, and the full datasheet is not public. So the short form is cited
//! by its headings, and what it does not say has three other sources, named in the table:
//!
//! * **The register map and the slave address** are read as facts from the header of the driver
//!   Ex-Alta 2's flight software uses for this part, `rtcmk.h`, in AlbertaSat's public repository.
//!   Nothing of it is copied. The map is registers `00h` to `0Dh`: seconds, minutes, hours, weekday,
//!   day, month and year; the alarm's minute, hour and weekday or day; the timer's counter; and the
//!   select, flag and control registers. The address is `0x32`.
//! * **What a flag or an interrupt does where the short form is silent** follows the family
//!   convention of Epson's real-time clocks, whose application manuals are public. Their registers
//!   differ from this part's, so only behaviors are borrowed, and each is marked as an assumption
//!   with the manual's section: `RX8900CE`, ETM45E-11, and `RX8804CE`, ETM59E-07.
//! * **A decision of this model** is marked as one.
//!
//! **The time is derived from virtual time.** A write to the seconds register sets the calendar at
//! that instant and the next second ends a second later. The calendar is advanced to an instant at
//! each access and at each event, by whole seconds from the last, so a year of virtual time asked
//! for at once is the same calendar as a year of events. The chip schedules an event only while a
//! pin or a flag needs one: the next second while the time update or the alarm interrupt is
//! enabled, the end of the update pulse, and the timer's next period.
//!
//! **The `/INT` pin is a level the controller carries.** The chip answers [`Peer::interrupt_pin`],
//! which a controller that wires the pin to its part asks after every call and every event. The pin
//! is high when released, with the pull-up an open drain needs, and low while it signals.
//!
//! | Register or section | Behavior | Source | Test |
//! |---|---|---|---|
//! | The address | Acknowledges `0x32` and nothing else, in either direction | Driver header, `RTCMK_ADDR` | `it_answers_at_0x32_and_nowhere_else` |
//! | The calendar | Seconds, minutes, hours, weekday, day, month and year in BCD at `00h` to `06h`, counted from the instant the board starts them. Hours are 24-hour. A year past 99 wraps to 00 | Short form, FEATURES "Clock function : Hour/ Min / Sec", driver header's masks | `the_calendar_reads_the_start_time_and_counts_seconds`, `the_calendar_carries_across_a_minute_an_hour_and_a_day` |
//! | Leap years | "Leap year automatic distinction calendar function till 2099": February has 29 days when the two-digit year divides by four, and 2000 is one | Short form, FEATURES | `february_has_29_days_in_a_leap_year_and_28_in_the_next_year`, `the_calendar_carries_across_a_year_and_a_century_boundary_of_the_two_digit_year` |
//! | The weekday | A count from 0 for Sunday to 6 for Saturday that goes up with each day. The short form gives no encoding. The driver header names the days `00h` to `06h`, and the model follows | Driver header, `_RTCMK_WEEK_WEEK_SUN` to `_SAT`. **Assumption:** the encoding | `the_weekday_counts_from_sunday_and_follows_each_day` |
//! | The start time | 2026-01-01T00:00:00Z at virtual time zero unless [`AbRtcmk::with_time`] gives another | Not a datasheet behavior | `with_time_sets_the_calendar_at_virtual_time_zero` |
//! | Setting the time | A write to a time register sets that field at once. A write to the seconds register also restarts the second, so the next one ends a second after it. Writing the seven registers in one transfer sets the calendar | Short form, FEATURES. **Assumption:** the restart, from RX8804CE ETM59E-07 8.2.1 (a write to the seconds register clears the divider below one second) | `a_write_sets_the_time_and_the_next_second_ends_a_second_later`, `a_burst_write_of_the_calendar_sets_it_whole` |
//! | The pointer | The first byte of a write is the register address, a read starts at the address last set, and each byte read or written moves it to the next. It keeps its value across a stop, so a driver that writes the address in one transfer and reads in the next finds the register | Driver `RTCMK_RegisterGet`, which writes the address and then reads | `a_read_in_its_own_transfer_uses_the_address_the_last_write_set`, `a_read_after_a_restart_uses_the_address_just_written` |
//! | Registers past `0Dh` | Read zero and take no write. The pointer moves on over them | Driver header's map. **Assumption:** the behavior past it | `registers_past_the_map_read_zero_and_take_no_write` |
//! | The alarm | `07h` minute, `08h` hour and `09h` weekday or day, each with an enable in bit 7 that is **clear to compare**. At the instant the minute changes, if at least one field is enabled and every enabled field matches, `AF` sets. The select register's `AS` bit picks the weekday (clear) or the day (set) for `09h` | Short form, FEATURES "Alarm interruption function for day, date, hour and minute settings", driver header `_AE_ENABLE`, `_AS_DAYOFWEEK`. **Assumption:** the compare at the minute and no alarm with every field disabled, from RX8900CE ETM45E-11 8.5 | `the_alarm_sets_af_at_the_minute_its_enabled_fields_match`, `an_alarm_with_every_field_disabled_never_fires`, `as_picks_the_weekday_or_the_day_for_the_alarm` |
//! | The timer | `0Ah` counts down from its value at the period `TSS` gives: 4096 Hz, 64 Hz, 1 Hz or once a minute, so one count is 244.14 µs at the least and 255 counts of a minute is 255 minutes. `TE` starts it at the write. Each time it reaches zero `TF` sets and it starts again. A zero counter never fires | Short form, FEATURES "A constant cycle timer interruption function : 244.14us to 255 min", driver header's `TE` and `TSS`. **Assumption:** the reload, and that zero never fires | `the_timer_sets_tf_every_count_periods_and_reloads`, `the_timer_source_picks_the_period`, `a_zero_counter_never_fires_and_te_clear_stops_it` |
//! | The time update flag | `UTF` sets when the second changes, or the minute with `UTS` set, whether or not its interrupt is enabled | Short form, FEATURES "Time update interruption function：Min / Sec", driver header's `UTS`. **Assumption:** the flag sets either way, from RX8900CE ETM45E-11 8.4 | `utf_sets_at_each_second_or_each_minute_by_uts` |
//! | The `/INT` pin: the update interrupt | With `UTIE` set an update event pulls `/INT` low for 7.813 ms and then releases it, and clearing `UTF` or `UTIE` releases it at once. The flag stays set until the driver clears it. The flight software enables this interrupt once and never clears the flag, and counts the falling edge each second, so the pin must release by itself | Short form, FUNCTION "/INT ... Output ... open drain". **Assumption:** the width and the release, from RX8900CE ETM45E-11 8.4 | `the_update_interrupt_pulls_int_low_for_a_pulse_each_second`, `clearing_utf_or_utie_releases_int_at_once` |
//! | The `/INT` pin: the alarm and the timer | With `AIE` or `TIE` set, `AF` or `TF` holds `/INT` low until the driver clears the flag | Short form, FUNCTION. **Assumption:** the hold, from RX8900CE ETM45E-11 8.5, and the timer's release, which Epson makes a pulse | `the_alarm_and_timer_flags_hold_int_low_until_cleared` |
//! | The flag register `0Ch` | `UTF` bit 0, `AF` bit 1, `TF` bit 2, `VDLF` bit 4 and `VDHF` bit 5. A write of zero to a bit clears it and a write of one leaves it. The other bits read zero | Driver header, `_RTCMK_FLAG_*`. **Assumption:** the write rule, from RX8900CE ETM45E-11 8.2.6 | `a_flag_clears_on_a_written_zero_and_not_on_a_written_one` |
//! | The control register `0Dh` | `UTIE` bit 0, `AIE` bit 1, `TIE` bit 2, `TE` bit 3, `FIE` bit 4, `RAM` bit 5, `TEST` bit 6 and `RESET` bit 7, all stored. A set `RESET` takes effect at the stop that ends the transfer and clears itself: the divider below one second and the timer start over, so the next second ends a second after the stop | Driver header, `_RTCMK_CONTROL_*`. **Assumption:** what `RESET` does, from RX8900CE ETM45E-11 8.2.7 | `reset_restarts_the_second_at_the_stop_and_clears_itself`, `the_control_register_stores_every_bit` |
//! | The select register `0Bh` | `UTS` bit 0, `AS` bit 1, `TSS` bits 3 to 2, `CFS` bits 5 to 4 and `TCS` bits 7 to 6, stored | Driver header, `_RTCMK_SELECT_*` | `the_select_register_stores_every_field` |
//! | The clock output | `CFS` picks 32.768 kHz, 1024 Hz, 32 Hz or 1 Hz for `CLKOUT`, which [`AbRtcmk::clock_output_hz`] answers. `CLKOE` low leaves the pin high impedance, and the board doesn't wire it | Short form, FEATURES "Clock output function：32.768kHz / 1024Hz / 32Hz / 1Hz", FUNCTION | `cfs_picks_the_clock_output_frequency` |
//! | Power-up | The flag register reads `VDLF` set and every other flag clear, as a part that has just had power: the time is not to be trusted until the driver clears it. The alarm fields come up disabled, the counter, select and control registers at zero | Driver header, `_RTCMK_FLAG_VDLF_DEFAULT` set. **Assumption:** the rest | `power_up_sets_vdlf_and_nothing_else` |
//! | Low voltage | A supply under 1.4 V, the typical detection voltage, sets `VDLF`, and the driver clears it once the supply is back | Short form, STANDARD SPECIFICATIONS "Low Voltage Detection Voltage (VDET)", 1.3 V minimum, 1.4 V typical, 1.5 V maximum | `a_low_supply_sets_vdlf` |
//! | The flight software's driver | `RTCMK_SetUnix` writes the six calendar registers in a transfer each, `RTCMK_GetUnix` reads them with an address transfer and a read each, and `RTCMK_EnableInt` reads the control register, clears `UTIE`, clears the flags and the counter, and sets `UTIE`, which leaves one falling edge on `/INT` a second | Driver, `rtcmk.c` | `the_flight_software_driver_sequences_work` |
//! | A restart of the part | The calendar goes on and the events the chip scheduled are scheduled again | Not a datasheet behavior | `a_restart_of_the_part_schedules_its_events_again` |
//! | Determinism | The same accesses at the same instants give the same bytes, and a chip restored from its saved state goes on as the original does | Not a datasheet behavior | `the_same_accesses_give_the_same_bytes_and_a_restored_chip_goes_on_alike` |
//!
//! # What the model leaves out
//!
//! | Departure | Reason |
//! |---|---|
//! | `VDHF` | The driver header names the bit and the short form says nothing of a high-voltage detect. It never sets and clears on a written zero like the rest |
//! | `FIE` and `TEST` | The header names the bits and nothing says what they do. They are stored |
//! | `TCS`, the temperature compensation interval | The short form gives accuracy, ±5 ppm over temperature, and not the register's effect. The time is exact, so the interval is stored |
//! | The oscillator's accuracy, start up time and current | Characteristics of the short form's table, not behaviors. The calendar keeps virtual time exactly |
//! | The `CLKOUT` waveform | No pin carries it. The selected frequency is answered and nothing toggles |
//! | The bus timing of the short form's AC characteristics | The seam carries bytes and not clock edges |
//! | A 12-hour mode | Neither the short form nor the driver header names one |
//! | An `/INT` for the timer that releases after a pulse | Epson's family does. The short form does not say, and the flight software doesn't use the timer |
//! | A time field read between two seconds of a rollover | A driver that reads the registers one at a time can read a calendar that rolled over between two reads. So can the part |
//! | The alarm and timer at the same instant as an access | The alarm compares at the minute change and the timer fires at its period, and an access at that instant sees the event already done |

use crate::chip::Timeline;
use crate::chip::i2c::Peer;
use crate::device::Level;
use crate::snapshot::store;
use crate::time::{EventId, NANOS_PER_SECOND, VirtualNanos};

/// The slave address, the driver header's `RTCMK_ADDR`.
pub const ADDRESS: u8 = 0x32;

/// 2026-01-01T00:00:00Z, the calendar at virtual time zero unless the board gives another.
pub const DEFAULT_START: u64 = 1_767_225_600;

/// 2000-01-01T00:00:00Z and 2100-01-01T00:00:00Z, the span the two-digit year holds.
const FIRST_UNIX: u64 = 946_684_800;
const PAST_LAST_UNIX: u64 = 4_102_444_800;

/// The register map, by address: the driver header's `RTCMK_Register_TypeDef`.
const SECOND: u8 = 0x00;
const MINUTE: u8 = 0x01;
const HOUR: u8 = 0x02;
const WEEK: u8 = 0x03;
const DAY: u8 = 0x04;
const MONTH: u8 = 0x05;
const YEAR: u8 = 0x06;
const MINUTE_ALARM: u8 = 0x07;
const HOUR_ALARM: u8 = 0x08;
const DAY_ALARM: u8 = 0x09;
const COUNTER: u8 = 0x0A;
const SELECT: u8 = 0x0B;
const FLAG: u8 = 0x0C;
const CONTROL: u8 = 0x0D;

/// The bits each calendar register holds, the header's `_MASK`s.
const SECOND_BITS: u8 = 0x7F;
const MINUTE_BITS: u8 = 0x7F;
const HOUR_BITS: u8 = 0x3F;
const WEEK_BITS: u8 = 0x07;
const DAY_BITS: u8 = 0x3F;
const MONTH_BITS: u8 = 0x1F;

/// An alarm register's enable bit, which is clear to compare: the header's `_AE_ENABLE` is zero.
const ALARM_DISABLE: u8 = 0x80;
const MINUTE_ALARM_BITS: u8 = 0x7F;
const HOUR_ALARM_BITS: u8 = 0x7F;
const DAY_ALARM_BITS: u8 = 0x3F;
const WEEKDAY_ALARM_BITS: u8 = 0x07;

/// The select register's fields.
const UTS: u8 = 0x01;
const AS: u8 = 0x02;
const TSS: u8 = 0x0C;
const TSS_SHIFT: u32 = 2;
const CFS: u8 = 0x30;
const CFS_SHIFT: u32 = 4;

/// The flag register's bits.
const UTF: u8 = 0x01;
const AF: u8 = 0x02;
const TF: u8 = 0x04;
const VDLF: u8 = 0x10;
const VDHF: u8 = 0x20;
const FLAGS: u8 = UTF | AF | TF | VDLF | VDHF;

/// The control register's bits.
const UTIE: u8 = 0x01;
const AIE: u8 = 0x02;
const TIE: u8 = 0x04;
const TE: u8 = 0x08;
const RESET: u8 = 0x80;

/// The supply under which `VDLF` sets, in millivolts: the short form's typical detection voltage.
const DETECTION_MILLIVOLTS: u32 = 1_400;

/// How long `/INT` stays low after an update event, in nanoseconds: 7.813 ms, RX8900CE 8.4.
const PULSE_NANOS: u64 = 7_813_000;

const SECONDS_PER_MINUTE: u64 = 60;
const SECONDS_PER_HOUR: u64 = 3_600;
const SECONDS_PER_DAY: u64 = 86_400;
const MINUTES_PER_HOUR: u8 = 60;
const HOURS_PER_DAY: u8 = 24;
const DAYS_PER_WEEK: u8 = 7;

/// The clock output frequencies `CFS` picks, in hertz.
const CLOCK_OUTPUT_HZ: [u32; 4] = [32_768, 1_024, 32, 1];

/// The timer's period for one count, as nanoseconds over a divisor, by `TSS`: 4096 Hz, 64 Hz, 1 Hz
/// and once a minute.
const TIMER_COUNT: [(u64, u64); 4] = [
    (NANOS_PER_SECOND, 4_096),
    (NANOS_PER_SECOND, 64),
    (NANOS_PER_SECOND, 1),
    (60 * NANOS_PER_SECOND, 1),
];

/// The calendar's seven registers, as numbers and not BCD.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
struct Calendar {
    second: u8,
    minute: u8,
    hour: u8,
    week: u8,
    day: u8,
    month: u8,
    year: u8,
}

/// The days in `month` of the two-digit `year`, counting every year divisible by four a leap year,
/// which holds until 2100. A month the calendar does not have, which a driver can write, has 31.
fn days_in(month: u8, year: u8) -> u8 {
    match month {
        2 if year.is_multiple_of(4) => 29,
        2 => 28,
        4 | 6 | 9 | 11 => 30,
        _ => 31,
    }
}

fn to_bcd(value: u8) -> u8 {
    let value = value % 100;
    value + 6 * (value / 10)
}

fn from_bcd(value: u8) -> u8 {
    (value >> 4) * 10 + (value & 0x0F)
}

impl Calendar {
    /// The calendar `seconds` after 1970-01-01T00:00:00Z, which must be in 2000 to 2099.
    fn from_unix(seconds: u64) -> Self {
        let days = seconds / SECONDS_PER_DAY;
        let rest = seconds % SECONDS_PER_DAY;
        // Howard Hinnant's days-to-civil, which counts from 0000-03-01.
        let shifted = days + 719_468;
        let era = shifted / 146_097;
        let day_of_era = shifted % 146_097;
        let year_of_era =
            (day_of_era - day_of_era / 1_460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
        let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
        let month_index = (5 * day_of_year + 2) / 153;
        let day = day_of_year - (153 * month_index + 2) / 5 + 1;
        let month = if month_index < 10 {
            month_index + 3
        } else {
            month_index - 9
        };
        let year = year_of_era + era * 400 + u64::from(month <= 2);
        let small = |value: u64| u8::try_from(value).expect("a calendar field");
        Self {
            second: small(rest % SECONDS_PER_MINUTE),
            minute: small(rest % SECONDS_PER_HOUR / SECONDS_PER_MINUTE),
            hour: small(rest / SECONDS_PER_HOUR),
            // 1970-01-01 was a Thursday.
            week: small((days + 4) % u64::from(DAYS_PER_WEEK)),
            day: small(day),
            month: small(month),
            year: small(year.saturating_sub(2000) % 100),
        }
    }

    /// Seconds after 1970-01-01T00:00:00Z, the inverse of [`Calendar::from_unix`] for a calendar
    /// that holds a real date. A month or day of zero counts as 1.
    fn to_unix(self) -> u64 {
        let month = u64::from(self.month.clamp(1, 12));
        let year = 2000 + u64::from(self.year) - u64::from(month <= 2);
        let era = year / 400;
        let year_of_era = year % 400;
        let month_index = (month + 9) % 12;
        let day_of_year = (153 * month_index + 2) / 5 + u64::from(self.day.max(1)) - 1;
        let day_of_era = year_of_era * 365 + year_of_era / 4 - year_of_era / 100 + day_of_year;
        let days = era * 146_097 + day_of_era - 719_468;
        days * SECONDS_PER_DAY
            + u64::from(self.hour) * SECONDS_PER_HOUR
            + u64::from(self.minute) * SECONDS_PER_MINUTE
            + u64::from(self.second)
    }

    /// The calendar one day on. A weekday goes up and wraps at seven, a day past the month's end
    /// goes to the first of the next, and a month past 12 to January of the next year.
    fn next_day(&mut self) {
        self.week = (self.week + 1) % DAYS_PER_WEEK;
        self.day += 1;
        if self.day > days_in(self.month, self.year) {
            self.day = 1;
            self.month += 1;
            if self.month > 12 {
                self.month = 1;
                self.year = (self.year + 1) % 100;
            }
        }
    }

    /// The calendar when the minute changes, with the seconds already at zero.
    fn next_minute(&mut self) {
        self.second = 0;
        self.minute += 1;
        if self.minute >= MINUTES_PER_HOUR {
            self.minute = 0;
            self.hour += 1;
            if self.hour >= HOURS_PER_DAY {
                self.hour = 0;
                self.next_day();
            }
        }
    }
}

/// Where an I2C transfer is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
enum Phase {
    Idle,
    /// The next byte written is the register address.
    Address,
    /// Further bytes written go to the register at the pointer.
    Write,
    /// The bytes read come from the register at the pointer.
    Read,
}

/// A running timer: when it started and how many periods have ended since.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
struct TimerRun {
    start: VirtualNanos,
    fired: u64,
}

/// One `AB-RTCMK-32.768kHz`.
#[derive(Debug, serde::Serialize, serde::Deserialize)]
pub struct AbRtcmk {
    time: Calendar,
    /// The instant `time` was exact: the last whole second, or the write that set it.
    anchor: VirtualNanos,
    minute_alarm: u8,
    hour_alarm: u8,
    day_alarm: u8,
    counter: u8,
    select: u8,
    flag: u8,
    control: u8,
    /// When the update pulse on `/INT` ends, while one is under way.
    pulse_until: Option<VirtualNanos>,
    timer: Option<TimerRun>,
    /// The event the chip last scheduled for the instant it next has to act.
    wake: Option<EventId>,
    pointer: u8,
    phase: Phase,
}

impl Default for AbRtcmk {
    fn default() -> Self {
        Self::new()
    }
}

impl AbRtcmk {
    /// A part just powered up, counting from [`DEFAULT_START`] at virtual time zero.
    #[must_use]
    pub fn new() -> Self {
        Self {
            time: Calendar::from_unix(DEFAULT_START),
            anchor: VirtualNanos(0),
            minute_alarm: ALARM_DISABLE,
            hour_alarm: ALARM_DISABLE,
            day_alarm: ALARM_DISABLE,
            counter: 0,
            select: 0,
            flag: VDLF,
            control: 0,
            pulse_until: None,
            timer: None,
            wake: None,
            pointer: 0,
            phase: Phase::Idle,
        }
    }

    /// The calendar at virtual time zero set to `unix_seconds` after 1970-01-01T00:00:00Z.
    ///
    /// # Panics
    ///
    /// On a time outside 2000-01-01 to 2099-12-31, which the two-digit year can't hold.
    #[must_use]
    pub fn with_time(mut self, unix_seconds: u64) -> Self {
        assert!(
            (FIRST_UNIX..PAST_LAST_UNIX).contains(&unix_seconds),
            "{unix_seconds} is outside 2000 to 2099"
        );
        self.time = Calendar::from_unix(unix_seconds);
        self.anchor = VirtualNanos(0);
        self
    }

    /// The time at `now`, in seconds after 1970-01-01T00:00:00Z.
    pub fn unix_time(&mut self, now: VirtualNanos) -> u64 {
        self.advance(now);
        self.time.to_unix()
    }

    /// The frequency `CLKOUT` has when `CLKOE` is high, in hertz, which `CFS` picks.
    #[must_use]
    pub fn clock_output_hz(&self) -> u32 {
        CLOCK_OUTPUT_HZ[usize::from((self.select & CFS) >> CFS_SHIFT)]
    }

    /// The supply the board gives the part from now on, in millivolts. Under the detection voltage
    /// `VDLF` sets.
    pub fn set_supply_millivolts(&mut self, millivolts: u32) {
        if millivolts < DETECTION_MILLIVOLTS {
            self.flag |= VDLF;
        }
    }

    /// Advances the calendar to the whole second at or before `now`, setting the update flag and
    /// starting the pulse at the second or the minute it ends, and the alarm flag at a minute that
    /// matches.
    fn advance(&mut self, now: VirtualNanos) {
        let whole = now.0.saturating_sub(self.anchor.0) / NANOS_PER_SECOND;
        if whole == 0 {
            return;
        }
        self.anchor = VirtualNanos(self.anchor.0 + whole * NANOS_PER_SECOND);
        if self.select & UTS == 0 {
            self.update(self.anchor);
        }
        let mut left = whole;
        while left > 0 {
            let to_minute = u64::from(MINUTES_PER_HOUR)
                .saturating_sub(u64::from(self.time.second))
                .max(1);
            if left < to_minute {
                self.time.second += u8::try_from(left).expect("under a minute");
                break;
            }
            left -= to_minute;
            self.time.next_minute();
            if self.select & UTS != 0 {
                self.update(VirtualNanos(self.anchor.0 - left * NANOS_PER_SECOND));
            }
            if self.alarm_matches() {
                self.flag |= AF;
            }
        }
    }

    /// An update event at `at`: the flag sets, and with `UTIE` set the pin goes low for a pulse.
    fn update(&mut self, at: VirtualNanos) {
        self.flag |= UTF;
        if self.control & UTIE != 0 {
            self.pulse_until = Some(VirtualNanos(at.0 + PULSE_NANOS));
        }
    }

    fn alarm_matches(&self) -> bool {
        let enabled = |register: u8| register & ALARM_DISABLE == 0;
        let by_day = self.select & AS != 0;
        let fields = [
            (
                enabled(self.minute_alarm),
                self.time.minute == from_bcd(self.minute_alarm & MINUTE_ALARM_BITS),
            ),
            (
                enabled(self.hour_alarm),
                self.time.hour == from_bcd(self.hour_alarm & HOUR_ALARM_BITS),
            ),
            (
                enabled(self.day_alarm),
                if by_day {
                    self.time.day == from_bcd(self.day_alarm & DAY_ALARM_BITS)
                } else {
                    self.time.week == self.day_alarm & WEEKDAY_ALARM_BITS
                },
            ),
        ];
        fields.iter().any(|&(enabled, _)| enabled)
            && fields.iter().all(|&(enabled, matches)| !enabled || matches)
    }

    /// The nanoseconds of one timer count as a numerator over a divisor, by `TSS`.
    fn timer_count(&self) -> (u128, u128) {
        let (nanos, divisor) = TIMER_COUNT[usize::from((self.select & TSS) >> TSS_SHIFT)];
        (u128::from(nanos), u128::from(divisor))
    }

    /// The instant the timer's `count`th period ends, rounded up to the nanosecond so a check
    /// at that instant finds it ended, or `None` for a counter of zero.
    fn timer_end(&self, run: TimerRun, count: u64) -> Option<VirtualNanos> {
        if self.counter == 0 {
            return None;
        }
        let (nanos, divisor) = self.timer_count();
        let span = (u128::from(count) * u128::from(self.counter) * nanos).div_ceil(divisor);
        Some(VirtualNanos(
            run.start
                .0
                .saturating_add(u64::try_from(span).unwrap_or(u64::MAX)),
        ))
    }

    /// Sets `TF` for the timer periods that ended by `now`.
    fn advance_timer(&mut self, now: VirtualNanos) {
        let Some(mut run) = self.timer.filter(|_| self.counter != 0) else {
            return;
        };
        let (nanos, divisor) = self.timer_count();
        let elapsed = u128::from(now.0.saturating_sub(run.start.0));
        let ended = elapsed * divisor / (u128::from(self.counter) * nanos);
        let ended = u64::try_from(ended).unwrap_or(u64::MAX);
        if ended > run.fired {
            run.fired = ended;
            self.flag |= TF;
            self.timer = Some(run);
        }
    }

    /// Brings every state that depends on time to `now`.
    fn catch_up(&mut self, now: VirtualNanos) {
        self.advance(now);
        self.advance_timer(now);
        if self.pulse_until.is_some_and(|until| until <= now) {
            self.pulse_until = None;
        }
    }

    /// Whether `/INT` is low, at the instant the state was last brought to.
    fn asserted(&self) -> bool {
        (self.flag & AF != 0 && self.control & AIE != 0)
            || (self.flag & TF != 0 && self.control & TIE != 0)
            || self.pulse_until.is_some()
    }

    /// The next instant something happens that the pin or a flag shows, after `now`.
    fn next_wake(&self) -> Option<VirtualNanos> {
        let mut wake = None;
        let mut consider = |at: VirtualNanos| {
            wake = Some(wake.map_or(at, |earlier: VirtualNanos| earlier.min(at)));
        };
        if self.control & (UTIE | AIE) != 0 {
            consider(VirtualNanos(self.anchor.0 + NANOS_PER_SECOND));
        }
        if let Some(end) = self
            .timer
            .and_then(|run| self.timer_end(run, run.fired + 1))
        {
            consider(end);
        }
        if let Some(until) = self.pulse_until {
            consider(until);
        }
        wake
    }

    /// Brings the chip to the instant of `context` and schedules the next instant it has to act.
    fn sync(&mut self, context: &mut Timeline<'_, '_>) {
        self.catch_up(context.now());
        self.wake = self.next_wake().map(|at| context.schedule(at));
    }

    fn read_register(&self, address: u8) -> u8 {
        match address {
            SECOND => to_bcd(self.time.second) & SECOND_BITS,
            MINUTE => to_bcd(self.time.minute) & MINUTE_BITS,
            HOUR => to_bcd(self.time.hour) & HOUR_BITS,
            WEEK => self.time.week & WEEK_BITS,
            DAY => to_bcd(self.time.day) & DAY_BITS,
            MONTH => to_bcd(self.time.month) & MONTH_BITS,
            YEAR => to_bcd(self.time.year),
            MINUTE_ALARM => self.minute_alarm,
            HOUR_ALARM => self.hour_alarm,
            DAY_ALARM => self.day_alarm,
            COUNTER => self.counter,
            SELECT => self.select,
            FLAG => self.flag & FLAGS,
            CONTROL => self.control,
            _ => 0,
        }
    }

    fn write_register(&mut self, address: u8, value: u8, now: VirtualNanos) {
        match address {
            SECOND => {
                self.time.second = from_bcd(value & SECOND_BITS);
                // Writing the seconds restarts the second, RX8804CE 8.2.1.
                self.anchor = now;
            }
            MINUTE => self.time.minute = from_bcd(value & MINUTE_BITS),
            HOUR => self.time.hour = from_bcd(value & HOUR_BITS),
            WEEK => self.time.week = value & WEEK_BITS,
            DAY => self.time.day = from_bcd(value & DAY_BITS),
            MONTH => self.time.month = from_bcd(value & MONTH_BITS),
            YEAR => self.time.year = from_bcd(value) % 100,
            MINUTE_ALARM => self.minute_alarm = value,
            HOUR_ALARM => self.hour_alarm = value,
            DAY_ALARM => self.day_alarm = value,
            COUNTER => {
                self.counter = value;
                self.restart_timer(now);
            }
            SELECT => {
                self.select = value;
                self.restart_timer(now);
            }
            FLAG => {
                // A written zero clears a flag and a written one leaves it.
                self.flag &= value | !FLAGS;
                if self.flag & UTF == 0 {
                    self.pulse_until = None;
                }
            }
            CONTROL => self.write_control(value, now),
            _ => {}
        }
    }

    fn write_control(&mut self, value: u8, now: VirtualNanos) {
        let before = self.control;
        self.control = value;
        if value & UTIE == 0 {
            self.pulse_until = None;
        }
        if before & TE == 0 && value & TE != 0 {
            self.restart_timer(now);
        } else if value & TE == 0 {
            self.timer = None;
        }
    }

    /// The timer counting from `now`, if `TE` is set.
    fn restart_timer(&mut self, now: VirtualNanos) {
        self.timer = (self.control & TE != 0).then_some(TimerRun {
            start: now,
            fired: 0,
        });
    }
}

impl Peer for AbRtcmk {
    fn start(&mut self, address: u8, read: bool, context: &mut Timeline<'_, '_>) -> bool {
        self.sync(context);
        if address != ADDRESS {
            self.phase = Phase::Idle;
            return false;
        }
        self.phase = if read { Phase::Read } else { Phase::Address };
        true
    }

    fn write(&mut self, byte: u8, context: &mut Timeline<'_, '_>) -> bool {
        self.sync(context);
        match self.phase {
            Phase::Address => {
                self.pointer = byte;
                self.phase = Phase::Write;
            }
            Phase::Write => {
                self.write_register(self.pointer, byte, context.now());
                self.pointer = self.pointer.wrapping_add(1);
                self.sync(context);
            }
            Phase::Idle | Phase::Read => return false,
        }
        true
    }

    fn read(&mut self, _last: bool, context: &mut Timeline<'_, '_>) -> u8 {
        self.sync(context);
        if self.phase != Phase::Read {
            return 0;
        }
        let byte = self.read_register(self.pointer);
        self.pointer = self.pointer.wrapping_add(1);
        byte
    }

    // The RESET bit takes effect at the stop that ends the transfer and clears itself, RX8900CE 8.2.7.
    fn stop(&mut self, context: &mut Timeline<'_, '_>) {
        self.phase = Phase::Idle;
        if self.control & RESET != 0 {
            let now = context.now();
            self.catch_up(now);
            self.control &= !RESET;
            self.anchor = now;
            self.restart_timer(now);
            self.sync(context);
        }
    }

    fn on_event(&mut self, event: EventId, context: &mut Timeline<'_, '_>) {
        if self.wake == Some(event) {
            self.sync(context);
        }
    }

    fn restarted(&mut self, context: &mut Timeline<'_, '_>) {
        self.phase = Phase::Idle;
        self.wake = None;
        self.sync(context);
    }

    fn interrupt_pin(&mut self, context: &mut Timeline<'_, '_>) -> Level {
        self.sync(context);
        Level::from(!self.asserted())
    }
}

store!(AbRtcmk);
