//! Points of a run in the quantity and unit of its sensor, while it goes on.

use calib_certificate::SensorKind;
use calib_core::point::PointResult;
use calib_output::PointView;
use schemars::JsonSchema;
use serde::Serialize;

/// A measured point, with its result in the unit of the sensor.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct StatedPoint {
    /// As the instrument measured it.
    #[serde(flatten)]
    pub measured: PointView,
    /// The sensor's; none where it was refused.
    pub in_unit: Option<InUnit>,
}

/// A result in the quantity of the sensor.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct InUnit {
    /// Magnitude, in the unit of the run.
    pub sensitivity: f64,
    /// Phase against the motion of the kind, degrees; polarity is apart.
    pub phase_deg: f64,
    /// The sensor is inverted, by the first point that is valid.
    pub inverted: bool,
}

/// States points of one run in the order they come.
#[derive(Clone, Copy, Debug)]
pub struct Stating {
    kind: SensorKind,
    sample_rate_hz: f32,
    /// By the first point that is valid.
    inverted: Option<bool>,
}

impl Stating {
    /// For a sensor of this kind.
    pub fn new(kind: SensorKind, sample_rate_hz: f32) -> Self {
        Self {
            kind,
            sample_rate_hz,
            inverted: None,
        }
    }

    /// Kind of the sensor.
    pub fn kind(&self) -> SensorKind {
        self.kind
    }

    /// The next point of the run.
    pub fn point(&mut self, point: &PointResult) -> StatedPoint {
        let measured = PointView::new(point, self.sample_rate_hz);
        let played_hz = measured.actual_frequency_hz.filter(|_| measured.is_valid());
        let in_unit = played_hz.map(|played_hz| {
            let told = || self.kind.is_inverted(point, played_hz);
            let inverted = *self.inverted.get_or_insert_with(told);
            let own = self.kind.of_result(point, played_hz, inverted);
            InUnit {
                sensitivity: self.kind.unit().of_si(own.magnitude),
                phase_deg: own.phase_deg,
                inverted,
            }
        });
        StatedPoint { measured, in_unit }
    }

    /// All points of a run.
    pub fn all(mut self, points: &[PointResult]) -> Vec<StatedPoint> {
        points.iter().map(|point| self.point(point)).collect()
    }
}
