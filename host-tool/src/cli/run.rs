//! `calib run`: measures a point list.

use super::certificate::{Laboratory, passed};
use super::measure::{Asked, Kept, judge, keep, measure, switch_of_interrupts};
use super::number::{finite, positive};
use super::remount::{self, Mountings, Remounting};
use super::substitute::{self, Known as Standard, Substitution};
use super::{Context, logbook, progress, progress::RunProgress, source, text, time};
use calib_certificate::{
    Certificate, ConformityStatement, Language, MountedResonance, Particulars, SensorKind,
    instrument_covers, said_of_closing,
};
use calib_core::point::{ExcitationKind, PointSpec};
use calib_core::settings::Settings;
use calib_host::in_unit::{StatedPoint, Stating};
use calib_host::refusals::{self, Refused};
use calib_host::{Error, Result, judged, terminal};
use calib_link::session::{self, Outcome, label, temperature_centi_c};
use calib_link::{Client, StopSwitch};
use calib_logbook::Sensor;
use calib_output::code;
use calib_protocol::message::RunState;
use calib_protocol::record::{Record, RunLabels};
use clap::{Args, ValueEnum};
use schemars::JsonSchema;
use serde::Serialize;
use std::path::PathBuf;

/// `calib run`.
#[derive(Debug, Args)]
pub(crate) struct Run {
    /// Point list, .toml or .csv; default: one-third octaves, 20 Hz to 10 kHz.
    #[arg(long, short, value_name = "FILE")]
    points: Option<PathBuf>,
    /// Measures again only what this record refused or never tried, because it ended early: a file, or the number of a
    /// record. Device and mounting are those of the record unless stated; the conformity is that of both.
    #[arg(long, value_name = "RECORD", conflicts_with_all = ["points", "level", "excitation"])]
    retry: Option<PathBuf>,
    /// Set acceleration of points that state none, m/s2 r.m.s.
    #[arg(long, short, default_value_t = 10.0, value_name = "MS2", value_parser = positive::<f32>)]
    level: f32,
    /// How the exciter is driven (ISO 16063-21, 4.4 Note 1). Broadband: all
    /// points at once, moved to the lines of a record of 4096 samples; the level
    /// is the total r.m.s. of the band.
    #[arg(long, value_enum, default_value_t = Excitation::SingleSine)]
    excitation: Excitation,
    /// Device under test, by its serial number in the logbook: model and
    /// mounting are known there.
    #[arg(long, value_name = "SERIAL", conflicts_with_all = ["model", "serial"])]
    sensor: Option<String>,
    /// Device under test: manufacturer and model.
    #[arg(long, value_name = "TEXT", default_value = "")]
    model: String,
    /// Device under test: serial number.
    #[arg(long, value_name = "TEXT", default_value = "")]
    serial: String,
    /// Operator who calibrates.
    #[arg(long, value_name = "NAME", default_value = "", env = "CALIB_OPERATOR")]
    operator: String,
    /// Temperature of the transducer, degrees Celsius.
    #[arg(long, value_name = "CELSIUS", allow_negative_numbers = true, value_parser = finite::<f64>)]
    temperature: Option<f64>,
    /// How the device under test is mounted.
    #[arg(long, value_name = "TEXT", default_value = "")]
    mounting: String,
    /// Measures the list this many times, and asks for the device to be taken off and mounted again in between. The
    /// scatter between mountings is evaluated (ISO 16063-21, 5.2). Each mounting gives a record of its own.
    #[arg(long, value_name = "N", default_value_t = 1, conflicts_with = "retry", value_parser = clap::value_parser!(u8).range(1..=20))]
    remount: u8,
    /// Measures this standard first and then the device, both at the input of the device: S2 = S1 X2 / X1, in which
    /// the instrument's reference, its gain and the ratio of its channels cancel (ISO 16063-21, 4.5).
    #[arg(long, value_name = "CHECK", conflicts_with_all = ["retry", "remount", "excitation"])]
    substitute: Option<String>,
    /// Table of the standard's certificate (CSV: frequency_hz, sensitivity_mv, expanded_uncertainty_percent)
    /// [default: what `calib assure` was told].
    #[arg(long, value_name = "FILE", requires = "substitute")]
    standard: Option<PathBuf>,
    /// Unit of the sensitivities shown, as of `calib sensors add` [default: that of the sensor].
    #[arg(long, value_name = "UNIT")]
    unit: Option<SensorKind>,
    #[command(flatten)]
    laboratory: Laboratory,
}

