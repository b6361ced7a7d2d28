// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! The TMP117, a temperature sensor on an I2C bus: a 16-bit result at 7.8125 thousandths of a degree
//! a count, conversions run continuously, once or not at all, averaged over up to 64, two limits
//! that drive the `ALERT` pin, and an EEPROM that holds what the registers come up as.
//!
//! Written against TI's TMP117 datasheet, SNOSD82D, revised September 2022. Every section, table and
//! figure below is that document's.
//!
//! **Conversions are derived from virtual time.** Nothing is scheduled. At each access, and each time
//! a board asks for the `ALERT` pin, the conversions that ended since the mode, the cycle or the
//! averaging last changed are counted from table 7-7 and land from the temperature held at that
//! instant. What a driver polling `Data_Ready` or the pin can observe is the same. What it can't is
//! the temperature changing between two conversions.
//!
//! **The `ALERT` pin is a level a board reads.** [`Tmp117::alert`] answers the level on the pin at an
//! instant, with the pull-up its open drain needs. A chip on this seam has no line of its own back to
//! the part, so the board carries the level to whatever it wired the pin to.
//!
//! | Register or section | Behavior | Source | Test |
//! |---|---|---|---|
//! | The address | `ADD0` to ground, `V+`, `SDA` or `SCL` makes the address `1001000`, `1001001`, `1001010` or `1001011`, chosen by [`Add0`]. No other address is acknowledged | 7.5.3.1.2 table 7-2 | `it_answers_at_the_address_add0_selects_and_nowhere_else` |
//! | Power-up | "the device requires 1.5 ms to power up before conversions can begin". The registers load from the EEPROM with `EEPROM_Busy` set, "Any I2C writes performed during this initial POR period to the limit registers or the configuration register are ignored", and reads work | 7.3.1, 7.5.1.1 | `writes_to_the_configuration_and_limits_are_ignored_while_the_registers_load` |
//! | Reset values | Table 7-3: the result `8000h`, which "reads -256 °C before the first conversion", the configuration `0220h`, the high limit `6000h`, the low limit `8000h`, the unlock register, the offset and the device ID `0117h` | 7.6 table 7-3, 7.6.2 | `the_registers_read_their_reset_values_and_the_result_reads_minus_256_until_the_first_conversion` |
//! | The pointer | The first byte after a write start is the pointer, which a read uses until "the value is changed by the next write operation". Its reset value is `00` | 7.5.2, 7.5.3.1.3 | `a_read_uses_the_pointer_the_last_write_set` |
//! | The write and the read | A register is two bytes, "most significant byte first". Further bytes in one transfer go to the same register again | 7.5.3.1.3, 7.5.3.1.4, figures 7-9 and 7-10 | `a_register_is_written_and_read_most_significant_byte_first` |
//! | `Temp_Result` | Two's complement, "a resolution of 7.8125 m°C", updated "At the end of every conversion". Read only | 7.3.3 table 7-1, 7.6.2 | `the_result_is_7_8125_thousandths_of_a_degree_a_count_and_saturates` |
//! | `Temp_Offset` | "The offset will be added to the temperature result after linearization", and a sum out of range "will show as the maximum or minimum value" | 7.6.9 | `the_offset_is_added_to_the_result_and_the_sum_saturates` |
//! | Continuous conversion | `MOD` `00` or `10`, which "reads back = 00". A result lands at the end of each active conversion and the next cycle starts a conversion cycle time after the last, table 7-7 by `CONV` and `AVG` | 7.4.1, 7.6.3 tables 7-6 and 7-7 | `continuous_conversion_lands_a_result_each_cycle_after_the_active_conversion` |
//! | Averaging | `AVG` `00`, `01`, `10`, `11` average 1, 8, 32 and 64 conversions of 15.5 ms each. A held temperature averages to itself | 7.3.2, 6.5, 7.6.3 table 7-6 | `averaging_lengthens_the_active_conversion` |
//! | Shutdown | `MOD` `01`. "the device instantly aborts the currently running conversion" and converts nothing more | 7.4.2 | `shutdown_aborts_the_conversion_under_way` |
//! | One-shot | `MOD` `11` runs one conversion, "only affected by the AVG bit settings", sets `Data_Ready` and the flags, and goes to shutdown, so `MOD` reads `01` | 7.4.3 figure 7-4 | `one_shot_converts_once_and_returns_to_shutdown` |
//! | `Data_Ready` | "set at the end of the conversion when the temperature register is updated", cleared "Every time the temperature register or configuration register is read" | 7.6.3 table 7-6, 7.4.1 | `data_ready_is_set_by_a_conversion_and_cleared_by_reading_the_result_or_the_configuration` |
//! | Alert mode | `T/nA` 0. A result above `THigh_Limit` sets `HIGH_Alert` and one below `TLow_Limit` sets `LOW_Alert`. "the user can run an I2C read from the configuration register to clear the status flags" | 7.4.4.1 figure 7-5 | `alert_mode_sets_a_flag_past_each_limit_and_a_configuration_read_clears_both` |
//! | Therm mode | `T/nA` 1. `HIGH_Alert` sets above the high limit and clears below the low limit, `LOW_Alert` "always reads 0", and "I2C reads of the configuration register do not affect the status bits" | 7.4.4.2 figure 7-6 | `therm_mode_sets_high_alert_above_the_high_limit_and_clears_it_below_the_low_limit` |
//! | A change of `T/nA` | Into therm mode `LOW_Alert` "always reads 0" at once. Back in alert mode the pin asserts "when either the `HIGH_Alert` or the `LOW_Alert` status flag is set" | 7.4.4.1, 7.4.4.2, 7.6.3 table 7-6 | `therm_mode_clears_low_alert_at_the_write_that_sets_it`, `back_in_alert_mode_the_pin_asserts_only_for_a_flag_that_stands` |
//! | The `ALERT` pin | With `DR/Alert` set it follows `Data_Ready`. Otherwise in alert mode it asserts with either flag until a configuration read or an alert response, and in therm mode it follows `HIGH_Alert`. `POL` makes it active high. It's open drain | 5 table 5-1, 7.4.4.1, 7.4.4.2, 7.6.3 table 7-6 | `the_alert_pin_follows_the_flags_or_data_ready_at_the_polarity_pol_gives` |
//! | The alert response | "If the ALERT pin is active, the device acknowledges the SMBus ALERT command" at `0001100` and returns its address with the low bit high for the high limit. In alert mode the pin goes inactive. A pin that isn't active doesn't acknowledge | 7.5.3.1.5 figure 7-11 | `an_alert_response_returns_the_address_and_which_limit_and_releases_the_pin` |
//! | The limits | `THigh_Limit` and `TLow_Limit` keep what's written, in the result's format | 7.6.4, 7.6.5 | `alert_mode_sets_a_flag_past_each_limit_and_a_configuration_read_clears_both` |
//! | `Soft_Reset` | Writing 1 "triggers software reset with a duration of 2 ms", the same reload as power-up, which leaves `EEPROM_UL` at its reset of `0000h` and so locks the EEPROM, and it "will always read back 0" | 7.6.3 table 7-6, 7.6.6 | `the_soft_reset_bit_reloads_the_registers_for_2_ms_and_reads_back_zero` |
//! | The general-call reset | The general-call address with `0000 0110` as the second byte resets the registers "to power-up values" from the EEPROM, "clears the EUN bit", and takes "approximately 1.5 ms" | 7.5.3.1.6 figure 7-12, 7.5.1.2, 8.2.2.3 | `a_general_call_reset_reloads_the_registers_from_the_eeprom_and_locks_it` |
//! | `EEPROM_UL` | `EUN` keeps what's written. `EEPROM_Busy` mirrors the configuration's bit 12, set while the registers load and while a cell programs | 7.6.6 table 7-10 | `an_unlocked_write_programs_the_eeprom_for_7_ms_and_a_reset_loads_it` |
//! | EEPROM programming | Unlocked, "any writes to programmable registers program the respective location in the EEPROM", which takes 7 ms with `EEPROM_Busy` set. The configuration's `MOD1` "cannot be stored in EEPROM", so one-shot stored comes up as shutdown | 7.5.1.2 figure 7-7, 6.6, 7.6.3 table 7-6, 7.4.3 | `an_unlocked_write_programs_the_eeprom_for_7_ms_and_a_reset_loads_it`, `one_shot_stored_in_the_eeprom_comes_up_as_shutdown` |
//! | `EEPROM1` to `EEPROM3` | Scratch registers backed by the EEPROM, read and write | 7.6.7, 7.6.8, 7.6.10 | `an_unlocked_write_programs_the_eeprom_for_7_ms_and_a_reset_loads_it` |
//! | `Device_ID` | `0117h`, read only | 7.6.11 table 7-15 | `the_registers_read_their_reset_values_and_the_result_reads_minus_256_until_the_first_conversion` |
//! | Addresses past the map | `09h` to `0Eh` and `10h` up aren't in table 7-3. They read zero and take no write | 7.6 table 7-3 | `a_register_the_map_does_not_have_reads_zero_and_takes_no_write` |
//! | What it measures | A temperature in thousandths of a degree Celsius, [`Tmp117::set_temperature`], taken by each conversion that lands | 7.3.3 | `the_result_is_7_8125_thousandths_of_a_degree_a_count_and_saturates` |
//! | Determinism | The same accesses at the same instants give the same bytes, and a chip restored from its saved state goes on as the original does | Not a datasheet behavior | `the_same_accesses_give_the_same_bytes_and_a_restored_chip_goes_on_alike` |
//!
//! # What the model leaves out
//!
//! | Departure | Reason |
//! |---|---|
//! | A pin the part drives at the instant it changes | The `ALERT` level is answered when a board asks, at the instant it gives. A chip on this seam reaches no line of the part's |
//! | A temperature changing during a conversion | A conversion takes the temperature held at the access that finds it finished, so an average of a changing temperature isn't a mean of its samples. A driver reading at its own rate can't tell |
//! | Noise, accuracy and self-heating | The repeatability of 7.3.2, the accuracy of 6.5 and the self-heating of 8.2.2.2 are characteristics. A plant that wants noise drives the temperature |
//! | Arbitration in an alert response | 7.5.3.1.5 has the device with the lowest address win and the others keep their pin active. The controller's own seam addresses the first chip that acknowledges, so the model always answers as the winner |
//! | An alert response with `DR/Alert` set | The page doesn't say what the response does while the pin shows `Data_Ready`. The model acknowledges when the pin is active and releases only alert mode's latch |
//! | A write of the configuration | 7.6.3 gives only `MOD` `10`'s alias and doesn't say what a write does to the cycle under way. A write that changes `MOD`, `CONV` or `AVG`, or writes one-shot, starts the new cycle at the write, and one that changes none of them leaves the cycle running |
//! | Alert mode's pin after a change of `T/nA` | The page doesn't say what a change of mode does to the flags. Going to therm mode the model clears `LOW_Alert`, which therm mode "always reads 0". Back in alert mode the pin asserts as the flags then stand, so a latch therm mode's reads didn't clear is gone |
//! | One-shot's `MOD` after the conversion | 7.4.3 says the device "goes to the low-power shutdown mode" and doesn't give the read-back. The model reads `01` |
//! | A write during EEPROM programming | 7.5.1.2 says "Do not perform any I2C writes until programming is complete" without saying what one does. The model drops it |
//! | What an unlocked write does to the register | 7.5.1.2 says it programs the EEPROM and figure 7-7 reads the registers back after a reset. The model writes the register as well as the cell |
//! | The factory's unique ID | 7.5.1.1 says `EEPROM1` to `EEPROM3` hold a unique ID programmed at the factory and doesn't give it. They start at zero |
//! | The EEPROM's write endurance and retention | 6.6 gives 1,000 writes at least and 10 years. The model counts neither |
//! | The serial bus timeout | 7.5.3.1.7 resets the interface after 35 ms of a held line. The seam carries bytes, not a clock |
//! | A write of one byte | Figure 7-9 writes two. A transfer that stops after the most significant byte writes nothing |
//! | The supply and the thermal pad | 9 and 10 are the part's electrical side |

