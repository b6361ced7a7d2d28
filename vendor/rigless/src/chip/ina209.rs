// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! The INA209, a current, voltage and power monitor on an I2C bus: a shunt voltage and a bus voltage
//! converted in turn, a current and a power worked out from the calibration register, peaks held, and
//! three watchdogs, a warning, an over-limit and an analog critical comparator, each with its own pin,
//! plus an SMBus alert.
//!
//! Written against TI's INA209 datasheet, SBOS403B, revised March 2009. The document numbers no
//! sections, so a source below is the heading it's under, a table, a figure, or the page.
//!
//! **Conversions are derived from virtual time.** Nothing is scheduled. At each access, each time a
//! board asks for a pin and each time the `Convert` pin falls, the conversions that ended since the
//! mode last changed are counted from table 4 and land from the shunt and bus voltages held at that
//! instant. The critical comparator watches the held shunt voltage at the same instants.
//!
//! **The pins are levels a board reads.** [`Ina209::warning`], [`Ina209::overlimit`],
//! [`Ina209::critical`] and [`Ina209::alert`] answer the level on each open-drain output at an
//! instant, with the pull-up it needs. [`Ina209::gpio`] answers what the chip drives on `GPIO`, and
//! [`Ina209::set_gpio`] and [`Ina209::set_convert`] are what the board drives on `GPIO` and `Convert`.
//! A chip on this seam has no line of its own back to the part, so the board carries each level to
//! whatever it wired the pin to.
//!
//! | Register or section | Behavior | Source | Test |
//! |---|---|---|---|
//! | The address | `A1` and `A0` each to `GND`, `VS+`, `SDA` or `SCL` select `1000000` to `1001111`, chosen by [`Strap`]. Nothing else is acknowledged, the HS master code `00001XXX` included | Serial Bus Address table 1, High-Speed I2C Mode, page 14 | `it_answers_at_each_of_the_sixteen_addresses_a1_and_a0_select` |
//! | Power-on values | Every register as table 2 gives it, the configuration `399F` | Register Information table 2 | `the_registers_read_their_power_on_values` |
//! | The pointer and the words | The first byte after a write start is the pointer, which a read uses until the next write. "All INA209 registers are 16-bit registers", "most significant byte first" | Writing to/Reading from the INA209, figures 16, 17 and 19, Register Details | `a_register_is_written_and_read_most_significant_byte_first` |
//! | Shunt voltage and the PGA | 10 µV a count in two's complement, sign extended. `PG` sets 40, 80, 160 or 320 mV, and a voltage past the range reads the range's end | Configuration Register table 3, Shunt Voltage Register table 6 | `the_shunt_voltage_is_10_microvolts_a_count_and_clamps_at_the_pga_range` |
//! | Bus voltage and `BRNG` | 4 mV a count in bits 15 to 3, a 32 V or a 16 V range, bits 2 to 0 zero | Bus Voltage Register, Configuration Register | `the_bus_voltage_is_4_millivolts_a_count_in_bits_15_to_3` |
//! | Current and power | "`ShuntVoltage` × Calibration Register / 4096" and "Current × `BusVoltage` / 5000", the calibration value bits 15 to 1. Power has no sign bit, so it's the current's magnitude | Current Register, Power Register, Calibration Register, equations 4 and 5 | `the_current_and_power_follow_the_calibration_register` |
//! | `OVF` | Set "if an arithmetic operation resulted in an overflow error", with the current held at its end. The power can't overflow, since 32768 by 8191 over 5000 fits its word | Status Register | `an_overflowing_current_sets_ovf_and_holds_the_word` |
//! | Continuous modes | `MODE` `101`, `110` and `111` convert the shunt, the bus or both, the shunt first, each taking the time `SADC` or `BADC` gives, over and over | Basic ADC Functions, table 4, table 5 | `continuous_modes_convert_shunt_then_bus_at_the_times_table_4_gives` |
//! | Triggered modes | `001`, `010` and `011` convert once when "the Convert line low" falls, ignoring "Any re-trigger of the Convert line during a conversion". With `Convert` held low, writing a triggered mode "triggers a single-shot conversion" | Basic ADC Functions, Pin Descriptions | `a_triggered_mode_converts_once_on_a_falling_convert_pin`, `a_triggered_mode_written_with_convert_held_low_converts_at_once` |
//! | Power-down and ADC off | `000` and `100` stop converting. "Full recovery from Power-Down requires 40µs" | Basic ADC Functions, table 5 | `power_down_and_adc_off_stop_converting_and_power_down_takes_40_us_to_leave` |
//! | `CNVR` | "set after all conversions, averaging, and multiplications are complete", cleared by a configuration write other than power-down or off, a status read, or a single-shot on the `Convert` pin | Status Register, Basic ADC Functions | `conversion_ready_sets_at_the_end_and_clears_as_the_page_lists` |
//! | Peak-hold | `07h` to `0Bh` hold the highest and lowest shunt voltage, the highest and lowest bus voltage and the highest power, and "are cleared and reset to POR values by writing a '1' into the respective D0 bits" | Peak-Hold Registers | `the_peak_registers_hold_the_extremes_and_a_write_of_d0_resets_them` |
//! | The warning watchdog | `0Ch` to `10h` set `WS+`, `WS-`, `WP`, `WOV` and `WUV`, and the `Warning` pin asserts "if the WRNEN bit is set" | Warning Watchdog Registers, Status Register | `the_warning_limits_set_their_flags_and_assert_the_warning_pin` |
//! | The warning delay | `WD` delays the `Warning` pin "from 0 to 1.5s, 0.1 second/LSB" | Critical DAC- Register table 10 | `the_warning_pin_waits_out_its_delay` |
//! | The over-limit watchdog | `11h` to `13h` set `OLP`, `OLOV` and `OLUV`, and the `Overlimit` pin asserts "if the OLEN bit is set" | Over-Limit/Critical Watchdog Registers | `the_over_limit_limits_set_their_flags_and_assert_the_overlimit_pin` |
//! | Latching | Flags "latch when corresponding latch bits are set" and clear "when the Status Register is read (unless a limit is exceeded, at which time the flag immediately sets again)". A transparent flag follows its fault. Turning a latch off clears it | Status Register, All Other Latches, `WNL`, `OLL`, `CRL` | `a_latched_flag_holds_until_the_status_read_and_a_transparent_one_follows` |
//! | The critical comparator | Compares the shunt voltage to `CDP+` and `-CDP-` in millivolts, the condition "true for every sample" of the `CF` filter, released past `CHYST` | Critical Comparator, Critical DAC+ and DAC- Registers, tables 8 and 9 | `the_critical_comparator_trips_past_its_dac_after_its_filter_and_releases_past_its_hysteresis` |
//! | The pins' polarity and enables | `WPL`, `OLP` and `CP` make `Warning`, `Overlimit` and `Critical` active high. `WRNEN`, `OLEN` and `CREN` enable them, and "The CREN bit affects only the Critical pin" | Pin Descriptions, SMBus Alert Mask/Enable Control Register | `each_pin_asserts_at_the_polarity_its_register_gives_only_while_enabled` |
//! | The SMBus alert | `ALERT` sets when an unmasked fault occurs, or `CNVR` in a triggered mode, "is latched and can be cleared only by either reading the Status Register or by successfully responding to an alert response address", and re-asserts if the fault stands. `SMBA` follows it and `SMAEN` gates both | SMBus Alert Response, SMBus Alert Mask/Enable Control Register, Status Register | `the_smbus_alert_latches_on_an_unmasked_fault_and_a_status_read_clears_it` |
//! | The alert response | At `0001100` the chip returns its address, which "clears the SMBus ALERT pin, provided that the condition causing the alert no longer exists" | SMBus Alert Response, figure 18 | `an_alert_response_returns_the_address_and_releases_the_pin_once_the_fault_is_gone` |
//! | `GPIO` | `GPM` `0x` is an input, `10` drives 0 and `11` drives 1. `GP` "Shows state of the GPIO pin" | Critical DAC+ Register table 7 | `the_gpio_pin_drives_or_reads_as_its_mode_says` |
//! | Resets | `RST` "generates a system reset that is the same as power-on reset" and self-clears, and so does the general call with `0000 0110` | Configuration Register, Power-Up Conditions | `the_reset_bit_and_a_general_call_reset_restore_the_power_on_values` |
//! | Read-only and missing registers | `01h` and `03h` to `06h` take no write. Pointers past `16h` read zero and take no write | Register Information table 2 | `a_read_only_register_and_one_past_the_map_take_no_write` |
//! | What it measures | A shunt voltage in microvolts and a bus voltage in millivolts, [`Ina209::set_shunt_voltage`] and [`Ina209::set_bus_voltage`] | Basic ADC Functions, figure 21 | `the_shunt_voltage_is_10_microvolts_a_count_and_clamps_at_the_pga_range` |
//! | Determinism | The same accesses at the same instants give the same bytes, and a chip restored from its saved state goes on as the original does | Not a datasheet behavior | `the_same_accesses_give_the_same_bytes_and_a_restored_chip_goes_on_alike` |
//!
//! # What the model leaves out
//!
//! | Departure | Reason |
//! |---|---|
//! | A pin the part drives at the instant it changes | Each pin's level is answered when a board asks, at the instant it gives. A chip on this seam reaches no line of the part's |
//! | A voltage changing during a conversion | A conversion takes the voltage held at the access that finds it finished, so an average of a changing voltage isn't a mean of its samples. A driver reading at its own rate can't tell |
//! | Resolution below 12 bits | Table 4's 9, 10 and 11 bit settings change the conversion time. The register keeps its 10 µV and 4 mV counts at every setting, and the page says nothing of the low bits, so the word is the held voltage at full resolution |
//! | A bus voltage past its range | The page gives no clamp. The word saturates at its field, 13 bits at 32 V and 12 bits at 16 V |
//! | The critical comparator between accesses | The comparator watches the held shunt voltage at each access and each pin query, so its filter counts from the first instant the chip sees the condition. The 5 µs comparator delay and the 4 µs strobe aren't modeled |
//! | The comparator in power-down | The page doesn't say whether power-down stops the analog comparator. The model keeps it running in every mode |
//! | When `OVF` clears | The page says only when it sets. The model latches it until a status read, after which it follows the last calculation |
//! | `CNVR` and the SMBus alert in a continuous mode | The page lists "Conversion Ready states (in triggered modes)" among what sets `ALERT`. The model takes that as the whole rule, so `MCNVR` gates nothing in a continuous mode |
//! | A configuration write in a continuous mode | The page doesn't say what it does to the conversion under way. The model drops it and starts the new mode from the write |
//! | The `Convert` pin's 4 µs minimum low time | A fall starts a conversion however short the low |
//! | The general call's reset byte | Power-Up Conditions names the general-call reset without its byte. The model takes `0000 0110`, the I2C bus's own. Any other second byte is acknowledged and does nothing |
//! | Arbitration in an alert response | The page has the lowest address win and the others keep their pin. The controller's own seam addresses the first chip that acknowledges, so the model always answers as the winner |
//! | Register contents 4 µs after a write | Register Information delays a write by 4 µs for SCL above 1 MHz. The seam carries bytes, not a clock, so a write lands at once |
//! | The SMBus timeout and the high-speed filters | 28 ms of a held line and the 3.4 MHz mode are the bus's electrical side. The seam carries bytes, not a clock |
//! | Address pins that change | Table 1's pins are "sampled on every bus communication". The model takes them once, when the board builds it |
//! | A write of one byte, or past two | Figure 16 writes two. A transfer that stops after the most significant byte writes nothing, and a third byte starts another word to the same register |
//! | Noise, offset and gain error | The electrical characteristics are the part's analog side. A plant that wants noise drives the voltages |
//! | Peak-hold missing a critical shutdown | The page notes a shutdown removes a fault before the ADC records it. That's the system around the part |

