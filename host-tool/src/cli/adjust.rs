//! `calib adjust`: measures what parts of the instrument differ by, and takes it away.

use super::hand::{Hand, done_by_hand};
use super::number::positive;
use super::{Context, source, time};
use calib_core::channel_ratio::RATIO_FREQUENCIES_HZ;
use calib_core::point::{ExcitationKind, PointSpec};
use calib_host::{Error, Result};
use calib_link::Client;
use calib_link::session::{self, label};
use calib_metrology::channel_ratio::{self, Evaluated, RatioLine};
use calib_protocol::record::{Record, RunLabels};
use clap::{Args, Subcommand};
use schemars::JsonSchema;
use serde::Serialize;
use std::io::{IsTerminal, stdin};
use std::path::{Path, PathBuf};

/// `calib adjust`.
#[derive(Debug, Args)]
pub(crate) struct Adjust {
    #[command(subcommand)]
    what: What,
}

#[derive(Debug, Subcommand)]
enum What {
    /// Measures the ratio of the two channels, with one source at both inputs.
    Ratio(Ratio),
}

/// `calib adjust ratio`.
#[derive(Debug, Args)]
#[command(after_help = "\
Take the amplifier off the drive output and the transducers off the inputs. Lead the drive output
through a divider of 5 to 1 (400 and 100 ohm) to both inputs. calib measures, asks for the two leads
to be exchanged, and measures again: the difference of the leads cancels.

  calib adjust ratio                              measures and prints
  calib adjust ratio --write                      and stores, with a hand on the button
  calib adjust ratio 12 13 --write                evaluates two runs measured before

With a ratio in force every result is divided by it. In the budget its uncertainty replaces the
tolerance of the parts (row 3 of Table A.1).")]
struct Ratio {
    /// Two runs with one source at both inputs, the second with the leads exchanged: files, or numbers of
    /// records in the calibrator. Without them calib measures.
    #[arg(num_args = 2, value_name = "RECORD")]
    records: Vec<PathBuf>,
    /// Point list, .toml or .csv, of at most 16 frequencies; default: 20 Hz to 10 kHz.
    #[arg(long, short, value_name = "FILE", conflicts_with = "records")]
    points: Option<PathBuf>,
    /// Level at the inputs, as acceleration by the reference's table, m/s2 r.m.s.: 50 is 0.72 V peak. The higher
    /// it is, the less the step of the converters counts.
    #[arg(long, short, default_value_t = 50.0, value_name = "MS2", value_parser = positive::<f32>)]
    level: f32,
    /// Stores the ratio in the calibrator.
    #[arg(long)]
    write: bool,
    #[command(flatten)]
    hand: Hand,
}

/// The result.
#[derive(Serialize, JsonSchema)]
pub(super) struct Output {
    /// Each frequency.
    points: Vec<RatioLine>,
    /// Whether the calibrator has stored it.
    stored: bool,
}

impl Adjust {
    /// Measures, prints, and stores if asked to.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let What::Ratio(ratio) = self.what;
        ratio.run(context)
    }
}

impl Ratio {
    fn run(self, context: &Context) -> Result<()> {
        let [straight, exchanged] = match self.records.as_slice() {
            [straight, exchanged] => [read(context, straight)?, read(context, exchanged)?],
            _ => self.measure_both(context)?,
        };
        let evaluated = channel_ratio::evaluate(&straight, &exchanged).map_err(|error| {
            Error::input(
                "the two runs",
                error.to_string(),
                "`calib adjust ratio` guides through both",
            )
        })?;
        if self.write {
            self.store(context, &evaluated)?;
        }
        let output = Output {
            points: evaluated.lines,
            stored: self.write,
        };
        context.print(&output, || channel_ratio::report(&output.points))
    }

    fn measure_both(&self, context: &Context) -> Result<[Box<Record>; 2]> {
        if !stdin().is_terminal() {
            return Err(Error::usage(
                "the leads are exchanged between two runs, and nobody is at the keyboard",
                "measure both with `calib run`, then `calib adjust ratio RECORD RECORD`",
            ));
        }
        let points = match &self.points {
            Some(path) => session::read_points(path, self.level)?,
            None => RATIO_FREQUENCIES_HZ
                .map(|frequency_hz| PointSpec {
                    frequency_hz,
                    acceleration_rms_ms2: self.level,
                })
                .to_vec(),
        };
        let mut client = context.connect()?;
        client.info()?;
        wait_for("one source at both inputs, the power amplifier off the drive output")?;
        let straight = self.measure(context, &mut client, &points)?;
        wait_for("the two leads exchanged")?;
        Ok([straight, self.measure(context, &mut client, &points)?])
    }

    fn measure(
        &self,
        context: &Context,
        client: &mut Client,
        points: &[PointSpec],
    ) -> Result<Box<Record>> {
        let labels = RunLabels {
            unix_time_s: time::unix_time_s(),
            dut_model: label("model", "ratio of the channels")?,
            operator: label("--operator", self.hand.operator())?,
            ..RunLabels::default()
        };
        let stop = super::measure::stop_on_interrupt(context);
        // A ratio better than U of a result needs all blocks.
        let held = ExcitationKind::HeldSine;
        let outcome = session::run_excited(client, points, held, labels, |_| stop())?;
        Ok(Box::new(session::take(client, outcome.record_id)?.0))
    }

    fn store(&self, context: &Context, evaluated: &Evaluated) -> Result<()> {
        let mut client = self.hand.connect(context)?;
        client.info()?;
        let mut settings = client.settings()?;
        settings.channel_ratio = evaluated.ratio.clone();
        self.hand.store(context, &mut client, settings)?;
        context.remark("stored: every result from here on is divided by it");
        Ok(())
    }
}

fn read(context: &Context, path: &Path) -> Result<Box<Record>> {
    let found = source::find(context, path, Path::new("."))?;
    Ok(Box::new(found.calibration()?.clone()))
}

fn wait_for(what: &str) -> Result<()> {
    let left = Error::usage(
        "the operator has left: nothing was changed",
        "call `calib adjust ratio` again",
    );
    done_by_hand(&format!("Connect: {what}. Then press Enter."), left)
}