use crate::chip::i2c::{GENERAL_CALL, GENERAL_CALL_RESET, Peer};
use crate::chip::{Timeline, round, saturate};
use crate::device::Level;
use crate::snapshot::store;
use crate::time::VirtualNanos;

/// 7.6 table 7-3: the register map, by pointer.
const TEMP_RESULT: u8 = 0x00;
const CONFIGURATION: u8 = 0x01;
const THIGH_LIMIT: u8 = 0x02;
const TLOW_LIMIT: u8 = 0x03;
const EEPROM_UL: u8 = 0x04;
const EEPROM1: u8 = 0x05;
const EEPROM2: u8 = 0x06;
const TEMP_OFFSET: u8 = 0x07;
const EEPROM3: u8 = 0x08;
const DEVICE_ID: u8 = 0x0F;

/// 7.6.3 table 7-6: the configuration register's fields.
const HIGH_ALERT: u16 = 0x8000;
const LOW_ALERT: u16 = 0x4000;
const DATA_READY: u16 = 0x2000;
const EEPROM_BUSY: u16 = 0x1000;
const MOD: u16 = 0x0C00;
const MOD_SHIFT: u32 = 10;
const CONV: u16 = 0x0380;
const CONV_SHIFT: u32 = 7;
const AVG: u16 = 0x0060;
const AVG_SHIFT: u32 = 5;
const T_NA: u16 = 0x0010;
const POL: u16 = 0x0008;
const DR_ALERT: u16 = 0x0004;
const SOFT_RESET: u16 = 0x0002;
/// What a write keeps: `MOD`, `CONV`, `AVG`, `T/nA`, `POL` and `DR/Alert`.
const WRITABLE: u16 = MOD | CONV | AVG | T_NA | POL | DR_ALERT;
/// What the EEPROM keeps of the configuration: all of it but `MOD1`, table 7-6 note 2.
const STORED: u16 = WRITABLE & !MOD1;
const MOD1: u16 = 0x0800;
/// 7.6.3 table 7-6: the `MOD` codes.
const CONTINUOUS: u16 = 0b00;
const CONTINUOUS_ALIAS: u16 = 0b10;
const SHUTDOWN: u16 = 0b01;
const ONE_SHOT: u16 = 0b11;
/// What the cycle depends on, 7.6.3.
const CYCLE_FIELDS: u16 = MOD | CONV | AVG;

