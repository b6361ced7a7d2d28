//! Whether results conform to the tolerance of a list: what the lamps say of a run without a host.
//!
//! A certificate of the same record makes the same statements; a test compares the two on random runs
//! (`tests/src/lone.rs`). Here they are computed in f32, and U of a deviation from the reference point counts both
//! points as independent. That is never less than on the certificate, which knows what both points share and
//! decides more often.
//!
//! # Source
//! ILAC-G8:09/2019, 4.2; ISO/IEC 17025:2017, 7.8.6; reference point by ISO 16063-21:2003, 5.3.

use crate::closing::Closing;
use crate::point::{PointResult, PointSpec};
use crate::point_state::PointState;
use crate::preferred::{REFERENCE_HZ, REFERENCE_MS2};
use crate::stored_list::{Band, Base, ListTerms, Rule};

/// A hundredth of an octave, as a ratio: omega = 1000 rad/s and 500 rad/s count as 160 Hz and 80 Hz.
const NEAR: f32 = 1.006_955_6;
/// Levels within 1 % of a preferred one count as it.
const SAME_LEVEL: f32 = 0.01;

/// Statement about results, the best first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Conformity {
    /// Accepted.
    Pass,
    /// Inside the tolerance, but not by the guard band.
    ConditionalPass,
    /// Outside the tolerance, but not by the guard band.
    ConditionalFail,
    /// No statement: the uncertainty is too large for the tolerance, a point was refused, or none has a
    /// tolerance.
    NotJudgeable,
    /// Rejected.
    Fail,
}

/// Statement about a run: that about the worst of its points. It is `complete` when every point was tried.
///
/// A point that was refused or never tried leaves nothing to be accepted, nor does a first point that could not be
/// repeated at the end; what another point fails by is rejected all the same. What changed until then counts with U.
pub fn judge(
    terms: &ListTerms,
    points: &[PointResult],
    complete: bool,
    closing: &Closing,
) -> Conformity {
    let Some(reference) = reference_point(points) else {
        return Conformity::NotJudgeable;
    };
    let judged = points.iter().filter(|point| is_result(point));
    let worst = judged
        .filter_map(|point| judge_point(terms, point, reference, closing))
        .max();
    let closed = !matches!(closing, Closing::Refused(_));
    match worst {
        Some(Conformity::Fail) => Conformity::Fail,
        Some(worst) if complete && closed && points.iter().all(is_result) => worst,
        _ => Conformity::NotJudgeable,
    }
}

/// Whether something can be said of the point: it is valid, and magnitude, uncertainty and factor are numbers
/// above zero.
fn is_result(point: &PointResult) -> bool {
    let positive = |value: f32| value.is_finite() && value > 0.0;
    point.state == PointState::Valid
        && point.has_result()
        && positive(point.sensitivity_v_per_ms2)
        && positive(point.expanded_uncertainty_rel)
        && positive(point.coverage_factor)
}

/// Limits of a sensitivity, V/(m/s2).
#[derive(Clone, Copy)]
struct Limits {
    lower: f32,
    upper: f32,
}

/// Statement about a point with a result; none where no band says anything.
fn judge_point(
    terms: &ListTerms,
    point: &PointResult,
    reference: &PointResult,
    closing: &Closing,
) -> Option<Conformity> {
    let at_reference = core::ptr::eq(point, reference);
    let own = closing.expanded_rel(point);
    let of_deviation = match at_reference {
        // It deviates by nothing from itself, whatever its U.
        true => 0.0,
        false => libm::hypotf(own, closing.expanded_rel(reference)),
    };
    let value = point.sensitivity_v_per_ms2;
    let by = |base, sensitivity: f32, expanded_rel: f32| {
        let bands = terms.bands.iter().filter(|band| band.base == base);
        let applying = bands.filter(|band| band.applies(point.spec.frequency_hz, at_reference));
        let limits = tightest(applying, sensitivity)?;
        Some(assess(terms.rule, limits, value, value * expanded_rel))
    };
    let nominal = by(Base::Nominal, terms.nominal_v_per_ms2, own);
    let response = by(
        Base::Reference,
        reference.sensitivity_v_per_ms2,
        of_deviation,
    );
    nominal.max(response)
}

/// Limits around a sensitivity that hold in all of these bands.
fn tightest<'a>(bands: impl Iterator<Item = &'a Band>, sensitivity: f32) -> Option<Limits> {
    let limits = bands.map(|band| Limits {
        lower: sensitivity * (1.0 + band.lower_rel),
        upper: sensitivity * (1.0 + band.upper_rel),
    });
    limits.reduce(|a, b| Limits {
        lower: a.lower.max(b.lower),
        upper: a.upper.min(b.upper),
    })
}