use crate::chip::i2c::{GENERAL_CALL, GENERAL_CALL_RESET, Peer};
use crate::chip::{Timeline, round, saturate};
use crate::device::Level;
use crate::snapshot::store;
use crate::time::VirtualNanos;

/// Register Information table 2: the register map, by pointer.
const CONFIGURATION: u8 = 0x00;
const STATUS: u8 = 0x01;
const ALERT_MASK: u8 = 0x02;
const SHUNT_VOLTAGE: u8 = 0x03;
const BUS_VOLTAGE: u8 = 0x04;
const POWER: u8 = 0x05;
const CURRENT: u8 = 0x06;
const SHUNT_POSITIVE_PEAK: u8 = 0x07;
const SHUNT_NEGATIVE_PEAK: u8 = 0x08;
const BUS_MAXIMUM_PEAK: u8 = 0x09;
const BUS_MINIMUM_PEAK: u8 = 0x0A;
const POWER_PEAK: u8 = 0x0B;
const SHUNT_POSITIVE_WARNING: u8 = 0x0C;
const SHUNT_NEGATIVE_WARNING: u8 = 0x0D;
const POWER_WARNING: u8 = 0x0E;
const BUS_OVER_WARNING: u8 = 0x0F;
const BUS_UNDER_WARNING: u8 = 0x10;
const POWER_OVER_LIMIT: u8 = 0x11;
const BUS_OVER_LIMIT: u8 = 0x12;
const BUS_UNDER_LIMIT: u8 = 0x13;
const CRITICAL_POSITIVE: u8 = 0x14;
const CRITICAL_NEGATIVE: u8 = 0x15;
const CALIBRATION: u8 = 0x16;

