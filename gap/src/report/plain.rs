//! Conditions in words that need no training.

use crate::axis::Axis;
use crate::summary::three_digits;

/// A range of a condition.
pub(super) fn range(axis: Axis, from: f64, to: f64) -> String {
    let (words, unit) = match axis {
        Axis::Frequency => ("at frequencies", "Hz"),
        Axis::Level | Axis::InverseLevel => ("at levels", "m/s\u{b2}"),
        Axis::Travel => ("at a travel", "m"),
        Axis::Time => ("over time,", "s"),
        Axis::Payload => ("with the payload,", "kg"),
        Axis::Temperature => ("with temperature,", "K above the reference"),
        Axis::Rotation => ("with the rotation,", "\u{b0}"),
        Axis::CoilVoltage => ("at coil voltages", "V"),
        Axis::Amplitude => ("amplitude", ""),
    };
    let (from, to) = (three_digits(from), three_digits(to));
    format!("{words} from {from} to {to}\u{a0}{unit}")
}