/// Judges a value with its expanded uncertainty. Where U is so large that no value could be accepted, that is
/// half the width of the tolerance, nothing is judged, unless it lies outside by more than U.
fn assess(rule: Rule, limits: Limits, value: f32, expanded: f32) -> Conformity {
    let within = |margin: f32| value >= limits.lower + margin && value <= limits.upper - margin;
    let can_accept = limits.lower + expanded <= limits.upper - expanded;
    if !within(-expanded) {
        return Conformity::Fail;
    }
    if !can_accept {
        return Conformity::NotJudgeable;
    }
    match rule {
        Rule::Simple if within(0.0) => Conformity::Pass,
        Rule::Simple => Conformity::Fail,
        Rule::GuardBand if within(expanded) => Conformity::Pass,
        Rule::GuardBand if within(0.0) => Conformity::ConditionalPass,
        Rule::GuardBand => Conformity::ConditionalFail,
    }
}

/// The reference point of 5.3 among the results: 160 Hz, else 80 Hz, else what is nearest to 160 Hz on the
/// logarithmic axis; there 100 m/s2, else 10, 20, 50 m/s2, else any level.
fn reference_point(points: &[PointResult]) -> Option<&PointResult> {
    let before = |a: &PointSpec, b: &PointSpec| {
        let key = |spec: &PointSpec| {
            let (frequency, level) = rank(spec);
            (
                frequency,
                level,
                spec.frequency_hz,
                spec.acceleration_rms_ms2,
            )
        };
        key(a) < key(b)
    };
    let results = points.iter().filter(|point| is_result(point));
    results.reduce(|best, point| match before(&point.spec, &best.spec) {
        true => point,
        false => best,
    })
}

