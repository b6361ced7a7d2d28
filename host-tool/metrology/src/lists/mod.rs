//! Point lists by clause 5.
//!
//! # Source
//! ISO 16063-21:2003 5.1 and 5.3; ISO 266 for the frequencies.

use crate::input::HIGHEST_HZ;
use calib_core::preferred::{FEWEST_POINTS, REFERENCE_HZ, REFERENCE_MS2};
use calib_files::{Error, Result};
use calib_protocol::record::MAX_POINTS;
use schemars::JsonSchema;
use serde::Serialize;

/// One point to be measured.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ListPoint {
    /// Frequency, Hz.
    pub frequency_hz: f64,
    /// Acceleration, m/s2 r.m.s.
    #[serde(rename = "set_acceleration_rms_ms2")]
    pub acceleration_rms_ms2: f64,
}

/// Mantissas of the one-third-octave series of ISO 266.
const THIRD_OCTAVES: [f64; 10] = [1.0, 1.25, 1.6, 2.0, 2.5, 3.15, 4.0, 5.0, 6.3, 8.0];
/// Mantissas of the acceleration series of 5.1 a.
const LEVELS: [f64; 3] = [1.0, 2.0, 5.0];

/// A list over a frequency range: the reference point first, then the others
/// rising, `count` in all and evenly spread over the series.
///
/// # Errors
/// A range with fewer than six preferred frequencies, or fewer than six asked.
pub fn preferred(
    from_hz: f64,
    to_hz: f64,
    count: Option<usize>,
    acceleration_rms_ms2: f64,
) -> Result<Vec<ListPoint>> {
    possible(&[from_hz, to_hz], HIGHEST_HZ, "Hz")?;
    possible(&[acceleration_rms_ms2], HIGHEST_MS2, "m/s2")?;
    let series = series(&THIRD_OCTAVES, from_hz, to_hz);
    let wanted = count.unwrap_or(series.len());
    if series.len() < FEWEST_POINTS || wanted < FEWEST_POINTS || wanted > series.len() {
        return Err(Error::usage(
            format!(
                "{wanted} points of the {} preferred frequencies in {from_hz} .. {to_hz} Hz",
                series.len()
            ),
            format!("ask for {FEWEST_POINTS} or more (5.1), or widen the range"),
        ));
    }
    let last = (series.len() - 1) as f64;
    let mut chosen: Vec<f64> = (0..wanted)
        .map(|n| series[(n as f64 * last / (wanted - 1) as f64).round() as usize])
        .collect();
    if let Some(reference) = REFERENCE_HZ
        .map(f64::from)
        .into_iter()
        .find(|reference| series.contains(reference))
    {
        // The inner point nearest to the reference gives way to it.
        let nearest = (0..wanted)
            .min_by(|&a, &b| {
                let distance = |n: usize| (chosen[n] / reference).ln().abs();
                distance(a).total_cmp(&distance(b))
            })
            .unwrap_or(0);
        chosen.remove(nearest);
        chosen.insert(0, reference);
    }
    Ok(chosen
        .into_iter()
        .map(|frequency_hz| ListPoint {
            frequency_hz,
            acceleration_rms_ms2,
        })
        .collect())
}

/// A linearity list: one frequency, the levels 1, 2, 5 and their decades; the
/// reference level (100, else 10, 20 or 50 m/s2) first.
///
/// # Errors
/// A range with fewer than three levels.
pub fn linearity(frequency_hz: f64, from_ms2: f64, to_ms2: f64) -> Result<Vec<ListPoint>> {
    possible(&[frequency_hz], HIGHEST_HZ, "Hz")?;
    possible(&[from_ms2, to_ms2], HIGHEST_MS2, "m/s2")?;
    let mut levels = series(&LEVELS, from_ms2, to_ms2);
    if levels.len() < 3 {
        return Err(Error::usage(
            format!("{} levels in {from_ms2} .. {to_ms2} m/s2", levels.len()),
            "a line needs three levels of the series 1, 2, 5: widen the range",
        ));
    }
    let reference = REFERENCE_MS2
        .map(f64::from)
        .into_iter()
        .find(|level| levels.contains(level));
    if let Some(level) = reference {
        levels.retain(|other| *other != level);
        levels.insert(0, level);
    }
    Ok(levels
        .into_iter()
        .map(|acceleration_rms_ms2| ListPoint {
            frequency_hz,
            acceleration_rms_ms2,
        })
        .collect())
}

/// Beyond this no exciter goes.
const HIGHEST_MS2: f64 = 100_000.0;

/// Refuses what is no frequency, or no level.
fn possible(values: &[f64], highest: f64, unit: &str) -> Result<()> {
    let wrong = values
        .iter()
        .find(|value| !(**value > 0.0 && **value <= highest));
    wrong.map_or(Ok(()), |value| {
        Err(Error::usage(
            format!("{value} {unit}: no exciter does that"),
            format!("above zero, up to {highest} {unit}"),
        ))
    })
}

