//! Amplitude linearity: how far the sensitivity goes with the level, where one frequency was measured at three levels
//! or more. U is that of the ratio, in which what both levels share cancels.

use super::budget::Basis;
use super::model::{Certificate, Entry, Point, Value};
use super::sections::RESULTS;
use calib_output::number::shortened;

/// Fewest levels that make a statement.
const FEWEST_LEVELS: usize = 3;

/// Adds what can be said.
pub(super) fn attach(certificate: &mut Certificate, basis: &Basis<'_>) {
    let valid: Vec<&Point> = certificate
        .points
        .iter()
        .filter(|point| point.outcome.is_ok())
        .collect();
    // The points are sorted by frequency.
    let frequencies = valid.chunk_by(|a, b| a.nominal_frequency_hz == b.nominal_frequency_hz);
    let stated: Vec<Value> = frequencies.filter_map(|levels| of(levels, basis)).collect();
    let mut sections = certificate.sections.iter_mut();
    let section = sections.find(|section| section.key == "calibration");
    if let (Some(section), false) = (section, stated.is_empty()) {
        section.entries.push(Entry {
            key: "linearity",
            clause: RESULTS,
            value: Some(Value::List(stated)),
        });
    }
}

/// Of the levels of a frequency, in rising order.
fn of(levels: &[&Point], basis: &Basis<'_>) -> Option<Value> {
    let [lowest, .., highest] = levels else {
        return None;
    };
    let base = levels.iter().copied().min_by(|a, b| {
        let octaves = |point: &Point| (point.nominal_acceleration_ms2 / BASE_MS2).log2().abs();
        octaves(a).total_cmp(&octaves(b))
    })?;
    let of_base = base.values()?.sensitivity;
    let deviation_percent = |point: &Point| {
        let sensitivity = point.values()?.sensitivity;
        Some(100.0 * (sensitivity / of_base - 1.0))
    };
    let others = levels.iter().filter(|point| !std::ptr::eq(**point, base));
    let deviating = others.filter_map(|point| Some((point, deviation_percent(point)?)));
    let (at, largest) = deviating.max_by(|(_, a), (_, b)| a.abs().total_cmp(&b.abs()))?;
    let expanded = basis.of_ratio(&at.measured, &base.measured)?.expanded_rel;
    let expanded_percent = 100.0 * (1.0 + largest / 100.0) * expanded;
    let kind = basis.kind;
    let level = |point: &Point| {
        let amplitude = kind.amplitude(point.nominal_acceleration_ms2, point.frequency_hz);
        // What was set of another motion has as many digits as anybody reads.
        let digits = if kind.steps() == 0 { 15 } else { 4 };
        Value::Exact(shortened(amplitude, digits), kind.amplitude_unit())
    };
    let percent = |value| Value::Number(value, 2, "%");
    (levels.len() >= FEWEST_LEVELS).then(|| {
        let values = vec![
            Value::Exact(base.nominal_frequency_hz, "Hz"),
            level(lowest),
            level(highest),
            level(base),
            percent(largest),
            level(at),
            percent(expanded_percent),
        ];
        Value::Phrase("linearity.value".to_owned(), values)
    })
}

/// The level others are compared with is the one nearest to this (ISO 16063-21, 5.3).
const BASE_MS2: f64 = 10.0;

#[cfg(test)]
mod tests {
    use super::super::model::Value;
    use super::super::{Certificate, Particulars};
    use calib_record::sample::{point, record};

    /// Levels and the sensitivity at each, relative to that at 10 m/s2.
    fn stated(levels: &[(f32, f32)]) -> Option<Vec<Value>> {
        let mut record = record(&[80.0]);
        record.points.clear();
        for &(acceleration_rms_ms2, relative) in levels {
            let mut measured = point(160.0);
            measured.spec.acceleration_rms_ms2 = acceleration_rms_ms2;
            measured.sensitivity_v_per_ms2 *= relative;
            record.points.push(measured).expect("room");
        }
        let certificate = Certificate::from_record(&record, &Particulars::default());
        let Some(Value::List(all)) = certificate.statement("calibration", "linearity") else {
            return None;
        };
        match &all[..] {
            [Value::Phrase(_, values)] => Some(values.clone()),
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn the_largest_deviation_from_the_usual_level_is_stated_with_u_of_the_ratio() {
        let levels = [(1.0, 1.0012), (2.0, 0.9995), (10.0, 1.0), (50.0, 0.9962)];
        let values = stated(&levels).expect("four levels");
        let level = |of| Value::Exact(of, "m/s²");
        assert_eq!(
            values[..4],
            [
                Value::Exact(160.0, "Hz"),
                level(1.0),
                level(50.0),
                level(10.0)
            ]
        );
        let Value::Number(largest, 2, "%") = values[4] else {
            panic!("{values:?}");
        };
        // f32 keeps 1e-7 of the sensitivities.
        assert!((largest + 0.38).abs() < 1e-4, "{largest}");
        assert_eq!(values[5], level(50.0));
        // What both levels share is more than half of U = 0.8 %.
        let Value::Number(expanded, 2, "%") = values[6] else {
            panic!("{values:?}");
        };
        assert!((0.02..0.6).contains(&expanded), "{expanded}");
    }

    #[test]
    fn two_levels_are_no_statement() {
        assert_eq!(stated(&[(1.0, 1.0), (10.0, 1.0)]), None);
        assert_eq!(stated(&[]), None);
    }
}