/// 7.6.6 table 7-10.
const EUN: u16 = 0x8000;
const EEPROM_BUSY_MIRROR: u16 = 0x4000;

/// 7.6.11 table 7-15: `Rev` 0 and `DID` `117h`.
const DEVICE_ID_VALUE: u16 = 0x0117;
/// 7.6.2: the result before the first conversion, -256 °C.
const RESULT_AT_RESET: u16 = 0x8000;

/// 7.5.3.1.5 figure 7-11: the alert response address, `0001100` with the read bit.
const ALERT_RESPONSE: u8 = 0x0C;

/// 7.3.1: the registers load for 1.5 ms after power-up, and 8.2.2.3 gives a general-call reset the same.
const LOAD_NANOS: u64 = 1_500_000;
/// 7.6.3 table 7-6: a soft reset's duration.
const SOFT_RESET_NANOS: u64 = 2_000_000;
/// 6.6 and 7.5.1.2: programming one EEPROM cell.
const PROGRAMMING_NANOS: u64 = 7_000_000;
/// 7.3.2 and 6.5: one active conversion, 15.5 ms.
const CONVERSION_NANOS: u64 = 15_500_000;
/// 7.6.3 table 7-6: the conversions averaged at each `AVG` code.
const AVERAGES: [u64; 4] = [1, 8, 32, 64];
/// 7.6.3 table 7-7: the conversion cycle in microseconds, by `CONV` and then `AVG`.
const CYCLE_MICROS: [[u64; 4]; 8] = [
    [15_500, 125_000, 500_000, 1_000_000],
    [125_000, 125_000, 500_000, 1_000_000],
    [250_000, 250_000, 500_000, 1_000_000],
    [500_000, 500_000, 500_000, 1_000_000],
    [1_000_000, 1_000_000, 1_000_000, 1_000_000],
    [4_000_000, 4_000_000, 4_000_000, 4_000_000],
    [8_000_000, 8_000_000, 8_000_000, 8_000_000],
    [16_000_000, 16_000_000, 16_000_000, 16_000_000],
];
const NANOS_PER_MICRO: u64 = 1_000;
/// 7.3.3: a count is 7.8125 thousandths of a degree, which is 125/16.
const MILLIDEGREES_PER_16_COUNTS: i64 = 125;
const COUNTS_PER_125_MILLIDEGREES: i64 = 16;

