//! Lines of the self-test, with their limits.
//!
//! A limit tells a board that is broken from one that works; it is no accuracy. Where the data sheet
//! states what a sound part does, the limit lies three times beyond it or more.

use super::figures::{AtRest, Loopback};
use super::option_bytes::{BROWN_OUT_LEVEL, OptionBytes};
use crate::alignment::Alignment;
use crate::thermometer::{HIGHEST_C, LOWEST_C};
use heapless::Vec;
use serde::{Deserialize, Serialize};

/// Room for lines.
pub const MAX_LINES: usize = 28;

/// Volts at a pin from one sample to the next, with a reference of 3.3 V.
const PIN_V: f32 = 3.3 / 65_536.0;

/// Quantity of a line. Numbers on the wire, counted from 0 in this order: new ones at the end.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Check {
    /// Supply of the converters by the internal reference, V.
    Supply,
    /// Temperature of the processor, degrees Celsius.
    Temperature,
    /// Mean of the reference's input at rest, V at the pin from mid-scale.
    ReferenceOffset,
    /// Noise of the reference's input at rest, V r.m.s. at the pin.
    ReferenceNoise,
    /// Mean of the input of the device under test at rest, V at the pin from mid-scale.
    DutOffset,
    /// Noise of the input of the device under test at rest, V r.m.s. at the pin.
    DutNoise,
    /// Gain from the drive's converter to ADC2 on the chip, 1 nominal.
    DriveGain,
    /// Mean of a tone of the drive's converter, V from mid-scale.
    DriveOffset,
    /// Repeating signal beside such a tone, relative to the tone, r.m.s.
    DriveDistortion,
    /// Signal beside it that does not repeat, relative to the tone, r.m.s.
    DriveNoise,
    /// Samples by which the device under test's half of a pair is later than the reference's.
    Alignment,
    /// Times sample pairs were lost since the start.
    LostPairs,
    /// Bytes of the stack never used since the start.
    Stack,
    /// Stored records that cannot be read to the byte; no value where the record area does not answer.
    Records,
    /// 1 if the last start came of a panic, the watchdog or a fall of the supply.
    LastStart,
    /// Things of the instrument that do not work.
    Defects,
    /// Longest time a piece of work took since the start, of the time it has.
    Deadline,
    /// Clock against the frames of a USB host, ppm; this line is there only where one was heard.
    Timebase,
    /// Level of the brown-out reset in the option bytes.
    BrownOut,
    /// Other option bytes that are not as delivered ([`OptionBytes::deviations`]).
    OptionBytes,
    /// Flash words of the image with wrong bits, mended or not.
    ImageErrors,
    /// Flash words of the record area with one wrong bit, which the part mends.
    FlashCorrected,
    /// Flash words of the record area with two wrong bits, which cannot be read.
    FlashUnreadable,
    /// Dither at the reference's input, V r.m.s. at the pin.
    ReferenceDither,
    /// Dither at the input of the device under test, V r.m.s. at the pin.
    DutDither,
}

/// One line: a value with its limits.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Line {
    /// Its quantity, and with it the unit.
    pub check: Check,
    /// The value; none where it could not be measured.
    pub value: Option<f32>,
    /// Least value of a sound board.
    pub lower: Option<f32>,
    /// Greatest value of a sound board.
    pub upper: Option<f32>,
}

impl Line {
    /// Whether the value is there and within its limits; what is not a number is not.
    pub fn passed(&self) -> bool {
        self.value.is_some_and(|value| {
            self.lower.is_none_or(|lower| value >= lower)
                && self.upper.is_none_or(|upper| value <= upper)
                && !value.is_nan()
        })
    }
}

/// Flash words whose check bits do not fit, one wrong bit and two.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct WrongWords {
    /// One, which the part mends at each read.
    pub corrected: u32,
    /// Two: the word cannot be read.
    pub unreadable: u32,
}

