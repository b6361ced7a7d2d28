//! Substitution: a standard and then the device in one channel of one instrument.
//!
//! # Equation
//! `S2 = S1 X2 / X1`: S1 from the standard's own certificate, X2 / X1 the ratio of what the instrument found for
//! device and standard. In that ratio the calibration of the instrument's reference and its drift, the gain and the ratio
//! of the channels (rows 1, 10, 2, 3 of Table A.1) cancel; every other row counts twice, and U of S1 is added.
//!
//! # Source
//! ISO 16063-21:2003, 4.5 and clause 6; GUM 5.2.2.

use super::budget::{Basis, LeftOf};
use super::deviation::{left_of, within_a_substitution};
use super::model::{Certificate, Entry, Remark, Severity, Value};
use super::mountings::Mountings;
use super::particulars::{Equipment, Item, Particulars};
use calib_core::budget::{Budget, Component, Row};
use calib_core::point::{PointResult, PointSpec};
use calib_core::point_state::{PointState, Reason};
use calib_core::settings::Distribution;
use calib_files::{Error, Result};
use calib_protocol::record::Record;
use jiff::civil::Date;
use schemars::JsonSchema;
use serde::Serialize;

/// Clause of a consecutive comparison.
const CLAUSE: &str = "ISO 16063-21 4.5 a";
/// The standard and the device are each mounted once.
pub(super) static ONCE: Mountings = Mountings::ONCE;
/// Label of U of the standard by its own certificate.
const OF_STANDARD: &str = "calibration of the standard";

/// A standard that was measured in the channel of the device, and what its own certificate says.
#[derive(Clone, Debug)]
pub struct Standard {
    /// Record of the standard.
    pub record: Record,
    /// Table of its certificate.
    pub certified: Vec<StandardPoint>,
}

/// A frequency of the standard's certificate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StandardPoint {
    /// Frequency, Hz.
    pub frequency_hz: f64,
    /// Sensitivity, V/(m/s2).
    pub sensitivity_v_per_ms2: f64,
    /// Its relative expanded uncertainty, k = 2.
    pub expanded_uncertainty_rel: f64,
}

/// Result of a substitution at one point.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Substituted {
    /// Nominal frequency, Hz.
    pub frequency_hz: f32,
    /// Set acceleration, m/s2 r.m.s.
    pub set_acceleration_rms_ms2: f32,
    /// Sensitivity of the standard by its certificate, V/(m/s2).
    pub standard_v_per_ms2: f64,
    /// Output of the device over that of the standard.
    pub ratio: f64,
    /// Relative expanded uncertainty of that ratio.
    pub expanded_uncertainty_ratio_rel: f64,
    /// Sensitivity of the device, V/(m/s2).
    pub sensitivity_v_per_ms2: f64,
    /// Its relative expanded uncertainty, k = 2.
    pub expanded_uncertainty_rel: f64,
}

/// Results at every point that is valid in both records and stated by the standard's certificate (within 1 %), with
/// the conditions stated for both.
///
/// # Errors
/// [`Error::Input`] when the records are not of one instrument and settings, of one device, or share no point with
/// the certificate.
pub fn substitute(
    standard: &Standard,
    device: &Record,
    particulars: &Particulars,
) -> Result<Vec<Substituted>> {
    let joined = join(device, standard)?;
    let stated = of_chain(particulars);
    let pair = Pair::new(standard, &stated);
    let of_ratio = Basis::new(device, &stated, &ONCE);
    let whole =
        Basis::new(&joined, &stated, &ONCE).by_substitution(left_of_pair(standard, &stated));
    let result = |point: &PointResult| {
        let (before, known) = pair.at(&point.spec)?;
        let ratio = of_ratio.of_substitution(point, &pair.basis, before)?;
        (point.state == PointState::Valid).then_some(())?;
        Some(Substituted {
            frequency_hz: point.spec.frequency_hz,
            set_acceleration_rms_ms2: point.spec.acceleration_rms_ms2,
            standard_v_per_ms2: known.sensitivity_v_per_ms2,
            ratio: f64::from(point.sensitivity_v_per_ms2) / known.sensitivity_v_per_ms2,
            expanded_uncertainty_ratio_rel: ratio.expanded_rel,
            sensitivity_v_per_ms2: f64::from(point.sensitivity_v_per_ms2),
            expanded_uncertainty_rel: whole.uncertainty(point)?.expanded_rel,
        })
    };
    Ok(joined.points.iter().filter_map(result).collect())
}