/// How the board wires the `ADD0` pin, which sets the chip's address, 7.5.3.1.2 table 7-2.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub enum Add0 {
    /// Tied to ground, `1001000`.
    Ground,
    /// Tied to `V+`, `1001001`.
    Supply,
    /// Tied to `SDA`, `1001010`.
    Sda,
    /// Tied to `SCL`, `1001011`.
    Scl,
}

impl Add0 {
    /// The seven-bit address the pin selects.
    #[must_use]
    pub fn address(self) -> u8 {
        match self {
            Self::Ground => 0x48,
            Self::Supply => 0x49,
            Self::Sda => 0x4A,
            Self::Scl => 0x4B,
        }
    }
}

/// The registers the EEPROM backs, 7.5.1.1, as the EEPROM holds them or as the part does.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
struct Backed {
    configuration: u16,
    high_limit: u16,
    low_limit: u16,
    offset: u16,
    scratch: [u16; 3],
}

/// 7.6 table 7-3: what the factory programs.
const FACTORY: Backed = Backed {
    configuration: 0x0220,
    high_limit: 0x6000,
    low_limit: 0x8000,
    offset: 0,
    scratch: [0; 3],
};

#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
enum Mode {
    Continuous,
    Shutdown,
    OneShot,
}

/// Where an I2C transaction is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
enum Phase {
    Idle,
    /// The next byte written is the pointer, 7.5.3.1.3.
    Pointer,
    /// The next byte written is a register's most significant.
    High,
    /// The next byte written is the least significant, after the one held.
    Low(u8),
    /// The next byte read is a register's most significant.
    ReadHigh,
    /// The next byte read is the least significant of the word held.
    ReadLow(u16),
    /// After the general-call address, 7.5.3.1.6.
    GeneralCall,
    /// After the alert response address, 7.5.3.1.5.
    AlertResponse,
}

