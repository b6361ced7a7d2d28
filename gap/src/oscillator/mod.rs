//! Datasets of `kind = "oscillator"`.
use crate::answer::Answer;
use crate::dataset::{Dataset, Record};
use crate::diagnose::Options;
use crate::error::GapError;

pub(crate) fn names() -> Vec<&'static str> {
    Vec::new()
}

pub(crate) fn diagnose(
    _: String,
    _: &Dataset,
    _: &Record,
    _: Option<&Dataset>,
    _: &Options,
) -> Result<Answer, GapError> {
    Err(GapError::Usage("kind oscillator: not ready".into()))
}
