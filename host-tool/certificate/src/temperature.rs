//! Contribution to the budget of the temperature told for a calibration.
//!
//! The instrument knows no temperature but its own processor's: its row 11 covers what both transducers do
//! within 3 K of 23 degrees Celsius. Who calibrates knows better, or does not say; row 11 of the certificate is the
//! coefficient times the distance that was told and its uncertainty, or the whole range of the clause, and U follows.
//!
//! # Source
//! ISO 16063-21:2003, 4.2 and Table D.1, note 5 (0.1 % and 0.02 % per kelvin, 3 K).

use super::model::{Remark, Severity, Value};
use super::particulars::Particulars;
use calib_core::requirements::Environment;
use calib_core::settings::{Distribution, Influence, Settings};
use calib_protocol::record::Record;

/// Temperature sensitivities are stated for, degrees Celsius (ISO 16063-21, 4.2).
const ROOM_C: f64 = 23.0;
/// Distance from it that row 11 of the settings covers, K.
const COVERED_K: f64 = 3.0;
/// Uncertainty of a transducer's temperature that was told, half-width, K: half of it a usual thermometer (class B
/// of IEC 60751 has 0.4 K at room temperature), half of it what it touches, which is not the inside of a transducer
/// whose own electronics warm it by some tenths.
const TOLD_TO_K: f64 = 1.0;
/// That bound where the air's was told and no difference from it: the coil warms the table. Table D.1 takes it for
/// a laboratory whose transducers nobody measured.
const BY_AIR_TO_K: f64 = 3.0;
/// Row of Table A.1.
const ROW: u8 = 11;

/// Row 11 where the settings have none: 3 K times 0.12 % and 0.03 degrees per kelvin.
const USUAL: Influence = Influence {
    row: ROW,
    value_rel: 0.0036,
    value_phase_rad: 0.001_745,
    distribution: Distribution::Rectangular,
};

/// Whether U as the instrument states it covers a transducer told to be at this temperature, degrees Celsius. Where
/// it does not, certificates state a larger one.
pub fn instrument_covers(temperature_c: f64) -> bool {
    (temperature_c - ROOM_C).abs() + TOLD_TO_K <= COVERED_K
}

/// How far from [`ROOM_C`] the transducers may have been.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Distance {
    /// As told.
    Told {
        /// From [`ROOM_C`] to the farther end of what was told, K.
        distance_k: f64,
        /// Uncertainty in it, half-width, K.
        uncertainty_k: f64,
    },
    /// Nobody said: as far as clause 4.2 allows, K.
    Unknown(f64),
}

impl Distance {
    /// Of device and reference the farther one. The reference is as warm as the ambient air, or, where
    /// nobody told that, as the device on it.
    pub(super) fn of(record: &Record, particulars: &Particulars) -> Self {
        let stated = &particulars.conditions;
        let ambient_c = stated.ambient_temperature_c;
        let by_difference = ambient_c.zip(stated.temperature_difference_k);
        let by_difference_c = by_difference.map(|(air_c, more_k)| air_c + more_k);
        let device_c = record.head.labels.temperature_centi_c;
        let device_c = device_c.map(|centi| f64::from(centi) / 100.0);
        let usual_k = device_c
            .or(by_difference_c)
            .map_or(BY_AIR_TO_K, |_| TOLD_TO_K);
        let uncertainty_k = stated.temperature_uncertainty_k.unwrap_or(usual_k);
        // Where run and job tell different things of the device, neither is believed alone.
        let told = [device_c, by_difference_c, ambient_c].into_iter().flatten();
        match told.map(|c| (c - ROOM_C).abs()).reduce(f64::max) {
            Some(kelvin) => Self::Told {
                distance_k: kelvin + uncertainty_k,
                uncertainty_k,
            },
            None => {
                let allowed = Environment::of(record.settings.example);
                Self::Unknown(f64::from(allowed.temperature_half_width_c))
            }
        }
    }

    /// From [`ROOM_C`], K.
    fn kelvin(self) -> f64 {
        match self {
            Self::Told { distance_k, .. } => distance_k,
            Self::Unknown(kelvin) => kelvin,
        }
    }

