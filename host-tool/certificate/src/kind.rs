//! Kinds of sensors: what a sensitivity is one of, in which unit, and what stands between sensor and input.
//!
//! The instrument measures volts per m/s2 against acceleration. A certificate states the sensitivity of the sensor, in
//! the SI unit of its kind:
//!
//! # Equation
//! `S = S_V (j w)^n / g`: n is 0 for acceleration, 1 for velocity, 2 for displacement, and g the gain of a charge
//! amplifier in V/C, the burden of a current in V/A, else 1. This file alone does it, by [`calib_core::quantity`].
//!
//! # Source
//! ISO 16063-21:2003, clause 6.

use calib_core::quantity::MotionQuantity;
use calib_output::number::decimal;
use schemars::JsonSchema;
use serde::{Deserialize, Deserializer, Serialize};
use std::f64::consts::TAU;
use std::fmt;
use std::str::FromStr;

/// Standard acceleration of free fall, m/s2 (ISO 80000-3): a sensitivity per g over one per m/s2.
pub(crate) const STANDARD_GRAVITY_MS2: f64 = 9.806_65;

/// Output of a sensor.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Output {
    /// A voltage, read as it is.
    Voltage,
    /// A charge, read through a charge amplifier.
    Charge,
    /// A current, read through a burden.
    Current,
}

/// A unit that a sensitivity is specified and shown in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SensitivityUnit {
    /// Millivolt per metre per second squared.
    #[default]
    MillivoltPerMs2,
    /// Millivolt per standard acceleration of free fall.
    MillivoltPerG,
    /// Millivolt per millimetre per second.
    MillivoltPerMmPerS,
    /// Millivolt per micrometre.
    MillivoltPerUm,
    /// Picocoulomb per metre per second squared.
    PicocoulombPerMs2,
    /// Picocoulomb per standard acceleration of free fall.
    PicocoulombPerG,
    /// Milliampere per metre per second squared.
    MilliamperePerMs2,
    /// Milliampere per standard acceleration of free fall.
    MilliamperePerG,
    /// Milliampere per millimetre per second.
    MilliamperePerMmPerS,
    /// Milliampere per micrometre.
    MilliamperePerUm,
}

use MotionQuantity::{Acceleration, Displacement, Velocity};
use SensitivityUnit::*;

/// Facts about a unit.
struct Form {
    /// As it is typed.
    name: &'static str,
    /// As it is printed.
    printed: &'static str,
    /// In headings of CSV.
    slug: &'static str,
    /// In D-SI, of the same size; none where there is no such unit.
    d_si: Option<&'static str>,
    output: Output,
    quantity: MotionQuantity,
    /// This unit in one SI unit of its kind: mV/(m/s2) in V/(m/s2).
    per_si: f64,
}

impl SensitivityUnit {
    /// Every unit there is.
    pub const ALL: [Self; 10] = [
        MillivoltPerMs2,
        MillivoltPerG,
        MillivoltPerMmPerS,
        MillivoltPerUm,
        PicocoulombPerMs2,
        PicocoulombPerG,
        MilliamperePerMs2,
        MilliamperePerG,
        MilliamperePerMmPerS,
        MilliamperePerUm,
    ];

