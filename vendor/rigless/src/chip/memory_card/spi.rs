// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! The memory card's serial peripheral interface mode, SD Physical Layer Simplified Specification
//! 6.00 chapter 7.
//!
//! The card is one card with two front ends. [`crate::chip::sd::Card`] is the bus a controller
//! drives in commands and blocks, and [`Peer`] is this one, bytes behind a chip select. Both read
//! and write the same blocks and share the card state and the programming time. The card powers up
//! on the first and enters this one when it gets `CMD0` with the select asserted (7.2.1). From then
//! on it speaks only this, and [`MemoryCard::power_cycle`] is the way back (7.1).
//!
//! | Section | Behavior | Source | Test |
//! |---|---|---|---|
//! | Mode selection | `CMD0` with the select asserted and a valid CRC7 enters this mode and answers R1. Without the select, or with a bad CRC, the card stays on the SD bus and says nothing. Only a power cycle returns | 7.1, 7.2.1, 7.2.2 | `cmd0_with_select_enters_spi_mode_and_without_it_does_not`, `cmd0_needs_a_valid_crc_to_enter_spi_mode`, `a_card_in_spi_mode_leaves_the_sd_bus_until_power_cycled` |
//! | Command frame | Six bytes: start bit `0`, transmission bit `1`, index, argument, CRC7, end bit `1` | Table 7-1 | `a_command_frame_is_six_bytes` |
//! | CRC7 | Off by default in this mode. `CMD0` is checked on entry and `CMD8` always. `CMD59` turns it on and off. A bad one answers R1 with the communication CRC error bit and the command does not run, `09h` for `CMD8` in idle | 7.2.2, Table 7-5, Table 7-6 | `crc7_is_checked_for_cmd8_even_when_off`, `crc7_is_checked_for_every_command_after_cmd59`, `crc7_matches_the_specifications_examples` |
//! | R1 | The idle, illegal command, CRC error and parameter error bits. Idle is set from `CMD0` until `ACMD41` completes | 7.3.2.1, Table 7-6 | `initialization_walks_figure_7_2_to_ready_with_ccs` |
//! | R2 | `CMD13`: R1 and a second byte, whose out of range bit is cleared by being read | 7.3.2.3, 7.3.4 | `send_status_gives_two_bytes_and_clears_out_of_range_by_reading` |
//! | R3 | `CMD58`: R1 and the OCR, power up status bit 31 and `CCS` bit 30 valid only once initialization completes. `CCS` is zero for a standard capacity card | 7.3.2.4, 5.1 Table 5-1 | `initialization_walks_figure_7_2_to_ready_with_ccs`, `a_standard_capacity_card_ignores_hcs_and_reports_ccs_zero` |
//! | R7 | `CMD8`: R1 and the voltage and check pattern echoed. A voltage the card does not support, or with more than one bit set, echoes the pattern and a zero voltage | 7.3.2.6, Table 7-5, 4.3.13 | `cmd8_echoes_the_check_pattern_and_voltage`, `cmd8_with_a_voltage_the_card_does_not_run_on_answers_zero` |
//! | Initialization | `CMD8`, `CMD58`, then `ACMD41` with `HCS` until the idle bit clears, then `CMD58` for `CCS`. A high capacity card stays idle if `CMD8` was not sent first or `HCS` was zero. A standard capacity card ignores `HCS` | 7.2.1, Figure 7-2 and its note | `initialization_walks_figure_7_2_to_ready_with_ccs`, `acmd41_without_cmd8_or_without_hcs_never_completes`, `a_standard_capacity_card_ignores_hcs_and_reports_ccs_zero` |
//! | Idle state | Only `CMD0`, `CMD8`, `CMD55` for the escape, `CMD58`, `CMD59` and `ACMD41` are legal while idle | 7.2.7 | `a_command_in_idle_that_7_2_7_does_not_list_is_illegal` |
//! | `CMD9`, `CMD10` | R1 then a 16-byte block with start token `FEh` and CRC16. Its last byte is the register's CRC7 and end bit | 7.2.6, 4.5 | `csd_and_cid_come_as_a_data_block_with_crc16` |
//! | `CMD13` | R2 | 7.3.2.3 | `send_status_gives_two_bytes_and_clears_out_of_range_by_reading` |
//! | `CMD16` | Sets the block length, 1 to 512. Memory transfers stay 512 bytes, as for a high capacity card | 7.2.3, Table 7-3 | `cmd16_takes_a_length_up_to_512_and_refuses_more` |
//! | `CMD17`, `CMD18`, `CMD12` | R1, then token `FEh`, the block and its CRC16, and for `CMD18` the next block until `CMD12`. The address is a block, or a byte on a standard capacity card. An address past the end gets the parameter error. A multiple read that runs off the end sends the data error token with out of range. Any other command during a read is rejected as illegal | 7.2.3, 7.3.3.2, 7.3.3.3, 7.2.8, Figure 7-3 to 7-5 | `a_block_written_is_the_block_read_back`, `a_multiple_read_is_stopped_by_cmd12`, `a_multiple_read_past_the_end_sends_the_data_error_token` |
//! | `CMD24`, `CMD25` | R1, then the host sends token `FEh` (`FCh` for many), the block and CRC16. The card answers the data response token, `05h` accepted, `0Bh` CRC error, `0Dh` write error, then holds the line low while it programs. `FDh` ends a multiple write | 7.2.4, 7.3.3.1, 7.3.3.2, Figure 7-6 and 7-7 | `a_block_written_is_the_block_read_back`, `a_multiple_write_is_ended_by_the_stop_tran_token`, `a_bad_crc16_gets_the_crc_error_response_when_crc_is_on`, `a_write_holds_miso_low_for_the_programming_time` |
//! | Busy | MISO low while programming. A deselect does not stop it and a select finds it still low | 7.2.4, 7.3.2.2 | `a_write_holds_miso_low_for_the_programming_time`, `programming_goes_on_while_deselected` |
//! | `CMD55`, `ACMD23` | `CMD55` is the escape, in R1. `ACMD23` stores the pre-erase count of bits 22:0 | Table 7-3, Table 7-4 | `acmd23_stores_the_pre_erase_count` |
//! | `CMD59` | Bit 0 turns CRC7 checking, and the CRC16 of write data, on or off | Table 7-3, 7.2.2 | `crc7_is_checked_for_every_command_after_cmd59` |
//! | Illegal command | An index Table 7-3 and 7-4 do not mark for this mode, or that this card does not carry, answers R1 with the illegal command bit alone | 7.3.2.1, 7.2.8 | `an_unsupported_command_is_illegal` |
//! | MISO | The card puts `FFh` on MISO whenever it is not driving: between a command and its response, after a response, and when deselected | 7.2, 7.2.4 | `miso_idles_high_when_deselected_and_between_commands` |
//! | Snapshot | A transfer in the middle of a block is kept and resumes | snapshot | `a_snapshot_mid_block_resumes_the_transfer` |
//!
//! **What this mode leaves out, and why.**
//!
//! | Behavior | Source | Reason |
//! |---|---|---|
//! | The count of `FFh` bytes before a response, `NCR` | 7.2.6, 7.5 | The simplified specification names `NCR` once and leaves 7.5, the timing diagrams, blank. The model answers after [`RESPONSE_DELAY_BYTES`] bytes, a fixed count of its own, and a host that waits for the first byte with the top bit clear reads it |
//! | The access time before a read's start token | 7.2.3, 7.2.6 | Taken from the `TAAC` in the CSD, which the simplified specification gives no number for. The token follows the R1 |
//! | The length of the busy after `FDh` | 7.2.4, Figure 7-7 | The figure shows busy after the stop token and no length. The model holds the line low for [`PROGRAMMING`], as for a block |
//! | `ACMD41` completing | 7.2.1, Figure 7-2 | The text says only that the host repeats until idle clears. The card completes on the [`INITIALIZATION_POLLS`]th poll |
//! | `CMD0` and the CRC option | 7.2.2 | The text says checking follows `CMD59` after entry. It does not say `CMD0` resets the option, so it is kept |
//! | Idle against 7.2.1 | 7.2.1, 7.2.7 | 7.2.1 says every supported command is always available and 7.2.7 lists the few valid while idle. The model follows the list |
//! | `CMD12` outside a read | 7.2.8, 7.3.3.1 | Legal only in a read by 7.2.8, yet 7.3.3.1 has the host send it after a write error. The model accepts it with a clean R1 whenever the card is out of idle |
//! | Erase, write protection, lock, `CMD6`, `CMD1`, `CMD56`, `ACMD13`, `ACMD22`, `ACMD42`, `ACMD51` | Table 7-3, 7-4 | Not carried by the SD bus side either. They answer illegal command |
//! | Partial blocks and the card's own block length for memory transfers | 7.2.3 | Transfers are 512 bytes whatever `CMD16` set, as on a high capacity card, so on a standard capacity card a byte address that isn't the start of a block gets the parameter error rather than the address error |
//! | Write protect, ECC and controller errors | 7.3.2.3, 7.3.3.3 | A card that returns what was written has none. The only errors are the ones in the table above |
//! | A deselect in the middle of a command, a read or a block | 7.2 | The specification gives no behavior. The partial frame, the pending response and a read in progress are dropped, and a block half received is lost. Programming goes on |

