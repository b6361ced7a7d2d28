//! Search for resonances: what a dense list of points shows, where one was measured.
//!
//! A search is a run of valid points of one level, at most a twelfth of an octave apart, over an octave or more. A
//! resonance is a maximum that stands above the response on both of its sides by more than U of that ratio, in which
//! what the points share cancels; it lies between the points beside the largest. Where the response rises to the end of
//! the range it may have one beyond, of which the [mounted resonance](super::resonance) says more.

use super::budget::Basis;
use super::model::{Certificate, Entry, Point, Value};

/// Largest ratio of neighbouring frequencies, a twelfth of an octave and what rounding of a list adds.
const STEP: f64 = 1.0605;
/// Smallest ratio of the ends of a search.
const SPAN: f64 = 1.99;

/// A maximum of the response.
struct Peak<'p> {
    point: &'p Point,
    /// Points beside it.
    beside: [&'p Point; 2],
    /// The lowest point on that side of it where the response falls less.
    base: &'p Point,
}

/// States what was found among the statements on mounting.
pub(super) fn attach(certificate: &mut Certificate, basis: &Basis<'_>) {
    let Some(value) = value(&certificate.points, basis) else {
        return;
    };
    let mut sections = certificate.sections.iter_mut();
    if let Some(section) = sections.find(|section| section.key == "mounting") {
        section.entries.push(Entry {
            key: "resonance_search",
            clause: "",
            value: Some(value),
        });
    }
}

fn value(points: &[Point], basis: &Basis<'_>) -> Option<Value> {
    let searched = longest(points);
    let [first, .., last] = searched[..] else {
        return None;
    };
    let whole = last.nominal_frequency_hz / first.nominal_frequency_hz >= SPAN;
    let found: Vec<Value> = (1..searched.len() - 1)
        .filter_map(|at| peak(&searched, at))
        .filter_map(|peak| said(&peak, basis))
        .collect();
    let mut values = [first, last].map(kilohertz).to_vec();
    values.push(Value::Number(searched.len() as f64, 0, ""));
    let key = match found.is_empty() {
        true => "search.none",
        false => "search.found",
    };
    values.push(Value::List(found));
    whole.then(|| Value::Phrase(key.to_owned(), values))
}

/// The longest run of points of one level without a gap.
fn longest(points: &[Point]) -> Vec<&Point> {
    let valid: Vec<&Point> = points.iter().filter(|p| p.outcome.is_ok()).collect();
    let mut best = Vec::new();
    for start in &valid {
        let level = start.nominal_acceleration_ms2;
        let mut run = vec![*start];
        let further = valid.iter().filter(|p| p.nominal_acceleration_ms2 == level);
        for point in further {
            let before = run[run.len() - 1].nominal_frequency_hz;
            if point.nominal_frequency_hz > before {
                if point.nominal_frequency_hz > STEP * before {
                    break;
                }
                run.push(*point);
            }
        }
        if run.len() > best.len() {
            best = run;
        }
    }
    best
}

fn peak<'p>(searched: &[&'p Point], at: usize) -> Option<Peak<'p>> {
    let of = |point: &Point| point.values().map_or(f64::NAN, |values| values.sensitivity);
    let top = of(searched[at]);
    if of(searched[at - 1]) >= top || of(searched[at + 1]) > top {
        return None;
    }
    let below = |point: &&&'p Point| of(point) <= top;
    let lowest = |a: &&&'p Point, b: &&&'p Point| of(a).total_cmp(&of(b));
    let left = searched[..at]
        .iter()
        .rev()
        .take_while(below)
        .min_by(lowest)?;
    let right = searched[at + 1..].iter().take_while(below).min_by(lowest)?;
    Some(Peak {
        point: searched[at],
        beside: [searched[at - 1], searched[at + 1]],
        base: if of(left) > of(right) { left } else { right },
    })
}

