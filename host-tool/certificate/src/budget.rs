//! The budgets of a record's points, recomputed from its settings.
//!
//! The instrument stored U; the certificate prints where it comes from. Both
//! are the same function of calib-core on the same numbers, so they agree to the
//! digits a record keeps; a record whose settings do not give its U is not trusted.
//! A temperature that is told, or not, changes U in the same proportion as it does
//! that of the recomputed budget.

use super::deviation::{
    OF_CONDITIONER, OF_FREQUENCY, OfRatio, of_ratio, within_a_response, within_a_substitution,
    within_an_instrument,
};
use super::harmonics;
use super::kind::SensorKind;
use super::model::{Budget, BudgetRow, Certificate, Remark, Severity, Value};
use super::mountings::Mountings;
use super::particulars::Particulars;
use super::resonance::Mounted;
use super::temperature::Distance;
use calib_core::budget::{Budget as CoreBudget, Component, PointBudget, Row, point_budget};
use calib_core::point::PointResult;
use calib_core::point_state::PointState;
use calib_core::settings::{Distribution, Settings};
use calib_output::number::decimal;
use calib_protocol::record::Record;

/// Row of Table A.1 for the distortion.
const DISTORTION: u8 = 4;
/// Row of Table A.1 for the gain of the conditioner.
const GAIN: u8 = 2;
/// Row of Table A.1 for the frequency.
const FREQUENCY: u8 = 12;
/// Half width of the frequency, relative: the clock's, 50 ppm (docs/hardware.md), and as much again.
const FREQUENCY_REL: f32 = 1.0e-4;
/// Row of Table A.1 for the mounting.
const MOUNTING: u8 = 8;
/// That for what is left: repeatability.
const RESIDUAL: u8 = 18;
/// Standard uncertainties are entered with this one.
const STANDARD: Distribution = Distribution::Normal {
    coverage_factor: 1.0,
};
/// A record keeps U to 1.6e-5 (upper 24 bits of the f32); sums of squares of
/// host and target differ in the last bits of f32 (6e-8, at most 22 terms).
const STORED_U_REL: f64 = 2.0e-5;
/// A record keeps the repeatability to half a unit of the upper 16 bits.
const STORED_REPEATABILITY_REL: f64 = 1.0 / 512.0;

/// Largest relative difference between stored and recomputed U: that of U, and
/// that of the repeatability by its share of the variance; twice, because the
/// coverage factor follows the degrees of freedom.
fn agreement_rel(budget: &CoreBudget<'_>) -> f64 {
    let square = |component: &Component<'_>| f64::from(component.contribution()).powi(2);
    let of = |repeated: bool| -> f64 {
        let wanted = |c: &&Component<'_>| !repeated || c.degrees_of_freedom.is_finite();
        budget.components().iter().filter(wanted).map(square).sum()
    };
    let share = if of(false) > 0.0 {
        of(true) / of(false)
    } else {
        0.0
    };
    STORED_U_REL + 2.0 * share * STORED_REPEATABILITY_REL
}

/// The magnitude's budget at a point after a substitution, with the standard's part; why there is none.
pub(super) type LeftOf<'a> =
    Box<dyn Fn(&CoreBudget<'_>, &PointResult) -> Result<CoreBudget<'static>, String> + 'a>;

/// Basis of the uncertainties of a certificate.
pub(super) struct Basis<'a> {
    record: &'a Record,
    /// Settings that cover the temperature, too.
    settings: Settings,
    /// How far the temperature was from that of the settings.
    pub(super) distance: Distance,
    /// Correlation of the reference's calibration between two frequencies.
    correlation: f64,
    mountings: &'a Mountings,
    /// Mounted resonance as the points show it.
    pub(super) mounted: Mounted,
    /// Of a substitution: what is left of a budget.
    left_of: Option<LeftOf<'a>>,
    /// Kind of the sensor: gain or burden, and the frequency, enter what is stated of it.
    pub(super) kind: SensorKind,
}

/// Expanded uncertainties of a point.
pub(super) struct Uncertainty {
    /// Of the magnitude, relative.
    pub(super) expanded_rel: f64,
    pub(super) coverage_factor: f64,
    /// Possibly infinite.
    pub(super) effective_degrees_of_freedom: f64,
    /// Of the phase, rad.
    pub(super) expanded_phase_rad: f64,
    /// Coverage factor of the phase, where its budget gives the stated U: the
    /// record stores that of the magnitude only.
    pub(super) coverage_factor_phase: Option<f64>,
}