/// Configuration Register: its fields and its power-on value.
const RST: u16 = 0x8000;
const BRNG: u16 = 0x2000;
const PG: u16 = 0x1800;
const PG_SHIFT: u32 = 11;
const BADC: u16 = 0x0780;
const BADC_SHIFT: u32 = 7;
const SADC: u16 = 0x0078;
const SADC_SHIFT: u32 = 3;
const MODE: u16 = 0x0007;
const CONFIGURATION_WRITABLE: u16 = BRNG | PG | BADC | SADC | MODE;
const CONFIGURATION_AT_RESET: u16 = 0x399F;
/// Table 5: `MODE1` converts the shunt, `MODE2` the bus, and `MODE3` repeats.
const MODE_SHUNT: u16 = 0b001;
const MODE_BUS: u16 = 0b010;
const MODE_CONTINUOUS: u16 = 0b100;

/// Status Register: the flags.
const WOV: u16 = 0x8000;
const WUV: u16 = 0x4000;
const WP: u16 = 0x2000;
const WS_POSITIVE: u16 = 0x1000;
const WS_NEGATIVE: u16 = 0x0800;
const OLOV: u16 = 0x0400;
const OLUV: u16 = 0x0200;
const OLP: u16 = 0x0100;
const CRIT_POSITIVE: u16 = 0x0080;
const CRIT_NEGATIVE: u16 = 0x0040;
const CNVR: u16 = 0x0020;
const SMBA: u16 = 0x0010;
const OVF: u16 = 0x0008;
const WARNING_FLAGS: u16 = WOV | WUV | WP | WS_POSITIVE | WS_NEGATIVE;
const OVER_LIMIT_FLAGS: u16 = OLOV | OLUV | OLP;
const CRITICAL_FLAGS: u16 = CRIT_POSITIVE | CRIT_NEGATIVE;
/// The faults that set `ALERT`, SMBus Alert Response.
const FAULTS: u16 = WARNING_FLAGS | OVER_LIMIT_FLAGS | CRITICAL_FLAGS;

/// SMBus Alert Mask/Enable Control Register: the masks are the status bits they gate, then the enables.
const SMAEN: u16 = 0x0008;
const CREN: u16 = 0x0004;
const OLEN: u16 = 0x0002;
const WRNEN: u16 = 0x0001;
const ALERT_MASK_WRITABLE: u16 = FAULTS | CNVR | SMAEN | CREN | OLEN | WRNEN;

/// Bus Over-Voltage Warning and Over-Limit Registers: the limit, the pin's polarity and its latch.
const BUS_LIMIT: u16 = 0xFFF8;
const POLARITY: u16 = 0x0002;
const LATCH: u16 = 0x0001;
/// Critical DAC+ Register.
const CDP: u16 = 0xFF00;
const CDP_SHIFT: u32 = 8;
const GP: u16 = 0x0080;
const GPM: u16 = 0x0060;
const GPM_SHIFT: u32 = 5;
const CP: u16 = 0x0010;
const CHYST: u16 = 0x000E;
const CHYST_SHIFT: u32 = 1;
const CRL: u16 = 0x0001;
/// Critical DAC- Register.
const CF: u16 = 0x00F0;
const CF_SHIFT: u32 = 4;
const WD: u16 = 0x000F;
/// Calibration Register: "D0 is a void bit and will always be '0'".
const CALIBRATION_WRITABLE: u16 = 0xFFFE;
/// Peak-Hold Registers: a write of D0 resets the register.
const PEAK_RESET: u16 = 0x0001;
/// Table 7: `GPM` `10` drives 0 and `11` drives 1.
const GPIO_DRIVES_LOW: u16 = 0b10;
const GPIO_DRIVES_HIGH: u16 = 0b11;

