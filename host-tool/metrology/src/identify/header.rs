//! Which quantity a column holds, from the words of its name.

use crate::input::Column;

/// Quantity of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Quantity {
    Frequency,
    Magnitude,
    Phase,
}

/// How a value is written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Form {
    /// In the quantity's own unit, times this factor (Hz, rad).
    Scaled(f64),
    /// Relative to the magnitude, times this factor.
    Relative(f64),
    /// The unit is not stated.
    Unstated,
    /// A logarithm of the quantity, which no model is fitted to.
    Decibel,
}

/// Meaning of a column.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Meaning {
    pub quantity: Quantity,
    /// An uncertainty of the quantity, divided by this coverage factor.
    pub uncertainty: Option<f64>,
    pub form: Form,
}

/// Meaning of a column, if its words tell one.
///
/// `U_...` beside lower-case names is an expanded uncertainty (k = 2), the
/// notation of the GUM; so is `expanded...`.
pub(super) fn meaning(column: &Column, lower_case_names: bool) -> Option<Meaning> {
    let words: Vec<&str> = column.name.split('_').collect();
    let has = |list: &[&str]| words.iter().any(|word| list.contains(word));
    let uncertain = has(&UNCERTAINTY) || words[0] == "us" || words[0] == "uphi";
    let capital = lower_case_names && column.written.starts_with('U');
    let expanded = has(&["expanded", "k2"]) || (uncertain && capital);
    let uncertainty = (uncertain || expanded).then_some(if expanded { 2.0 } else { 1.0 });
    let quantity = if has(&["frequency", "freq", "f"]) {
        Quantity::Frequency
    } else if has(&["phase", "phi", "angle", "arg", "uphi"]) || words == ["dut", "deg"] {
        Quantity::Phase
    } else if has(&[
        "magnitude",
        "mag",
        "s",
        "sensitivity",
        "modulus",
        "ratio",
        "h",
        "us",
    ]) {
        Quantity::Magnitude
    } else {
        return None;
    };
    Some(Meaning {
        quantity,
        uncertainty,
        form: form(quantity, uncertainty.is_some(), &has),
    })
}

const UNCERTAINTY: [&str; 6] = ["u", "unc", "uncertainty", "std", "sigma", "sd"];

fn form(quantity: Quantity, uncertain: bool, has: &dyn Fn(&[&str]) -> bool) -> Form {
    match quantity {
        Quantity::Frequency if has(&["khz"]) => Form::Scaled(1000.0),
        Quantity::Frequency => Form::Scaled(1.0),
        Quantity::Phase if has(&["deg", "degree", "degrees"]) => Form::Scaled(1.0_f64.to_radians()),
        Quantity::Phase if has(&["rad", "radian", "radians"]) => Form::Scaled(1.0),
        Quantity::Phase if has(&["mrad"]) => Form::Scaled(1.0e-3),
        Quantity::Phase => Form::Unstated,
        Quantity::Magnitude if uncertain && has(&["percent", "pct"]) => Form::Relative(0.01),
        // `u_ratio` is relative by the definition of the gap dataset.
        Quantity::Magnitude if uncertain && has(&["rel", "relative", "ratio"]) => {
            Form::Relative(1.0)
        }
        Quantity::Magnitude if has(&["db", "decibel"]) => Form::Decibel,
        Quantity::Magnitude => Form::Scaled(1.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(name: &str, written: &str) -> Option<Meaning> {
        let column = Column {
            index: 0,
            written: written.into(),
            name: name.into(),
        };
        meaning(&column, true)
    }

    #[test]
    fn names_laboratories_use_are_understood() {
        let plain = |name| of(name, name).expect(name);
        assert_eq!(plain("frequency_hz").quantity, Quantity::Frequency);
        assert_eq!(plain("f_khz").form, Form::Scaled(1000.0));
        assert_eq!(plain("dut_deg").quantity, Quantity::Phase);
        assert_eq!(plain("phase").form, Form::Unstated);
        assert_eq!(plain("ratio").form, Form::Scaled(1.0));
        assert_eq!(plain("magnitude_db").form, Form::Decibel);
        assert_eq!(plain("u_ratio").form, Form::Relative(1.0));
        assert_eq!(plain("u_s").form, Form::Scaled(1.0));
        assert_eq!(plain("u_magnitude_percent").form, Form::Relative(0.01));
        assert_eq!(plain("u_phase_deg").uncertainty, Some(1.0));
        assert_eq!(plain("expanded_uncertainty_s").uncertainty, Some(2.0));
        assert_eq!(of("u_s", "U_S").and_then(|m| m.uncertainty), Some(2.0));
        assert_eq!(of("coherence", "coherence"), None);
    }
}
