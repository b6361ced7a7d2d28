//! Session of a SCPI controller: the effect of its lines.

use super::errors::{ScpiError, Status};
use super::header::{self, Command, Quantity};
use super::measurement::{Measurement, What, is_running};
use super::number::{mask, put};
use super::{Answering, MAX_LINE, inquiry, lists};
use crate::command::Instrument;
use core::fmt::Write;
use heapless::String;

/// Answer a line left to be sent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Answer {
    /// Nothing.
    None,
    /// The bytes that were written.
    Now,
    /// The bytes that were written, if any; the rest of the line, and with it the end of the answer, once no
    /// run is going on.
    Later,
}

/// The rest of a line that waits for the end of a run.
struct Waiting {
    /// Longer by the question that a `READ?` became.
    rest: String<{ MAX_LINE + 16 }>,
    /// The header before it.
    before: String<64>,
    /// Something of the line was answered.
    answered: bool,
}

/// One controller's settings, errors and events.
pub struct Session {
    measurement: Measurement,
    status: Status,
    /// `*OPC` waits for the end of a run.
    reports_end: bool,
    waiting: Option<Waiting>,
}

impl Default for Session {
    fn default() -> Self {
        Self::new()
    }
}

impl Session {
    /// As after power on.
    pub const fn new() -> Self {
        Self {
            measurement: Measurement::AFTER_RESET,
            status: Status::new(),
            reports_end: false,
            waiting: None,
        }
    }

    /// A line was longer than there is room.
    pub fn overrun(&mut self) {
        self.status.push(ScpiError::InputOverrun);
    }

    /// True while the rest of a line waits for the end of a run.
    pub fn waits(&self) -> bool {
        self.waiting.is_some()
    }

    /// Carries out a line of one or more commands, with answers into `out`: separated by semicolons, ended
    /// by LF. What follows a command that waits for the end of a run waits with it, for [`Self::resume`];
    /// meanwhile other lines are carried out.
    pub async fn line(
        &mut self,
        line: &str,
        instrument: &mut impl Instrument,
        out: &mut impl Answering,
    ) -> Answer {
        self.units(line, "", false, instrument, out).await
    }

    /// Goes on with a line that waited, once no run is going on.
    pub async fn resume(
        &mut self,
        instrument: &mut impl Instrument,
        out: &mut impl Answering,
    ) -> Answer {
        let over = self.waits() && !is_running(instrument);
        match self.waiting.take_if(|_| over) {
            Some(Waiting {
                rest,
                before,
                answered,
            }) => self.units(&rest, &before, answered, instrument, out).await,
            None => Answer::None,
        }
    }

