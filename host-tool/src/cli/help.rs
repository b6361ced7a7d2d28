//! Help that teaches: the verbs in groups, and two examples of each.

use clap::Command;
use clap::builder::StyledStr;
use std::fmt::Write;

/// A verb and two lines that use it, without the `calib` before.
type Verb = (&'static str, [&'static str; 2]);

/// Verbs by what they are for, each group in the order of its work.
const GROUPS: [(&str, &[Verb]); 6] = [
    (
        "Measure",
        &[
            ("demo", ["demo", "demo --seed 3 --out another"]),
            (
                "run",
                [
                    "run --sensor LW12345 --operator N.",
                    "run --sensor LW12345 --remount 3",
                ],
            ),
            (
                "serve",
                [
                    "serve",
                    "serve --listen 0.0.0.0:8160 --laboratory laboratory.toml",
                ],
            ),
            (
                "capture",
                [
                    "capture",
                    "capture --frequency 160 --level 10 --csv tone.csv",
                ],
            ),
            ("stop", ["stop", "--device /dev/ttyACM0 stop"]),
            (
                "points",
                [
                    "points preferred --from 10 --to 1000",
                    "points linearity --frequency 80",
                ],
            ),
            ("records", ["records", "records --json"]),
            ("download", ["download 12", "download --all --out records"]),
            ("release", ["release 12", "release 12 --json"]),
        ],
    ),
    (
        "Results and certificates",
        &[
            (
                "show",
                ["show 12", "show record-00012.calibrec --unit mV/g"],
            ),
            (
                "verify",
                [
                    "verify record-00012.calibrec",
                    "verify certificate-17.pdf certificate-17.dcc.xml --certificate laboratory.pem",
                ],
            ),
            (
                "sign",
                [
                    "sign certificate-17.pdf certificate-17.dcc.xml --key laboratory.p12",
                    "sign certificate-17.pdf --key laboratory.p12 --password-file password",
                ],
            ),
            (
                "certificate",
                [
                    "certificate 12 --particulars job.toml",
                    "certificate --amend 17 --reason \"name of the customer\" --customer \"B. Ltd\"",
                ],
            ),
            (
                "check",
                [
                    "check record-00012.calibrec",
                    "check record-00012.calibrec --example 2",
                ],
            ),
        ],
    ),
    (
        "Logbook",
        &[
            (
                "sensors",
                [
                    "sensors add --serial LW12345 --sensitivity 100 --unit mV/g --tolerance 5",
                    "sensors list",
                ],
            ),
            (
                "history",
                ["history LW12345", "history LW12345 --frequency 1000"],
            ),
            (
                "assure",
                [
                    "assure CHECK-1",
                    "assure CHECK-1 --certified 10.02 --certified-u 0.5",
                ],
            ),
            (
                "selfcheck",
                [
                    "selfcheck --baseline --operator N.",
                    "selfcheck 12 13 14 15 16 17 18 19 20 21 --equipment mass.toml",
                ],
            ),
            (
                "turnover",
                [
                    "turnover readings.toml 12 --baseline",
                    "turnover readings.toml record-00012.calibrec --json",
                ],
            ),
            ("sync", ["sync", "sync --device /dev/ttyACM0"]),
            (
                "logbook",
                [
                    "logbook records",
                    "logbook check --certificate laboratory.pem",
                ],
            ),
            (
                "export",
                [
                    "export --parquet data",
                    "export --lake fleet --laboratory-name Lab",
                ],
            ),
        ],
    ),
    (
        "Metrology",
        &[
            (
                "budget",
                ["budget --template a1", "budget budget.toml --monte-carlo"],
            ),
            (
                "sensitivity",
                [
                    "sensitivity readings.csv",
                    "sensitivity readings.csv --quantity velocity",
                ],
            ),
            (
                "phase",
                ["phase readings.toml", "phase readings.toml --json"],
            ),
            (
                "identify",
                [
                    "identify points.csv",
                    "identify --shock record.csv --from-hz 100",
                ],
            ),
            (
                "predict",
                [
                    "predict record.csv --model model.json",
                    "predict output.csv --model model.json --inverse",
                ],
            ),
            (
                "link",
                ["link comparisons.toml --pairs", "link --doe degrees.csv"],
            ),
            (
                "risk",
                ["risk --ratio 4", "risk --ratio 2 --in-tolerance 90"],
            ),
            (
                "convert",
                [
                    "convert --frequency 160 --sensitivity 0.01",
                    "convert --frequency 80 --sensitivity 0.004 --from velocity",
                ],
            ),
            (
                "nomogram",
                [
                    "nomogram --frequency 160 --acceleration 10",
                    "nomogram --frequency 20 --displacement 0.001 --as peak",
                ],
            ),
        ],
    ),
    (
        "Gap between simulation and reality",
        &[(
            "gap",
            [
                "gap diagnose dataset --report gap.html",
                "gap effects mount_resonance",
            ],
        )],
    ),
    (
        "Instrument and service",
        &[
            ("devices", ["devices", "devices --json"]),
            (
                "config",
                ["config operator \"N. N.\"", "config --unset level"],
            ),
            ("doctor", ["doctor", "--device /dev/ttyACM0 doctor"]),
            ("info", ["info", "--device tcp:192.0.2.7:5025 info"]),
            ("selftest", ["selftest", "--device emulated selftest"]),
            (
                "settings",
                ["settings", "settings --write settings.toml --operator N."],
            ),
            (
                "reference",
                [
                    "reference K-2026-17.dcc.xml --due 2028-05-04",
                    "reference table.csv --write --operator N.",
                ],
            ),
            (
                "adjust",
                ["adjust ratio", "adjust ratio --write --operator N."],
            ),
            ("key", ["key", "key --make"]),
            (
                "lists",
                [
                    "lists store pump.csv --sensitivity 100 --unit mV/g --tolerance 5",
                    "lists choose pump",
                ],
            ),
            (
                "update",
                [
                    "update calib-0.1.0-nucleo-h743zi2.update",
                    "update older.update --wait 60",
                ],
            ),
            ("emulate", ["emulate", "emulate --pty --flash flash.bin"]),
            ("completions", ["completions bash", "completions fish"]),
            ("man", ["man", "man --out pages"]),
            ("version", ["version", "version --json"]),
        ],
    ),
];

