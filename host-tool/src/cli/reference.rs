//! `calib reference FILE`: the reference's certificate is read, not typed.

use super::Context;
use super::hand::Hand;
use super::number::positive;
use calib_certificate::SensorKind;
use calib_core::settings::ReferenceCalibration;
use calib_host::{Error, Result, terminal};
use calib_metrology::reference::{self, Certified, Compared, Reading};
use calib_record::origin::is_emulated;
use calib_signing::{Certificate, Kind};
use clap::Args;
use jiff::Timestamp;
use jiff::civil::Date;
use schemars::JsonSchema;
use serde::Serialize;
use std::path::PathBuf;

/// `calib reference FILE`.
#[derive(Debug, Args)]
#[command(after_help = "\
FILE is the laboratory's digital calibration certificate (DCC 3.x), or a CSV with frequency, sensitivity
(or deviation), U in percent and coverage factor at each frequency, and phase with its U. calib shows it
beside the calibration in force. Nothing changes without --write and a hand on the button.

Between calibrated frequencies the instrument interpolates over the logarithm of the frequency, with the
larger U of both neighbours. The budget has the error of that, by the curvature of the table. Outside of
the table the instrument measures nothing.")]
pub(crate) struct Reference {
    /// The certificate: DCC or CSV.
    file: PathBuf,
    /// Stores it in the calibrator.
    #[arg(long)]
    write: bool,
    /// Reads and shows it, without a calibrator.
    #[arg(long, conflicts_with = "write")]
    offline: bool,
    /// Takes from a DCC only results whose name holds this, such as `as left`.
    #[arg(long, value_name = "TEXT")]
    result: Option<String>,
    /// Sensitivity that the deviations of a CSV refer to, in the unit of --unit.
    #[arg(long, value_name = "NUMBER", value_parser = positive::<f64>)]
    sensitivity: Option<f64>,
    /// Unit of --sensitivity: mV/(m/s2) or mV/g.
    #[arg(long, value_name = "UNIT", default_value = "mV/(m/s2)", value_parser = of_reference)]
    unit: SensorKind,
    /// Takes a certificate without phase: phases of results then have U = 180 degrees.
    #[arg(long)]
    without_phase: bool,
    /// Serial number, in place of the one in the file.
    #[arg(long, value_name = "TEXT")]
    serial: Option<String>,
    /// Number of the certificate, likewise.
    #[arg(long, value_name = "TEXT")]
    certificate: Option<String>,
    /// Day of the calibration, likewise.
    #[arg(long, value_name = "DAY")]
    calibrated: Option<Date>,
    /// Day the next one is due; a DCC does not say it.
    #[arg(long, value_name = "DAY")]
    due: Option<Date>,
    /// Certificate of the laboratory that signed the DCC, PEM or DER; may be given again.
    #[arg(long, value_name = "FILE")]
    signer: Vec<PathBuf>,
    #[command(flatten)]
    hand: Hand,
}

/// A certificate of the reference beside what is in force.
#[derive(Serialize, JsonSchema)]
pub(super) struct Output {
    /// Statements of the certificate.
    certified: Certified,
    /// Serial number of the reference in force; none without a calibrator.
    in_force_serial: Option<String>,
    /// Its certificate.
    in_force_certificate: Option<String>,
    /// Every frequency beside what is in force there.
    compared: Vec<Compared>,
    /// Frequencies in force that the new table does not reach, Hz.
    lost_hz: Vec<f64>,
    /// Whether the calibrator has stored it.
    stored: bool,
}

/// Unit of a reference, which is an accelerometer with a voltage.
fn of_reference(text: &str) -> Result<SensorKind, String> {
    let kind: SensorKind = text.parse()?;
    let usable = kind.is_as_measured();
    usable
        .then_some(kind)
        .ok_or_else(|| "a reference is stated in mV/(m/s2) or mV/g".to_owned())
}

