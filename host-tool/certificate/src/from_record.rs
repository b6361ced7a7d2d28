//! From a decoded record to the certificate: the only place that computes.

use super::around::minute;
use super::budget::{self, Basis};
use super::conformity;
use super::decision::Request;
use super::interval::{InForce, in_force};
use super::kind::{OfSensor, SensitivityUnit, SensorKind, Specified};
use super::linearity;
use super::model::{Certificate, Refusal, Remark, Severity, Value};
use super::model::{Deviation, Point, PointValues};
use super::mountings::Mountings;
use super::particulars::Particulars;
use super::polarity::Polarity;
use super::resonance;
use super::rounding::{Rounded, round_uncertainty};
use super::search;
use super::sections::{is_traceable, sections};
use super::stored::{run_day, unix_day};
use super::substitution::{self, Standard};
use calib_core::closing::Closing;
use calib_core::point::PointResult;
use calib_core::point_state::PointState;
use calib_output::PointView;
use calib_output::number::decimal;
use calib_protocol::clock::ClockReading;
use calib_protocol::provenance::{LoggedChange, Provenance};
use calib_protocol::record::Record;
use calib_protocol::update::ImageSigner;
use calib_record::origin::is_emulated;
use jiff::civil::Date;

impl Certificate {
    /// The certificate of a record and of what else is to be stated.
    ///
    /// Points are ordered by frequency and level; the reference point is
    /// chosen per clause 5.3 among those that passed. The budget there is
    /// recomputed from the settings and compared with the stored U.
    pub fn from_record(record: &Record, particulars: &Particulars) -> Self {
        Self::with_mountings(record, particulars, &Mountings::ONCE)
    }

    /// [`Self::from_record`] of one device that was mounted again for every record: means, with the scatter
    /// between mountings in every budget.
    ///
    /// # Errors
    /// [`calib_files::Error::Input`] when the records do not belong together.
    pub fn from_records(
        record: &Record,
        others: &[Record],
        particulars: &Particulars,
    ) -> calib_files::Result<Self> {
        let (joined, mountings) = Mountings::join(record, others)?;
        Ok(Self::with_mountings(&joined, particulars, &mountings))
    }

    /// [`Self::from_record`] by substitution: the sensitivity from the standard's own certificate and the ratio of what
    /// was found for device and standard in one channel.
    ///
    /// # Errors
    /// [`calib_files::Error::Input`] when the records are no pair.
    pub fn by_substitution(
        record: &Record,
        standard: &Standard,
        particulars: &Particulars,
    ) -> calib_files::Result<Self> {
        let joined = substitution::join(record, standard)?;
        let left_of = substitution::left_of_pair(standard, particulars);
        let basis = |record, particulars: &Particulars| {
            Basis::new(record, particulars, &substitution::ONCE).by_substitution(left_of)
        };
        let mut certificate = Self::of(&joined, particulars, &Mountings::ONCE, basis);
        substitution::attach(&mut certificate, standard);
        Ok(certificate)
    }

    fn with_mountings(record: &Record, particulars: &Particulars, mountings: &Mountings) -> Self {
        Self::of(record, particulars, mountings, |record, particulars| {
            Basis::new(record, particulars, mountings)
        })
    }