/// Names of [`ExcitationKind`] on the command line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Excitation {
    /// One tone after another.
    SingleSine,
    /// All lines at once, the same record 64 times.
    Multisine,
    /// Periodic noise, 64 different records.
    Random,
}

impl From<Excitation> for ExcitationKind {
    fn from(excitation: Excitation) -> Self {
        match excitation {
            Excitation::SingleSine => Self::SingleSine,
            Excitation::Multisine => Self::Multisine,
            Excitation::Random => Self::Random,
        }
    }
}

/// How a run ended.
#[derive(Serialize, JsonSchema)]
pub(super) struct RunResult {
    /// Running number of the record in the calibrator.
    record_id: u32,
    /// Number of the record in the logbook, if it is kept there.
    logbook_record: Option<i64>,
    /// `finished`, `stopped`, or `failed` when the record could not be stored.
    state: String,
    /// Time of the instrument's own clock from the order to its end, s; with `--remount` of the last mounting. None
    /// where it did not say.
    instrument_s: Option<f64>,
    /// Unit of `in_unit` of the points.
    unit: &'static str,
    /// Every point in the order measured.
    points: Vec<StatedPoint>,
    /// Conformity of the sensor by its tolerance; none when it has none.
    conformity_statement: Option<ConformityStatement>,
    /// Why points were refused, and what to do about it.
    refusals: Vec<Refused>,
    /// Change until the first point was repeated at the end, in words; none where nothing changed.
    closing: Option<String>,
    /// The mounted resonance that the points show; none where there is none from 1 kHz on, or no record.
    mounted_resonance: Option<MountedResonance>,
    /// With `--remount`: every mounting's record, this one included, and their scatter.
    remounting: Option<Remounting>,
    /// With `--substitute`: the device by the standard.
    substitution: Option<Substitution>,
}