/// The statements that count for both, of the chain as it was measured: no gain or burden is taken out of it.
fn of_chain(particulars: &Particulars) -> Particulars {
    Particulars {
        conditions: particulars.conditions.clone(),
        mounting: particulars.mounting.clone(),
        item: Item {
            mounted_resonance_hz: particulars.item.mounted_resonance_hz,
            ..Item::default()
        },
        ..Particulars::default()
    }
}

/// The device's record with `S2` at every point; refused where the standard has no result, or its certificate says
/// nothing.
///
/// # Errors
/// As [`substitute`].
pub(super) fn join(device: &Record, standard: &Standard) -> Result<Record> {
    belong_together(&standard.record, device)?;
    let mut joined = device.clone();
    for point in &mut joined.points {
        if point.state != PointState::Valid {
            continue;
        }
        match pair_of(standard, &point.spec) {
            Some((before, known)) => {
                let found = f64::from(point.sensitivity_v_per_ms2);
                let ratio = found / f64::from(before.sensitivity_v_per_ms2);
                point.sensitivity_v_per_ms2 = (known.sensitivity_v_per_ms2 * ratio) as f32;
            }
            None => point.state = PointState::Refused(Reason::FrequencyUnavailable),
        }
    }
    match joined.points.iter().any(|p| p.state == PointState::Valid) {
        true => Ok(joined),
        false => Err(Error::input(
            format!("records {} and {}", standard.record.head.id, device.head.id),
            "have no valid point in common that the certificate of the standard states",
            "measure both at frequencies of its table",
        )),
    }
}

/// The standard's own point, and what its certificate says there.
fn pair_of<'s>(
    standard: &'s Standard,
    spec: &PointSpec,
) -> Option<(&'s PointResult, &'s StandardPoint)> {
    let near = |hz: f64| (f64::from(spec.frequency_hz) / hz - 1.0).abs() <= 0.01;
    let mut certified = standard.certified.iter();
    let known = certified.find(|known| near(known.frequency_hz))?;
    let mut points = standard.record.points.iter();
    let before = points.find(|p| p.spec == *spec && p.state == PointState::Valid)?;
    (before.sensitivity_v_per_ms2 > 0.0).then_some((before, known))
}

/// The budgets that a substitution for this standard leaves.
pub(super) fn left_of_pair<'a>(standard: &'a Standard, particulars: &Particulars) -> LeftOf<'a> {
    let pair = Pair::new(standard, particulars);
    Box::new(move |device, point| pair.left_of(device, point))
}

/// The standard's part of the budgets of a substitution.
struct Pair<'a> {
    standard: &'a Standard,
    basis: Basis<'a>,
}

impl<'a> Pair<'a> {
    fn new(standard: &'a Standard, particulars: &Particulars) -> Self {
        // The data sheet of the device says nothing of the standard.
        let mut particulars = of_chain(particulars);
        particulars.item = Item::default();
        let basis = Basis::new(&standard.record, &particulars, &ONCE);
        Self { standard, basis }
    }

    fn at(&self, spec: &PointSpec) -> Option<(&PointResult, &StandardPoint)> {
        pair_of(self.standard, spec)
    }