/// Table 2: the peak registers' power-on values.
const SHUNT_POSITIVE_PEAK_AT_RESET: u16 = 0x8000;
const SHUNT_NEGATIVE_PEAK_AT_RESET: u16 = 0x7FFF;
const BUS_MINIMUM_PEAK_AT_RESET: u16 = 0xFFF8;

/// SMBus Alert Response figure 18: the alert response address, `0001100`.
const ALERT_RESPONSE: u8 = 0x0C;
/// Serial Bus Address table 1: `A1` and `A0` select the low four bits of `100xxxx`.
const ADDRESS_BASE: u8 = 0x40;
const ADDRESSES_PER_A1: u8 = 4;

/// Table 4: the conversion time of each `ADC` code in nanoseconds, 9 to 12 bits and then 2 to 128
/// samples. Bit 2 of the first eight is "Don't care".
const CONVERSION_NANOS: [u64; 16] = [
    84_000, 148_000, 276_000, 532_000, 84_000, 148_000, 276_000, 532_000, 532_000, 1_060_000,
    2_130_000, 4_260_000, 8_510_000, 17_020_000, 34_050_000, 68_100_000,
];
/// Basic ADC Functions: "Full recovery from Power-Down requires 40µs".
const WAKE_NANOS: u64 = 40_000;
/// Table 9: the critical filter, 64 µs a count.
const FILTER_NANOS_PER_COUNT: u64 = 64_000;
/// Table 10: the warning delay, 0.1 s a count.
const DELAY_NANOS_PER_COUNT: u64 = 100_000_000;
/// Table 8: the critical hysteresis, 2 mV a count.
const HYSTERESIS_MILLIVOLTS_PER_COUNT: i64 = 2;
/// Table 3: the shunt voltage range in counts at each `PG`.
const SHUNT_RANGE: [i64; 4] = [4_000, 8_000, 16_000, 32_000];
/// Bus Voltage Register: the counts the field holds at 16 V and at 32 V.
const BUS_COUNTS_16V: i64 = 0x0FFF;
const BUS_COUNTS_32V: i64 = 0x1FFF;
const BUS_SHIFT: u32 = 3;
/// Electrical Characteristics: a shunt count is 10 µV and a bus count 4 mV.
const MICROVOLTS_PER_SHUNT_COUNT: i64 = 10;
const MILLIVOLTS_PER_BUS_COUNT: i64 = 4;
const MICROVOLTS_PER_MILLIVOLT: i64 = 1_000;
/// Current Register and Power Register: the divisors of the two equations.
const CURRENT_DIVISOR: i64 = 4_096;
const POWER_DIVISOR: i64 = 5_000;

/// How the board wires one of the address pins, Serial Bus Address table 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub enum Strap {
    /// Tied to ground.
    Ground,
    /// Tied to `VS+`.
    Supply,
    /// Tied to `SDA`.
    Sda,
    /// Tied to `SCL`.
    Scl,
}

impl Strap {
    fn code(self) -> u8 {
        match self {
            Self::Ground => 0,
            Self::Supply => 1,
            Self::Sda => 2,
            Self::Scl => 3,
        }
    }
}

/// A run of conversions: when it started, whether it repeats, and the conversions of each kind that
/// have landed since.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
struct Run {
    start: VirtualNanos,
    repeats: bool,
    shunts: u64,
    buses: u64,
}

/// Where an I2C transaction is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
enum Phase {
    Idle,
    Pointer,
    High,
    Low(u8),
    ReadHigh,
    ReadLow(u16),
    GeneralCall,
    AlertResponse,
}

/// The registers, as table 2 lists them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
struct Registers {
    configuration: u16,
    alert_mask: u16,
    shunt: u16,
    bus: u16,
    power: u16,
    current: u16,
    shunt_positive_peak: u16,
    shunt_negative_peak: u16,
    bus_maximum_peak: u16,
    bus_minimum_peak: u16,
    power_peak: u16,
    shunt_positive_warning: u16,
    shunt_negative_warning: u16,
    power_warning: u16,
    bus_over_warning: u16,
    bus_under_warning: u16,
    power_over_limit: u16,
    bus_over_limit: u16,
    bus_under_limit: u16,
    critical_positive: u16,
    critical_negative: u16,
    calibration: u16,
}

/// Table 2's power-on values.
const AT_RESET: Registers = Registers {
    configuration: CONFIGURATION_AT_RESET,
    alert_mask: 0,
    shunt: 0,
    bus: 0,
    power: 0,
    current: 0,
    shunt_positive_peak: SHUNT_POSITIVE_PEAK_AT_RESET,
    shunt_negative_peak: SHUNT_NEGATIVE_PEAK_AT_RESET,
    bus_maximum_peak: 0,
    bus_minimum_peak: BUS_MINIMUM_PEAK_AT_RESET,
    power_peak: 0,
    shunt_positive_warning: 0,
    shunt_negative_warning: 0,
    power_warning: 0,
    bus_over_warning: 0,
    bus_under_warning: 0,
    power_over_limit: 0,
    bus_over_limit: 0,
    bus_under_limit: 0,
    critical_positive: 0,
    critical_negative: 0,
    calibration: 0,
};

