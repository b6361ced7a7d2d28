//! The metrology that needs f64, files or matrices.
//!
//! | module | subject | source |
//! |---|---|---|
//! | [`budget`] | uncertainty budgets, type A evaluation, coverage factors | ISO 16063-21 Annex A, GUM |
//! | [`monte_carlo`] | propagation of distributions | GUM Supplement 1 |
//! | [`input`] | files with line numbers, remedies in every error | |
//! | [`identify`] | accelerometer model from sinusoidal data | ISO 16063-43 7.2 |
//! | [`shock`] | the same from a shock record | ISO 16063-43 7.3 |
//! | [`predict`] | output for an input, input behind an output | ISO 16063-43 |
//! | [`discrete`], [`record`] | sampled model, time records | ISO 16063-43 7.3.1 |
//! | [`linking`] | degrees of equivalence, linked comparisons | EURAMET.AUV.V-K3 |
//! | [`oscillator`] | the mass-spring-damper model | ISO 16063-43 7.1 |
//! | [`phase5347`] | phase by comparison | ISO 5347-9 |
//! | [`sensitivity`] | sensitivity from readings, conversions | ISO 16063-21 clause 6 |
//! | [`nomogram`] | acceleration, velocity, displacement | ISO 16063-21 Annex C |
//! | [`lists`], [`line_fit`] | point and linearity lists, straight lines | ISO 16063-21 5, GUM H.3 |
//! | [`control_chart`], [`common_drift`] | check standards, alone and together | ISO 7870-2, ILAC-G24 |
//! | [`channel_ratio`] | ratio of the two channels, with one source at both | ISO 16063-21 clause 6 |
//! | [`reciprocity`] | the reference by a mass and two voltages | |
//! | [`check`] | a record against Tables 1 to 6 and clause 7 | ISO 16063-21 |
//! | [`reference`] | a certificate of the reference: DCC or CSV | DCC 3.x, D-SI |
//! | [`teds`] | what an accelerometer says about itself | IEEE 1451.4 |
//! | [`statistics`] | quantiles | |
//!
//! Nothing here prints: each subject has a function that evaluates, a value
//! that serialises to JSON, and a `report` that renders it within 80 columns.

#![forbid(unsafe_code)]

pub mod budget;
pub mod channel_ratio;
pub mod check;
pub mod common_drift;
pub mod control_chart;
pub mod discrete;
pub mod evaluated;
pub mod identify;
pub mod input;
pub mod line_fit;
pub mod linking;
pub mod lists;
pub mod monte_carlo;
pub mod nomogram;
pub mod oscillator;
pub mod phase5347;
pub mod predict;
pub mod reciprocity;
pub mod record;
pub mod reference;
pub mod sensitivity;
pub mod shock;
pub mod statistics;
pub mod teds;
pub mod text;
pub mod turn_over;