use std::collections::VecDeque;

use crate::chip::Timeline;
use crate::chip::sd::{BLOCK, command};
use crate::chip::spi::Peer;
use crate::soc::{Access, FieldSpec};
use crate::time::VirtualNanos;

use super::{CARD_IDENTIFICATION, MemoryCard, OPERATING_RANGE, PROGRAMMING, State};

/// How many bytes of `FFh` the card sends between the end of a command and the start of its
/// response. The specification leaves the diagrams blank, so this is the model's count.
pub const RESPONSE_DELAY_BYTES: usize = 1;

/// How many `ACMD41` polls a card that takes `HCS` needs before the idle bit clears: the first
/// starts its initialization and the second finds it done.
pub const INITIALIZATION_POLLS: u32 = 2;

/// What the card puts on MISO when it has nothing to say: the line at rest, 7.2.
const MISO_IDLE: u8 = 0xFF;
/// What it puts there while programming: the busy token, "a zero value indicates card is busy",
/// 7.3.2.2.
const MISO_BUSY: u8 = 0x00;

/// 7.3.3.2: the byte before a single block, and before each block of a multiple read.
const START_BLOCK: u8 = 0xFE;
/// 7.3.3.2: the byte before each block of a multiple write.
const START_BLOCK_MULTIPLE: u8 = 0xFC;
/// 7.3.3.2: the byte that ends a multiple write, in place of a start block.
const STOP_TRAN: u8 = 0xFD;

