//! The instrument's own temperature, by the sensor inside its processor.
//!
//! It shows the silicon, which its own dissipation keeps warmer than
//! the instrument, and the sensor is good to some kelvin. That is enough to
//! refuse work outside of what the parts are made for, and to see the
//! instrument warm up; it is no ambient temperature of a certificate.

/// Lowest temperature at which the instrument works, degrees Celsius: it is
/// specified from 0, less the 10 K the sensor may be wrong by.
pub const LOWEST_C: f32 = -10.0;
/// Highest temperature at which the instrument works, degrees Celsius: the
/// processor is specified to a junction of 105 at the core voltage that 480 MHz
/// need, less the 10 K the sensor may be wrong by.
///
/// # Source
/// DS12110 Rev 11, table 112 (junction temperature at voltage scale 0).
pub const HIGHEST_C: f32 = 95.0;

/// How much warmer than its surroundings the processor is once it has warmed
/// up, K. Depends on board and housing: good to 10 K.
pub const SELF_HEATING_K: f32 = 25.0;

/// Whether the instrument may work at this temperature; what is not a number
/// may not.
pub fn may_work_at(temperature_c: f32) -> bool {
    (LOWEST_C..=HIGHEST_C).contains(&temperature_c)
}

/// Reference of the converter while the factory read its codes, V.
const FACTORY_REFERENCE_V: f32 = 3.3;
/// Temperatures of the factory's calibration, degrees Celsius.
const FACTORY_LOW_C: f32 = 30.0;
const FACTORY_HIGH_C: f32 = 110.0;
/// An erased halfword.
const ERASED: u16 = 0xFFFF;

/// Codes the factory read with 3.3 V as the converter's reference, and left in
/// the part: 16-bit codes.
///
/// # Source
/// DS12110 Rev 11, tables 118 (VREFINT_CAL) and 181 (TS_CAL1, TS_CAL2).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FactoryCodes {
    /// Sensor at 30 degrees Celsius.
    pub at_30_c: u16,
    /// Sensor at 110 degrees Celsius.
    pub at_110_c: u16,
    /// Internal reference voltage.
    pub reference: u16,
}

/// The sensor of one part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Thermometer {
    codes: FactoryCodes,
}

impl Thermometer {
    /// The sensor of a part with these codes; `None` when they are no
    /// calibration.
    pub fn new(codes: FactoryCodes) -> Option<Self> {
        let erased = [codes.at_30_c, codes.at_110_c, codes.reference].contains(&ERASED);
        let plausible = codes.at_110_c > codes.at_30_c && codes.reference > 0 && !erased;
        plausible.then_some(Self { codes })
    }

    /// Temperature of the silicon, degrees Celsius, from codes of the sensor
    /// and of the internal reference read one after the other.
    ///
    /// # Equation
    /// `T = 30 + (110 - 30) (k s - s30) / (s110 - s30)` with `k = r_cal / r`:
    /// the reference voltage tells what the converter's own reference is, so a
    /// supply that is 1 % off does not make 3 K.
    ///
    /// # Accuracy
    /// Some kelvin, that of the sensor; the arithmetic is exact to 0.01 K: test
    /// `the_factory_points_and_a_point_by_hand`.
    ///
    /// # Source
    /// RM0433 Rev 9, sections 25.4.33 (temperature) and 25.4.35 (supply).
    pub fn temperature_c(&self, sensor: u16, reference: u16) -> Option<f32> {
        let FactoryCodes {
            at_30_c,
            at_110_c,
            reference: calibrated,
        } = self.codes;
        if reference == 0 {
            return None;
        }
        let seen = f32::from(sensor) * f32::from(calibrated) / f32::from(reference);
        let per_code = (FACTORY_HIGH_C - FACTORY_LOW_C) / f32::from(at_110_c - at_30_c);
        Some(FACTORY_LOW_C + (seen - f32::from(at_30_c)) * per_code)
    }

    /// Reference of the converters, which is their supply, V, from a code of the internal reference:
    /// `3.3 V r_cal / r`.
    ///
    /// # Source
    /// RM0433 Rev 9, section 25.4.35.
    pub fn supply_v(&self, reference: u16) -> Option<f32> {
        let calibrated = f32::from(self.codes.reference);
        (reference > 0).then(|| FACTORY_REFERENCE_V * calibrated / f32::from(reference))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// As read from a part: 2.5 mV/K.
    const CODES: FactoryCodes = FactoryCodes {
        at_30_c: 12_564,
        at_110_c: 16_576,
        reference: 24_150,
    };

    fn read(sensor: u16, reference: u16) -> f32 {
        let thermometer = Thermometer::new(CODES).expect("a calibration");
        let temperature_c = thermometer.temperature_c(sensor, reference);
        temperature_c.expect("a reference")
    }

    #[test]
    fn the_factory_points_and_a_point_by_hand() {
        assert_eq!(read(12_564, 24_150), 30.0);
        assert!((read(16_576, 24_150) - 110.0).abs() < 0.01);
        // By hand: 4012 codes are 80 K, 1003 are 20 K.
        assert!((read(13_567, 24_150) - 50.0).abs() < 0.01);
        assert!((read(11_561, 24_150) - 10.0).abs() < 0.01);
    }

    #[test]
    fn a_supply_that_is_off_changes_nothing() {
        // At 3.0 V both codes are 10 % higher: 13 567 becomes 14 923.7, whose
        // rounding is 0.3 codes, 0.006 K.
        assert!((read(14_924, 26_565) - 50.0).abs() < 0.01);
        // Without the reference it would be 77 degrees.
        assert!((read(14_924, 24_150) - 77.06).abs() < 0.01);
    }

    #[test]
    fn a_higher_code_of_the_reference_is_a_lower_supply() {
        let thermometer = Thermometer::new(CODES).expect("a calibration");
        assert_eq!(thermometer.supply_v(24_150), Some(3.3));
        let low_v = thermometer.supply_v(26_565).expect("a code");
        assert!((low_v - 3.0).abs() < 1e-4, "{low_v}");
        assert_eq!(thermometer.supply_v(0), None);
    }

    #[test]
    fn what_is_no_calibration_is_not_used() {
        let wrong: [fn(&mut FactoryCodes); 5] = [
            |codes| codes.at_30_c = 0xFFFF,
            |codes| codes.at_110_c = 0xFFFF,
            |codes| codes.reference = 0xFFFF,
            |codes| codes.reference = 0,
            |codes| codes.at_110_c = codes.at_30_c,
        ];
        for change in wrong {
            let mut codes = CODES;
            change(&mut codes);
            assert_eq!(Thermometer::new(codes), None, "{codes:?}");
        }
        let thermometer = Thermometer::new(CODES).expect("a calibration");
        assert_eq!(thermometer.temperature_c(12_564, 0), None);
    }

    #[test]
    fn the_range_ends_where_it_says() {
        for inside in [LOWEST_C, 0.0, 23.0, 48.0, HIGHEST_C] {
            assert!(may_work_at(inside), "{inside}");
        }
        for outside in [-10.1, 95.1, f32::NAN, f32::INFINITY] {
            assert!(!may_work_at(outside), "{outside}");
        }
    }
}
