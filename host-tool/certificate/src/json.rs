//! JSON: every number of the certificate, not rounded, names with units.
//!
//! ```text
//! { "certificate", "complete", "item": {..}, "calibration": {..}, ...,
//!   "reference": {point}, "points": [{point}], "budget": {..}, "remarks": [..] }
//! ```

use super::measured::MEASURED;
use super::model::{Budget, Certificate, Point, Remark, Section};
use super::words::Language;
use calib_files::{Error, Result};
use serde_json::{Map, Value, json};

/// The certificate as JSON, UTF-8, with a newline at the end.
///
/// # Errors
/// [`Error::Input`] if the writer fails, which memory does not.
pub(super) fn render(certificate: &Certificate, language: Language) -> Result<Vec<u8>> {
    let mut bytes = serde_json::to_vec_pretty(&document(certificate, language))
        .map_err(|error| Error::input("JSON", error.to_string(), "report this as a defect"))?;
    bytes.push(b'\n');
    Ok(bytes)
}

/// The certificate as a JSON value; statements in words of `language`.
pub fn document(certificate: &Certificate, language: Language) -> Value {
    let mut document = Map::new();
    document.insert("certificate".into(), json!(certificate.number));
    document.insert("language".into(), json!(language.code()));
    for section in &certificate.sections {
        document.insert(section.key.into(), statements(section, language));
    }
    let reference = certificate
        .reference
        .and_then(|index| certificate.points.get(index));
    document.insert("inverted".into(), json!(certificate.inverted));
    document.insert("reference".into(), reference.map_or(Value::Null, point));
    document.insert(
        "points".into(),
        certificate.points.iter().map(point).collect(),
    );
    let conformity = certificate.conformity().map(|conformity| conformity.name());
    document.insert("conformity".into(), json!(conformity));
    document.insert(
        "budget".into(),
        certificate.budget.as_ref().map_or(Value::Null, budget),
    );
    document.insert("as_found".into(), as_found(certificate));
    let chain = certificate.chain.map(super::standing::name);
    document.insert("record_chain".into(), json!(chain));
    let remarks = certificate.remarks.iter().map(|r| remark(r, language));
    document.insert("remarks".into(), remarks.collect());
    Value::Object(document)
}

/// The certificate as found, and the change of each point since.
fn as_found(certificate: &Certificate) -> Value {
    let Some(found) = certificate.as_found.as_deref() else {
        return Value::Null;
    };
    let pair = |(left, found): (&Point, Option<&Point>)| {
        json!({
            "frequency_hz": left.nominal_frequency_hz,
            "acceleration_ms2": left.nominal_acceleration_ms2,
            "change_percent": super::adjustment::change_percent(found, left),
        })
    };
    json!({
        "certificate": found.number,
        "date": found.day.map(|day| day.to_string()),
        "conformity": found.conformity().map(|conformity| conformity.name()),
        "points": found.points.iter().map(point).collect::<Vec<_>>(),
        "pairs": certificate.pairs().map(pair).collect::<Vec<_>>(),
    })
}

fn statements(section: &Section, language: Language) -> Value {
    let said = |entry: &super::model::Entry| {
        let words = entry
            .value
            .as_ref()
            .map(|v| super::present::value(v, language));
        (entry.key.to_owned(), json!(words))
    };
    Value::Object(section.entries.iter().map(said).collect())
}

/// "pass" or "refused", and the reason in snake case.
pub(super) fn verdict(point: &Point) -> (&'static str, Option<String>) {
    match &point.outcome {
        Ok(_) => ("pass", None),
        Err(refusal) => ("refused", Some(snake_case(&refusal.0))),
    }
}

fn snake_case(name: &str) -> String {
    let mut snake = String::new();
    for letter in name.chars() {
        if letter.is_uppercase() && !snake.is_empty() {
            snake.push('_');
        }
        snake.extend(letter.to_lowercase());
    }
    snake
}

fn point(point: &Point) -> Value {
    let (verdict, reason) = verdict(point);
    let values = point.outcome.as_ref().ok();
    let assessment = values.and_then(|v| v.assessment);
    let of = |f: fn(&super::model::PointValues) -> f64| values.map(f);
    let mut document = json!({
        "frequency_hz": point.nominal_frequency_hz,
        "actual_frequency_hz": point.frequency_hz,
        "acceleration_ms2": point.acceleration_ms2,
        "nominal_acceleration_ms2": point.nominal_acceleration_ms2,
        "verdict": verdict,
        "reason": reason,
        "sensitivity_v_per_ms2": of(|v| v.sensitivity_v_per_ms2),
        "expanded_uncertainty_percent": of(|v| v.expanded_uncertainty_percent),
        "coverage_factor": of(|v| v.coverage_factor),
        "effective_degrees_of_freedom": of(|v| v.effective_degrees_of_freedom),
        "phase_deg": of(|v| v.phase_deg),
        "expanded_uncertainty_phase_deg": of(|v| v.expanded_uncertainty_phase_deg),
        "deviation_percent": values.and_then(|v| v.deviation_percent),
        "deviation_db": values.and_then(|v| v.deviation_db),
        "conformity": assessment.map(|a| a.conformity.name()),
        "lower_limit_v_per_ms2": assessment.map(|a| a.tolerance.lower),
        "upper_limit_v_per_ms2": assessment.map(|a| a.tolerance.upper),
        "coherence": point.coherence,
        "false_accept_percent": assessment.and_then(|a| a.false_accept).map(|p| 100.0 * p),
        "false_reject_percent": assessment.and_then(|a| a.false_reject).map(|p| 100.0 * p),
        "printed_mv_per_ms2": values.map(|v| v.printed_mv_per_ms2),
        "printed_mv_per_g": values.map(|v| v.printed_mv_per_g),
        "printed_phase_deg": values.and_then(|v| v.printed_phase_deg),
        "blocks": point.blocks,
    });
    if let Value::Object(keys) = &mut document {
        let measured = MEASURED.iter();
        keys.extend(measured.map(|one| (one.key.to_owned(), json!((one.of)(&point.measured)))));
    }
    document
}

fn budget(budget: &Budget) -> Value {
    let rows = budget.rows.iter().map(|row| {
        json!({
            "row": row.row,
            "value_percent": row.value_percent,
            "distribution": row.distribution.0,
            "distribution_parameter": row.distribution.1,
            "divisor": row.divisor,
            "sensitivity_coefficient": row.sensitivity_coefficient,
            "contribution_percent": row.contribution_percent,
            "degrees_of_freedom": row.degrees_of_freedom,
        })
    });
    json!({
        "components": rows.collect::<Vec<_>>(),
        "combined_standard_uncertainty_percent": budget.combined_percent,
        "effective_degrees_of_freedom": budget.effective_degrees_of_freedom,
        "coverage_factor": budget.coverage_factor,
        "expanded_uncertainty_percent": budget.expanded_percent,
    })
}

fn remark(remark: &Remark, language: Language) -> Value {
    let words: Vec<String> = remark
        .values
        .iter()
        .map(|v| super::present::value(v, language))
        .collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    json!({
        "severity": remark.severity,
        "key": remark.key,
        "text": language.phrase(&format!("remark.{}", remark.key), &words),
    })
}
