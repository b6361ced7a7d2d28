//! `calib selfcheck`: the reference checked on site by reciprocity.

use super::hand::done_by_hand;
use super::measure::{Asked, judge, keep, measure, switch_of_interrupts};
use super::number::{finite, positive};
use super::progress::{RunProgress, print_result};
use super::{Context, source, time};
use calib_certificate::SensorKind;
use calib_core::point::{ExcitationKind, PointSpec};
use calib_host::in_unit::Stating;
use calib_host::self_check::{self, Found};
use calib_host::{Error, Result};
use calib_link::session::{self, label, temperature_centi_c};
use calib_link::{Client, StopSwitch};
use calib_metrology::reciprocity::{
    Change, CheckPoint, Equipment, Evaluation, Identified, Row, Runs, STEPS, Step, change_text,
    evaluate, levels, report,
};
use calib_protocol::record::{Record, RunLabels};
use clap::Args;
use schemars::JsonSchema;
use serde::Serialize;
use std::io::{IsTerminal, stdin};
use std::path::{Path, PathBuf};

/// Frequencies of a check, Hz: one-third octaves.
const FREQUENCIES_HZ: [f32; 14] = [
    40.0, 50.0, 63.0, 80.0, 100.0, 125.0, 160.0, 200.0, 250.0, 315.0, 400.0, 630.0, 800.0, 1000.0,
];
/// A run after whose number nothing is left to ask for.
const RUNS: usize = STEPS.len();

/// `calib selfcheck`.
#[derive(Debug, Args)]
#[command(after_help = "\
Compares the reference with a mass and the ratio of two voltages, without any other standard. It takes a shunt in
the coil's circuit, a divider across coil and shunt, a mass of 50 g, and a direct current that carries the mass
(hardware/reciprocity.md). calib asks for each of ten runs: no mass, the mass in three orientations, no mass
again, each with shunt and divider at the device's input in turn. Give `calib adjust ratio --write` before.

The first check after the reference came back from calibration is the baseline (--baseline); later ones are
compared with it. The result is kept in the logbook and stated on certificates. It never changes the table of
the reference. Exit code 7 when the reference changed, or differs from its certificate.")]
pub(crate) struct SelfcheckVerb {
    /// The ten runs, measured before in this order: files, or numbers of records in the calibrator. Without them
    /// calib measures.
    #[arg(num_args = RUNS, value_name = "RECORD", conflicts_with_all = ["yes", "moving_mass"])]
    from: Vec<PathBuf>,
    /// Mass, shunt and divider with their uncertainties (TOML); values left out are those of
    /// hardware/reciprocity.md.
    #[arg(long, short, value_name = "FILE")]
    equipment: Option<PathBuf>,
    /// States that no direct current carries the mass: U is larger.
    #[arg(long)]
    not_held: bool,
    /// Moving mass without anything on the table, g: the current is then the same with the mass and without.
    #[arg(long, value_name = "GRAM", default_value_t = 50.0, value_parser = positive::<f64>)]
    moving_mass: f64,
    /// Makes this check the baseline of later ones: the reference has just come back from calibration.
    #[arg(long)]
    baseline: bool,
    /// Asks nobody: something else mounts the mass and switches the inputs before each run.
    #[arg(long)]
    yes: bool,
    /// Operator who checks.
    #[arg(long, value_name = "NAME", default_value = "", env = "CALIB_OPERATOR")]
    operator: String,
    /// Temperature of the calibrator, degrees Celsius.
    #[arg(long, value_name = "CELSIUS", allow_negative_numbers = true, value_parser = finite::<f64>)]
    temperature: Option<f64>,
}

/// The result.
#[derive(Serialize, JsonSchema)]
pub(super) struct Output {
    /// Each frequency.
    points: Vec<CheckPoint>,
    /// Against the baseline, if there is one, and against the certificate.
    changes: Vec<Change>,
    /// The exciter.
    exciter: Identified,
    /// The budget: standard uncertainties at each frequency.
    budget: Vec<Row>,
    /// With what it was found.
    equipment: Equipment,
    /// Warning about the ratio of the channels; none where it is known well enough and anew.
    ratio_remark: Option<String>,
    /// Running numbers of the ten records.
    record_ids: Vec<u32>,
    /// Kept in the logbook.
    kept: bool,
}

