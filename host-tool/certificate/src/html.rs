//! One HTML page with everything inside: works offline, prints well, zooms.

use super::present::Presented;
use calib_files::{Error, Result};
use minijinja::value::{Serde, Value};
use minijinja::{AutoEscape, Environment, context};

const TEMPLATE: &str = include_str!("page/page.html");
const STYLE: &str = include_str!("page/style.css");
const SCRIPT: &str = include_str!("page/zoom.js");

/// The certificate as one self-contained HTML page.
///
/// # Errors
/// [`Error::Input`] naming the template line, if the template does not render.
pub(super) fn render(presented: &Presented) -> Result<Vec<u8>> {
    let mut environment = Environment::new();
    environment.set_auto_escape_callback(|_| AutoEscape::Html);
    let page = environment
        .template_from_named_str("page.html", TEMPLATE)
        .and_then(|template| {
            template.render(context! {
                c => Value::from(Serde(presented)),
                style => STYLE,
                script => SCRIPT,
                paper => paper(presented),
            })
        });
    page.map(String::into_bytes).map_err(|error| {
        let line = error
            .line()
            .map(|line| format!(":{line}"))
            .unwrap_or_default();
        Error::input(
            format!("page.html{line}"),
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