/// One INA209.
#[derive(Debug, serde::Serialize, serde::Deserialize)]
pub struct Ina209 {
    address: u8,
    registers: Registers,
    /// The status register's flags.
    flags: u16,
    /// What's wrong now: the watchdogs' conditions at the last conversion, the critical comparator's
    /// at the last instant the chip saw, and whether the last calculation overflowed.
    faults: u16,
    run: Option<Run>,
    /// The SMBus alert's latch, SMBus Alert Response.
    alert: bool,
    /// Since when a warning flag has stood, which the warning delay counts from.
    warning_since: Option<VirtualNanos>,
    /// Since when each critical comparator has been active, positive then negative, which the filter
    /// counts from.
    critical_since: [Option<VirtualNanos>; 2],
    microvolts: i32,
    millivolts: u32,
    gpio_input: Level,
    convert: Level,
    pointer: u8,
    phase: Phase,
}

impl Ina209 {
    /// A part at power-up with its address pins as given, converting the shunt and the bus
    /// continuously as table 2 has it, with no current through the shunt and 12 V on the bus. The
    /// `Convert` pin is high, as the page has an unused one tied, and nothing drives `GPIO`.
    #[must_use]
    pub fn new(a1: Strap, a0: Strap) -> Self {
        Self {
            address: ADDRESS_BASE + ADDRESSES_PER_A1 * a1.code() + a0.code(),
            registers: AT_RESET,
            flags: 0,
            faults: 0,
            run: Some(Run {
                start: VirtualNanos(0),
                repeats: true,
                shunts: 0,
                buses: 0,
            }),
            alert: false,
            warning_since: None,
            critical_since: [None; 2],
            microvolts: 0,
            millivolts: 12_000,
            gpio_input: Level::Low,
            convert: Level::High,
            pointer: 0,
            phase: Phase::Idle,
        }
    }

    /// The voltage across the shunt from now on, `VIN+` less `VIN-`, in microvolts.
    pub fn set_shunt_voltage(&mut self, microvolts: i32) {
        self.microvolts = microvolts;
    }

    /// The bus voltage from now on, `VIN-` to ground, in millivolts.
    pub fn set_bus_voltage(&mut self, millivolts: u32) {
        self.millivolts = millivolts;
    }

    /// The level the board drives on `GPIO`, which the chip reads while `GPM` makes it an input.
    pub fn set_gpio(&mut self, level: Level) {
        self.gpio_input = level;
    }

    /// The level on the `Convert` pin from `now` on. A fall starts a conversion in a triggered mode.
    pub fn set_convert(&mut self, level: Level, now: VirtualNanos) {
        self.catch_up(now);
        let falls = self.convert == Level::High && level == Level::Low;
        self.convert = level;
        let converting = self.run.is_some_and(|run| !self.finished(run, now));
        if falls && self.triggered() && !converting {
            self.flags &= !CNVR;
            self.begin(now, false);
        }
    }

    /// What the chip drives on `GPIO`, or `None` while `GPM` makes it an input, table 7.
    #[must_use]
    pub fn gpio(&self) -> Option<Level> {
        match (self.registers.critical_positive & GPM) >> GPM_SHIFT {
            GPIO_DRIVES_LOW => Some(Level::Low),
            GPIO_DRIVES_HIGH => Some(Level::High),
            _ => None,
        }
    }

    /// The level on the `Warning` pin at `now`, with the pull-up its open drain needs.
    pub fn warning(&mut self, now: VirtualNanos) -> Level {
        self.catch_up(now);
        let delay = u64::from(self.registers.critical_negative & WD) * DELAY_NANOS_PER_COUNT;
        let waited = self
            .warning_since
            .is_some_and(|since| now.0 >= since.0 + delay);
        let active = self.registers.alert_mask & WRNEN != 0 && waited;
        pin(active, self.registers.bus_over_warning, POLARITY)
    }

    /// The level on the `Overlimit` pin at `now`, with the pull-up its open drain needs.
    pub fn overlimit(&mut self, now: VirtualNanos) -> Level {
        self.catch_up(now);
        let active = self.registers.alert_mask & OLEN != 0 && self.flags & OVER_LIMIT_FLAGS != 0;
        pin(active, self.registers.bus_over_limit, POLARITY)
    }

    /// The level on the `Critical` pin at `now`, with the pull-up its open drain needs.
    pub fn critical(&mut self, now: VirtualNanos) -> Level {
        self.catch_up(now);
        let active = self.registers.alert_mask & CREN != 0 && self.flags & CRITICAL_FLAGS != 0;
        pin(active, self.registers.critical_positive, CP)
    }

    /// The level on the `SMBus Alert` pin at `now`, active low, with the pull-up its open drain needs.
    pub fn alert(&mut self, now: VirtualNanos) -> Level {
        self.catch_up(now);
        Level::from(!self.alert_active())
    }

    fn alert_active(&self) -> bool {
        self.alert && self.registers.alert_mask & SMAEN != 0
    }

    fn mode(&self) -> u16 {
        self.registers.configuration & MODE
    }

    fn triggered(&self) -> bool {
        self.mode() & MODE_CONTINUOUS == 0 && self.mode() & (MODE_SHUNT | MODE_BUS) != 0
    }

    // Table 4: how long each kind takes, zero for a kind the mode doesn't convert.
    fn shunt_nanos(&self) -> u64 {
        if self.mode() & MODE_SHUNT == 0 {
            return 0;
        }
        CONVERSION_NANOS[usize::from((self.registers.configuration & SADC) >> SADC_SHIFT)]
    }

