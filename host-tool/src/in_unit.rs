//! Points of a run in the quantity and unit of its sensor, while it goes on.

use calib_certificate::model::Point;
use calib_certificate::{Certificate, SensorKind};
use calib_core::point::PointResult;
use calib_output::PointView;
use schemars::JsonSchema;
use serde::Serialize;

/// A measured point, with its result in the unit of the sensor.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct StatedPoint {
    /// As the instrument measured it. Its U leaves out temperature and mount, which a certificate has.
    #[serde(flatten)]
    pub measured: PointView,
    /// The sensor's; none where it was refused.
    pub in_unit: Option<InUnit>,
    /// U as a certificate of the record states it; none while the run goes on, where the point was refused, and without a
    /// record.
    pub certified: Option<Certified>,
}

/// Uncertainty of a point on a certificate: with temperature, mount and kind of the sensor.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Certified {
    /// Relative expanded uncertainty of the magnitude.
    pub expanded_uncertainty_rel: f64,
    /// Its coverage factor.
    pub coverage_factor: f64,
    /// Expanded uncertainty of the phase, degrees.
    pub expanded_uncertainty_phase_deg: f64,
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
        StatedPoint {
            measured,
            in_unit,
            certified: None,
        }
    }

    /// All points of a run that ended, with U of its certificate.
    pub fn certified(self, points: &[PointResult], certificate: &Certificate) -> Vec<StatedPoint> {
        let stated = self.all(points).into_iter().zip(points);
        let with_u = |(mut stated, point): (StatedPoint, &PointResult)| {
            stated.certified = of_certificate(point, certificate);
            stated
        };
        stated.map(with_u).collect()
    }

    /// All points of a run.
    pub fn all(mut self, points: &[PointResult]) -> Vec<StatedPoint> {
        points.iter().map(|point| self.point(point)).collect()
    }
}

/// U of a point on a certificate. Of several of one frequency and level it is that of the same result.
pub fn of_certificate(point: &PointResult, certificate: &Certificate) -> Option<Certified> {
    let same = certificate
        .points
        .iter()
        .filter(|p| p.measured.spec == point.spec);
    let apart = |p: &&Point| (p.measured.sensitivity_v_per_ms2 - point.sensitivity_v_per_ms2).abs();
    let found = same
        .min_by(|a, b| apart(a).total_cmp(&apart(b)))?
        .values()?;
    Some(Certified {
        expanded_uncertainty_rel: found.expanded_uncertainty_percent / 100.0,
        coverage_factor: found.coverage_factor,
        expanded_uncertainty_phase_deg: found.expanded_uncertainty_phase_deg,
    })
}