/// A list for a search of resonances: the reference point, then `per_octave` points an octave, rising, to five digits.
///
/// # Errors
/// A range that is none, fewer than twelve points an octave, in which a certificate sees no search, or more points than
/// a run has room for.
pub fn resonance(
    from_hz: f64,
    to_hz: f64,
    per_octave: u32,
    acceleration_rms_ms2: f64,
) -> Result<Vec<ListPoint>> {
    possible(&[from_hz, to_hz], HIGHEST_HZ, "Hz")?;
    possible(&[acceleration_rms_ms2], HIGHEST_MS2, "m/s2")?;
    let octaves = (to_hz / from_hz).log2();
    let steps = (octaves * f64::from(per_octave)).round();
    let problem = match () {
        () if octaves < 1.0 => format!("{from_hz} .. {to_hz} Hz is no octave"),
        () if per_octave < 12 => format!("{per_octave} points an octave find no resonance"),
        () if steps + 2.0 > MAX_POINTS as f64 => {
            format!("{} points are more than a run has room for", steps + 2.0)
        }
        () => {
            let at = |n: u32| from_hz * (to_hz / from_hz).powf(f64::from(n) / steps);
            let digits = |hz: f64| 10.0_f64.powf(4.0 - hz.log10().floor());
            let rounded = |hz: f64| (hz * digits(hz)).round() / digits(hz);
            let searched = (0..=steps as u32).map(|n| rounded(at(n)));
            let preferred_hz = f64::from(REFERENCE_HZ[0]);
            let reference = std::iter::once(preferred_hz);
            let others = searched.filter(|hz| *hz != preferred_hz);
            let point = |frequency_hz| ListPoint {
                frequency_hz,
                acceleration_rms_ms2,
            };
            return Ok(reference.chain(others).map(point).collect());
        }
    };
    Err(Error::usage(
        problem,
        format!("twelve points an octave or more, over an octave or more, {MAX_POINTS} in all"),
    ))
}

/// Members of a decimal series in a range, rising.
fn series(mantissas: &[f64], from: f64, to: f64) -> Vec<f64> {
    (-2..=5)
        .flat_map(|decade| {
            mantissas.iter().map(move |mantissa| {
                // Written and read again: 3.15e1 is then exactly 31.5.
                format!("{mantissa}e{decade}").parse().unwrap_or(f64::NAN)
            })
        })
        .filter(|value: &f64| *value >= from * (1.0 - 1e-9) && *value <= to * (1.0 + 1e-9))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A list of minus ten or infinitely many m/s2 was written as it was asked for.
    #[test]
    fn what_no_exciter_does_is_in_no_list() {
        for wrong in [-1.0, 0.0, f64::NAN, f64::INFINITY, 1e9] {
            assert!(preferred(20.0, 5000.0, None, wrong).is_err(), "{wrong}");
            assert!(preferred(wrong, 5000.0, None, 10.0).is_err(), "{wrong}");
            assert!(preferred(20.0, wrong, None, 10.0).is_err(), "{wrong}");
            assert!(linearity(wrong, 1.0, 50.0).is_err(), "{wrong}");
            assert!(linearity(160.0, wrong, 50.0).is_err(), "{wrong}");
            assert!(linearity(160.0, 1.0, wrong).is_err(), "{wrong}");
        }
    }

    /// 24 an octave over three octaves are 73, and the reference point; neighbours are 2^(1/24) = 1.0293 apart.
    #[test]
    fn a_search_has_as_many_points_an_octave_as_asked_for() {
        let list = resonance(1000.0, 8000.0, 24, 10.0).expect("list");
        let f: Vec<f64> = list.iter().map(|point| point.frequency_hz).collect();
        assert_eq!((f.len(), f[0], f[1], f[73]), (74, 160.0, 1000.0, 8000.0));
        for pair in f[1..].windows(2) {
            assert!((pair[1] / pair[0] - 1.029_302).abs() < 1e-4, "{pair:?}");
        }
        for (from, to, per_octave, acceleration) in [
            (1000.0, 1500.0, 24, 10.0),
            (8000.0, 1000.0, 24, 10.0),
            (0.0, 1000.0, 24, 10.0),
            (-1.0, 1000.0, 24, 10.0),
            (f64::NAN, 1000.0, 24, 10.0),
            (1000.0, f64::INFINITY, 24, 10.0),
            (1000.0, 8000.0, 11, 10.0),
            (20.0, 10_000.0, 24, 10.0),
            (1000.0, 8000.0, 24, 0.0),
            (1000.0, 8000.0, 24, f64::NAN),
        ] {
            let refused = resonance(from, to, per_octave, acceleration);
            assert!(refused.is_err(), "{from} {to} {per_octave} {acceleration}");
        }
    }

    #[test]
    fn six_points_cover_the_range_and_begin_with_the_reference() {
        let list = preferred(20.0, 5000.0, Some(6), 100.0).expect("list");
        let f: Vec<f64> = list.iter().map(|point| point.frequency_hz).collect();
        assert_eq!(f[0], 160.0);
        assert_eq!((f[1], f[5]), (20.0, 5000.0));
        assert!(f[1..].windows(2).all(|pair| pair[0] < pair[1]));
        // Evenly: 24 steps in five parts are 4 or 5 steps, up to 10^0.5 = 3.2;
        // the reference stands within one step of its place.
        let mut sorted = f.clone();
        sorted.sort_by(f64::total_cmp);
        assert!(
            sorted.windows(2).all(|pair| pair[1] / pair[0] < 4.1),
            "{f:?}"
        );
        assert_eq!(preferred(20.0, 5000.0, None, 10.0).expect("list").len(), 25);
        assert!(preferred(100.0, 125.0, None, 10.0).is_err());
        assert!(preferred(20.0, 5000.0, Some(5), 10.0).is_err());
    }

    #[test]
    fn a_linearity_list_begins_with_its_reference_level() {
        let list = linearity(160.0, 1.0, 200.0).expect("list");
        let levels: Vec<f64> = list.iter().map(|p| p.acceleration_rms_ms2).collect();
        assert_eq!(levels, [100.0, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 200.0]);
    }
}
