//! The budget file: TOML a person writes by hand.

mod component;
mod correlations;

use super::{Budget, Component, CoverageRule, Model, Unit};
use crate::input::{self, Number, Source, Text};
use calib_files::Result;
use component::{ComponentTable, check_label, component};
use correlations::{CorrelationTable, correlations};
use serde::Deserialize;
use std::path::{Path, PathBuf};
use toml::Spanned;

/// Remedy of everything the TOML reader itself refuses.
const KEYS: &str = "known keys: measurand, unit, model, coverage_factor or \
coverage_probability, degrees_of_freedom_rounding, [[component]] with label, value, \
distribution, k, divisor, shape, sensitivity_coefficient, degrees_of_freedom, budget, \
and [[correlation]] with a, b, r; see docs/metrology/budget.md";

/// From that of k = 1 on; 1 itself would be an infinite one.
const COVERAGE_PROBABILITIES: std::ops::Range<f64> = 0.68..1.0;

/// Budgets inside budgets: Note 1 of Table A.1 needs one, a chain a few more.
const MAX_STAGES: usize = 8;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct BudgetFile {
    measurand: Option<String>,
    unit: Option<Text>,
    model: Option<Text>,
    coverage_factor: Option<Number>,
    coverage_probability: Option<Number>,
    degrees_of_freedom_rounding: Option<Text>,
    #[serde(default)]
    component: Vec<Spanned<ComponentTable>>,
    #[serde(default)]
    correlation: Vec<Spanned<CorrelationTable>>,
}

/// Reads a budget file; a component's `budget` key names a file beside it.
///
/// # Errors
/// Every fault with file, line and remedy.
pub fn load(path: &Path) -> Result<Budget> {
    load_stage(path, &mut Vec::new())
}

/// Reads a budget from text.
///
/// # Errors
/// As [`load`].
pub fn parse(source: &Source) -> Result<Budget> {
    parse_stage(source, &mut Vec::new())
}

fn load_stage(path: &Path, stages: &mut Vec<PathBuf>) -> Result<Budget> {
    parse_stage(&Source::read(path)?, stages)
}

/// The budget a component names, in a file beside its own.
fn stage_beside(source: &Source, name: &Text, stages: &mut Vec<PathBuf>) -> Result<Budget> {
    let folder = source.path.parent().unwrap_or(Path::new(""));
    let path = folder.join(name.get_ref());
    if stages.contains(&path) || stages.len() >= MAX_STAGES {
        return Err(source.at(
            &name.span(),
            format!("budget '{}' leads back to itself", name.get_ref()),
            "a chain of budgets must end in one that names no further budget",
        ));
    }
    stages.push(path.clone());
    let inner = load_stage(&path, stages)?;
    stages.pop();
    Ok(inner)
}

fn parse_stage(source: &Source, stages: &mut Vec<PathBuf>) -> Result<Budget> {
    let file: BudgetFile = source.parse_toml(KEYS)?;
    let mut remarks = Vec::new();
    let unit = unit(source, &file)?;
    let mut components = Vec::new();
    for table in &file.component {
        let mut stage = |name: &Text| stage_beside(source, name, stages);
        let component = component(source, table, unit, &mut stage, &mut remarks)?;
        check_label(source, &table.get_ref().label, &components)?;
        components.push(component);
    }
    check_something(source, &components)?;
    let correlations = correlations(source, &file.correlation, &components)?;
    Ok(Budget {
        measurand: file
            .measurand
            .clone()
            .unwrap_or_else(|| "not stated".into()),
        unit,
        model: model(source, &file, unit)?,
        coverage: coverage(source, &file)?,
        truncate_degrees_of_freedom: truncation(source, &file)?,
        components,
        correlations,
        remarks,
    })
}

fn unit(source: &Source, file: &BudgetFile) -> Result<Unit> {
    let Some(text) = &file.unit else {
        return Ok(Unit::Percent);
    };
    match text.get_ref().as_str() {
        "percent" | "%" => Ok(Unit::Percent),
        "deg" | "degree" | "degrees" => Ok(Unit::Degree),
        other => Err(source.at(
            &text.span(),
            format!("unit '{other}' is not known"),
            "write \"percent\" (magnitude) or \"deg\" (phase)",
        )),
    }
}

fn model(source: &Source, file: &BudgetFile, unit: Unit) -> Result<Model> {
    let Some(text) = &file.model else {
        return Ok(match unit {
            Unit::Percent => Model::Product,
            Unit::Degree => Model::Sum,
        });
    };
    match text.get_ref().as_str() {
        "product" => Ok(Model::Product),
        "sum" => Ok(Model::Sum),
        other => Err(source.at(
            &text.span(),
            format!("model '{other}' is not known"),
            "write \"product\" (relative budgets) or \"sum\"",
        )),
    }
}

fn coverage(source: &Source, file: &BudgetFile) -> Result<CoverageRule> {
    match (&file.coverage_factor, &file.coverage_probability) {
        (None, None) => Ok(CoverageRule::Default),
        (Some(factor), None) => {
            input::coverage_factor(source, "coverage_factor", factor).map(CoverageRule::Factor)
        }
        (None, Some(number)) => {
            let probability = input::positive(source, "coverage_probability", number)?;
            match COVERAGE_PROBABILITIES.contains(&probability) {
                true => Ok(CoverageRule::Probability(probability)),
                false => Err(source.at(
                    &number.span(),
                    format!("coverage_probability = {probability} is not between 0.68 and 1"),
                    "write 95 % as 0.95; below 68 % U is less than the standard uncertainty",
                )),
            }
        }
        (Some(_), Some(second)) => Err(source.at(
            &second.span(),
            "coverage_factor and coverage_probability are both stated",
            "state one of them; the other follows from it",
        )),
    }
}

fn truncation(source: &Source, file: &BudgetFile) -> Result<bool> {
    let Some(text) = &file.degrees_of_freedom_rounding else {
        return Ok(false);
    };
    match text.get_ref().as_str() {
        "none" => Ok(false),
        "down" => Ok(true),
        other => Err(source.at(
            &text.span(),
            format!("degrees_of_freedom_rounding '{other}' is not known"),
            "write \"none\" (interpolate, GUM G.4.1) or \"down\" (EA-4/02 Annex E)",
        )),
    }
}

fn check_something(source: &Source, components: &[Component]) -> Result<()> {
    if components.is_empty() {
        return Err(source.at_line(
            1,
            "the budget has no component",
            "add [[component]] tables with label, value and distribution",
        ));
    }
    if components
        .iter()
        .all(|component| component.signed_contribution() == 0.0)
    {
        return Err(source.at_line(
            1,
            "every contribution is zero",
            "state the value of at least one component in percent",
        ));
    }
    Ok(())
}