/// One TMP117.
#[derive(Debug, serde::Serialize, serde::Deserialize)]
pub struct Tmp117 {
    address: u8,
    eeprom: Backed,
    /// The registers as the part holds them. The configuration keeps only its writable fields.
    live: Backed,
    result: u16,
    /// `HIGH_Alert`, `LOW_Alert` and `Data_Ready`, where the configuration register has them.
    flags: u16,
    /// Alert mode's pin, set with either flag and released by a configuration read or an alert
    /// response, 7.4.4.1.
    alert_latched: bool,
    unlocked: bool,
    /// When the registers finish loading from the EEPROM, 7.5.1.1.
    loading_until: VirtualNanos,
    /// When the cell being programmed finishes, 7.5.1.2.
    programming_until: VirtualNanos,
    /// When the current cycle's first conversion started, and the conversions landed since.
    epoch: VirtualNanos,
    landed: u64,
    millicelsius: i32,
    pointer: u8,
    phase: Phase,
}

impl Tmp117 {
    /// A part at power-up with its `ADD0` pin as given and the factory's EEPROM, at 25 °C. Its
    /// registers load for the first 1.5 ms on the virtual clock.
    #[must_use]
    pub fn new(add0: Add0) -> Self {
        Self {
            address: add0.address(),
            eeprom: FACTORY,
            live: FACTORY,
            result: RESULT_AT_RESET,
            flags: 0,
            alert_latched: false,
            unlocked: false,
            loading_until: VirtualNanos(LOAD_NANOS),
            programming_until: VirtualNanos(0),
            epoch: VirtualNanos(LOAD_NANOS),
            landed: 0,
            millicelsius: 25_000,
            pointer: 0,
            phase: Phase::Idle,
        }
    }