/// Table 7-1, the command format, over the forty-eight bits as they cross.
mod frame {
    use super::{Access, FieldSpec};

    pub(super) const START: FieldSpec = FieldSpec::new("START", 47, 1, Access::ReadOnly);
    pub(super) const TRANSMISSION: FieldSpec =
        FieldSpec::new("TRANSMISSION", 46, 1, Access::ReadOnly);
    pub(super) const INDEX: FieldSpec = FieldSpec::new("INDEX", 40, 6, Access::ReadOnly);
    pub(super) const ARGUMENT: FieldSpec = FieldSpec::new("ARGUMENT", 8, 32, Access::ReadOnly);
    pub(super) const CRC7: FieldSpec = FieldSpec::new("CRC7", 1, 7, Access::ReadOnly);
    pub(super) const END: FieldSpec = FieldSpec::new("END", 0, 1, Access::ReadOnly);
}

/// Figure 7-9, the R1 response.
mod r1 {
    use super::{Access, FieldSpec};

    pub(super) const IN_IDLE_STATE: FieldSpec =
        FieldSpec::new("IN_IDLE_STATE", 0, 1, Access::ReadOnly);
    pub(super) const ILLEGAL_COMMAND: FieldSpec =
        FieldSpec::new("ILLEGAL_COMMAND", 2, 1, Access::ReadOnly);
    pub(super) const COM_CRC_ERROR: FieldSpec =
        FieldSpec::new("COM_CRC_ERROR", 3, 1, Access::ReadOnly);
    pub(super) const PARAMETER_ERROR: FieldSpec =
        FieldSpec::new("PARAMETER_ERROR", 6, 1, Access::ReadOnly);
}

/// The fields of the arguments Table 7-3 and 7-4 give, and of the OCR in Table 5-1.
mod argument {
    use super::{Access, FieldSpec};

    /// `CMD8`, 4.3.13: the voltage supplied.
    pub(super) const VHS: FieldSpec = FieldSpec::new("VHS", 8, 4, Access::ReadOnly);
    /// `CMD8`: the check pattern the card echoes.
    pub(super) const CHECK_PATTERN: FieldSpec =
        FieldSpec::new("CHECK_PATTERN", 0, 8, Access::ReadOnly);
    /// `ACMD41`: host capacity support.
    pub(super) const HCS: FieldSpec = FieldSpec::new("HCS", 30, 1, Access::ReadOnly);
    /// `ACMD23`: the number of blocks to pre-erase.
    pub(super) const ERASE_COUNT: FieldSpec =
        FieldSpec::new("ERASE_COUNT", 0, 23, Access::ReadOnly);
    /// `CMD59`: the CRC option.
    pub(super) const CRC_OPTION: FieldSpec = FieldSpec::new("CRC_OPTION", 0, 1, Access::ReadOnly);
    /// The OCR's card power up status, which reads low while the card is busy.
    pub(super) const POWER_UP: FieldSpec = FieldSpec::new("POWER_UP", 31, 1, Access::ReadOnly);
    /// The OCR's card capacity status.
    pub(super) const CCS: FieldSpec = FieldSpec::new("CCS", 30, 1, Access::ReadOnly);
}

/// The 2.7 to 3.6 V range `CMD8`'s voltage supplied field codes as `0001b`, Table 4-18.
const VHS_2_7_TO_3_6: u64 = 0b0001;

