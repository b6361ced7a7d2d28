//! A certificate of the reference row by row, beside what is in force.

use calib_metrology::reference::Compared;
use calib_metrology::text::{Table, significant};

/// The table, 80 columns wide; `beside` what is in force, or alone.
pub fn show(rows: &[Compared], beside: bool) -> String {
    let mut heads = vec!["Hz", "mV/(m/s2)", "U/%", "phase/deg", "U/deg"];
    if beside {
        heads.extend(["change/%", "deg", "E_n", ""]);
    }
    let mut table = Table::new(&heads);
    for row in rows {
        let mut cells = vec![
            significant(row.frequency_hz, 6),
            format!("{:.5}", 1e3 * row.sensitivity_v_per_ms2),
            format!("{:.2}", 100.0 * row.expanded_uncertainty_rel),
            format!("{:.2}", row.phase_deg),
            format!("{:.2}", row.expanded_uncertainty_phase_deg),
        ];
        if beside {
            let signed = |value: Option<f64>| value.map_or(String::new(), |v| format!("{v:+.2}"));
            let word = match (row.change_rel, row.e_n) {
                (None, _) => "new",
                (_, Some(e_n)) if e_n.abs() > 1.0 => "changed",
                _ => "",
            };
            cells.push(signed(row.change_rel.map(|change| 100.0 * change)));
            cells.extend([
                signed(row.change_phase_deg),
                signed(row.e_n),
                word.to_owned(),
            ]);
        }
        table.row(cells);
    }
    table.to_string()
}
