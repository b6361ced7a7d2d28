//! The point a controller measures: what it may be, how it begins, what came of it.

use super::errors::ScpiError;
use super::header::Quantity;
use super::number::{NOT_A_NUMBER, number, put};
use crate::command::{self, Instrument};
use calib_core::point::{ExcitationKind, PointResult, PointSpec};
use calib_core::point_state::PointState;
use calib_core::tone::Tone;
use calib_protocol::message::{Request, Response, RunSpec};
use calib_protocol::record::RunLabels;
use core::f32::consts::SQRT_2;
use core::fmt::Write;
use heapless::Vec;

/// True while a run is going on.
pub(super) fn is_running(instrument: &mut impl Instrument) -> bool {
    instrument.status().state.is_running()
}

/// Object of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum What {
    /// The configured point.
    Point,
    /// The configured list.
    List,
}

impl From<Quantity> for What {
    fn from(quantity: Quantity) -> Self {
        match quantity {
            Quantity::List => Self::List,
            _ => Self::Point,
        }
    }
}

/// Frequencies of a list: as many as a line holds.
const MAX_LIST: usize = 32;

/// The point and the list that were configured, and which of them was measured.
pub(super) struct Measurement {
    pub(super) point: PointSpec,
    /// Frequencies, Hz, at the level of the point.
    list: Vec<f32, MAX_LIST>,
    /// A run of this was begun here, and nothing configured since.
    initiated: Option<What>,
}

impl Measurement {
    /// After `*RST`: the reference point of ISO 16063-21, 5.3.
    pub(super) const AFTER_RESET: Self = Self {
        point: PointSpec {
            frequency_hz: 160.0,
            acceleration_rms_ms2: 10.0,
        },
        list: Vec::new(),
        initiated: None,
    };

    /// Takes a frequency that this instrument can generate.
    pub(super) fn set_frequency(
        &mut self,
        text: &str,
        instrument: &mut impl Instrument,
    ) -> Result<(), ScpiError> {
        self.point.frequency_hz = frequency(text, instrument)?;
        self.initiated = None;
        Ok(())
    }

    /// Takes frequencies of a list, or keeps the one there is where none is stated.
    pub(super) fn set_list(
        &mut self,
        text: &str,
        instrument: &mut impl Instrument,
    ) -> Result<(), ScpiError> {
        self.initiated = None;
        if text.is_empty() {
            return match self.list.is_empty() {
                false => Ok(()),
                true => Err(ScpiError::MissingParameter),
            };
        }
        let mut list = Vec::new();
        for stated in text.split(',').map(str::trim) {
            let frequency_hz = frequency(stated, instrument)?;
            list.push(frequency_hz)
                .map_err(|_| ScpiError::TooMuchData)?;
        }
        self.list = list;
        Ok(())
    }

    /// Writes the frequencies of the list; nothing where there is none.
    pub(super) fn put_list(&self, out: &mut impl Write) {
        for (index, frequency_hz) in self.list.iter().enumerate() {
            let _ = out.write_str(if index == 0 { "" } else { "," });
            put(out, *frequency_hz);
        }
    }

    /// Points of what is to be measured.
    fn points(&self, what: What) -> impl Iterator<Item = PointSpec> {
        let own = core::slice::from_ref(&self.point.frequency_hz);
        let frequencies = match what {
            What::Point => own,
            What::List => &self.list[..],
        };
        let acceleration_rms_ms2 = self.point.acceleration_rms_ms2;
        frequencies.iter().map(move |&frequency_hz| PointSpec {
            frequency_hz,
            acceleration_rms_ms2,
        })
    }

    /// Takes a level within the limit of the table. Whether velocity and displacement allow it at the
    /// frequency is looked at when the run begins.
    pub(super) fn set_acceleration(
        &mut self,
        text: &str,
        instrument: &mut impl Instrument,
    ) -> Result<(), ScpiError> {
        let rms_ms2 = number(text, &[("M/S2", 1.0)])?;
        if rms_ms2 * SQRT_2 > instrument.settings().limits.acceleration_peak_ms2 {
            return Err(ScpiError::DataOutOfRange);
        }
        self.point.acceleration_rms_ms2 = rms_ms2;
        self.initiated = None;
        Ok(())
    }

    /// Takes `frequency,acceleration`, or none of both; what is left out stays.
    pub(super) fn set(
        &mut self,
        text: &str,
        instrument: &mut impl Instrument,
    ) -> Result<(), ScpiError> {
        let before = self.point;
        let set = self.set_each(text, instrument);
        self.initiated = None;
        if set.is_err() {
            self.point = before;
        }
        set
    }

    fn set_each(&mut self, text: &str, instrument: &mut impl Instrument) -> Result<(), ScpiError> {
        let mut parameters = text.split(',').map(str::trim);
        let (frequency, level) = (parameters.next(), parameters.next());
        if parameters.next().is_some() {
            return Err(ScpiError::ParameterNotAllowed);
        }
        if let Some(frequency) = frequency.filter(|text| !text.is_empty()) {
            self.set_frequency(frequency, instrument)?;
        }
        match level.filter(|text| !text.is_empty()) {
            Some(level) => self.set_acceleration(level, instrument),
            None => Ok(()),
        }
    }

