//! `calib gap` from the outside: datasets of known cause, sealed sets, bad input.

use crate::command_line::{calib, json, text};
use serde_json::Value;
use std::path::Path;

/// Lines of JSON lines.
fn lines(bytes: &[u8]) -> Vec<Value> {
    let parse = |line| serde_json::from_str(line).expect("a JSON document per line");
    text(bytes).lines().map(parse).collect()
}

fn simulate(directory: &Path, out: &str, more: &[&str]) -> Value {
    let arguments = ["gap", "simulate", "standard", "--json", "--out", out];
    json(&calib(directory, &[&arguments, more].concat()))
}

#[test]
fn a_simulated_effect_is_named_and_the_dataset_does_not_tell_it() {
    let directory = tempfile::tempdir().expect("directory");
    let path = directory.path();
    let effect = "dut_resonance=resonance_hz:31000";
    let made = simulate(path, "a", &["--effect", effect, "--seed", "5"]);
    assert_eq!(made["rows"], 214);
    assert_eq!(
        made["effects"][0],
        "dut_resonance=resonance_hz:31000,quality:25"
    );
    for file in ["rig.toml", "points.csv"] {
        let content = std::fs::read_to_string(path.join("a").join(file)).expect("written");
        assert!(!content.contains("resonance") && !content.contains("31000"));
    }
    let report = ["gap", "diagnose", "a", "--json", "--report", "a.html"];
    let answer = json(&calib(path, &report));
    assert_eq!(answer["verdict"], "explained");
    assert_eq!(answer["causes"][0]["effects"][0], "dut_resonance");
    let resonance = &answer["causes"][0]["parameters"]["dut_resonance"]["resonance_hz"];
    let (value, u) = (resonance["value"].as_f64(), resonance["u"].as_f64());
    // Five of its own standard uncertainties.
    assert!(
        (value.expect("number") - 31e3).abs() < 5.0 * u.expect("number"),
        "{resonance}"
    );
    let page = std::fs::read_to_string(path.join("a.html")).expect("written");
    assert!(page.contains("dut_resonance"));
    // Never over an existing dataset.
    let again = ["gap", "simulate", "standard", "--out", "a"];
    assert_eq!(calib(path, &again).status.code(), Some(6));
}

#[test]
fn the_same_seed_gives_the_same_dataset_and_another_one_another() {
    let directory = tempfile::tempdir().expect("directory");
    let path = directory.path();
    let points = |out: &str, seed: &str| {
        simulate(path, out, &["--seed", seed, "--columns", "ratio"]);
        std::fs::read_to_string(path.join(out).join("points.csv")).expect("written")
    };
    let (first, again, other) = (points("a", "9"), points("b", "9"), points("c", "10"));
    assert_eq!(first, again);
    assert_ne!(first, other);
    let header = first.lines().next().expect("header");
    assert!(
        header.contains("ratio") && !header.contains("coil_v"),
        "{header}"
    );
}

#[test]
fn effects_are_described_with_units_bounds_columns_and_confusions() {
    let directory = tempfile::tempdir().expect("directory");
    let all = json(&calib(directory.path(), &["gap", "effects", "--json"]));
    let all = all.as_array().expect("a list");
    // 42 nameable, two constant gains, eleven of oscillators.
    assert_eq!(all.len(), 55);
    for entry in all {
        let parameters = entry["parameters"].as_array().expect("parameters");
        assert!(!parameters.is_empty(), "{entry}");
        for p in parameters {
            assert!(p["lower"].as_f64() < p["upper"].as_f64(), "{entry}");
            assert!(p["unit"].is_string());
        }
        assert!(!entry["columns"].as_array().expect("columns").is_empty());
        assert!(
            !entry["confused_with"].as_array().expect("names").is_empty(),
            "{entry}"
        );
    }
    let one = text(&calib(directory.path(), &["gap", "effects", "channel_skew"]).stdout);
    assert!(
        one.contains("crosstalk") && one.contains("told apart by"),
        "{one}"
    );
    let wrong = calib(directory.path(), &["gap", "effects", "channel_scew"]);
    assert_eq!(wrong.status.code(), Some(2));
    assert!(text(&wrong.stderr).contains("channel_skew"));
}

#[test]
fn a_wrong_effect_is_refused_with_its_bounds() {
    let directory = tempfile::tempdir().expect("directory");
    for (effect, hint) in [
        ("suspension_cubic=k3_n_per_m3:1e99", "N/m3"),
        ("suspension_cubic=k4:1", "k3_n_per_m3"),
        ("suspension_cubic=k3_n_per_m3", "PARAM:VALUE"),
        ("suspension", "suspension_cubic"),
    ] {
        let arguments = [
            "gap", "simulate", "standard", "--out", "a", "--effect", effect,
        ];
        let output = calib(directory.path(), &arguments);
        assert_eq!(output.status.code(), Some(2), "{effect}");
        assert!(
            text(&output.stderr).contains(hint),
            "{}",
            text(&output.stderr)
        );
        assert!(!directory.path().join("a").exists());
    }
}

#[test]
fn a_sealed_set_is_answered_in_one_call_and_opened_only_with_its_own_truth() {
    let directory = tempfile::tempdir().expect("directory");
    let path = directory.path();
    let arguments = [
        "gap",
        "challenge",
        "set",
        "--cases",
        "2",
        "--seed",
        "11",
        "--strata",
        "null,ratio-only,withheld",
        "--json",
    ];
    let sealed = json(&calib(path, &arguments));
    assert_eq!(sealed["cases"], 6);
    let manifest = std::fs::read_to_string(path.join("set/challenge.json")).expect("manifest");
    let published = sealed["truth_sha256"].as_str().expect("a sum");
    assert!(manifest.contains(published));
    assert!(!manifest.contains("seed"), "the seed gives the truth away");

    let answers = calib(
        path,
        &["gap", "diagnose", "set", "--json", "--max-effects", "1"],
    );
    let list = lines(&answers.stdout);
    assert_eq!(list.len(), 6);
    assert!(text(&answers.stderr).contains("6 of 6 datasets"));
    std::fs::write(path.join("answers.jsonl"), &answers.stdout).expect("written");
    let score = ["gap", "score", "answers.jsonl", "set-truth.json", "--json"];
    let scored = json(&calib(path, &score));
    assert_eq!(scored["strata"]["null"]["false_alarm"]["of"], 2);
    assert_eq!(scored["strata"]["null"]["unanswered"], 0);
    assert_eq!(scored["strata"]["ratio-only"]["top_1"]["of"], 2);
    assert!(scored["strata"]["withheld"]["top_1"].is_null());

    // One more blank, and it is not what was sealed.
    let truth = std::fs::read_to_string(path.join("set-truth.json")).expect("truth");
    std::fs::write(path.join("set-truth.json"), truth.clone() + " ").expect("written");
    let refused = calib(path, &score);
    assert_eq!(refused.status.code(), Some(6));
    assert!(text(&refused.stderr).contains(published));
    std::fs::write(path.join("elsewhere.json"), truth).expect("written");
    let lost = calib(path, &["gap", "score", "answers.jsonl", "elsewhere.json"]);
    assert_eq!(lost.status.code(), Some(2));
    let named = [
        "gap",
        "score",
        "answers.jsonl",
        "elsewhere.json",
        "--sha256",
        published,
    ];
    assert!(calib(path, &named).status.success());
    // Never over an existing set.
    assert_eq!(calib(path, &arguments).status.code(), Some(6));
}
