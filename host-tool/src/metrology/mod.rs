//! The metrology that needs f64, files or matrices.
//!
//! | module | subject | source |
//! |---|---|---|
//! | [`budget`] | uncertainty budgets, type A evaluation, coverage factors | ISO 16063-21 Annex A, GUM |
//! | [`monte_carlo`] | propagation of distributions | GUM Supplement 1 |
//! | [`input`] | files with line numbers, remedies in every error | |
//! | [`identify`] | accelerometer model from sinusoidal data | ISO 16063-43 7.2 |
//! | [`linking`] | degrees of equivalence, linked comparisons | EURAMET.AUV.V-K3 |
//! | [`oscillator`] | the mass-spring-damper model | ISO 16063-43 7.1 |
//! | [`chart`] | small SVG charts | |
//! | [`statistics`] | quantiles | |
//!
//! Nothing here prints: each subject has a function that evaluates, a value
//! that serialises to JSON, and a `report` that renders it within 80 columns.

pub mod budget;
pub mod chart;
pub mod identify;
pub mod input;
pub mod linking;
pub mod monte_carlo;
pub mod oscillator;
pub mod statistics;
pub mod text;
