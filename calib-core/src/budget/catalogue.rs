//! The rows of Tables A.1 to A.4 of ISO 16063-21.
//!
//! A.1 and A.2 are for the sensitivity at calibration conditions (magnitude
//! and phase), A.3 and A.4 for the whole frequency and amplitude range, whose
//! first row is the result of A.1 or A.2. These words are the English ones of every
//! output; translations name them by table and number.

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
    "Calibration of the reference transducer with its amplifier",
    "Gain of the conditioning amplifier",
    "Measurement of the voltage ratio",
    "Harmonic distortion",
    "Hum and noise",
    "Transverse, rocking and bending motion",
    "Base strain",
    "Mounting: torque, cable, mass",
    "Relative motion",
    "Stability of the reference over time",
    "Temperature",
    "Frequency",
    "Non-linearity of the transducers",
    "Non-linearity of the amplifiers",
    "Gravity",
    "Magnetic field of the exciter",
    "Other influences of the environment",
    "Residual effects: repeatability of the measurement",
];

const A2: [&str; 17] = [
    "Phase calibration of the reference transducer with its amplifier",
    "Phase shift of the conditioning amplifier",
    "Measurement of the phase",
    "Harmonic distortion, on phase",
    "Hum and noise, on phase",
    "Transverse, rocking and bending motion, on phase",
    "Base strain, on phase",
    "Mounting: torque, cable, mass, on phase",
    "Relative motion, on phase",
    "Phase stability of the reference over time",
    "Temperature, on phase",
    "Non-linearity of the transducers, on phase",
    "Non-linearity of the amplifiers, on phase",
    "Gravity, on phase",
    "Magnetic field of the exciter, on phase",
    "Other influences of the environment, on phase",
    "Residual effects: repeatability of the phase",
];

const A3: [&str; 11] = [
    "Sensitivity at calibration conditions (A.2.1)",
    "Amplifier tracking between gain settings",
    "Frequency response of the amplifier",
    "Deviation of the transducer from its theoretical response",
    "Amplitude dependence of the amplifier gain",
    "Amplitude dependence of the transducer",
    "Instability of the amplifier gain, source impedance",
    "Instability of the transducer",
    "Environment, on the amplifier gain",
    "Environment, on the transducer",
    "Mounting, on the transducer",
];

const A4: [&str; 11] = [
    "Phase shift at calibration conditions (A.2.2)",
    "Amplifier tracking between gain settings, on phase",
    "Phase response of the amplifier",
    "Deviation of the transducer from its theoretical phase",
    "Amplitude dependence of the amplifier phase",
    "Amplitude dependence of the transducer phase",
    "Instability of the amplifier phase, source impedance",
    "Instability of the transducer phase",
    "Environment, on the amplifier phase",
    "Environment, on the transducer phase",
    "Mounting, on the transducer phase",
];

impl Table {
    /// Subject of each row, in the table's order.
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

    /// Subject of the row; "other" for a number the table does not have.
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
                let words = row.source().to_lowercase();
                let kept = |word: &&str| !["phase", "of", "gain", "shift"].contains(word);
                words.split([' ', ':', ',']).find(kept).map(str::to_owned)
            };
            assert_eq!(word(magnitude), word(phase), "row {number}");
        }
        assert_eq!(Row::a1(19).source(), "other");
        assert_eq!(Row::a1(0).source(), "other");
    }
}
