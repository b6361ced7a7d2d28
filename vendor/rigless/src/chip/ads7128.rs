// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! The ADS7128, an eight-channel 12-bit ADC on an I2C bus whose channels are each an analog input, a
//! digital input or a digital output: conversions a read frame starts, a sequencer, an autonomous mode
//! with a window comparator per channel and an `ALERT` pin, averaging, statistics, an RMS module, a
//! zero-crossing detector, outputs that follow alerts and crossings, and a CRC on every byte.
//!
//! Written against TI's ADS7128 datasheet, SBAS868A, revised May 2020. Every section, table and figure
//! below is that document's.
//!
//! **Conversions are derived from virtual time.** Nothing is scheduled. A read frame and `CNVST`
//! convert at the instant of the access. In autonomous mode, at each access and each time a board asks
//! for the `ALERT` pin, the results that fell due since the sequence started are counted from table 5
//! and land, channel by channel, from the voltages held at that instant. A held voltage gives every
//! sample of a channel the same code, so the window comparator's counts, the statistics, the RMS
//! module and the zero-crossing detector take a run of them at once.
//!
//! **Pins are levels the board and the chip drive.** [`Ads7128::set_voltage`] is the voltage on a
//! channel's pin and [`Ads7128::set_supply`] the `AVDD` the ADC measures against. A digital input reads
//! the same voltage against `VIH` and `VIL`. [`Ads7128::output`] is what a digital output drives and
//! [`Ads7128::alert`] the `ALERT` pin's level. A chip on this seam has no line of its own back to the
//! part, so the board carries `ALERT` to whatever it wired the pin to.
//!
//! | Register or section | Behavior | Source | Test |
//! |---|---|---|---|
//! | The address | The resistors on `ADDR` select one of eight addresses, chosen by [`Addr`]. Nothing else is acknowledged | 8.3.5 table 2 | `it_answers_at_the_address_its_addr_resistors_select` |
//! | Power-up | The chip answers after `tPU`, 5 ms, with every register at its reset and `BOR` set | 8.4.1, 7.9, 8.6 table 10 | `it_answers_after_5_ms_with_every_register_at_its_reset` |
//! | Single register read | Opcode `0001 0000b` and an address, then a read frame "provides the same register data even if the host provides more clocks" | 8.5.1.1 figure 34, table 9 | `a_single_register_read_repeats_the_register` |
//! | Block read | Opcode `0011 0000b`: the registers in turn from the address, zeros where the map has none and past its end | 8.5.1.2 figure 35 | `a_block_read_walks_the_registers_and_reads_zero_where_there_are_none` |
//! | Single write, set bits and clear bits | Opcodes `0000 1000b`, `0001 1000b` and `0010 0000b` write a register, set the bits that are 1, or clear them | 8.5.2.1 to 8.5.2.3 figure 36 | `a_write_sets_or_clears_only_the_bits_its_opcode_says` |
//! | Block write | Opcode `0010 1000b` writes the registers in turn, "Writing data to addresses that do not exist ... have no effect" and data past the end is ignored | 8.5.2.4 figure 37 | `a_block_write_lands_in_the_registers_in_turn` |
//! | Reserved fields | Fields marked reserved read zero and keep nothing | 8.6 | `a_block_write_lands_in_the_registers_in_turn` |
//! | Manual mode | A read frame converts the channel `MANUAL_CHID` names, and after the last byte of a result "A new conversion is initiated on the ninth falling edge of SCL" | 8.4.2 figures 30 and 31, table 7 | `manual_mode_converts_the_channel_manual_chid_names_at_each_read_frame` |
//! | The transfer function | Straight binary, 1 LSB is `AVDD / 2^12`, a code from its voltage to 1 LSB above, and `FFFh` at the top | 8.3.2, 8.3.3 table 1 figure 22 | `the_code_is_the_voltage_over_avdd_as_table_1_gives` |
//! | Output data | Frame A is the 12-bit code and four zeros, frame B the 16-bit average, frames C and D append the channel ID or `{1, 0, CRCERR_IN, ALERT}`. `FIX_PAT` outputs `A5Ah` | 8.3.10 figure 25, 8.6.3 table 14 | `the_data_frames_carry_the_code_the_average_and_what_append_status_appends` |
//! | Averaging | `OSR` 1 to 128 samples, a 16-bit result, 1 LSB `AVDD / 2^16`, and `OSR_DONE` when it's complete | 8.3.6 figure 24, 8.6.4 table 15 | `the_data_frames_carry_the_code_the_average_and_what_append_status_appends` |
//! | `CNVST` | Writing 1 converts the selected channel without a read frame. The result goes to the statistics, and `OSR_DONE` is set. It reads back 0 | 8.3.6, 8.6.2 table 13 | `cnvst_converts_without_a_read_frame_and_sets_osr_done` |
//! | Auto-sequence mode | `SEQ_MODE` `01` with `SEQ_START` steps through the channels `AUTO_SEQ_CH_SEL` enables "in ascending order" after every conversion. `SEQ_STATUS` shows it running | 8.4.3 figure 32, 8.6.12 table 23 | `auto_sequence_mode_steps_through_the_enabled_channels` |
//! | Autonomous mode | `CONV_MODE` `01` converts the sequence by itself, one result every averaging's worth of cycles of table 5 by `OSC_SEL` and `CLK_DIV` | 8.4.4 figure 33, 8.3.9 table 5 | `autonomous_mode_converts_at_the_rate_table_5_gives` |
//! | The window comparator | With `DWC_EN`, a result above the high threshold or below the low one for `n+1` consecutive samples sets `EVENT_HIGH_FLAG` or `EVENT_LOW_FLAG`, "regardless of the `ALERT_CH_SEL` configuration". Thresholds are 12 bits across two registers | 8.3.11 figures 26 and 27, 8.6.22 to 8.6.25 | `the_window_comparator_flags_a_result_past_a_threshold_after_its_event_count` |
//! | Hysteresis | `HYSTERESIS_CHx` shifted left three is how far back past a threshold a result goes before the event ends | 8.6.22 table 33, figure 27 | `hysteresis_holds_an_event_until_the_result_is_back_past_it` |
//! | `EVENT_RGN` | 1 flags a result inside the band instead | 8.6.21 table 32 | `an_in_band_region_flags_a_result_between_the_thresholds` |
//! | The event flags | `EVENT_HIGH_FLAG` and `EVENT_LOW_FLAG` clear on a write of 1, and `EVENT_FLAG` is their OR | 8.6.18 to 8.6.20 | `the_event_flags_clear_on_a_write_of_one_and_event_flag_is_their_or` |
//! | `DWC_EN` | 0 resets the comparator, its counts and its state. The flags stand | 8.6.2 table 13 | `the_event_flags_clear_on_a_write_of_one_and_event_flag_is_their_or` |
//! | The `ALERT` pin | Asserts for an event flag of a channel `ALERT_CH_SEL` selects, for `RMS_DONE` under `ALERT_RMS` and for `CRC_ERR_IN` under `ALERT_CRCIN`. `ALERT_LOGIC` makes it active low or high | 8.3.11, 8.6.15 to 8.6.17 | `the_alert_pin_asserts_for_what_alert_ch_sel_and_alert_map_select_at_its_logic` |
//! | A pulsed `ALERT` | `ALERT_LOGIC` `1x` gives "one logic low pulse one time per alert flag", `tALERT` long, from the latest flag the results landing at once set | 8.6.17 table 28, 7.9 | `a_pulsed_alert_pin_pulses_once_for_each_new_flag`, `a_pulse_starts_at_the_latest_flag_a_run_of_results_sets` |
//! | Digital inputs | `PIN_CFG` 1 and `GPIO_CFG` 0 read the pin against `VIH` and `VIL` in `GPI_VALUE`, judged again when `AVDD` changes. With `ALERT_CH_SEL` and `DWC_EN`, logic 1 sets `EVENT_HIGH_FLAG`, or logic 0 `EVENT_LOW_FLAG` under `EVENT_RGN` | 8.3.8 table 4, 8.3.11.1 table 6, 7.5 | `a_digital_input_reads_its_level_and_flags_it_as_table_6_says`, `a_new_avdd_judges_every_digital_input_again` |
//! | Digital outputs | `GPIO_CFG` 1 drives `GPO_VALUE`, push-pull or open drain by `GPO_DRIVE_CFG` | 8.3.8 table 4, 8.6.7 to 8.6.10 | `a_digital_output_drives_gpo_value_push_pull_or_open_drain` |
//! | `CH_RST` | "All channels are configured as analog inputs irrespective of configuration in other registers" | 8.6.2 table 13 | `ch_rst_makes_every_channel_an_analog_input` |
//! | Statistics | With `STATS_EN`, `MAX_CHx`, `MIN_CHx` and `RECENT_CHx` record each result of an analog channel. Writing 1 to `STATS_EN` reinitializes them, and reading a `MAX` or `MIN` register resets it | 8.3.14, 8.6.54 to 8.6.101 | `the_statistics_record_each_result_and_a_read_resets_max_and_min` |
//! | Outputs on alerts | An event flag of a channel `GPOx_TRIG_EVENT_SEL` selects sets output `x` to its `GPO_VALUE_TRIG` bit, where `GPO_TRIGGER_CFG` enables it | 8.3.11.2.1, 8.6.105 to 8.6.117 | `an_alert_sets_the_outputs_its_trigger_selects` |
//! | Zero-crossing detect | The channel `ZCD_CHID` names crosses its high threshold, or a digital input changes, and each output `GPO_ZCD_UPDATE_EN` enables takes the value its `GPO_VALUE_ZCD_CFG` gives for the edge. `ZCD_BLANKING` ignores conversions after a crossing | 8.3.13 figure 29, 8.6.11, 8.6.13, 8.6.113 to 8.6.115 | `a_zero_crossing_sets_the_outputs_it_enables_and_blanking_ignores_what_follows` |
//! | The RMS module | `RMS_EN` written 1 clears the result and computes over `RMS_SAMPLES` of `RMS_CHID`, with 40 samples more to finish, then sets `RMS_DONE`. `RMS_DC_SUB` subtracts the mean | 8.3.12 equations 3 and 4, 8.6.102 to 8.6.104 | `the_rms_module_computes_over_its_samples_and_sets_rms_done` |
//! | CRC | With `CRC_EN` every byte read is followed by its CRC-8, polynomial `x8 + x2 + x + 1`, and every byte written must be. A mismatch drops the byte, sets `CRC_ERR_IN` and blocks writes but to `00h` and `01h` until it's cleared | 8.3.7 table 3, 8.6.1 table 12 | `crc_follows_every_byte_read_and_checks_every_byte_written` |
//! | `CONV_ON_ERR` | 1 makes a CRC error turn every channel analog and pause autonomous sequencing until `CRC_ERR_IN` is cleared | 8.6.5 table 16 | `crc_follows_every_byte_read_and_checks_every_byte_written` |
//! | Resets | `RST`, or the general call with `06h`, resets every register, sets `BOR` and answers again after `tRST`, 5 ms. `BOR` clears on a write of 1 | 8.4.1, 8.3.15.2, 8.6.1, 8.6.2, 7.9 | `rst_and_a_general_call_reset_every_register_and_set_bor` |
//! | The general call | `00h` is acknowledged, and `04h` after it re-reads the address, which the resistors hold where they were | 8.3.15.1, 8.3.15.3 | `rst_and_a_general_call_reset_every_register_and_set_bor` |
//! | High-speed mode | A frame of `0x09`, `0x0B`, `0x0D` or `0x0F` sets `I2C_SPEED` until a stop | 8.3.15.4, 8.6.1 | `a_high_speed_code_sets_i2c_speed_until_the_stop` |
//! | `CAL` | "After calibration is complete, this bit is set to 0b" | 8.3.4, 8.6.2 table 13 | `cal_clears_itself` |
//! | What it measures | A voltage on each channel's pin and on `AVDD`, in microvolts, [`Ads7128::set_voltage`] and [`Ads7128::set_supply`] | 8.3.2, 8.3.3 | `the_code_is_the_voltage_over_avdd_as_table_1_gives` |
//! | Determinism | The same accesses at the same instants give the same bytes, and a chip restored from its saved state goes on as the original does | Not a datasheet behavior | `the_same_accesses_give_the_same_bytes_and_a_restored_chip_goes_on_alike` |
//!
//! # What the model leaves out
//!
//! | Departure | Reason |
//! |---|---|
//! | A pin the part drives at the instant it changes | `ALERT` is answered when a board asks, at the instant it gives, and a pulse lasts its 100 ns. A chip on this seam reaches no line of the part's |
//! | Clock stretching and the conversion time | A read frame or `CNVST` converts, averaging included, at the instant of the access. The seam carries bytes, not a clock |
//! | A voltage changing during a run of samples | A run takes the voltage held at the access that finds it due, so an average of a changing voltage isn't a mean of its samples, and the averaged result is the 12-bit code with four zero bits |
//! | Noise, offset, gain error and the offset calibration | The electrical characteristics are the part's analog side. `CAL` completes at once and changes nothing |
//! | Autonomous mode's first start | 8.4.4 says "The first start of conversion must be provided by the host". The model takes the write of `SEQ_START`, the host's last step in figure 33, as that start, and ignores `CNVST` in autonomous mode |
//! | When an autonomous result lands | The page gives the cycle and not where in it the result is ready. A channel's result lands at the end of its last sample's cycle |
//! | A write while autonomous mode runs | 8.4.4 asks the host to stop the sequence first. A write of `OPMODE_CFG`, `OSR_CFG`, `SEQUENCE_CFG` or `AUTO_SEQ_CH_SEL` restarts the sample clock at the write, from the next channel |
//! | A data read in autonomous mode | Table 7 has the device start every conversion in autonomous mode. A read frame there converts nothing and reads zeros |
//! | A conversion of a channel that isn't analog | 8.6.13 says the data isn't valid. The model converts the voltage the board set on the pin |
//! | A reserved channel ID or `APPEND_STATUS` code | `MANUAL_CHID` past 7 converts nothing and reads a zero code. `APPEND_STATUS` `11b` appends nothing |
//! | A sequence with no channel enabled | The page doesn't say. In auto-sequence mode the mux stays on `MANUAL_CHID`, and autonomous mode converts nothing |
//! | Nothing before `tPU` | 7.9 gives 5 ms as the most power-up takes. The model answers nothing before it, nor before `tRST` after a reset |
//! | The in-band region's condition | 8.6.21 writes `(low threshold > conversion result < high threshold)`. The model reads it as the result between the thresholds, sets both flags, and widens the band by the hysteresis once a result is in it |
//! | Digital inputs and time | The comparator and the zero-crossing detector see a digital input's level when the board sets its voltage, at the instant of the chip's last access |
//! | `GPI_VALUE` for outputs | 8.3.8 says it reads the channels that are digital inputs and table 21 says all of `GPIO[7:0]`. The model gives the pin's level for every channel that's a GPIO and zero for an analog one |
//! | `GPO_VALUE` and the triggered values | Figure 28 has a trigger or a crossing replace what drives an output. The register keeps what was written, and a write of it drives every output again |
//! | `ALERT_DRIVE` | Kept and read back. With the pull-up an open drain needs, the pin's level is the same either way, so the model reads nothing from it |
//! | Results that land at once | In autonomous mode each channel's run of results lands whole, in sequence order, so an output that both an alert trigger and the zero-crossing detector update within one access takes the two in that order rather than in time order. A pulsed `ALERT` starts at the latest flag of the stretch |
//! | The zero-crossing detector's hysteresis | 8.3.13 compares the result with the channel's high threshold, and table 33 gives `HYSTERESIS_CHx` "for high and low thresholds" without naming the detector. The model releases a crossing back past the hysteresis, as the window comparator does |
//! | Set bits and clear bits on a flag a 1 clears | 8.5.2.2 and 8.5.2.3 don't say what either opcode does to `BOR`, `CRC_ERR_IN`, `RMS_DONE`, `OSR_DONE` or an event flag, which 8.6.1 and 8.6.19 clear by a write of 1. The model takes a 1 in either opcode's data as that write, so it clears the flag |
//! | The CRC's initial value | 8.3.7 gives the polynomial and not the initial value. The model starts from zero, as CRC-8 over `x8 + x2 + x + 1` usually does. The address byte carries none, and neither do the bytes after a general call |
//! | `CRC_ERR_FUSE` | The power-up configuration always loads, so it reads 0 |
//! | `RMS_DONE` on a new computation | The page clears it only by a write of 1, so a new computation leaves it as it was |
//! | Statistics when `STATS_EN` is written 1 | 8.3.14 reinitializes the module and lets previous values be read until a new result. `MAX` and `MIN` restart, and `RECENT` keeps its last result |
//! | The general call's address re-read | 8.3.15.3 re-reads `ADDR`. The resistors are fixed, so the address is too, and the chip answers throughout |
//! | High-speed mode on the bus | 7.6's timings are the clock's. The code isn't acknowledged, as no master code is on the I2C bus |

