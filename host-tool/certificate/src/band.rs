//! The tolerance as areas over frequency, and the reference point's own limits.
//!
//! Limits are those of the specification at every frequency, not only where
//! something was measured, so that a step stays a step.

use super::model::Certificate;
use crate::decision::specification::Place as Where;
use crate::decision::{Limits, Specification};

/// Places per area on the logarithmic axis; steps have places of their own.
const PLACES: u32 = 64;

/// A frequency and the limits there, SI unit of the kind.
pub(super) type Place = (f64, Limits);

/// Areas of the tolerance between two frequencies, left to right.
pub(super) fn areas(certificate: &Certificate, low_hz: f64, high_hz: f64) -> Vec<Vec<Place>> {
    let Some((specification, reference)) = judged_by(certificate) else {
        return Vec::new();
    };
    let known = |limits: &Limits| limits.lower.is_finite() && limits.upper.is_finite();
    let place = |hz| {
        let limits = specification
            .limits(at(hz, reference, false))
            .filter(known)?;
        Some((hz, limits))
    };
    let frequencies = frequencies(specification, low_hz, high_hz);
    let places: Vec<Option<Place>> = frequencies.into_iter().map(place).collect();
    let areas = places.split(Option::is_none).filter(|area| area.len() > 1);
    areas
        .map(|area| area.iter().flatten().copied().collect())
        .collect()
}

/// Limits that hold at the reference point and nowhere else.
pub(super) fn at_reference(certificate: &Certificate) -> Option<Place> {
    let (specification, reference) = judged_by(certificate)?;
    let (point, _) = certificate.reference_result()?;
    let hz = point.nominal_frequency_hz;
    let own = specification.limits(at(hz, reference, true))?;
    let known = own.lower.is_finite() && own.upper.is_finite();
    let differ = known && specification.limits(at(hz, reference, false)) != Some(own);
    differ.then_some((point.frequency_hz, own))
}

fn at(frequency_hz: f64, reference: f64, at_reference_point: bool) -> Where {
    Where {
        frequency_hz,
        at_reference_point,
        reference,
    }
}

fn judged_by(certificate: &Certificate) -> Option<(&Specification, f64)> {
    let decision = certificate.decision.as_ref()?;
    let (_, values) = certificate.reference_result()?;
    Some((&decision.specification, values.sensitivity))
}

/// Even steps on the logarithmic axis, and both sides of every edge of a band.
fn frequencies(specification: &Specification, low_hz: f64, high_hz: f64) -> Vec<f64> {
    let even =
        (0..=PLACES).map(|i| low_hz * (high_hz / low_hz).powf(f64::from(i) / f64::from(PLACES)));
    // `Specification::limits` widens a band by 0.1 %.
    let edges = specification.bands.iter().flat_map(|band| {
        let (from, to) = (0.999 * band.from_hz, 1.001 * band.to_hz);
        [
            from * (1.0 - 1.0e-9),
            from * (1.0 + 1.0e-9),
            to * (1.0 - 1.0e-9),
            to * (1.0 + 1.0e-9),
        ]
    });
    let mut all: Vec<f64> = even
        .chain(edges)
        .filter(|hz| (low_hz..=high_hz).contains(hz))
        .collect();
    all.sort_by(f64::total_cmp);
    all
}

#[cfg(test)]
mod tests {
    use super::super::{Certificate, Particulars};
    use super::*;
    use calib_record::sample::{THIRD_OCTAVES_HZ, record};

    fn judged(decision: &str) -> Certificate {
        let particulars: Particulars = toml::from_str(decision).expect("TOML");
        Certificate::from_record(&record(&THIRD_OCTAVES_HZ), &particulars)
    }

    #[test]
    fn the_area_ends_where_the_specification_does() {
        let certificate = judged("[decision]\nspecification = 'api670'");
        let areas = areas(&certificate, 5.0, 20_000.0);
        assert_eq!(areas.len(), 1);
        let (first, last) = (areas[0][0].0, areas[0][areas[0].len() - 1].0);
        // 10 Hz to 10 kHz, widened by 0.1 %.
        assert!((first / 9.99 - 1.0).abs() < 1e-6 && (last / 10_010.0 - 1.0).abs() < 1e-6);
        let (at_hz, own) = at_reference(&certificate).expect("5 % of nominal");
        assert!((at_hz / 160.0 - 1.0).abs() < 1e-3);
        assert!((own.upper / own.lower - 1.05 / 0.95).abs() < 1e-9);
    }

    #[test]
    fn a_step_stays_a_step() {
        let certificate = judged(
            "[decision]\nspecification = 'mine'\n\
             [[decision.band]]\nfrom_hz = 20\nto_hz = 1000\nbase = 'reference'\nlower_percent = -2\nupper_percent = 2\n\
             [[decision.band]]\nfrom_hz = 1000\nto_hz = 10000\nbase = 'reference'\nlower_percent = -5\nupper_percent = 5\n",
        );
        let area = &areas(&certificate, 15.0, 12_000.0)[0];
        let steps = area
            .windows(2)
            .filter(|pair| pair[0].1.upper != pair[1].1.upper);
        let steps: Vec<f64> = steps.map(|pair| pair[1].0 / pair[0].0).collect();
        assert_eq!(steps.len(), 1);
        assert!(steps[0] < 1.0 + 1.0e-6, "{steps:?}");
        assert_eq!(at_reference(&certificate), None);
    }

    #[test]
    fn nothing_judged_has_no_area() {
        assert!(areas(&judged(""), 10.0, 1000.0).is_empty());
    }
}
