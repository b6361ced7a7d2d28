//! Template 25: accelerometers with constant current supply (IEPE).

use super::bits::Bits;
use super::error::TedsError;
use jiff::civil::Date;

/// The first 64 bits of every TEDS.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Basic {
    /// Number of the manufacturer, 17 to 16381, as the IEEE assigned it.
    pub manufacturer_id: u32,
    /// The manufacturer's number of the model.
    pub model_number: u32,
    /// Version of the model, a letter.
    pub version_letter: String,
    /// Version of the model, a number.
    pub version_number: u32,
    /// Serial number.
    pub serial_number: u32,
}

/// Accelerometer as template 25 states it.
#[derive(Clone, Debug, PartialEq)]
pub struct Accelerometer {
    /// The basic TEDS.
    pub basic: Basic,
    /// Sensitivity at reference conditions, V/(m/s2).
    pub sensitivity_v_per_ms2: Option<f64>,
    /// Lower cut-off frequency, Hz.
    pub high_pass_hz: Option<f64>,
    /// Sensitive direction: `x`, `y`, `z`.
    pub direction: Option<char>,
    /// Mass, kg.
    pub mass_kg: Option<f64>,
    /// True when a positive acceleration gives a negative voltage.
    pub inverted: bool,
    /// Upper cut-off frequency, Hz.
    pub low_pass_hz: Option<f64>,
    /// Resonance frequency, Hz.
    pub resonance_hz: Option<f64>,
    /// Quality factor of the resonance.
    pub quality_factor: Option<f64>,
    /// Slope of the response, percent per decade.
    pub slope_percent_per_decade: Option<f64>,
    /// Temperature coefficient, percent per kelvin.
    pub temperature_percent_per_k: Option<f64>,
    /// Reference frequency, Hz.
    pub reference_frequency_hz: Option<f64>,
    /// Reference temperature, degrees Celsius.
    pub reference_temperature_c: Option<f64>,
    /// Day of the last calibration.
    pub calibrated: Option<Date>,
    /// Who calibrated.
    pub initials: String,
    /// Days from one calibration to the next.
    pub period_days: Option<u32>,
    /// Number of the measuring point.
    pub location: u32,
}

impl Accelerometer {
    /// Day the next calibration is due.
    pub fn due(&self) -> Option<Date> {
        use jiff::ToSpan;
        let days = i64::from(self.period_days?).days();
        self.calibrated?.checked_add(days).ok()
    }
}

/// Reads basic TEDS and template 25.
///
/// # Errors
/// See [`TedsError`].
pub fn decode(bytes: &[u8]) -> Result<Accelerometer, TedsError> {
    let bits = &mut Bits::new(bytes);
    let basic = Basic {
        manufacturer_id: bits.number(14)?,
        model_number: bits.number(15)?,
        version_letter: bits.letters(1)?,
        version_number: bits.number(6)?,
        serial_number: bits.number(24)?,
    };
    if !(17..=16_381).contains(&basic.manufacturer_id) {
        return Err(TedsError::Manufacturer(basic.manufacturer_id));
    }
    if bits.number(2)? != 0 {
        return Err(TedsError::NoTemplate);
    }
    match bits.number(8)? {
        25 => accelerometer(basic, bits),
        other => Err(TedsError::Template(other)),
    }
}

/// The values in their order; a struct's fields are evaluated as they stand.
fn accelerometer(basic: Basic, bits: &mut Bits<'_>) -> Result<Accelerometer, TedsError> {
    if bits.flag()? {
        return Err(TedsError::Force);
    }
    if bits.flag()? {
        return Err(TedsError::Switchable);
    }
    let sensitivity_v_per_ms2 = bits.relative(16, 5e-7, 0.000_15)?;
    let high_pass_hz = bits.relative(8, 0.005, 0.03)?;
    let direction = ['x', 'y', 'z'].get(bits.number(2)? as usize).copied();
    let mass_kg = bits.relative(6, 0.1, 0.1)?.map(|gram| gram / 1000.0);
    let inverted = bits.flag()?;
    let response = match bits.flag()? {
        true => response(bits)?,
        false => [None; 5],
    };
    let [
        low_pass_hz,
        resonance_hz,
        quality_factor,
        slope_percent_per_decade,
        temperature_percent_per_k,
    ] = response;
    Ok(Accelerometer {
        basic,
        sensitivity_v_per_ms2,
        high_pass_hz,
        direction,
        mass_kg,
        inverted,
        low_pass_hz,
        resonance_hz,
        quality_factor,
        slope_percent_per_decade,
        temperature_percent_per_k,
        reference_frequency_hz: bits.relative(8, 0.35, 0.017_5)?,
        reference_temperature_c: bits.linear(5, 15.0, 0.5)?,
        calibrated: day(bits.number(16)?),
        initials: bits.letters(3)?,
        period_days: Some(bits.number(12)?).filter(|days| (1..4095).contains(days)),
        location: bits.number(11)?,
    })
}

/// Fields that follow when the response is stated.
fn response(bits: &mut Bits<'_>) -> Result<[Option<f64>; 5], TedsError> {
    Ok([
        bits.relative(7, 10.0, 0.05)?,
        bits.relative(9, 100.0, 0.01)?,
        bits.relative(9, 0.4, 0.01)?,
        bits.linear(7, -6.3, 0.1)?,
        bits.linear(6, -0.8, 0.025)?,
    ])
}

