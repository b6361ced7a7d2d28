//! One HTML page with everything inside: works offline, prints well, zooms.

use super::present::Presented;
use crate::{Error, Result};
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
            template.render(
                context! { c => Value::from(Serde(presented)), style => STYLE, script => SCRIPT },
            )
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
