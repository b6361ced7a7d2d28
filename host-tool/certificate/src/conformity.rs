//! Judges the results of a certificate by specification and rule.

use super::model::{Certificate, Line, PointValues, Remark, Section, Severity, Value};
use crate::decision::specification::Name;
use crate::decision::{Assessment, Base, Decision, Place, Rule, Specification, assess};

/// Judges every point that has a result, if a decision is asked for, and adds
/// the statement ISO/IEC 17025 7.8.6.2 wants: results, specification, rule.
pub(super) fn attach(certificate: &mut Certificate) {
    let request = certificate.particulars.decision.as_ref();
    // A rule alone judges nothing: the tolerance is the sensor's, and it has none.
    let Some(request) = request.filter(|request| !request.is_open()) else {
        certificate.particulars.decision = None;
        return;
    };
    let decision = match request.build() {
        Ok(decision) => decision,
        Err(problem) => {
            let remark = Remark {
                severity: Severity::Error,
                key: "decision_invalid",
                values: vec![Value::Text(problem)],
            };
            certificate.remarks.push(remark);
            return;
        }
    };
    judge(certificate, &decision);
    let section = statement(certificate, &decision);
    certificate.sections.push(section);
    certificate.decision = Some(decision);
}

fn judge(certificate: &mut Certificate, decision: &Decision) {
    let reference = certificate
        .reference_result()
        .map(|(_, values)| values.sensitivity);
    let index_of_reference = certificate.reference;
    let Some(reference) = reference else { return };
    for (index, point) in certificate.points.iter_mut().enumerate() {
        let place = Place {
            frequency_hz: point.nominal_frequency_hz,
            at_reference_point: Some(index) == index_of_reference,
            reference,
        };
        if let Ok(values) = point.outcome.as_mut() {
            values.assessment = judged(decision, place, values);
        }
    }
}

/// Judges by every base of the tolerance with the uncertainty of what is compared: of a deviation from the reference
/// point that of the deviation, in which what both points share cancels; else that of the sensitivity. The worse
/// statement counts.
fn judged(decision: &Decision, place: Place, values: &PointValues) -> Option<Assessment> {
    let specification = &decision.specification;
    let value = values.sensitivity;
    let by = |limits, of: f64, percent: f64, factor| {
        let expanded = of * percent / 100.0;
        assess(decision.rule, limits, value, expanded, factor)
    };
    let own = (values.expanded_uncertainty_percent, values.coverage_factor);
    let others = specification.limits_of(place, |base| base != Base::Reference);
    let others = others.map(|limits| by(limits, value, own.0, own.1));
    let deviation = values.deviation.and_then(|deviation| deviation.uncertainty);
    let of_deviation = match deviation {
        // The reference point deviates by nothing from itself, whatever its U.
        _ if place.at_reference_point => (place.reference, CERTAIN_PERCENT, 2.0),
        Some(u) => (place.reference, u.expanded_percent, u.coverage_factor),
        None => (value, own.0, own.1),
    };
    let relative = specification.limits_of(place, |base| base == Base::Reference);
    let relative =
        relative.map(|limits| by(limits, of_deviation.0, of_deviation.1, of_deviation.2));
    let tolerance = specification.limits(place)?;
    let worse = match (others, relative) {
        (Some(one), Some(other)) => one.and(other),
        (one, other) => one.or(other)?,
    };
    Some(Assessment { tolerance, ..worse })
}

/// U of what is certain, %: above zero, which a distribution needs.
const CERTAIN_PERCENT: f64 = 1e-9;

fn statement(certificate: &Certificate, decision: &Decision) -> Section {
    let judged: Vec<Assessment> = certificate
        .results()
        .filter_map(|(_, values)| values.assessment)
        .collect();
    let largest = |of: fn(&Assessment) -> Option<f64>| {
        let largest = judged.iter().filter_map(of).reduce(f64::max)?;
        // Below that nobody wants the digits.
        Some(match largest < 1.0e-4 {
            true => Value::Phrase("risk.negligible".to_owned(), vec![]),
            false => Value::Number(100.0 * largest, 2, "%"),
        })
    };
    let nominal = decision.specification.nominal;
    // As accelerometers are specified.
    let unit = certificate.kind.per_g_unit();
    let unit = unit.unwrap_or_else(|| certificate.kind.stated_unit());
    let lines = [
        (
            "specification",
            "ISO/IEC 17025 7.8.6.2 b",
            Some(specification(&decision.specification)),
        ),
        (
            "nominal",
            "",
            nominal.map(|v| Value::Number(unit.of_si(v), 2, unit.printed())),
        ),
        ("rule", "ISO/IEC 17025 7.8.6.2 c", Some(rule(decision.rule))),
        (
            "applies_to",
            "ISO/IEC 17025 7.8.6.2 a",
            Some(applies_to(certificate, judged.len())),
        ),
        (
            "statement",
            "ISO/IEC 17025 7.8.4.1 e",
            Some(overall(certificate)),
        ),
        ("false_accept", "", largest(|a| a.false_accept)),
        ("false_reject", "", largest(|a| a.false_reject)),
    ];
    // Risks of what did not happen are not missing, they do not exist.
    let exists = |(key, _, value): &Line| value.is_some() || *key == "statement";
    Section::new("decision", lines.into_iter().filter(exists))
}

fn specification(specification: &Specification) -> Value {
    let with =
        |key: &str, percent: f64| Value::Phrase(key.to_owned(), vec![Value::Exact(percent, "%")]);
    match &specification.name {
        Name::Own(name) => Value::Text(name.clone()),
        Name::Nominal(percent) => with("specification.nominal", *percent),
        Name::Relative(percent) => with("specification.relative", *percent),
        Name::Bands => Value::List(
            specification
                .bands
                .iter()
                .copied()
                .map(Value::Band)
                .collect(),
        ),
    }
}

fn rule(rule: Rule) -> Value {
    match rule {
        Rule::Simple => Value::Phrase("rule.simple".to_owned(), vec![]),
        Rule::GuardBand => Value::Phrase("rule.guard_band".to_owned(), vec![]),
        Rule::MaxFalseAccept(most) => {
            // What was typed, not what became of it in binary.
            let percent = (most * 1.0e8).round() / 1.0e6;
            let values = vec![Value::Exact(percent, "%")];
            Value::Phrase("rule.max_false_accept".to_owned(), values)
        }
    }
}

fn applies_to(certificate: &Certificate, judged: usize) -> Value {
    let count = |n: usize| Value::Number(n as f64, 0, "");
    let counts = vec![count(judged), count(certificate.points.len())];
    Value::Phrase("decision.points".to_owned(), counts)
}

fn overall(certificate: &Certificate) -> Value {
    let key = match certificate.conformity() {
        Some(conformity) => crate::decision::Stated::from(conformity).message(),
        None => "conformity.none",
    };
    Value::Phrase(key.to_owned(), vec![])
}
