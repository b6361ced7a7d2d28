//! Shunt, divider and mass, and what is known of them and of the exciter.

use calib_files::{Error, Result, text};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::path::Path;

/// Temperature a reference is calibrated at, degrees Celsius (ISO 16063-21, 4.2).
const CERTIFIED_C: f64 = 23.0;

/// Equipment of a check beside the calibrator, with the standard uncertainties of the budget.
///
/// Values left out are those of `hardware/reciprocity.md`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Equipment {
    /// Added mass with its stud, kg.
    pub mass_kg: f64,
    /// Its standard uncertainty, relative.
    pub mass_standard_rel: f64,
    /// Mean of the film under it, kg; as much again is its standard uncertainty over sqrt(3).
    pub film_kg: f64,
    /// Shunt, ohm.
    pub shunt_ohm: f64,
    /// Its standard uncertainty, relative.
    pub shunt_standard_rel: f64,
    /// Output of the divider for a volt across coil and shunt.
    pub divider_volt_per_v: f64,
    /// Its standard uncertainty, relative.
    pub divider_standard_rel: f64,
    /// A direct current carries the mass.
    pub held: bool,
    /// Compliance of the seat of the mass, m/N: mean, and standard uncertainty.
    pub seat_m_per_n: [f64; 2],
    /// Part of that which differs from check to check, 1.
    pub seat_scatter_rel: f64,
    /// Standard uncertainty of the position with the mass, of its sag, where it is held.
    pub hold_standard_rel: f64,
    /// Standard uncertainty of the position beside that, m.
    pub creep_standard_m: f64,
    /// Standard uncertainty of the relative change with position: of the blocked inductance, 1/m.
    pub inductance_per_m: f64,
    /// Of the stiffness, 1/m.
    pub stiffness_per_m: f64,
    /// Of Bl, 1/m.
    pub force_factor_per_m: f64,
    /// Fall of Bl with the square of travel, 1/m2: mean, and standard uncertainty.
    pub force_factor_per_m2: [f64; 2],
    /// Coil's field in the reference's channel: standard uncertainty, V/A.
    pub stray_v_per_a: f64,
    /// Coil's field in the reference's channel by induction: standard uncertainty, V s/A.
    pub stray_vs_per_a: f64,
    /// Rocking: standard uncertainty at 1 kHz, relative; it grows with the square of the frequency.
    pub rocking_at_1_khz_rel: f64,
    /// Reference against seat: standard uncertainty at 1 kHz, relative; likewise.
    pub table_at_1_khz_rel: f64,
    /// Resistance of the coil from load to load, after the fit: standard uncertainty, ohm.
    pub heating_standard_ohm: f64,
    /// Change of the reference's sensitivity with temperature, relative, 1/K: mean, and standard uncertainty.
    pub reference_per_k: [f64; 2],
    /// Temperature of the reference over what was told of it, times that: standard uncertainty, relative.
    pub temperature_standard_rel: f64,
    /// Where nobody told a temperature: standard uncertainty about that of the certificate, K.
    pub untold_temperature_standard_k: f64,
    /// A reading by the converter's characteristic: standard uncertainty, relative.
    pub reading_standard_rel: f64,
    /// Of the other input's signal in an input: standard uncertainty, 1.
    pub crosstalk_standard: f64,
    /// Two measurements of the ratio of the channels: standard uncertainty, relative.
    pub ratio_scatter_standard_rel: f64,
}

/// Keys whose values are above zero; all others are not below.
const ABOVE_ZERO: [&str; 3] = ["mass_kg", "shunt_ohm", "divider_volt_per_v"];

impl Default for Equipment {
    fn default() -> Self {
        let even = |half_width: f64| half_width / 3.0_f64.sqrt();
        Self {
            mass_kg: 0.050,
            mass_standard_rel: even(1e-4),
            film_kg: 2.5e-6,
            shunt_ohm: 1.0,
            shunt_standard_rel: even(5e-4),
            divider_volt_per_v: 0.5,
            divider_standard_rel: even(5e-4),
            held: true,
            // 2e8 to 6e8 N/m, evenly on a logarithmic scale: (a - b)/ln(a/b), and the second moment from that.
            seat_m_per_n: [3.03e-9, 0.98e-9],
            seat_scatter_rel: 0.09,
            hold_standard_rel: 0.02,
            creep_standard_m: 1e-6,
            inductance_per_m: even(80.0),
            stiffness_per_m: even(80.0),
            force_factor_per_m: even(10.0),
            // 1e3 to 2e4, likewise.
            force_factor_per_m2: [6.3e3, 5.3e3],
            stray_v_per_a: even(1e-4),
            stray_vs_per_a: even(2e-8),
            rocking_at_1_khz_rel: 2e-5,
            table_at_1_khz_rel: 5e-5,
            heating_standard_ohm: 1e-3,
            reference_per_k: [0.0, even(2e-4)],
            temperature_standard_rel: 0.5 * even(2e-4),
            // Clause 4.2: 23 degrees, 3 either side in a laboratory, 10 on a site.
            untold_temperature_standard_k: even(10.0),
            reading_standard_rel: 5e-5,
            crosstalk_standard: even(1e-4),
            ratio_scatter_standard_rel: 5e-5,
        }
    }
}