/// R2's second byte, Figure 7-10: the out of range bit is the lowest.
const STATUS_OUT_OF_RANGE: FieldSpec = FieldSpec::new("OUT_OF_RANGE", 0, 1, Access::ReadOnly);
/// The data error token's four low bits are R2's, and out of range is the highest of them,
/// Figure 7-13.
const ERROR_TOKEN_OUT_OF_RANGE: FieldSpec = FieldSpec::new("OUT_OF_RANGE", 3, 1, Access::ReadOnly);

/// 7.3.3.1: the data response token is `xxx0 sss1`.
mod response {
    use super::{Access, FieldSpec};

    pub(super) const STATUS: FieldSpec = FieldSpec::new("STATUS", 1, 3, Access::ReadOnly);
    pub(super) const MARK: FieldSpec = FieldSpec::new("MARK", 0, 1, Access::ReadOnly);
    pub(super) const ACCEPTED: u64 = 0b010;
    pub(super) const CRC_ERROR: u64 = 0b101;
    pub(super) const WRITE_ERROR: u64 = 0b110;
}

/// The longest block `CMD16` takes, 7.2.3.
const MAX_BLOCK_LENGTH: u32 = 512;

/// What a block in flight is doing, and where.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
struct Cursor {
    block: usize,
    multiple: bool,
}

/// What the card does with the next byte the host sends.
#[derive(Debug, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
enum Input {
    /// A command can start, or the byte is filler.
    #[default]
    Waiting,
    /// The bytes of a command so far, 7.3.1.1.
    Command { frame: [u8; 6], have: usize },
    /// A write has been accepted and the card waits for its start token, 7.2.4.
    Token(Cursor),
    /// A block is arriving, with its CRC16 after it.
    Data { cursor: Cursor, bytes: Vec<u8> },
}

/// The card's end of the serial interface. Everything else it keeps is the card's.
#[derive(Debug, Default, serde::Serialize, serde::Deserialize)]
#[expect(
    clippy::struct_excessive_bools,
    reason = "each is a separate fact the specification names, set and cleared by its own command"
)]
pub(super) struct Port {
    /// Whether `CMD0` with the select has put the card in this mode, 7.2.1.
    active: bool,
    selected: bool,
    /// `CMD59`'s option, 7.2.2.
    crc_checked: bool,
    /// Whether `CMD8` was accepted since `CMD0`, which decides what `ACMD41` does (Figure 7-2).
    interface_condition: bool,
    host_high_capacity: bool,
    polls: u32,
    escaped: bool,
    out_of_range: bool,
    pre_erase: u32,
    input: Input,
    /// What the card sends next, in order, ahead of anything it would generate.
    output: VecDeque<u8>,
    /// A read in progress, which makes its next block when the output runs dry.
    reading: Option<Cursor>,
}

impl Port {
    /// Whether the card has left the SD bus for this mode.
    pub(super) fn active(&self) -> bool {
        self.active
    }
}

/// 4.5: the CRC7 of a command or register, generator `x^7 + x^3 + 1`, over the bytes given.
fn crc7(bytes: &[u8]) -> u8 {
    let mut crc = 0u8;
    for byte in bytes {
        for position in (0..8).rev() {
            let top = ((crc >> 6) & 1) ^ ((byte >> position) & 1);
            crc = (crc << 1) & 0x7F;
            if top == 1 {
                crc ^= 0x09;
            }
        }
    }
    crc
}

/// 4.5: the CRC16 of a data block, generator `x^16 + x^12 + x^5 + 1`, starting from zero.
fn crc16(bytes: &[u8]) -> u16 {
    let mut crc = 0u16;
    for byte in bytes {
        crc ^= u16::from(*byte) << 8;
        for _ in 0..8 {
            crc = if crc & 0x8000 == 0 {
                crc << 1
            } else {
                (crc << 1) ^ 0x1021
            };
        }
    }
    crc
}

/// The six bytes of a command as the forty-eight bits of Table 7-1.
fn word(bytes: [u8; 6]) -> u64 {
    let [a, b, c, d, e, f] = bytes;
    u64::from_be_bytes([0, 0, a, b, c, d, e, f])
}

/// A field narrowed to the byte it sits in.
fn byte(value: u64) -> u8 {
    u8::try_from(value).expect("the fields are inside eight bits")
}

impl MemoryCard {
    /// Whether the card is in serial peripheral interface mode, which `CMD0` with the select
    /// asserted puts it in, 7.2.1.
    #[must_use]
    pub fn spi_mode(&self) -> bool {
        self.spi.active
    }

    /// Powers the card off and on: back on the SD bus, idle, with its blocks as they were, 7.1. The
    /// chip select is the host's wire, so the card finds it where the host left it.
    pub fn power_cycle(&mut self) {
        self.spi = Port {
            selected: self.spi.selected,
            ..Port::default()
        };
        self.state = State::Idle;
        self.streaming = None;
        self.escaped = false;
        self.programming_until = None;
        self.address = 0;
    }