use crate::chip::Timeline;
use crate::chip::i2c::{GENERAL_CALL, GENERAL_CALL_RESET, Peer};
use crate::device::Level;
use crate::snapshot::store;
use crate::time::VirtualNanos;

/// 8.5 table 9: the opcodes.
const SINGLE_READ: u8 = 0x10;
const SINGLE_WRITE: u8 = 0x08;
const SET_BITS: u8 = 0x18;
const CLEAR_BITS: u8 = 0x20;
const BLOCK_READ: u8 = 0x30;
const BLOCK_WRITE: u8 = 0x28;

/// 8.6 table 10: the registers by address.
const SYSTEM_STATUS: u8 = 0x00;
const GENERAL_CFG: u8 = 0x01;
const DATA_CFG: u8 = 0x02;
const OSR_CFG: u8 = 0x03;
const OPMODE_CFG: u8 = 0x04;
const PIN_CFG: u8 = 0x05;
const GPIO_CFG: u8 = 0x07;
const GPO_DRIVE_CFG: u8 = 0x09;
const GPO_VALUE: u8 = 0x0B;
const GPI_VALUE: u8 = 0x0D;
const ZCD_BLANKING_CFG: u8 = 0x0F;
const SEQUENCE_CFG: u8 = 0x10;
const CHANNEL_SEL: u8 = 0x11;
const AUTO_SEQ_CH_SEL: u8 = 0x12;
const ALERT_CH_SEL: u8 = 0x14;
const ALERT_MAP: u8 = 0x16;
const ALERT_PIN_CFG: u8 = 0x17;
const EVENT_FLAG: u8 = 0x18;
const EVENT_HIGH_FLAG: u8 = 0x1A;
const EVENT_LOW_FLAG: u8 = 0x1C;
const EVENT_RGN: u8 = 0x1E;
/// 8.6.22 to 8.6.53: four registers a channel from `20h`.
const HYSTERESIS_CH0: u8 = 0x20;
const HIGH_TH_CH0: u8 = 0x21;
const EVENT_COUNT_CH0: u8 = 0x22;
const LOW_TH_CH0: u8 = 0x23;
const LOW_TH_CH7: u8 = 0x3F;
const REGISTERS_PER_CHANNEL: u8 = 4;
/// 8.6.54 to 8.6.101: two registers a channel, least significant first.
const MAX_CH0_LSB: u8 = 0x60;
const MAX_CH7_MSB: u8 = 0x6F;
const MIN_CH0_LSB: u8 = 0x80;
const MIN_CH7_MSB: u8 = 0x8F;
const RECENT_CH0_LSB: u8 = 0xA0;
const RECENT_CH7_MSB: u8 = 0xAF;
const RMS_CFG: u8 = 0xC0;
const RMS_LSB: u8 = 0xC1;
const RMS_MSB: u8 = 0xC2;
/// 8.6.105 to 8.6.112: one register every other address from `C3h`.
const GPO0_TRIG_EVENT_SEL: u8 = 0xC3;
const GPO7_TRIG_EVENT_SEL: u8 = 0xD1;
const GPO_VALUE_ZCD_CFG_CH0_CH3: u8 = 0xE3;
const GPO_VALUE_ZCD_CFG_CH4_CH7: u8 = 0xE4;
const GPO_ZCD_UPDATE_EN: u8 = 0xE7;
const GPO_TRIGGER_CFG: u8 = 0xE9;
const GPO_VALUE_TRIG: u8 = 0xEB;