    /// The temperature the part measures from now on, in thousandths of a degree Celsius.
    pub fn set_temperature(&mut self, millicelsius: i32) {
        self.millicelsius = millicelsius;
    }

    /// The level on the `ALERT` pin at `now`, with the pull-up its open drain needs.
    pub fn alert(&mut self, now: VirtualNanos) -> Level {
        self.catch_up(now);
        let active_high = self.live.configuration & POL != 0;
        Level::from(self.alert_active() == active_high)
    }

    // 7.6.3 table 7-6 and 7.4.4: whether the pin is asserted, whatever its polarity.
    fn alert_active(&self) -> bool {
        let configuration = self.live.configuration;
        if configuration & DR_ALERT != 0 {
            self.flags & DATA_READY != 0
        } else if configuration & T_NA != 0 {
            self.flags & HIGH_ALERT != 0
        } else {
            self.alert_latched
        }
    }

    fn mode(&self) -> Mode {
        match (self.live.configuration & MOD) >> MOD_SHIFT {
            SHUTDOWN => Mode::Shutdown,
            ONE_SHOT => Mode::OneShot,
            _ => Mode::Continuous,
        }
    }

    // 7.3.2: the active conversion, 15.5 ms for each conversion averaged.
    fn active_nanos(&self) -> u64 {
        CONVERSION_NANOS * AVERAGES[usize::from((self.live.configuration & AVG) >> AVG_SHIFT)]
    }

    // 7.6.3 table 7-7.
    fn cycle_nanos(&self) -> u64 {
        let conv = usize::from((self.live.configuration & CONV) >> CONV_SHIFT);
        let avg = usize::from((self.live.configuration & AVG) >> AVG_SHIFT);
        CYCLE_MICROS[conv][avg] * NANOS_PER_MICRO
    }

    fn busy(&self, now: VirtualNanos) -> bool {
        now < self.loading_until || now < self.programming_until
    }

    // 7.4: the conversions that ended by `now` land. A held temperature gives each the same result,
    // so the last stands for all of them.
    fn catch_up(&mut self, now: VirtualNanos) {
        let first = self.epoch.0 + self.active_nanos();
        if now.0 < first {
            return;
        }
        match self.mode() {
            Mode::Continuous => {
                let due = (now.0 - first) / self.cycle_nanos() + 1;
                if due > self.landed {
                    self.landed = due;
                    self.land();
                }
            }
            Mode::OneShot => {
                self.land();
                self.live.configuration =
                    (self.live.configuration & !MOD) | (SHUTDOWN << MOD_SHIFT);
            }
            Mode::Shutdown => {}
        }
    }

    // 7.3.3, 7.6.9 and 7.4.4: a conversion's result and its effect on the flags.
    fn land(&mut self) {
        let raw = saturate(round(
            i64::from(self.millicelsius) * COUNTS_PER_125_MILLIDEGREES,
            MILLIDEGREES_PER_16_COUNTS,
        ));
        let result = saturate(i64::from(raw) + i64::from(self.live.offset.cast_signed()));
        self.result = result.cast_unsigned();
        self.flags |= DATA_READY;
        let high = self.live.high_limit.cast_signed();
        let low = self.live.low_limit.cast_signed();
        if self.live.configuration & T_NA != 0 {
            if result > high {
                self.flags |= HIGH_ALERT;
            } else if result < low {
                self.flags &= !HIGH_ALERT;
            }
            self.flags &= !LOW_ALERT;
        } else {
            if result > high {
                self.flags |= HIGH_ALERT;
                self.alert_latched = true;
            }
            if result < low {
                self.flags |= LOW_ALERT;
                self.alert_latched = true;
            }
        }
    }