    async fn units<'a>(
        &mut self,
        line: &'a str,
        mut before: &'a str,
        mut answered: bool,
        instrument: &mut impl Instrument,
        out: &mut impl Answering,
    ) -> Answer {
        let mut rest = line;
        while !rest.is_empty() {
            let (unit, after) = rest.split_once(';').unwrap_or((rest, ""));
            rest = after;
            let (header, parameter) = unit
                .trim()
                .split_once([' ', '\t'])
                .unwrap_or((unit.trim(), ""));
            if header.is_empty() {
                continue;
            }
            let Some(command) = header::find_after(before, header) else {
                self.status.push(ScpiError::UndefinedHeader);
                // Who asked waits for something: it gets an empty answer.
                if header.ends_with('?') {
                    let _ = out.write_str(if answered { ";" } else { "" });
                    answered = true;
                }
                continue;
            };
            before = if header.starts_with('*') {
                before
            } else {
                header
            };
            let waits = self.waits_for(command, parameter.trim(), instrument).await;
            if let Some(first) = waits {
                self.put_off(first, rest, before, answered);
                return Answer::Later;
            }
            if header.ends_with('?') {
                let _ = out.write_str(if answered { ";" } else { "" });
                answered = true;
            }
            let done = self
                .carry_out(command, parameter.trim(), instrument, out)
                .await;
            let _ = self.noted(done);
        }
        if !answered {
            return Answer::None;
        }
        let _ = out.write_str("\n");
        Answer::Now
    }

    /// For a command that waits for the end of a run, which a measuring one begins: what is to be asked then.
    async fn waits_for(
        &mut self,
        command: Command,
        parameter: &str,
        instrument: &mut impl Instrument,
    ) -> Option<&'static str> {
        match command {
            Command::IsComplete => is_running(instrument).then_some("*OPC?"),
            Command::Wait => is_running(instrument).then_some(""),
            Command::Read(quantity) if parameter.is_empty() => {
                let begun = self.measurement.initiate(quantity.into(), instrument).await;
                self.noted(begun).map(|()| quantity.fetch())
            }
            Command::Measure(quantity) => {
                let set = match quantity {
                    Quantity::List => self.measurement.set_list(parameter, instrument),
                    _ => self.measurement.set(parameter, instrument),
                };
                self.noted(set)?;
                let begun = self.measurement.initiate(quantity.into(), instrument).await;
                self.noted(begun).map(|()| quantity.fetch())
            }
            _ => None,
        }
    }

    /// The result, or none with its error in the queue.
    fn noted<T>(&mut self, done: Result<T, ScpiError>) -> Option<T> {
        done.map_err(|error| self.status.push(error)).ok()
    }

    /// One line waits at a time, as IEEE 488.2 has it: a second takes its place.
    fn put_off(&mut self, first: &str, rest: &str, before: &str, answered: bool) {
        if self.waiting.is_some() {
            self.status.push(ScpiError::Interrupted);
        }
        let mut waiting = Waiting {
            rest: String::new(),
            before: String::new(),
            answered,
        };
        // A line and a question have room; of a header without, what follows is no command.
        let _ = write!(waiting.rest, "{first};{rest}");
        let _ = waiting.before.push_str(before);
        self.waiting = Some(waiting);
    }

    async fn carry_out(
        &mut self,
        command: Command,
        parameter: &str,
        instrument: &mut impl Instrument,
        out: &mut impl Answering,
    ) -> Result<(), ScpiError> {
        if !takes_number(command) && !parameter.is_empty() {
            return Err(ScpiError::ParameterNotAllowed);
        }
        match command {
            Command::Identify => inquiry::identify(instrument, out),
            Command::Reset => {
                self.measurement = Measurement::AFTER_RESET;
                stop(instrument).await?;
            }
            Command::SelfTest => inquiry::self_test(instrument, out).await?,
            Command::Version => drop(out.write_str("1999.0")),
            Command::Key => inquiry::key(instrument, out).await?,
            Command::Frequency => self.measurement.set_frequency(parameter, instrument)?,
            Command::Acceleration => self.measurement.set_acceleration(parameter, instrument)?,
            Command::FrequencyIs => put(out, self.measurement.point.frequency_hz),
            Command::AccelerationIs => put(out, self.measurement.point.acceleration_rms_ms2),
            Command::SetList => self.measurement.set_list(parameter, instrument)?,
            Command::SetListIs => self.measurement.put_list(out),
            Command::Initiate => self.measurement.initiate(What::Point, instrument).await?,
            Command::InitiateList => self.measurement.initiate(What::List, instrument).await?,
            Command::Data => inquiry::data(parameter, instrument, out).await?,
            Command::Abort => stop(instrument).await?,
            Command::Catalog => inquiry::catalog(instrument, out).await?,
            Command::Defects => inquiry::defects(instrument, out),
            Command::Lists => lists::catalog(instrument, out).await?,
            Command::ChosenList => lists::chosen(instrument, out).await?,
            Command::ChooseList => lists::choose(parameter, instrument).await?,
            Command::Fetch(quantity) | Command::Read(quantity) | Command::Measure(quantity) => {
                self.measurement.fetch(quantity, instrument, out)?;
            }
            _ => self.status_command(command, parameter, instrument, out)?,
        }
        Ok(())
    }

    /// The commands of IEEE 488.2 about status and errors.
    fn status_command(
        &mut self,
        command: Command,
        parameter: &str,
        instrument: &mut impl Instrument,
        out: &mut impl Answering,
    ) -> Result<(), ScpiError> {
        self.note_end(instrument);
        let answer = match command {
            Command::ClearStatus => {
                self.status.clear();
                self.reports_end = false;
                return Ok(());
            }
            Command::EventMask => return mask(parameter).map(|mask| self.status.event_mask = mask),
            Command::ServiceMask => {
                return mask(parameter).map(|mask| self.status.set_service_mask(mask));
            }
            Command::Complete => {
                self.reports_end = true;
                return Ok(());
            }
            Command::NextError => {
                let error = self.status.pop();
                let _ = write!(out, "{},\"{}\"", error.code(), error.text());
                return Ok(());
            }
            // The end of a run was waited for.
            Command::Wait => return Ok(()),
            Command::IsComplete => 1,
            Command::EventMaskIs => self.status.event_mask,
            Command::ServiceMaskIs => self.status.service_mask(),
            Command::Events => self.status.take_events(),
            Command::StatusByte => self.status.byte(),
            _ => self.status.count(),
        };
        let _ = write!(out, "{answer}");
        Ok(())
    }

    /// `*OPC` asked for a bit once the run is over.
    fn note_end(&mut self, instrument: &mut impl Instrument) {
        if self.reports_end && !is_running(instrument) {
            self.reports_end = false;
            self.status.operation_complete();
        }
    }
}

async fn stop(instrument: &mut impl Instrument) -> Result<(), ScpiError> {
    instrument.stop().await.map_err(|_| ScpiError::Hardware)
}

/// Of a measuring command that was not begun, what it was to measure is no parameter too many.
fn takes_number(command: Command) -> bool {
    matches!(
        command,
        Command::Frequency
            | Command::Acceleration
            | Command::SetList
            | Command::Data
            | Command::Measure(_)
            | Command::ChooseList
            | Command::EventMask
            | Command::ServiceMask
    )
}