/// 8.6.1 table 12.
const RSVD: u8 = 0x80;
const SEQ_STATUS: u8 = 0x40;
const I2C_SPEED: u8 = 0x20;
const RMS_DONE: u8 = 0x10;
const OSR_DONE: u8 = 0x08;
const CRC_ERR_IN: u8 = 0x02;
const BOR: u8 = 0x01;
/// 8.6.2 table 13.
const RMS_EN: u8 = 0x80;
const CRC_EN: u8 = 0x40;
const STATS_EN: u8 = 0x20;
const DWC_EN: u8 = 0x10;
const CNVST: u8 = 0x08;
const CH_RST: u8 = 0x04;
const RST: u8 = 0x01;
const GENERAL_CFG_KEPT: u8 = RMS_EN | CRC_EN | STATS_EN | DWC_EN | CH_RST;
/// 8.6.3 table 14.
const FIX_PAT: u8 = 0x80;
const APPEND_STATUS: u8 = 0x30;
const APPEND_STATUS_SHIFT: u32 = 4;
const APPEND_CHANNEL_ID: u8 = 0b01;
const APPEND_FLAGS: u8 = 0b10;
/// 8.6.4 table 15.
const OSR: u8 = 0x07;
/// 8.6.5 table 16.
const CONV_ON_ERR: u8 = 0x80;
const CONV_MODE: u8 = 0x60;
const CONV_MODE_SHIFT: u32 = 5;
const AUTONOMOUS: u8 = 0b01;
const OSC_SEL: u8 = 0x10;
const CLK_DIV: u8 = 0x0F;
/// 8.6.11 table 22.
const MULT_EN: u8 = 0x80;
const ZCD_BLANKING: u8 = 0x7F;
/// 8.6.12 table 23.
const SEQ_START: u8 = 0x10;
const SEQ_MODE: u8 = 0x03;
const AUTO_SEQUENCE: u8 = 0b01;
/// 8.6.13 table 24.
const ZCD_CHID: u8 = 0xF0;
const ZCD_CHID_SHIFT: u32 = 4;
const MANUAL_CHID: u8 = 0x0F;
/// 8.6.16 table 27.
const ALERT_RMS: u8 = 0x02;
const ALERT_CRCIN: u8 = 0x01;
/// 8.6.17 table 28.
const ALERT_DRIVE: u8 = 0x04;
const ALERT_LOGIC: u8 = 0x03;
const ALERT_ACTIVE_HIGH: u8 = 0x01;
const ALERT_PULSED: u8 = 0x02;
/// 8.6.22 and 8.6.24: the threshold's low bits above the hysteresis and the event count.
const THRESHOLD_LSB: u8 = 0xF0;
const THRESHOLD_LSB_SHIFT: u32 = 4;
const HYSTERESIS: u8 = 0x0F;
const HYSTERESIS_SHIFT: u32 = 3;
const EVENT_COUNT: u8 = 0x0F;
/// 8.6.102 table 113.
const RMS_CHID: u8 = 0xF0;
const RMS_CHID_SHIFT: u32 = 4;
const RMS_DC_SUB: u8 = 0x04;
const RMS_SAMPLES: u8 = 0x03;
/// 8.6.113 table 124: each output's two bits, the value on a rising crossing above the falling one.
const ZCD_RISING: u8 = 0b10;
const ZCD_FALLING: u8 = 0b01;
const ZCD_CFG_BITS: u32 = 2;
const ZCD_OUTPUTS_PER_REGISTER: u8 = 4;

/// What each register keeps of a write, 8.6. Reserved fields read zero.
const KEPT: [(u8, u8); 6] = [
    (DATA_CFG, FIX_PAT | APPEND_STATUS),
    (OSR_CFG, OSR),
    (SEQUENCE_CFG, SEQ_START | SEQ_MODE),
    (ALERT_MAP, ALERT_RMS | ALERT_CRCIN),
    (ALERT_PIN_CFG, ALERT_DRIVE | ALERT_LOGIC),
    (RMS_CFG, RMS_CHID | RMS_DC_SUB | RMS_SAMPLES),
];
/// 8.6.22 and 8.6.105: the registers whose reset isn't zero.
const HYSTERESIS_AT_RESET: u8 = 0xF0;
const HIGH_TH_AT_RESET: u8 = 0xFF;
const TRIG_EVENT_SEL_AT_RESET: u8 = 0x02;
const MINIMUM_AT_RESET: u16 = 0xFFFF;