    // 7.5.1.1, 7.5.1.2 and 7.6.3: every register from the EEPROM, the result at -256 °C and the
    // EEPROM locked, loading for `nanos`.
    fn reset(&mut self, now: VirtualNanos, nanos: u64) {
        self.live = self.eeprom;
        self.result = RESULT_AT_RESET;
        self.flags = 0;
        self.alert_latched = false;
        self.unlocked = false;
        self.loading_until = VirtualNanos(now.0 + nanos);
        self.epoch = self.loading_until;
        self.landed = 0;
        self.pointer = 0;
    }

    fn configuration_word(&self, now: VirtualNanos) -> u16 {
        let busy = if self.busy(now) { EEPROM_BUSY } else { 0 };
        self.live.configuration | self.flags | busy
    }

    // 7.6: a register read, with what the read does.
    fn read_register(&mut self, register: u8, now: VirtualNanos) -> u16 {
        match register {
            TEMP_RESULT => {
                self.flags &= !DATA_READY;
                self.result
            }
            CONFIGURATION => {
                let word = self.configuration_word(now);
                self.flags &= !DATA_READY;
                if self.live.configuration & T_NA == 0 {
                    self.flags &= !(HIGH_ALERT | LOW_ALERT);
                    self.alert_latched = false;
                }
                word
            }
            THIGH_LIMIT => self.live.high_limit,
            TLOW_LIMIT => self.live.low_limit,
            EEPROM_UL => {
                let mut word = 0;
                if self.unlocked {
                    word |= EUN;
                }
                if self.busy(now) {
                    word |= EEPROM_BUSY_MIRROR;
                }
                word
            }
            EEPROM1 => self.live.scratch[0],
            EEPROM2 => self.live.scratch[1],
            TEMP_OFFSET => self.live.offset,
            EEPROM3 => self.live.scratch[2],
            DEVICE_ID => DEVICE_ID_VALUE,
            _ => 0,
        }
    }

    // 7.6: a register write. 7.5.1.1 drops a write of the configuration or the limits while the
    // registers load.
    fn write_register(&mut self, register: u8, word: u16, now: VirtualNanos) {
        if now < self.programming_until {
            return;
        }
        let loading = now < self.loading_until;
        match register {
            CONFIGURATION | THIGH_LIMIT | TLOW_LIMIT if loading => {}
            CONFIGURATION if word & SOFT_RESET != 0 => self.reset(now, SOFT_RESET_NANOS),
            CONFIGURATION => self.configure(word, now),
            THIGH_LIMIT => self.put(now, word, |backed| &mut backed.high_limit),
            TLOW_LIMIT => self.put(now, word, |backed| &mut backed.low_limit),
            EEPROM1 => self.put(now, word, |backed| &mut backed.scratch[0]),
            EEPROM2 => self.put(now, word, |backed| &mut backed.scratch[1]),
            TEMP_OFFSET => self.put(now, word, |backed| &mut backed.offset),
            EEPROM3 => self.put(now, word, |backed| &mut backed.scratch[2]),
            EEPROM_UL => self.unlocked = word & EUN != 0,
            _ => {}
        }
    }