    fn bus_nanos(&self) -> u64 {
        if self.mode() & MODE_BUS == 0 {
            return 0;
        }
        CONVERSION_NANOS[usize::from((self.registers.configuration & BADC) >> BADC_SHIFT)]
    }

    fn finished(&self, run: Run, now: VirtualNanos) -> bool {
        !run.repeats && now.0 >= run.start.0 + self.shunt_nanos() + self.bus_nanos()
    }

    fn begin(&mut self, at: VirtualNanos, repeats: bool) {
        self.run = Some(Run {
            start: at,
            repeats,
            shunts: 0,
            buses: 0,
        });
    }

    // Basic ADC Functions: each cycle converts the shunt and then the bus. A held voltage gives every
    // conversion of a kind the same result, so the first new one of each stands for the rest.
    fn catch_up(&mut self, now: VirtualNanos) {
        if let Some(mut run) = self.run {
            let (shunt, bus) = (self.shunt_nanos(), self.bus_nanos());
            let period = shunt + bus;
            let due = |offset: u64| {
                if now.0 < run.start.0 + offset {
                    0
                } else if run.repeats {
                    (now.0 - run.start.0 - offset) / period + 1
                } else {
                    1
                }
            };
            let shunts = if shunt == 0 { 0 } else { due(shunt) };
            let buses = if bus == 0 { 0 } else { due(period) };
            let shunt_at = VirtualNanos(run.start.0 + run.shunts * period + shunt);
            let bus_at = VirtualNanos(run.start.0 + run.buses * period + period);
            let mut landings = [
                (shunts > run.shunts, shunt_at, true),
                (buses > run.buses, bus_at, false),
            ];
            landings.sort_by_key(|&(_, at, _)| at);
            for (new, at, is_shunt) in landings {
                if !new {
                    continue;
                }
                if is_shunt {
                    self.land_shunt(at);
                } else {
                    self.land_bus(at);
                }
                if !is_shunt || bus == 0 {
                    self.converted();
                }
            }
            run.shunts = shunts;
            run.buses = buses;
            self.run = (run.repeats || !self.finished(run, now)).then_some(run);
        }
        self.compare(now);
    }

    // Shunt Voltage Register table 6: 10 µV a count, held to the PGA's range.
    fn land_shunt(&mut self, at: VirtualNanos) {
        let range = SHUNT_RANGE[usize::from((self.registers.configuration & PG) >> PG_SHIFT)];
        let counts =
            round(i64::from(self.microvolts), MICROVOLTS_PER_SHUNT_COUNT).clamp(-range, range);
        let shunt = i16::try_from(counts).expect("held to 32000");
        self.registers.shunt = shunt.cast_unsigned();
        let registers = &mut self.registers;
        if shunt > registers.shunt_positive_peak.cast_signed() {
            registers.shunt_positive_peak = registers.shunt;
        }
        if shunt < registers.shunt_negative_peak.cast_signed() {
            registers.shunt_negative_peak = registers.shunt;
        }
        self.calculate();
        self.watch(at);
    }

    // Bus Voltage Register: 4 mV a count in bits 15 to 3, held to the field at the range.
    fn land_bus(&mut self, at: VirtualNanos) {
        let most = if self.registers.configuration & BRNG != 0 {
            BUS_COUNTS_32V
        } else {
            BUS_COUNTS_16V
        };
        let counts = round(i64::from(self.millivolts), MILLIVOLTS_PER_BUS_COUNT).min(most);
        let bus = u16::try_from(counts).expect("held to thirteen bits") << BUS_SHIFT;
        let registers = &mut self.registers;
        registers.bus = bus;
        registers.bus_maximum_peak = registers.bus_maximum_peak.max(bus);
        registers.bus_minimum_peak = registers.bus_minimum_peak.min(bus);
        self.calculate();
        self.watch(at);
    }

    // Current Register and Power Register: the two equations, the current held to its sixteen bits
    // with `OVF` set when it overflows. The power can't, since the current and the bus are held first.
    fn calculate(&mut self) {
        let registers = &mut self.registers;
        let calibration = i64::from(registers.calibration & CALIBRATION_WRITABLE);
        let current = i64::from(registers.shunt.cast_signed()) * calibration / CURRENT_DIVISOR;
        let held_current = saturate(current);
        registers.current = held_current.cast_unsigned();
        let bus = i64::from(registers.bus >> BUS_SHIFT);
        let power = i64::from(held_current).abs() * bus / POWER_DIVISOR;
        registers.power = u16::try_from(power).expect("32768 by 8191 over 5000 fits sixteen bits");
        registers.power_peak = registers.power_peak.max(registers.power);
        let overflowed = i64::from(held_current) != current;
        self.faults = (self.faults & !OVF) | if overflowed { OVF } else { 0 };
        self.flags |= self.faults & OVF;
    }

    // Warning and Over-Limit Watchdog Registers: each limit against the result it watches, at the end
    // of a conversion.
    fn watch(&mut self, at: VirtualNanos) {
        let registers = &self.registers;
        let shunt = registers.shunt.cast_signed();
        let above = |value: u16, limit: u16| value & BUS_LIMIT > limit & BUS_LIMIT;
        let below = |value: u16, limit: u16| value & BUS_LIMIT < limit & BUS_LIMIT;
        let mut watched = 0;
        for (fault, flag) in [
            (above(registers.bus, registers.bus_over_warning), WOV),
            (below(registers.bus, registers.bus_under_warning), WUV),
            (registers.power > registers.power_warning, WP),
            (
                shunt > registers.shunt_positive_warning.cast_signed(),
                WS_POSITIVE,
            ),
            (
                shunt < registers.shunt_negative_warning.cast_signed(),
                WS_NEGATIVE,
            ),
            (above(registers.bus, registers.bus_over_limit), OLOV),
            (below(registers.bus, registers.bus_under_limit), OLUV),
            (registers.power > registers.power_over_limit, OLP),
        ] {
            if fault {
                watched |= flag;
            }
        }
        let watchdogs = WARNING_FLAGS | OVER_LIMIT_FLAGS;
        self.faults = (self.faults & !watchdogs) | watched;
        self.settle(watchdogs, at);
    }