/// 8.3.15.4: the high-speed codes `0x09` to `0x0F` are the addresses `04h` to `07h` with the read bit.
const HIGH_SPEED_CODES: std::ops::RangeInclusive<u8> = 0x04..=0x07;
/// 7.9: `tPU` and `tRST`.
const READY_NANOS: u64 = 5_000_000;
/// 7.9: `tALERT_HI` and `tALERT_LO` are 50 to 150 ns, and the model takes the middle.
const PULSE_NANOS: u64 = 100;
/// 8.3.3 equation 1: a code is `AVDD / 2^12`, and 8.3.6 equation 2 places it in a 16-bit result.
const CODES: u64 = 4_096;
const LARGEST_CODE: u16 = 0x0FFF;
const RESULT_SHIFT: u32 = 4;
/// 8.6.3 table 14: what `FIX_PAT` outputs.
const FIXED_PATTERN: u16 = 0x0A5A;
/// 8.3.10: the status flags appended, `{1b, 0b, CRCERR_IN, ALERT}`.
const STATUS_FLAGS_FIXED: u8 = 0b1000;
const STATUS_FLAG_CRC: u8 = 0b0010;
const STATUS_FLAG_ALERT: u8 = 0b0001;
/// 7.5: `VIH` is 0.7 `AVDD` and `VIL` 0.3 `AVDD`, in tenths.
const VIH_TENTHS: u64 = 7;
const VIL_TENTHS: u64 = 3;
const TENTHS: u64 = 10;
/// 8.3.9 table 5: the cycle at each `CLK_DIV`, in nanoseconds, for `OSC_SEL` 0 and then 1.
const CYCLE_NANOS: [[u64; 16]; 2] = [
    [
        1_000, 1_500, 2_000, 3_000, 4_000, 6_000, 8_000, 12_000, 16_000, 24_000, 32_000, 48_000,
        64_000, 96_000, 128_000, 192_000,
    ],
    [
        32_000, 48_000, 64_000, 96_000, 128_000, 192_000, 256_000, 384_000, 512_000, 768_000,
        1_024_000, 1_536_000, 2_048_000, 3_072_000, 4_096_000, 6_144_000,
    ],
];
/// 8.6.102 table 113: the samples an RMS is computed over, and the 40 more it takes to finish.
const RMS_SAMPLE_COUNTS: [u64; 4] = [1_024, 4_096, 16_384, 65_536];
const RMS_FINISH: u64 = 40;
/// 8.6.11 table 22: `MULT_EN` multiplies the blanking count by 8.
const BLANKING_MULTIPLIER: u32 = 8;
/// 8.3.7: CRC-8, `x8 + x2 + x + 1`.
const CRC_POLYNOMIAL: u8 = 0x07;
const CRC_TOP: u8 = 0x80;
const CHANNELS: u8 = 8;

/// How the board fits the resistors on `ADDR`, 8.3.5 figure 23 and table 2. `R1` runs to `DECAP` and
/// `R2` to ground.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub enum Addr {
    /// `R1` 0 Ω, `0010111b`.
    Decap0,
    /// `R1` 11 kΩ, `0010110b`.
    Decap11k,
    /// `R1` 33 kΩ, `0010101b`.
    Decap33k,
    /// `R1` 100 kΩ, `0010100b`.
    Decap100k,
    /// Neither fitted, `0010000b`.
    Open,
    /// `R2` 11 kΩ, `0010001b`.
    Ground11k,
    /// `R2` 33 kΩ, `0010010b`.
    Ground33k,
    /// `R2` 100 kΩ, `0010011b`.
    Ground100k,
}

impl Addr {
    /// The seven-bit address the resistors select.
    #[must_use]
    pub fn address(self) -> u8 {
        match self {
            Self::Decap0 => 0x17,
            Self::Decap11k => 0x16,
            Self::Decap33k => 0x15,
            Self::Decap100k => 0x14,
            Self::Open => 0x10,
            Self::Ground11k => 0x11,
            Self::Ground33k => 0x12,
            Self::Ground100k => 0x13,
        }
    }
}

/// One of the eight channels, `AIN0/GPIO0` to `AIN7/GPIO7`.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, serde::Serialize, serde::Deserialize,
)]
pub struct Channel(u8);

impl Channel {
    /// The channel at `index`, 0 to 7.
    #[must_use]
    pub const fn new(index: u8) -> Option<Self> {
        if index < CHANNELS {
            Some(Self(index))
        } else {
            None
        }
    }

    /// The channel's number, its ID in `MANUAL_CHID` and its bit in the per-channel registers.
    #[must_use]
    pub const fn index(self) -> u8 {
        self.0
    }
}

fn bit(channel: u8) -> u8 {
    1 << channel
}

/// A write's opcode, 8.5.2.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
enum Write {
    Single,
    Set,
    Clear,
    Block,
}

/// Where an I2C transaction is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
enum Phase {
    Idle,
    /// The first byte of a write frame is the opcode, 8.5.
    Opcode,
    /// The register address of a read command, block or not.
    ReadAddress {
        block: bool,
    },
    /// The register address of a write.
    WriteAddress(Write),
    /// The data of a write, to the register held, which a block write moves on past the map's end.
    Data(Write, u16),
    /// A frame the chip acknowledges and drops the rest of.
    Ignored,
    /// A read frame after a single register read, with the byte once it's read, 8.5.1.1.
    SingleRead {
        register: u16,
        byte: Option<u8>,
    },
    /// A read frame after a block read, at the register it reads next, 8.5.1.2.
    BlockRead {
        register: u16,
    },
    /// A read frame of conversion data, 8.3.10.
    DataRead,
    /// After the general-call address, 8.3.15.
    GeneralCall,
}

/// One channel's window comparator: whether each side is past its threshold, and the samples in a row
/// it has been, 8.3.11.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
struct Watch {
    high: bool,
    low: bool,
    band: bool,
    high_count: u64,
    low_count: u64,
    band_count: u64,
}

/// A run of one channel's identical results: how many, the first one's instant, and the gap.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Run {
    count: u64,
    first: VirtualNanos,
    stride: u64,
}

impl Run {
    fn at(self, sample: u64) -> VirtualNanos {
        VirtualNanos(self.first.0 + sample * self.stride)
    }
}

/// An RMS computation under way, 8.3.12.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
struct Rms {
    channel: u8,
    wanted: u64,
    taken: u64,
    converted: u64,
    sum: u128,
    squares: u128,
}

/// The output bytes of a read frame not yet read, 8.3.10, with their CRC bytes where `CRC_EN` adds
/// them.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
struct Frame {
    bytes: [u8; 6],
    length: u8,
    next: u8,
}

/// One ADS7128.
#[derive(Debug, serde::Serialize, serde::Deserialize)]
pub struct Ads7128 {
    address: u8,
    /// What the configuration registers keep, by address, zero where the map has none.
    registers: Vec<u8>,
    /// When the chip answers after power-up or a reset, 7.9.
    ready_at: VirtualNanos,
    /// The latest instant an access or a board brought the chip to.
    seen: VirtualNanos,
    /// `SYSTEM_STATUS`'s flags the chip keeps: `I2C_SPEED`, `RMS_DONE`, `OSR_DONE`, `CRC_ERR_IN` and
    /// `BOR`.
    status: u8,
    event_high: u8,
    event_low: u8,
    watches: [Watch; 8],
    maximum: [u16; 8],
    minimum: [u16; 8],
    recent: [u16; 8],
    rms: Option<Rms>,
    rms_result: u16,
    /// The zero-crossing detector's level and the conversions it still ignores.
    zcd: bool,
    blanking: u32,
    /// What each digital output drives, figure 28.
    outputs: u8,
    /// When `ALERT`'s last pulse began.
    pulse_at: Option<VirtualNanos>,
    /// The channel the sequencer converts next, or the first it looks from.
    sequence_next: u8,
    /// When autonomous mode's sample clock started, and the results landed since.
    autonomous: Option<(VirtualNanos, u64)>,
    microvolts: [u32; 8],
    supply: u32,
    /// Each pin's level as a digital input reads it, 7.5.
    digital: u8,
    phase: Phase,
    /// A read command waiting for its read frame, 8.5.1.
    pending: Option<(u16, bool)>,
    /// A byte written with `CRC_EN` that waits for its CRC, and the CRC of the byte just read.
    held: Option<u8>,
    crc_next: Option<u8>,
    frame: Frame,
}

impl Ads7128 {
    /// A part at power-up with the `ADDR` resistors as given, `AVDD` at 3.3 V and every channel at 0 V.
    /// It answers from 5 ms on the virtual clock.
    #[must_use]
    pub fn new(addr: Addr) -> Self {
        let mut chip = Self {
            address: addr.address(),
            registers: vec![0; 256],
            ready_at: VirtualNanos(READY_NANOS),
            seen: VirtualNanos(0),
            status: BOR,
            event_high: 0,
            event_low: 0,
            watches: [Watch::default(); 8],
            maximum: [0; 8],
            minimum: [MINIMUM_AT_RESET; 8],
            recent: [0; 8],
            rms: None,
            rms_result: 0,
            zcd: false,
            blanking: 0,
            outputs: 0,
            pulse_at: None,
            sequence_next: 0,
            autonomous: None,
            microvolts: [0; 8],
            supply: 3_300_000,
            digital: 0,
            phase: Phase::Idle,
            pending: None,
            held: None,
            crc_next: None,
            frame: Frame::default(),
        };
        chip.reset_registers();
        chip
    }

