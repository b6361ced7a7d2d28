//! The page itself: files that are part of the program.

use axum::Router;
use axum::http::header;
use axum::routing::get;

/// Path, kind, content.
type Asset = (&'static str, &'static str, &'static str);

const HTML: &str = "text/html; charset=utf-8";
const SCRIPT: &str = "text/javascript; charset=utf-8";

const PAGE: Asset = ("/", HTML, include_str!("page/index.html"));

/// Files of the page. They hold nothing of anybody's, and links to them hold
/// no token: everybody may read it.
const PARTS: [Asset; 9] = [
    ("/style.css", "text/css", include_str!("page/style.css")),
    ("/icon.svg", "image/svg+xml", include_str!("page/icon.svg")),
    ("/page.js", SCRIPT, include_str!("page/page.js")),
    ("/chart.js", SCRIPT, include_str!("page/chart.js")),
    ("/server.js", SCRIPT, include_str!("page/server.js")),
    ("/live.js", SCRIPT, include_str!("page/live.js")),
    (
        "/measurement.js",
        SCRIPT,
        include_str!("page/measurement.js"),
    ),
    ("/waveforms.js", SCRIPT, include_str!("page/waveforms.js")),
    ("/records.js", SCRIPT, include_str!("page/records.js")),
];

/// Whether everybody may read this path.
pub(super) fn is_open(path: &str) -> bool {
    PARTS.iter().any(|(open, ..)| *open == path)
}

/// Adds the page and its parts.
pub(super) fn add<S: Clone + Send + Sync + 'static>(router: Router<S>) -> Router<S> {
    let all = [PAGE].into_iter().chain(PARTS);
    all.fold(router, |router, (path, kind, content)| {
        let answer = move || async move { ([(header::CONTENT_TYPE, kind)], content) };
        router.route(path, get(answer))
    })
}