    /// Settings whose row 11 covers this distance.
    pub(super) fn covered_by(self, settings: &Settings) -> Settings {
        let mut settings = settings.clone();
        if settings.influences.iter().all(|known| known.row != ROW) {
            // A list that is full has its rows; one is made room for below by none.
            let _ = settings.influences.push(USUAL);
        }
        let times = (self.kelvin() / COVERED_K) as f32;
        for influence in settings.influences.iter_mut().filter(|i| i.row == ROW) {
            influence.value_rel *= times;
            influence.value_phase_rad *= times;
        }
        settings
    }

    /// Remark for the reader.
    pub(super) fn remark(self) -> Remark {
        let (severity, key, uncertainty_k) = match self {
            Self::Told { uncertainty_k, .. } => {
                (Severity::Note, "temperature_told", Some(uncertainty_k))
            }
            Self::Unknown(_) => (Severity::Warning, "temperature_unknown", None),
        };
        let kelvin = [Some(self.kelvin()), uncertainty_k].into_iter().flatten();
        Remark {
            severity,
            key,
            values: kelvin.map(|k| Value::Number(k, 1, "K")).collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use calib_record::sample::record;

    fn distance(device_centi_c: Option<i16>, conditions: &str) -> Distance {
        let mut record = record(&[160.0]);
        record.head.labels.temperature_centi_c = device_centi_c;
        let particulars = toml::from_str(&format!("[conditions]\n{conditions}")).expect("TOML");
        Distance::of(&record, &particulars)
    }

    /// The farther of device and reference, and the uncertainty of what was told: 1 K of a transducer's, 3 K where
    /// only the air's is known, or as stated.
    #[test]
    fn the_farther_of_device_and_reference_counts_with_the_uncertainty_of_the_reading() {
        for (device_centi_c, conditions, distance_k, to_k) in [
            (Some(2300), "", 1.0, 1.0),
            (Some(2310), "", 1.1, 1.0),
            (Some(2600), "ambient_temperature_c = 20", 4.0, 1.0),
            (Some(3300), "ambient_temperature_c = 23", 11.0, 1.0),
            (Some(2300), "ambient_temperature_c = 15", 9.0, 1.0),
            (
                None,
                "ambient_temperature_c = 21\ntemperature_difference_k = 12",
                11.0,
                1.0,
            ),
            (
                Some(2300),
                "ambient_temperature_c = 23\ntemperature_difference_k = 12",
                13.0,
                1.0,
            ),
            (None, "ambient_temperature_c = 23", 3.0, 3.0),
            (None, "ambient_temperature_c = 24", 4.0, 3.0),
            (Some(2310), "temperature_uncertainty_k = 0.4", 0.5, 0.4),
        ] {
            let Distance::Told {
                distance_k: found_k,
                uncertainty_k,
            } = distance(device_centi_c, conditions)
            else {
                panic!("{conditions}: told");
            };
            assert!(
                (found_k - distance_k).abs() < 1e-9,
                "{conditions}: {found_k}"
            );
            assert_eq!(uncertainty_k, to_k, "{conditions}");
        }
        // Example 2 of clause 4.2.
        assert_eq!(distance(None, ""), Distance::Unknown(10.0));
    }

    #[test]
    fn the_instrument_covers_3_k_to_either_side_with_the_uncertainty_of_the_reading() {
        for (temperature_c, covered) in [(20.9, false), (21.0, true), (25.0, true), (25.1, false)] {
            assert_eq!(instrument_covers(temperature_c), covered, "{temperature_c}");
        }
    }

    /// 0.36 % for 3 K are 1.2 % for 10 and 0.12 % for 1; without a row the usual coefficient counts.
    #[test]
    fn row_11_is_coefficient_times_difference() {
        let mut settings = record(&[160.0]).settings;
        let row_11 = |settings: &Settings, kelvin: f64| -> f32 {
            let covered = Distance::Unknown(kelvin).covered_by(settings);
            let rows = covered.influences.iter().filter(|i| i.row == ROW);
            rows.map(|i| i.value_rel).sum()
        };
        for (kelvin, expected) in [(10.0, 0.012), (3.0, 0.0036), (1.0, 0.0012)] {
            let found = row_11(&settings, kelvin);
            assert!((found - expected).abs() < 1e-7, "{kelvin}: {found}");
        }
        settings.influences.retain(|i| i.row != ROW);
        let usual = row_11(&settings, 10.0);
        assert!((usual - 0.012).abs() < 1e-7, "{usual}");
    }
}