    pub(super) async fn initiate(
        &mut self,
        what: What,
        instrument: &mut impl Instrument,
    ) -> Result<(), ScpiError> {
        if is_running(instrument) {
            return Err(ScpiError::InitIgnored);
        }
        let spec = RunSpec {
            points: self.points(what).collect(),
            excitation: ExcitationKind::SingleSine,
            labels: RunLabels::default(),
        };
        // The same road a frame takes, with the same rule who may start.
        let response = command::answer(Request::Start(spec), instrument).await;
        let begun = matches!(response, Response::Started { .. });
        self.initiated = begun.then_some(what);
        match response {
            Response::Refused(refusal) => Err(refusal.into()),
            _ => Ok(()),
        }
    }

    /// The result of a point of the run that was initiated here, once it is over.
    fn result(
        &self,
        what: What,
        index: u16,
        spec: PointSpec,
        instrument: &mut impl Instrument,
    ) -> Result<PointResult, ScpiError> {
        let over = self.initiated == Some(what) && !is_running(instrument);
        let result = if over { instrument.point(index) } else { None };
        // Another host may have run a list of its own since.
        result
            .filter(|result| result.spec == spec)
            .ok_or(ScpiError::DataStale)
    }

    /// Writes frequency, sensitivity, phase, uncertainty and state of every point of the list.
    fn fetch_list(
        &self,
        instrument: &mut impl Instrument,
        out: &mut impl Write,
    ) -> Result<(), ScpiError> {
        let mut worst = Ok(());
        if self.list.is_empty() {
            return Err(ScpiError::DataStale);
        }
        for (index, spec) in self.points(What::List).enumerate() {
            let _ = out.write_str(if index == 0 { "" } else { "," });
            put(out, spec.frequency_hz);
            // A list has 32 points at most.
            let result = self.result(What::List, index as u16, spec, instrument);
            let valid = valid(result);
            for value in VALUES {
                let _ = out.write_str(",");
                put(out, valid.as_ref().map_or(NOT_A_NUMBER, value));
            }
            let _ = match result.map(|result| result.state) {
                Ok(PointState::Valid) => out.write_str(",VALID"),
                Ok(PointState::Refused(reason)) => write!(out, ",{reason:?}"),
                Err(_) => out.write_str(",NONE"),
            };
            worst = worst.and(valid.map(drop));
        }
        worst
    }

    /// Writes a quantity of the result, or what stands for it where there is none.
    pub(super) fn fetch(
        &self,
        quantity: Quantity,
        instrument: &mut impl Instrument,
        out: &mut impl Write,
    ) -> Result<(), ScpiError> {
        if quantity == Quantity::List {
            return self.fetch_list(instrument, out);
        }
        let result = self.result(What::Point, 0, self.point, instrument);
        if quantity == Quantity::State {
            put_state(out, result);
            return result.map(drop);
        }
        let valid = valid(result);
        let mut put_one = |value: fn(&PointResult) -> f32| {
            put(out, valid.as_ref().map_or(NOT_A_NUMBER, value));
        };
        match quantity {
            Quantity::Phase => put_one(phase_deg),
            Quantity::Uncertainty => put_one(expanded_uncertainty),
            _ => put_one(sensitivity),
        }
        if quantity == Quantity::All {
            for value in [phase_deg, expanded_uncertainty] {
                let _ = out.write_str(",");
                put(out, valid.as_ref().map_or(NOT_A_NUMBER, value));
            }
            let _ = out.write_str(",");
            put_state(out, result);
        }
        valid.map(drop)
    }
}

/// Numbers of a point, in the order they are told.
const VALUES: [fn(&PointResult) -> f32; 3] = [sensitivity, phase_deg, expanded_uncertainty];

/// A frequency that this instrument can generate.
fn frequency(text: &str, instrument: &mut impl Instrument) -> Result<f32, ScpiError> {
    let frequency_hz = number(text, &[("HZ", 1.0), ("KHZ", 1e3)])?;
    let tone = Tone::nearest(frequency_hz, instrument.info().sample_rate_hz);
    tone.map(|_| frequency_hz).ok_or(ScpiError::DataOutOfRange)
}

/// A result that may be used.
fn valid(result: Result<PointResult, ScpiError>) -> Result<PointResult, ScpiError> {
    result.and_then(|result| match result.state {
        PointState::Valid => Ok(result),
        PointState::Refused(_) => Err(ScpiError::PointRefused),
    })
}

fn sensitivity(result: &PointResult) -> f32 {
    result.sensitivity_v_per_ms2
}

fn phase_deg(result: &PointResult) -> f32 {
    result.phase_rad.to_degrees()
}

/// Of the sensitivity, V/(m/s2).
fn expanded_uncertainty(result: &PointResult) -> f32 {
    result.expanded_uncertainty_rel * result.sensitivity_v_per_ms2
}

fn put_state(out: &mut impl Write, result: Result<PointResult, ScpiError>) {
    let _ = match result.map(|result| result.state) {
        Ok(PointState::Valid) => out.write_str("VALID"),
        Ok(PointState::Refused(reason)) => write!(out, "REFUSED,{reason:?}"),
        Err(_) => out.write_str("NONE"),
    };
}