    /// The pre-erase count `ACMD23` last gave, Table 7-4. The default is one block.
    #[must_use]
    pub fn pre_erase_blocks(&self) -> u32 {
        self.spi.pre_erase.max(1)
    }

    /// Whether CRC7 checking is on, which `CMD59` sets, 7.2.2.
    #[must_use]
    pub fn crc_checked(&self) -> bool {
        self.spi.crc_checked
    }

    fn busy_at(&self, now: VirtualNanos) -> bool {
        self.programming_until.is_some_and(|until| now < until)
    }

    /// Ends a programming time that has passed, which puts the card back where the transfer left it.
    fn settle(&mut self, now: VirtualNanos) {
        if self.programming_until.is_some() && !self.busy_at(now) {
            self.programming_until = None;
            if self.state == State::Programming {
                self.state = if matches!(self.spi.input, Input::Token(_)) {
                    State::ReceivingData
                } else {
                    State::Transfer
                };
            }
        }
    }

    /// The byte for one exchange: the pending output, a block a read is due, the busy token, or the
    /// line at rest.
    fn next_output(&mut self, now: VirtualNanos) -> u8 {
        if self.spi.output.is_empty() {
            self.queue_block();
        }
        if let Some(out) = self.spi.output.pop_front() {
            if self.spi.output.is_empty()
                && self.spi.reading.is_none()
                && self.state == State::SendingData
            {
                self.state = State::Transfer;
            }
            out
        } else if self.busy_at(now) {
            MISO_BUSY
        } else {
            MISO_IDLE
        }
    }

    /// The next block of a read, or the data error token where the card ends, 7.3.3.3.
    fn queue_block(&mut self) {
        let Some(cursor) = self.spi.reading else {
            return;
        };
        if cursor.block >= self.capacity {
            let token = ERROR_TOKEN_OUT_OF_RANGE.set(0, 1);
            self.spi.output.push_back(byte(token));
            self.spi.reading = None;
            return;
        }
        let data = self.stored(cursor.block);
        let mut check = crc16(&data);
        if self.answer_corrupt {
            check = !check;
        }
        self.spi.output.push_back(START_BLOCK);
        self.spi.output.extend(data);
        self.spi.output.extend(check.to_be_bytes());
        self.spi.reading = cursor.multiple.then_some(Cursor {
            block: cursor.block + 1,
            ..cursor
        });
    }

    /// The byte the host sent, taken into the command or block being received.
    fn take_input(&mut self, mosi: u8, now: VirtualNanos) {
        match std::mem::take(&mut self.spi.input) {
            Input::Waiting => {
                let first = word([mosi, 0, 0, 0, 0, 0]);
                if !frame::START.is_set(first) && frame::TRANSMISSION.is_set(first) {
                    self.spi.input = Input::Command {
                        frame: [mosi, 0, 0, 0, 0, 0],
                        have: 1,
                    };
                }
            }
            Input::Command { mut frame, have } => {
                frame[have] = mosi;
                if have + 1 == frame.len() {
                    self.run_frame(frame);
                } else {
                    self.spi.input = Input::Command {
                        frame,
                        have: have + 1,
                    };
                }
            }
            Input::Token(cursor) => self.take_token(cursor, mosi, now),
            Input::Data { cursor, mut bytes } => {
                bytes.push(mosi);
                if bytes.len() == BLOCK + 2 {
                    self.finish_block(cursor, &bytes, now);
                } else {
                    self.spi.input = Input::Data { cursor, bytes };
                }
            }
        }
    }

    fn take_token(&mut self, cursor: Cursor, mosi: u8, now: VirtualNanos) {
        let start = if cursor.multiple {
            START_BLOCK_MULTIPLE
        } else {
            START_BLOCK
        };
        if mosi == start {
            self.spi.input = Input::Data {
                cursor,
                bytes: Vec::with_capacity(BLOCK + 2),
            };
        } else if mosi == STOP_TRAN && cursor.multiple {
            self.program(now);
        } else {
            self.spi.input = Input::Token(cursor);
        }
    }

    /// The card is busy until the programming time has passed, 7.2.4.
    fn program(&mut self, now: VirtualNanos) {
        self.programming_until = Some(VirtualNanos(now.0 + PROGRAMMING.0));
        self.state = State::Programming;
    }

