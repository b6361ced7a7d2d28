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
const PARTS: [Asset; 13] = [
    ("/style.css", "text/css", include_str!("page/style.css")),
    ("/icon.svg", "image/svg+xml", include_str!("page/icon.svg")),
    ("/page.js", SCRIPT, include_str!("page/page.js")),
    ("/chart.js", SCRIPT, include_str!("page/chart.js")),
    ("/de.js", SCRIPT, include_str!("page/de.js")),
    ("/sensors.js", SCRIPT, include_str!("page/sensors.js")),
    ("/server.js", SCRIPT, include_str!("page/server.js")),
    ("/words.js", SCRIPT, include_str!("page/words.js")),
    ("/live.js", SCRIPT, include_str!("page/live.js")),
    (
        "/measurement.js",
        SCRIPT,
        include_str!("page/measurement.js"),
    ),
    ("/waveforms.js", SCRIPT, include_str!("page/waveforms.js")),
    ("/issued.js", SCRIPT, include_str!("page/issued.js")),
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::refusals;
    use calib_certificate::Language;
    use calib_protocol::health::Defect;
    use std::collections::{BTreeMap, BTreeSet};

    fn content(name: &str) -> &'static str {
        let part = PARTS.iter().find(|(path, ..)| *path == name);
        part.expect("a part of the page").2
    }

    fn german() -> BTreeMap<String, String> {
        let file = content("/de.js");
        let (_, table) = file.split_once("german = ").expect("the table");
        serde_json::from_str(table.trim_end().trim_end_matches(';')).expect("a table of texts")
    }

    /// Texts between `before` and `after`, wherever there are any.
    fn between(text: &str, before: &str, after: &str) -> Vec<String> {
        let parts = text.split(before).skip(1);
        let inner = parts.filter_map(|part| Some(part.split_once(after)?.0.trim().to_owned()));
        inner.collect()
    }

    /// Texts of the page: what stands between its tags and in attributes that are read out.
    fn written() -> BTreeSet<String> {
        let (_, body) = PAGE.2.split_once("<body>").expect("a body");
        let mut texts = between(body, ">", "<");
        for attribute in ["placeholder=\"", "aria-label=\""] {
            texts.extend(between(body, attribute, "\""));
        }
        let symbols = ["calib", "Hz", "mV", "m/s", "V", "UFF58", "PDF", "STOP"];
        let is_symbol = |text: &String| symbols.iter().any(|symbol| text.starts_with(symbol));
        let words = |text: &String| text.chars().filter(|c| c.is_lowercase()).count() > 1;
        texts.retain(|text| words(text) && (!is_symbol(text) || text.contains(' ')));
        texts.into_iter().collect()
    }

    /// Texts the server sends for somebody to read.
    fn sent() -> BTreeSet<String> {
        let table = refusals::table(Language::En);
        let refusals = table.iter().map(|line| line.remedy.to_owned());
        let defects = Defect::ALL.map(|defect| format!("{}: {}", defect.text(), defect.remedy()));
        refusals.chain(defects).collect()
    }

    #[test]
    fn every_text_of_the_page_has_german_words() {
        let german = german();
        let scripts: String = PARTS
            .iter()
            .filter(|(path, ..)| path.ends_with(".js") && *path != "/de.js")
            .map(|(.., content)| *content)
            .collect();
        let mut asked = written();
        asked.extend(sent());
        for call in ["say(\"", "word(\""] {
            asked.extend(between(&scripts, call, "\""));
        }
        let missing: Vec<_> = asked
            .iter()
            .filter(|text| !german.contains_key(*text))
            .collect();
        assert!(missing.is_empty(), "de.js lacks {missing:#?}");
    }

    #[test]
    fn the_page_judges_in_the_words_of_certificates() {
        let page = german();
        let keys = [
            "pass",
            "conditionalPass",
            "conditionalFail",
            "fail",
            "notJudgeable",
        ];
        for key in keys.map(|key| format!("conformity.{key}")) {
            assert_eq!(page[Language::En.word(&key)], Language::De.word(&key));
        }
    }

    #[test]
    fn german_words_are_for_texts_there_are_and_keep_their_places() {
        let sources: String = PARTS
            .iter()
            .filter(|(path, ..)| *path != "/de.js")
            .map(|(.., content)| *content)
            .chain([
                PAGE.2,
                include_str!("calibrator_side.rs"),
                include_str!("stops.rs"),
            ])
            .chain([include_str!("routes.rs")])
            .collect();
        let sent = sent();
        for (english, german) in german() {
            let states = [
                "conditional pass",
                "conditional fail",
                "not judgeable",
                "pass",
                "fail",
            ];
            let known = sources.contains(&english) || sent.contains(&english);
            let made = english.ends_with("within 200 ms") || states.contains(&english.as_str());
            assert!(known || made, "nobody says '{english}' any more");
            for place in ["{0}", "{1}", "{2}"] {
                let (asked, kept) = (english.contains(place), german.contains(place));
                assert_eq!(asked, kept, "{place} of '{english}'");
            }
        }
    }
}