impl Run {
    /// Measures, follows, and says how it ended.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let before = self.record_before(context)?;
        let completed = before.clone();
        let mut points = self.points(before.as_ref())?;
        let sensor = self.sensor(context, before.as_ref())?;
        let labels = self.labels(&sensor, before.as_ref())?;
        // What cannot be judged afterwards is said before anything moves.
        let mut particulars = self.particulars(context, &labels)?;
        judged::show_in(&mut particulars, self.unit)?;
        let kind = particulars.kind();
        let standard = self.standard(context)?;
        let mut client = context.connect()?;
        let info = client.info()?;
        let excitation = ExcitationKind::from(self.excitation);
        if excitation != ExcitationKind::SingleSine {
            points = session::on_lines(&points, info.sample_rate_hz)?;
        }
        possible(&points, &client.settings()?, info.sample_rate_hz)?;
        if !context.for_program() {
            remark_on_temperature(context, labels.temperature_centi_c);
        }
        let stating = Stating::new(kind, info.sample_rate_hz);
        let stating = match &completed {
            Some(first) => stating.following(&stating.all(&first.points)),
            None => stating,
        };
        let asked = Asked {
            points: &points,
            excitation,
            stating,
        };
        let switch = switch_of_interrupts(context);
        let before = match &standard {
            Some(standard) => Some(self.measure_standard(
                context,
                &mut client,
                &asked,
                &labels,
                (standard, &switch),
            )?),
            None => None,
        };
        let (mountings, outcome, kept, instrument_s) =
            self.measure_mountings(context, &mut client, &asked, labels, &switch)?;
        let substitution = match standard.zip(before) {
            Some((standard, before)) => {
                let device = session::take(&mut client, outcome.record_id)?.0;
                Some(standard.substituted(before, &device, &particulars)?)
            }
            None => None,
        };
        let whole = kept.as_ref().map(|kept| match &completed {
            Some(first) => completed_by(first, &kept.record),
            None => kept.record.clone(),
        });
        let of_record = |record: &Record| Certificate::from_record(record, &particulars);
        let certificate = whole.as_ref().map(of_record);
        let conformity = |record: &Record| match &completed {
            Some(_) => judged::conformity_statement(record, &particulars),
            None => mountings.conformity_statement(&particulars),
        };
        let result = RunResult {
            record_id: outcome.record_id,
            logbook_record: kept.as_ref().and_then(|kept| kept.id),
            state: code(&outcome.state),
            instrument_s,
            unit: kind.unit().name(),
            points: match &certificate {
                Some(certificate) => stating.certified(&outcome.points, certificate),
                None => stating.all(&outcome.points),
            },
            conformity_statement: whole.as_ref().and_then(conformity),
            refusals: refusals::of(&outcome.points),
            closing: kept
                .as_ref()
                .and_then(|kept| said_of_closing(&kept.record, Language::default())),
            mounted_resonance: certificate.as_ref().and_then(|c| c.resonance),
            remounting: mountings.remounting(),
            substitution,
        };
        if let Some(closing) = &result.closing {
            context.remark(closing);
        }
        for key in ["mount_gives_way", "mount_unseen", "polarity_doubtful"] {
            let warning = |c: &Certificate| c.remark(key, Language::default());
            if let Some(warning) = certificate.as_ref().and_then(warning) {
                context.remark(&warning);
            }
        }
        let certified = certificate.as_ref().and_then(said_of_certificate);
        progress::print_result(context, &result, || said(&result, certified))?;
        judge(&outcome, points.len())?;
        passed(result.conformity_statement.as_ref())
    }

    fn standard(&self, context: &Context) -> Result<Option<Standard>> {
        let find = |serial: &String| Standard::find(context, serial, self.standard.as_deref());
        self.substitute.as_ref().map(find).transpose()
    }

    /// Measures the standard at the input of the device, and asks for the device.
    fn measure_standard(
        &self,
        context: &Context,
        client: &mut Client,
        asked: &Asked<'_>,
        labels: &RunLabels,
        (standard, switch): (&Standard, &StopSwitch),
    ) -> Result<Record> {
        remount::wait_for(&format!("Mount the standard {}", standard.serial))?;
        let labels = RunLabels {
            dut_serial: label("--substitute", &standard.serial)?,
            dut_model: label("--substitute", "standard of a substitution")?,
            ..labels.clone()
        };
        let progress = RunProgress::new(context, asked.stating);
        let mut progress = progress.with_points_as_result();
        let outcome = measure(context, client, asked, labels, switch, &mut progress)?;
        progress.end(&outcome.points);
        keep(context, client, &outcome)?;
        judge(&outcome, asked.points.len())?;
        let record = session::take(client, outcome.record_id)?.0;
        remount::wait_for(&format!(
            "Record {}. Mount the device in its place",
            outcome.record_id
        ))?;
        Ok(record)
    }

    /// Measures, and once more for every mounting that is wanted.
    fn measure_mountings(
        &self,
        context: &Context,
        client: &mut Client,
        asked: &Asked<'_>,
        mut labels: RunLabels,
        switch: &StopSwitch,
    ) -> Result<(Mountings, Outcome, Option<Kept>, Option<f64>)> {
        let mut mountings = Mountings::default();
        loop {
            let progress = RunProgress::new(context, asked.stating);
            let mut progress = progress.with_points_as_result();
            let begun_ms = clock_ms(client);
            let outcome = measure(
                context,
                client,
                asked,
                labels.clone(),
                switch,
                &mut progress,
            )?;
            let took_s = |from: u64| Some(1e-3 * clock_ms(client)?.checked_sub(from)? as f64);
            let instrument_s = begun_ms.and_then(took_s);
            progress.end(&outcome.points);
            let kept = keep(context, client, &outcome)?;
            mountings.add(&outcome, kept.as_ref());
            let enough = mountings.count() >= usize::from(self.remount);
            if enough || outcome.state != RunState::Finished {
                return Ok((mountings, outcome, kept, instrument_s));
            }
            mountings.wait_for_the_next(outcome.record_id)?;
            if switch.is_asked() {
                return Ok((mountings, outcome, kept, instrument_s));
            }
            labels.unix_time_s = time::unix_time_s();
        }
    }

    /// The record whose refused points are measured again.
    fn record_before(&self, context: &Context) -> Result<Option<Record>> {
        let Some(name) = &self.retry else {
            return Ok(None);
        };
        let folder = tempfile::tempdir()
            .map_err(|error| Error::file("create", &std::env::temp_dir(), error))?;
        let found = source::find(context, name, folder.path())?;
        found.calibration().cloned().map(Some)
    }

    fn points(&self, before: Option<&Record>) -> Result<Vec<PointSpec>> {
        if let Some(record) = before {
            return points_left(record);
        }
        match &self.points {
            Some(path) => Ok(session::read_points(path, self.level)?),
            None => Ok(session::default_points(self.level)),
        }
    }

    fn sensor(&self, context: &Context, before: Option<&Record>) -> Result<Sensor> {
        let typed = !self.serial.is_empty() || !self.model.is_empty();
        match (&self.sensor, before.filter(|_| !typed)) {
            (Some(serial), _) => logbook::find_sensor(context, serial),
            (None, Some(record)) => Ok(of_labels(context, &record.head.labels)?),
            (None, None) => Ok(Sensor {
                serial: self.serial.clone(),
                model: self.model.clone(),
                ..Sensor::default()
            }),
        }
    }

    fn particulars(&self, context: &Context, labels: &RunLabels) -> Result<Particulars> {
        let files = self.laboratory.before(&[]);
        let logbook = context.logbook_if_there()?;
        judged::particulars(&files, labels, logbook.as_ref())
    }

    /// Labels of the run: what is stated, else that of the record it completes, if that is of the same day.
    fn labels(&self, sensor: &Sensor, before: Option<&Record>) -> Result<RunLabels> {
        let now_s = time::unix_time_s();
        let fresh = |record: &&Record| now_s.abs_diff(record.head.labels.unix_time_s) < DAY_S;
        let before = before.filter(fresh).map(|record| &record.head.labels);
        let operator = match self.operator.as_str() {
            "" => before.map_or("", |labels| labels.operator.as_str()),
            stated => stated,
        };
        let temperature_centi_c = temperature_centi_c("--temperature", self.temperature)?;
        let mounting = match self.mounting.as_str() {
            "" => sensor.mounting.as_deref().unwrap_or_default(),
            stated => stated,
        };
        Ok(RunLabels {
            unix_time_s: now_s,
            dut_model: label("--model", &sensor.name())?,
            dut_serial: label("--serial", &sensor.serial)?,
            operator: label("--operator", operator)?,
            temperature_centi_c: temperature_centi_c
                .or(before.and_then(|labels| labels.temperature_centi_c)),
            mounting: label("--mounting", mounting)?,
        })
    }
}