/// The command line with its verbs grouped, and examples at each.
pub(super) fn described(calib: Command) -> Command {
    let overview = overview(&calib);
    let verbs = GROUPS.iter().flat_map(|(_, verbs)| verbs.iter());
    let calib = verbs.fold(calib, |calib, (verb, examples)| {
        calib.mut_subcommand(verb, |verb| with_examples(verb, examples))
    });
    calib.help_template(format!(
        "{{about-with-newline}}\n{{usage-heading}} {{usage}}\n{overview}\n\
         {header}Options of every verb:{header:#}\n{{options}}{{after-help}}",
        header = header(),
    ))
}

fn header() -> clap::builder::styling::Style {
    *clap::builder::Styles::default().get_header()
}

fn overview(calib: &Command) -> String {
    let (header, literal) = (header(), *clap::builder::Styles::default().get_literal());
    let mut text = String::new();
    for (title, verbs) in GROUPS {
        let _ = writeln!(text, "\n{header}{title}:{header:#}");
        for (name, _) in verbs {
            let about = calib.find_subcommand(name).and_then(Command::get_about);
            let about = about.map(ToString::to_string).unwrap_or_default();
            let _ = writeln!(text, "  {literal}{name:<12}{literal:#} {about}");
        }
    }
    text
}

/// Adds the examples to the text after the options of a verb.
fn with_examples(verb: Command, examples: &[&str]) -> Command {
    let header = header();
    let mut text = verb
        .get_after_help()
        .map(|said| format!("{}\n\n", said.ansi()))
        .unwrap_or_default();
    let _ = write!(text, "{header}Examples:{header:#}");
    for example in examples {
        let _ = write!(text, "\n  calib {example}");
    }
    verb.after_help(StyledStr::from(text))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::Arguments;
    use clap::CommandFactory;
    use clap::error::ErrorKind;

    fn verbs() -> impl Iterator<Item = &'static Verb> {
        GROUPS.iter().flat_map(|(_, verbs)| verbs.iter())
    }

    #[test]
    fn every_verb_is_in_one_group() {
        let mut grouped: Vec<_> = verbs().map(|(name, _)| *name).collect();
        grouped.sort_unstable();
        let calib = Arguments::command();
        let there = calib.get_subcommands().filter(|verb| !verb.is_hide_set());
        let mut there: Vec<_> = there.map(Command::get_name).collect();
        there.sort_unstable();
        assert_eq!(grouped, there);
    }

    /// Lines of the documents that call the tool, without prompt, comment and what the shell does.
    fn commands_of_the_docs() -> Vec<String> {
        let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let docs = std::fs::read_dir(root.join("docs")).expect("a folder");
        let docs = docs.flatten().map(|entry| entry.path());
        let files = docs.chain(["README.md", "CONTRIBUTING.md"].map(|name| root.join(name)));
        let mut commands = Vec::new();
        for file in files.filter(|file| file.extension().is_some_and(|end| end == "md")) {
            let text = std::fs::read_to_string(file).expect("text");
            let lines = text
                .lines()
                .map(|line| line.strip_prefix("$ ").unwrap_or(line));
            let calls = lines.filter(|line| line.starts_with("calib "));
            let bare = |line: &str| line.split(['#', '|', '>']).next().unwrap_or("").to_owned();
            commands.extend(calls.map(bare));
        }
        commands
    }

    #[test]
    fn every_command_in_the_docs_is_understood() {
        let commands = commands_of_the_docs();
        assert!(commands.len() > 20, "{commands:?}");
        for command in commands {
            let words = shlex::split(&command).expect("quoted as a shell reads it");
            let read = described(Arguments::command()).try_get_matches_from(words);
            assert!(read.is_ok(), "{command}: {}", read.expect_err("wrong"));
        }
    }

    #[test]
    fn every_example_is_understood_and_shown() {
        for (name, examples) in verbs() {
            for example in examples {
                let words =
                    shlex::split(&format!("calib {example}")).expect("quoted as a shell reads it");
                let read = described(Arguments::command()).try_get_matches_from(words);
                match read {
                    Ok(matches) => assert_eq!(matches.subcommand_name(), Some(*name), "{example}"),
                    Err(said) => {
                        assert_eq!(said.kind(), ErrorKind::DisplayHelp, "{example}: {said}")
                    }
                }
            }
            let mut calib = described(Arguments::command());
            let verb = calib.find_subcommand_mut(name).expect("there");
            let help = verb.render_long_help().to_string();
            assert!(help.contains(examples[1]), "{help}");
        }
    }
}