/// In words, where it is one.
fn said(peak: &Peak<'_>, basis: &Basis<'_>) -> Option<Value> {
    let (top, base) = (peak.point.values()?, peak.base.values()?);
    let ratio = top.sensitivity / base.sensitivity;
    let expanded = basis.of_ratio(&peak.point.measured, &peak.base.measured)?;
    let (above, expanded) = (100.0 * (ratio - 1.0), 100.0 * ratio * expanded.expanded_rel);
    let mut values = peak.beside.map(kilohertz).to_vec();
    values.extend([above, expanded].map(|percent| Value::Number(percent, 1, "%")));
    (above > expanded).then(|| Value::Phrase("search.peak".to_owned(), values))
}

fn kilohertz(point: &Point) -> Value {
    Value::Number(point.nominal_frequency_hz / 1000.0, 3, "kHz")
}

#[cfg(test)]
mod tests {
    use super::super::model::Value;
    use super::super::{Certificate, Particulars};
    use calib_protocol::record::Record;
    use calib_record::sample::record;

    /// 1 to 8 kHz, so many points an octave, and the reference point.
    fn searched(per_octave: u32) -> Record {
        let steps = 0..=3 * per_octave;
        let hz = steps.map(|n| 1000.0 * 2.0_f32.powf(n as f32 / per_octave as f32));
        record(&std::iter::once(160.0).chain(hz).collect::<Vec<_>>())
    }

    fn stated(record: &Record) -> Option<(String, Vec<Value>)> {
        let certificate = Certificate::from_record(record, &Particulars::default());
        match certificate.statement("mounting", "resonance_search")? {
            Value::Phrase(key, values) => Some((key.clone(), values.clone())),
            other => panic!("{other:?}"),
        }
    }

    /// The response of a mass on a damped spring, times that of the sample.
    fn with_resonance(record: &mut Record, resonance_hz: f32) {
        const QUALITY: f32 = 10.0;
        for point in &mut record.points {
            let r = point.spec.frequency_hz / resonance_hz;
            let raised = 1.0 / ((1.0 - r * r).powi(2) + (r / QUALITY).powi(2)).sqrt();
            point.sensitivity_v_per_ms2 *= raised;
        }
    }

    /// A fixture at 3 kHz: the maximum of `1 / ((1 - x)^2 + x / 100)`, `x = (f/fr)^2`, is at `x = 0.995`, 2.992 kHz.
    #[test]
    fn a_resonance_within_the_range_lies_between_two_points() {
        let mut record = searched(24);
        with_resonance(&mut record, 3000.0);
        let (key, values) = stated(&record).expect("searched");
        assert_eq!(key, "search.found");
        let Value::List(found) = &values[3] else {
            panic!("{values:?}");
        };
        let [Value::Phrase(_, peak)] = &found[..] else {
            panic!("one: {found:?}");
        };
        let [
            Value::Number(from, ..),
            Value::Number(to, ..),
            Value::Number(above, ..),
            ..,
        ] = peak[..]
        else {
            panic!("{peak:?}");
        };
        assert!(from < 2.992 && 2.992 < to, "{from} {to}");
        // A twenty-fourth of an octave to either side.
        assert!(to / from < 1.06, "{from} {to}");
        // Ten times the response, over 1.13 times at 1 kHz, and 0.16 of it and less beyond the resonance.
        assert!((600.0..1100.0).contains(&above), "{above}");
    }

    /// U of the ratio is 0.092 %, by row 8 and the scatter of two points; the response rises by 0.01 % from point to point
    /// at 1.1 kHz.
    #[test]
    fn what_is_less_than_u_is_no_resonance() {
        for (raised, key) in [(1.0005, "search.none"), (1.003, "search.found")] {
            let mut record = searched(24);
            record.points[4].sensitivity_v_per_ms2 *= raised;
            assert_eq!(stated(&record).expect("searched").0, key, "{raised}");
        }
    }

    #[test]
    fn third_octaves_and_half_an_octave_are_no_search() {
        assert_eq!(stated(&searched(3)), None);
        let mut short = searched(24);
        short.points.truncate(13);
        assert_eq!(stated(&short), None);
    }
}
