//! One HTML page with everything inside: works offline, prints well, zooms.

use super::present::Presented;
use calib_files::{Error, Result};
use minijinja::value::{Serde, Value};
use minijinja::{AutoEscape, Environment};
use serde::Serialize;

const TEMPLATE: &str = include_str!("page/page.html");
const STYLE: &str = include_str!("page/style.css");
const SCRIPT: &str = include_str!("page/zoom.js");

/// The certificate as one self-contained HTML page.
///
/// # Errors
/// [`Error::Input`] naming the template line, if the template does not render.
pub(super) fn render(presented: &Presented) -> Result<Vec<u8>> {
    let values = Values {
        c: presented,
        style: STYLE,
        script: SCRIPT,
        paper: paper(presented),
    };
    page("page.html", TEMPLATE, &values).map(String::into_bytes)
}

/// Values at hand for the template.
#[derive(Serialize)]
struct Values<'a> {
    c: &'a Presented,
    style: &'a str,
    script: &'a str,
    paper: String,
}

/// A page of HTML by a template; values are escaped, unless it says they are HTML.
///
/// # Errors
/// [`Error::Input`] naming the line of the template `name`, if it does not render.
pub fn page(name: &str, template: &str, values: &impl Serialize) -> Result<String> {
    let mut environment = Environment::new();
    environment.set_auto_escape_callback(|_| AutoEscape::Html);
    let page = environment
        .template_from_named_str(name, template)
        .and_then(|template| template.render(Value::from(Serde(values))));
    page.map_err(|error| {
        let line = error
            .line()
            .map(|line| format!(":{line}"))
            .unwrap_or_default();
        Error::input(
            format!("{name}{line}"),
            error.to_string(),
            "correct the template",
        )
    })
}

/// Number of the certificate and "page n of m" on every printed page.
fn paper(presented: &Presented) -> String {
    let word = |key: &str| css(presented.words.get(key).map_or("", String::as_str));
    format!(
        "@page {{ @bottom-left {{ content: {}; }} @bottom-right {{ content: {} \" \" counter(page) \" \" {} \" \" counter(pages); }} }}",
        css(&presented.number),
        word("page"),
        word("of"),
    )
}

/// A string of CSS: everything but letters and figures escaped.
fn css(text: &str) -> String {
    let escaped = |c: char| match c.is_ascii_alphanumeric() {
        true => c.to_string(),
        false => format!("\\{:x} ", u32::from(c)),
    };
    format!("\"{}\"", text.chars().map(escaped).collect::<String>())
}

#[cfg(test)]
mod tests {
    use super::css;

    #[test]
    fn a_string_of_css_cannot_be_left() {
        assert_eq!(css("A-1"), "\"A\\2d 1\"");
        assert_eq!(css("\"</style>"), "\"\\22 \\3c \\2f style\\3e \"");
    }
}
