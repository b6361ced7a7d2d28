//! Statements from what a record or a file says; `None` where it says nothing.

use crate::model::Value;

/// Words, or `None` when nothing but blanks was said.
pub(super) fn text(words: &str) -> Option<Value> {
    let words = words.trim();
    (!words.is_empty()).then(|| Value::Text(words.to_owned()))
}

pub(super) fn said(words: &Option<String>) -> Option<Value> {
    words.as_deref().and_then(text)
}

/// Statement of the record, else of the file.
pub(super) fn either(recorded: &str, stated: &Option<String>) -> Option<Value> {
    text(recorded).or_else(|| said(stated))
}

pub(super) fn phrase(key: impl Into<String>, values: &[String]) -> Option<Value> {
    let values = values.iter().cloned().map(Value::Text).collect();
    Some(Value::Phrase(key.into(), values))
}

pub(super) fn exact(number: Option<f64>, unit: &'static str) -> Option<Value> {
    number
        .filter(|n| n.is_finite())
        .map(|n| Value::Exact(n, unit))
}