/// A day, s.
const DAY_S: u64 = 86_400;

/// The clock of the instrument, if it answers.
fn clock_ms(client: &mut Client) -> Option<u64> {
    client.info().ok().map(|info| info.uptime_ms)
}

/// The sensor of a record: as the logbook knows it, else as the record names it.
fn of_labels(context: &Context, labels: &RunLabels) -> Result<Sensor> {
    let known = match context.logbook_if_there()? {
        Some(logbook) => logbook.sensor(&labels.dut_serial)?,
        None => None,
    };
    Ok(known.unwrap_or_else(|| Sensor {
        serial: labels.dut_serial.to_string(),
        model: labels.dut_model.to_string(),
        mounting: Some(labels.mounting.to_string()),
        ..Sensor::default()
    }))
}

/// A record with what a later one measured of it.
fn completed_by(record: &Record, later: &Record) -> Record {
    let whole = calib_certificate::complete(record, std::slice::from_ref(later));
    whole.unwrap_or_else(|_| record.clone())
}

/// The points of a record that have no result.
fn points_left(record: &Record) -> Result<Vec<PointSpec>> {
    let points: Vec<PointSpec> = calib_certificate::without_result(record).collect();
    match points.is_empty() {
        false => Ok(points),
        true => Err(Error::input(
            format!("record {}", record.head.id),
            "has a result for every point",
            "there is nothing to measure again",
        )),
    }
}

