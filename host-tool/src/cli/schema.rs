//! `calib schema DIR`: the JSON Schemas of all outputs, as they lie in docs/schema.

use super::context::Failure;
use super::progress::RunEvent;
use super::{
    Context, adjust, capture, certificate, completions, config, convert, download, emulate, gap,
    logbook,
};
use super::{
    identify, key, linking, lists, phase, predict, reference, release, risk, run, selfcheck,
    sensitivity, serve, sign, stop, sync, turnover, update, verify, version,
};
use calib_certificate::Document;
use calib_core::settings::Settings;
use calib_effects::Entry;
use calib_files::file;
use calib_gap::{Answer, Plan};
use calib_gap_challenge::{Sealed, score::Score};
use calib_host::Result;
use calib_host::assurance::AssuranceReport;
use calib_host::demo::DemoReport;
use calib_host::doctor::Finding;
use calib_host::gap::simulated::Simulated;
use calib_host::serve::Snapshot;
use calib_link::port::Port;
use calib_logbook::{History, Instrument, Issued, Listed, Operator, Sensor};
use calib_metrology::budget::Template;
use calib_metrology::check::Check;
use calib_metrology::evaluated::EvaluationView;
use calib_metrology::lists::ListPoint;
use calib_metrology::nomogram::Vibration;
use calib_metrology::shock::ShockIdentification;
use calib_output::{ChangeView, InfoView, RecordView, SelfTestView};
use clap::Args;
use schemars::generate::SchemaSettings;
use schemars::{JsonSchema, Schema};
use serde::Serialize;
use std::path::PathBuf;

/// `calib schema DIR`.
#[derive(Debug, Args)]
pub(crate) struct SchemaVerb {
    /// Directory for the files.
    directory: PathBuf,
}

#[derive(Serialize, JsonSchema)]
struct Written {
    /// One file per output.
    files: Vec<PathBuf>,
}

impl SchemaVerb {
    /// Writes one file per verb, named after it, and those of the page.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let mut files = Vec::new();
        for (name, schema) in all() {
            let path = self.directory.join(format!("{name}.json"));
            let text = calib_output::json::document(&schema).map_err(super::context::defect)?;
            file::replace(&path, text.as_bytes())?;
            files.push(path);
        }
        context.print(&Written { files }, || self.directory.display().to_string())
    }
}

/// A document of one of two forms.
#[derive(Serialize, JsonSchema)]
#[serde(untagged)]
#[expect(dead_code, reason = "stands for the schemas of both")]
enum Either<A, B> {
    One(A),
    Other(B),
}

fn of<T: JsonSchema>(name: &'static str) -> (&'static str, Schema) {
    let generator = SchemaSettings::draft2020_12()
        .for_serialize()
        .into_generator();
    (name, generator.into_root_schema_for::<T>())
}

