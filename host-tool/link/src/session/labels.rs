//! Labels an operator gives a run, cut to the room of a record.

use calib_files::{Error, Result};
use calib_protocol::text::is_plain;

/// Words of one line. `what` names them in a complaint.
///
/// # Errors
/// [`Error::Usage`] when they are longer than `N` bytes or hold control characters.
pub fn label<const N: usize>(what: &str, words: &str) -> Result<heapless::String<N>> {
    if !is_plain(words) {
        let problem = "is one line, without control characters and those that turn it round";
        return Err(usage(what, problem));
    }
    let length = words.len();
    let full = |_| usage(what, &format!("has room for {N} bytes, this is {length}"));
    words.try_into().map_err(full)
}

/// A temperature in hundredths of a degree Celsius. `what` names it in a complaint.
///
/// # Errors
/// [`Error::Usage`] when no transducer has it.
pub fn temperature_centi_c(what: &str, celsius: Option<f64>) -> Result<Option<i16>> {
    match celsius {
        None => Ok(None),
        Some(celsius) if (-55.0..=200.0).contains(&celsius) => {
            Ok(Some((100.0 * celsius).round() as i16))
        }
        Some(_) => Err(usage(what, "is between -55 and 200 degrees Celsius")),
    }
}

fn usage(what: &str, problem: &str) -> Error {
    Error::usage(format!("{what} {problem}"), "")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_label_is_one_line_that_fits() {
        assert_eq!(label::<8>("--serial", "Müller").expect("7 bytes"), "Müller");
        for (words, problem) in [
            ("Müller's", "room for 8 bytes, this is 9"),
            ("a\nb", "one line"),
            ("\u{1b}[31m", "control"),
            ("S\u{202e}1", "turn it round"),
        ] {
            let error = label::<8>("--serial", words).expect_err(problem);
            let message = error.to_string();
            assert!(message.starts_with("--serial "), "{message}");
            assert!(message.contains(problem), "{message}");
        }
    }

    #[test]
    fn a_temperature_is_a_number_that_fits() {
        let centi = |celsius| temperature_centi_c("--temperature", Some(celsius));
        assert_eq!(centi(-19.995).expect("cold"), Some(-2000));
        assert_eq!(centi(200.0).expect("hot"), Some(20_000));
        for celsius in [200.1, -55.1, f64::NAN, f64::INFINITY] {
            assert!(centi(celsius).is_err());
        }
    }
}