    #[rustfmt::skip]
    const fn form(self) -> Form {
        const fn form(
            name: &'static str, printed: &'static str, slug: &'static str, d_si: Option<&'static str>,
            output: Output, quantity: MotionQuantity, per_si: f64,
        ) -> Form {
            Form { name, printed, slug, d_si, output, quantity, per_si }
        }
        const G: f64 = STANDARD_GRAVITY_MS2;
        use Output::{Charge, Current, Voltage};
        match self {
            MillivoltPerMs2 => form("mV/(m/s2)", "mV/(m/s²)", "mv_per_ms2",
                Some(r"\milli\volt\metre\tothe{-1}\second\tothe{2}"), Voltage, Acceleration, 1e3),
            MillivoltPerG => form("mV/g", "mV/g", "mv_per_g", None, Voltage, Acceleration, 1e3 * G),
            MillivoltPerMmPerS => form("mV/(mm/s)", "mV/(mm/s)", "mv_per_mm_per_s",
                Some(r"\volt\metre\tothe{-1}\second"), Voltage, Velocity, 1.0),
            MillivoltPerUm => form("mV/um", "mV/µm", "mv_per_um",
                Some(r"\kilo\volt\metre\tothe{-1}"), Voltage, Displacement, 1e-3),
            PicocoulombPerMs2 => form("pC/(m/s2)", "pC/(m/s²)", "pc_per_ms2",
                Some(r"\pico\coulomb\metre\tothe{-1}\second\tothe{2}"), Charge, Acceleration, 1e12),
            PicocoulombPerG => form("pC/g", "pC/g", "pc_per_g", None, Charge, Acceleration, 1e12 * G),
            MilliamperePerMs2 => form("mA/(m/s2)", "mA/(m/s²)", "ma_per_ms2",
                Some(r"\milli\ampere\metre\tothe{-1}\second\tothe{2}"), Current, Acceleration, 1e3),
            MilliamperePerG => form("mA/g", "mA/g", "ma_per_g", None, Current, Acceleration, 1e3 * G),
            MilliamperePerMmPerS => form("mA/(mm/s)", "mA/(mm/s)", "ma_per_mm_per_s",
                Some(r"\ampere\metre\tothe{-1}\second"), Current, Velocity, 1.0),
            MilliamperePerUm => form("mA/um", "mA/µm", "ma_per_um",
                Some(r"\kilo\ampere\metre\tothe{-1}"), Current, Displacement, 1e-3),
        }
    }

    /// As it is typed.
    pub fn name(self) -> &'static str {
        self.form().name
    }

    /// As it is printed.
    pub fn printed(self) -> &'static str {
        self.form().printed
    }

    /// In headings of CSV.
    pub(crate) fn slug(self) -> &'static str {
        self.form().slug
    }

    /// In D-SI, of the same size.
    pub(crate) fn d_si(self) -> Option<&'static str> {
        self.form().d_si
    }

    /// Output of the sensor.
    pub fn output(self) -> Output {
        self.form().output
    }

    /// The motion it is a sensitivity to.
    pub fn quantity(self) -> MotionQuantity {
        self.form().quantity
    }

    /// A sensitivity in this unit, from the SI unit of its kind.
    pub fn of_si(self, sensitivity: f64) -> f64 {
        sensitivity * self.form().per_si
    }

    /// A sensitivity in the SI unit of its kind, from this unit.
    pub fn to_si(self, sensitivity: f64) -> f64 {
        sensitivity / self.form().per_si
    }

    /// A unit of the same sensitivity, of another size.
    fn is_alike(self, other: Self) -> bool {
        (self.output(), self.quantity()) == (other.output(), other.quantity())
    }

    /// The unit that certificates state: that of SI among those that are alike.
    fn stated(self) -> Self {
        let alike = |unit: &Self| self.is_alike(*unit) && unit.d_si().is_some();
        Self::ALL.into_iter().find(alike).unwrap_or(self)
    }

    /// The unit per standard acceleration of free fall beside it.
    fn per_g(self) -> Option<Self> {
        let alike = |unit: &Self| self.is_alike(*unit) && unit.d_si().is_none();
        Self::ALL.into_iter().find(alike)
    }
}

impl FromStr for SensitivityUnit {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, String> {
        let plain = name.trim().replace('\u{b2}', "2").replace(['µ', 'μ'], "u");
        let unit = Self::ALL.into_iter().find(|unit| unit.name() == plain);
        let known = Self::ALL.map(Self::name).join(", ");
        unit.ok_or_else(|| format!("no unit '{name}'; there are {known}"))
    }
}

/// A sensitivity as it is specified: `4 mV/(mm/s)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Specified {
    /// In the SI unit of its kind.
    pub si: f64,
    /// Unit it is specified in.
    pub unit: SensitivityUnit,
}

impl Specified {
    /// So many of this unit.
    pub fn new(in_unit: f64, unit: SensitivityUnit) -> Self {
        Self::of_si(unit.to_si(in_unit), unit)
    }

    /// So many of the SI unit, specified in this one.
    pub fn of_si(si: f64, unit: SensitivityUnit) -> Self {
        Self { si, unit }
    }
}