/// Every output: what a verb prints with `--json`, under its name; `-lines` where a line
/// of `--json-lines` is no row of that; `page-` what the page is given.
fn all() -> Vec<(&'static str, Schema)> {
    vec![
        of::<adjust::Output>("adjust-ratio"),
        of::<Either<logbook::Assurance, AssuranceReport>>("assure"),
        of::<Either<EvaluationView, Template>>("budget"),
        of::<capture::Output<'_>>("capture"),
        of::<certificate::Written>("certificate"),
        of::<Document>("certificate-file"),
        of::<Check>("check"),
        of::<completions::Script>("completions"),
        of::<config::ConfigView>("config"),
        of::<convert::Output>("convert"),
        of::<DemoReport>("demo"),
        of::<RunEvent<'_, DemoReport>>("demo-lines"),
        of::<Vec<Port>>("devices"),
        of::<Vec<Finding>>("doctor"),
        of::<Either<download::Downloaded, Vec<download::Downloaded>>>("download"),
        of::<emulate::Listening>("emulate"),
        of::<Failure>("error"),
        of::<logbook::Exported>("export"),
        of::<Sealed>("gap-challenge"),
        of::<Either<Answer, Vec<gap::Said>>>("gap-diagnose"),
        of::<Vec<Entry>>("gap-effects"),
        of::<Plan>("gap-plan"),
        of::<gap::Written>("gap-record"),
        of::<Score>("gap-score"),
        of::<Simulated>("gap-simulate"),
        of::<History>("history"),
        of::<Either<identify::Output, ShockIdentification>>("identify"),
        of::<InfoView>("info"),
        of::<key::KeyView>("key"),
        of::<Either<linking::Output, linking::DoeOutput>>("linking"),
        of::<Vec<lists::ListView>>("lists"),
        of::<Vec<logbook::Added>>("logbook-add"),
        of::<Vec<Issued>>("logbook-certificates"),
        of::<Vec<logbook::Problem>>("logbook-check"),
        of::<calib_logbook::Seal>("logbook-sign"),
        of::<logbook::Backup>("logbook-backup"),
        of::<calib_logbook::Merged>("logbook-merge"),
        of::<logbook::Written>("logbook-get"),
        of::<Vec<Instrument>>("logbook-instruments"),
        of::<Vec<Operator>>("logbook-operators"),
        of::<Vec<Listed>>("logbook-records"),
        of::<completions::Pages>("man"),
        of::<Vibration>("nomogram"),
        of::<Snapshot>("page-state"),
        of::<calib_host::serve::Waveforms>("page-waveforms"),
        of::<phase::Output>("phase"),
        of::<Vec<ListPoint>>("points"),
        of::<predict::Output>("predict"),
        of::<Vec<RecordView>>("records"),
        of::<reference::Output>("reference"),
        of::<release::Released>("release"),
        of::<Vec<risk::Row>>("risk"),
        of::<run::RunResult>("run"),
        of::<RunEvent<'_, run::RunResult>>("run-lines"),
        of::<Written>("schema"),
        of::<selfcheck::Output>("selfcheck"),
        of::<turnover::Output>("turnover"),
        of::<RunEvent<'_, selfcheck::Output>>("selfcheck-lines"),
        of::<SelfTestView>("selftest"),
        of::<sensitivity::Output>("sensitivity"),
        of::<Either<Vec<Sensor>, Sensor>>("sensors"),
        of::<serve::Listening>("serve"),
        of::<Settings>("settings"),
        of::<Either<Document, ChangeView>>("show"),
        of::<stop::Stopped>("stop"),
        of::<Vec<sync::Synced>>("sync"),
        of::<update::UpdateView>("update"),
        of::<Vec<verify::Verified>>("verify"),
        of::<sign::Signed>("sign"),
        of::<version::Versions>("version"),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::Arguments;
    use clap::{Command, CommandFactory};
    use serde_json::Value;

    fn verbs(command: &Command, before: &str, found: &mut Vec<String>) {
        for verb in command.get_subcommands() {
            let name = format!("{before}{}", verb.get_name());
            match verb.has_subcommands() {
                true => verbs(verb, &format!("{name}-"), found),
                false => found.push(name),
            }
        }
    }

    #[test]
    fn every_verb_has_a_schema() {
        let mut found = Vec::new();
        verbs(&Arguments::command(), "", &mut found);
        // Both lists, and all verbs about sensors and kept lists, print one form.
        let one_form = |name: &str| match name.split_once('-') {
            Some((verb @ ("points" | "sensors" | "lists"), _)) => verb.to_owned(),
            _ => name.to_owned(),
        };
        let known: Vec<_> = all().into_iter().map(|(name, _)| name).collect();
        for verb in found.iter().map(|verb| one_form(verb)) {
            assert!(known.contains(&verb.as_str()), "{verb}");
        }
    }

    /// Every key of a schema.
    fn keys(schema: &Value, found: &mut Vec<String>) {
        match schema {
            Value::Object(members) => {
                if let Some(Value::Object(named)) = members.get("properties") {
                    found.extend(named.keys().cloned());
                }
                members.values().for_each(|member| keys(member, found));
            }
            Value::Array(items) => items.iter().for_each(|item| keys(item, found)),
            _ => {}
        }
    }

    #[test]
    fn no_key_states_percent_or_radians_or_another_unit_than_si() {
        let unwanted = [
            "_percent",
            "_rad",
            "_ms",
            "_mv",
            "acceleration_ms2",
            "verdict",
            "u_",
        ];
        for (name, schema) in all() {
            let mut found = Vec::new();
            keys(schema.as_value(), &mut found);
            assert!(!found.is_empty(), "{name} has no keys");
            found.retain(|key| match key.as_str() {
                // The settings are those of the settings file; velocity is in m/s.
                "phase_rad" | "expanded_uncertainty_phase_rad" | "value_phase_rad" => {
                    !["settings", "show", "logbook-instruments"].contains(&name)
                }
                "velocity_ms" | "velocity_peak_ms" => false,
                // It has `rms` and `peak` below.
                "acceleration_ms2" => name != "nomogram",
                // That of a diagnosis; a point has a state, and a sensor a conformity.
                "verdict" => !name.starts_with("gap"),
                key => unwanted
                    .iter()
                    .any(|end| key.ends_with(end) || key.starts_with(end)),
            });
            assert_eq!(found, [""; 0], "{name}");
        }
    }
}
