//! The metrology that needs f64, files or matrices.
//!
//! | module | subject | source |
//! |---|---|---|
//! | [`budget`] | uncertainty budgets, type A evaluation, coverage factors | ISO 16063-21 Annex A, GUM |
//! | [`monte_carlo`] | propagation of distributions | GUM Supplement 1 |
//! | [`input`] | files with line numbers, remedies in every error | |
//! | [`chart`] | small SVG charts | |
//! | [`statistics`] | quantiles | |
//!
//! Nothing here prints: each subject has a function that evaluates, a value
//! that serialises to JSON, and a `report` that renders it within 80 columns.

pub mod budget;
pub mod chart;
pub mod input;
pub mod monte_carlo;
pub mod statistics;
pub mod text;
