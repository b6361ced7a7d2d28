//! `calib lists`: the lists a calibrator keeps, for a tap of its button.

use super::Context;
use super::hand::Hand;
use super::number::positive;
use calib_certificate::decision::{RuleName, Tolerance};
use calib_certificate::{SensitivityUnit, SensorKind, Specified};
use calib_core::stored_list::{ListTerms, MAX_LIST_POINTS, Rule, StoredList};
use calib_host::{Error, Result};
use calib_link::Client;
use calib_link::session::{self, label};
use calib_metrology::lists::ListPoint;
use calib_metrology::text::Table;
use calib_output::number::decimal;
use calib_protocol::lists::{KeptList, ListChange};
use clap::{Args, Subcommand, ValueEnum};
use schemars::JsonSchema;
use serde::Serialize;
use std::path::PathBuf;

/// `calib lists`.
#[derive(Debug, Args)]
#[command(after_help = "\
A tap of the button on the instrument measures the chosen list, without a host, and the lamps
say PASS, FAIL or NOT JUDGEABLE (docs/safety.md has the patterns). The record names the list and
carries its limits. The lamps judge by the list, so each change waits for a hand on the
button.")]
pub(crate) struct Lists {
    #[command(subcommand)]
    what: What,
}

#[derive(Debug, Subcommand)]
enum What {
    /// Shows the lists the calibrator keeps, the chosen one marked.
    Show,
    /// Stores a list, in place of the one of its name.
    Store(Box<Store>),
    /// Removes a list.
    Remove {
        /// Its name.
        name: String,
        #[command(flatten)]
        hand: Hand,
    },
    /// Chooses the list that a tap of the button measures.
    Choose {
        /// Its name.
        #[arg(required_unless_present = "none")]
        name: Option<String>,
        /// Chooses none: a tap measures the default list, and nothing is judged.
        #[arg(long, conflicts_with = "name")]
        none: bool,
        #[command(flatten)]
        hand: Hand,
    },
}

/// `calib lists store`.
#[derive(Debug, Args)]
struct Store {
    /// Point list, .toml or .csv, as of `calib run --points`.
    points: PathBuf,
    /// Its name, up to 24 letters [default: that of the file].
    #[arg(long)]
    name: Option<String>,
    /// Set acceleration of points that state none, m/s2 r.m.s.
    #[arg(long, default_value_t = 10.0, value_name = "MS2", value_parser = positive::<f32>)]
    level: f32,
    /// Sensor of the logbook whose nominal sensitivity, unit and tolerance are taken where none is stated.
    #[arg(long, value_name = "SERIAL")]
    sensor: Option<String>,
    /// Nominal sensitivity, in the unit of --unit.
    #[arg(long, value_name = "NUMBER", value_parser = positive::<f64>)]
    sensitivity: Option<f64>,
    /// Unit the sensitivity is specified in, as of `calib sensors add`; of a sensor to acceleration [default: mV/(m/s2)].
    #[arg(long, value_name = "UNIT")]
    unit: Option<SensorKind>,
    /// Tolerance, as of `calib sensors add`: percent of nominal, such as 5; of the reference point, such as
    /// 10:reference:20-5000; several after commas; or api670.
    #[arg(long, value_name = "TOLERANCE", allow_hyphen_values = true)]
    tolerance: Option<Tolerance>,
    /// Decision rule.
    #[arg(long, value_enum, default_value_t = RuleOption::GuardBand)]
    rule: RuleOption,
    #[command(flatten)]
    hand: Hand,
}

/// The rules an instrument judges by.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum RuleOption {
    /// PASS inside the tolerance.
    Simple,
    /// PASS inside the tolerance less U.
    GuardBand,
}

/// A list the calibrator keeps.
#[derive(Serialize, JsonSchema)]
pub(super) struct ListView {
    name: String,
    /// A tap of the button measures it.
    chosen: bool,
    /// Points in the order they are measured.
    points: Vec<ListPoint>,
    /// Nominal sensitivity, V/(m/s2).
    nominal_sensitivity_v_per_ms2: Option<f64>,
    /// Unit it is specified in.
    unit: String,
    /// Tolerance, as `--tolerance` takes it.
    tolerance: String,
    /// Decision rule: `simple` or `guard_band`.
    rule: &'static str,
}

impl Lists {
    /// Changes what is asked for, and prints the lists there are.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let (change, hand) = match self.what {
            What::Show => {
                let mut client = context.connect()?;
                client.info()?;
                return show(context, &mut client);
            }
            What::Store(store) => (ListChange::Store(store.list(context)?), store.hand),
            What::Remove { name, hand } => (
                ListChange::Remove {
                    name: named("name", &name)?,
                },
                hand,
            ),
            What::Choose { name, hand, .. } => {
                let name = named("name", &name.unwrap_or_default())?;
                (ListChange::Choose { name }, hand)
            }
        };
        let mut client = hand.connect(context)?;
        client.info()?;
        hand.wait_for(context, &mut client, |client| client.change_lists(&change))?;
        show(context, &mut client)
    }
}