    /// The budget left of the device's and the standard's, and U of the standard by its certificate.
    fn left_of(
        &self,
        device: &Budget<'_>,
        point: &PointResult,
    ) -> std::result::Result<Budget<'static>, String> {
        let none = || {
            format!(
                "the standard has no result at {} Hz",
                point.spec.frequency_hz
            )
        };
        let (before, known) = self.at(&point.spec).ok_or_else(none)?;
        let own = self.basis.magnitude(before).ok_or_else(none)?;
        let left = left_of(device, &own, &within_a_substitution);
        let mut left = left.ok_or("the budgets of device and standard do not fit into one")?;
        let half = Distribution::Normal {
            coverage_factor: 2.0,
        };
        let of_standard = Component::new(Row::a1(1), known.expanded_uncertainty_rel as f32, half);
        let added = left.add(of_standard.labelled(OF_STANDARD));
        added.map_err(|error| error.to_string())?;
        Ok(left)
    }
}

/// The standard among the equipment that the laboratory states.
fn equipment<'c>(certificate: &'c Certificate, serial: &str) -> Option<&'c Equipment> {
    let mut stated = certificate.particulars.equipment.iter();
    stated.find(|used| used.serial.trim().eq_ignore_ascii_case(serial))
}

/// The day the standard's calibration was due, where that is before the calibration.
pub(super) fn overdue(certificate: &Certificate, standard: &Standard) -> Option<Date> {
    let used = equipment(certificate, serial_of(&standard.record))?;
    used.due
        .filter(|due| certificate.day.is_some_and(|day| *due < day))
}

/// States the standard, its certificate and its term; traceability is through it.
pub(super) fn attach(certificate: &mut Certificate, standard: &Standard) {
    let serial = serial_of(&standard.record).to_owned();
    let used = equipment(certificate, &serial).cloned();
    let number = used.as_ref().and_then(|used| used.certificate.clone());
    let number = number.filter(|number| !number.trim().is_empty());
    let due = used.and_then(|used| used.due);
    let in_force = due
        .zip(certificate.day)
        .is_some_and(|(due, day)| day <= due);
    certificate.traceable = number.is_some() && in_force && !certificate.simulated;
    say_overdue(certificate, standard);
    let id = Value::Text(standard.record.head.id.to_string());
    let said = vec![Value::Text(serial.clone()), id];
    let said = Value::Phrase("substitution.value".to_owned(), said);
    let through = traceability(certificate, serial, number.clone(), due);
    let stated = [
        ("calibration", "substitution", Some(said)),
        (
            "calibration",
            "standard_certificate",
            number.map(Value::Text),
        ),
        ("calibration", "standard_due", due.map(Value::Day)),
        ("equipment", "traceability", Some(through)),
    ];
    for (section, key, value) in stated {
        let mut sections = certificate.sections.iter_mut();
        if let Some(section) = sections.find(|found| found.key == section) {
            section.entries.retain(|entry| entry.key != key);
            let clause = CLAUSE;
            section.entries.push(Entry { key, clause, value });
        }
    }
}

/// Says that an overdue standard was used, and why.
fn say_overdue(certificate: &mut Certificate, standard: &Standard) {
    let overdue = overdue(certificate, standard);
    let why = certificate
        .particulars
        .calibration
        .overdue_reference
        .clone();
    let Some((due, why)) = overdue.zip(why) else {
        return;
    };
    for (severity, key, value) in [
        (Severity::Error, "reference_overdue", Value::Day(due)),
        (Severity::Warning, "reference_override", Value::Text(why)),
    ] {
        let values = vec![value];
        certificate.remarks.push(Remark {
            severity,
            key,
            values,
        });
    }
}

fn traceability(
    certificate: &Certificate,
    serial: String,
    number: Option<String>,
    due: Option<Date>,
) -> Value {
    let phrase = |key: &str, values| Value::Phrase(key.to_owned(), values);
    match number.zip(due).filter(|_| certificate.traceable) {
        Some((number, due)) => phrase(
            "statement.traceability_standard",
            vec![Value::Text(serial), Value::Text(number), Value::Day(due)],
        ),
        None if certificate.simulated => phrase("traceability.simulated", vec![]),
        None => phrase("traceability.standard_not_in_force", vec![]),
    }
}