    fn of<'a>(
        record: &'a Record,
        particulars: &Particulars,
        mountings: &Mountings,
        basis: impl FnOnce(&'a Record, &Particulars) -> Basis<'a>,
    ) -> Self {
        let mut measured: Vec<&PointResult> = record.points.iter().collect();
        measured.sort_by(|a, b| {
            let key = |p: &PointResult| (p.spec.frequency_hz, p.spec.acceleration_rms_ms2);
            let (a, b) = (key(a), key(b));
            a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1))
        });
        let particulars = &judging(record, particulars);
        let kind = particulars.kind();
        let basis = basis(record, particulars);
        let polarity = Polarity::of(kind, &record.points);
        let in_order = measured.iter();
        let mut points: Vec<Point> = in_order
            .map(|p| point(p, &basis, record, polarity))
            .collect();
        let reference = reference_point(&points);
        state_deviations(&mut points, reference, &basis);
        let between = particulars.around.between(record);
        let one_day = between.and_then(|(first, last)| (first == last).then_some(first));
        let mut certificate = Self {
            number: number(record, particulars),
            day: run_day(record).or(particulars.calibration.date).or(one_day),
            between,
            particulars: particulars.clone(),
            sections: sections(record, particulars),
            inverted: polarity.is_inverted(),
            kind,
            reference,
            points,
            budget: None,
            decision: None,
            remarks: Vec::new(),
            as_found: None,
            resonance: None,
            record_chain: None,
            untried_hz: record
                .untried
                .iter()
                .map(|point| decimal(point.frequency_hz))
                .collect(),
            is_closed: !matches!(record.closing, Closing::Refused(_)),
            simulated: is_emulated(&record.head.instrument_serial),
            traceable: is_traceable(record, particulars),
        };
        mountings.state(&mut certificate);
        linearity::attach(&mut certificate, &basis);
        search::attach(&mut certificate, &basis);
        certificate.remarks = remarks(record, &certificate);
        certificate.remarks.extend(closing_remark(record));
        certificate.remarks.push(basis.distance.remark());
        resonance::attach(&mut certificate, &basis.mounted, &record.settings);
        conformity::attach(&mut certificate);
        match reference {
            Some(index) => budget::attach(&mut certificate, &basis, measured[index]),
            None => budget::say_why_none(&mut certificate, &basis),
        }
        certificate
    }
}

/// A record that was judged at the instrument is judged by its own limits, unless a tolerance is stated.
fn judging(record: &Record, particulars: &Particulars) -> Particulars {
    let mut particulars = particulars.clone();
    let stated = particulars.decision.as_ref();
    if stated.is_none_or(Request::is_open) && !record.list.is_none() {
        particulars.decision = of_list(record, particulars.kind());
    }
    particulars
}

/// The terms the instrument judged by; nothing of a sensor it cannot judge.
fn of_list(record: &Record, kind: SensorKind) -> Option<Request> {
    let mut request = Request::of_terms(&record.list);
    request.nominal = request.nominal.map(|nominal| {
        let of_sensor = kind.of_v_per_ms2(nominal.si, 160.0);
        Specified::of_si(of_sensor, kind.unit())
    });
    (kind.steps() == 0 && !kind.is_reported_only()).then_some(request)
}

fn number(record: &Record, particulars: &Particulars) -> String {
    let stated = particulars.calibration.number.clone();
    stated.unwrap_or_else(|| format!("{}-{:06}", record.head.instrument_serial, record.head.id))
}

fn point(result: &PointResult, basis: &Basis<'_>, record: &Record, polarity: Polarity) -> Point {
    let mut view = PointView::new(result, record.head.sample_rate_hz);
    let nominal_frequency_hz = decimal(result.spec.frequency_hz);
    let frequency_hz = view.actual_frequency_hz.unwrap_or(nominal_frequency_hz);
    let of_sensor = polarity.split(result, frequency_hz);
    let outcome = outcome(result, of_sensor, basis);
    match &outcome {
        Err(_) if view.is_valid() => view.refuse("not_reportable"),
        Ok(values) if !basis.is_the_instruments() => state_uncertainty(&mut view, values),
        _ => {}
    }
    let acceleration_ms2 = decimal(result.acceleration_rms_ms2);
    Point {
        nominal_frequency_hz,
        frequency_hz,
        nominal_acceleration_ms2: decimal(result.spec.acceleration_rms_ms2),
        acceleration_ms2,
        amplitude_rms: basis.kind.amplitude(acceleration_ms2, frequency_hz),
        outcome,
        measured: *result,
        view,
    }
}

/// U as certified, in place of the instrument's.
fn state_uncertainty(view: &mut PointView, values: &PointValues) {
    let single = |value: f64| Some(value as f32).filter(|value| value.is_finite());
    view.expanded_uncertainty_rel = single(values.expanded_uncertainty_percent / 100.0);
    view.coverage_factor = single(values.coverage_factor);
    view.effective_degrees_of_freedom = single(values.effective_degrees_of_freedom);
    view.expanded_uncertainty_phase_deg = Some(values.expanded_uncertainty_phase_deg);
}

fn outcome(
    result: &PointResult,
    of_sensor: OfSensor,
    basis: &Basis<'_>,
) -> Result<PointValues, Refusal> {
    match result.state {
        PointState::Refused(reason) => Err(Refusal(format!("{reason:?}"))),
        // A result without a valid U is none, whatever its state says.
        PointState::Valid => {
            values(result, of_sensor, basis).ok_or_else(|| Refusal("NotReportable".to_owned()))
        }
    }
}

