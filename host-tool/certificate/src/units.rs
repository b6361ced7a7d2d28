//! Constants that turn one unit into another, and the units of a sensitivity.

use std::str::FromStr;

/// Standard acceleration of free fall, m/s2 (ISO 80000-3): a sensitivity per g over one per m/s2.
pub(crate) const STANDARD_GRAVITY_MS2: f64 = 9.806_65;

/// A unit that a sensitivity is specified and shown in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SensitivityUnit {
    /// Millivolt per metre per second squared.
    #[default]
    MillivoltPerMs2,
    /// Millivolt per standard acceleration of free fall.
    MillivoltPerG,
}

impl SensitivityUnit {
    /// Every unit there is.
    pub const ALL: [Self; 2] = [Self::MillivoltPerMs2, Self::MillivoltPerG];

    /// As it is typed and printed.
    pub fn name(self) -> &'static str {
        match self {
            Self::MillivoltPerMs2 => "mV/(m/s2)",
            Self::MillivoltPerG => "mV/g",
        }
    }

    /// A sensitivity in this unit, from V/(m/s2).
    pub fn of_v_per_ms2(self, sensitivity: f64) -> f64 {
        sensitivity * self.per_v_per_ms2()
    }

    /// A sensitivity in V/(m/s2), from this unit.
    pub fn to_v_per_ms2(self, sensitivity: f64) -> f64 {
        sensitivity / self.per_v_per_ms2()
    }

    fn per_v_per_ms2(self) -> f64 {
        match self {
            Self::MillivoltPerMs2 => 1000.0,
            Self::MillivoltPerG => 1000.0 * STANDARD_GRAVITY_MS2,
        }
    }
}

impl FromStr for SensitivityUnit {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, String> {
        let plain = name.trim().replace('\u{b2}', "2");
        let unit = Self::ALL.into_iter().find(|unit| unit.name() == plain);
        let known = Self::ALL.map(Self::name).join(", ");
        unit.ok_or_else(|| format!("no unit '{name}'; there are {known}"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_hundred_millivolt_per_g_is_ten_per_metre_per_second_squared() {
        // 100 / 9.80665 = 10.19716.
        let v_per_ms2 = SensitivityUnit::MillivoltPerG.to_v_per_ms2(100.0);
        assert!((v_per_ms2 - 0.010_197_16).abs() < 5e-9);
        for unit in SensitivityUnit::ALL {
            assert_eq!(unit.name().parse(), Ok(unit));
            let back = unit.of_v_per_ms2(unit.to_v_per_ms2(7.0));
            assert!((back - 7.0).abs() < 1e-12);
        }
        assert!("mV/ms2".parse::<SensitivityUnit>().is_err());
    }
}
