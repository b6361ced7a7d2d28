//! Whether a document has the form that its schema promises; for tests.
//!
//! Knows the keywords that generated schemas use and refuses all others, so that
//! none is passed over. Stricter than JSON Schema in one thing: a key that an
//! object's schema does not name is a fault.

use serde_json::{Map, Value};
use std::path::Path;

/// Keywords that say nothing about a document.
const REMARKS: [&str; 6] = [
    "$schema",
    "$defs",
    "title",
    "description",
    "format",
    "default",
];

/// Checks a document against the schema in `root`.
///
/// # Errors
/// Where the document breaks it, and how; or a keyword that is not known here.
pub fn conforms(document: &Value, root: &Value) -> Result<(), String> {
    Place::top(root).check(document, root)
}

/// Checks what a verb printed for programs against its schema in the folder `schemas`;
/// nothing is checked where its arguments ask for text.
///
/// # Errors
/// As [`conforms`]; a verb without a schema, and what is no JSON.
pub fn check_output(schemas: &Path, arguments: &[&str], printed: &[u8]) -> Result<(), String> {
    let lines = arguments.contains(&"--json-lines");
    if !lines && !arguments.contains(&"--json") {
        return Ok(());
    }
    let words: Vec<&str> = arguments
        .iter()
        .filter(|a| !a.starts_with('-'))
        .copied()
        .collect();
    let names = words.iter().enumerate().flat_map(|(at, word)| {
        let both = words.get(at + 1).map(|next| format!("{word}-{next}"));
        [both, Some((*word).to_owned())].into_iter().flatten()
    });
    let schema = |name: &str| {
        let text = std::fs::read(schemas.join(format!("{name}.json"))).ok()?;
        serde_json::from_slice::<Value>(&text).ok()
    };
    let found = names
        .into_iter()
        .find_map(|name| Some((schema(&name)?, name)));
    let (root, name) = found.ok_or_else(|| format!("{arguments:?}: there is no schema"))?;
    let read = |text: &[u8]| serde_json::from_slice::<Value>(text).map_err(|e| e.to_string());
    let checked = match lines {
        false => read(printed).and_then(|document| conforms(&document, &root)),
        true => {
            let root = schema(&format!("{name}-lines")).unwrap_or(root);
            let lines = printed
                .split(|byte| *byte == b'\n')
                .filter(|l| !l.is_empty());
            lines
                .into_iter()
                .try_for_each(|line| read(line).and_then(|row| of_row(&row, &root)))
        }
    };
    checked.map_err(|fault| format!("{name}: {fault}"))
}

/// A line is a row of a list, or the whole document.
fn of_row(row: &Value, root: &Value) -> Result<(), String> {
    let place = Place::top(root);
    let forms = root.get("anyOf").and_then(Value::as_array);
    let forms = forms.into_iter().flatten().chain([root]);
    let of_list = |form: &Value| match form.get("items") {
        Some(items) => place.check(row, items).is_ok(),
        None => false,
    };
    match forms.into_iter().any(of_list) {
        true => Ok(()),
        false => place.check(row, root),
    }
}

struct Place<'a> {
    root: &'a Value,
    path: &'a str,
    /// The schema is one of several that an object is joined of: others name its other keys.
    joined: bool,
}

impl<'a> Place<'a> {
    fn top(root: &'a Value) -> Self {
        Self {
            root,
            path: "$",
            joined: false,
        }
    }

    fn check(&self, value: &Value, schema: &Value) -> Result<(), String> {
        let Some(keywords) = schema.as_object() else {
            return match schema {
                Value::Bool(true) => Ok(()),
                _ => Err(self.fault("nothing is allowed here")),
            };
        };
        let joined = self.joined || keywords.contains_key("properties");
        for (keyword, wanted) in keywords {
            Place { joined, ..*self }.keyword(keyword, wanted, value)?;
        }
        match value {
            Value::Object(members) => self.members(members, keywords),
            Value::Array(items) => self.items(items, keywords),
            _ => Ok(()),
        }
    }

    fn keyword(&self, keyword: &str, wanted: &Value, value: &Value) -> Result<(), String> {
        let schemas = || wanted.as_array().map(Vec::as_slice).unwrap_or_default();
        let matching = || schemas().iter().filter(|s| self.check(value, s).is_ok());
        let number = |f: fn(f64, f64) -> bool| match (value.as_f64(), wanted.as_f64()) {
            (Some(value), Some(limit)) => f(value, limit),
            _ => true,
        };
        let length = value.as_array().map(|items| items.len() as u64);
        let good = match keyword {
            "type" => match wanted {
                Value::Array(any) => any.iter().any(|one| is_of(value, one)),
                one => is_of(value, one),
            },
            "enum" => schemas().contains(value),
            "const" => value == wanted,
            "$ref" => return self.check(value, self.referenced(wanted)?),
            "anyOf" => matching().next().is_some(),
            "oneOf" => matching().count() == 1,
            "allOf" => matching().count() == schemas().len(),
            "minimum" => number(|value, limit| value >= limit),
            "maximum" => number(|value, limit| value <= limit),
            "minItems" => length >= wanted.as_u64() || length.is_none(),
            "maxItems" => length <= wanted.as_u64(),
            "properties" | "required" | "additionalProperties" | "items" => true,
            remark if REMARKS.contains(&remark) => true,
            unknown => return Err(self.fault(&format!("unknown keyword {unknown}"))),
        };
        match good {
            true => Ok(()),
            false => Err(self.fault(&format!("{value} breaks {keyword} {wanted}"))),
        }
    }