impl FromStr for Specified {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let parts = text.trim().split_once(' ');
        let number = parts.and_then(|(number, unit)| Some((number.parse().ok()?, unit)));
        match number {
            Some((number, unit)) => Ok(Self::new(number, unit.parse()?)),
            None => Err(format!("'{text}' is no sensitivity; such is 4 mV/(mm/s)")),
        }
    }
}

/// The part between a sensor and the input: a charge amplifier, or a burden.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Conditioner {
    /// mV/pC, or ohm.
    value: f64,
    /// Its expanded uncertainty (k = 2), %.
    expanded_percent: f64,
}

/// The kind of a sensor; its text is what a logbook keeps.
///
/// ```text
/// mV/g                            an accelerometer with a voltage
/// mV/(mm/s)                       a velocity transducer
/// mV/um                           a displacement transducer
/// pC/g at 10 mV/pC +-0.5%         a charge transducer, its amplifier's gain and U (k = 2) of that
/// mA/(mm/s) at 250 ohm +-0.1%     a transmitter, its burden
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SensorKind {
    unit: SensitivityUnit,
    conditioner: Option<Conditioner>,
}

/// The sensitivity of a sensor at one point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OfSensor {
    /// Magnitude, SI unit of the kind.
    pub magnitude: f64,
    /// Phase against the motion of the kind, degrees; polarity is apart.
    pub phase_deg: f64,
}

impl SensorKind {
    /// The kind that is specified in this unit, without anything before the input.
    ///
    /// # Errors
    /// The text of what is missing, for a charge or a current.
    pub fn of_unit(unit: SensitivityUnit) -> Result<Self, String> {
        unit.name().parse()
    }

    /// Unit it is specified and shown in.
    pub fn unit(self) -> SensitivityUnit {
        self.unit
    }

    /// The motion its sensitivity is one to.
    pub fn quantity(self) -> MotionQuantity {
        self.unit.quantity()
    }