/// Measurements of a board.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Evidence {
    /// Supply of the converters, V.
    pub supply_v: Option<f32>,
    /// Temperature of the processor, degrees Celsius.
    pub temperature_c: Option<f32>,
    /// Both inputs, reference first.
    pub at_rest: Option<[AtRest; 2]>,
    /// Both inputs at rest by single conversions, whose noise is the dither.
    pub dithered: Option<[AtRest; 2]>,
    /// The drive's converter heard by ADC2.
    pub loopback: Option<Loopback>,
    /// Alignment by a common signal.
    pub alignment: Alignment,
    /// Times pairs were lost.
    pub lost_pairs: u32,
    /// Bytes never used.
    pub stack_unused_bytes: u32,
    /// Stored records that cannot be read; none where the record area does not answer.
    pub records_unreadable: Option<u32>,
    /// Option bytes of the part, set in the workshop.
    pub option_bytes: OptionBytes,
    /// Wrong words of the image.
    pub image: WrongWords,
    /// Wrong words of the record area; none where it does not answer.
    pub record_area: Option<WrongWords>,
    /// The last start was nobody's wish.
    pub unwanted_start: bool,
    /// Things that do not work.
    pub defects: u32,
    /// Largest share of its time a piece of work took.
    pub deadline_rel: f32,
    /// How much faster the clock is than a USB host's frames, ppm.
    pub timebase_ppm: Option<f32>,
}

/// The lines of a board, in the order of [`Check`].
pub fn judge(board: &Evidence) -> Vec<Line, MAX_LINES> {
    let reference = board.at_rest.map(|[reference, _]| reference);
    let dut = board.at_rest.map(|[_, dut]| dut);
    let offset_v = |input: Option<AtRest>| input.map(|input| input.offset * PIN_V);
    let noise_v = |input: Option<AtRest>| input.map(|input| input.noise_rms * PIN_V);
    let drive = board.loopback;
    let shift = match board.alignment {
        Alignment::Aligned => Some(0.0),
        Alignment::Shifted(samples) => Some(f32::from(samples)),
        Alignment::Unclear => None,
    };
    let (options, area) = (board.option_bytes, board.record_area);
    let flag = |bad: bool| Some(f32::from(u8::from(bad)));
    let values = [
        (Check::Supply, board.supply_v),
        (Check::Temperature, board.temperature_c),
        (Check::ReferenceOffset, offset_v(reference)),
        (Check::ReferenceNoise, noise_v(reference)),
        (Check::DutOffset, offset_v(dut)),
        (Check::DutNoise, noise_v(dut)),
        (Check::DriveGain, drive.map(|drive| drive.gain)),
        (Check::DriveOffset, drive.map(|drive| drive.offset * PIN_V)),
        (
            Check::DriveDistortion,
            drive.map(|drive| drive.distortion_rel),
        ),
        (Check::DriveNoise, drive.map(|drive| drive.noise_rel)),
        (Check::Alignment, shift),
        (Check::LostPairs, Some(board.lost_pairs as f32)),
        (Check::Stack, Some(board.stack_unused_bytes as f32)),
        (Check::Records, board.records_unreadable.map(|n| n as f32)),
        (Check::LastStart, flag(board.unwanted_start)),
        (Check::Defects, Some(board.defects as f32)),
        (Check::Deadline, Some(board.deadline_rel)),
        (Check::Timebase, board.timebase_ppm),
        (Check::BrownOut, Some(f32::from(options.brown_out_level()))),
        (
            Check::OptionBytes,
            Some(options.deviations().count() as f32),
        ),
        (
            Check::ImageErrors,
            Some((board.image.corrected + board.image.unreadable) as f32),
        ),
        (
            Check::FlashCorrected,
            area.map(|area| area.corrected as f32),
        ),
        (
            Check::FlashUnreadable,
            area.map(|area| area.unreadable as f32),
        ),
        (
            Check::ReferenceDither,
            noise_v(board.dithered.map(|[reference, _]| reference)),
        ),
        (
            Check::DutDither,
            noise_v(board.dithered.map(|[_, dut]| dut)),
        ),
    ];
    let mut lines = Vec::new();
    for (check, value) in values {
        if check == Check::Timebase && value.is_none() {
            continue;
        }
        let (lower, upper) = limits(check);
        // There is room for all.
        let _ = lines.push(Line {
            check,
            value,
            lower,
            upper,
        });
    }
    lines
}