impl SelfcheckVerb {
    /// Measures or reads the runs, evaluates, compares, keeps.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let equipment = self.equipment()?;
        let records = match self.from.is_empty() {
            false => self.read(context)?,
            true => self.measure_all(context, &equipment)?,
        };
        let all: Vec<&Record> = records.iter().collect();
        let unusable = |error: calib_metrology::reciprocity::ReciprocityError| {
            Error::input(
                "the check of the reference",
                error.to_string(),
                "nothing was concluded; docs/metrology/reciprocity.md says what each refusal means",
            )
        };
        let runs = Runs::from_records(&all).map_err(|error| unusable(error.into()))?;
        let found = evaluate(&runs, &equipment).map_err(unusable)?;
        self.conclude(context, &records, found)
    }

    fn conclude(&self, context: &Context, records: &[Record], found: Evaluation) -> Result<()> {
        let Some(last) = records.last() else {
            return Ok(());
        };
        let logbook = context.logbook_if_there()?;
        let kept = Found::Reciprocity(Box::new(found.clone()));
        let changes = self_check::changes(logbook.as_ref(), last, &kept)?;
        let ratio_remark = self_check::about_the_ratio(logbook.as_ref(), last, &kept)?;
        if let Some(open) = &ratio_remark {
            context.remark(open);
        }
        if let Some(logbook) = &logbook {
            self_check::keep(logbook, last, &kept, self.baseline)?;
        }
        let output = Output {
            ratio_remark,
            record_ids: records.iter().map(|record| record.head.id).collect(),
            kept: logbook.is_some(),
            points: found.points.clone(),
            budget: found.budget.clone(),
            exciter: found.exciter,
            equipment: found.equipment,
            changes,
        };
        print_result(context, &output, || text(&found, &output))?;
        let changed = output.changes.iter().find(|change| change.significant);
        Error::not_passed(changed.map(|change| format!("the reference {}", change.words())))
    }

    fn equipment(&self) -> Result<Equipment> {
        let stated = self.equipment.as_deref().map(Equipment::read);
        let mut equipment = stated.transpose()?.unwrap_or_default();
        equipment.held &= !self.not_held;
        Ok(equipment)
    }

    fn read(&self, context: &Context) -> Result<Vec<Record>> {
        let read = |path: &PathBuf| {
            let found = source::find(context, path, Path::new("."))?;
            found.calibration().cloned()
        };
        self.from.iter().map(read).collect()
    }

    fn measure_all(&self, context: &Context, equipment: &Equipment) -> Result<Vec<Record>> {
        if !self.yes && !stdin().is_terminal() {
            return Err(Error::usage(
                "the mass is mounted between the runs, and nobody is at the keyboard",
                "measure the ten runs with `calib run`, then `calib selfcheck RECORD ...`; or --yes, where something \
                 else mounts it",
            ));
        }
        let mut client = context.connect()?;
        client.info()?;
        let switch = switch_of_interrupts(context);
        let mut records = Vec::new();
        for (place, step) in STEPS.iter().enumerate() {
            if !self.yes {
                wait_for(place, step, equipment)?;
            }
            let record = self.measure_one(context, &mut client, (step, equipment), &switch)?;
            records.push(record);
        }
        Ok(records)
    }

    fn measure_one(
        &self,
        context: &Context,
        client: &mut Client,
        (step, equipment): (&Step, &Equipment),
        switch: &StopSwitch,
    ) -> Result<Record> {
        let info = client.info()?;
        let points = self.points(step, equipment);
        let asked = Asked {
            points: &points,
            // Small differences of large ratios need all blocks.
            excitation: ExcitationKind::HeldSine,
            stating: Stating::new(SensorKind::default(), info.sample_rate_hz),
        };
        let labels = RunLabels {
            unix_time_s: time::unix_time_s(),
            dut_model: label("model", &format!("check: {}, {}", step.input, step.mass))?,
            operator: label("--operator", &self.operator)?,
            temperature_centi_c: temperature_centi_c("--temperature", self.temperature)?,
            ..RunLabels::default()
        };
        let mut progress = RunProgress::new(context, asked.stating);
        let outcome = measure(context, client, &asked, labels, switch, &mut progress)?;
        progress.end(&outcome.points);
        keep(context, client, &outcome)?;
        judge(&outcome, points.len())?;
        Ok(session::take(client, outcome.record_id)?.0)
    }

    /// The list of a run.
    fn points(&self, step: &Step, equipment: &Equipment) -> Vec<PointSpec> {
        let point = |frequency_hz: f32| {
            let [bare, loaded] = levels(
                f64::from(frequency_hz),
                self.moving_mass / 1000.0,
                equipment.mass_kg,
            );
            PointSpec {
                frequency_hz,
                acceleration_rms_ms2: if step.is_bare() { bare } else { loaded } as f32,
            }
        };
        FREQUENCIES_HZ.into_iter().map(point).collect()
    }
}

fn wait_for(place: usize, step: &Step, equipment: &Equipment) -> Result<()> {
    let left = Error::usage(
        "the operator has left: what was measured is kept",
        "begin again with `calib selfcheck`; a check is ten runs in a row",
    );
    let before = match place {
        0 => {
            "Take the device under test and any payload off, and let the calibrator stand until its temperature does.\n"
        }
        _ => "",
    };
    let current = match (equipment.held, step.is_bare()) {
        (false, _) => "",
        (true, true) => " Direct current: off.",
        (true, false) => " Direct current: on, so that the table is as high as without the mass.",
    };
    let asked = format!(
        "{before}Run {} of {RUNS}. On the table: {}. At the device's input: {}.{current} Then press Enter.",
        place + 1,
        step.mass,
        step.input,
    );
    done_by_hand(&asked, left)
}

fn text(found: &Evaluation, output: &Output) -> String {
    let kept = match output.kept {
        true => "kept in the logbook",
        false => "not kept: there is no logbook",
    };
    format!(
        "{}\n{}\n{kept}",
        report(found),
        change_text(&output.changes)
    )
}
