//! Headers: which command a line means.

/// A command of this instrument.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Command {
    Identify,
    Reset,
    ClearStatus,
    Events,
    Complete,
    IsComplete,
    SelfTest,
    NextError,
    Version,
    Frequency,
    FrequencyIs,
    Acceleration,
    AccelerationIs,
    Initiate,
    Abort,
    Sensitivity,
    Phase,
    Uncertainty,
    Verdict,
    Catalog,
    Defects,
}

use Command::*;

/// Headers as SCPI documents them: the short form is in capitals.
const HEADERS: &[(&str, Command)] = &[
    ("*IDN?", Identify),
    ("*RST", Reset),
    ("*CLS", ClearStatus),
    ("*ESR?", Events),
    ("*OPC", Complete),
    ("*OPC?", IsComplete),
    ("*TST?", SelfTest),
    ("SYSTem:ERRor?", NextError),
    ("SYSTem:ERRor:NEXT?", NextError),
    ("SYSTem:VERSion?", Version),
    ("CONFigure:FREQuency", Frequency),
    ("CONFigure:FREQuency?", FrequencyIs),
    ("CONFigure:ACCeleration", Acceleration),
    ("CONFigure:ACCeleration?", AccelerationIs),
    ("INITiate", Initiate),
    ("INITiate:IMMediate", Initiate),
    ("ABORt", Abort),
    ("FETCh:SENSitivity?", Sensitivity),
    ("FETCh:PHASe?", Phase),
    ("FETCh:UNCertainty?", Uncertainty),
    ("FETCh:VERDict?", Verdict),
    ("MMEMory:CATalog?", Catalog),
    ("DIAGnostic:DEFects?", Defects),
];

/// The command of a header, in its short or long form, in any case.
pub(super) fn find(header: &str) -> Option<Command> {
    let header = header.strip_prefix(':').unwrap_or(header);
    let means = |(form, _): &&(&str, Command)| matches(form, header);
    HEADERS.iter().find(means).map(|(_, command)| *command)
}

/// As [`find`], or below the node of the header before it in the line: after
/// `CONF:FREQ 80`, `ACC 5` is `CONF:ACC 5`.
pub(super) fn find_after(before: &str, header: &str) -> Option<Command> {
    let below = || {
        let (node, _) = before.rsplit_once(':')?;
        let mut whole = heapless::String::<64>::new();
        whole.push_str(node).ok()?;
        whole.push(':').ok()?;
        whole.push_str(header).ok()?;
        find(&whole)
    };
    find(header).or_else(below)
}

fn matches(form: &str, header: &str) -> bool {
    let (form, asks) = question(form);
    let (header, asked) = question(header);
    let mut nodes = header.split(':');
    let all = form.split(':').all(|node| {
        let given = nodes.next().unwrap_or_default();
        let short = node.trim_end_matches(|letter: char| letter.is_ascii_lowercase());
        given.eq_ignore_ascii_case(node) || given.eq_ignore_ascii_case(short)
    });
    asks == asked && all && nodes.next().is_none()
}

fn question(text: &str) -> (&str, bool) {
    match text.strip_suffix('?') {
        Some(rest) => (rest, true),
        None => (text, false),
    }
}

#[cfg(test)]
mod unit {
    use super::*;

    #[test]
    fn short_and_long_forms_mean_the_same_and_nothing_between() {
        for header in [
            "FETC:SENS?",
            "fetch:sensitivity?",
            ":FETCh:sens?",
            "Fetc:SENSITIVITY?",
        ] {
            assert_eq!(find(header), Some(Sensitivity), "{header}");
        }
        for header in [
            "FETC:SENS",
            "FETC:SENSI?",
            "FETC?",
            "FETC:SENS:X?",
            "",
            ":",
            "?",
            "*IDN",
            "IDN?",
        ] {
            assert_eq!(find(header), None, "{header}");
        }
    }
}