    // Critical Comparator: each side trips past its DAC, holds until the shunt voltage is back past the
    // hysteresis, and sets its flag once it has stood for the filter's time.
    fn compare(&mut self, now: VirtualNanos) {
        let positive_dac = i64::from((self.registers.critical_positive & CDP) >> CDP_SHIFT);
        let negative_dac = i64::from((self.registers.critical_negative & CDP) >> CDP_SHIFT);
        let hysteresis = i64::from((self.registers.critical_positive & CHYST) >> CHYST_SHIFT)
            * HYSTERESIS_MILLIVOLTS_PER_COUNT;
        let filter =
            u64::from((self.registers.critical_negative & CF) >> CF_SHIFT) * FILTER_NANOS_PER_COUNT;
        let microvolts = i64::from(self.microvolts);
        let [positive, negative] = self.critical_since;
        let positive_trips = if positive.is_some() {
            microvolts > (positive_dac - hysteresis) * MICROVOLTS_PER_MILLIVOLT
        } else {
            microvolts > positive_dac * MICROVOLTS_PER_MILLIVOLT
        };
        let negative_trips = if negative.is_some() {
            microvolts < -(negative_dac - hysteresis) * MICROVOLTS_PER_MILLIVOLT
        } else {
            microvolts < -negative_dac * MICROVOLTS_PER_MILLIVOLT
        };
        let mut critical = 0;
        for (index, (trips, flag)) in [
            (positive_trips, CRIT_POSITIVE),
            (negative_trips, CRIT_NEGATIVE),
        ]
        .into_iter()
        .enumerate()
        {
            let was = self.critical_since[index];
            let since = trips.then(|| was.unwrap_or(now));
            self.critical_since[index] = since;
            if since.is_some_and(|since| now.0 >= since.0 + filter) {
                critical |= flag;
            }
        }
        if (self.faults & CRITICAL_FLAGS) != critical {
            self.faults = (self.faults & !CRITICAL_FLAGS) | critical;
            self.settle(CRITICAL_FLAGS, now);
        }
    }

    // Status Register and All Other Latches: the flags of each group in `groups` follow their faults,
    // or gather them while the group latches, and the SMBus alert sets on a fault it doesn't mask.
    fn settle(&mut self, groups: u16, at: VirtualNanos) {
        for (group, latched) in [
            (WARNING_FLAGS, self.registers.bus_over_warning & LATCH != 0),
            (OVER_LIMIT_FLAGS, self.registers.bus_over_limit & LATCH != 0),
            (CRITICAL_FLAGS, self.registers.critical_positive & CRL != 0),
        ] {
            if group & groups == 0 {
                continue;
            }
            let held = if latched { self.flags & group } else { 0 };
            self.flags = (self.flags & !group) | held | (self.faults & group);
        }
        self.warning_since =
            (self.flags & WARNING_FLAGS != 0).then(|| self.warning_since.unwrap_or(at));
        self.raise(self.faults & FAULTS);
    }

    // SMBus Alert Response: `ALERT` and `SMBA` set on what isn't masked, while `SMAEN` lets them.
    fn raise(&mut self, events: u16) {
        if self.registers.alert_mask & SMAEN != 0 && events & self.registers.alert_mask != 0 {
            self.alert = true;
            self.flags |= SMBA;
        }
    }

    // Status Register: "The Conversion bit is set after all conversions, averaging, and
    // multiplications are complete", which in a triggered mode is an alert of its own.
    fn converted(&mut self) {
        self.flags |= CNVR;
        if self.triggered() {
            self.raise(CNVR);
        }
    }

    // Status Register: the read clears every flag a fault doesn't hold, and the alert with them. A
    // fault that stands sets its flag, and the alert, again.
    fn read_status(&mut self, now: VirtualNanos) -> u16 {
        let word = self.flags;
        self.flags = self.faults & (FAULTS | OVF);
        self.alert = false;
        self.warning_since =
            (self.flags & WARNING_FLAGS != 0).then_some(self.warning_since.unwrap_or(now));
        self.raise(self.faults & FAULTS);
        word
    }

    fn read_register(&mut self, register: u8, now: VirtualNanos) -> u16 {
        let registers = &self.registers;
        match register {
            CONFIGURATION => registers.configuration,
            STATUS => self.read_status(now),
            ALERT_MASK => registers.alert_mask,
            SHUNT_VOLTAGE => registers.shunt,
            BUS_VOLTAGE => registers.bus,
            POWER => registers.power,
            CURRENT => registers.current,
            SHUNT_POSITIVE_PEAK => registers.shunt_positive_peak,
            SHUNT_NEGATIVE_PEAK => registers.shunt_negative_peak,
            BUS_MAXIMUM_PEAK => registers.bus_maximum_peak,
            BUS_MINIMUM_PEAK => registers.bus_minimum_peak,
            POWER_PEAK => registers.power_peak,
            SHUNT_POSITIVE_WARNING => registers.shunt_positive_warning,
            SHUNT_NEGATIVE_WARNING => registers.shunt_negative_warning,
            POWER_WARNING => registers.power_warning,
            BUS_OVER_WARNING => registers.bus_over_warning,
            BUS_UNDER_WARNING => registers.bus_under_warning,
            POWER_OVER_LIMIT => registers.power_over_limit,
            BUS_OVER_LIMIT => registers.bus_over_limit,
            BUS_UNDER_LIMIT => registers.bus_under_limit,
            CRITICAL_POSITIVE => {
                let pin = self.gpio().unwrap_or(self.gpio_input);
                let gp = if pin == Level::High { GP } else { 0 };
                registers.critical_positive | gp
            }
            CRITICAL_NEGATIVE => registers.critical_negative,
            CALIBRATION => registers.calibration,
            _ => 0,
        }
    }

