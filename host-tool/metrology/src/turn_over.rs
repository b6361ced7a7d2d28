//! Sensitivity of a reference that responds to steady acceleration, by turning it over in gravity.
//!
//! # Equation
//! With its axis up the output is `U0 + S g`, with its axis down `U0 - S g`. Readings in groups of up, down, down,
//! up: a zero that drifts evenly cancels.
//!
//! ```text
//! S = (U1 - U2 - U3 + U4) / (4 g)
//! ```
//!
//! # Source
//! The principle of ISO 16063-16, *Calibration by Earth's gravitation*; the text itself was not at hand. Normal
//! gravity: GRS80 (H. Moritz, Bulletin géodésique 54 (1980)), and 3.086e-6 s^-2 of height.

use crate::reciprocity::{Against, Change};
use crate::statistics::{mean, standard_deviation, student_factor};
use crate::text::Table;
use calib_core::reference::ReferenceSensitivity;
use calib_core::settings::ReferenceCalibration;
use calib_files::{Error, Result, text};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::path::Path;

/// Readings of a group: up, down, down, up.
const GROUP: usize = 4;
/// Fewest groups: their scatter is the type A.
const FEWEST_GROUPS: usize = 2;
/// Probability of `k = 2`, and that of the limit beyond which a change is significant.
const PROBABILITY_K2: f64 = 0.9545;
const PROBABILITY_99: f64 = 0.99;
/// Temperature a reference is calibrated at, degrees Celsius (ISO 16063-21, 4.2).
const CERTIFIED_C: f64 = 23.0;
/// Where nobody read it: half-width about that, K (clause 4.2, on a site).
const UNTOLD_K: f64 = 10.0;
/// Gravity by latitude and height, half-width, m/s2: anomalies of 100 mGal; and the plate of rock under a height,
/// s^-2, which may be there or not.
const ANOMALY_MS2: f64 = 1.0e-3;
const PLATE_PER_S2: f64 = 1.1e-6;

/// A file of readings, and of the equipment they were taken with.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TurnOverReadings {
    /// Output of the reference, V, in the order taken: up, down, down, up, and again.
    pub readings_v: Vec<f64>,
    /// Local acceleration of free fall, m/s2, with its relative standard uncertainty; or latitude and height.
    pub gravity_ms2: Option<[f64; 2]>,
    /// Latitude, degrees.
    pub latitude_deg: Option<f64>,
    /// Height above the sea, m.
    #[serde(default)]
    pub height_m: f64,
    /// The voltmeter: half-width, relative.
    pub voltmeter_rel: f64,
    /// The axis may be off the vertical by so much, degrees.
    pub tilt_deg: f64,
    /// From d.c. to the lowest frequency of the table the sensitivity may change by so much, relative.
    pub step_rel: f64,
    /// Change of the sensitivity with temperature: half-width, 1/K.
    #[serde(default = "usual_per_k")]
    pub reference_per_k: f64,
    /// Temperature of the reference, degrees Celsius.
    pub temperature_c: Option<f64>,
    /// When it was read (RFC 3339, as 2026-11-23T14:30:00Z); now where nobody says.
    pub measured: Option<String>,
}

/// As of an equipment of [`crate::reciprocity`].
fn usual_per_k() -> f64 {
    2e-4
}

/// A row of the budget.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct TurnOverRow {
    /// The contribution, in words.
    pub what: String,
    /// Standard uncertainty, relative.
    #[serde(rename = "standard_uncertainty_rel")]
    pub standard_rel: f64,
    /// It is the same the next time, with the same equipment at the same place.
    pub stays: bool,
}