fn serial_of(record: &Record) -> &str {
    record.head.labels.dut_serial.trim()
}

fn belong_together(standard: &Record, device: &Record) -> Result<()> {
    let problem = match () {
        () if standard.head.instrument_serial != device.head.instrument_serial => {
            "were measured with two instruments"
        }
        () if standard.settings != device.settings => "were measured with other settings",
        () if serial_of(standard) == serial_of(device) => "are of one device",
        () => return Ok(()),
    };
    Err(Error::input(
        format!("records {} and {}", standard.head.id, device.head.id),
        problem,
        "`calib run --substitute` measures standard and device one after the other",
    ))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests_dcc::FULL;
    use crate::{Format, Mark, Options, Prepared, prepare};
    use calib_record::sample::{record, text};

    const CERTIFIED: [StandardPoint; 1] = [StandardPoint {
        frequency_hz: 160.0,
        sensitivity_v_per_ms2: 0.0102,
        expanded_uncertainty_rel: 0.004,
    }];

    fn by(standard: &Record, device: &Record) -> Result<Vec<Substituted>> {
        let standard = Standard {
            record: standard.clone(),
            certified: CERTIFIED.to_vec(),
        };
        substitute(&standard, device, &Particulars::default())
    }

    fn pair() -> (Record, Record) {
        let mut standard = record(&[160.0, 1000.0]);
        standard.head.labels.dut_serial = text("CHK-1");
        let mut device = record(&[160.0, 1000.0]);
        device.head.id += 1;
        for point in &mut device.points {
            point.sensitivity_v_per_ms2 *= 0.98;
        }
        (standard, device)
    }

    /// Rows 8 and 11 (0.05 and, for 1.1 K, 0.132 %) and the scatter of 0.015 % twice: U = 0.234 % of the ratio, and 0.4 % of the
    /// standard: 0.464 %. An instrument that reads both 3 % high gives the same.
    #[test]
    fn what_the_instrument_does_to_both_cancels() {
        for gain in [1.0, 1.03] {
            let (mut standard, mut device) = pair();
            for point in standard.points.iter_mut().chain(&mut device.points) {
                point.sensitivity_v_per_ms2 *= gain;
            }
            let found = by(&standard, &device).expect("a pair");
            assert_eq!(found.len(), 1, "1 kHz is not certified");
            // f32 of the records.
            assert!((found[0].sensitivity_v_per_ms2 / (0.0102 * 0.98) - 1.0).abs() < 5e-7);
            let rows = (0.05_f64.powi(2) + 0.132_f64.powi(2)) / 3.0 + 0.015_f64.powi(2);
            let ratio = 0.02 * (2.0 * rows).sqrt();
            let stated = found[0].expanded_uncertainty_ratio_rel;
            assert!((stated / ratio - 1.0).abs() < 1e-3, "{stated} {ratio}");
            let whole = found[0].expanded_uncertainty_rel;
            assert!((whole / ratio.hypot(0.004) - 1.0).abs() < 1e-3, "{whole}");
        }
    }

    /// The sample's particulars, with the standard among the equipment.
    fn stated(due: &str, more: &str) -> Particulars {
        let used = format!(
            "[[equipment]]\nname = 'standard'\nserial = 'chk-1'\ncertificate = 'NMI 7'\ndue = '{due}'\n"
        );
        let text = FULL.replace("[conditions]", &format!("{more}\n[conditions]"));
        toml::from_str(&format!("{text}\n{used}")).expect("TOML")
    }

    fn certified(particulars: Particulars) -> Result<Prepared> {
        let (standard, device) = pair();
        let options = Options {
            particulars,
            standard: Some(Standard {
                record: standard,
                certified: CERTIFIED.to_vec(),
            }),
            ..Options::default()
        };
        prepare(&device, &[Format::Json, Format::Dcc], &options)
    }

    /// Air of 22.6 degrees is 1.4 K: row 11 is 0.168 %, row 8 0.05 %, scatter 0.015 %, twice; 0.4 / 2 % of the standard.
    #[test]
    fn a_certificate_by_substitution_states_the_standard_and_what_is_left() {
        let prepared = certified(stated("2030-01-01", "")).expect("a pair");
        assert_eq!(prepared.marks, []);
        let json = &prepared.files[0].content;
        let json: serde_json::Value = serde_json::from_slice(json).expect("JSON");
        let point = &json["points"][0];
        let sensitivity = point["sensitivity_v_per_ms2"].as_f64().expect("S");
        assert!(
            (sensitivity / (0.0102 * 0.98) - 1.0).abs() < 5e-7,
            "{sensitivity}"
        );
        let rows = (0.05_f64.powi(2) + 0.168_f64.powi(2)) / 3.0 + 0.015_f64.powi(2);
        let expanded = 0.02 * (2.0 * rows + 0.04).sqrt();
        let stated_u = point["expanded_uncertainty_rel"].as_f64().expect("U");
        assert!(
            (stated_u / expanded - 1.0).abs() < 1e-3,
            "{stated_u} {expanded}"
        );
        assert_eq!(json["points"][1]["reason"], "frequency_unavailable");
        let budget = &json["budget"];
        let of_budget = budget["expanded_uncertainty_rel"].as_f64().expect("U");
        assert!((of_budget / expanded - 1.0).abs() < 1e-3, "{budget}");
        let said = json["calibration"]["substitution"].as_str().expect("said");
        assert!(said.contains("CHK-1"), "{said}");
        assert_eq!(json["calibration"]["standard_certificate"], "NMI 7");
        let through = json["equipment"]["traceability"].as_str().expect("said");
        assert!(
            through.contains("CHK-1") && through.contains("NMI 7"),
            "{through}"
        );
        let dcc = String::from_utf8_lossy(&prepared.files[1].content);
        assert!(dcc.contains("<dcc:traceable>true"), "{dcc}");
        // The same U as the table of the run.
        let (standard, device) = pair();
        let run = Standard {
            record: standard,
            certified: CERTIFIED.to_vec(),
        };
        let run = substitute(&run, &device, &stated("2030-01-01", "")).expect("a pair");
        assert!((run[0].expanded_uncertainty_rel / stated_u - 1.0).abs() < 1e-6);
    }

    #[test]
    fn a_standard_nobody_states_or_that_is_overdue_is_no_traceable_one() {
        let unknown = certified(toml::from_str(FULL).expect("TOML")).expect("a draft");
        let is_draft = |(mark, _): &(Mark, String)| *mark == Mark::Draft;
        assert!(unknown.marks.iter().any(is_draft), "{:?}", unknown.marks);
        let dcc = String::from_utf8_lossy(&unknown.files[1].content);
        assert!(dcc.contains("<dcc:traceable>false"), "{dcc}");
        let refused = certified(stated("2025-01-01", "")).expect_err("overdue");
        assert!(refused.to_string().contains("2025-01-01"), "{refused}");
        let why = "overdue_reference = 'it is on its way'";
        let printed = certified(stated("2025-01-01", why)).expect("overridden in writing");
        let json = String::from_utf8_lossy(&printed.files[0].content);
        assert!(json.contains("it is on its way") && json.contains("reference_overdue"));
        let dcc = String::from_utf8_lossy(&printed.files[1].content);
        assert!(dcc.contains("<dcc:traceable>false"), "{dcc}");
    }

    #[test]
    fn records_that_are_no_pair_are_refused() {
        let refused = |change: fn(&mut Record), words: &str| {
            let (standard, mut device) = pair();
            change(&mut device);
            let error = by(&standard, &device).expect_err(words);
            assert!(error.to_string().contains(words), "{error}");
        };
        refused(|r| r.head.instrument_serial.clear(), "two instruments");
        refused(|r| r.settings.blocks += 1, "other settings");
        refused(|r| r.head.labels.dut_serial = text("CHK-1"), "one device");
        refused(|r| r.points.clear(), "no valid point");
    }
}
