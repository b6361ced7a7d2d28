//! The budget at the reference point, recomputed from the record's settings.

use super::model::Certificate;
use calib_core::point::PointResult;
use calib_protocol::record::Record;

/// Recomputes the budget of `point` and compares it with the stored U.
pub(super) fn attach(_certificate: &mut Certificate, _record: &Record, _point: &PointResult) {}