/// Days since 1998-01-01; all ones is "not stated".
fn day(days: u32) -> Option<Date> {
    use jiff::ToSpan;
    let known = (days != 0xFFFF).then(|| i64::from(days).days())?;
    jiff::civil::date(1998, 1, 1).checked_add(known).ok()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Values and their widths, lowest bit first, into bytes.
    fn pack(values: &[(u32, usize)]) -> Vec<u8> {
        let all = values
            .iter()
            .flat_map(|(value, bits)| (0..*bits).map(move |place| value >> place & 1));
        let all: Vec<u32> = all.collect();
        let byte = |bits: &[u32]| {
            let place = |(place, bit): (usize, &u32)| (*bit as u8) << place;
            bits.iter().enumerate().map(place).sum()
        };
        all.chunks(8).map(byte).collect()
    }

    const BASIC: [(u32, usize); 6] = [(21, 14), (4507, 15), (2, 5), (3, 6), (30_000, 24), (0, 2)];

    #[test]
    fn an_accelerometer_is_read() {
        // Sensitivity: code ln(0.01 / 5e-7) / ln(1.0003) = 33 016.6 -> 33 017.
        let rest = [
            (25, 8),
            (0, 1),
            (0, 1),
            (33_017, 16),
            (80, 8),
            (2, 2),
            (41, 6),
            (1, 1),
            (0, 1),
            (178, 8),
            (16, 5),
            (10_000, 16),
            (1 | 2 << 5 | 3 << 10, 15),
            (365, 12),
            (7, 11),
        ];
        let read = decode(&pack(&[&BASIC[..], &rest].concat())).expect("a TEDS");
        assert_eq!(read.basic.manufacturer_id, 21);
        assert_eq!(read.basic.model_number, 4507);
        assert_eq!(read.basic.version_letter, "B");
        assert_eq!(read.basic.serial_number, 30_000);
        // Half a step of the code is 0.015 %.
        let near = |value: Option<f64>, truth: f64, relative: f64| {
            assert!((value.expect("stated") / truth - 1.0).abs() < relative);
        };
        near(read.sensitivity_v_per_ms2, 0.01, 1.6e-4);
        // 0.005 * 1.06^80 = 0.5292; 0.1 * 1.2^41 = 176.4 g; 0.35 * 1.035^178 = 159.7.
        near(read.high_pass_hz, 0.5292, 1e-3);
        near(read.mass_kg, 0.1764, 1e-3);
        near(read.reference_frequency_hz, 159.7, 1e-2);
        assert_eq!(read.direction, Some('z'));
        assert!(read.inverted && read.low_pass_hz.is_none());
        assert_eq!(read.reference_temperature_c, Some(23.0));
        // 1998-01-01 and 10 000 days, by `date -d "1998-01-01 + 10000 days"`.
        assert_eq!(read.calibrated, Some(jiff::civil::date(2025, 5, 19)));
        assert_eq!(read.due(), Some(jiff::civil::date(2026, 5, 19)));
        assert_eq!((read.initials.as_str(), read.location), ("ABC", 7));
    }

    #[test]
    fn a_stated_response_shifts_what_follows() {
        let rest = [
            (25, 8),
            (0, 2),
            (0xFFFF, 16),
            (0xFF, 8),
            (3, 2),
            (63, 6),
            (0, 1),
            (1, 1),
            (0, 7),
            (0, 9),
            (511, 9),
            (63, 7),
            (32, 6),
            (0, 8),
            (31, 5),
            (0xFFFF, 16),
            (0, 15),
            (0, 12),
            (0, 11),
        ];
        let read = decode(&pack(&[&BASIC[..], &rest].concat())).expect("a TEDS");
        assert_eq!(read.sensitivity_v_per_ms2, None);
        assert_eq!((read.direction, read.mass_kg), (None, None));
        assert_eq!(read.low_pass_hz, Some(10.0));
        assert_eq!(read.resonance_hz, Some(100.0));
        assert_eq!(read.quality_factor, None);
        // -6.3 + 63 * 0.1 and -0.8 + 32 * 0.025, in f64.
        assert!(read.slope_percent_per_decade.expect("stated").abs() < 1e-12);
        assert!(read.temperature_percent_per_k.expect("stated").abs() < 1e-12);
        assert_eq!(read.reference_frequency_hz, Some(0.35));
        assert_eq!((read.calibrated, read.due()), (None, None));
    }

    #[test]
    fn what_is_no_accelerometer_is_named() {
        let with = |rest: &[(u32, usize)]| decode(&pack(&[&BASIC[..], rest].concat()));
        assert_eq!(with(&[(27, 8)]).err(), Some(TedsError::Template(27)));
        assert_eq!(with(&[(25, 8), (1, 1)]).err(), Some(TedsError::Force));
        assert_eq!(with(&[(25, 8), (2, 2)]).err(), Some(TedsError::Switchable));
        assert_eq!(with(&[(25, 8)]).err(), Some(TedsError::Short));
        assert_eq!(decode(&[0; 40]).err(), Some(TedsError::Manufacturer(0)));
    }

    proptest! {
        #[test]
        fn any_bytes_are_survived(bytes in prop::collection::vec(any::<u8>(), 0..64)) {
            let _ = decode(&bytes);
        }
    }
}
