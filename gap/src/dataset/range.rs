//! Values a cell of `points.csv` may hold.

/// Values a column can have: wide enough for every instrument, narrow enough to find a wrong unit or decimal mark.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Range {
    lowest: f64,
    highest: f64,
    positive: bool,
}

impl Range {
    /// From `lowest` to `highest`, both allowed.
    const fn between(lowest: f64, highest: f64) -> Self {
        Self {
            lowest,
            highest,
            positive: false,
        }
    }

    /// Above zero; as small and as large as an amplitude can be that some instrument measures.
    const fn amplitude() -> Self {
        Self {
            lowest: 1e-15,
            highest: 1e9,
            positive: true,
        }
    }

    /// Problem of a value, and the expected one; `None` if it is sound.
    pub(super) fn problem(self, value: f64) -> Option<String> {
        if self.positive && value <= 0.0 || self.lowest == 0.0 && value < 0.0 {
            return Some("must be positive".into());
        }
        let range = self.lowest..=self.highest;
        (!range.contains(&value)).then(|| {
            format!(
                "is out of the range of this column, {:e} to {:e}; check its unit",
                self.lowest, self.highest
            )
        })
    }
}

/// All columns with numbers, and what each may hold.
pub(super) fn columns() -> Vec<(String, Range)> {
    let amplitude = Range::amplitude();
    let angle = Range::between(-1e6, 1e6);
    let voltage = Range::between(-1e6, 1e6);
    let fixed = [
        ("frequency_hz", amplitude),
        ("time_s", Range::between(-1e10, 1e10)),
        ("temperature_c", Range::between(-273.15, 1e4)),
        ("rotation_deg", angle),
        ("tilt_deg", angle),
        ("payload_kg", Range::between(0.0, 1e6)),
        ("acceleration_ms2", amplitude),
        ("coil_v", amplitude),
        ("coil_a", amplitude),
        ("coil_a_deg", angle),
        ("ref_v", amplitude),
        ("ref_deg", angle),
        ("dut_v", amplitude),
        ("dut_deg", angle),
        ("ratio", amplitude),
        ("ref_dc_v", voltage),
        ("dut_dc_v", voltage),
        ("ref_noise_v", amplitude),
        ("dut_noise_v", amplitude),
        ("u_ratio", amplitude),
        ("u_phase_deg", amplitude),
        ("u_drive", amplitude),
        ("u_current", amplitude),
        ("u_harmonic", amplitude),
        ("u_dc_v", amplitude),
    ];
    let mut all: Vec<_> = fixed
        .into_iter()
        .map(|(name, range)| (name.to_owned(), range))
        .collect();
    for channel in ["ref", "dut"] {
        for order in 2..=5 {
            all.push((format!("{channel}_h{order}"), Range::between(0.0, 1e3)));
            all.push((format!("{channel}_h{order}_deg"), angle));
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    fn problem(column: &str, value: f64) -> Option<String> {
        let all = columns();
        let (_, range) = all.iter().find(|(name, _)| name == column).expect("column");
        range.problem(value)
    }

    #[test]
    fn a_value_no_instrument_has_is_named_and_all_others_pass() {
        for (column, value) in [
            ("temperature_c", -400.0),
            ("u_ratio", 1e-300),
            ("ref_dc_v", -1e300),
            ("payload_kg", -0.1),
            ("coil_v", 0.0),
        ] {
            assert!(problem(column, value).is_some(), "{column} {value}");
        }
        for (column, value) in [
            ("temperature_c", -196.0),
            ("ref_h3", 0.0),
            ("dut_deg", -720.0),
        ] {
            assert_eq!(problem(column, value), None, "{column}");
        }
    }
}