    /// The motion in words, as programs read it.
    pub fn quantity_name(self) -> &'static str {
        match self.quantity() {
            Acceleration => "acceleration",
            Velocity => "velocity",
            Displacement => "displacement",
        }
    }

    /// Whether the instrument measures it without any conversion: volts and acceleration.
    pub fn is_as_measured(self) -> bool {
        self.unit.is_alike(SensitivityUnit::default())
    }

    /// A transmitter, read through a burden: reported only.
    pub fn is_reported_only(self) -> bool {
        self.unit.output() == Output::Current
    }

    /// This sensor with another unit for what is shown.
    ///
    /// # Errors
    /// Why it cannot be shown in it.
    pub fn shown_in(self, unit: SensitivityUnit) -> Result<Self, String> {
        match self.unit.is_alike(unit) {
            true => Ok(Self { unit, ..self }),
            false => Err(format!(
                "{} is no unit of a sensor that is specified in {}",
                unit.name(),
                self.unit.name()
            )),
        }
    }

    /// Unit that certificates state.
    pub fn stated_unit(self) -> SensitivityUnit {
        self.unit.stated()
    }

    /// Unit per standard acceleration of free fall beside it.
    pub(crate) fn per_g_unit(self) -> Option<SensitivityUnit> {
        self.unit.per_g()
    }

    /// Gain of a charge amplifier in V/C or the burden in V/A; 1 without any.
    fn gain(self) -> f64 {
        let value = self
            .conditioner
            .map_or(1.0, |conditioner| conditioner.value);
        match self.unit.output() {
            Output::Voltage | Output::Current => value,
            // mV/pC.
            Output::Charge => 1.0e9 * value,
        }
    }

    /// Relative expanded uncertainty (k = 2) of gain or burden, which enters every result.
    pub(crate) fn expanded_rel_of_gain(self) -> Option<f64> {
        Some(self.conditioner?.expanded_percent / 100.0)
    }

    /// Gain of a charge amplifier, mV/pC, or burden, ohm, and its expanded uncertainty (k = 2), %.
    pub(crate) fn gain_and_expanded_percent(self) -> Option<(f64, f64)> {
        let stands = self.conditioner?;
        Some((stands.value, stands.expanded_percent))
    }

    /// Gain or burden and its U in words.
    pub(crate) fn conditioner_words(self) -> Option<String> {
        let stands = self.conditioner?;
        let unit = conditioner_unit(self.unit.output())?;
        Some(format!(
            "{} {unit} \u{b1}{} % (k = 2)",
            stands.value, stands.expanded_percent
        ))
    }

    /// How often the motion was differentiated less than acceleration.
    pub(crate) fn steps(self) -> i32 {
        match self.quantity() {
            Acceleration => 0,
            Velocity => 1,
            Displacement => 2,
        }
    }

    /// A sensitivity in the SI unit of the kind, from V/(m/s2) of the whole chain at a frequency.
    pub fn of_v_per_ms2(self, v_per_ms2: f64, frequency_hz: f64) -> f64 {
        match self.is_as_measured() {
            true => v_per_ms2,
            false => v_per_ms2 * (TAU * frequency_hz).powi(self.steps()) / self.gain(),
        }
    }

    /// V/(m/s2) of the whole chain at a frequency, from a sensitivity in the SI unit of the kind.
    pub fn to_v_per_ms2(self, sensitivity: f64, frequency_hz: f64) -> f64 {
        sensitivity / self.of_v_per_ms2(1.0, frequency_hz)
    }

    /// Motion of the kind in the unit its size is stated in, from an acceleration, m/s2: m/s2, mm/s or um, both r.m.s. or
    /// both peak.
    pub fn amplitude(self, acceleration_ms2: f64, frequency_hz: f64) -> f64 {
        let scale = match self.quantity() {
            Acceleration => 1.0,
            Velocity => 1.0e3,
            Displacement => 1.0e6,
        };
        // In the digits of the level it is made of.
        decimal((scale * acceleration_ms2 / (TAU * frequency_hz).powi(self.steps())) as f32)
    }

    /// Unit of [`Self::amplitude`], as printed.
    pub fn amplitude_unit(self) -> &'static str {
        match self.quantity() {
            Acceleration => "m/s²",
            Velocity => "mm/s",
            Displacement => "µm",
        }
    }

    /// The motion of the kind as headings name it, where it is no acceleration.
    pub(crate) fn amplitude_slug(self) -> Option<&'static str> {
        match self.quantity() {
            Acceleration => None,
            Velocity => Some("velocity_rms_mm_per_s"),
            Displacement => Some("displacement_rms_um"),
        }
    }
}

fn conditioner_unit(output: Output) -> Option<&'static str> {
    match output {
        Output::Voltage => None,
        Output::Charge => Some("mV/pC"),
        Output::Current => Some("ohm"),
    }
}

impl FromStr for SensorKind {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (unit, before) = match text.split_once(" at ") {
            Some((unit, before)) => (unit, Some(before)),
            None => (text, None),
        };
        let unit: SensitivityUnit = unit.parse()?;
        let conditioner = match (conditioner_unit(unit.output()), before) {
            (None, None) => None,
            (None, Some(_)) => {
                return Err(format!("{} is read without anything between", unit.name()));
            }
            (Some(of), stated) => {
                Some(conditioner(stated.unwrap_or_default(), of).ok_or_else(|| {
                    let (what, such) = match unit.output() {
                        Output::Charge => ("gain of its charge amplifier", "10 mV/pC +-0.5%"),
                        _ => ("burden", "250 ohm +-0.1%"),
                    };
                    format!(
                        "{} needs the {what} with its expanded uncertainty: '{} at {such}'",
                        unit.name(),
                        unit.name()
                    )
                })?)
            }
        };
        Ok(Self { unit, conditioner })
    }
}

/// `10 mV/pC +-0.5%`.
fn conditioner(text: &str, unit: &str) -> Option<Conditioner> {
    let (value, expanded) = text
        .split_once("+-")
        .or_else(|| text.split_once('\u{b1}'))?;
    let number = |text: &str| text.trim().parse::<f64>().ok();
    let stands = Conditioner {
        value: number(value.trim().strip_suffix(unit)?)?,
        expanded_percent: number(expanded.trim().trim_end_matches('%'))?,
    };
    let usable = stands.value.is_finite() && stands.value > 0.0;
    (usable && (0.0..=20.0).contains(&stands.expanded_percent)).then_some(stands)
}