impl Reference {
    /// Reads, shows, and stores if asked to.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let place = self.file.display().to_string();
        let certified = self.read(context)?;
        let new = certified.calibration(&place, self.without_phase)?;
        for remark in remarks(&new, &certified) {
            context.remark(remark);
        }
        if self.offline {
            let table = reference::compare(&new, &new);
            return print(context, output(certified, None, table, &new));
        }
        let mut client = self.hand.connect(context)?;
        let info = client.info()?;
        if let Some(serial) = certified
            .equipment
            .iter()
            .find(|serial| is_emulated(serial))
            && !is_emulated(&info.serial)
        {
            return Err(Error::input(
                place,
                format!(
                    "was measured by the emulated instrument {serial}: nothing real was calibrated"
                ),
                "take the certificate of a laboratory",
            ));
        }
        let mut settings = client.settings()?;
        let compared = reference::compare(&new, &settings.reference);
        let mut output = output(certified, Some(&settings.reference), compared, &new);
        if self.write {
            settings.reference = new;
            self.hand.store(context, &mut client, settings)?;
            output.stored = true;
            context.remark("stored: every result from here on rests on it");
        }
        print(context, output)
    }

    /// Statements of the file, and of the command line in their place.
    fn read(&self, context: &Context) -> Result<Certified> {
        let reading = Reading {
            result: self.result.clone(),
            sensitivity_v_per_ms2: self
                .sensitivity
                .map(|stated| self.unit.unit().to_si(stated)),
        };
        self.signature(context)?;
        let read = reference::read(&self.file, &reading)?;
        Ok(Certified {
            serial: self.serial.clone().or(read.serial),
            certificate: self.certificate.clone().or(read.certificate),
            calibrated: self.calibrated.or(read.calibrated),
            due: self.due.or(read.due),
            ..read
        })
    }

    /// Refuses what was altered since it was signed, and says by whom it was.
    fn signature(&self, context: &Context) -> Result<()> {
        let bytes =
            std::fs::read(&self.file).map_err(|error| Error::file("read", &self.file, error))?;
        let known = self.signer.iter().map(|path| Certificate::read(path));
        let known: Vec<Certificate> = known.collect::<calib_files::Result<Vec<_>>>()?.concat();
        let refused = |problem: String| {
            let hint =
                "ask the laboratory for the file as it was given out; `calib verify` says more";
            Err(Error::input(self.file.display().to_string(), problem, hint))
        };
        let signed = match Kind::of(&bytes) {
            Some(Kind::Dcc) if Kind::Dcc.is_signed(&bytes) => {
                calib_signing::verify(Kind::Dcc, &bytes)
            }
            Some(Kind::Pdf) => {
                return refused("is a PDF: the DCC is attached inside, or beside it".to_owned());
            }
            _ if known.is_empty() => {
                context
                    .remark("not signed: nothing shows that it is as the laboratory gave it out");
                return Ok(());
            }
            _ => return refused("is not signed".to_owned()),
        };
        match signed {
            Err(problem) => refused(format!("its signature does not hold: {problem}")),
            Ok(signature) if known.is_empty() => {
                let by = signature.by.subject();
                context.remark(&format!(
                    "signed by {by}, whom nobody here knows: name it with --signer"
                ));
                Ok(())
            }
            Ok(signature) if signature.is_of(&known, Timestamp::now()) => Ok(()),
            Ok(signature) => refused(format!(
                "is signed by {}, and not by --signer",
                signature.by.subject()
            )),
        }
    }
}

/// Remarks for a reader before it is stored.
fn remarks(new: &ReferenceCalibration, certified: &Certified) -> Vec<&'static str> {
    let said = [
        (
            new.due_day == 0,
            "no day is stated when the next calibration is due: certificates are not traceable without; --due DAY",
        ),
        (
            certified.traceability.is_none(),
            "it does not say that it is traceable",
        ),
        (
            certified
                .points
                .iter()
                .any(|point| point.phase_rad.is_none()),
            "it has no phase: phases of results have U = 180 degrees",
        ),
    ];
    said.into_iter()
        .filter(|(holds, _)| *holds)
        .map(|(_, words)| words)
        .collect()
}

fn output(
    certified: Certified,
    in_force: Option<&ReferenceCalibration>,
    compared: Vec<Compared>,
    new: &ReferenceCalibration,
) -> Output {
    let old = in_force.map_or(&[][..], |old| &old.points);
    let lost = old.iter().filter(|row| new.at(row.frequency_hz).is_none());
    Output {
        in_force_serial: in_force.map(|old| old.serial.to_string()),
        in_force_certificate: in_force.map(|old| old.certificate.to_string()),
        lost_hz: lost.map(|row| f64::from(row.frequency_hz)).collect(),
        certified,
        compared,
        stored: false,
    }
}

fn print(context: &Context, output: Output) -> Result<()> {
    context.print(&output, || text(&output))
}

fn text(output: &Output) -> String {
    let Certified {
        serial,
        model,
        certificate,
        laboratory,
        calibrated,
        due,
        traceability,
        ..
    } = &output.certified;
    let stated = |words: &Option<String>| words.clone().unwrap_or_else(|| "not stated".to_owned());
    let day =
        |day: &Option<Date>| day.map_or_else(|| "not stated".to_owned(), |day| day.to_string());
    let before = |words: &Option<String>| {
        words
            .as_ref()
            .map(|old| format!(", in force: {old}"))
            .unwrap_or_default()
    };
    let mut text = format!(
        "serial number  {}{}\nmodel          {}\ncertificate    {}{}\nlaboratory     {}\ncalibrated     {}\n\
         due            {}\ntraceability   {}\n\n",
        stated(serial),
        before(&output.in_force_serial),
        stated(model),
        stated(certificate),
        before(&output.in_force_certificate),
        stated(laboratory),
        day(calibrated),
        day(due),
        stated(traceability),
    );
    text.push_str(&terminal::reference(
        &output.compared,
        output.in_force_serial.is_some(),
    ));
    if !output.lost_hz.is_empty() {
        let lost: Vec<String> = output.lost_hz.iter().map(|hz| format!("{hz:.0}")).collect();
        text.push_str(&format!(
            "no longer measured, outside of the new table: {} Hz\n",
            lost.join(", ")
        ));
    }
    text
}