    /// The voltage on `channel`'s pin from now on, in microvolts.
    pub fn set_voltage(&mut self, channel: Channel, microvolts: u32) {
        self.microvolts[usize::from(channel.index())] = microvolts;
        self.judge(channel.index());
        self.inputs(self.seen);
    }

    /// `AVDD` from now on, in microvolts, which is also the ADC's reference, 8.3.2.
    pub fn set_supply(&mut self, microvolts: u32) {
        self.supply = microvolts.max(1);
        for channel in 0..CHANNELS {
            self.judge(channel);
        }
        self.inputs(self.seen);
    }

    // 7.5: a pin is 1 from `VIH`, 0.7 `AVDD`, up and 0 from `VIL`, 0.3 `AVDD`, down, and keeps its level
    // between.
    fn judge(&mut self, channel: u8) {
        let tenths = u64::from(self.microvolts[usize::from(channel)]) * TENTHS;
        let supply = u64::from(self.supply);
        if tenths >= VIH_TENTHS * supply {
            self.digital |= bit(channel);
        } else if tenths <= VIL_TENTHS * supply {
            self.digital &= !bit(channel);
        }
    }

    /// What the chip drives on `channel`, or `None` where it drives nothing: an analog or digital
    /// input, or an open-drain output at 1, 8.3.8 table 4.
    #[must_use]
    pub fn output(&self, channel: Channel) -> Option<Level> {
        let mask = bit(channel.index());
        if self.outputs_mask() & mask == 0 {
            return None;
        }
        let high = self.outputs & mask != 0;
        let push_pull = self.registers[usize::from(GPO_DRIVE_CFG)] & mask != 0;
        (push_pull || !high).then_some(Level::from(high))
    }

    /// The level on `ALERT` at `now`, with the pull-up an open drain needs, 8.3.11 and 8.6.17.
    pub fn alert(&mut self, now: VirtualNanos) -> Level {
        self.catch_up(now);
        let logic = self.register(ALERT_PIN_CFG) & ALERT_LOGIC;
        let active = if logic & ALERT_PULSED == 0 {
            self.alerting()
        } else {
            self.pulse_at
                .is_some_and(|at| now >= at && now.0 < at.0 + PULSE_NANOS)
        };
        Level::from(active == (logic & ALERT_ACTIVE_HIGH != 0))
    }

    fn register(&self, address: u8) -> u8 {
        self.registers[usize::from(address)]
    }

    fn flagged(&self, field: u8) -> bool {
        self.status & field != 0
    }

    fn crc_error(&self) -> bool {
        self.flagged(CRC_ERR_IN)
    }

    fn general(&self, field: u8) -> bool {
        self.register(GENERAL_CFG) & field != 0
    }

    // 8.6: every register at its reset.
    fn reset_registers(&mut self) {
        self.registers.fill(0);
        for channel in 0..CHANNELS {
            let base = HYSTERESIS_CH0 + REGISTERS_PER_CHANNEL * channel;
            self.registers[usize::from(base)] = HYSTERESIS_AT_RESET;
            self.registers[usize::from(base + HIGH_TH_CH0 - HYSTERESIS_CH0)] = HIGH_TH_AT_RESET;
            self.registers[usize::from(GPO0_TRIG_EVENT_SEL + 2 * channel)] =
                TRIG_EVENT_SEL_AT_RESET;
        }
    }

    // 8.4.1, 8.6.1 and 7.9: every register and state at its reset, `BOR` set, and the chip back after
    // `tRST`.
    fn reset(&mut self, now: VirtualNanos) {
        self.reset_registers();
        self.ready_at = VirtualNanos(now.0 + READY_NANOS);
        self.status = BOR;
        self.event_high = 0;
        self.event_low = 0;
        self.watches = [Watch::default(); 8];
        self.maximum = [0; 8];
        self.minimum = [MINIMUM_AT_RESET; 8];
        self.recent = [0; 8];
        self.rms = None;
        self.rms_result = 0;
        self.zcd = false;
        self.blanking = 0;
        self.outputs = 0;
        self.pulse_at = None;
        self.sequence_next = 0;
        self.autonomous = None;
        self.pending = None;
        self.held = None;
        self.crc_next = None;
        self.frame = Frame::default();
    }

    // 8.6.2 table 13 and 8.6.5 table 16: the channels that are GPIOs, none under `CH_RST` or a CRC
    // error with `CONV_ON_ERR`.
    fn gpio_mask(&self) -> u8 {
        let forced = self.general(CH_RST)
            || (self.crc_error() && self.register(OPMODE_CFG) & CONV_ON_ERR != 0);
        if forced { 0 } else { self.register(PIN_CFG) }
    }

    fn outputs_mask(&self) -> u8 {
        self.gpio_mask() & self.register(GPIO_CFG)
    }

    fn inputs_mask(&self) -> u8 {
        self.gpio_mask() & !self.register(GPIO_CFG)
    }

    fn analog(&self, channel: u8) -> bool {
        self.gpio_mask() & bit(channel) == 0
    }

    // 8.3.8: the level on each GPIO, what an output drives or the pin's own.
    fn gpi_value(&self) -> u8 {
        let push_pull = self.outputs_mask() & self.register(GPO_DRIVE_CFG);
        let open_drain = self.outputs_mask() & !self.register(GPO_DRIVE_CFG);
        let driven = (self.outputs & push_pull) | (self.digital & open_drain & self.outputs);
        (driven | (self.digital & self.inputs_mask())) & self.gpio_mask()
    }

    // 8.3.3 table 1: the 12-bit code of a channel's voltage, as a 16-bit result.
    fn result(&self, channel: u8) -> u16 {
        let code =
            u64::from(self.microvolts[usize::from(channel)]) * CODES / u64::from(self.supply);
        u16::try_from(code.min(u64::from(LARGEST_CODE))).expect("held to twelve bits")
            << RESULT_SHIFT
    }

    fn alerting(&self) -> bool {
        (self.event_high | self.event_low) & self.register(ALERT_CH_SEL) != 0
            || (self.flagged(RMS_DONE) && self.register(ALERT_MAP) & ALERT_RMS != 0)
            || (self.crc_error() && self.register(ALERT_MAP) & ALERT_CRCIN != 0)
    }

    fn sequencing(&self) -> bool {
        self.register(SEQUENCE_CFG) & SEQ_MODE == AUTO_SEQUENCE
            && self.register(SEQUENCE_CFG) & SEQ_START != 0
    }

    fn autonomous_mode(&self) -> bool {
        (self.register(OPMODE_CFG) & CONV_MODE) >> CONV_MODE_SHIFT == AUTONOMOUS
    }

    fn autonomous_running(&self) -> bool {
        self.autonomous_mode()
            && self.sequencing()
            && !(self.crc_error() && self.register(OPMODE_CFG) & CONV_ON_ERR != 0)
    }

    // 8.3.6 table 15: the samples averaged into one result.
    fn samples(&self) -> u64 {
        1 << (self.register(OSR_CFG) & OSR)
    }

    // 8.3.9 table 5.
    fn cycle_nanos(&self) -> u64 {
        let opmode = self.register(OPMODE_CFG);
        CYCLE_NANOS[usize::from(opmode & OSC_SEL != 0)][usize::from(opmode & CLK_DIV)]
    }

    // 8.4.3: the channels `AUTO_SEQ_CH_SEL` enables, from the one the sequencer looks at next.
    fn sequence(&self) -> impl Iterator<Item = u8> + use<> {
        let enabled = self.register(AUTO_SEQ_CH_SEL);
        let next = self.sequence_next;
        (0..CHANNELS)
            .map(move |offset| (next + offset) % CHANNELS)
            .filter(move |&channel| enabled & bit(channel) != 0)
    }

