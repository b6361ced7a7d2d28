//! Contribution to the budget of the temperature told for a calibration.
//!
//! The instrument knows no temperature but its own processor's: its row 11 covers what both transducers do
//! within 3 K of 23 degrees Celsius. Who calibrates knows better, or does not say; row 11 of the certificate
//! follows from that, and U with it.
//!
//! # Source
//! ISO 16063-21:2003, 4.2 and Table D.1, note 5 (0.1 % and 0.02 % per kelvin, 3 K).

use super::model::{Remark, Severity, Value};
use super::particulars::Particulars;
use calib_core::requirements::Environment;
use calib_core::settings::{Distribution, Influence, Settings};
use calib_protocol::record::Record;
use std::borrow::Cow;

/// Temperature sensitivities are stated for, degrees Celsius (ISO 16063-21, 4.2).
const ROOM_C: f64 = 23.0;
/// Distance from it that row 11 of the settings covers, K.
const COVERED_K: f64 = 3.0;
/// Row of Table A.1.
const ROW: u8 = 11;

/// Row 11 where the settings have none: 3 K times 0.12 % and 0.03 degrees per kelvin.
const USUAL: Influence = Influence {
    row: ROW,
    value_rel: 0.0036,
    value_phase_rad: 0.001_745,
    distribution: Distribution::Rectangular,
};

/// Whether U as the instrument states it covers a transducer at this temperature, degrees Celsius. Where it does
/// not, certificates state a larger one.
pub fn instrument_covers(temperature_c: f64) -> bool {
    (temperature_c - ROOM_C).abs() <= COVERED_K
}

/// How far from [`ROOM_C`] the transducers may have been.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Distance {
    /// Within what the settings cover.
    Covered,
    /// Farther, as told, K.
    Told(f64),
    /// Nobody said: as far as clause 4.2 allows, K.
    Unknown(f64),
}

impl Distance {
    /// Of device and reference the farther one. The reference is as warm as the ambient air, or, where
    /// nobody told that, as the device on it.
    pub(super) fn of(record: &Record, particulars: &Particulars) -> Self {
        let stated = &particulars.conditions;
        let ambient_c = stated.ambient_temperature_c;
        let by_difference = ambient_c.map(|c| c + stated.temperature_difference_k.unwrap_or(0.0));
        let device_c = record.head.labels.temperature_centi_c;
        let device_c = device_c.map(|centi| f64::from(centi) / 100.0);
        let told = [device_c.or(by_difference), ambient_c];
        let farthest = told.into_iter().flatten().map(|c| (c - ROOM_C).abs());
        match farthest.reduce(f64::max) {
            Some(kelvin) if kelvin <= COVERED_K => Self::Covered,
            Some(kelvin) => Self::Told(kelvin),
            None => {
                let allowed = Environment::of(record.settings.example);
                Self::Unknown(f64::from(allowed.temperature_half_width_c))
            }
        }
    }

    /// Settings whose row 11 covers this distance.
    pub(super) fn covered_by(self, settings: &Settings) -> Cow<'_, Settings> {
        let (Self::Told(kelvin) | Self::Unknown(kelvin)) = self else {
            return Cow::Borrowed(settings);
        };
        let mut settings = settings.clone();
        if settings.influences.iter().all(|known| known.row != ROW) {
            // A list that is full has its rows; one is made room for below by none.
            let _ = settings.influences.push(USUAL);
        }
        let times = (kelvin / COVERED_K) as f32;
        for influence in settings.influences.iter_mut().filter(|i| i.row == ROW) {
            influence.value_rel *= times;
            influence.value_phase_rad *= times;
        }
        Cow::Owned(settings)
    }

    /// Remark for the reader.
    pub(super) fn remark(self) -> Option<Remark> {
        let (severity, key, kelvin) = match self {
            Self::Covered => return None,
            Self::Told(kelvin) => (Severity::Note, "temperature_told", kelvin),
            Self::Unknown(kelvin) => (Severity::Warning, "temperature_unknown", kelvin),
        };
        Some(Remark {
            severity,
            key,
            values: vec![Value::Number(kelvin, 1, "K")],
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use calib_record::sample::record;

    fn distance(device_centi_c: Option<i16>, ambient: &str) -> Distance {
        let mut record = record(&[160.0]);
        record.head.labels.temperature_centi_c = device_centi_c;
        let particulars = toml::from_str(&format!("[conditions]\n{ambient}")).expect("TOML");
        Distance::of(&record, &particulars)
    }

    #[test]
    fn the_farther_of_device_and_reference_counts() {
        for (device_centi_c, ambient, expected) in [
            (Some(2310), "", Distance::Covered),
            (Some(2600), "ambient_temperature_c = 20", Distance::Covered),
            (
                Some(3300),
                "ambient_temperature_c = 23",
                Distance::Told(10.0),
            ),
            (
                Some(2300),
                "ambient_temperature_c = 15",
                Distance::Told(8.0),
            ),
            (
                None,
                "ambient_temperature_c = 21\ntemperature_difference_k = 12",
                Distance::Told(10.0),
            ),
            // Example 2 of clause 4.2.
            (None, "", Distance::Unknown(10.0)),
        ] {
            assert_eq!(distance(device_centi_c, ambient), expected, "{ambient}");
        }
    }

    #[test]
    fn the_instrument_covers_3_k_to_either_side() {
        for (temperature_c, covered) in [(19.9, false), (20.0, true), (26.0, true), (26.1, false)] {
            assert_eq!(instrument_covers(temperature_c), covered, "{temperature_c}");
        }
    }

    /// 0.36 % for 3 K are 1.2 % for 10; without a row the usual coefficient counts.
    #[test]
    fn row_11_is_coefficient_times_difference() {
        let mut settings = record(&[160.0]).settings;
        let row_11 = |settings: &Settings| -> f32 {
            let rows = settings.influences.iter().filter(|i| i.row == ROW);
            rows.map(|i| i.value_rel).sum()
        };
        let enlarged = row_11(&Distance::Told(10.0).covered_by(&settings));
        assert!((enlarged - 0.012).abs() < 1e-7, "{enlarged}");
        assert_eq!(
            row_11(&Distance::Covered.covered_by(&settings)),
            row_11(&settings)
        );
        settings.influences.retain(|i| i.row != ROW);
        let usual = row_11(&Distance::Told(10.0).covered_by(&settings));
        assert!((usual - 0.012).abs() < 1e-7, "{usual}");
    }
}
