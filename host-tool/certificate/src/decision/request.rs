//! Specification and rule as a file asks for them, not yet checked.

use super::limits::Band;
use crate::kind::SensitivityUnit::{MillivoltPerG, MillivoltPerMs2};
use crate::kind::{SensorKind, Specified};
use serde::{Deserialize, Deserializer};

/// The `[decision]` part of a TOML file.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Request {
    /// `api670`, `nominal`, `relative`; or a name of one's own with bands.
    pub specification: String,
    /// Nominal sensitivity with its unit, such as `4 mV/(mm/s)`.
    #[serde(deserialize_with = "specified")]
    pub nominal: Option<Specified>,
    /// Nominal sensitivity, mV/g.
    pub nominal_mv_per_g: Option<f64>,
    /// Nominal sensitivity, mV/(m/s2).
    pub nominal_mv_per_ms2: Option<f64>,
    /// Tolerance of `nominal` and `relative`, plus or minus %.
    pub tolerance_percent: Option<f64>,
    /// Bands of one's own specification.
    #[serde(rename = "band")]
    pub bands: Vec<Band>,
    /// How results are judged.
    pub rule: RuleName,
    /// Largest probability of false acceptance, %, for `max_false_accept`.
    pub max_false_accept_percent: Option<f64>,
    /// Sensitivities of the last calibration, Hz and the SI unit of the sensor's kind; from the logbook.
    #[serde(skip)]
    pub last: Vec<(f64, f64)>,
}

/// Names of the decision rules.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum RuleName {
    /// Accept inside the tolerance.
    Simple,
    /// Accept inside the tolerance less U.
    #[default]
    GuardBand,
    /// Accept while the probability of false acceptance is small enough.
    MaxFalseAccept,
}

impl Request {
    /// True when nothing is specified: a laboratory may state its rule alone, and the
    /// tolerance is the sensor's.
    pub fn is_open(&self) -> bool {
        self.specification.is_empty() && self.bands.is_empty()
    }

    /// Takes a nominal sensitivity if none is stated. API 670 states one itself.
    pub fn know_nominal(&mut self, nominal: Specified) {
        if self.stated_nominal().is_none() && self.specification != API_670 {
            self.nominal = Some(nominal);
        }
    }

    /// Nominal sensitivity, if it is stated.
    pub(crate) fn stated_nominal(&self) -> Option<Specified> {
        let of = |unit, stated: Option<f64>| Some(Specified::new(stated?, unit));
        self.nominal
            .or(of(MillivoltPerMs2, self.nominal_mv_per_ms2))
            .or(of(MillivoltPerG, self.nominal_mv_per_g))
    }

    /// Whether sensors of this kind can be judged by it.
    ///
    /// # Errors
    /// A sentence that names what does not fit.
    pub(crate) fn fits(&self, kind: SensorKind) -> Result<(), String> {
        if kind.is_reported_only() && !self.is_open() {
            return Err(format!(
                "decision: a transmitter in {} is reported only: it has no tolerance",
                kind.unit().name()
            ));
        }
        if self.specification == API_670 && !kind.is_as_measured() {
            return Err("decision: API 670 is for accelerometers of 100 mV/g".to_owned());
        }
        let nominal = self.stated_nominal();
        nominal.map_or(Ok(()), |nominal| kind.shown_in(nominal.unit).map(drop))
    }
}

/// Name of the preset.
pub(super) const API_670: &str = "api670";

fn specified<'de, D: Deserializer<'de>>(stated: D) -> Result<Option<Specified>, D::Error> {
    let text = Option::<String>::deserialize(stated)?;
    let parsed = text.map(|text| text.parse().map_err(serde::de::Error::custom));
    parsed.transpose()
}
