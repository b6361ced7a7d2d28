//! The ratio of the two channels, measured with one source at both inputs.
//!
//! Both channels have the same dividers and filters, but parts have tolerances: with capacitors of
//! 1 % the ratio is off by 0.5 % and 0.5 degrees at 10 kHz. One source at both inputs shows it, and
//! with the leads exchanged whatever differs between the leads cancels.

use crate::response_table::{self, Response, Row};
use heapless::Vec;
use num_complex::Complex32;
use serde::{Deserialize, Serialize};

/// Most frequencies of a ratio.
pub const MAX_CHANNEL_RATIO_POINTS: usize = 16;

/// Frequencies a ratio is measured at unless others are wanted, Hz: close together where filters differ.
pub const RATIO_FREQUENCIES_HZ: [f32; MAX_CHANNEL_RATIO_POINTS] = [
    20.0, 40.0, 80.0, 160.0, 315.0, 630.0, 1000.0, 1250.0, 2000.0, 2500.0, 3150.0, 4000.0, 5000.0,
    6300.0, 8000.0, 10_000.0,
];

/// One frequency of the ratio.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct ChannelRatioPoint {
    /// Frequency, Hz.
    pub frequency_hz: f32,
    /// Reading of the device's channel over that of the reference's channel, of the same voltage.
    pub magnitude: f32,
    /// Phase of that, rad.
    pub phase_rad: f32,
    /// Relative expanded uncertainty (k = 2) of the magnitude.
    pub expanded_uncertainty_rel: f32,
    /// Expanded uncertainty (k = 2) of the phase, rad.
    pub expanded_uncertainty_phase_rad: f32,
}

/// The device's channel over the reference's, from the connectors on.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct ChannelRatio {
    /// Day it was measured, days since 1970-01-01; 0 = not stated.
    pub measured_day: u32,
    /// Table in rising frequency; empty where it was not measured.
    #[cfg_attr(feature = "schema", schemars(with = "[ChannelRatioPoint]"))]
    pub points: Vec<ChannelRatioPoint, MAX_CHANNEL_RATIO_POINTS>,
}

impl ChannelRatio {
    /// Not measured: both channels are taken as equal.
    pub const UNKNOWN: Self = Self {
        measured_day: 0,
        points: Vec::new(),
    };

    /// The ratio that is taken away at `frequency_hz`: 1 outside the table, as nothing is extrapolated.
    pub fn taken_away(&self, frequency_hz: f32) -> Complex32 {
        self.at(frequency_hz)
            .map_or(Complex32::new(1.0, 0.0), |known| {
                Complex32::from_polar(known.magnitude, known.phase_rad)
            })
    }

    /// The ratio at `frequency_hz`; none outside the table.
    pub(crate) fn at(&self, frequency_hz: f32) -> Option<Response> {
        response_table::at(&self.points, frequency_hz)
    }
}

impl Row for ChannelRatioPoint {
    fn frequency_hz(&self) -> f32 {
        self.frequency_hz
    }

    fn response(&self) -> Response {
        Response {
            magnitude: self.magnitude,
            phase_rad: self.phase_rad,
            expanded_uncertainty_rel: self.expanded_uncertainty_rel,
            expanded_uncertainty_phase_rad: self.expanded_uncertainty_phase_rad,
            interpolation_rel: 0.0,
            interpolation_phase_rad: 0.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reference::ReferenceSensitivity;
    use crate::settings::Settings;

    fn reference() -> ReferenceSensitivity {
        Settings::field_calibrator()
            .reference
            .at(1000.0)
            .expect("in the table")
    }

    fn with(points: &[[f32; 3]]) -> Settings {
        let mut settings = Settings::field_calibrator();
        let point = |&[frequency_hz, magnitude, phase_rad]: &[f32; 3]| ChannelRatioPoint {
            frequency_hz,
            magnitude,
            phase_rad,
            expanded_uncertainty_rel: 2.0e-4,
            expanded_uncertainty_phase_rad: 2.0e-4,
        };
        settings.channel_ratio.points = points.iter().map(point).collect();
        settings
    }

    /// A device's channel that reads 1 % high and 0.02 rad late: the sensitivity is 1 % lower and
    /// 0.02 rad earlier than the samples say. Four roundings of f32, and those of sine and cosine.
    #[test]
    fn what_the_channel_adds_is_taken_away() {
        let read = Complex32::from_polar(0.98, 0.3);
        let plain = with(&[]).sensitivity(read, &reference(), 1000.0);
        assert!((plain.norm() / (0.98 * 0.0102) - 1.0).abs() < 1.0e-6);
        assert!((plain.arg() - 0.3).abs() < 1.0e-6);
        let known = with(&[[500.0, 1.01, -0.02], [2000.0, 1.01, -0.02]]);
        let mended = known.sensitivity(read, &reference(), 1000.0);
        assert!((mended.norm() * 1.01 / plain.norm() - 1.0).abs() < 1.0e-6);
        assert!((mended.arg() - 0.32).abs() < 1.0e-6);
    }

    #[test]
    fn outside_its_table_the_channels_are_taken_as_equal() {
        let settings = with(&[[500.0, 1.01, -0.02], [2000.0, 1.01, -0.02]]);
        let read = Complex32::new(1.0, 0.0);
        for frequency_hz in [499.0, 2010.0] {
            let plain = with(&[]).sensitivity(read, &reference(), frequency_hz);
            assert_eq!(
                settings.sensitivity(read, &reference(), frequency_hz),
                plain
            );
        }
    }
}