    fn referenced(&self, reference: &Value) -> Result<&Value, String> {
        let pointer = reference.as_str().and_then(|name| name.strip_prefix('#'));
        let found = pointer.and_then(|pointer| self.root.pointer(pointer));
        found.ok_or_else(|| self.fault(&format!("{reference} leads nowhere")))
    }

    fn members(
        &self,
        members: &Map<String, Value>,
        schema: &Map<String, Value>,
    ) -> Result<(), String> {
        let required = schema.get("required").and_then(Value::as_array);
        for key in required.into_iter().flatten().filter_map(Value::as_str) {
            if !members.contains_key(key) {
                return Err(self.fault(&format!("{key} is missing")));
            }
        }
        let named = schema.get("properties").and_then(Value::as_object);
        for (key, member) in members {
            let path = format!("{}.{key}", self.path);
            let place = Place {
                path: &path,
                ..*self
            };
            match (named.and_then(|named| named.get(key)), named) {
                (Some(schema), _) => place.check(member, schema)?,
                (None, _) if schema.contains_key("additionalProperties") => {
                    place.check(member, &schema["additionalProperties"])?;
                }
                // Other members are those of the schemas joined to this one.
                (None, Some(_)) if !self.joined && !is_joined(schema) => {
                    return Err(place.fault("is not in the schema"));
                }
                _ => {}
            }
        }
        Ok(())
    }

    fn items(&self, items: &[Value], schema: &Map<String, Value>) -> Result<(), String> {
        let Some(wanted) = schema.get("items") else {
            return Ok(());
        };
        for (index, item) in items.iter().enumerate() {
            let path = format!("{}[{index}]", self.path);
            let place = Place {
                path: &path,
                joined: false,
                ..*self
            };
            place.check(item, wanted)?;
        }
        Ok(())
    }

    fn fault(&self, problem: &str) -> String {
        format!("{}: {problem}", self.path)
    }
}

fn is_joined(schema: &Map<String, Value>) -> bool {
    ["$ref", "anyOf", "oneOf", "allOf"]
        .iter()
        .any(|keyword| schema.contains_key(*keyword))
}

fn is_of(value: &Value, name: &Value) -> bool {
    match name.as_str() {
        Some("null") => value.is_null(),
        Some("boolean") => value.is_boolean(),
        Some("integer") => value.as_f64().is_some_and(|number| number.fract() == 0.0),
        Some("number") => value.is_number(),
        Some("string") => value.is_string(),
        Some("array") => value.is_array(),
        Some("object") => value.is_object(),
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn each_keyword_refuses_what_breaks_it() {
        let schema = json!({
            "type": "object",
            "properties": {
                "n": { "type": ["integer", "null"], "minimum": 1, "maximum": 3 },
                "l": { "type": "array", "items": { "$ref": "#/$defs/word" }, "minItems": 1, "maxItems": 2 },
                "e": { "anyOf": [{ "const": "a" }, { "type": "boolean" }] },
            },
            "required": ["n"],
            "$defs": { "word": { "enum": ["x", "y"] } },
        });
        let good = |value: Value| conforms(&value, &schema).expect("conforms");
        let bad = |value: Value| conforms(&value, &schema).expect_err("does not");
        good(json!({ "n": 2, "l": ["x"], "e": "a" }));
        good(json!({ "n": null, "l": ["y", "x"], "e": true }));
        for (value, place) in [
            (json!([]), "$: "),
            (json!({}), "$: n is missing"),
            (json!({ "n": 0 }), "$.n: "),
            (json!({ "n": 4 }), "$.n: "),
            (json!({ "n": 1.5 }), "$.n: "),
            (json!({ "n": 1, "l": [] }), "$.l: "),
            (json!({ "n": 1, "l": ["x", "x", "x"] }), "$.l: "),
            (json!({ "n": 1, "l": ["z"] }), "$.l[0]: "),
            (json!({ "n": 1, "e": "b" }), "$.e: "),
            (json!({ "n": 1, "f": 1 }), "$.f: is not in the schema"),
        ] {
            let error = bad(value);
            assert!(error.starts_with(place), "{error}");
        }
        assert!(conforms(&json!(1), &json!({ "not": {} })).is_err());
        assert!(conforms(&json!(1), &json!({ "oneOf": [true, true] })).is_err());
        assert!(conforms(&json!(1), &json!({ "allOf": [true, false] })).is_err());
        conforms(
            &json!({ "a": 1 }),
            &json!({ "additionalProperties": { "type": "number" } }),
        )
        .expect("conforms");
    }
}
