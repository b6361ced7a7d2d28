//! Numbers of the command line.

use calib_host::{Error, Result};
use calib_metrology::input::HIGHEST_HZ;
use clap::Command;
use std::any::TypeId;
use std::str::FromStr;

/// Every option that takes a number takes a negative one as well: what is wrong with it is then said by the verb,
/// not that `-1` is no option.
pub(crate) fn signed(verb: Command) -> Command {
    let number = |arg: &clap::Arg| {
        let read = arg.get_value_parser().type_id();
        read == TypeId::of::<f64>() || read == TypeId::of::<f32>()
    };
    verb.mut_args(|arg| match number(&arg) {
        true => arg.allow_negative_numbers(true),
        false => arg,
    })
    .mut_subcommands(signed)
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

/// A finite number above zero.
pub(crate) fn positive<T: FromStr + Into<f64> + Copy>(
    text: &str,
) -> std::result::Result<T, String> {
    let finite = |value: &T| (*value).into().is_finite() && (*value).into() > 0.0;
    text.parse()
        .ok()
        .filter(finite)
        .ok_or_else(|| "must be a number above zero".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_positive_number_is_refused() {
        assert_eq!(positive::<f32>("1.5e3"), Ok(1500.0));
        // 1e39 is beyond f32, 1e-400 rounds to zero.
        for text in ["0", "-1", "nan", "inf", "1e39", "1e-400", "", "1,5", "x"] {
            assert!(positive::<f32>(text).is_err(), "{text}");
        }
    }
}
