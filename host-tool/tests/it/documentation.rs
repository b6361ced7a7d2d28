//! The pages show what the program prints.
//!
//! Blocks marked `console` in docs/metrology begin with `$ calib ...`. The
//! program is run with these arguments from the top of the repository, and
//! every line below must be printed, in this order; `...` stands for lines
//! left out.

use crate::tool;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// A verb with arguments, and the lines shown for it.
struct Example {
    page: PathBuf,
    arguments: Vec<String>,
    lines: Vec<String>,
}

fn top() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn examples() -> Vec<Example> {
    let folder = std::fs::read_dir(top().join("docs/metrology")).expect("docs");
    let pages = folder.map(|entry| entry.expect("entry").path());
    let mut examples = Vec::new();
    for page in pages.filter(|path| path.extension().is_some_and(|kind| kind == "md")) {
        let text = std::fs::read_to_string(&page).expect("page");
        for block in text.split("```console\n").skip(1) {
            let block = block.split("```").next().unwrap_or("");
            let mut lines = block.lines().map(str::to_owned);
            let command = lines.next().expect("a command");
            let arguments = command
                .strip_prefix("$ calib ")
                .expect("a console block begins with $ calib");
            examples.push(Example {
                page: page.clone(),
                arguments: arguments.split_whitespace().map(str::to_owned).collect(),
                lines: lines.collect(),
            });
        }
    }
    examples
}

fn printed(arguments: &[String]) -> Vec<String> {
    let output = tool(&top()).args(arguments).output();
    let output = output.expect("calib starts");
    let text = String::from_utf8(output.stdout).expect("text");
    text.lines().map(str::to_owned).collect()
}

#[test]
fn every_line_shown_is_printed() {
    let mut verbs = BTreeSet::new();
    for example in examples() {
        let printed = printed(&example.arguments);
        let mut rest = printed.iter();
        for line in &example.lines {
            assert!(
                line == "..." || rest.any(|found| found.trim_end() == line.trim_end()),
                "{}: calib {} does not print, in this place:\n{line}\nbut:\n{}",
                example.page.display(),
                example.arguments.join(" "),
                printed.join("\n")
            );
        }
        verbs.extend(example.arguments.into_iter().next());
    }
    // `check` takes a record, which no text page can hold: its page is compared
    // in the module of the check.
    let expected = [
        "budget",
        "convert",
        "identify",
        "linking",
        "nomogram",
        "phase",
        "points",
        "predict",
        "sensitivity",
    ];
    assert_eq!(verbs.into_iter().collect::<Vec<_>>(), expected);
}

#[test]
fn every_verb_has_a_json_form() {
    for mut example in examples() {
        example.arguments.push("--json".into());
        let text = printed(&example.arguments).join("\n");
        let parsed: Result<serde_json::Value, _> = serde_json::from_str(&text);
        assert!(parsed.is_ok(), "{:?}: {text}", example.arguments);
    }
}