/// How far a point is from the reference point: the less the better.
fn rank(spec: &PointSpec) -> (f32, usize) {
    let ratio = |hz: f32| {
        let ratio = spec.frequency_hz / hz;
        ratio.max(1.0 / ratio)
    };
    let [first, second] = REFERENCE_HZ.map(ratio);
    let frequency = match (first < NEAR, second < NEAR) {
        (true, _) => 0.0,
        // Below every other ratio.
        (false, true) => 1.0,
        (false, false) => first,
    };
    let is = |level: &f32| (spec.acceleration_rms_ms2 / level - 1.0).abs() < SAME_LEVEL;
    let level = REFERENCE_MS2.iter().position(is);
    (frequency, level.unwrap_or(REFERENCE_MS2.len()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::point_state::Reason;

    /// Of a run that was not closed.
    fn judge(terms: &ListTerms, points: &[PointResult]) -> Conformity {
        super::judge(terms, points, true, &Closing::None)
    }

    /// A valid point of S in V/(m/s2) with U = 1 %.
    fn valid(frequency_hz: f32, sensitivity: f32) -> PointResult {
        let spec = PointSpec {
            frequency_hz,
            acceleration_rms_ms2: 10.0,
        };
        PointResult {
            state: PointState::Valid,
            sensitivity_v_per_ms2: sensitivity,
            expanded_uncertainty_rel: 0.01,
            coverage_factor: 2.0,
            ..PointResult::refused(spec, None, Reason::Stopped)
        }
    }

    fn refused(frequency_hz: f32) -> PointResult {
        PointResult {
            state: PointState::Refused(Reason::Clipped),
            ..valid(frequency_hz, 1.0)
        }
    }

    fn band(base: Base, percent: f32) -> Band {
        Band::everywhere(base, percent / 100.0)
    }

    fn terms(rule: Rule, bands: &[Band]) -> ListTerms {
        ListTerms {
            name: "a".try_into().expect("short"),
            nominal_v_per_ms2: 1.0,
            unit: "mV/g".try_into().expect("short"),
            rule,
            bands: bands.iter().copied().collect(),
        }
    }

    #[test]
    fn a_guard_band_of_u_has_four_statements_and_simple_acceptance_two() {
        // Limits 0.95 and 1.05; U = 1 % of the value.
        let guarded = terms(Rule::GuardBand, &[band(Base::Nominal, 5.0)]);
        let simple = terms(Rule::Simple, &[band(Base::Nominal, 5.0)]);
        for (value, with_guard, without) in [
            (1.0, Conformity::Pass, Conformity::Pass),
            (1.039, Conformity::Pass, Conformity::Pass),
            (1.041, Conformity::ConditionalPass, Conformity::Pass),
            (1.059, Conformity::ConditionalFail, Conformity::Fail),
            (1.062, Conformity::Fail, Conformity::Fail),
            (0.958, Conformity::ConditionalPass, Conformity::Pass),
            (0.93, Conformity::Fail, Conformity::Fail),
        ] {
            let points = [valid(160.0, value)];
            assert_eq!(judge(&guarded, &points), with_guard, "{value}");
            assert_eq!(judge(&simple, &points), without, "{value}");
        }
    }

    #[test]
    fn what_no_result_could_meet_is_not_judged_unless_it_is_far_outside() {
        for rule in [Rule::Simple, Rule::GuardBand] {
            let tight = terms(rule, &[band(Base::Nominal, 0.9)]);
            let judged = |value| judge(&tight, &[valid(160.0, value)]);
            assert_eq!(judged(1.0), Conformity::NotJudgeable);
            assert_eq!(judged(1.018), Conformity::NotJudgeable);
            assert_eq!(judged(1.02), Conformity::Fail);
        }
    }

    #[test]
    fn a_point_that_was_never_tried_leaves_nothing_to_be_accepted() {
        let terms = terms(Rule::Simple, &[band(Base::Nominal, 5.0)]);
        let stopped = |value| super::judge(&terms, &[valid(160.0, value)], false, &Closing::None);
        assert_eq!(stopped(1.0), Conformity::NotJudgeable);
        assert_eq!(stopped(1.2), Conformity::Fail);
    }

    #[test]
    fn a_refused_point_leaves_nothing_to_be_accepted() {
        let terms = terms(Rule::Simple, &[band(Base::Nominal, 5.0)]);
        let good = valid(160.0, 1.0);
        assert_eq!(judge(&terms, &[good]), Conformity::Pass);
        assert_eq!(
            judge(&terms, &[good, refused(80.0)]),
            Conformity::NotJudgeable
        );
        assert_eq!(judge(&terms, &[refused(80.0)]), Conformity::NotJudgeable);
        assert_eq!(judge(&terms, &[]), Conformity::NotJudgeable);
        let bad = valid(500.0, 1.2);
        assert_eq!(judge(&terms, &[good, refused(80.0), bad]), Conformity::Fail);
        let without_u = PointResult {
            expanded_uncertainty_rel: 0.0,
            ..good
        };
        assert_eq!(judge(&terms, &[without_u]), Conformity::NotJudgeable);
    }

    #[test]
    fn bands_are_of_their_frequencies_their_base_and_the_reference_point() {
        let mut at_reference = band(Base::Nominal, 5.0);
        at_reference.reference_point_only = true;
        let mut response = band(Base::Reference, 20.0);
        (response.from_hz, response.to_hz) = (10.0, 1000.0);
        let terms = terms(Rule::Simple, &[at_reference, response]);
        // 15 % above nominal and 11 % above the reference point; beyond 1 kHz nothing is said.
        let points = [valid(500.0, 1.15), valid(160.0, 1.04), valid(5000.0, 9.0)];
        assert_eq!(judge(&terms, &points), Conformity::Pass);
        assert_eq!(judge(&terms, &points[..1]), Conformity::Fail, "it is alone");
        assert_eq!(judge(&terms, &points[2..]), Conformity::Fail, "of nominal");
        let outside = [valid(160.0, 1.0), valid(500.0, 1.25)];
        assert_eq!(judge(&terms, &outside), Conformity::Fail);
        let mut nowhere = terms.clone();
        nowhere.bands.retain(|band| !band.reference_point_only);
        assert_eq!(judge(&nowhere, &points[2..]), Conformity::NotJudgeable);
    }

    /// U of a deviation is that of both points, sqrt(2) %, if nothing is known of what they share; the reference
    /// point itself deviates by nothing, though its own U is more than the tolerance.
    #[test]
    fn a_response_is_judged_with_the_uncertainty_of_both_points() {
        let response = terms(Rule::GuardBand, &[band(Base::Reference, 5.0)]);
        let judged = |value| judge(&response, &[valid(160.0, 1.0), valid(500.0, value)]);
        assert_eq!(judged(1.035), Conformity::Pass);
        assert_eq!(judged(1.037), Conformity::ConditionalPass);
        let tight = terms(Rule::GuardBand, &[band(Base::Reference, 0.5)]);
        assert_eq!(judge(&tight, &[valid(160.0, 1.0)]), Conformity::Pass);
    }

    #[test]
    fn the_reference_point_is_that_of_5_3() {
        let found = |list: &[(f32, f32)]| {
            let points: std::vec::Vec<PointResult> = list
                .iter()
                .map(|(hz, level)| {
                    let mut point = valid(*hz, 1.0);
                    point.spec.acceleration_rms_ms2 = *level;
                    point
                })
                .collect();
            reference_point(&points).map(|p| (p.spec.frequency_hz, p.spec.acceleration_rms_ms2))
        };
        assert_eq!(
            found(&[(80.0, 100.0), (160.0, 10.0), (159.155, 100.0)]),
            Some((159.155, 100.0))
        );
        assert_eq!(found(&[(100.0, 10.0), (80.0, 1.0)]), Some((80.0, 1.0)));
        assert_eq!(found(&[(1000.0, 5.0), (315.0, 5.0)]), Some((315.0, 5.0)));
        assert_eq!(found(&[]), None);
    }
}