    // 8.4.4: the results due by `now` land, each channel's run at once, in the order the sequence
    // takes them.
    fn catch_up(&mut self, now: VirtualNanos) {
        self.seen = self.seen.max(now);
        if let Some((epoch, landed)) = self.autonomous {
            if self.autonomous_running() {
                let period = self.samples() * self.cycle_nanos();
                let due = now.0.saturating_sub(epoch.0) / period;
                let length =
                    u64::try_from(self.sequence().count()).expect("eight channels at most");
                if due > landed && length > 0 {
                    let new = due - landed;
                    let last = self
                        .sequence()
                        .nth(usize::try_from((new - 1) % length).expect("small"))
                        .expect("within the sequence");
                    for (position, channel) in self.sequence().enumerate() {
                        let position = u64::try_from(position).expect("eight channels at most");
                        let count = new / length + u64::from(position < new % length);
                        if count > 0 {
                            let first = VirtualNanos(epoch.0 + (landed + position + 1) * period);
                            let stride = length * period;
                            self.land(
                                channel,
                                Run {
                                    count,
                                    first,
                                    stride,
                                },
                            );
                        }
                    }
                    self.sequence_next = (last + 1) % CHANNELS;
                }
                self.autonomous = Some((epoch, due));
            } else {
                self.autonomous = None;
            }
        }
        self.inputs(now);
    }

    // 8.4.4: the sample clock from `now`, where autonomous mode runs.
    fn anchor(&mut self, now: VirtualNanos) {
        self.autonomous = self.autonomous_running().then_some((now, 0));
    }

    // 8.3.6 and 8.3.14: one channel's run of identical results.
    fn land(&mut self, channel: u8, run: Run) {
        let result = self.result(channel);
        let index = usize::from(channel);
        if self.analog(channel) {
            if self.general(STATS_EN) {
                self.recent[index] = result;
                self.maximum[index] = self.maximum[index].max(result);
                self.minimum[index] = self.minimum[index].min(result);
            }
            self.watch(channel, result, run);
            self.cross(channel, result, run.count);
            self.measure(channel, result, run);
        }
        self.status |= OSR_DONE;
    }

    // 8.6.22 to 8.6.25: a channel's high and low thresholds, its hysteresis, and the samples in a row
    // its event needs.
    fn thresholds(&self, channel: u8) -> (i32, i32, i32, u64) {
        let base = HYSTERESIS_CH0 + REGISTERS_PER_CHANNEL * channel;
        let hysteresis = self.register(base);
        let high = (u16::from(self.register(base + HIGH_TH_CH0 - HYSTERESIS_CH0))
            << THRESHOLD_LSB_SHIFT)
            | u16::from((hysteresis & THRESHOLD_LSB) >> THRESHOLD_LSB_SHIFT);
        let count = self.register(base + EVENT_COUNT_CH0 - HYSTERESIS_CH0);
        let low = (u16::from(self.register(base + LOW_TH_CH0 - HYSTERESIS_CH0))
            << THRESHOLD_LSB_SHIFT)
            | u16::from((count & THRESHOLD_LSB) >> THRESHOLD_LSB_SHIFT);
        (
            i32::from(high),
            i32::from(low),
            i32::from(hysteresis & HYSTERESIS) << HYSTERESIS_SHIFT,
            u64::from(count & EVENT_COUNT) + 1,
        )
    }

    // 8.3.11 figure 27: the window comparator over a run of identical results.
    fn watch(&mut self, channel: u8, result: u16, run: Run) {
        if !self.general(DWC_EN) {
            return;
        }
        let code = i32::from(result >> RESULT_SHIFT);
        let (high, low, hysteresis, needed) = self.thresholds(channel);
        let mut watch = self.watches[usize::from(channel)];
        let (high_set, low_set) = if self.register(EVENT_RGN) & bit(channel) == 0 {
            watch.high = code > high || (watch.high && code >= high - hysteresis);
            watch.low = code < low || (watch.low && code <= low + hysteresis);
            (
                streak(watch.high, &mut watch.high_count, run.count, needed),
                streak(watch.low, &mut watch.low_count, run.count, needed),
            )
        } else {
            let inside = low < code && code < high;
            let still = low - hysteresis < code && code < high + hysteresis;
            watch.band = inside || (watch.band && still);
            let set = streak(watch.band, &mut watch.band_count, run.count, needed);
            (set, set)
        };
        self.watches[usize::from(channel)] = watch;
        for (high, sample) in [(true, high_set), (false, low_set)] {
            if let Some(sample) = sample {
                self.flag(channel, high, run.at(sample));
            }
        }
    }

    // 8.6.19 and 8.6.20: an event flag sets, and a new one pulses `ALERT` and launches the outputs its
    // trigger selects, 8.3.11.2.1.
    fn flag(&mut self, channel: u8, high: bool, at: VirtualNanos) {
        let mask = bit(channel);
        let flags = if high {
            &mut self.event_high
        } else {
            &mut self.event_low
        };
        if *flags & mask != 0 {
            return;
        }
        *flags |= mask;
        if self.register(ALERT_CH_SEL) & mask != 0 {
            self.pulse(at);
        }
        let enabled = self.register(GPO_TRIGGER_CFG);
        let values = self.register(GPO_VALUE_TRIG);
        for output in 0..CHANNELS {
            let selects = self.register(GPO0_TRIG_EVENT_SEL + 2 * output) & mask != 0;
            if enabled & bit(output) != 0 && selects {
                self.outputs = (self.outputs & !bit(output)) | (values & bit(output));
            }
        }
    }

    // 8.3.11.1 table 6 and 8.3.13: what a digital input's level does to the comparator and the
    // zero-crossing detector.
    fn inputs(&mut self, now: VirtualNanos) {
        let inputs = self.inputs_mask();
        if self.general(DWC_EN) {
            let selected = inputs & self.register(ALERT_CH_SEL);
            let region = self.register(EVENT_RGN);
            for channel in (0..CHANNELS).filter(|&channel| selected & bit(channel) != 0) {
                let high = self.digital & bit(channel) != 0;
                if region & bit(channel) == 0 && high {
                    self.flag(channel, true, now);
                } else if region & bit(channel) != 0 && !high {
                    self.flag(channel, false, now);
                }
            }
        }
        let zcd = (self.register(CHANNEL_SEL) & ZCD_CHID) >> ZCD_CHID_SHIFT;
        if zcd < CHANNELS && inputs & bit(zcd) != 0 {
            let level = self.digital & bit(zcd) != 0;
            if level != self.zcd {
                self.zcd = level;
                self.launch_crossing(level);
            }
        }
    }

    // 8.3.13: the zero-crossing detector over a run of an analog channel's results, the crossing at its
    // high threshold after the blanking. The release past table 33's hysteresis is the model's reading,
    // which its departures record.
    fn cross(&mut self, channel: u8, result: u16, count: u64) {
        if (self.register(CHANNEL_SEL) & ZCD_CHID) >> ZCD_CHID_SHIFT != channel {
            return;
        }
        let code = i32::from(result >> RESULT_SHIFT);
        let (high, _, hysteresis, _) = self.thresholds(channel);
        let level = code > high || (self.zcd && code >= high - hysteresis);
        let skipped = u64::from(self.blanking).min(count);
        self.blanking -= u32::try_from(skipped).expect("held to the blanking");
        let rest = count - skipped;
        if rest == 0 || level == self.zcd {
            return;
        }
        self.zcd = level;
        self.launch_crossing(level);
        let blanking = self.register(ZCD_BLANKING_CFG);
        let multiplier = if blanking & MULT_EN != 0 {
            BLANKING_MULTIPLIER
        } else {
            1
        };
        let blanked = u64::from(u32::from(blanking & ZCD_BLANKING) * multiplier);
        self.blanking = u32::try_from(blanked.saturating_sub(rest - 1)).expect("small");
    }

    // 8.6.113 to 8.6.115: each output a crossing updates takes its value for the edge.
    fn launch_crossing(&mut self, rising: bool) {
        let enabled = self.register(GPO_ZCD_UPDATE_EN);
        for output in (0..CHANNELS).filter(|&output| enabled & bit(output) != 0) {
            let register = if output < ZCD_OUTPUTS_PER_REGISTER {
                GPO_VALUE_ZCD_CFG_CH0_CH3
            } else {
                GPO_VALUE_ZCD_CFG_CH4_CH7
            };
            let shift = u32::from(output % ZCD_OUTPUTS_PER_REGISTER) * ZCD_CFG_BITS;
            let configuration = (self.register(register) >> shift) & (ZCD_RISING | ZCD_FALLING);
            let edge = if rising { ZCD_RISING } else { ZCD_FALLING };
            if configuration & edge != 0 {
                self.outputs |= bit(output);
            } else {
                self.outputs &= !bit(output);
            }
        }
    }