impl<'a> Basis<'a> {
    pub(super) fn new(
        record: &'a Record,
        particulars: &Particulars,
        mountings: &'a Mountings,
    ) -> Self {
        let distance = Distance::of(record, particulars);
        let correlation = particulars.calibration.reference_correlation;
        let mut basis = Self {
            record,
            settings: distance.covered_by(&record.settings),
            distance,
            correlation: correlation.unwrap_or(1.0),
            mountings,
            mounted: Mounted::UNKNOWN,
            left_of: None,
            kind: particulars.kind(),
        };
        // The resonance is that of this mounting: what another would do is no part of its U.
        basis.shift_mounting(0.0);
        basis.mounted = Mounted::of(record, particulars, |point, reference| {
            basis.of_ratio(point, reference).map(|of| of.expanded_rel)
        });
        basis.shift_mounting(basis.mounted.mounting_at_10_khz_rel(&record.settings));
        basis
    }

    /// The basis of a result by substitution.
    pub(super) fn by_substitution(mut self, left_of: LeftOf<'a>) -> Self {
        self.left_of = Some(left_of);
        self
    }

    /// Uncertainty of a point; none where it has none, or no budget can say how the temperature counts.
    pub(super) fn uncertainty(&self, point: &PointResult) -> Option<Uncertainty> {
        let stored = self.stored(point);
        let stated = [
            stored.expanded_rel,
            stored.coverage_factor,
            stored.expanded_phase_rad,
        ];
        if !stated.into_iter().all(f64::is_finite) {
            return None;
        }
        if self.is_the_instruments() {
            return Some(stored);
        }
        let own = of_point(self.record, &self.record.settings, point).ok()?;
        let (before, before_phase) = own.expand().ok()?;
        let (now, now_phase) = self.certified(point).ok()?.expand().ok()?;
        let times = |now: f32, before: f32| match before > 0.0 {
            true => f64::from(now) / f64::from(before),
            false => 1.0,
        };
        let expanded_rel = match self.left_of {
            // What is left of two records is no multiple of what one of them stored.
            Some(_) => f64::from(now.expanded_uncertainty),
            None => {
                let change = times(now.expanded_uncertainty, before.expanded_uncertainty);
                stored.expanded_rel * change
            }
        };
        Some(Uncertainty {
            expanded_rel,
            coverage_factor: decimal(now.coverage.factor),
            effective_degrees_of_freedom: decimal(now.effective_degrees_of_freedom),
            expanded_phase_rad: stored.expanded_phase_rad
                * times(
                    now_phase.expanded_uncertainty,
                    before_phase.expanded_uncertainty,
                ),
            coverage_factor_phase: stored
                .coverage_factor_phase
                .map(|_| f64::from(now_phase.coverage.factor)),
        })
    }

    /// True when nothing is known beyond what the instrument knew.
    pub(super) fn is_the_instruments(&self) -> bool {
        let of_change = |point: &PointResult| self.record.closing.half_widths(point);
        let changed = self.record.points.iter().any(|p| of_change(p) != [0.0; 2]);
        let bounded = |p: &PointResult| self.excess_rel(p) > 0.0 || self.bent_rel(p) > 0.0;
        let gives_way = self.record.points.iter().any(bounded);
        let as_set = self.settings == self.record.settings && !self.mountings.are_repeated();
        as_set && self.left_of.is_none() && !changed && !gives_way && self.kind.is_as_measured()
    }

    fn shift_mounting(&mut self, at_10_khz_rel: f32) {
        self.settings.point_influences.mounting_at_10_khz_rel = at_10_khz_rel;
    }

    /// By how much the mount may have raised a point, relative.
    fn excess_rel(&self, point: &PointResult) -> f32 {
        let frequency_hz = point.tone.frequency_hz(self.record.head.sample_rate_hz);
        self.mounted.excess_rel(f64::from(frequency_hz)) as f32
    }

    /// By how much a channel that bends may have changed a point, relative.
    fn bent_rel(&self, point: &PointResult) -> f32 {
        let rate_hz = self.record.head.sample_rate_hz;
        let resonance_s2 = self.mounted.cautious_s2();
        harmonics::half_width_rel(point, rate_hz, resonance_s2, self.kind.steps()) as f32
    }

