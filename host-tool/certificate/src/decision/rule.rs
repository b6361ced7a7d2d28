//! Decision rules: a result, its uncertainty and a tolerance to a statement.

use super::limits::Limits;
use super::request::{Request, RuleName};
use super::risk;
use calib_core::conformity::Conformity;
use schemars::JsonSchema;
use serde::Serialize;

/// How a result is judged.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Rule {
    /// Simple acceptance: inside the tolerance (ILAC-G8:09/2019, 4.2.1).
    Simple,
    /// Guard band w = U: inside the tolerance less U; between the two limits
    /// the statement is conditional (ILAC-G8:09/2019, 4.2.3).
    GuardBand,
    /// Accept while the probability that the true value lies outside is at
    /// most this.
    MaxFalseAccept(f64),
}

impl Rule {
    /// True when a result in the middle of the tolerance would be accepted: U at most
    /// half the tolerance's width (test uncertainty ratio 1, ILAC-G8:09/2019, 4.2), or
    /// a small enough risk there.
    fn can_accept(self, tolerance: Limits, expanded: f64, coverage_factor: f64) -> bool {
        let standard = expanded / coverage_factor;
        match self {
            Self::Simple | Self::GuardBand => tolerance.narrowed(expanded).hold_something(),
            Self::MaxFalseAccept(most) => {
                1.0 - risk::inside(tolerance, tolerance.middle(), standard) <= most
            }
        }
    }

    pub(super) fn build(request: &Request) -> Result<Self, String> {
        match request.rule {
            RuleName::Simple => Ok(Self::Simple),
            RuleName::GuardBand => Ok(Self::GuardBand),
            RuleName::MaxFalseAccept => {
                let percent = request.max_false_accept_percent;
                let percent = percent.ok_or("decision: state max_false_accept_percent")?;
                match percent > 0.0 && percent <= 50.0 {
                    true => Ok(Self::MaxFalseAccept(percent / 100.0)),
                    false => Err(format!(
                        "decision.max_false_accept_percent: {percent} is not between 0 and 50"
                    )),
                }
            }
        }
    }
}

/// [`Conformity`] as programs read it, and why there is none.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Stated {
    /// Accepted.
    Pass,
    /// Inside the tolerance, but not by the guard band.
    ConditionalPass,
    /// Outside the tolerance, but not by the guard band.
    ConditionalFail,
    /// Rejected.
    Fail,
    /// Something is specified, and there is no result that could be judged by it.
    NotJudgeable,
    /// Nothing is specified.
    NotSpecified,
}

impl Stated {
    /// Key of its words in the message file.
    pub(crate) fn message(self) -> &'static str {
        match self {
            Self::Pass => "conformity.pass",
            Self::ConditionalPass => "conformity.conditionalPass",
            Self::ConditionalFail => "conformity.conditionalFail",
            Self::Fail => "conformity.fail",
            Self::NotJudgeable => "conformity.notJudgeable",
            Self::NotSpecified => "conformity.none",
        }
    }
}

impl From<Conformity> for Stated {
    fn from(conformity: Conformity) -> Self {
        match conformity {
            Conformity::Pass => Self::Pass,
            Conformity::ConditionalPass => Self::ConditionalPass,
            Conformity::ConditionalFail => Self::ConditionalFail,
            Conformity::NotJudgeable => Self::NotJudgeable,
            Conformity::Fail => Self::Fail,
        }
    }
}

/// A judged result.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Assessment {
    /// The tolerance, in the unit of the result.
    pub tolerance: Limits,
    /// Statement.
    pub conformity: Conformity,
    /// Probability that the true value lies outside the tolerance although
    /// the result is accepted; `None` when it is not.
    pub false_accept: Option<f64>,
    /// Probability that the true value lies inside although the result is not
    /// accepted; `None` when it is.
    pub false_reject: Option<f64>,
}

impl Assessment {
    /// Both at once: the worse statement. Accepted is what both accept, wrongly at most as often as both together;
    /// rejected is what one rejects, wrongly at most as often as each.
    pub(crate) fn and(self, other: Self) -> Self {
        let conformity = self.conformity.max(other.conformity);
        let accepted = self.false_accept.zip(other.false_accept);
        let rejected = [self.false_reject, other.false_reject];
        let judged = conformity != Conformity::NotJudgeable;
        Self {
            conformity,
            false_accept: accepted.map(|(one, two)| (one + two).min(1.0)),
            false_reject: rejected
                .into_iter()
                .flatten()
                .filter(|_| judged)
                .reduce(f64::min),
            ..self
        }
    }
}

