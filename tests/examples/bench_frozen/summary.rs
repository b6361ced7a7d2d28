//! The part of an answer that is frozen: verdict, places, causes with values, nominal values.

use super::Fault;
use calib_gap::Answer;
use serde_json::{Value, json};

/// The answer without texts, pictures and the folder it came from.
pub(super) fn of(answer: &Answer) -> Result<Value, Fault> {
    let whole = serde_json::to_value(answer)?;
    let places: Vec<Value> = list(&whole["where"])
        .map(|place| {
            let word = |key: &str| place[key].as_str().unwrap_or("?").to_owned();
            let words = ["stage", "observable", "axis", "class"].map(word);
            Value::from(words.join("/"))
        })
        .collect();
    let causes: Vec<Value> = list(&whole["causes"])
        .map(|cause| {
            json!({
                "effects": cause["effects"],
                "probability": cause["probability"],
                "stability": cause["stability"],
                "parameters": abbreviated(&cause["parameters"]),
            })
        })
        .collect();
    Ok(json!({
        "verdict": whole["verdict"],
        "where": places,
        "causes": causes,
        "none_of_these_p_value": whole["none_of_these_p_value"],
        "confusable": whole["confusable"],
        "closed": whole["gap"]["closed"],
        "nominal": abbreviated(&whole["nominal_parameters"]),
        "dataset": whole["dataset"]["sha256"],
    }))
}

/// The baseline says `u` for a standard uncertainty.
fn abbreviated(value: &Value) -> Value {
    let word = |key: &str| match key {
        "standard_uncertainty" => "u".to_owned(),
        key => key.to_owned(),
    };
    match value.as_object() {
        Some(members) => members
            .iter()
            .map(|(key, value)| (word(key), abbreviated(value)))
            .collect(),
        None => value.clone(),
    }
}

fn list(value: &Value) -> impl Iterator<Item = &Value> {
    value.as_array().into_iter().flatten()
}