/// Limits of a check.
///
/// # Source
/// DS12110 Rev 10, table 188 (DAC): gain within 1 %, offset within 8 codes of 12 bits (6.4 mV) without
/// buffer, integral error 4 codes (0.1 % r.m.s. of the tone), SNR 67.8 dB (0.04 %). The others are
/// assumed: 3.3 V within 5 %; an input with 50 mV at its pin lost 3 % of its range; 5 mV r.m.s. is
/// hum or a broken converter, and 5 uV, a tenth of a code of 16 bits, is no converter at all; a stack
/// that came within 2 KiB of its end has no room left for what was not tried. A USB host may be 500 ppm
/// off (USB 2.0, 7.1.11), a crystal 50. A power cut leaves at most one word that cannot be read, until its
/// sector is erased; 16 of them are assumed to be no wear yet. One wrong bit is never left by
/// design.
/// The dither is 0.2726 V r.m.s. by the parts of the front end: 5 % less and the budget is no longer right,
/// 10 % more and signals are clipped that are not taken for it.
fn limits(check: Check) -> (Option<f32>, Option<f32>) {
    let around = |middle: f32, by: f32| (Some(middle - by), Some(middle + by));
    match check {
        Check::Supply => around(3.3, 0.165),
        Check::Temperature => (Some(LOWEST_C), Some(HIGHEST_C)),
        Check::ReferenceOffset | Check::DutOffset => around(0.0, 0.05),
        Check::ReferenceNoise | Check::DutNoise => (Some(5e-6), Some(5e-3)),
        Check::DriveGain => around(1.0, 0.03),
        Check::DriveOffset => around(0.0, 0.02),
        Check::DriveDistortion => (None, Some(3e-3)),
        Check::DriveNoise => (None, Some(2e-3)),
        Check::Alignment => around(0.0, 0.0),
        Check::LostPairs
        | Check::Records
        | Check::LastStart
        | Check::Defects
        | Check::OptionBytes
        | Check::ImageErrors
        | Check::FlashCorrected => (None, Some(0.0)),
        Check::FlashUnreadable => (None, Some(16.0)),
        Check::BrownOut => around(f32::from(BROWN_OUT_LEVEL), 0.0),
        Check::Deadline => (None, Some(1.0)),
        Check::Timebase => around(0.0, 550.0),
        Check::ReferenceDither | Check::DutDither => (Some(0.259), Some(0.300)),
        Check::Stack => (Some(2048.0), None),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const REST: AtRest = AtRest {
        offset: 10.0,
        noise_rms: 17.0,
    };
    const NONE_WRONG: WrongWords = WrongWords {
        corrected: 0,
        unreadable: 0,
    };
    const DITHER: AtRest = AtRest {
        offset: 10.0,
        // 0.2726 V of 3.3 V / 65 536.
        noise_rms: 5414.0,
    };
    const SOUND: Evidence = Evidence {
        supply_v: Some(3.3),
        temperature_c: Some(48.0),
        at_rest: Some([REST; 2]),
        dithered: Some([DITHER; 2]),
        loopback: Some(Loopback {
            gain: 1.002,
            offset: 30.0,
            distortion_rel: 3e-4,
            noise_rel: 4e-4,
        }),
        alignment: Alignment::Aligned,
        lost_pairs: 0,
        stack_unused_bytes: 12_000,
        records_unreadable: Some(0),
        option_bytes: OptionBytes(0x0006_AAFC),
        image: NONE_WRONG,
        record_area: Some(NONE_WRONG),
        unwanted_start: false,
        defects: 0,
        deadline_rel: 0.4,
        timebase_ppm: Some(-40.0),
    };

    fn failing(board: &Evidence) -> std::vec::Vec<Check> {
        let lines = judge(board);
        lines
            .iter()
            .filter(|line| !line.passed())
            .map(|line| line.check)
            .collect()
    }

    #[test]
    fn a_sound_board_passes_and_every_line_is_there_once() {
        assert_eq!(failing(&SOUND), []);
        let lines = judge(&SOUND);
        assert_eq!(lines.len(), Check::DutDither as usize + 1);
        assert!(lines.len() <= MAX_LINES);
        assert!(
            lines
                .iter()
                .enumerate()
                .all(|(place, line)| line.check as usize == place)
        );
    }

    #[test]
    fn what_was_not_measured_and_what_is_not_a_number_fails() {
        let board = Evidence {
            supply_v: None,
            temperature_c: Some(f32::NAN),
            ..SOUND
        };
        assert_eq!(failing(&board), [Check::Supply, Check::Temperature]);
        let board = Evidence {
            loopback: None,
            at_rest: None,
            dithered: None,
            ..SOUND
        };
        assert_eq!(failing(&board).len(), 10);
        let board = Evidence {
            alignment: Alignment::Unclear,
            ..SOUND
        };
        assert_eq!(failing(&board), [Check::Alignment]);
        let board = Evidence {
            records_unreadable: None,
            record_area: None,
            ..SOUND
        };
        let without_records = [
            Check::Records,
            Check::FlashCorrected,
            Check::FlashUnreadable,
        ];
        assert_eq!(failing(&board), without_records);
    }

    #[test]
    fn without_a_usb_host_there_is_no_line_about_the_clock() {
        let board = Evidence {
            timebase_ppm: None,
            ..SOUND
        };
        assert_eq!(judge(&board).len(), judge(&SOUND).len() - 1);
        assert!(
            judge(&board)
                .iter()
                .all(|line| line.check != Check::Timebase)
        );
        assert_eq!(failing(&board), []);
    }

    #[test]
    fn an_input_without_any_noise_is_no_converter() {
        let dead = AtRest {
            offset: 0.0,
            noise_rms: 0.0,
        };
        let board = Evidence {
            at_rest: Some([dead, REST]),
            ..SOUND
        };
        assert_eq!(failing(&board), [Check::ReferenceNoise]);
    }

    #[test]
    fn each_fault_fails_its_line() {
        type Fault = (Check, fn(&mut Evidence));
        let faults: [Fault; 18] = [
            (Check::Supply, |board| board.supply_v = Some(3.0)),
            (Check::Alignment, |board| {
                board.alignment = Alignment::Shifted(-1)
            }),
            (Check::LostPairs, |board| board.lost_pairs = 1),
            (Check::Stack, |board| board.stack_unused_bytes = 100),
            (Check::Records, |board| board.records_unreadable = Some(1)),
            (Check::LastStart, |board| board.unwanted_start = true),
            (Check::Defects, |board| board.defects = 1),
            (Check::Deadline, |board| board.deadline_rel = 1.01),
            (Check::Timebase, |board| board.timebase_ppm = Some(600.0)),
            (Check::BrownOut, |board| {
                board.option_bytes = OptionBytes(0x0006_AAF0)
            }),
            (Check::BrownOut, |board| {
                board.option_bytes = OptionBytes(0x0006_AAF8)
            }),
            (Check::OptionBytes, |board| {
                board.option_bytes = OptionBytes(0x0006_BBFC)
            }),
            (Check::ImageErrors, |board| board.image.corrected = 1),
            (Check::ImageErrors, |board| board.image.unreadable = 1),
            (Check::FlashCorrected, |board| {
                board.record_area = Some(WrongWords {
                    corrected: 1,
                    unreadable: 16,
                })
            }),
            (Check::FlashUnreadable, |board| {
                board.record_area = Some(WrongWords {
                    corrected: 0,
                    unreadable: 17,
                })
            }),
            (Check::ReferenceDither, |board| {
                board.dithered = Some([REST, DITHER]);
            }),
            (Check::DutDither, |board| {
                let more = AtRest {
                    noise_rms: 1.11 * DITHER.noise_rms,
                    ..DITHER
                };
                board.dithered = Some([DITHER, more]);
            }),
        ];
        for (check, happen) in faults {
            let mut board = SOUND;
            happen(&mut board);
            assert_eq!(failing(&board), [check]);
        }
    }
}
