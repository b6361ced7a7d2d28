//! `calib sensors`: devices under test, typed once.

use crate::cli::Context;
use calib_host::about_sensor::{self, AboutSensor};
use calib_host::{Error, Result};
use calib_logbook::Sensor;
use calib_metrology::teds;
use calib_metrology::text::Table;
use calib_output::number::shortened;
use clap::{Args, Subcommand};
use std::path::PathBuf;

/// `calib sensors`.
#[derive(Debug, Args)]
pub(crate) struct Sensors {
    #[command(subcommand)]
    what: What,
}

#[derive(Debug, Subcommand)]
enum What {
    /// Lists the sensors of the logbook.
    List {
        /// Only those whose serial number, maker, model or owner holds this.
        #[arg(default_value = "")]
        text: String,
    },
    /// Shows everything about one sensor.
    Show {
        /// Serial number.
        serial: String,
    },
    /// Adds a sensor.
    Add {
        /// Serial number.
        #[arg(long)]
        serial: String,
        #[command(flatten)]
        about: AboutSensor,
    },
    /// Changes what is stated; the rest stays.
    Change {
        /// Serial number.
        serial: String,
        #[command(flatten)]
        about: AboutSensor,
    },
    /// Removes a sensor; its records and certificates stay.
    Remove {
        /// Serial number.
        serial: String,
    },
    /// Adds a sensor from a virtual TEDS (IEEE 1451.4, template 25).
    Import {
        /// The TEDS: its bytes, or hexadecimal digits.
        #[arg(long, value_name = "FILE")]
        teds: PathBuf,
        /// Serial number; default: that of the TEDS.
        #[arg(long)]
        serial: Option<String>,
        #[command(flatten)]
        about: AboutSensor,
    },
}

impl Sensors {
    /// Carries it out.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let logbook = match &self.what {
            What::Add { .. } | What::Import { .. } => context.logbook_to_add_to()?,
            _ => context.logbook()?,
        };
        let sensor = match self.what {
            What::List { text } => {
                let sensors = logbook.sensors(&text)?;
                return context.print(&sensors, || table(&sensors));
            }
            What::Show { serial } => logbook.known_sensor(&serial)?,
            What::Add { serial, about } => {
                let mut sensor = about.onto(about_sensor::of_serial(serial))?;
                sensor.tolerance = sensor.tolerance.or(context.defaults.tolerance.clone());
                logbook.add_sensor(&sensor)?;
                sensor
            }
            What::Change { serial, about } => {
                let sensor = about.onto(logbook.known_sensor(&serial)?)?;
                logbook.put_sensor(&sensor)?;
                sensor
            }
            What::Remove { serial } => logbook.remove_sensor(&serial)?,
            What::Import {
                teds,
                serial,
                about,
            } => {
                let (read, bytes) = teds::read(&teds)?;
                let sensor = about.onto(about_sensor::from_teds(&read, bytes, serial))?;
                logbook.add_sensor(&sensor)?;
                sensor
            }
        };
        context.print(&sensor, || text(&sensor))
    }
}

fn table(sensors: &[Sensor]) -> String {
    let mut table = Table::new(&["serial", "sensor", "sensitivity", "due", "owner"]);
    for sensor in sensors {
        table.row([
            cut(&sensor.serial, 16),
            cut(&sensor.name(), 26),
            sensitivity(sensor).unwrap_or_default(),
            sensor.due_day.clone().unwrap_or_default(),
            cut(sensor.owner.as_deref().unwrap_or_default(), 12),
        ]);
    }
    table.to_string()
}

/// Nominal sensitivity in the unit it is specified in.
fn sensitivity(sensor: &Sensor) -> Option<String> {
    let kind = sensor.kind().unwrap_or_default();
    let value = kind.unit().of_si(sensor.sensitivity?);
    // As it was typed, without the tail that binary numbers have.
    Some(format!("{} {kind}", shortened(value, 9)))
}

/// The first letters, so that a table fits 80 columns.
pub(super) fn cut(text: &str, letters: usize) -> String {
    match text.chars().count() > letters {
        true => text.chars().take(letters - 1).chain(['…']).collect(),
        false => text.to_owned(),
    }
}

fn text(sensor: &Sensor) -> String {
    let stated = |value: &Option<String>| value.clone().unwrap_or_else(|| "not stated".to_owned());
    let iepe = sensor.iepe.map(|iepe| if iepe { "yes" } else { "no" });
    format!(
        "serial number  {}\nsensor         {}\nsensitivity    {}\ntolerance      {}\n\
         range          {}\nresonance      {}\nIEPE           {}\nmounting       {}\n\
         owner          {}\ndue            {}\n",
        sensor.serial,
        sensor.name(),
        stated(&sensitivity(sensor)),
        stated(&sensor.tolerance),
        stated(&sensor.range_ms2.map(|range| format!("{range} m/s2 peak"))),
        stated(&sensor.resonance_hz.map(|hz| format!("{hz} Hz, mounted"))),
        iepe.unwrap_or("not stated"),
        stated(&sensor.mounting),
        stated(&sensor.owner),
        stated(&sensor.due_day),
    )
}

/// The sensor of this serial number, for a run.
///
/// # Errors
/// [`Error::Input`] when there is no logbook, or it has no such sensor.
pub(crate) fn find(context: &Context, serial: &str) -> Result<Sensor> {
    match context.logbook_if_there()? {
        Some(logbook) => Ok(logbook.known_sensor(serial)?),
        None => Err(Error::input(
            format!("sensor {serial}"),
            "there is no logbook yet",
            "`calib sensors add` makes one",
        )),
    }
}
