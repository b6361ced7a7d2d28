//! `calib gap effects`: the library.

use super::super::Context;
use super::misuse::refused;
use calib_gap::{About, NEVER_IDENTIFIABLE, check_name, effects};
use calib_host::Result;
use calib_twin::effects::oscillator::OSCILLATOR_EFFECTS;
use calib_twin::effects::{self as twin, Effect};
use clap::Args;
use serde::Serialize;
use std::fmt::Write;

/// `calib gap effects`.
#[derive(Debug, Args)]
pub(crate) struct Effects {
    /// One effect; without it all are listed.
    name: Option<String>,
}

#[derive(Serialize)]
struct Parameter {
    name: &'static str,
    unit: &'static str,
    lower: f64,
    upper: f64,
}

/// What is said of an effect; for every effect the same fields.
#[derive(Serialize)]
struct Entry {
    id: &'static str,
    /// Of what it is an effect: `calibrator` or `oscillator`.
    of: &'static str,
    stage: &'static str,
    formula: &'static str,
    parameters: Vec<Parameter>,
    columns: Vec<&'static str>,
    confused_with: Vec<&'static str>,
    separate_by: &'static str,
    /// False for constant gains, which no data with one unknown gain can name.
    identifiable: bool,
}

impl Effects {
    /// Prints the list, or one description.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let wanted = |entry: &Entry| self.name.as_deref().is_none_or(|name| name == entry.id);
        let list: Vec<Entry> = all().into_iter().filter(wanted).collect();
        if let (Some(name), []) = (&self.name, list.as_slice()) {
            check_name(name).map_err(refused)?;
        }
        let one = self.name.is_some();
        context.print(&list, || {
            let mut text = String::new();
            for entry in &list {
                let (id, stage) = (entry.id, entry.stage);
                let _ = writeln!(text, "{id:<24} {stage:<13} {}", entry.formula);
                if one {
                    describe(&mut text, entry);
                }
            }
            text.trim_end().to_owned()
        })
    }
}

fn all() -> Vec<Entry> {
    let known = effects().into_iter().map(of_calibrator);
    known
        .chain(NEVER_IDENTIFIABLE.map(|(id, stage, formula)| never(id, stage.name(), formula)))
        .chain(OSCILLATOR_EFFECTS.iter().map(of_oscillator))
        .collect()
}

fn of_calibrator(about: &About) -> Entry {
    let parameter = |p: &calib_gap::Parameter| Parameter {
        name: p.name,
        unit: p.unit,
        lower: p.lower,
        upper: p.upper,
    };
    Entry {
        id: about.id,
        of: "calibrator",
        stage: about.stage.name(),
        formula: about.formula,
        parameters: merged(about, about.parameters.iter().map(parameter).collect()),
        columns: about.columns.to_vec(),
        confused_with: about.confused_with.to_vec(),
        separate_by: about.separate_by,
        identifiable: true,
    }
}

/// An effect with variants names the parameters of one; a simulation takes all of them.
fn merged(about: &About, mut known: Vec<Parameter>) -> Vec<Parameter> {
    let simulated = Effect::<twin::CalibratorAction>::named(about.id);
    for parameter in simulated.map_or(Vec::new(), |effect| parameters(effect.parameters)) {
        if !known.iter().any(|p| p.name == parameter.name) {
            known.push(parameter);
        }
    }
    known
}

fn never(id: &'static str, stage: &'static str, formula: &'static str) -> Entry {
    let found = Effect::<twin::CalibratorAction>::named(id);
    Entry {
        id,
        of: "calibrator",
        stage,
        formula,
        parameters: found.map_or(Vec::new(), |effect| parameters(effect.parameters)),
        columns: vec!["ratio"],
        confused_with: NEVER_IDENTIFIABLE
            .iter()
            .map(|other| other.0)
            .filter(|other| *other != id)
            .collect(),
        separate_by: "compare with a second reference",
        identifiable: false,
    }
}

fn of_oscillator(effect: &'static Effect<twin::oscillator::OscillatorAction>) -> Entry {
    let (confused_with, separate_by) = oscillator_confusions(effect.id);
    Entry {
        id: effect.id,
        of: "oscillator",
        stage: "oscillator",
        formula: effect.formula,
        parameters: parameters(effect.parameters),
        columns: vec!["input", "output"],
        confused_with: confused_with.to_vec(),
        separate_by,
        identifiable: true,
    }
}

/// Terms of like parity and like force: conservative ones move the resonance
/// with level, dissipative ones its height.
fn oscillator_confusions(id: &str) -> (&'static [&'static str], &'static str) {
    let grow = "a record whose level grows from nothing to full scale";
    match id {
        "cubic_stiffness" => (&["dead_zone", "hysteresis", "input_saturation"], grow),
        "dead_zone" => (&["cubic_stiffness", "coulomb_friction"], grow),
        "quadratic_stiffness" => (
            &["output_highpass"],
            "records with positive and negative offset",
        ),
        "coulomb_friction" => (&["quadratic_damping", "hysteresis", "dead_zone"], grow),
        "quadratic_damping" => (&["coulomb_friction", "cubic_damping"], grow),
        "cubic_damping" => (&["quadratic_damping", "input_saturation"], grow),
        "hysteresis" => (
            &["coulomb_friction", "cubic_stiffness"],
            "very slow cycles at full level",
        ),
        "input_saturation" => (
            &["cubic_stiffness", "cubic_damping"],
            "the same level far from resonance",
        ),
        "input_delay" => (
            &["second_mode", "output_highpass"],
            "a record up to three times the resonance",
        ),
        "output_highpass" => (
            &["quadratic_stiffness", "input_delay"],
            "a record far below the resonance",
        ),
        "second_mode" => (&["input_delay"], "a record up to three times the resonance"),
        _ => (&[], grow),
    }
}

fn parameters(list: &'static [twin::Parameter]) -> Vec<Parameter> {
    let parameter = |p: &twin::Parameter| Parameter {
        name: p.name,
        unit: p.unit,
        lower: p.bounds[0],
        upper: p.bounds[1],
    };
    list.iter().map(parameter).collect()
}

fn describe(text: &mut String, entry: &Entry) {
    for p in &entry.parameters {
        let (name, unit) = (p.name, p.unit);
        let _ = writeln!(
            text,
            "  {name:<26} {unit:<10} {:e} .. {:e}",
            p.lower, p.upper
        );
    }
    let list = |names: &[&str]| match names {
        [] => "nothing".to_owned(),
        some => some.join(", "),
    };
    let _ = writeln!(text, "  shows in       {}", list(&entry.columns));
    let _ = writeln!(text, "  confused with  {}", list(&entry.confused_with));
    let _ = writeln!(text, "  told apart by  {}", entry.separate_by);
    if !entry.identifiable {
        let _ = writeln!(
            text,
            "  never named    it is the measurand, or shared with it"
        );
    }
}
