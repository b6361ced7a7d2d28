//! What the documents show is what happens.

use super::tool;
use std::net::TcpListener;
use std::path::Path;
use std::process::Command;

/// A command of a document, and the lines it is said to print.
#[derive(Debug, Default)]
struct Step {
    command: String,
    shown: Vec<String>,
}

/// Steps of all `console` blocks.
fn steps(document: &str) -> Vec<Step> {
    let mut steps: Vec<Step> = Vec::new();
    let mut within = false;
    for line in document.lines() {
        match line.strip_prefix("$ ") {
            _ if line.starts_with("```") => within = line == "```console",
            _ if !within => {}
            Some(command) => steps.push(Step {
                command: command.to_owned(),
                shown: Vec::new(),
            }),
            None => {
                let step = steps.last_mut().expect("a command before its output");
                step.shown.push(line.to_owned());
            }
        }
    }
    steps
}

/// One shell runs them all, so that what is exported stays; what goes on in the background ends with it.
fn script(steps: &[Step], port: u16) -> String {
    let mut script = "trap 'kill $(jobs -p) 2>/dev/null' EXIT\n".to_owned();
    for step in steps {
        script += &format!("echo '@@'; {{ {}\n}} 2>&1; code=$?\n", step.command);
        if step.command.ends_with('&') {
            script += &format!(
                "for try in $(seq 600); do (exec 3<>/dev/tcp/127.0.0.1/{port}) 2>/dev/null && break; sleep 0.1; done\n"
            );
        }
        script += "echo \"@code $code\"\n";
    }
    script
}

/// Whether a line is what the document shows, `[..]` standing for anything.
fn is_shown(line: &str, shown: &str) -> bool {
    let mut parts = shown.split("[..]");
    let Some(mut rest) = parts.next().and_then(|first| line.strip_prefix(first)) else {
        return false;
    };
    let mut last = "";
    for part in parts {
        match rest.find(part) {
            Some(at) => rest = &rest[at + part.len()..],
            None => return false,
        }
        last = part;
    }
    rest.is_empty() || (shown.contains("[..]") && last.is_empty())
}

/// The lines in their order, `...` standing for any number of others.
fn holds(printed: &[&str], shown: &[String]) -> bool {
    match shown.split_first() {
        None => printed.is_empty(),
        Some((first, rest)) if first == "..." => {
            (0..=printed.len()).any(|skipped| holds(&printed[skipped..], rest))
        }
        Some((first, rest)) => printed
            .split_first()
            .is_some_and(|(line, after)| is_shown(line, first) && holds(after, rest)),
    }
}

#[test]
fn lines_left_out_and_parts_left_out_are_understood() {
    let shown = |lines: &[&str]| {
        lines
            .iter()
            .map(|line| (*line).to_owned())
            .collect::<Vec<_>>()
    };
    assert!(holds(
        &["a", "b 1 c", "d"],
        &shown(&["...", "b [..] c", "..."])
    ));
    assert!(!holds(&["a", "d"], &shown(&["...", "b [..] c", "..."])));
    assert!(!holds(&["a", "b"], &shown(&["a"])));
    assert!(is_shown("x: 3", "x: [..]") && !is_shown("x: 3 !", "x: 3"));
}

#[test]
fn the_tutorial_does_what_it_shows() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/tutorial.md");
    let port = TcpListener::bind("127.0.0.1:0").and_then(|free| free.local_addr());
    let port = port.expect("a free port").port();
    let document = std::fs::read_to_string(path).expect("there");
    let steps = steps(&document.replace("5025", &port.to_string()));
    assert!(steps.len() > 10);
    let folder = tempfile::tempdir().expect("a folder");
    let tools = tool();
    let tools = tools.parent().expect("a folder").display().to_string();
    let output = Command::new("bash")
        .args(["-c", &script(&steps, port)])
        .current_dir(folder.path())
        .env(
            "PATH",
            format!("{tools}:{}", std::env::var("PATH").unwrap_or_default()),
        )
        .env("CALIB_STATE_DIR", folder.path().join("state"))
        .env("NO_COLOR", "1")
        .env_remove("CALIB_DEVICE")
        .output()
        .expect("bash");
    let output = String::from_utf8_lossy(&output.stdout).into_owned();
    let answers: Vec<&str> = output.split("@@\n").skip(1).collect();
    assert_eq!(answers.len(), steps.len(), "{output}");
    for (step, answer) in steps.iter().zip(answers) {
        let (printed, code) = answer.rsplit_once("@code ").expect("a code");
        assert_eq!(code.trim(), "0", "{}: {printed}", step.command);
        let printed: Vec<&str> = printed.lines().map(str::trim_end).collect();
        assert!(
            holds(&printed, &step.shown),
            "{}: {printed:#?}",
            step.command
        );
    }
}
