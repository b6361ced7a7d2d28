//! The verbs: each with what it does and two lines that use it, in groups by what they are for.

use super::{
    Context, adjust, budget, capture, certificate, check, completions, config, convert, demo,
    devices, doctor, download, emulate, gap, identify, info, key, linking, lists, logbook,
    nomogram, phase, points, predict, records, reference, release, risk, run, schema, selfcheck,
    selftest, sensitivity, serve, settings, show, sign, stop, sync, turnover, update, verify,
    version,
};
use calib_host::Result;
use clap::Subcommand;

/// The enum of verbs and the table of their examples, from one list. A verb begins its first example.
macro_rules! verbs {
    ($($group:literal {
        $($(#[$about:meta])* $verb:ident($arguments:ty) $examples:tt;)+
    })+) => {
        /// The verbs.
        #[derive(Debug, Subcommand)]
        pub(crate) enum Command {
            $($($(#[$about])* $verb($arguments),)+)+
            /// Writes the JSON Schemas of all outputs.
            #[command(hide = true)]
            Schema(schema::SchemaVerb),
        }

        impl Command {
            /// Carries the verb out.
            pub(crate) fn run(self, context: &Context) -> Result<()> {
                match self {
                    $($(Self::$verb(verb) => verb.run(context),)+)+
                    Self::Schema(verb) => verb.run(context),
                }
            }
        }

        /// Verbs by what they are for, each group in the order of its work: two lines that use each,
        /// without the `calib` before.
        pub(super) const GROUPS: &[(&str, &[[&str; 2]])] = &[$(($group, &[$($examples),+])),+];
    };
}

verbs! {
    "Measure" {
        /// Runs a whole calibration on an emulated calibrator.
        Demo(demo::Demo) ["demo", "demo --seed 3 --out another"];
        /// Measures a point list.
        Run(run::Run) ["run --sensor LW12345 --operator N.", "run --sensor LW12345 --remount 3"];
        /// Serves a local web page to start, watch and stop calibrations.
        Serve(serve::Serve) ["serve", "serve --listen 0.0.0.0:8160 --laboratory laboratory.toml"];
        /// Captures waveforms of both channels: d.c., harmonics, noise, spectrum.
        Capture(capture::CaptureVerb) ["capture", "capture --frequency 160 --level 10 --csv tone.csv"];
        /// Stops a run and silences the exciter.
        Stop(stop::Stop) ["stop", "--device /dev/ttyACM0 stop"];
        /// Writes lists of points by ISO 16063-21 clause 5.
        Points(points::Points) ["points preferred --from 10 --to 1000", "points linearity --frequency 80"];
        /// Lists the records stored in the calibrator.
        Records(records::Records) ["records", "records --json"];
        /// Downloads a stored record into a file.
        Download(download::Download) ["download 12", "download --all --out records"];
        /// Lets downloaded records make room for new ones.
        Release(release::Release) ["release 12", "release 12 --json"];
    }
    "Results and certificates" {
        /// Draws a record in the terminal: S over f with U.
        Show(show::Show) ["show 12", "show record-00012.calibrec --unit mV/g"];
        /// Says what the signature of a record or a certificate proves.
        Verify(verify::Verify) [
            "verify record-00012.calibrec",
            "verify certificate-17.pdf certificate-17.dcc.xml --certificate laboratory.pem"
        ];
        /// Signs certificates with the laboratory's key.
        Sign(sign::Sign) [
            "sign certificate-17.pdf certificate-17.dcc.xml --key laboratory.p12",
            "sign certificate-17.pdf --key laboratory.p12 --password-file password"
        ];
        /// Writes the certificate of a record.
        Certificate(certificate::CertificateVerb) [
            "certificate 12 --particulars job.toml",
            "certificate --amend 17 --reason \"name of the customer\" --customer \"B. Ltd\""
        ];
        /// Judges a record by Tables 1 to 6 and clause 7 of ISO 16063-21.
        Check(check::Check) ["check record-00012.calibrec", "check record-00012.calibrec --example 2"];
    }
    "Logbook" {
        /// Lists, adds and changes sensors of the logbook.
        Sensors(logbook::Sensors) [
            "sensors add --serial LW12345 --sensitivity 100 --unit mV/g --tolerance 5",
            "sensors list"
        ];
        /// Shows the drift of a sensor over the years, with U.
        History(logbook::History) ["history LW12345", "history LW12345 --frequency 1000"];
        /// Judges a check standard by its own results, before a job.
        Assure(logbook::Assure) ["assure CHECK-1", "assure CHECK-1 --certified 10.02 --certified-u 0.5"];
        /// Checks the reference on site by reciprocity: a mass and two voltages.
        Selfcheck(selfcheck::SelfcheckVerb) [
            "selfcheck --baseline --operator N.",
            "selfcheck 12 13 14 15 16 17 18 19 20 21 --equipment mass.toml"
        ];
        /// Checks a reference that responds to d.c. by turning it over in gravity.
        Turnover(turnover::Turnover) [
            "turnover readings.toml 12 --baseline",
            "turnover readings.toml record-00012.calibrec --json"
        ];
        /// Fetches records the logbook lacks from every connected calibrator.
        Sync(sync::Sync) ["sync", "sync --device /dev/ttyACM0"];
        /// Keeps records, certificates, instruments and operators, and checks them.
        Logbook(logbook::LogbookVerb) ["logbook records", "logbook check --certificate laboratory.pem"];
        /// Exports the logbook for other programs.
        Export(logbook::Export) ["export --parquet data", "export --lake fleet --laboratory-name Lab"];
    }
    "Metrology" {
        /// Evaluates an uncertainty budget (ISO 16063-21 Annex A, GUM).
        Budget(budget::BudgetVerb) ["budget --template a1", "budget budget.toml --monte-carlo"];
        /// Computes sensitivity from readings: comparison, consecutive, calibrator (clause 6).
        Sensitivity(sensitivity::Sensitivity) [
            "sensitivity readings.csv",
            "sensitivity readings.csv --quantity velocity"
        ];
        /// Computes phase by comparison, with the uncertainty of ISO 5347-9.
        Phase(phase::Phase) ["phase readings.toml", "phase readings.toml --json"];
        /// Identifies the model of an accelerometer (ISO 16063-43).
        Identify(identify::Identify) ["identify points.csv", "identify --shock record.csv --from-hz 100"];
        /// Predicts the output for a record, or the input behind it.
        Predict(predict::Predict) [
            "predict record.csv --model model.json",
            "predict output.csv --model model.json --inverse"
        ];
        /// Links comparisons, judges degrees of equivalence.
        Linking(linking::Linking) ["linking comparisons.toml --pairs", "linking --doe degrees.csv"];
        /// Computes risks of decision rules over many sensors (JCGM 106:2012, clause 9).
        Risk(risk::Risk) ["risk --ratio 4", "risk --ratio 2 --in-tolerance 90"];
        /// Converts a sensitivity to acceleration, velocity or displacement (clause 6).
        Convert(convert::Convert) [
            "convert --frequency 160 --sensitivity 0.01",
            "convert --frequency 80 --sensitivity 0.004 --from velocity"
        ];
        /// Converts between acceleration, velocity and displacement (Annex C).
        Nomogram(nomogram::Nomogram) [
            "nomogram --frequency 160 --acceleration 10",
            "nomogram --frequency 20 --displacement 0.001 --as peak"
        ];
    }
    "Gap between simulation and reality" {
        /// Diagnoses the gap between simulation and measurement.
        Gap(gap::Gap) ["gap diagnose dataset --report gap.html", "gap effects mount_resonance"];
    }
    "Instrument and service" {
        /// Lists serial ports, the likely calibrators first.
        Devices(devices::Devices) ["devices", "devices --json"];
        /// Shows or sets this user's defaults: device, level, operator ...
        Config(config::ConfigVerb) ["config operator \"N. N.\"", "config --unset level"];
        /// Finds what keeps this computer from talking to a calibrator.
        Doctor(doctor::Doctor) ["doctor", "--device /dev/ttyACM0 doctor"];
        /// Shows identity and health of the calibrator.
        Info(info::Info) ["info", "--device tcp:192.0.2.7:5025 info"];
        /// Tests the board, with the table at rest: each line with its limits.
        Selftest(selftest::SelfTest) ["selftest", "--device emulated selftest"];
        /// Prints or replaces the calibrator's settings.
        Settings(settings::Settings) ["settings", "settings --write settings.toml --operator N."];
        /// Reads the certificate of the reference, shows it beside the one in force, and stores it.
        Reference(reference::Reference) [
            "reference K-2026-17.dcc.xml --due 2028-05-04",
            "reference table.csv --write --operator N."
        ];
        /// Measures by how much the channels differ, and corrects for it.
        Adjust(adjust::Adjust) ["adjust ratio", "adjust ratio --write --operator N."];
        /// Shows or makes the key with which the calibrator signs its records.
        Key(key::Key) ["key", "key --make"];
        /// Shows or changes the lists the calibrator keeps for a tap of its button.
        Lists(lists::Lists) [
            "lists store pump.csv --sensitivity 100 --unit mV/g --tolerance 5",
            "lists choose pump"
        ];
        /// Installs other firmware: sends it to the calibrator, tries it, confirms it.
        Update(update::Update) ["update calib-0.1.0-nucleo-h743zi2.update", "update older.update --wait 60"];
        /// Runs an emulated calibrator that other programs use like hardware.
        Emulate(emulate::Emulate) ["emulate", "emulate --pty --flash flash.bin"];
        /// Prints the completion script of a shell.
        Completions(completions::Completions) ["completions bash", "completions fish"];
        /// Writes the man pages.
        Man(completions::Man) ["man", "man --out pages"];
        /// Prints versions of the tool, the protocol and the stored records.
        Version(version::Version) ["version", "version --json"];
    }
}
