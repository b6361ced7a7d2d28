//! Decision rules: a result, its uncertainty and a tolerance to a statement.

use super::limits::Limits;
use super::request::{Request, RuleName};
use super::risk;
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

/// Statement about a result, the best first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Conformity {
    /// Accepted.
    Pass,
    /// Inside the tolerance, but not by the guard band.
    ConditionalPass,
    /// Outside the tolerance, but not by the guard band.
    ConditionalFail,
    /// Rejected.
    Fail,
}

impl Conformity {
    /// Name in files, as the digital calibration certificate spells it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Pass => "pass",
            Self::ConditionalPass => "conditionalPass",
            Self::ConditionalFail => "conditionalFail",
            Self::Fail => "fail",
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

impl From<Conformity> for Stated {
    fn from(conformity: Conformity) -> Self {
        match conformity {
            Conformity::Pass => Self::Pass,
            Conformity::ConditionalPass => Self::ConditionalPass,
            Conformity::ConditionalFail => Self::ConditionalFail,
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

/// Judges `value` with expanded uncertainty `expanded` and its factor.
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
        Rule::Simple if tolerance.contain(value) => Conformity::Pass,
        Rule::MaxFalseAccept(most) if outside <= most => Conformity::Pass,
        Rule::GuardBand if tolerance.narrowed(expanded).contain(value) => Conformity::Pass,
        Rule::GuardBand if tolerance.contain(value) => Conformity::ConditionalPass,
        Rule::GuardBand if tolerance.narrowed(-expanded).contain(value) => {
            Conformity::ConditionalFail
        }
        _ => Conformity::Fail,
    };
    let accepted = conformity == Conformity::Pass;
    Assessment {
        tolerance,
        conformity,
        false_accept: accepted.then_some(outside),
        false_reject: (!accepted).then_some(inside),
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