    /// A whole block and its CRC16 have arrived. The card answers with the data response token,
    /// 7.3.3.1, and programs a block that was accepted.
    fn finish_block(&mut self, cursor: Cursor, bytes: &[u8], now: VirtualNanos) {
        let (data, check) = bytes.split_at(BLOCK);
        let sent = u16::from_be_bytes([check[0], check[1]]);
        let status = if self.spi.crc_checked && crc16(data) != sent {
            response::CRC_ERROR
        } else if cursor.block >= self.capacity {
            response::WRITE_ERROR
        } else {
            self.block_mut(cursor.block).copy_from_slice(data);
            response::ACCEPTED
        };
        let token = response::MARK.set(response::STATUS.set(0, status), 1);
        self.spi.output.push_back(byte(token));
        let accepted = status == response::ACCEPTED;
        if accepted {
            self.program(now);
        }
        self.spi.input = if cursor.multiple && accepted {
            Input::Token(Cursor {
                block: cursor.block + 1,
                ..cursor
            })
        } else {
            Input::Waiting
        };
    }

    /// Queues a response after the delay before it, in place of anything still pending.
    fn respond(&mut self, bytes: &[u8]) {
        self.spi.output.clear();
        self.spi.output.extend([MISO_IDLE; RESPONSE_DELAY_BYTES]);
        self.spi.output.extend(bytes);
    }

    /// R1 with `flags` and the idle bit the card's state gives, 7.3.2.1.
    fn r1(&self, flags: u64) -> u8 {
        let idle = u64::from(self.state == State::Idle);
        byte(r1::IN_IDLE_STATE.set(flags, idle))
    }

    fn respond_ok(&mut self) {
        let ok = self.r1(0);
        self.respond(&[ok]);
    }

    fn respond_illegal(&mut self) {
        let illegal = self.r1(r1::ILLEGAL_COMMAND.set(0, 1));
        self.respond(&[illegal]);
    }

    /// An argument outside the card: R1 says so and `CMD13` finds the out of range bit after it.
    fn respond_parameter_error(&mut self) {
        self.spi.out_of_range = true;
        let error = self.r1(r1::PARAMETER_ERROR.set(0, 1));
        self.respond(&[error]);
    }

    /// A command has arrived whole, 7.3.1.1.
    fn run_frame(&mut self, frame: [u8; 6]) {
        let bits = word(frame);
        let index = byte(frame::INDEX.get(bits));
        let argument = u32::try_from(frame::ARGUMENT.get(bits)).expect("a field of 32 bits");
        let sent = byte(frame::CRC7.get(bits));
        let valid = frame::END.is_set(bits) && sent == crc7(&frame[..5]);
        let escaped = std::mem::take(&mut self.spi.escaped);

        if !self.spi.active {
            // 7.2.1: only `CMD0` with a valid CRC7 and the select asserted moves it to this mode.
            if index != command::GO_IDLE_STATE || !valid {
                return;
            }
            self.spi.active = true;
        } else if (self.spi.crc_checked || index == command::SEND_IF_COND) && !valid {
            // 7.2.2: a bad CRC answers the CRC error whatever the index, and the command does not run.
            let error = self.r1(r1::COM_CRC_ERROR.set(0, 1));
            self.respond(&[error]);
            return;
        }
        self.commanded.push((index, argument));
        if self.spi.reading.is_some() && index != command::STOP_TRANSMISSION {
            // 7.2.8: a command in a read is rejected, and the rejection disturbs the data.
            self.spi.reading = None;
            self.state = State::Transfer;
            self.respond_illegal();
            return;
        }
        self.execute(index, u64::from(argument), escaped);
    }