fn values(result: &PointResult, of_sensor: OfSensor, basis: &Basis<'_>) -> Option<PointValues> {
    let stated = basis.uncertainty(result)?;
    let OfSensor {
        magnitude,
        phase_deg,
    } = of_sensor;
    let relative = stated.expanded_rel;
    let phase_u_deg = stated.expanded_phase_rad.to_degrees();
    let coverage_factor = stated.coverage_factor;
    let rounded = |unit: SensitivityUnit| {
        let value = unit.of_si(magnitude);
        Rounded::new(value, value * relative)
    };
    let (rounded_u, digit) = round_uncertainty(relative * 100.0, 2)?;
    let usable = magnitude > 0.0 && coverage_factor > 0.0 && phase_deg.is_finite();
    usable.then_some(())?;
    Some(PointValues {
        sensitivity: magnitude,
        expanded_uncertainty_percent: relative * 100.0,
        coverage_factor,
        effective_degrees_of_freedom: stated.effective_degrees_of_freedom,
        phase_deg,
        expanded_uncertainty_phase_deg: phase_u_deg,
        coverage_factor_phase: stated.coverage_factor_phase,
        deviation: None,
        assessment: None,
        printed: rounded(basis.kind.stated_unit())?,
        printed_per_g: basis.kind.per_g_unit().and_then(rounded),
        printed_phase_deg: Rounded::new(phase_deg, phase_u_deg),
        printed_uncertainty_percent: (rounded_u, usize::try_from(digit).unwrap_or(0)),
    })
}

/// The reference point of clause 5.3: 160 Hz, else 80 Hz; there 100 m/s2, else
/// 10, 20 or 50 m/s2, else any level. Without either frequency the point
/// nearest to 160 Hz on the logarithmic axis stands in.
fn reference_point(points: &[Point]) -> Option<usize> {
    let rank = |point: &Point| {
        let octaves = |hz: f64| (point.nominal_frequency_hz / hz).log2().abs();
        // omega = 1000 rad/s and 500 rad/s count as 160 Hz and 80 Hz.
        let frequency = if octaves(160.0) < 0.01 {
            0.0
        } else if octaves(80.0) < 0.01 {
            0.001
        } else {
            octaves(160.0)
        };
        let level = [100.0, 10.0, 20.0, 50.0]
            .iter()
            .position(|level| (point.nominal_acceleration_ms2 / level - 1.0).abs() < 0.01)
            .unwrap_or(4);
        (frequency, level)
    };
    let passed = points
        .iter()
        .enumerate()
        .filter(|(_, point)| point.outcome.is_ok());
    passed
        .map(|(index, point)| (rank(point), index))
        .min_by(|(a, _), (b, _)| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)))
        .map(|(_, index)| index)
}

/// Deviations from the reference point; that of the reference point is nothing, without uncertainty.
fn state_deviations(points: &mut [Point], reference: Option<usize>, basis: &Basis<'_>) {
    let Some(at) = reference else { return };
    let of_reference = points[at].measured;
    let Some(of_reference_point) = points[at].values().map(|v| v.sensitivity) else {
        return;
    };
    for (index, point) in points.iter_mut().enumerate() {
        let uncertainty = match index == at {
            true => None,
            false => basis.of_ratio(&point.measured, &of_reference),
        };
        if let Ok(values) = &mut point.outcome {
            let ratio = values.sensitivity / of_reference_point;
            let decimals = values.printed_uncertainty_percent.1;
            values.deviation = Some(Deviation::new(ratio, uncertainty, decimals));
        }
    }
}

