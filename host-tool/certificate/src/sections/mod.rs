//! The statements of a certificate, each with the clause that asks for it.
//!
//! Everything ISO 16063-21 clause 7 and ISO/IEC 17025 7.8.2.1 and 7.8.4.1 ask
//! for has a line here; a line without a value is printed as missing.

mod calibration;
mod clause;
mod conditions;
mod equipment;
mod parties;
mod value;

use super::model::Section;
use super::particulars::Particulars;
use calib_protocol::record::Record;
pub(super) use clause::RESULTS;
pub(super) use equipment::is_traceable;

/// All statements in the order they are printed.
pub(super) fn sections(record: &Record, particulars: &Particulars) -> Vec<Section> {
    vec![
        parties::item(record, particulars),
        parties::laboratory(particulars),
        calibration::calibration(record, particulars),
        conditions::conditions(record, particulars),
        conditions::mounting(record, particulars),
        equipment::amplifier(record, particulars),
        equipment::equipment(record, particulars),
    ]
}
