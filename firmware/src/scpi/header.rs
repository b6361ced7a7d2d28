//! Headers: which command a line means.

/// A quantity of the result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Quantity {
    /// All of them, in this order.
    All,
    Sensitivity,
    Phase,
    Uncertainty,
    State,
    /// All of them at every point of a list.
    List,
}

impl Quantity {
    /// The question that fetches it.
    pub(super) fn fetch(self) -> &'static str {
        match self {
            Self::All => "FETC?",
            Self::Sensitivity => "FETC:SENS?",
            Self::Phase => "FETC:PHAS?",
            Self::Uncertainty => "FETC:UNC?",
            Self::State => "FETC:STAT?",
            Self::List => "FETC:LIST?",
        }
    }
}

/// A command of this instrument.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Command {
    Identify,
    Reset,
    ClearStatus,
    EventMask,
    EventMaskIs,
    Events,
    ServiceMask,
    ServiceMaskIs,
    StatusByte,
    Complete,
    IsComplete,
    Wait,
    SelfTest,
    NextError,
    ErrorCount,
    Version,
    Key,
    Frequency,
    FrequencyIs,
    Acceleration,
    AccelerationIs,
    SetList,
    SetListIs,
    Initiate,
    InitiateList,
    Abort,
    Fetch(Quantity),
    Read(Quantity),
    Measure(Quantity),
    Catalog,
    Data,
    Defects,
    Lists,
    ChooseList,
    ChosenList,
}

use Command::*;
use Quantity::*;

/// Headers as SCPI documents them: the short form is in capitals.
const HEADERS: &[(&str, Command)] = &[
    ("*IDN?", Identify),
    ("*RST", Reset),
    ("*CLS", ClearStatus),
    ("*ESE", EventMask),
    ("*ESE?", EventMaskIs),
    ("*ESR?", Events),
    ("*SRE", ServiceMask),
    ("*SRE?", ServiceMaskIs),
    ("*STB?", StatusByte),
    ("*OPC", Complete),
    ("*OPC?", IsComplete),
    ("*WAI", Wait),
    ("*TST?", SelfTest),
    ("SYSTem:ERRor?", NextError),
    ("SYSTem:ERRor:NEXT?", NextError),
    ("SYSTem:ERRor:COUNt?", ErrorCount),
    ("SYSTem:VERSion?", Version),
    ("SYSTem:KEY?", Key),
    ("CONFigure:FREQuency", Frequency),
    ("CONFigure:FREQuency?", FrequencyIs),
    ("CONFigure:ACCeleration", Acceleration),
    ("CONFigure:ACCeleration?", AccelerationIs),
    ("CONFigure:LIST", SetList),
    ("CONFigure:LIST?", SetListIs),
    ("INITiate", Initiate),
    ("INITiate:LIST", InitiateList),
    ("INITiate:IMMediate", Initiate),
    ("ABORt", Abort),
    ("FETCh?", Fetch(All)),
    ("FETCh:SENSitivity?", Fetch(Sensitivity)),
    ("FETCh:PHASe?", Fetch(Phase)),
    ("FETCh:UNCertainty?", Fetch(Uncertainty)),
    ("FETCh:STATe?", Fetch(State)),
    ("FETCh:LIST?", Fetch(List)),
    ("READ?", Read(All)),
    ("READ:SENSitivity?", Read(Sensitivity)),
    ("READ:PHASe?", Read(Phase)),
    ("READ:UNCertainty?", Read(Uncertainty)),
    ("READ:STATe?", Read(State)),
    ("READ:LIST?", Read(List)),
    ("MEASure?", Measure(All)),
    ("MEASure:SENSitivity?", Measure(Sensitivity)),
    ("MEASure:PHASe?", Measure(Phase)),
    ("MEASure:UNCertainty?", Measure(Uncertainty)),
    ("MEASure:STATe?", Measure(State)),
    ("MEASure:LIST?", Measure(List)),
    ("MMEMory:CATalog?", Catalog),
    ("MMEMory:DATA?", Data),
    ("DIAGnostic:DEFects?", Defects),
    ("LIST:CATalog?", Lists),
    ("LIST:CHOose", ChooseList),
    ("LIST:CHOose?", ChosenList),
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
            assert_eq!(find(header), Some(Fetch(Sensitivity)), "{header}");
        }
        for header in [
            "FETC:SENS",
            "FETC:SENSI?",
            "FET?",
            "FETC:SENS:X?",
            "",
            ":",
            "?",
            "*IDN",
            "IDN?",
        ] {
            assert_eq!(find(header), None, "{header}");
        }
        for quantity in [All, Sensitivity, Phase, Uncertainty, State, List] {
            assert_eq!(find(quantity.fetch()), Some(Fetch(quantity)));
        }
    }
}