fn remarks(record: &Record, certificate: &Certificate) -> Vec<Remark> {
    let refused = certificate
        .points
        .iter()
        .filter(|p| p.outcome.is_err())
        .count();
    let count = |n: usize| Value::Number(n as f64, 0, "");
    let mut remarks = Vec::new();
    let mut say = |severity, key, values| {
        remarks.push(Remark {
            severity,
            key,
            values,
        })
    };
    if certificate.reference.is_none() {
        say(Severity::Error, "no_result", vec![]);
    }
    match certificate.untried_hz.len() {
        0 if record.complete => {}
        0 => say(Severity::Warning, "incomplete", vec![]),
        untried => {
            let hz = |hz: &f64| Value::Exact(*hz, "Hz");
            let all = certificate.untried_hz.iter().map(hz).collect();
            let of = count(untried + certificate.points.len());
            let values = vec![count(untried), of, Value::List(all)];
            say(Severity::Warning, "untried", values);
        }
    }
    if refused > 0 {
        say(
            Severity::Warning,
            "refused",
            vec![count(refused), count(certificate.points.len())],
        );
    }
    match in_force(record, &certificate.particulars, run_day(record)) {
        InForce::AsCalibrated => {}
        InForce::Extended { due, until } => {
            let days = vec![Value::Day(due), Value::Day(until)];
            say(Severity::Warning, "reference_extended", days);
        }
        InForce::Overdue { due } => {
            say(Severity::Error, "reference_overdue", vec![Value::Day(due)]);
            if let Some(why) = &certificate.particulars.calibration.overdue_reference {
                let why = vec![Value::Text(why.clone())];
                say(Severity::Warning, "reference_override", why);
            }
        }
    }
    if let Some((earlier, later)) = certificate.particulars.around.contradiction(record) {
        let times = [earlier, later].map(|time| Value::Text(minute(time)));
        say(Severity::Warning, "clock_backwards", times.to_vec());
    }
    if record.clock != ClockReading::NONE {
        let told = Value::Text(minute(record.clock.told_unix_time_s));
        let uncertainty = Value::Number(f64::from(record.clock.uncertainty_s), 0, "s");
        say(Severity::Note, "clock_counted", vec![told, uncertainty]);
    }
    if record.provenance.differs_from_reference() {
        say(Severity::Warning, "settings_changed", changes(record));
    }
    if certificate.kind.is_reported_only() {
        say(Severity::Note, "reported_only", Vec::new());
    }
    if let Some(phase_deg) = Polarity::of(certificate.kind, &record.points).doubtful_deg() {
        let phase = Value::Number(phase_deg, 1, "°");
        say(Severity::Warning, "polarity_doubtful", vec![phase]);
    }
    if record.image.signer == ImageSigner::Development {
        say(Severity::Warning, "development_image", Vec::new());
    }
    for (name, due) in other_due_days(&certificate.particulars) {
        if run_day(record).is_some_and(|run| due < run) {
            let values = vec![Value::Text(name), Value::Day(due)];
            say(Severity::Error, "equipment_overdue", values);
        }
    }
    if certificate
        .results()
        .any(|(_, values)| (values.coverage_factor - 2.0).abs() > 0.005)
    {
        say(Severity::Note, "coverage_factor", vec![]);
    }
    remarks
}

/// Remark about the repetition of the first point at the end of the run, if any.
pub(super) fn closing_remark(record: &Record) -> Option<Remark> {
    let (key, value) = match record.closing {
        Closing::None => return None,
        Closing::Refused(reason) => {
            let reason = Value::Phrase(format!("reason.{reason:?}"), Vec::new());
            ("not_repeated", reason)
        }
        Closing::Changed(change) => {
            let counts = |p: &PointResult| record.closing.half_widths(p) != [0.0; 2];
            record.points.iter().any(counts).then_some(())?;
            let percent = 100.0 * decimal(change.magnitude_rel);
            ("changed_meanwhile", Value::Number(percent, 2, "%"))
        }
    };
    Some(Remark {
        severity: Severity::Warning,
        key,
        values: vec![value],
    })
}

/// Record and day of the last change of the reference's calibration, and of any setting.
fn changes(record: &Record) -> Vec<Value> {
    let stated = |change: LoggedChange| {
        let day = unix_day(change.unix_time_s).map_or("\u{2013}".to_owned(), |day| day.to_string());
        [change.record_id.to_string(), day].map(Value::Text)
    };
    let Provenance {
        changed,
        reference_changed,
        ..
    } = record.provenance;
    [stated(reference_changed), stated(changed)].concat()
}

/// Equipment used beside the reference, and when its calibration is due.
fn other_due_days(particulars: &Particulars) -> Vec<(String, Date)> {
    let of = |used: &super::particulars::Equipment| Some((used.name.clone(), used.due?));
    let others = particulars.equipment.iter().filter_map(of);
    let calibrator = particulars.calibrator.due;
    let calibrator = calibrator.map(|due| ("calibrator".to_owned(), due));
    calibrator.into_iter().chain(others).collect()
}
