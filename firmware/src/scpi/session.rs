//! Session of a SCPI controller: its configuration, and the effect of its lines.

use super::errors::{ScpiError, Status};
use super::header::{self, Command};
use crate::command::{self, Instrument};
use calib_core::point::{ExcitationKind, PointResult, PointSpec};
use calib_core::verdict::Verdict;
use calib_protocol::message::{Refusal, Request, Response, RunSpec};
use calib_protocol::record::RunLabels;
use core::fmt::Write;

/// SCPI's "not a number".
const NOT_A_NUMBER: f32 = 9.91e37;
/// After `*RST`: the reference point of ISO 16063-21, 5.3.
const AFTER_RESET: PointSpec = PointSpec {
    frequency_hz: 160.0,
    acceleration_rms_ms2: 10.0,
};

/// Answer a line left to be sent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Answer {
    /// Nothing.
    None,
    /// The bytes that were written.
    Now,
    /// `1` once no run is going on: `*OPC?` waits.
    OnceComplete,
}

/// One controller's settings, errors and events.
pub struct Session {
    point: PointSpec,
    status: Status,
    /// A run was begun here, and nothing configured since.
    initiated: bool,
    /// `*OPC` waits for its end.
    reports_end: bool,
}

impl Default for Session {
    fn default() -> Self {
        Self::new()
    }
}

type Done = Result<(), ScpiError>;

impl Session {
    /// As after power on.
    pub const fn new() -> Self {
        Self {
            point: AFTER_RESET,
            status: Status::new(),
            initiated: false,
            reports_end: false,
        }
    }

    /// A line was longer than there is room.
    pub fn overrun(&mut self) {
        self.status.push(ScpiError::InputOverrun);
    }

    /// Carries out a line of one or more commands, with answers into `out`:
    /// separated by semicolons, ended by LF. After `*OPC?` nothing more of a line
    /// is looked at.
    pub async fn line(
        &mut self,
        line: &str,
        instrument: &mut impl Instrument,
        out: &mut impl Write,
    ) -> Answer {
        let (mut answered, mut before) = (false, "");
        for text in line
            .split(';')
            .map(str::trim)
            .filter(|text| !text.is_empty())
        {
            let (header, parameter) = text.split_once([' ', '\t']).unwrap_or((text, ""));
            let Some(command) = header::find_after(before, header) else {
                self.status.push(ScpiError::UndefinedHeader);
                continue;
            };
            before = if header.starts_with('*') {
                before
            } else {
                header
            };
            if command == Command::IsComplete && is_running(instrument) {
                return Answer::OnceComplete;
            }
            if header.ends_with('?') {
                let separator = if answered { ";" } else { "" };
                let _ = out.write_str(separator);
                answered = true;
            }
            let done = self.carry_out(command, parameter.trim(), instrument, out);
            if let Err(error) = done.await {
                self.status.push(error);
            }
        }
        if !answered {
            return Answer::None;
        }
        let _ = out.write_str("\n");
        Answer::Now
    }