/// Result of turning over.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct TurnOver {
    /// Sensitivity at d.c., V/(m/s2); negative where the axis points the other way than was told.
    pub sensitivity_at_dc_v_per_ms2: f64,
    /// Its relative expanded uncertainty, as that of the lowest frequency of the table (k = 2, or its Student factor).
    pub expanded_uncertainty_rel: f64,
    /// Output without acceleration, V.
    pub zero_v: f64,
    /// Change of that from the first group to the last, V.
    pub zero_drift_v: f64,
    /// Local acceleration of free fall, m/s2.
    pub gravity_ms2: f64,
    /// Groups of four readings.
    pub groups: usize,
    /// Effective degrees of freedom; none where they have no end.
    pub effective_degrees_of_freedom: Option<f64>,
    /// The budget.
    pub budget: Vec<TurnOverRow>,
    /// Lowest frequency of the reference's table, Hz.
    pub certified_hz: f64,
    /// Sensitivity on the certificate at that frequency, V/(m/s2).
    pub certified_v_per_ms2: f64,
    /// Its relative expanded uncertainty (k = 2).
    pub certified_expanded_uncertainty_rel: f64,
    /// Result over certificate, less 1.
    pub change_rel: f64,
}

impl TurnOverReadings {
    /// Reads a file (TOML).
    ///
    /// # Errors
    /// [`Error::File`]; [`Error::Input`] with line or key.
    pub fn read(path: &Path) -> Result<Self> {
        let content = text::read(path)?;
        const HINT: &str = "docs/metrology/reciprocity.md#turning-over-in-gravity has an example";
        let read: Self = text::parse_toml(path, &content, HINT)?;
        match read.wrong() {
            None => Ok(read),
            Some(problem) => Err(Error::input(path.display().to_string(), problem, HINT)),
        }
    }

    /// Why nothing can be said.
    fn wrong(&self) -> Option<String> {
        let count = self.readings_v.len();
        if !count.is_multiple_of(GROUP) || count < GROUP * FEWEST_GROUPS {
            return Some(format!(
                "has {count} readings: groups of up, down, down, up are wanted, at least {FEWEST_GROUPS}"
            ));
        }
        let share = |value: f64| (0.0..0.5).contains(&value);
        let checks = [
            ("readings_v", self.readings_v.iter().all(|v| v.is_finite())),
            (
                "voltmeter_rel",
                share(self.voltmeter_rel) && self.voltmeter_rel > 0.0,
            ),
            ("tilt_deg", (0.0..=10.0).contains(&self.tilt_deg)),
            ("step_rel", share(self.step_rel)),
            ("reference_per_k", share(self.reference_per_k)),
            (
                "temperature_c",
                (-55.0..=200.0).contains(&self.temperature_c.unwrap_or(CERTIFIED_C)),
            ),
            (
                "gravity_ms2",
                self.gravity_ms2
                    .is_none_or(|[g, u]| (9.7..9.9).contains(&g) && share(u)),
            ),
            (
                "latitude_deg",
                self.latitude_deg
                    .is_none_or(|deg| (-90.0..=90.0).contains(&deg)),
            ),
            ("height_m", (-500.0..9000.0).contains(&self.height_m)),
        ];
        if let Some((key, _)) = checks.into_iter().find(|(_, holds)| !holds) {
            return Some(format!("{key} cannot be"));
        }
        let places = [self.gravity_ms2.is_some(), self.latitude_deg.is_some()];
        (places[0] == places[1])
            .then(|| "states neither or both of gravity_ms2 and latitude_deg".to_owned())
    }

    /// Local acceleration of free fall, m/s2, and its relative standard uncertainty.
    fn gravity(&self) -> [f64; 2] {
        let Some(latitude_deg) = self.latitude_deg else {
            return self.gravity_ms2.unwrap_or_default();
        };
        let normal_ms2 = normal_gravity_ms2(latitude_deg) - 3.086e-6 * self.height_m;
        let half_width_ms2 = ANOMALY_MS2 + PLATE_PER_S2 * self.height_m.abs();
        [normal_ms2, even(half_width_ms2 / normal_ms2)]
    }
}

/// Gravity of the ellipsoid GRS80 at the sea, m/s2, by Somigliana's formula.
fn normal_gravity_ms2(latitude_deg: f64) -> f64 {
    let square = latitude_deg.to_radians().sin().powi(2);
    9.780_326_771_5 * (1.0 + 0.001_931_851_353 * square)
        / (1.0 - 0.006_694_380_022_90 * square).sqrt()
}

