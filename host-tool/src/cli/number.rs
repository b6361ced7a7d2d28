//! Numbers of the command line.

pub(crate) use calib_host::number::{finite, positive};
use calib_host::{Error, Result};
use calib_metrology::input::HIGHEST_HZ;
use clap::Command;
use std::any::TypeId;

/// Every option that takes a number takes a negative one as well: what is wrong with it is then said by the verb,
/// not that `-1` is no option.
pub(crate) fn signed(verb: Command) -> Command {
    verb.mut_args(|arg| match takes_number(&arg) {
        true => arg.allow_negative_numbers(true),
        false => arg,
    })
    .mut_subcommands(signed)
}

fn takes_number(arg: &clap::Arg) -> bool {
    let read = arg.get_value_parser().type_id();
    read == TypeId::of::<f64>() || read == TypeId::of::<f32>()
}

/// Refuses a frequency that no exciter reaches: it is in another unit.
pub(crate) fn reachable(name: &str, frequency_hz: f64) -> Result<()> {
    match frequency_hz <= HIGHEST_HZ {
        true => Ok(()),
        false => Err(Error::usage(
            format!("{name} of {frequency_hz} Hz: no exciter reaches it"),
            "frequencies are in Hz, accelerations in m/s2, velocities in m/s, displacements in m",
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::Arguments;
    use clap::CommandFactory;
    use clap::error::ErrorKind;

    /// Words that lead to each option of each verb that takes a number.
    fn options(verb: &Command, before: &[String], found: &mut Vec<Vec<String>>) {
        for arg in verb.get_arguments() {
            if let (true, Some(name)) = (takes_number(arg), arg.get_long()) {
                found.push([before, &[format!("--{name}")]].concat());
            }
        }
        for verb in verb.get_subcommands() {
            options(
                verb,
                &[before, &[verb.get_name().to_owned()]].concat(),
                found,
            );
        }
    }

    #[test]
    fn every_number_of_every_verb_is_finite_and_has_a_point() {
        let calib = || signed(Arguments::command());
        let mut found = Vec::new();
        options(&calib(), &["calib".to_owned()], &mut found);
        assert!(found.len() > 40, "{found:?}");
        for words in found {
            for text in ["nan", "NaN", "inf", "-inf", "1e400", "", "x"] {
                let mut words = words.clone();
                let option = words.pop().expect("an option");
                words.push(format!("{option}={text}"));
                let said = calib().try_get_matches_from(&words);
                let said = said.expect_err(&words.join(" "));
                assert_eq!(said.kind(), ErrorKind::ValueValidation, "{words:?}: {said}");
                assert!(said.to_string().contains("a number"), "{words:?}: {said}");
            }
        }
    }
}