    fn write_register(&mut self, register: u8, word: u16, now: VirtualNanos) {
        let registers = &mut self.registers;
        match register {
            CONFIGURATION if word & RST != 0 => self.reset(now),
            CONFIGURATION => self.configure(word & CONFIGURATION_WRITABLE, now),
            ALERT_MASK => {
                registers.alert_mask = word & ALERT_MASK_WRITABLE;
                if registers.alert_mask & SMAEN == 0 {
                    self.alert = false;
                    self.flags &= !SMBA;
                }
                self.raise(self.faults & FAULTS);
            }
            SHUNT_POSITIVE_PEAK if word & PEAK_RESET != 0 => {
                registers.shunt_positive_peak = SHUNT_POSITIVE_PEAK_AT_RESET;
            }
            SHUNT_NEGATIVE_PEAK if word & PEAK_RESET != 0 => {
                registers.shunt_negative_peak = SHUNT_NEGATIVE_PEAK_AT_RESET;
            }
            BUS_MAXIMUM_PEAK if word & PEAK_RESET != 0 => registers.bus_maximum_peak = 0,
            BUS_MINIMUM_PEAK if word & PEAK_RESET != 0 => {
                registers.bus_minimum_peak = BUS_MINIMUM_PEAK_AT_RESET;
            }
            POWER_PEAK if word & PEAK_RESET != 0 => registers.power_peak = 0,
            SHUNT_POSITIVE_WARNING => registers.shunt_positive_warning = word,
            SHUNT_NEGATIVE_WARNING => registers.shunt_negative_warning = word,
            POWER_WARNING => registers.power_warning = word,
            BUS_OVER_WARNING => {
                registers.bus_over_warning = word & (BUS_LIMIT | POLARITY | LATCH);
                self.settle(WARNING_FLAGS, now);
            }
            BUS_UNDER_WARNING => registers.bus_under_warning = word & BUS_LIMIT,
            POWER_OVER_LIMIT => registers.power_over_limit = word,
            BUS_OVER_LIMIT => {
                registers.bus_over_limit = word & (BUS_LIMIT | POLARITY | LATCH);
                self.settle(OVER_LIMIT_FLAGS, now);
            }
            BUS_UNDER_LIMIT => registers.bus_under_limit = word & BUS_LIMIT,
            CRITICAL_POSITIVE => {
                registers.critical_positive = word & !GP;
                self.settle(CRITICAL_FLAGS, now);
            }
            CRITICAL_NEGATIVE => registers.critical_negative = word,
            CALIBRATION => registers.calibration = word & CALIBRATION_WRITABLE,
            _ => {}
        }
    }

    // Basic ADC Functions and Status Register: the new mode from the write, after the 40 µs
    // power-down asks to leave it, with `CNVR` cleared unless the mode converts nothing.
    fn configure(&mut self, word: u16, now: VirtualNanos) {
        let asleep = self.mode() == 0;
        self.registers.configuration = word;
        let mode = self.mode();
        if mode & (MODE_SHUNT | MODE_BUS) == 0 {
            self.run = None;
            return;
        }
        self.flags &= !CNVR;
        let start = VirtualNanos(now.0 + if asleep { WAKE_NANOS } else { 0 });
        if mode & MODE_CONTINUOUS != 0 {
            self.begin(start, true);
        } else if self.convert == Level::Low {
            self.begin(start, false);
        } else {
            self.run = None;
        }
    }

    // Power-Up Conditions: "At device power up, all Status bits are masked" and every register is at
    // its power-on value, which converts continuously.
    fn reset(&mut self, now: VirtualNanos) {
        self.registers = AT_RESET;
        self.flags = 0;
        self.faults = 0;
        self.alert = false;
        self.warning_since = None;
        self.critical_since = [None; 2];
        self.begin(now, true);
    }
}

// The level on an open-drain output with its pull-up, asserted or not, and active high where `word`
// has the `polarity` bit set.
fn pin(active: bool, word: u16, polarity: u16) -> Level {
    Level::from(active == (word & polarity != 0))
}

impl Peer for Ina209 {
    // Table 1, Power-Up Conditions and SMBus Alert Response: its own address, the general call for a
    // write, and the alert response while its alert is active.
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

    // Figure 16: the pointer, then each register two bytes at a time.
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
                // Power-Up Conditions: the "I2C bus General Call Reset".
                if byte == GENERAL_CALL_RESET {
                    self.reset(now);
                }
            }
            Phase::Idle | Phase::ReadHigh | Phase::ReadLow(_) | Phase::AlertResponse => {
                return false;
            }
        }
        true
    }

    // Figure 17 and figure 18: the register at the pointer, most significant byte first, or the address
    // in answer to the alert response.
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
                self.alert = false;
                self.raise(self.faults & FAULTS);
                self.address << 1
            }
            _ => 0,
        }
    }

    fn stop(&mut self, _context: &mut Timeline<'_, '_>) {
        self.phase = Phase::Idle;
    }
}

store!(Ina209);