    async fn carry_out(
        &mut self,
        command: Command,
        parameter: &str,
        instrument: &mut impl Instrument,
        out: &mut impl Write,
    ) -> Done {
        let takes_number = matches!(command, Command::Frequency | Command::Acceleration);
        if !takes_number && !parameter.is_empty() {
            return Err(ScpiError::ParameterNotAllowed);
        }
        match command {
            Command::Identify => identify(instrument, out),
            Command::Reset => {
                instrument.stop().await;
                (self.point, self.initiated) = (AFTER_RESET, false);
            }
            Command::ClearStatus => {
                self.status.clear();
                self.reports_end = false;
            }
            Command::Events => {
                self.note_end(instrument);
                let _ = write!(out, "{}", self.status.take_events());
            }
            Command::Complete => self.reports_end = true,
            Command::IsComplete => drop(out.write_str("1")),
            Command::SelfTest => self_test(instrument, out).await?,
            Command::NextError => {
                let error = self.status.pop();
                let _ = write!(out, "{},\"{}\"", error.code(), error.text());
            }
            Command::Version => drop(out.write_str("1999.0")),
            Command::Frequency => {
                self.point.frequency_hz = number(parameter, &[("HZ", 1.0), ("KHZ", 1e3)])?;
                self.initiated = false;
            }
            Command::Acceleration => {
                self.point.acceleration_rms_ms2 = number(parameter, &[("M/S2", 1.0)])?;
                self.initiated = false;
            }
            Command::FrequencyIs => put(out, self.point.frequency_hz),
            Command::AccelerationIs => put(out, self.point.acceleration_rms_ms2),
            Command::Initiate => self.initiate(instrument).await?,
            Command::Abort => instrument.stop().await,
            Command::Verdict => self.verdict(instrument, out)?,
            Command::Catalog => catalog(instrument, out).await?,
            Command::Defects => defects(instrument, out),
            Command::Sensitivity | Command::Phase | Command::Uncertainty => {
                let fetched = self.fetch(command, instrument);
                put(out, fetched.unwrap_or(NOT_A_NUMBER));
                fetched?;
            }
        }
        Ok(())
    }

    async fn initiate(&mut self, instrument: &mut impl Instrument) -> Done {
        if is_running(instrument) {
            return Err(ScpiError::InitIgnored);
        }
        let spec = RunSpec {
            points: core::iter::once(self.point).collect(),
            excitation: ExcitationKind::SingleSine,
            labels: RunLabels::default(),
        };
        // The same road a frame takes, with the same rule who may start.
        let response = command::answer(Request::Start(spec), instrument).await;
        self.initiated = matches!(response, Response::Started { .. });
        let Response::Refused(refusal) = response else {
            return Ok(());
        };
        Err(match refusal {
            Refusal::Busy => ScpiError::InitIgnored,
            Refusal::OtherHost => ScpiError::OtherHost,
            Refusal::StorageFull => ScpiError::OutOfMemory,
            Refusal::PointList => ScpiError::DataOutOfRange,
            Refusal::Degraded(_) => ScpiError::Hardware,
            _ => ScpiError::StorageFault,
        })
    }

    /// The result of the run that was initiated here, once it is over.
    fn result(&self, instrument: &mut impl Instrument) -> Result<PointResult, ScpiError> {
        let over = self.initiated && !is_running(instrument);
        let result = if over { instrument.point(0) } else { None };
        // Another host may have run a list of its own since.
        result
            .filter(|result| result.spec == self.point)
            .ok_or(ScpiError::DataStale)
    }

    fn fetch(&self, what: Command, instrument: &mut impl Instrument) -> Result<f32, ScpiError> {
        let result = self.result(instrument)?;
        if result.verdict != Verdict::Pass {
            return Err(ScpiError::PointRefused);
        }
        Ok(match what {
            Command::Phase => result.phase_rad.to_degrees(),
            Command::Uncertainty => result.expanded_uncertainty_rel * result.sensitivity_v_per_ms2,
            _ => result.sensitivity_v_per_ms2,
        })
    }

    fn verdict(&self, instrument: &mut impl Instrument, out: &mut impl Write) -> Done {
        let result = self.result(instrument);
        let _ = match result.map(|result| result.verdict) {
            Ok(Verdict::Pass) => out.write_str("VALID"),
            Ok(Verdict::Refused(reason)) => write!(out, "REFUSED,{reason:?}"),
            Err(_) => out.write_str("NONE"),
        };
        result.map(drop)
    }

    /// `*OPC` asked for a bit once the run is over.
    fn note_end(&mut self, instrument: &mut impl Instrument) {
        if self.reports_end && !is_running(instrument) {
            self.reports_end = false;
            self.status.operation_complete();
        }
    }
}

/// True while a run is going on.
pub(super) fn is_running(instrument: &mut impl Instrument) -> bool {
    instrument.status().state.is_running()
}

