//! The auditable metrology of the calibrator: no_std, no allocation, f32.
//!
//! Everything a metrologist would want to check is in this crate and runs on a
//! laptop: sine correlation of sampled blocks, sensitivity and phase, the
//! uncertainty budget of ISO 16063-21 Annex A, the amplitude loop, the point
//! lists and the checks that end in the state of a point. The firmware only carries
//! samples in and results out.
#![cfg_attr(not(test), no_std)]
#![forbid(unsafe_code)]
#![allow(
    clippy::neg_cmp_op_on_partial_ord,
    reason = "`!(x > limit)` refuses what is not a number, `x <= limit` would not"
)]

pub mod alignment;
pub mod aperture;
pub mod broadband;
pub mod budget;
pub mod channel_ratio;
pub mod closing;
pub mod conformity;
pub mod consecutive;
pub mod control;
pub mod converter;
pub mod correlation;
pub mod generator;
pub mod hum;
pub mod output;
pub mod phase;
pub mod point;
pub mod point_state;
pub mod points;
pub mod polarity;
pub mod preferred;
pub mod quantity;
pub mod reference;
pub mod requirements;
mod response_table;
pub mod self_test;
pub mod sequence;
pub mod settings;
pub mod stored_list;
pub mod thermometer;
pub mod tone;