    /// Budget with everything that is known.
    fn certified(&self, point: &PointResult) -> Result<PointBudget<'static>, String> {
        let mut budget = of_point(self.record, &self.settings, point)?;
        let [change_rel, change_rad] = self.record.closing.half_widths(point);
        for (budget, row, half_width) in [
            (&mut budget.magnitude, Row::a1(RESIDUAL), change_rel),
            (&mut budget.phase, Row::a2_from_a1(RESIDUAL), change_rad),
        ] {
            if half_width > 0.0 {
                let component = Component::new(row, half_width, Distribution::UShaped);
                let added =
                    budget.add(component.labelled("change until the first point was repeated"));
                added.map_err(|error| error.to_string())?;
            }
        }
        // All of it, or nothing: the mount's, or the data sheet is wrong; the channel's, or the device's own.
        for (row, half_width_rel, label) in [
            (
                MOUNTING,
                self.excess_rel(point),
                "mounted resonance below that of the data sheet",
            ),
            (
                DISTORTION,
                self.bent_rel(point),
                "harmonics of one channel alone",
            ),
        ] {
            if half_width_rel > 0.0 {
                let component = Component::new(Row::a1(row), half_width_rel, Distribution::UShaped);
                let added = budget.magnitude.add(component.labelled(label));
                added.map_err(|error| error.to_string())?;
            }
        }
        if let Some(scatter) = self.mountings.of(&point.spec) {
            let degrees = scatter.degrees_of_freedom as f32;
            let phase_rad = scatter.standard_uncertainty_phase_deg.to_radians();
            for (budget, row, value) in [
                (
                    &mut budget.magnitude,
                    Row::a1(MOUNTING),
                    scatter.standard_uncertainty_rel,
                ),
                (&mut budget.phase, Row::a2_from_a1(MOUNTING), phase_rad),
            ] {
                let component = Component::new(row, value as f32, STANDARD);
                let component = component.labelled("scatter between mountings");
                let added = budget.add(component.with_degrees_of_freedom(degrees));
                added.map_err(|error| error.to_string())?;
            }
        }
        if let Some(left_of) = &self.left_of {
            budget.magnitude = left_of(&budget.magnitude, point)?;
        }
        for component in self.of_kind() {
            let added = budget.magnitude.add(component);
            added.map_err(|error| error.to_string())?;
        }
        Ok(budget)
    }

    /// Components by which the chain's sensitivity to acceleration becomes the sensor's: gain or burden, and the
    /// frequency, as often as it enters.
    fn of_kind(&self) -> impl Iterator<Item = Component<'static>> {
        let gain = self.kind.expanded_rel_of_gain().map(|expanded_rel| {
            let half = Distribution::Normal {
                coverage_factor: 2.0,
            };
            Component::new(Row::a1(GAIN), expanded_rel as f32, half).labelled(OF_CONDITIONER)
        });
        let steps = self.kind.steps() as f32;
        let frequency = (steps > 0.0).then(|| {
            let half_width_rel = steps * FREQUENCY_REL;
            let row = Row::a1(FREQUENCY);
            Component::new(row, half_width_rel, Distribution::Rectangular).labelled(OF_FREQUENCY)
        });
        gain.into_iter().chain(frequency)
    }

    /// Uncertainty the instrument stated.
    fn stored(&self, point: &PointResult) -> Uncertainty {
        Uncertainty {
            expanded_rel: f64::from(point.expanded_uncertainty_rel),
            coverage_factor: decimal(point.coverage_factor),
            effective_degrees_of_freedom: decimal(point.effective_degrees_of_freedom),
            expanded_phase_rad: f64::from(point.expanded_uncertainty_phase_rad),
            coverage_factor_phase: self.coverage_factor_phase(point),
        }
    }

    fn coverage_factor_phase(&self, point: &PointResult) -> Option<f64> {
        let budget = of_point(self.record, &self.record.settings, point).ok()?;
        let (_, phase) = budget.expand().ok()?;
        let ratio = f64::from(phase.expanded_uncertainty / point.expanded_uncertainty_phase_rad);
        let agrees = (ratio - 1.0).abs() <= agreement_rel(&budget.phase);
        agrees.then(|| f64::from(phase.coverage.factor))
    }

    /// Uncertainty of the ratio of a point's magnitude to that of the reference point.
    pub(super) fn of_ratio(&self, point: &PointResult, reference: &PointResult) -> Option<OfRatio> {
        let correlation = within_a_response(self.correlation);
        of_ratio(
            &self.magnitude(point)?,
            &self.magnitude(reference)?,
            &correlation,
        )
    }

    /// Uncertainty of the ratio of a point's magnitude to that of a point of another calibration.
    pub(super) fn of_change(
        &self,
        point: &PointResult,
        before: &Self,
        point_before: &PointResult,
    ) -> Option<OfRatio> {
        let (now, then) = (self.magnitude(point)?, before.magnitude(point_before)?);
        match self.is_of_the_instrument(before) {
            true => of_ratio(&now, &then, &within_an_instrument),
            false => of_ratio(&now, &then, &|_| 0.0),
        }
    }

    /// Uncertainty of the ratio of two devices' magnitudes, measured one after the other.
    pub(super) fn of_substitution(
        &self,
        point: &PointResult,
        before: &Self,
        point_before: &PointResult,
    ) -> Option<OfRatio> {
        let (now, then) = (self.magnitude(point)?, before.magnitude(point_before)?);
        of_ratio(&now, &then, &within_a_substitution)
    }

    /// One instrument, and one calibration of its reference, that is known by name.
    fn is_of_the_instrument(&self, other: &Self) -> bool {
        let of = |basis: &Self| {
            let reference = &basis.record.settings.reference;
            let words = [
                basis.record.head.instrument_serial.as_str(),
                reference.serial.as_str(),
                reference.certificate.as_str(),
            ];
            words.map(|word| word.trim().to_owned())
        };
        let (own, other) = (of(self), of(other));
        own == other && own.iter().all(|word| !word.is_empty())
    }

    pub(super) fn magnitude(&self, point: &PointResult) -> Option<CoreBudget<'static>> {
        Some(self.certified(point).ok()?.magnitude)
    }
}

