//! The vocabulary of every machine-readable output: one key for one thing.
//!
//! | file | idea |
//! |---|---|
//! | [`point`] | a measured point, and one that is to be measured |
//! | [`measured`] | quantities beside the result of a point, and their columns |
//! | [`instrument`] | the calibrator, its runs and its records |
//! | [`self_test`] | what a board says of itself |
//! | [`json`] | how documents are written: numbers, lines |
//! | [`number`] | decimal numbers of stored f32 |
//! | [`conforms`] | whether a document has the form its schema promises |
//!
//! The verbs, the page and the certificate all state these. docs/json.md lists the
//! keys; docs/schema holds what is generated from the types.

pub mod conforms;
pub mod instrument;
pub mod json;
pub mod measured;
pub mod number;
pub mod point;
pub mod self_test;

pub use instrument::{ChangeView, ImageView, InfoView, RecordView, StatusView};
pub use point::{PointView, SetPoint, StateView};
pub use self_test::{LineView, SelfTestView};

use std::fmt::Debug;

/// The code of a variant without fields: its name in snake case.
pub fn code(variant: &impl Debug) -> String {
    let mut code = String::new();
    for letter in format!("{variant:?}").chars() {
        if letter.is_uppercase() && !code.is_empty() {
            code.push('_');
        }
        code.extend(letter.to_lowercase());
    }
    code
}

/// A time as outputs state it: none where it is not known, which records say with 0.
pub fn unix_time_s(stored: u64) -> Option<u64> {
    (stored > 0).then_some(stored)
}

#[cfg(test)]
mod tests {
    use super::*;
    use calib_core::point_state::Reason;

    #[test]
    fn codes_are_snake_case() {
        assert_eq!(code(&Reason::SignalToNoise), "signal_to_noise");
        assert_eq!((unix_time_s(0), unix_time_s(7)), (None, Some(7)));
    }
}