    // 8.3.12 equation 3: a run of the RMS channel's results, the mean of their squares less the square
    // of their mean under `RMS_DC_SUB`, its 16-bit root once 40 more are converted.
    fn measure(&mut self, channel: u8, result: u16, run: Run) {
        let Some(mut rms) = self.rms else {
            return;
        };
        if rms.channel != channel {
            return;
        }
        let taken = run.count.min(rms.wanted - rms.taken);
        let result = u128::from(result);
        rms.sum += u128::from(taken) * result;
        rms.squares += u128::from(taken) * result * result;
        rms.taken += taken;
        let finished = rms.wanted + RMS_FINISH;
        if rms.converted + run.count < finished {
            rms.converted += run.count;
            self.rms = Some(rms);
            return;
        }
        let wanted = u128::from(rms.wanted);
        let mean = rms.sum / wanted;
        let mut squares = rms.squares / wanted;
        if self.register(RMS_CFG) & RMS_DC_SUB != 0 {
            squares = squares.saturating_sub(mean * mean);
        }
        self.rms_result = u16::try_from(squares.isqrt()).expect("the root of a 16-bit square");
        self.rms = None;
        if !self.flagged(RMS_DONE) && self.register(ALERT_MAP) & ALERT_RMS != 0 {
            self.pulse(run.at(finished - rms.converted - 1));
        }
        self.status |= RMS_DONE;
    }

    // 8.4.2 and 8.4.3: the channel a host-started conversion takes, the sequencer's next or
    // `MANUAL_CHID`'s.
    fn next_channel(&mut self) -> Option<u8> {
        if self.sequencing()
            && let Some(channel) = self.sequence().next()
        {
            self.sequence_next = (channel + 1) % CHANNELS;
            return Some(channel);
        }
        let channel = self.register(CHANNEL_SEL) & MANUAL_CHID;
        (channel < CHANNELS).then_some(channel)
    }

    // 8.3.10 figure 25: a conversion now and its output bytes, each followed by its CRC under `CRC_EN`.
    fn convert_frame(&mut self, now: VirtualNanos) {
        let converted = if self.autonomous_mode() {
            None
        } else {
            self.next_channel().map(|channel| {
                self.land(
                    channel,
                    Run {
                        count: 1,
                        first: now,
                        stride: 0,
                    },
                );
                (channel, self.result(channel))
            })
        };
        let data = self.register(DATA_CFG);
        let result = if data & FIX_PAT != 0 {
            FIXED_PATTERN << RESULT_SHIFT
        } else {
            converted.map_or(0, |(_, result)| result)
        };
        let channel = converted.map_or(self.register(CHANNEL_SEL) & MANUAL_CHID, |(channel, _)| {
            channel
        });
        let appended = match (data & APPEND_STATUS) >> APPEND_STATUS_SHIFT {
            APPEND_CHANNEL_ID => Some(channel),
            APPEND_FLAGS => {
                let mut flags = STATUS_FLAGS_FIXED;
                if self.crc_error() {
                    flags |= STATUS_FLAG_CRC;
                }
                if self.event_high | self.event_low != 0 {
                    flags |= STATUS_FLAG_ALERT;
                }
                Some(flags)
            }
            _ => None,
        };
        let [high, low] = result.to_be_bytes();
        let averaged = self.register(OSR_CFG) & OSR != 0;
        let mut data_bytes = [high, low, 0];
        let length = match (averaged, appended) {
            (_, None) => 2,
            (false, Some(nibble)) => {
                data_bytes[1] |= nibble;
                2
            }
            (true, Some(nibble)) => {
                data_bytes[2] = nibble << RESULT_SHIFT;
                3
            }
        };
        let mut frame = Frame::default();
        for &byte in &data_bytes[..length] {
            frame.bytes[usize::from(frame.length)] = byte;
            frame.length += 1;
            if self.general(CRC_EN) {
                frame.bytes[usize::from(frame.length)] = crc(byte);
                frame.length += 1;
            }
        }
        self.frame = frame;
    }

    // 8.6: a register read, with what the read does.
    fn read_register(&mut self, register: u8) -> u8 {
        let index = usize::from(register);
        match register {
            SYSTEM_STATUS => {
                let sequence = if self.autonomous_running() || self.sequencing() {
                    SEQ_STATUS
                } else {
                    0
                };
                RSVD | sequence | self.status
            }
            GENERAL_CFG => self.register(GENERAL_CFG) & GENERAL_CFG_KEPT,
            GPI_VALUE => self.gpi_value(),
            EVENT_FLAG => self.event_high | self.event_low,
            EVENT_HIGH_FLAG => self.event_high,
            EVENT_LOW_FLAG => self.event_low,
            MAX_CH0_LSB..=MAX_CH7_MSB => {
                let (channel, byte) = statistic(register - MAX_CH0_LSB);
                let word = &mut self.maximum[channel];
                let value = word.to_le_bytes()[byte];
                *word &= !(u16::from(u8::MAX) << (8 * byte));
                value
            }
            MIN_CH0_LSB..=MIN_CH7_MSB => {
                let (channel, byte) = statistic(register - MIN_CH0_LSB);
                let word = &mut self.minimum[channel];
                let value = word.to_le_bytes()[byte];
                *word |= u16::from(u8::MAX) << (8 * byte);
                value
            }
            RECENT_CH0_LSB..=RECENT_CH7_MSB => {
                let (channel, byte) = statistic(register - RECENT_CH0_LSB);
                self.recent[channel].to_le_bytes()[byte]
            }
            RMS_LSB => self.rms_result.to_le_bytes()[0],
            RMS_MSB => self.rms_result.to_le_bytes()[1],
            _ => self.registers[index],
        }
    }

    // 8.5.2 and 8.6: a write to `register` of `data` as the opcode says, where a write may land.
    fn write_register(&mut self, register: u8, data: u8, write: Write, now: VirtualNanos) {
        if self.crc_error() && register > GENERAL_CFG {
            return;
        }
        let old = self.register(register);
        let new = match write {
            Write::Single | Write::Block => data,
            Write::Set => old | data,
            Write::Clear => old & !data,
        };
        let ones = if write == Write::Clear { 0 } else { data };
        match register {
            SYSTEM_STATUS => {
                let paused = self.crc_error();
                self.status &= !(data & (RMS_DONE | OSR_DONE | CRC_ERR_IN | BOR));
                if paused && !self.crc_error() {
                    self.anchor(now);
                }
            }
            GENERAL_CFG => self.configure(new, ones, now),
            EVENT_HIGH_FLAG => self.event_high &= !data,
            EVENT_LOW_FLAG => self.event_low &= !data,
            GPI_VALUE
            | EVENT_FLAG
            | MAX_CH0_LSB..=MAX_CH7_MSB
            | MIN_CH0_LSB..=MIN_CH7_MSB
            | RECENT_CH0_LSB..=RECENT_CH7_MSB
            | RMS_LSB
            | RMS_MSB => {}
            _ if exists(register) => {
                let kept = KEPT
                    .iter()
                    .find(|&&(address, _)| address == register)
                    .map_or(u8::MAX, |&(_, kept)| kept);
                self.registers[usize::from(register)] = new & kept;
                match register {
                    GPO_VALUE => self.outputs = new,
                    SEQUENCE_CFG => {
                        if old & SEQ_START == 0 && new & SEQ_START != 0 {
                            self.sequence_next = 0;
                        }
                        self.anchor(now);
                    }
                    OPMODE_CFG | OSR_CFG | AUTO_SEQ_CH_SEL => self.anchor(now),
                    _ => {}
                }
            }
            _ => {}
        }
        self.inputs(now);
    }

    // 8.6.2 table 13: the fields `GENERAL_CFG` keeps, and the effect of a 1 written to the others.
    fn configure(&mut self, new: u8, ones: u8, now: VirtualNanos) {
        if ones & RST != 0 {
            self.reset(now);
            return;
        }
        let old = self.register(GENERAL_CFG);
        self.registers[usize::from(GENERAL_CFG)] = new & GENERAL_CFG_KEPT;
        if old & DWC_EN != 0 && new & DWC_EN == 0 {
            self.watches = [Watch::default(); 8];
        }
        if ones & STATS_EN != 0 {
            self.maximum = [0; 8];
            self.minimum = [MINIMUM_AT_RESET; 8];
        }
        if new & RMS_EN == 0 {
            self.rms = None;
        } else if ones & RMS_EN != 0 {
            let configuration = self.register(RMS_CFG);
            self.rms_result = 0;
            self.rms = Some(Rms {
                channel: (configuration & RMS_CHID) >> RMS_CHID_SHIFT,
                wanted: RMS_SAMPLE_COUNTS[usize::from(configuration & RMS_SAMPLES)],
                taken: 0,
                converted: 0,
                sum: 0,
                squares: 0,
            });
        }
        if ones & CNVST != 0
            && !self.autonomous_mode()
            && let Some(channel) = self.next_channel()
        {
            self.land(
                channel,
                Run {
                    count: 1,
                    first: now,
                    stride: 0,
                },
            );
        }
    }