/// Standard uncertainty of what lies evenly within a half-width.
fn even(half_width: f64) -> f64 {
    half_width / 3.0_f64.sqrt()
}

/// Evaluates readings, against the table of the reference.
///
/// # Errors
/// [`Error::Input`] where the readings do not change, or the reference has no table.
///
/// # Accuracy
/// Test `readings_by_newton_give_the_sensitivity_and_an_even_drift_nothing`.
pub fn turn_over(read: &TurnOverReadings, reference: &ReferenceCalibration) -> Result<TurnOver> {
    let certified = lowest(reference).ok_or_else(|| {
        Error::input(
            "the reference",
            "has no calibration to compare with",
            "enter its table: `calib reference`",
        )
    })?;
    let [gravity_ms2, gravity_standard_rel] = read.gravity();
    let (groups, _) = read.readings_v.as_chunks::<GROUP>();
    let of_group = |u: &[f64; GROUP]| (u[0] - u[1] - u[2] + u[3]) / (4.0 * gravity_ms2);
    let values: Vec<f64> = groups.iter().map(of_group).collect();
    let zeros: Vec<f64> = groups.iter().map(|group| mean(group)).collect();
    let sensitivity = mean(&values);
    if sensitivity.abs() * gravity_ms2 <= f64::EPSILON * mean(&zeros).abs() {
        return Err(Error::input(
            "the readings",
            "do not change from up to down",
            "an IEPE reference does not respond to d.c.: `calib selfcheck` checks it by reciprocity",
        ));
    }
    let count = values.len() as f64;
    let scatter_rel = standard_deviation(&values) / count.sqrt() / sensitivity.abs();
    let distance_k = read
        .temperature_c
        .map_or(even(UNTOLD_K), |c| (c - CERTIFIED_C).abs());
    let tilt = 0.5 * read.tilt_deg.to_radians().powi(2);
    let row = |what: &str, standard_rel: f64, stays: bool| TurnOverRow {
        what: what.to_owned(),
        standard_rel,
        stays,
    };
    let budget = vec![
        row("local gravity", gravity_standard_rel, true),
        row("voltmeter", even(read.voltmeter_rel), true),
        row("axis off the vertical", even(tilt), false),
        row(
            "temperature",
            even(read.reference_per_k) * distance_k,
            false,
        ),
        row("from d.c. to the table", even(read.step_rel), true),
        row(SCATTER, scatter_rel, false),
    ];
    let standard_rel = combined(&budget, |_| true);
    let freedom = (count - 1.0) * (standard_rel / scatter_rel).powi(4);
    let certified_v_per_ms2 = f64::from(certified.1.sensitivity_v_per_ms2);
    Ok(TurnOver {
        sensitivity_at_dc_v_per_ms2: sensitivity,
        expanded_uncertainty_rel: student_factor(PROBABILITY_K2, freedom) * standard_rel,
        zero_v: mean(&zeros),
        zero_drift_v: zeros.last().unwrap_or(&0.0) - zeros.first().unwrap_or(&0.0),
        gravity_ms2,
        groups: values.len(),
        effective_degrees_of_freedom: Some(freedom).filter(|freedom| freedom.is_finite()),
        budget,
        certified_hz: f64::from(certified.0),
        certified_v_per_ms2,
        certified_expanded_uncertainty_rel: f64::from(certified.1.expanded_uncertainty_rel),
        change_rel: sensitivity.abs() / certified_v_per_ms2 - 1.0,
    })
}

const SCATTER: &str = "scatter of the groups";

fn lowest(reference: &ReferenceCalibration) -> Option<(f32, ReferenceSensitivity)> {
    let frequency_hz = reference.points.first()?.frequency_hz;
    Some((frequency_hz, reference.at(frequency_hz)?))
}

fn combined(budget: &[TurnOverRow], takes: impl Fn(&TurnOverRow) -> bool) -> f64 {
    let rows = budget.iter().filter(|row| takes(row));
    rows.map(|row| row.standard_rel.powi(2)).sum::<f64>().sqrt()
}

