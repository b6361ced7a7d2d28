//! The self-test of a calibrator: what each line is called, and what to do when it fails.

use crate::code;
use calib_core::self_test::{Check, Line};
use schemars::JsonSchema;
use serde::Serialize;

/// Result of a self-test.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SelfTestView {
    /// Every line is within its limits.
    pub passed: bool,
    /// Lines of the test.
    pub lines: Vec<LineView>,
}

/// One line of a self-test.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct LineView {
    /// Number from 1, which `*TST?` answers for the first that failed.
    pub number: u8,
    /// Its quantity: `supply`, `drive_gain` ...
    pub check: String,
    /// The quantity in words.
    pub what: &'static str,
    /// The value, in `unit`; none where it could not be measured.
    pub value: Option<f32>,
    /// Unit of the value and its limits; `1` for a ratio or a count.
    pub unit: &'static str,
    /// Least value of a sound board.
    pub lower: Option<f32>,
    /// Greatest value of a sound board.
    pub upper: Option<f32>,
    /// The value is there and within its limits.
    pub passed: bool,
    /// Remedy, where it is not.
    pub remedy: Option<&'static str>,
}

impl From<&[Line]> for SelfTestView {
    fn from(lines: &[Line]) -> Self {
        let lines: Vec<LineView> = lines.iter().map(LineView::from).collect();
        Self {
            // No lines are no proof.
            passed: !lines.is_empty() && lines.iter().all(|line| line.passed),
            lines,
        }
    }
}

impl From<&Line> for LineView {
    fn from(line: &Line) -> Self {
        let (what, unit, remedy) = words(line.check);
        let passed = line.passed();
        Self {
            number: line.check as u8 + 1,
            check: code(&line.check),
            what,
            value: line.value,
            unit,
            lower: line.lower,
            upper: line.upper,
            passed,
            remedy: (!passed).then_some(remedy),
        }
    }
}

/// Words for a line, its unit, and its remedy when it fails.
fn words(check: Check) -> (&'static str, &'static str, &'static str) {
    const INPUT: &str = "unplug the transducers; if it stays, look for a short or an open part in that \
                         input's divider, bias and clamp";
    const NOISE: &str = "unplug the transducers and keep the table still; if it stays, look at the \
                         ground and the supply of that input; no noise at all is a dead converter";
    const DRIVE: &str = "the pin of the drive may be loaded or the part's reference noisy: unplug the \
                         output stage; if it stays, replace the board";
    const DITHER: &str = "look for the wire from the timer's pin to the front end, and at R61, C61 and U9; for a \
                          front end without dither set `dither_peak_v` of the settings to 0";
    match check {
        Check::Supply => (
            "supply of the converters",
            "V",
            "measure VDDA and VREF+ at the board: the regulator, its load, or a jumper",
        ),
        Check::Temperature => (
            "temperature of the processor",
            "degC",
            "let the instrument cool down or warm up; without a value its sensor does not answer",
        ),
        Check::ReferenceOffset => ("reference input at rest: offset", "V", INPUT),
        Check::ReferenceNoise => ("reference input at rest: noise, r.m.s.", "V", NOISE),
        Check::DutOffset => ("DUT input at rest: offset", "V", INPUT),
        Check::DutNoise => ("DUT input at rest: noise, r.m.s.", "V", NOISE),
        Check::DriveGain => ("drive to ADC2 on the chip: gain", "1", DRIVE),
        Check::DriveOffset => ("drive to ADC2 on the chip: offset", "V", DRIVE),
        Check::DriveDistortion => ("drive to ADC2 on the chip: distortion", "1", DRIVE),
        Check::DriveNoise => ("drive to ADC2 on the chip: noise", "1", DRIVE),
        Check::Alignment => (
            "DUT samples later than the reference's",
            "samples",
            "press the reset button; if it stays, see docs/hardware.md, Alignment",
        ),
        Check::LostPairs => (
            "times samples were lost since the start",
            "1",
            "reset and test again; if it comes back, keep `calib info` for a report",
        ),
        Check::Stack => (
            "stack never used",
            "bytes",
            "a defect of the firmware: keep `calib info` for a report",
        ),
        Check::Records => (
            "stored records that cannot be read",
            "1",
            "download what can be read, then replace the board",
        ),
        Check::LastStart => (
            "last start unwanted",
            "1",
            "`calib info` says why it restarted; look at the supply, then reset and test again",
        ),
        Check::Defects => (
            "things that do not work",
            "1",
            "`calib info` names them, and what to do",
        ),
        Check::Deadline => (
            "longest work, of the time it has",
            "1",
            "a defect of the firmware: keep `calib info` for a report",
        ),
        Check::ReferenceDither => ("reference input: dither, r.m.s.", "V", DITHER),
        Check::DutDither => ("DUT input: dither, r.m.s.", "V", DITHER),
        Check::Timebase => (
            "clock against the USB host",
            "ppm",
            "the clock from the ST-LINK, or that of this computer: try another host, then fit a crystal",
        ),
        Check::BrownOut => (
            "level of the brown-out reset",
            "1",
            "set it once, with the exciter unplugged: `./run brown-out`, or see docs/hardware.md, Brown-out \
             level",
        ),
        Check::OptionBytes => (
            "other option bytes not as delivered",
            "1",
            "`calib info` names them; set them back with STM32CubeProgrammer, records downloaded first",
        ),
        Check::ImageErrors => (
            "words of the image with wrong bits",
            "1",
            "put the image on the board again: `./run program`; if it comes back, replace the board",
        ),
        Check::FlashCorrected => (
            "record words mended at each read",
            "1",
            "download and release the records, so that their sector is erased; if it comes back, the flash \
             wears out: replace the board",
        ),
        Check::FlashUnreadable => (
            "record words that cannot be read",
            "1",
            "each power cut while something is stored leaves one: download and release the records, so that \
             their sector is erased; if they come back, replace the board",
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_that_fails_says_what_to_do_and_no_lines_are_no_pass() {
        let line = |value| Line {
            check: Check::DriveGain,
            value,
            lower: Some(0.9),
            upper: Some(1.1),
        };
        let view = SelfTestView::from(&[line(Some(1.0)), line(None)][..]);
        let states = view
            .lines
            .iter()
            .map(|line| (line.passed, line.remedy.is_some()));
        assert_eq!(states.collect::<Vec<_>>(), [(true, false), (false, true)]);
        assert_eq!((view.passed, view.lines[0].number), (false, 7));
        assert_eq!(view.lines[0].check, "drive_gain");
        assert!(!SelfTestView::from(&[][..]).passed);
    }
}
