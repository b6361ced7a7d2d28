//! Points of a run in the quantity and unit of its sensor, while it goes on.

use calib_certificate::model::Point;
use calib_certificate::{Certificate, Polarity, SensorKind};
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
    polarity: Polarity,
    sample_rate_hz: f32,
}

impl Stating {
    /// For a sensor of this kind.
    pub fn new(kind: SensorKind, sample_rate_hz: f32) -> Self {
        Self {
            polarity: Polarity::new(kind),
            sample_rate_hz,
        }
    }

    /// With the polarity that these points of an earlier run have, if one is valid.
    pub fn following(mut self, earlier: &[StatedPoint]) -> Self {
        if let Some(own) = earlier.iter().find_map(|point| point.in_unit) {
            self.polarity = Polarity::decided(self.kind(), own.inverted);
        }
        self
    }

    /// Kind of the sensor.
    pub fn kind(&self) -> SensorKind {
        self.polarity.kind()
    }

    /// The next point of the run.
    pub fn point(&mut self, point: &PointResult) -> StatedPoint {
        let measured = PointView::new(point, self.sample_rate_hz);
        let played_hz = measured.actual_frequency_hz.filter(|_| measured.is_valid());
        self.polarity.hear(point);
        let in_unit = played_hz.map(|played_hz| {
            let own = self.polarity.split(point, played_hz);
            InUnit {
                sensitivity: self.kind().unit().of_si(own.magnitude),
                phase_deg: own.phase_deg,
                inverted: self.polarity.is_inverted(),
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

#[cfg(test)]
mod tests {
    use super::*;
    use calib_certificate::{Certificate, Document, Language, Particulars};
    use calib_record::sample::record;

    /// An accelerometer that was registered as a velocity transducer lies at a quarter turn, where a hundredth of a
    /// degree decides which side it is on: whatever comes first, and whatever a retry decided anew, the points as they
    /// come and the certificate say the same.
    #[test]
    fn a_run_and_its_certificate_fold_the_phase_alike() {
        let phases_deg = [(40.0, 0.2_f32), (160.0, -0.08), (1000.0, -0.9)];
        for kind in ["mV/(m/s2)", "mV/(mm/s)", "mV/um"] {
            for first in 0..3 {
                for told in 0..8_u8 {
                    let mut order = phases_deg;
                    order.rotate_left(first);
                    let mut record = record(&order.map(|(hz, _)| hz));
                    for (at, point) in record.points.iter_mut().enumerate() {
                        point.inverted = told >> at & 1 == 1;
                        let turned_deg = if point.inverted { 180.0 } else { 0.0 };
                        point.phase_rad = (order[at].1 - turned_deg).to_radians();
                    }
                    let kind: SensorKind = kind.parse().expect("a kind");
                    let mut particulars = Particulars::default();
                    particulars.item.unit = Some(kind);
                    let certificate = Certificate::from_record(&record, &particulars);
                    let stated = Document::new(&certificate, Language::En);
                    let stated = serde_json::to_value(&stated).expect("JSON");
                    let live = Stating::new(kind, record.head.sample_rate_hz).all(&record.points);
                    let certified = stated["points"].as_array().expect("points");
                    for point in live {
                        let hz = point.measured.set.frequency_hz;
                        let own = point.in_unit.expect("valid");
                        let same = |p: &&serde_json::Value| p["frequency_hz"] == f64::from(hz);
                        let twin = certified.iter().find(same).expect("the point");
                        let deg = twin["in_unit"]["phase_deg"].as_f64().expect("a phase");
                        let place = format!("{kind}, {first} first, {told:03b}, {hz} Hz");
                        assert!((own.phase_deg - deg).abs() < 1e-9, "{place}: {own:?} {deg}");
                        assert_eq!(stated["inverted"], own.inverted, "{place}");
                    }
                }
            }
        }
    }
}
