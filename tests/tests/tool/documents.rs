//! The documents show things as they happen.

use super::tool;
use calib_core::point_state::Reason;
use calib_firmware::scpi::ScpiError;
use calib_link::Refused;
use calib_protocol::health::{Defect, Defects};
use calib_protocol::message::Refusal;
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
fn script(before: &str, steps: &[Step], port: u16) -> String {
    let listens = format!(
        "listens() {{ for try in $(seq 600); do (exec 3<>/dev/tcp/127.0.0.1/{port}) 2>/dev/null && break; sleep 0.1; done; }}\n"
    );
    let mut script = "trap 'kill $(jobs -p) 2>/dev/null' EXIT\n".to_owned() + &listens + before;
    for step in steps {
        script += &format!("echo '@@'; {{ {}\n}} 2>&1; code=$?\n", step.command);
        if step.command.ends_with('&') {
            script += "listens\n";
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

/// Runs the `console` blocks of a page in an empty folder, after what is there before: each command succeeds, and prints
/// what the page shows.
fn does_what_it_shows(page: &str, before: &str, fewest: usize) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../docs")
        .join(page);
    let port = TcpListener::bind("127.0.0.1:0").and_then(|free| free.local_addr());
    let port = port.expect("a free port").port();
    // A sealed set of 160 datasets is a matter of a minute, and one of 16 is as good.
    let with_port = |text: &str| {
        text.replace("5025", &port.to_string())
            .replace("--cases 20", "--cases 2")
    };
    let document = std::fs::read_to_string(path).expect("there");
    let steps = steps(&with_port(&document));
    assert!(steps.len() >= fewest, "{}", steps.len());
    let folder = tempfile::tempdir().expect("a folder");
    let tools = tool();
    let tools = tools.parent().expect("a folder").display().to_string();
    let output = Command::new("bash")
        .args(["-c", &script(&with_port(before), &steps, port)])
        .current_dir(folder.path())
        .env(
            "PATH",
            format!("{tools}:{}", std::env::var("PATH").unwrap_or_default()),
        )
        .env("HOME", folder.path())
        .env("CALIB_STATE_DIR", folder.path().join("state"))
        .env("CALIB_CONFIG", folder.path().join("config.toml"))
        .env("NO_COLOR", "1")
        .env_remove("CALIB_DEVICE")
        .env_remove("CALIB_LOGBOOK")
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

#[test]
fn the_tutorial_does_what_it_shows() {
    does_what_it_shows("tutorial.md", "", 11);
}

#[test]
fn the_page_of_the_gap_does_what_it_shows() {
    does_what_it_shows("gap.md", "", 7);
}

/// A calibrator with its button held, a sensor measured six times, and the keys of two laboratories.
///
/// A control chart calls one of some two hundred sound series out of control. That the reference is another for two of
/// the six, by 0.1 % where the noise is 0.01 %, leaves nothing of that to chance: no six results rise or fall, and the
/// limits are wide.
#[test]
fn the_page_of_the_tool_does_what_it_shows() {
    let keys = Path::new(env!("CARGO_MANIFEST_DIR")).join("../host-tool/signing/test-keys");
    let before = format!(
        "keys='{}'
cp $keys/p256.p12 laboratory.p12; cp $keys/p256.pem laboratory.pem; cp laboratory.pem old.pem
cp $keys/rsa.p12 new.p12; cp $keys/rsa.pem new.pem
export CALIB_KEY_PASSWORD=test CALIB_LOGBOOK=$PWD/logbook.sqlite CALIB_DEVICE=tcp:127.0.0.1:5025
mkdir -p .local/share/bash-completion/completions
calib emulate --tcp 5025 --hold-button > emulator.log 2>&1 &
listens
printf 'frequency_hz\n160\n80\n' > pump.csv
{{ calib sensors add --serial LW1 --sensitivity 98 --unit mV/g
calib settings > settings.toml; awk '/^sensitivity_v_per_ms2/ {{ $3 *= 0.999 }} 1' settings.toml > lower.toml
measure() {{ for nth in $(seq $1); do calib run --sensor LW1 --points pump.csv; done; }}
measure 2; calib settings --write lower.toml; measure 2; calib settings --write settings.toml; measure 2; }} > before.log 2>&1
",
        keys.display()
    );
    does_what_it_shows("host-tool.md", &before, 12);
}

/// One name, one text, one way out, and one number of SCPI for everything an instrument declines.
#[test]
fn what_an_instrument_declines_is_said_alike_everywhere() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/troubleshooting.md");
    let document = std::fs::read_to_string(path).expect("there");
    // Zeros are fields of any kind; the last number is none yet.
    let refusal = |number: u8| {
        let mut bytes = [0; 10];
        bytes[0] = number;
        postcard::from_bytes::<Refusal>(&bytes).ok()
    };
    let defects = Defect::ALL.map(|defect| Refusal::Degraded(Defects::NONE.with(defect)));
    let without = Refusal::Degraded(Defects::NONE);
    let all = (0..=u8::MAX).map_while(refusal).filter(|r| *r != without);
    let all: Vec<Refusal> = all.chain(defects).collect();
    assert!(all.len() > 30, "{}", all.len());
    for refusal in all {
        let debug = format!("{refusal:?}");
        let name = debug.split([' ', '(']).next().expect("a name");
        let refused = Refused {
            request: "it",
            refusal,
        };
        let said = refused.to_string();
        let words = said.split_once(": ").expect("a reason").1;
        let words = words
            .replace("point 1 ", "point N ")
            .replace(&Reason::Clipped.to_string(), "the reason");
        let name = match refusal {
            Refusal::Degraded(defects) => {
                let defect = defects.iter().next().expect("one");
                format!("| `{name}`, [{defect:?}](safety.md#degraded)")
            }
            _ => format!("| `{name}`"),
        };
        let number = match ScpiError::from(refusal) {
            ScpiError::StorageFault if refusal != Refusal::StorageFailed => "\u{2013}".to_owned(),
            error => error.code().to_string(),
        };
        let row = format!("{name} | {words} | {} | {number} |", refused.hint());
        assert!(
            document.contains(&row),
            "docs/troubleshooting.md lacks:\n{row}"
        );
    }
}
