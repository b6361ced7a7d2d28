//! The rows of Tables A.1 to A.4 of ISO 16063-21.
//!
//! A.1 and A.2 are for the sensitivity at calibration conditions (magnitude
//! and phase), A.3 and A.4 for the whole frequency and amplitude range, whose
//! first row is the result of A.1 or A.2.

/// Which table of Annex A.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Table {
    /// Magnitude at calibration conditions.
    A1,
    /// Phase shift at calibration conditions.
    A2,
    /// Magnitude over the complete frequency and amplitude range.
    A3,
    /// Phase shift over the complete frequency and amplitude range.
    A4,
}

/// One row of one table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Row {
    /// Table.
    pub table: Table,
    /// Number in the table, from 1.
    pub number: u8,
}

const A1: [&str; 18] = [
    "calibration of reference transducer and amplifier",
    "gain of conditioning amplifier",
    "voltage ratio",
    "harmonic distortion, on voltage ratio",
    "hum and noise, on voltage ratio",
    "transverse, rocking and bending motion",
    "base strain",
    "mounting: torque, cable, dummy mass",
    "relative motion of the transducers",
    "drift of the reference since its calibration",
    "temperature",
    "vibration frequency",
    "non-linearity of the transducers",
    "non-linearity of the amplifiers",
    "gravitation",
    "magnetic field of the exciter",
    "other influences of the environment",
    "residual: experimental standard deviation of the mean",
];

const A2: [&str; 17] = [
    "phase calibration of reference transducer and amplifier",
    "phase shift of conditioning amplifier",
    "phase measurement",
    "harmonic distortion, on phase",
    "hum and noise, on phase",
    "transverse, rocking and bending motion, on phase",
    "base strain, on phase",
    "mounting: torque, cable, dummy mass, on phase",
    "relative motion of the transducers, on phase",
    "phase drift of the reference since its calibration",
    "temperature, on phase",
    "non-linearity of the transducers, on phase",
    "non-linearity of the amplifiers, on phase",
    "gravitation, on phase",
    "magnetic field of the exciter, on phase",
    "other influences of the environment, on phase",
    "residual: experimental standard deviation of the mean phase",
];

const A3: [&str; 11] = [
    "sensitivity at calibration conditions (A.2.1)",
    "amplifier tracking between gain settings",
    "frequency response of the amplifier",
    "deviation of the transducer from its theoretical response",
    "amplitude dependence of the amplifier gain",
    "amplitude dependence of the transducer",
    "instability of the amplifier gain, source impedance",
    "instability of the transducer",
    "environment, on the amplifier gain",
    "environment, on the transducer",
    "mounting, on the transducer",
];

const A4: [&str; 11] = [
    "phase shift at calibration conditions (A.2.2)",
    "amplifier tracking between gain settings, on phase",
    "phase response of the amplifier",
    "deviation of the transducer from its theoretical phase",
    "amplitude dependence of the amplifier phase",
    "amplitude dependence of the transducer phase",
    "instability of the amplifier phase, source impedance",
    "instability of the transducer phase",
    "environment, on the amplifier phase",
    "environment, on the transducer phase",
    "mounting, on the transducer phase",
];

impl Table {
    /// What each row is about, in the table's order.
    pub fn sources(self) -> &'static [&'static str] {
        match self {
            Self::A1 => &A1,
            Self::A2 => &A2,
            Self::A3 => &A3,
            Self::A4 => &A4,
        }
    }

    /// Name as printed.
    pub fn name(self) -> &'static str {
        match self {
            Self::A1 => "A.1",
            Self::A2 => "A.2",
            Self::A3 => "A.3",
            Self::A4 => "A.4",
        }
    }
}

impl Row {
    /// Row of the magnitude at calibration conditions.
    pub const fn a1(number: u8) -> Self {
        Self {
            table: Table::A1,
            number,
        }
    }

    /// Row of the phase at calibration conditions.
    pub const fn a2(number: u8) -> Self {
        Self {
            table: Table::A2,
            number,
        }
    }

    /// The row of Table A.2 with the same source as this row of Table A.1.
    ///
    /// A.2 has no row for the vibration frequency (A.1 row 12) and counts one
    /// less from there on; a phase effect of the frequency goes to "other
    /// influences".
    pub const fn a2_from_a1(number: u8) -> Self {
        Self::a2(match number {
            0..=11 => number,
            12 => 16,
            _ => number - 1,
        })
    }

    /// What the row is about; "other" for a number the table does not have.
    pub fn source(self) -> &'static str {
        let index = usize::from(self.number).checked_sub(1);
        let sources = self.table.sources();
        index
            .and_then(|index| sources.get(index))
            .copied()
            .unwrap_or("other")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_of_magnitude_and_phase_name_the_same_source() {
        for number in (1..=18).filter(|number| *number != 12) {
            let (magnitude, phase) = (Row::a1(number), Row::a2_from_a1(number));
            let word = |row: Row| {
                let words = row.source().split([' ', ':', ',']);
                words
                    .filter(|word| !["phase", "of", "voltage", "gain", "shift"].contains(word))
                    .map(str::to_owned)
                    .next()
            };
            // Row 3 is "voltage ratio" in one and "phase measurement" in the other.
            if number != 3 {
                assert_eq!(word(magnitude), word(phase), "row {number}");
            }
        }
        assert_eq!(Row::a1(19).source(), "other");
        assert_eq!(Row::a1(0).source(), "other");
    }
}