    // 8.3.7: a byte written under `CRC_EN` waits for its CRC, and a mismatch drops it.
    fn checked(&mut self, byte: u8) -> Option<u8> {
        if !self.general(CRC_EN) {
            return Some(byte);
        }
        let Some(data) = self.held.take() else {
            self.held = Some(byte);
            return None;
        };
        if crc(data) == byte {
            return Some(data);
        }
        let reported = self.crc_error();
        self.status |= CRC_ERR_IN;
        if !reported && self.register(ALERT_MAP) & ALERT_CRCIN != 0 {
            self.pulse(self.seen);
        }
        None
    }

    // 8.5.1.2: a register's byte, zero where the map has none or past its end.
    fn register_byte(&mut self, register: u16) -> u8 {
        u8::try_from(register).map_or(0, |address| {
            if exists(address) {
                self.read_register(address)
            } else {
                0
            }
        })
    }

    // 8.3.7: a byte read, with its CRC to follow under `CRC_EN`.
    fn checksummed(&mut self, byte: u8) -> u8 {
        if self.general(CRC_EN) {
            self.crc_next = Some(crc(byte));
        }
        byte
    }

    // 8.6.17 table 28: a pulse at `at`, unless a later one already stands, since a run of results lands
    // its flags in sequence order and not in time order.
    fn pulse(&mut self, at: VirtualNanos) {
        self.pulse_at = self.pulse_at.max(Some(at));
    }

    // 8.5: a byte of a write frame, past its CRC.
    fn take(&mut self, byte: u8, now: VirtualNanos) {
        self.phase = match self.phase {
            Phase::Opcode => match byte {
                SINGLE_READ => Phase::ReadAddress { block: false },
                BLOCK_READ => Phase::ReadAddress { block: true },
                SINGLE_WRITE => Phase::WriteAddress(Write::Single),
                SET_BITS => Phase::WriteAddress(Write::Set),
                CLEAR_BITS => Phase::WriteAddress(Write::Clear),
                BLOCK_WRITE => Phase::WriteAddress(Write::Block),
                _ => Phase::Ignored,
            },
            Phase::ReadAddress { block } => {
                self.pending = Some((u16::from(byte), block));
                Phase::Ignored
            }
            Phase::WriteAddress(write) => Phase::Data(write, u16::from(byte)),
            Phase::Data(write, register) => {
                if let Ok(address) = u8::try_from(register) {
                    self.write_register(address, byte, write, now);
                }
                if write == Write::Block {
                    Phase::Data(write, register + 1)
                } else {
                    Phase::Ignored
                }
            }
            other => other,
        };
    }
}

// 8.6.54 to 8.6.101: which channel's statistic an offset from the first is, and which byte of it.
fn statistic(offset: u8) -> (usize, usize) {
    (usize::from(offset / 2), usize::from(offset % 2))
}

// 8.6 table 10: whether the map has a register at `address`.
fn exists(address: u8) -> bool {
    matches!(
        address,
        SYSTEM_STATUS..=PIN_CFG
            | GPIO_CFG
            | GPO_DRIVE_CFG
            | GPO_VALUE
            | GPI_VALUE
            | ZCD_BLANKING_CFG..=AUTO_SEQ_CH_SEL
            | ALERT_CH_SEL
            | ALERT_MAP..=EVENT_FLAG
            | EVENT_HIGH_FLAG
            | EVENT_LOW_FLAG
            | EVENT_RGN
            | HYSTERESIS_CH0..=LOW_TH_CH7
            | MAX_CH0_LSB..=MAX_CH7_MSB
            | MIN_CH0_LSB..=MIN_CH7_MSB
            | RECENT_CH0_LSB..=RECENT_CH7_MSB
            | RMS_CFG..=RMS_MSB
            | GPO_VALUE_ZCD_CFG_CH0_CH3
            | GPO_VALUE_ZCD_CFG_CH4_CH7
            | GPO_ZCD_UPDATE_EN
            | GPO_TRIGGER_CFG
            | GPO_VALUE_TRIG
    ) || (GPO0_TRIG_EVENT_SEL..=GPO7_TRIG_EVENT_SEL).contains(&address)
        && (address - GPO0_TRIG_EVENT_SEL).is_multiple_of(2)
}

// 8.3.11: the samples of a run, starting where the count left off, at which the event's `needed`
// samples in a row are reached, the first sample where they already were.
fn streak(active: bool, counted: &mut u64, count: u64, needed: u64) -> Option<u64> {
    if !active {
        *counted = 0;
        return None;
    }
    let before = *counted;
    *counted = before.saturating_add(count);
    if before >= needed {
        Some(0)
    } else if before + count >= needed {
        Some(needed - before - 1)
    } else {
        None
    }
}

// 8.3.7: CRC-8 over `x8 + x2 + x + 1`, from zero.
fn crc(byte: u8) -> u8 {
    (0..u8::BITS).fold(byte, |crc, _| {
        if crc & CRC_TOP != 0 {
            (crc << 1) ^ CRC_POLYNOMIAL
        } else {
            crc << 1
        }
    })
}

impl Peer for Ads7128 {
    // 8.3.5, 8.3.15 and 7.9: its own address once it's ready, the general call for a write, and the
    // high-speed codes, which it notes and doesn't acknowledge.
    fn start(&mut self, address: u8, read: bool, context: &mut Timeline<'_, '_>) -> bool {
        let now = context.now();
        self.catch_up(now);
        self.held = None;
        self.crc_next = None;
        if read && HIGH_SPEED_CODES.contains(&address) {
            self.status |= I2C_SPEED;
        }
        self.phase = if now < self.ready_at {
            Phase::Idle
        } else if address == GENERAL_CALL && !read {
            Phase::GeneralCall
        } else if address != self.address {
            Phase::Idle
        } else if !read {
            Phase::Opcode
        } else if let Some((register, block)) = self.pending.take() {
            if block {
                Phase::BlockRead { register }
            } else {
                Phase::SingleRead {
                    register,
                    byte: None,
                }
            }
        } else {
            self.convert_frame(now);
            Phase::DataRead
        };
        self.phase != Phase::Idle
    }

    fn write(&mut self, byte: u8, context: &mut Timeline<'_, '_>) -> bool {
        let now = context.now();
        self.catch_up(now);
        match self.phase {
            Phase::GeneralCall => {
                // 8.3.15.2: "On receiving a general call (00h) followed by a software reset (06h), the
                // device resets itself".
                if byte == GENERAL_CALL_RESET {
                    self.reset(now);
                }
                true
            }
            Phase::Opcode
            | Phase::ReadAddress { .. }
            | Phase::WriteAddress(_)
            | Phase::Data(..)
            | Phase::Ignored => {
                if let Some(byte) = self.checked(byte) {
                    self.take(byte, now);
                }
                true
            }
            Phase::Idle | Phase::SingleRead { .. } | Phase::BlockRead { .. } | Phase::DataRead => {
                false
            }
        }
    }

    // 8.5.1 and 8.4.2: a register, the same or the next, or conversion data, with a new conversion once
    // a result's bytes are all read.
    fn read(&mut self, _last: bool, context: &mut Timeline<'_, '_>) -> u8 {
        let now = context.now();
        self.catch_up(now);
        if let Some(crc) = self.crc_next.take() {
            return crc;
        }
        match self.phase {
            Phase::SingleRead { register, byte } => {
                let byte = byte.unwrap_or_else(|| self.register_byte(register));
                self.phase = Phase::SingleRead {
                    register,
                    byte: Some(byte),
                };
                self.checksummed(byte)
            }
            Phase::BlockRead { register } => {
                let byte = self.register_byte(register);
                self.phase = Phase::BlockRead {
                    register: register.saturating_add(1),
                };
                self.checksummed(byte)
            }
            Phase::DataRead => {
                if self.frame.next == self.frame.length {
                    self.convert_frame(now);
                }
                let byte = self.frame.bytes[usize::from(self.frame.next)];
                self.frame.next += 1;
                byte
            }
            _ => 0,
        }
    }

    // 8.3.15.4: a stop ends high-speed mode.
    fn stop(&mut self, _context: &mut Timeline<'_, '_>) {
        self.status &= !I2C_SPEED;
        self.phase = Phase::Idle;
    }
}

store!(Ads7128);