fn named(option: &'static str, name: &str) -> Result<heapless::String<24>> {
    Ok(label(option, name)?)
}

fn show(context: &Context, client: &mut Client) -> Result<()> {
    let lists: Vec<ListView> = client.lists()?.iter().map(ListView::from).collect();
    context.print(&lists, || table(&lists))
}

impl Store {
    /// The list as it is to be kept; what an instrument cannot judge by is refused before it is asked.
    fn list(&self, context: &Context) -> Result<StoredList> {
        let points = session::read_points(&self.points, self.level)?;
        let points = heapless::Vec::from_slice(&points).map_err(|_| {
            Error::input(
                self.points.display().to_string(),
                format!(
                    "holds {} points, a list on the instrument {MAX_LIST_POINTS} at most",
                    points.len()
                ),
                "split the list",
            )
        })?;
        let file_name = self.points.file_stem().unwrap_or_default();
        let file_name = file_name.to_string_lossy();
        let name = self.name.as_deref().unwrap_or(&file_name);
        Ok(StoredList {
            terms: ListTerms {
                name: named("--name", name)?,
                ..self.terms(context)?
            },
            points,
        })
    }

    fn terms(&self, context: &Context) -> Result<ListTerms> {
        let sensor = match &self.sensor {
            Some(serial) => context.logbook()?.known_sensor(serial)?,
            None => calib_logbook::Sensor::default(),
        };
        let kind = self.unit.unwrap_or(sensor.kind()?);
        let stated = self.sensitivity.map(|value| kind.unit().to_si(value));
        let nominal = stated.or(sensor.sensitivity);
        let nominal = nominal.map(|si| Specified::of_si(si, kind.unit()));
        let of_sensor = sensor.tolerance.as_deref().map(str::parse).transpose();
        let unusable =
            |problem: String| Error::usage(problem, "`calib lists store --help` shows tolerances");
        let tolerance = self.tolerance.clone().or(of_sensor.map_err(unusable)?);
        let tolerance = tolerance.ok_or_else(|| {
            Error::usage(
                "a list is judged by a tolerance, and none is stated",
                "state it with --tolerance, or name a --sensor of the logbook that has one",
            )
        })?;
        let rule = match self.rule {
            RuleOption::Simple => RuleName::Simple,
            RuleOption::GuardBand => RuleName::GuardBand,
        };
        let terms = tolerance.request(rule, nominal).terms(kind);
        let hint = "state --sensitivity and --unit with a tolerance of nominal; a tolerance of the last \
                    calibration is judged on the host alone";
        Ok(ListTerms {
            // What the instrument measures of others are volts per m/s2.
            unit: label("--unit", shown(kind).name())?,
            ..terms.map_err(|problem| Error::usage(problem, hint))?
        })
    }
}

fn shown(kind: SensorKind) -> SensitivityUnit {
    match kind.is_as_measured() {
        true => kind.unit(),
        false => SensitivityUnit::default(),
    }
}

impl From<&KeptList> for ListView {
    fn from(kept: &KeptList) -> Self {
        let StoredList { terms, points } = &kept.list;
        let nominal = Some(terms.nominal_v_per_ms2).filter(|nominal| *nominal > 0.0);
        let point = |point: &calib_core::point::PointSpec| ListPoint {
            frequency_hz: decimal(point.frequency_hz),
            acceleration_rms_ms2: decimal(point.acceleration_rms_ms2),
        };
        Self {
            name: terms.name.as_str().to_owned(),
            chosen: kept.chosen,
            points: points.iter().map(point).collect(),
            nominal_sensitivity_v_per_ms2: nominal.map(decimal),
            unit: terms.unit.as_str().to_owned(),
            tolerance: Tolerance::of_terms(terms).to_string(),
            rule: match terms.rule {
                Rule::Simple => "simple",
                Rule::GuardBand => "guard_band",
            },
        }
    }
}

fn table(lists: &[ListView]) -> String {
    if lists.is_empty() {
        return "no list is kept: a tap of the button measures the default list\n".to_owned();
    }
    let mut table = Table::new(&["tap", "list", "points", "nominal", "tolerance", "rule"]);
    for list in lists {
        let unit = list.unit.parse::<SensitivityUnit>().unwrap_or_default();
        let nominal = list.nominal_sensitivity_v_per_ms2;
        let nominal = nominal.map(|v| format!("{:.5} {}", unit.of_si(v), unit.name()));
        table.row([
            if list.chosen { "->" } else { "" }.to_owned(),
            list.name.clone(),
            list.points.len().to_string(),
            nominal.unwrap_or_else(|| "-".to_owned()),
            list.tolerance.clone(),
            list.rule.to_owned(),
        ]);
    }
    table.to_string()
}