fn identify(instrument: &mut impl Instrument, out: &mut impl Write) {
    let info = instrument.info();
    let _ = write!(
        out,
        "calib,Field Vibration Calibrator,{},{}",
        info.serial, info.firmware_version
    );
}

/// 0, or the number of the first line that failed, from 1; -1 where the test was not carried out.
async fn self_test(instrument: &mut impl Instrument, out: &mut impl Write) -> Done {
    // The same road a frame takes, with the same rule who may test.
    let response = command::answer(Request::SelfTest, instrument).await;
    let refused = match response {
        Response::SelfTest { lines } => {
            let failed = lines.iter().find(|line| !line.passed());
            let number = failed.map_or(0, |line| line.check as u8 + 1);
            let _ = write!(out, "{number}");
            return Ok(());
        }
        Response::Refused(Refusal::OtherHost) => ScpiError::OtherHost,
        _ => ScpiError::InitIgnored,
    };
    let _ = out.write_str("-1");
    Err(refused)
}

/// Names of what does not work, as strings; an empty one when all is well.
fn defects(instrument: &mut impl Instrument, out: &mut impl Write) {
    let defects = instrument.health().defects;
    let _ = out.write_str("\"");
    for (index, defect) in defects.iter().enumerate() {
        let separator = if index == 0 { "" } else { "," };
        let _ = write!(out, "{separator}{defect:?}");
    }
    let _ = out.write_str("\"");
}

/// A positive number with one of these units, or with none.
fn number(text: &str, units: &[(&str, f32)]) -> Result<f32, ScpiError> {
    if text.is_empty() {
        return Err(ScpiError::MissingParameter);
    }
    let upper = |unit: &str| {
        let start = text.len().checked_sub(unit.len())?;
        let tail = text.get(start..)?;
        tail.eq_ignore_ascii_case(unit).then(|| text.get(..start))?
    };
    // The longest unit that fits: KHZ ends in HZ.
    let found = units
        .iter()
        .rev()
        .find_map(|(unit, factor)| Some((upper(unit)?, *factor)));
    let (digits, factor) = found.unwrap_or((text, 1.0));
    let value: f32 = digits.trim().parse().map_err(|_| ScpiError::DataType)?;
    let value = value * factor;
    match value.is_finite() && value > 0.0 {
        true => Ok(value),
        false => Err(ScpiError::DataOutOfRange),
    }
}

/// A number in SCPI's NR3 form.
fn put(out: &mut impl Write, value: f32) {
    let _ = write!(out, "{value:E}");
}

/// Bytes used, bytes free (not known: 0), and every record. What does not fit is left out, and
/// an error says so.
async fn catalog(instrument: &mut impl Instrument, out: &mut impl Write) -> Done {
    let (mut used, mut from) = (0_u32, 0);
    let mut page = page_of(instrument, from).await?;
    // Twice through the list: its sum comes before its lines.
    loop {
        let bytes = page.records.iter().map(|record| record.bytes);
        used = bytes.fold(used, u32::saturating_add);
        match (page.more, page.records.last()) {
            (true, Some(last)) => from = last.id.saturating_add(1),
            _ => break,
        }
        page = page_of(instrument, from).await?;
    }
    let _ = write!(out, "{used},0");
    from = 0;
    loop {
        page = page_of(instrument, from).await?;
        for record in &page.records {
            let mut entry = heapless::String::<48>::new();
            let _ = write!(entry, ",\"{},BIN,{}\"", record.id, record.bytes);
            out.write_str(&entry).map_err(|_| ScpiError::TooMuchData)?;
        }
        match (page.more, page.records.last()) {
            (true, Some(last)) => from = last.id.saturating_add(1),
            _ => return Ok(()),
        }
    }
}

async fn page_of(
    instrument: &mut impl Instrument,
    from: u32,
) -> Result<crate::command::RecordPage, ScpiError> {
    let page = instrument.records(from).await;
    page.map_err(|_| ScpiError::StorageFault)
}