impl fmt::Display for SensorKind {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.unit.name())?;
        match (self.conditioner, conditioner_unit(self.unit.output())) {
            (Some(stands), Some(unit)) => write!(
                formatter,
                " at {} {unit} +-{}%",
                stands.value, stands.expanded_percent
            ),
            _ => Ok(()),
        }
    }
}

impl<'de> Deserialize<'de> for SensorKind {
    fn deserialize<D: Deserializer<'de>>(stated: D) -> Result<Self, D::Error> {
        let text = String::deserialize(stated)?;
        text.parse().map_err(serde::de::Error::custom)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn kind(text: &str) -> SensorKind {
        text.parse().expect(text)
    }

    #[test]
    fn a_hundred_millivolt_per_g_is_ten_per_metre_per_second_squared() {
        // 100 / 9.80665 = 10.19716.
        let v_per_ms2 = MillivoltPerG.to_si(100.0);
        assert!((v_per_ms2 - 0.010_197_16).abs() < 5e-9);
        for unit in SensitivityUnit::ALL {
            assert_eq!(unit.name().parse(), Ok(unit));
            assert_eq!(unit.printed().parse(), Ok(unit));
            let back = unit.of_si(unit.to_si(7.0));
            assert!((back - 7.0).abs() < 1e-12);
        }
        assert!("mV/ms2".parse::<SensitivityUnit>().is_err());
    }

    #[test]
    fn what_is_written_is_read_again_and_what_is_missing_is_named() {
        for text in [
            "mV/g",
            "mV/(mm/s)",
            "mV/um",
            "pC/g at 10 mV/pC +-0.5%",
            "mA/(mm/s) at 250 ohm +-0.1%",
        ] {
            assert_eq!(kind(text).to_string(), text);
        }
        for (text, names) in [
            ("pC/g", "charge amplifier"),
            ("pC/g at 10 ohm +-1%", "charge amplifier"),
            ("pC/g at 10 mV/pC", "expanded uncertainty"),
            ("pC/g at 0 mV/pC +-1%", "charge amplifier"),
            ("pC/g at -1 mV/pC +-1%", "charge amplifier"),
            ("pC/g at 1e999 mV/pC +-1%", "charge amplifier"),
            ("pC/g at 1 mV/pC +-NaN%", "charge amplifier"),
            ("mA/g", "burden"),
            ("mV/g at 10 mV/pC +-1%", "without anything between"),
            ("mV/furlong", "there are mV/(m/s2)"),
        ] {
            let problem = text.parse::<SensorKind>().expect_err(text);
            assert!(problem.contains(names), "{text}: {problem}");
        }
    }

    /// By hand, 0.01 V/(m/s2) at 160 Hz, w = 1005.30965 rad/s: 10.0530965 mV/(mm/s), 10.1064747 mV/um;
    /// through 10 mV/pC 1 pC/(m/s2) and 9.80665 pC/g; over 250 ohm 0.04 mA/(m/s2).
    #[test]
    fn one_chain_in_every_unit() {
        for (text, expected) in [
            ("mV/(m/s2)", 10.0),
            ("mV/g", 98.0665),
            ("mV/(mm/s)", 10.053_096_5),
            ("mV/um", 10.106_474_9),
            ("pC/(m/s2) at 10 mV/pC +-1%", 1.0),
            ("pC/g at 10 mV/pC +-1%", 9.806_65),
            ("mA/(m/s2) at 250 ohm +-1%", 0.04),
            ("mA/(mm/s) at 250 ohm +-1%", 0.040_212_386),
        ] {
            let kind = kind(text);
            let found = kind.unit().of_si(kind.of_v_per_ms2(0.01, 160.0));
            assert!((found / expected - 1.0).abs() < 1e-8, "{text}: {found}");
            let back = kind.to_v_per_ms2(kind.unit().to_si(expected), 160.0);
            assert!((back / 0.01 - 1.0).abs() < 1e-8, "{text}: {back}");
        }
    }
}