    /// Runs one command and queues what it answers.
    fn execute(&mut self, index: u8, argument: u64, escaped: bool) {
        let idle = self.state == State::Idle;
        if escaped {
            match index {
                command::SD_SEND_OP_COND => self.initialize(argument),
                command::SET_WR_BLK_ERASE_COUNT if !idle => {
                    self.spi.pre_erase = u32::try_from(argument::ERASE_COUNT.get(argument))
                        .expect("a field of 23 bits");
                    self.respond_ok();
                }
                _ => self.respond_illegal(),
            }
            return;
        }
        // 7.2.7: while idle these are the commands that are valid.
        let legal_idle = matches!(
            index,
            command::GO_IDLE_STATE
                | command::SEND_IF_COND
                | command::APP_CMD
                | command::READ_OCR
                | command::CRC_ON_OFF
        );
        if idle && !legal_idle {
            self.respond_illegal();
            return;
        }
        let block = u32::try_from(argument).expect("a field of 32 bits");
        match index {
            command::GO_IDLE_STATE => {
                self.state = State::Idle;
                self.streaming = None;
                self.escaped = false;
                self.programming_until = None;
                self.spi.reading = None;
                self.spi.input = Input::Waiting;
                self.spi.interface_condition = false;
                self.spi.host_high_capacity = false;
                self.spi.polls = 0;
                self.respond_ok();
            }
            command::SEND_IF_COND => self.interface_condition(argument),
            command::SEND_CSD => self.register_block(&self.card_specific()),
            command::SEND_CID => self.register_block(&CARD_IDENTIFICATION),
            command::STOP_TRANSMISSION => {
                self.spi.reading = None;
                self.state = State::Transfer;
                self.respond_ok();
            }
            command::SEND_STATUS => {
                let second = byte(STATUS_OUT_OF_RANGE.set(0, u64::from(self.spi.out_of_range)));
                self.spi.out_of_range = false;
                let ok = self.r1(0);
                self.respond(&[ok, second]);
            }
            command::SET_BLOCKLEN if (1..=MAX_BLOCK_LENGTH).contains(&block) => {
                self.block_length = block;
                self.respond_ok();
            }
            command::SET_BLOCKLEN => self.respond_parameter_error(),
            command::READ_SINGLE_BLOCK | command::READ_MULTIPLE_BLOCK => {
                if let Some(first) = self.offset(block) {
                    self.spi.reading = Some(Cursor {
                        block: first,
                        multiple: index == command::READ_MULTIPLE_BLOCK,
                    });
                    self.state = State::SendingData;
                    self.respond_ok();
                } else {
                    self.respond_parameter_error();
                }
            }
            command::WRITE_BLOCK | command::WRITE_MULTIPLE_BLOCK => {
                if let Some(first) = self.offset(block) {
                    self.spi.input = Input::Token(Cursor {
                        block: first,
                        multiple: index == command::WRITE_MULTIPLE_BLOCK,
                    });
                    self.state = State::ReceivingData;
                    self.respond_ok();
                } else {
                    self.respond_parameter_error();
                }
            }
            command::APP_CMD => {
                self.spi.escaped = true;
                self.respond_ok();
            }
            command::READ_OCR => {
                let [a, b, c, d] = self.ocr().to_be_bytes();
                let ok = self.r1(0);
                self.respond(&[ok, a, b, c, d]);
            }
            command::CRC_ON_OFF => {
                self.spi.crc_checked = argument::CRC_OPTION.is_set(argument);
                self.respond_ok();
            }
            _ => self.respond_illegal(),
        }
    }

    /// `CMD8`, Table 7-5: R7 with the voltage and pattern echoed when the card runs on the voltage.
    fn interface_condition(&mut self, argument: u64) {
        let supplied = argument::VHS.get(argument);
        let pattern = byte(argument::CHECK_PATTERN.get(argument));
        let accepted = supplied == VHS_2_7_TO_3_6;
        self.spi.interface_condition |= accepted;
        let voltage = if accepted { byte(supplied) } else { 0 };
        let ok = self.r1(0);
        self.respond(&[ok, 0, 0, voltage, pattern]);
    }

    /// `ACMD41`, 7.2.1: the card reads `HCS` at the first poll and completes on the
    /// [`INITIALIZATION_POLLS`]th. A high capacity card with no `CMD8` before it, or `HCS` zero,
    /// reports busy for good (the note to Figure 7-2). A standard capacity card ignores `HCS`.
    fn initialize(&mut self, argument: u64) {
        if self.spi.polls == 0 {
            self.spi.host_high_capacity =
                argument::HCS.is_set(argument) && self.spi.interface_condition;
        }
        self.spi.polls = self.spi.polls.saturating_add(1);
        let supported = self.standard_capacity || self.spi.host_high_capacity;
        if supported && self.spi.polls >= INITIALIZATION_POLLS {
            self.state = State::Transfer;
        }
        self.respond_ok();
    }

    /// The OCR, 5.1: the voltage window always, the power up status and `CCS` once initialized.
    fn ocr(&self) -> u32 {
        let window = argument::POWER_UP.set(u64::from(OPERATING_RANGE), 0);
        let ready = u64::from(self.state != State::Idle);
        let ocr = argument::POWER_UP.set(window, ready);
        let ocr = argument::CCS.set(ocr, ready & u64::from(!self.standard_capacity));
        u32::try_from(ocr).expect("the fields are inside 32 bits")
    }

    /// A register as the data block of a read, 7.2.6: R1, the start token, sixteen bytes and a
    /// CRC16. The register's last byte is its CRC7 and the end bit, 5.2.
    fn register_block(&mut self, words: &[u32; 4]) {
        let mut register = [0u8; 16];
        for (bytes, word) in register.as_chunks_mut::<4>().0.iter_mut().zip(words) {
            bytes.copy_from_slice(&word.to_be_bytes());
        }
        register[15] = (crc7(&register[..15]) << 1) | 1;
        let ok = self.r1(0);
        self.respond(&[ok, START_BLOCK]);
        self.spi.output.extend(register);
        self.spi.output.extend(crc16(&register).to_be_bytes());
    }
}

impl MemoryCard {
    /// The chip select falling.
    fn select_spi(&mut self) {
        self.spi.selected = true;
        self.spi.input = Input::Waiting;
    }