/// Judges `value` with expanded uncertainty `expanded` and its factor.
///
/// Where U is so large that the rule could accept no result at all, nothing is
/// judged, unless the value lies outside the tolerance by more than U.
///
/// Probabilities are those of a normal distribution of the measurand around
/// the result with standard deviation U/k (JCGM 106:2012, no prior knowledge).
pub fn assess(
    rule: Rule,
    tolerance: Limits,
    value: f64,
    expanded: f64,
    coverage_factor: f64,
) -> Assessment {
    let inside = risk::inside(tolerance, value, expanded / coverage_factor);
    let outside = 1.0 - inside;
    let conformity = match rule {
        _ if tolerance.narrowed(-expanded).excludes(value) => Conformity::Fail,
        rule if !rule.can_accept(tolerance, expanded, coverage_factor) => Conformity::NotJudgeable,
        Rule::Simple if tolerance.contain(value) => Conformity::Pass,
        Rule::MaxFalseAccept(most) if outside <= most => Conformity::Pass,
        Rule::GuardBand if tolerance.narrowed(expanded).contain(value) => Conformity::Pass,
        Rule::GuardBand if tolerance.contain(value) => Conformity::ConditionalPass,
        Rule::GuardBand => Conformity::ConditionalFail,
        _ => Conformity::Fail,
    };
    let accepted = conformity == Conformity::Pass;
    let judged = conformity != Conformity::NotJudgeable;
    Assessment {
        tolerance,
        conformity,
        false_accept: accepted.then_some(outside),
        false_reject: (judged && !accepted).then_some(inside),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TOLERANCE: Limits = Limits {
        lower: 95.0,
        upper: 105.0,
    };

    fn stated(rule: Rule, value: f64) -> Conformity {
        assess(rule, TOLERANCE, value, 1.0, 2.0).conformity
    }

    #[test]
    fn a_guard_band_of_u_has_four_statements() {
        let cases = [
            (103.9, Conformity::Pass),
            (104.1, Conformity::ConditionalPass),
            (105.9, Conformity::ConditionalFail),
            (106.1, Conformity::Fail),
            (96.1, Conformity::Pass),
            (95.9, Conformity::ConditionalPass),
        ];
        for (value, expected) in cases {
            assert_eq!(stated(Rule::GuardBand, value), expected, "{value}");
        }
    }

    #[test]
    fn what_no_result_could_meet_is_not_judged() {
        // Tolerance +-5, U = 6 with k = 2: the rule accepts nothing; 1 - P(|z| < 5/3) = 9.56 %
        // in the middle.
        let rules = [Rule::Simple, Rule::GuardBand, Rule::MaxFalseAccept(0.05)];
        for rule in rules {
            let judged = |value| assess(rule, TOLERANCE, value, 6.0, 2.0);
            for value in [100.0, 104.0, 106.0, 110.9] {
                assert_eq!(
                    judged(value).conformity,
                    Conformity::NotJudgeable,
                    "{rule:?}"
                );
                assert_eq!(
                    (judged(value).false_accept, judged(value).false_reject),
                    (None, None)
                );
            }
            // Outside by more than U it fails, whatever the rule.
            assert_eq!(judged(111.1).conformity, Conformity::Fail, "{rule:?}");
        }
        let lenient = assess(Rule::MaxFalseAccept(0.10), TOLERANCE, 100.0, 6.0, 2.0);
        assert_eq!(lenient.conformity, Conformity::Pass);
    }

    #[test]
    fn limits_of_a_base_nobody_knows_judge_nothing() {
        let unknown = Limits {
            lower: f64::NAN,
            upper: f64::NAN,
        };
        for rule in [Rule::Simple, Rule::GuardBand, Rule::MaxFalseAccept(0.05)] {
            let judged = assess(rule, unknown, 1.0, 0.01, 2.0);
            assert_eq!(judged.conformity, Conformity::NotJudgeable, "{rule:?}");
        }
    }

    #[test]
    fn simple_acceptance_shares_the_risk_on_the_limit() {
        let on_limit = assess(Rule::Simple, TOLERANCE, 105.0, 1.0, 2.0);
        assert_eq!(on_limit.conformity, Conformity::Pass);
        // Half of the distribution lies beyond a limit it is centred on.
        assert!((on_limit.false_accept.expect("accepted") - 0.5).abs() < 1e-9);
        assert_eq!(stated(Rule::Simple, 105.001), Conformity::Fail);
    }

    #[test]
    fn the_largest_false_acceptance_sets_the_acceptance_limit() {
        // One-sided 2.5 % lies 1.959964 standard deviations (0.5) inside: 0.979982.
        let rule = Rule::MaxFalseAccept(0.025);
        assert_eq!(stated(rule, 105.0 - 0.9799), Conformity::Fail);
        assert_eq!(stated(rule, 105.0 - 0.9801), Conformity::Pass);
        let failed = assess(rule, TOLERANCE, 104.5, 1.0, 2.0);
        // One standard deviation inside: 84.134 % of rejecting wrongly.
        assert!((failed.false_reject.expect("rejected") - 0.841_345).abs() < 1e-6);
    }
}
