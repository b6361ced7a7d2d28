//! The point a controller measures: what it may be, how it begins, what came of it.

use super::errors::ScpiError;
use super::header::Quantity;
use super::number::{NOT_A_NUMBER, number, put};
use crate::command::{self, Instrument};
use calib_core::point::{ExcitationKind, PointResult, PointSpec};
use calib_core::tone::Tone;
use calib_core::verdict::Verdict;
use calib_protocol::message::{Refusal, Request, Response, RunSpec};
use calib_protocol::record::RunLabels;
use core::f32::consts::SQRT_2;
use core::fmt::Write;

/// True while a run is going on.
pub(super) fn is_running(instrument: &mut impl Instrument) -> bool {
    instrument.status().state.is_running()
}

/// The point that was configured, and whether it was measured.
pub(super) struct Measurement {
    pub(super) point: PointSpec,
    /// A run was begun here, and nothing configured since.
    initiated: bool,
}

impl Measurement {
    /// After `*RST`: the reference point of ISO 16063-21, 5.3.
    pub(super) const AFTER_RESET: Self = Self {
        point: PointSpec {
            frequency_hz: 160.0,
            acceleration_rms_ms2: 10.0,
        },
        initiated: false,
    };

    /// Takes a frequency that this instrument can generate.
    pub(super) fn set_frequency(
        &mut self,
        text: &str,
        instrument: &mut impl Instrument,
    ) -> Result<(), ScpiError> {
        let frequency_hz = number(text, &[("HZ", 1.0), ("KHZ", 1e3)])?;
        let tone = Tone::nearest(frequency_hz, instrument.info().sample_rate_hz);
        tone.ok_or(ScpiError::DataOutOfRange)?;
        self.point.frequency_hz = frequency_hz;
        self.initiated = false;
        Ok(())
    }

    /// Takes a level within the limit of the table. Whether velocity and displacement allow it at the
    /// frequency is the verdict's to say.
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
        self.initiated = false;
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
        self.initiated = false;
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
        instrument: &mut impl Instrument,
    ) -> Result<(), ScpiError> {
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

    /// Writes a quantity of the result, or what stands for it where there is none.
    pub(super) fn fetch(
        &self,
        quantity: Quantity,
        instrument: &mut impl Instrument,
        out: &mut impl Write,
    ) -> Result<(), ScpiError> {
        let result = self.result(instrument);
        if quantity == Quantity::Verdict {
            put_verdict(out, result);
            return result.map(drop);
        }
        let valid = result.and_then(|result| match result.verdict {
            Verdict::Pass => Ok(result),
            Verdict::Refused(_) => Err(ScpiError::PointRefused),
        });
        let mut put_one = |value: fn(&PointResult) -> f32| {
            put(out, valid.as_ref().map_or(NOT_A_NUMBER, value));
        };
        match quantity {
            Quantity::Phase => put_one(phase_deg),
            Quantity::Uncertainty => put_one(expanded_uncertainty),
            _ => put_one(|result| result.sensitivity_v_per_ms2),
        }
        if quantity == Quantity::All {
            for value in [phase_deg, expanded_uncertainty] {
                let _ = out.write_str(",");
                put(out, valid.as_ref().map_or(NOT_A_NUMBER, value));
            }
            let _ = out.write_str(",");
            put_verdict(out, result);
        }
        valid.map(drop)
    }
}

fn phase_deg(result: &PointResult) -> f32 {
    result.phase_rad.to_degrees()
}

/// Of the sensitivity, V/(m/s2).
fn expanded_uncertainty(result: &PointResult) -> f32 {
    result.expanded_uncertainty_rel * result.sensitivity_v_per_ms2
}

fn put_verdict(out: &mut impl Write, result: Result<PointResult, ScpiError>) {
    let _ = match result.map(|result| result.verdict) {
        Ok(Verdict::Pass) => out.write_str("VALID"),
        Ok(Verdict::Refused(reason)) => write!(out, "REFUSED,{reason:?}"),
        Err(_) => out.write_str("NONE"),
    };
}