impl Equipment {
    /// Reads a file of these values (TOML).
    ///
    /// # Errors
    /// [`Error::File`]; [`Error::Input`] with line or key.
    pub fn read(path: &Path) -> Result<Self> {
        let content = text::read(path)?;
        const HINT: &str = "docs/schema/selfcheck.json says under `Equipment` what each key is";
        let equipment: Self = text::parse_toml(path, &content, HINT)?;
        match equipment.wrong() {
            None => Ok(equipment),
            Some(key) => Err(Error::input(
                path.display().to_string(),
                format!("{key} cannot be"),
                "masses, shunt and divider are above zero, uncertainties not below",
            )),
        }
    }

    /// Mass, shunt, divider and hold are those of another check: what they do to both cancels.
    pub fn is_that_of(&self, other: &Self) -> bool {
        let own = |one: &Self| [one.mass_kg, one.shunt_ohm, one.divider_volt_per_v];
        own(self) == own(other) && self.held == other.held
    }

    /// By how much the reference gives more at a temperature than at that of its certificate, relative: mean, and
    /// standard uncertainty; where nobody told a temperature, that of the untold one.
    pub(super) fn by_temperature_rel(&self, temperature_c: Option<f64>) -> [f64; 2] {
        let [mean, standard] = self.reference_per_k;
        match temperature_c.map(|told| told - CERTIFIED_C) {
            Some(distance_k) => [mean * distance_k, standard * distance_k],
            None => [
                0.0,
                self.untold_temperature_standard_k * mean.hypot(standard),
            ],
        }
    }

    /// The first key whose value cannot be.
    fn wrong(&self) -> Option<String> {
        // What is not finite is written as nothing.
        let Ok(Value::Object(stated)) = serde_json::to_value(self) else {
            return None;
        };
        let can_be = |key: &str, value: &Value| match (key, value) {
            ("held", _) => true,
            // A mean has either sign.
            ("reference_per_k", value) => value[1].as_f64() >= Some(0.0),
            (_, Value::Array(values)) => values.iter().all(|one| one.as_f64() >= Some(0.0)),
            (key, value) if ABOVE_ZERO.contains(&key) => value.as_f64() > Some(0.0),
            (_, value) => value.as_f64() >= Some(0.0),
        };
        let mut wrong = stated
            .into_iter()
            .filter(|(key, value)| !can_be(key, value));
        wrong.next().map(|(key, _)| key)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Mean and second moment of what is even on a logarithmic scale, by a sum.
    #[test]
    fn the_moments_are_those_of_what_they_state() {
        let moments = |lowest: f64, highest: f64| {
            const STEPS: u32 = 100_000;
            let value = |step: u32| {
                lowest * (highest / lowest).powf((f64::from(step) + 0.5) / f64::from(STEPS))
            };
            let mean = (0..STEPS).map(value).sum::<f64>() / f64::from(STEPS);
            let square = (0..STEPS)
                .map(|step| (value(step) - mean).powi(2))
                .sum::<f64>();
            [mean, (square / f64::from(STEPS)).sqrt()]
        };
        let stated = Equipment::default();
        for (stated, expected) in [
            (stated.seat_m_per_n, moments(1.0 / 6e8, 1.0 / 2e8)),
            (stated.force_factor_per_m2, moments(1e3, 2e4)),
        ] {
            // Two digits are stated, and deviations are rounded up.
            for (stated, expected) in stated.into_iter().zip(expected) {
                assert!(
                    (0.98..1.04).contains(&(stated / expected)),
                    "{stated} {expected}"
                );
            }
        }
    }

    #[test]
    fn what_cannot_be_is_told() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("e.toml");
        for (text, told) in [
            ("mass_kg = 0.0", "mass_kg cannot be"),
            ("shunt_ohm = nan", "shunt_ohm cannot be"),
            ("creep_standard_m = -1.0", "creep_standard_m cannot be"),
            ("masse_kg = 0.05", "masse_kg"),
        ] {
            std::fs::write(&path, text).expect("written");
            let message = Equipment::read(&path).expect_err(text).to_string();
            assert!(message.contains(told), "{message}");
        }
        std::fs::write(&path, "mass_kg = 0.1\nheld = false\n").expect("written");
        let read = Equipment::read(&path).expect("read");
        assert_eq!((read.mass_kg, read.held), (0.1, false));
    }
}
