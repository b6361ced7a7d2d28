//! Where the values of a check by reciprocity may lie.

use super::Rig;
use super::range::Range;

pub(super) fn ranges(rig: &Rig) -> Vec<Range> {
    let Some(check) = rig.reciprocity else {
        return Vec::new();
    };
    let range = |name: &str, value, lowest, highest| {
        Range::new(format!("reciprocity.{name}"), value, lowest, highest)
    };
    let moving_kg = rig.exciter.moving_mass_kg;
    vec![
        range("shunt_ohm", check.shunt_ohm, 1e-6, 1e3),
        range("shunt_inductance_h", check.shunt_inductance_h, 0.0, 1e-3),
        range("divider_volt_per_v", check.divider_volt_per_v, 1e-6, 1.0),
        range("divider_corner_hz", check.divider_corner_hz, 1e3, 1e8),
        range("mass_kg", check.mass_kg, 0.0, 1e3),
        range("seat_n_per_m", check.seat_n_per_m, 1e3, 1e12),
        range("seat_ns_per_m", check.seat_ns_per_m, 0.0, 1e6),
        range("table_kg", check.table_kg, 0.0, 0.99 * moving_kg),
        range("table_n_per_m", check.table_n_per_m, 1e3, 1e12),
        range("table_ns_per_m", check.table_ns_per_m, 0.0, 1e6),
        range("stray_h", check.stray_h, -1.0, 1.0),
        range("stray_ohm", check.stray_ohm, -1.0, 1.0),
        range("rocking_rel", check.rocking_rel, -0.5, 0.5),
        range("rocking_hz", check.rocking_hz, 1.0, 1e5),
        range("rocking_quality", check.rocking_quality, 0.3, 1e3),
    ]
}