/// Refuses a list with points that cannot be measured, before anything moves.
fn possible(list: &[PointSpec], settings: &Settings, sample_rate_hz: f32) -> Result<()> {
    let impossible = refusals::impossible(list, settings, sample_rate_hz);
    let Some(first) = impossible.first() else {
        return Ok(());
    };
    let lines: Vec<String> = impossible.iter().map(frequencies).collect();
    Err(Error::input("point list", lines.join("; "), first.remedy))
}

/// Frequencies of a refusal and its reason in words.
fn frequencies(refused: &Refused) -> String {
    let hz: Vec<String> = refused.frequencies_hz.iter().map(f32::to_string).collect();
    format!("{} Hz: {}", hz.join(", "), refused.reason_text)
}

/// Text printed after the points of a run: what was refused and why, the conformity of the sensor, and
/// where the record is.
fn said(result: &RunResult, certified: Option<String>) -> String {
    let advice = |refused: &Refused| format!("{}\n  {}", frequencies(refused), refused.remedy);
    let mut lines: Vec<String> = result.refusals.iter().map(advice).collect();
    lines.extend(certified);
    let shown = result.mounted_resonance.and_then(|shown| shown.in_words());
    lines.extend(shown.map(|said| format!("mounted resonance, effective: {said}")));
    lines.extend(result.remounting.as_ref().map(remount::text));
    lines.extend(result.substitution.as_ref().map(substitute::text));
    lines.extend(
        result
            .conformity_statement
            .as_ref()
            .map(terminal::conformity_statement),
    );
    let next = match result.logbook_record {
        Some(_) => "kept in the logbook".to_owned(),
        None => format!("calib download {}", result.record_id),
    };
    lines.push(format!("record {}: {next}", result.record_id));
    lines.join("\n")
}

/// Result at the reference point with U of a certificate, beside the lines with the instrument's.
fn said_of_certificate(certificate: &Certificate) -> Option<String> {
    let (point, values) = certificate.reference_result()?;
    let unit = certificate.kind.unit();
    Some(format!(
        "S({} Hz) = {} {}, U = {:.2} % (k = {:.2}) on a certificate\n\
         U of the lines above is the instrument's, without temperature and mount",
        point.nominal_frequency_hz,
        text::sensitivity(unit.of_si(values.sensitivity)),
        unit.name(),
        values.expanded_uncertainty_percent,
        values.coverage_factor,
    ))
}

/// Says where certificates will state a larger U than the instrument, which is printed.
fn remark_on_temperature(context: &Context, told_centi_c: Option<i16>) {
    match told_centi_c.map(|centi_c| f64::from(centi_c) / 100.0) {
        None => context.remark(
            "no --temperature: certificates state U for all that ISO 16063-21, 4.2 allows",
        ),
        Some(told_c) if !instrument_covers(told_c) => context.remark(&format!(
            "{told_c} degrees: certificates state a larger U than the instrument, which covers 3 K to either side of 23",
        )),
        Some(_) => {}
    }
}