impl TurnOver {
    /// Against an earlier one with the same equipment at the same place: what stays cancels.
    pub fn since(&self, baseline: &Self) -> Change {
        let varies = |found: &Self| combined(&found.budget, |row| !row.stays);
        let ratio = self.sensitivity_at_dc_v_per_ms2 / baseline.sensitivity_at_dc_v_per_ms2;
        let standard_rel = varies(self).hypot(varies(baseline));
        let freedom = self
            .freedom_of(standard_rel)
            .min(baseline.freedom_of(standard_rel));
        judged(Against::Baseline, ratio - 1.0, standard_rel, freedom)
    }

    /// Against the certificate, at the lowest frequency of its table.
    pub fn against_certificate(&self) -> Change {
        let own = combined(&self.budget, |_| true);
        let standard_rel = own.hypot(0.5 * self.certified_expanded_uncertainty_rel);
        let freedom = self.freedom_of(standard_rel);
        judged(Against::Certificate, self.change_rel, standard_rel, freedom)
    }

    /// Effective degrees of freedom of something of this standard uncertainty that has the scatter in it.
    fn freedom_of(&self, standard_rel: f64) -> f64 {
        let scatter = combined(&self.budget, |row| row.what == SCATTER);
        (self.groups as f64 - 1.0) * (standard_rel / scatter).powi(4)
    }

    /// Result and budget as text.
    pub fn report(&self) -> String {
        let mut table = Table::new(&["", "u/%"]);
        for row in &self.budget {
            table.row([row.what.clone(), format!("{:.4}", 100.0 * row.standard_rel)]);
        }
        format!(
            "{:.4} mV/(m/s2) at d.c., U = {:.2} %; {:.4} mV/(m/s2) at {} Hz by the certificate: {:+.2} %\n\
             g = {:.5} m/s2; zero {:.3} mV, {:+.3} mV from the first of {} groups to the last\n\n{table}",
            1000.0 * self.sensitivity_at_dc_v_per_ms2,
            100.0 * self.expanded_uncertainty_rel,
            1000.0 * self.certified_v_per_ms2,
            self.certified_hz,
            100.0 * self.change_rel,
            self.gravity_ms2,
            1000.0 * self.zero_v,
            1000.0 * self.zero_drift_v,
            self.groups,
        )
    }
}

