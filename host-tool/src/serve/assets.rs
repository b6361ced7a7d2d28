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
const PARTS: [Asset; 15] = [
    ("/style.css", "text/css", include_str!("page/style.css")),
    ("/icon.svg", "image/svg+xml", include_str!("page/icon.svg")),
    ("/page.js", SCRIPT, include_str!("page/page.js")),
    ("/chart.js", SCRIPT, include_str!("page/chart.js")),
    ("/de.js", SCRIPT, include_str!("page/de.js")),
    ("/errors.js", SCRIPT, include_str!("page/errors.js")),
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
    ("/checks.js", SCRIPT, include_str!("page/checks.js")),
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
        let symbols = [
            "calib", "Hz", "mV", "pC", "mA", "m/s", "V", "UFF58", "PDF", "STOP",
        ];
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
            .filter(|(path, ..)| path.ends_with(".js") && !["/de.js", "/errors.js"].contains(path))
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

    /// Words of the page for failures by the words of the server; German alone, or English and German.
    fn failures() -> BTreeMap<String, Vec<String>> {
        let file = content("/errors.js");
        let (_, table) = file.split_once("failures = ").expect("the table");
        let lines = table.lines().filter(|line| !line.trim().is_empty());
        let table: String = lines.collect();
        let words: BTreeMap<String, serde_json::Value> =
            serde_json::from_str(table.trim_end_matches(';')).expect("a table of texts");
        let all = |words| match words {
            serde_json::Value::Array(pair) => pair,
            one => vec![one],
        };
        let texts = words.into_iter().map(|(text, words)| {
            let words = all(words).into_iter();
            (
                text,
                words
                    .map(|one| one.as_str().expect("a text").to_owned())
                    .collect(),
            )
        });
        texts.collect()
    }

    /// Whether a text is one of the table, with anything in its places.
    fn is_known(failures: &BTreeMap<String, Vec<String>>, text: &str) -> bool {
        let matches = |pattern: &String| {
            let mut rest = text;
            let mut parts = pattern.split(['{', '}']).step_by(2);
            let first = parts.next().unwrap_or_default();
            let Some(begun) = rest.strip_prefix(first) else {
                return false;
            };
            rest = begun;
            let mut last = first;
            for part in parts {
                let Some(at) = rest.find(part) else {
                    return false;
                };
                rest = &rest[at + part.len()..];
                last = part;
            }
            rest.is_empty() || (last.is_empty() && pattern.ends_with('}'))
        };
        failures.keys().any(matches)
    }

    /// Everything a link or a calibrator can answer an order of a page with: message and way out.
    fn refused_and_broken() -> Vec<(String, String)> {
        use calib_link::{Error, LinkError, ProtocolError, Refused};
        use calib_protocol::health::Defects;
        use calib_protocol::message::Refusal;
        let gone = || std::io::Error::other("gone");
        let address = || "COM3".to_owned();
        let links = [
            LinkError::Closed {
                address: address(),
                source: gone(),
            },
            LinkError::NoAnswer {
                address: address(),
                attempts: 4,
            },
            LinkError::NotACalibrator {
                address: address(),
                bytes: 7,
            },
            LinkError::Late {
                address: address(),
                late: 4,
                attempts: 4,
            },
            LinkError::Damaged {
                address: address(),
                damaged: 4,
                attempts: 4,
            },
            LinkError::StopUnconfirmed {
                address: address(),
                source: Box::new(LinkError::NoAnswer {
                    address: address(),
                    attempts: 1,
                }),
            },
        ];
        let protocols = [
            ProtocolError::Version { device: u16::MAX },
            ProtocolError::Version { device: 0 },
            ProtocolError::UnexpectedAnswer {
                request: "its status",
            },
        ];
        // Zeros are fields of any kind; the last number is none yet.
        let refusal = |number: u8| {
            let mut bytes = [0; 10];
            bytes[0] = number;
            postcard::from_bytes::<Refusal>(&bytes).ok()
        };
        let refusals = (0..=u8::MAX).map_while(refusal);
        let defects = Defect::ALL.map(|defect| Refusal::Degraded(Defects::NONE.with(defect)));
        let refused = refusals.chain(defects).map(|refusal| {
            Error::from(Refused {
                request: "to start a run",
                refusal,
            })
        });
        let all = links.into_iter().map(Error::from);
        let all = all
            .chain(protocols.into_iter().map(Error::from))
            .chain(refused);
        all.map(|error| {
            (
                error.to_string(),
                error.hint().unwrap_or_default().to_owned(),
            )
        })
        .collect()
    }

    #[test]
    fn every_failure_of_link_and_calibrator_has_words_of_the_page() {
        let failures = failures();
        let all = refused_and_broken();
        assert!(all.len() > 40, "{}", all.len());
        for (message, hint) in all {
            assert!(is_known(&failures, &message), "errors.js lacks '{message}'");
            assert!(
                hint.is_empty() || is_known(&failures, &hint),
                "errors.js lacks '{hint}'"
            );
            let reason = message.split_once(": ").map_or("", |(_, reason)| reason);
            let refused = message.starts_with("the calibrator refused");
            assert!(
                !refused || is_known(&failures, reason),
                "errors.js lacks '{reason}'"
            );
        }
    }

    /// The reasons for which an instrument declines are held in full beside its numbers, where all of them are at hand.
    #[test]
    fn every_failure_of_a_link_is_in_the_docs_with_its_way_out() {
        let docs = include_str!("../../../docs/troubleshooting.md");
        let all = refused_and_broken();
        let broken = all
            .iter()
            .filter(|(message, _)| !message.starts_with("the calibrator refused"));
        assert_eq!(broken.clone().count(), 9);
        for (message, hint) in broken {
            let words = message.replace("COM3", "PORT");
            let ends = |row: &&str| {
                let words_of_row = row.split(" | ").next().unwrap_or_default();
                words.starts_with(words_of_row.trim_start_matches("| "))
            };
            let mut rows = docs.lines().filter(|row| row.starts_with("| "));
            let row = rows.find(|row| ends(row) && row.ends_with(&format!("| {hint} |")));
            assert!(
                row.is_some(),
                "docs/troubleshooting.md lacks '{words}': {hint}"
            );
        }
    }

    #[test]
    fn words_of_failures_keep_their_places() {
        for (text, words) in failures() {
            for place in ["{0}", "{1}", "{2}"] {
                for word in words
                    .iter()
                    .filter(|_| words.len() == 1 || !text.contains("--amend"))
                {
                    assert_eq!(
                        text.contains(place),
                        word.contains(place),
                        "{place} of '{word}'"
                    );
                }
            }
        }
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
            .filter(|(path, ..)| !["/de.js", "/errors.js"].contains(path))
            .map(|(.., content)| *content)
            .chain([
                PAGE.2,
                include_str!("calibrator_side.rs"),
                include_str!("stops.rs"),
                include_str!("view.rs"),
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
