//! Linking a regional comparison to a key comparison, and judging degrees of
//! equivalence.
//!
//! # Source
//! Elster, Link, Woger, Metrologia 40 (2003) 189; the report of
//! EURAMET.AUV.V-K3; Cox, Metrologia 39 (2002) 589 for the consistency test;
//! Paule and Mandel, J. Res. NBS 87 (1982) 377.

mod chart;
mod doe;
mod file;
mod link;
mod reference;
mod report;

pub use chart::equivalence_chart;
pub use doe::{Degree, DoeTable, Judgement, judge, read_table};
pub use file::{Comparison, LinkFile, LinkResult, LinkedFrequency, load, parse};
pub use link::{Linked, LinkedLaboratory, Pair, link};
pub use reference::{OnFailure, ReferenceValue, reference_value};
pub use report::{doe_report, link_report};