fn judged(against: Against, change_rel: f64, standard_rel: f64, freedom: f64) -> Change {
    Change {
        against,
        frequencies: 1,
        change_rel,
        expanded_rel: student_factor(PROBABILITY_K2, freedom) * standard_rel,
        significant: change_rel.abs() > student_factor(PROBABILITY_99, freedom) * standard_rel,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use calib_core::settings::Settings;

    const G: f64 = 9.81;

    /// By Newton: zero and drift of it, V, beside S g up and down; each group's S off by a share.
    fn readings(sensitivity: f64, drift_v: f64, off: &[f64]) -> TurnOverReadings {
        let mut readings_v = Vec::new();
        for off in off {
            for sign in [1.0, -1.0, -1.0, 1.0] {
                let zero_v = 0.012 + drift_v * readings_v.len() as f64;
                readings_v.push(zero_v + sign * sensitivity * (1.0 + off) * G);
            }
        }
        TurnOverReadings {
            readings_v,
            gravity_ms2: Some([G, 1e-5]),
            latitude_deg: None,
            height_m: 0.0,
            voltmeter_rel: 1e-4,
            tilt_deg: 0.5,
            step_rel: 1e-3,
            reference_per_k: 2e-4,
            temperature_c: Some(23.0),
            measured: None,
        }
    }

    fn found(read: &TurnOverReadings) -> TurnOver {
        turn_over(read, &Settings::field_calibrator().reference).expect("a result")
    }

    #[test]
    fn readings_by_newton_give_the_sensitivity_and_an_even_drift_nothing() {
        for drift_v in [0.0, 1e-3] {
            let found = found(&readings(0.0102, drift_v, &[0.0, 0.0]));
            let off = found.sensitivity_at_dc_v_per_ms2 / 0.0102 - 1.0;
            assert!(off.abs() < 1e-12, "{off}");
            // From the middle of one group to that of the next.
            assert!((found.zero_drift_v - 4.0 * drift_v).abs() < 1e-12);
        }
    }

    /// 1e-5; 1e-4 and (0.5 degrees)^2/2 = 3.81e-5 and 1e-3 over sqrt 3; groups 1e-4 off to either side scatter by
    /// 1.414e-4, their mean by 1e-4: u = 5.98e-4, 1 degree of freedom of it is 1280.
    #[test]
    fn the_budget_is_the_one_by_hand() {
        let found = found(&readings(0.0102, 0.0, &[1e-4, -1e-4]));
        let square = 1e-10_f64 + (1e-8 + 3.808e-5_f64.powi(2) + 1e-6) / 3.0 + 1e-8;
        let expected = 2.0 * square.sqrt();
        let ratio = found.expanded_uncertainty_rel / expected;
        assert!((0.999..1.003).contains(&ratio), "{ratio}");
        let freedom = found.effective_degrees_of_freedom.expect("an end");
        assert!((1200.0..1350.0).contains(&freedom), "{freedom}");
    }

    /// Rows that stay cancel between two, and a change of 0.5 % is one; the certificate has 1 % of its own.
    #[test]
    fn a_change_is_told_from_the_certificate() {
        let baseline = found(&readings(0.0102, 0.0, &[1e-5, -1e-5, 0.0]));
        for (sensitivity, changed) in [(0.010_200_2, false), (0.010_149, true)] {
            let now = found(&readings(sensitivity, 0.0, &[1e-5, -1e-5, 0.0]));
            let since = now.since(&baseline);
            assert_eq!(since.significant, changed, "{since:?}");
            assert!(since.expanded_rel < 2e-4, "{since:?}");
        }
    }

    /// GRS80 at the equator, 45 degrees and the pole, to its printed digits; 1 000 m take 3.086e-3 m/s2.
    #[test]
    fn gravity_is_that_of_the_ellipsoid() {
        for (latitude_deg, expected) in [(0.0, 9.780_327), (45.0, 9.806_199), (-90.0, 9.832_186)] {
            assert!((normal_gravity_ms2(latitude_deg) - expected).abs() < 1e-6);
        }
        let at = TurnOverReadings {
            gravity_ms2: None,
            latitude_deg: Some(45.0),
            height_m: 1000.0,
            ..readings(0.0102, 0.0, &[0.0, 0.0])
        };
        let [gravity, standard_rel] = at.gravity();
        assert!((gravity - 9.803_113).abs() < 2e-6, "{gravity}");
        assert!((standard_rel * gravity * 3.0_f64.sqrt() - 2.1e-3).abs() < 1e-9);
    }

    #[test]
    fn what_says_nothing_is_refused() {
        type Damage = fn(&mut TurnOverReadings);
        let damages: [(Damage, &str); 7] = [
            (|r| r.readings_v.truncate(4), "has 4 readings"),
            (|r| r.readings_v.truncate(7), "has 7 readings"),
            (|r| r.readings_v[2] = f64::NAN, "readings_v cannot be"),
            (
                |r| r.gravity_ms2 = Some([981.0, 0.0]),
                "gravity_ms2 cannot be",
            ),
            (|r| r.gravity_ms2 = None, "neither or both"),
            (|r| r.latitude_deg = Some(50.0), "neither or both"),
            (|r| r.tilt_deg = -1.0, "tilt_deg cannot be"),
        ];
        let good = readings(0.0102, 0.0, &[0.0, 0.0]);
        assert_eq!(good.wrong(), None);
        for (damage, told) in damages {
            let mut damaged = good.clone();
            damage(&mut damaged);
            assert!(
                damaged.wrong().is_some_and(|said| said.contains(told)),
                "{told}"
            );
        }
        let dead = readings(0.0, 0.0, &[0.0, 0.0]);
        let refused = turn_over(&dead, &Settings::field_calibrator().reference);
        assert!(
            refused
                .expect_err("none")
                .to_string()
                .contains("do not change")
        );
    }
}