    // 7.6.3: `MOD` `10` reads back `00`. The restart of a changed cycle or a one-shot at the write,
    // and the flags across a change of `T/nA`, are the model's own, which its departures record.
    fn configure(&mut self, word: u16, now: VirtualNanos) {
        let mut word = word & WRITABLE;
        if (word & MOD) >> MOD_SHIFT == CONTINUOUS_ALIAS {
            word = (word & !MOD) | (CONTINUOUS << MOD_SHIFT);
        }
        if (word ^ self.live.configuration) & T_NA != 0 {
            if word & T_NA != 0 {
                self.flags &= !LOW_ALERT;
            }
            self.alert_latched = self.flags & (HIGH_ALERT | LOW_ALERT) != 0;
        }
        let restarts = word & CYCLE_FIELDS != self.live.configuration & CYCLE_FIELDS
            || (word & MOD) >> MOD_SHIFT == ONE_SHOT;
        if restarts {
            self.epoch = now;
            self.landed = 0;
        }
        self.put(now, word, |backed| &mut backed.configuration);
        self.eeprom.configuration &= STORED;
    }

    // 7.5.1.2: a write of a register the EEPROM backs, which programs its cell too while unlocked.
    fn put(&mut self, now: VirtualNanos, word: u16, cell: impl Fn(&mut Backed) -> &mut u16) {
        *cell(&mut self.live) = word;
        if self.unlocked {
            *cell(&mut self.eeprom) = word;
            self.programming_until = VirtualNanos(now.0 + PROGRAMMING_NANOS);
        }
    }
}

impl Peer for Tmp117 {
    // 7.5.3.1.2, 7.5.3.1.5 and 7.5.3.1.6: its own address, the general call for a write, and the
    // alert response while its pin is active.
    fn start(&mut self, address: u8, read: bool, context: &mut Timeline<'_, '_>) -> bool {
        self.catch_up(context.now());
        self.phase = match (address, read) {
            (own, false) if own == self.address => Phase::Pointer,
            (own, true) if own == self.address => Phase::ReadHigh,
            (GENERAL_CALL, false) => Phase::GeneralCall,
            (ALERT_RESPONSE, true) if self.alert_active() => Phase::AlertResponse,
            _ => Phase::Idle,
        };
        self.phase != Phase::Idle
    }

    // 7.5.3.1.4.1: the pointer, then each register two bytes at a time.
    fn write(&mut self, byte: u8, context: &mut Timeline<'_, '_>) -> bool {
        let now = context.now();
        self.catch_up(now);
        match self.phase {
            Phase::Pointer => {
                self.pointer = byte;
                self.phase = Phase::High;
            }
            Phase::High => self.phase = Phase::Low(byte),
            Phase::Low(high) => {
                self.write_register(self.pointer, u16::from_be_bytes([high, byte]), now);
                self.phase = Phase::High;
            }
            Phase::GeneralCall => {
                // 7.5.3.1.6: "If the second byte is 0000 0110, the TMP117 internal registers are reset".
                if byte == GENERAL_CALL_RESET {
                    self.reset(now, LOAD_NANOS);
                }
            }
            Phase::Idle | Phase::ReadHigh | Phase::ReadLow(_) | Phase::AlertResponse => {
                return false;
            }
        }
        true
    }

    // 7.5.3.1.4.2 and 7.5.3.1.5: the register at the pointer, most significant byte first, or the
    // address in answer to the alert response.
    fn read(&mut self, _last: bool, context: &mut Timeline<'_, '_>) -> u8 {
        let now = context.now();
        self.catch_up(now);
        match self.phase {
            Phase::ReadHigh => {
                let word = self.read_register(self.pointer, now);
                self.phase = Phase::ReadLow(word);
                word.to_be_bytes()[0]
            }
            Phase::ReadLow(word) => {
                self.phase = Phase::ReadHigh;
                word.to_be_bytes()[1]
            }
            Phase::AlertResponse => {
                self.alert_latched = false;
                (self.address << 1) | u8::from(self.flags & HIGH_ALERT != 0)
            }
            _ => 0,
        }
    }

    // 7.5.3.1.1: "TMP117 I2C state machine resets every time it sees a STOP condition".
    fn stop(&mut self, _context: &mut Timeline<'_, '_>) {
        self.phase = Phase::Idle;
    }
}

store!(Tmp117);
