//! Help that teaches: the verbs in groups, and two examples of each.

use super::verbs::GROUPS;
use clap::Command;
use clap::builder::StyledStr;
use std::fmt::Write;

/// The command line with its verbs grouped, and examples at each.
pub(super) fn described(calib: Command) -> Command {
    let overview = overview(&calib);
    let verbs = GROUPS.iter().flat_map(|(_, verbs)| verbs.iter());
    let calib = verbs.fold(calib, |calib, examples| {
        calib.mut_subcommand(name(examples), |verb| with_examples(verb, examples))
    });
    calib.help_template(format!(
        "{{about-with-newline}}\n{{usage-heading}} {{usage}}\n{overview}\n\
         {header}Options of every verb:{header:#}\n{{options}}{{after-help}}",
        header = header(),
    ))
}

/// The verb that two examples are of.
fn name([first, _]: &[&'static str; 2]) -> &'static str {
    first.split(' ').next().unwrap_or(first)
}

fn header() -> clap::builder::styling::Style {
    *clap::builder::Styles::default().get_header()
}

fn overview(calib: &Command) -> String {
    let (header, literal) = (header(), *clap::builder::Styles::default().get_literal());
    let mut text = String::new();
    for (title, verbs) in GROUPS {
        let _ = writeln!(text, "\n{header}{title}:{header:#}");
        for name in verbs.iter().map(name) {
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
        for examples in GROUPS.iter().flat_map(|(_, verbs)| verbs.iter()) {
            let name = name(examples);
            for example in examples {
                let words =
                    shlex::split(&format!("calib {example}")).expect("quoted as a shell reads it");
                let read = described(Arguments::command()).try_get_matches_from(words);
                match read {
                    Ok(matches) => assert_eq!(matches.subcommand_name(), Some(name), "{example}"),
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