    /// The chip select rising: the card lets go of MISO, and what was in flight on the wire is gone.
    fn deselect_spi(&mut self) {
        self.spi.selected = false;
        self.spi.input = Input::Waiting;
        self.spi.output.clear();
        self.spi.reading = None;
        if matches!(self.state, State::SendingData | State::ReceivingData) {
            self.state = State::Transfer;
        }
    }

    /// One byte each way at `now`. A card that isn't selected leaves MISO high and takes nothing.
    fn exchange(&mut self, mosi: u8, now: VirtualNanos) -> u8 {
        if !self.spi.selected {
            return MISO_IDLE;
        }
        self.settle(now);
        let busy = self.busy_at(now);
        let out = self.next_output(now);
        if !busy {
            self.take_input(mosi, now);
        }
        out
    }
}

impl Peer for MemoryCard {
    fn select(&mut self, _context: &mut Timeline<'_, '_>) {
        self.select_spi();
    }

    fn deselect(&mut self, _context: &mut Timeline<'_, '_>) {
        self.deselect_spi();
    }

    fn transfer(&mut self, mosi: u32, _bits: u8, context: &mut Timeline<'_, '_>) -> u32 {
        u32::from(self.exchange(byte(u64::from(mosi & 0xFF)), context.now()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::snapshot;

    /// A command as the host sends it, with its CRC7.
    fn frame(index: u8, argument: u32) -> [u8; 6] {
        let [a, b, c, d] = argument.to_be_bytes();
        let head = [0x40 | index, a, b, c, d];
        [head[0], a, b, c, d, (crc7(&head) << 1) | 1]
    }

    fn send(card: &mut MemoryCard, bytes: &[u8]) -> Vec<u8> {
        bytes
            .iter()
            .map(|&byte| card.exchange(byte, VirtualNanos(0)))
            .collect()
    }

    /// The card selected and initialized the way Figure 7-2 has it, ready to read and write.
    fn started(card: &mut MemoryCard) {
        card.select_spi();
        send(card, &frame(command::GO_IDLE_STATE, 0));
        send(card, &frame(command::SEND_IF_COND, 0x1AA));
        for _ in 0..INITIALIZATION_POLLS {
            send(card, &frame(command::APP_CMD, 0));
            send(card, &frame(command::SD_SEND_OP_COND, 0x4000_0000));
        }
        send(card, &[0xFF; 16]);
        assert_eq!(card.state(), State::Transfer, "initialized");
    }

    fn clock(card: &mut MemoryCard, count: usize) -> Vec<u8> {
        send(card, &vec![0xFF; count])
    }

    /// A transfer in the middle of a block is what a snapshot keeps: a read goes on from the byte it
    /// was at and a write takes the rest of its block, on a card rebuilt from the bytes.
    #[test]
    fn a_snapshot_mid_block_resumes_the_transfer() {
        let pattern: Vec<u8> = (0..BLOCK)
            .map(|at| u8::try_from(at * 7 % 251).unwrap())
            .collect();
        let mut card = MemoryCard::holding(&pattern);
        started(&mut card);
        send(&mut card, &frame(command::READ_SINGLE_BLOCK, 0));
        let head = clock(&mut card, RESPONSE_DELAY_BYTES + 2 + 100);
        assert_eq!(head[RESPONSE_DELAY_BYTES], 0x00, "R1, ready");
        assert_eq!(head[RESPONSE_DELAY_BYTES + 1], START_BLOCK);
        let saved = snapshot::stored(&card).unwrap();
        let rest = clock(&mut card, BLOCK - 100 + 2);

        let mut restored = MemoryCard::empty(1);
        snapshot::load(&mut restored, snapshot::keep(saved)).unwrap();
        assert_eq!(
            clock(&mut restored, BLOCK - 100 + 2),
            rest,
            "the read resumes"
        );
        assert_eq!(rest[..BLOCK - 100], pattern[100..]);
        assert_eq!(
            rest[BLOCK - 100..],
            crc16(&pattern).to_be_bytes(),
            "and ends in its CRC16"
        );

        let mut writing = MemoryCard::empty(4);
        started(&mut writing);
        send(&mut writing, &frame(command::WRITE_BLOCK, 2));
        let mut sent = vec![START_BLOCK];
        sent.extend_from_slice(&pattern);
        sent.extend(crc16(&pattern).to_be_bytes());
        send(&mut writing, &sent[..201]);
        let saved = snapshot::stored(&writing).unwrap();
        let mut restored = MemoryCard::empty(1);
        snapshot::load(&mut restored, snapshot::keep(saved)).unwrap();
        send(&mut restored, &sent[201..]);
        assert_eq!(restored.stored(2).to_vec(), pattern, "the block is whole");
        assert_eq!(restored.stored(1), [0; BLOCK]);
    }
}