/// Says why no point has a budget, where that is why there is no result.
pub(super) fn say_why_none(certificate: &mut Certificate, basis: &Basis<'_>) {
    let valid = |point: &&PointResult| point.state == PointState::Valid;
    let mut points = basis.record.points.iter().filter(valid);
    let problem = points.find_map(|point| basis.certified(point).err());
    certificate.remarks.extend(problem.map(|problem| Remark {
        severity: Severity::Error,
        key: "budget_failed",
        values: vec![Value::Text(problem)],
    }));
}

/// Recomputes the budget of `point` and compares it with the stored U.
pub(super) fn attach(certificate: &mut Certificate, basis: &Basis<'_>, point: &PointResult) {
    let mut error = |key, values| {
        let severity = Severity::Error;
        certificate.remarks.push(Remark {
            severity,
            key,
            values,
        });
    };
    let own = of_point(basis.record, &basis.record.settings, point);
    let budgets = own
        .and_then(|own| reported(&own))
        .and_then(|own| Ok((own, reported(&basis.certified(point)?)?.0)));
    match budgets {
        Err(problem) => error("budget_failed", vec![Value::Text(problem)]),
        Ok(((own, agreement_rel), budget)) => {
            let stored = 100.0 * f64::from(point.expanded_uncertainty_rel);
            if (own.expanded_percent / stored - 1.0).abs() > agreement_rel {
                let number = |percent| Value::Number(percent, 4, "");
                error(
                    "budget_mismatch",
                    vec![number(own.expanded_percent), number(stored)],
                );
            }
            certificate.budget = Some(budget);
        }
    }
}

fn of_point(
    record: &Record,
    settings: &Settings,
    point: &PointResult,
) -> Result<PointBudget<'static>, String> {
    let frequency_hz = point.tone.frequency_hz(record.head.sample_rate_hz);
    let reference = settings.reference.at(frequency_hz);
    let reference = reference
        .ok_or_else(|| format!("the table of the reference does not reach {frequency_hz} Hz"))?;
    point_budget(settings, &reference, point).map_err(|e| e.to_string())
}

/// As the certificate prints it, and how well a stored U agrees with it.
fn reported(budget: &PointBudget<'_>) -> Result<(Budget, f64), String> {
    let (expanded, _) = budget.expand().map_err(|e| e.to_string())?;
    let reported = Budget {
        rows: rows(&budget.magnitude),
        combined_percent: 100.0 * f64::from(expanded.standard_uncertainty),
        effective_degrees_of_freedom: f64::from(expanded.effective_degrees_of_freedom),
        coverage_factor: f64::from(expanded.coverage.factor),
        expanded_percent: 100.0 * f64::from(expanded.expanded_uncertainty),
    };
    Ok((reported, agreement_rel(&budget.magnitude)))
}

fn rows(budget: &CoreBudget<'_>) -> Vec<BudgetRow> {
    let mut rows: Vec<BudgetRow> = budget.components().iter().map(row).collect();
    rows.sort_by_key(|row| row.row);
    rows
}

fn row(component: &Component<'_>) -> BudgetRow {
    BudgetRow {
        row: component.row.number,
        value_percent: 100.0 * f64::from(component.value),
        distribution: distribution(component),
        divisor: f64::from(component.distribution.divisor()),
        sensitivity_coefficient: f64::from(component.sensitivity_coefficient),
        contribution_percent: 100.0 * f64::from(component.contribution().abs()),
        degrees_of_freedom: f64::from(component.degrees_of_freedom),
    }
}

/// Message key after `distribution.` and its parameter.
fn distribution(component: &Component<'_>) -> (&'static str, Option<f64>) {
    match component.distribution {
        Distribution::Normal { .. } if component.degrees_of_freedom.is_finite() => {
            match component.row.number {
                MOUNTING => ("mountings", None),
                _ => ("student", None),
            }
        }
        Distribution::Normal { coverage_factor } => (
            "normal",
            Some(calib_output::number::decimal(coverage_factor)),
        ),
        Distribution::Rectangular => ("rectangular", None),
        Distribution::Triangular => ("triangular", None),
        Distribution::UShaped => ("u_shaped", None),
        Distribution::Special { .. } => ("special", None),
    }
}
