//! The budget file: TOML a person writes by hand.

use super::correlation::first_negative_eigenvalue;
use super::{
    Budget, Coefficient, Component, Correlation, CoverageRule, Distribution, Model, Unit, evaluate,
};
use crate::Result;
use crate::metrology::input::{self, Number, Source, Text};
use serde::Deserialize;
use std::path::{Path, PathBuf};
use toml::{Spanned, Value};

/// Budgets inside budgets: Note 1 of Table A.1 needs one, a chain a few more.
const MAX_STAGES: usize = 8;

/// Remedy of everything the TOML reader itself refuses.
const KEYS: &str = "known keys: measurand, unit, model, coverage_factor or \
coverage_probability, degrees_of_freedom_rounding, [[component]] with label, value, \
distribution, k, divisor, shape, sensitivity_coefficient, degrees_of_freedom, budget, \
and [[correlation]] with a, b, r; see docs/metrology/budget.md";

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

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ComponentTable {
    label: Text,
    value: Option<Number>,
    distribution: Option<Text>,
    k: Option<Number>,
    divisor: Option<Number>,
    shape: Option<Text>,
    sensitivity_coefficient: Option<Number>,
    degrees_of_freedom: Option<Number>,
    budget: Option<Text>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct CorrelationTable {
    a: Spanned<Value>,
    b: Spanned<Value>,
    r: Number,
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

fn parse_stage(source: &Source, stages: &mut Vec<PathBuf>) -> Result<Budget> {
    let file: BudgetFile = source.parse_toml(KEYS)?;
    let mut remarks = Vec::new();
    let unit = unit(source, &file)?;
    let mut components = Vec::new();
    for table in &file.component {
        let component = component(source, table, unit, stages, &mut remarks)?;
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
            input::positive(source, "coverage_factor", factor).map(CoverageRule::Factor)
        }
        (None, Some(number)) => {
            let probability = input::positive(source, "coverage_probability", number)?;
            match probability < 1.0 {
                true => Ok(CoverageRule::Probability(probability)),
                false => Err(source.at(
                    &number.span(),
                    format!("coverage_probability = {probability} is not below 1"),
                    "write 95 % as 0.95",
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

fn component(
    source: &Source,
    table: &Spanned<ComponentTable>,
    unit: Unit,
    stages: &mut Vec<PathBuf>,
    remarks: &mut Vec<String>,
) -> Result<Component> {
    let fields = table.get_ref();
    let label = fields.label.get_ref().trim().to_owned();
    let sensitivity_coefficient = match &fields.sensitivity_coefficient {
        Some(number) => input::finite(source, "sensitivity_coefficient", number)?,
        None => 1.0,
    };
    if let Some(name) = &fields.budget {
        let mut component = staged(source, fields, name, unit, stages, remarks)?;
        component.sensitivity_coefficient = sensitivity_coefficient;
        return Ok(component);
    }
    let Some(value) = &fields.value else {
        return Err(source.at(
            &fields.label.span(),
            format!("component '{label}' has no value"),
            "add `value = ...` in percent: half-width, or expanded for normal",
        ));
    };
    Ok(Component {
        value: not_negative(source, value)?,
        distribution: distribution(source, fields, remarks)?,
        degrees_of_freedom: degrees_of_freedom(source, fields)?,
        sensitivity_coefficient,
        label,
    })
}

fn not_negative(source: &Source, number: &Number) -> Result<f64> {
    let value = input::finite(source, "value", number)?;
    match value >= 0.0 {
        true => Ok(value),
        false => Err(source.at(
            &number.span(),
            format!("value = {value}: an uncertainty is never negative"),
            "write its magnitude; a sign belongs to sensitivity_coefficient",
        )),
    }
}

fn degrees_of_freedom(source: &Source, fields: &ComponentTable) -> Result<f64> {
    let Some(number) = &fields.degrees_of_freedom else {
        return Ok(f64::INFINITY);
    };
    let value = input::plain(source, "degrees_of_freedom", number)?;
    match value > 0.0 {
        true => Ok(value),
        false => Err(source.at(
            &number.span(),
            format!("degrees_of_freedom = {value}: must be greater than zero"),
            "n - 1 for a mean of n observations; leave it out for infinite",
        )),
    }
}

fn distribution(
    source: &Source,
    fields: &ComponentTable,
    remarks: &mut Vec<String>,
) -> Result<Distribution> {
    let Some(name) = &fields.distribution else {
        return Err(source.at(
            &fields.label.span(),
            format!("component '{}' has no distribution", fields.label.get_ref()),
            "add `distribution = \"normal\"`, rectangular, triangular, u_shaped or special",
        ));
    };
    let spelled = name.get_ref().trim().to_lowercase().replace('-', "_");
    match spelled.as_str() {
        "normal" | "gaussian" => return normal(source, fields, remarks),
        "special" => return special(source, fields),
        _ => {}
    }
    let fixed = match spelled.as_str() {
        "rectangular" | "uniform" => Distribution::Rectangular,
        "triangular" => Distribution::Triangular,
        "u_shaped" | "arcsine" | "ushaped" => Distribution::UShaped,
        _ => {
            return Err(source.at(
                &name.span(),
                format!("distribution '{}' is not known", name.get_ref()),
                "write normal, rectangular, triangular, u_shaped or special",
            ));
        }
    };
    refuse_k(source, fields, &spelled)?;
    refuse_shape(source, fields)?;
    check_fixed_divisor(source, fields, fixed)?;
    Ok(fixed)
}

fn normal(
    source: &Source,
    fields: &ComponentTable,
    remarks: &mut Vec<String>,
) -> Result<Distribution> {
    refuse_shape(source, fields)?;
    let k = match &fields.k {
        Some(number) => Some(input::positive(source, "k", number)?),
        None => None,
    };
    let divisor = match &fields.divisor {
        Some(number) => Some((input::positive(source, "divisor", number)?, number.span())),
        None => None,
    };
    let coverage_factor = match (k, divisor) {
        (Some(k), Some((divisor, span))) if (divisor / k - 1.0).abs() > 0.005 => {
            return Err(source.at(
                &span,
                format!("k = {k} and divisor = {divisor} contradict each other"),
                "keep one of them; for a normal distribution they are the same",
            ));
        }
        (Some(k), _) => k,
        (None, Some((divisor, _))) => divisor,
        (None, None) => {
            remarks.push(format!(
                "{}: k is not stated, so k = 2 (ISO 16063-21 A.1.6)",
                fields.label.get_ref()
            ));
            2.0
        }
    };
    Ok(Distribution::Normal { coverage_factor })
}

fn special(source: &Source, fields: &ComponentTable) -> Result<Distribution> {
    refuse_k(source, fields, "special")?;
    let Some(number) = &fields.divisor else {
        return Err(source.at(
            &fields.label.span(),
            format!(
                "special component '{}' has no divisor",
                fields.label.get_ref()
            ),
            "add `divisor = ...`, value over standard uncertainty, such as 4.2426 (sqrt 18)",
        ));
    };
    let divisor = input::positive(source, "divisor", number)?;
    let transverse = match &fields.shape {
        None => false,
        Some(shape) if shape.get_ref() == "transverse" => true,
        Some(shape) => {
            return Err(source.at(
                &shape.span(),
                format!("shape '{}' is not known", shape.get_ref()),
                "write \"transverse\" (Table D.1 Note 3), or leave it out",
            ));
        }
    };
    if transverse && (divisor / 18.0_f64.sqrt() - 1.0).abs() > 0.01 {
        return Err(source.at(
            &number.span(),
            format!("divisor = {divisor}, but shape \"transverse\" has sqrt(18) = 4.2426"),
            "correct the divisor, or leave the shape out",
        ));
    }
    Ok(Distribution::Special {
        divisor,
        transverse,
    })
}

fn refuse_k(source: &Source, fields: &ComponentTable, name: &str) -> Result<()> {
    match &fields.k {
        None => Ok(()),
        Some(k) => Err(source.at(
            &k.span(),
            format!("k is stated for a {name} component"),
            "k belongs to normal; use divisor with special, nothing with the others",
        )),
    }
}

fn refuse_shape(source: &Source, fields: &ComponentTable) -> Result<()> {
    match &fields.shape {
        None => Ok(()),
        Some(shape) => Err(source.at(
            &shape.span(),
            "shape is only for distribution = \"special\"",
            "remove the key",
        )),
    }
}

fn check_fixed_divisor(
    source: &Source,
    fields: &ComponentTable,
    fixed: Distribution,
) -> Result<()> {
    let Some(number) = &fields.divisor else {
        return Ok(());
    };
    let stated = input::positive(source, "divisor", number)?;
    let own = fixed.divisor();
    match (stated / own - 1.0).abs() <= 0.005 {
        true => Ok(()),
        false => Err(source.at(
            &number.span(),
            format!(
                "divisor = {stated}, but a {} distribution has {own:.4}",
                fixed.name()
            ),
            "remove the divisor, or write distribution = \"special\"",
        )),
    }
}

/// Combined uncertainty of another budget: the working reference calibrated
/// by the reference (Note 1 of Tables A.1 and A.2).
fn staged(
    source: &Source,
    fields: &ComponentTable,
    name: &Text,
    unit: Unit,
    stages: &mut Vec<PathBuf>,
    remarks: &mut Vec<String>,
) -> Result<Component> {
    if fields.value.is_some() || fields.distribution.is_some() {
        return Err(source.at(
            &name.span(),
            "a component with `budget` takes value and distribution from that file",
            "remove value and distribution, or budget",
        ));
    }
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
    if inner.unit != unit {
        return Err(source.at(
            &name.span(),
            format!("budget '{}' is in another unit", name.get_ref()),
            "use a magnitude budget for magnitude, a phase budget for phase",
        ));
    }
    let result = evaluate(&inner);
    remarks.push(format!(
        "{}: standard uncertainty {:.4} {} from {}",
        fields.label.get_ref(),
        result.combined_standard_uncertainty,
        unit.symbol(),
        name.get_ref()
    ));
    Ok(Component {
        label: fields.label.get_ref().trim().to_owned(),
        value: result.combined_standard_uncertainty,
        distribution: Distribution::Normal {
            coverage_factor: 1.0,
        },
        sensitivity_coefficient: 1.0,
        degrees_of_freedom: result.effective_degrees_of_freedom,
    })
}

fn check_label(source: &Source, label: &Text, earlier: &[Component]) -> Result<()> {
    let name = label.get_ref().trim();
    let problem = match name {
        "" => "a component has an empty label".to_owned(),
        _ if earlier.iter().any(|component| component.label == name) => {
            format!("two components are labelled '{name}'")
        }
        _ => return Ok(()),
    };
    Err(source.at(&label.span(), problem, "give each component its own label"))
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

fn correlations(
    source: &Source,
    tables: &[Spanned<CorrelationTable>],
    components: &[Component],
) -> Result<Vec<Correlation>> {
    let mut all: Vec<Correlation> = Vec::new();
    for table in tables {
        let correlation = correlation(source, table.get_ref(), components)?;
        let pair = |other: &Correlation| {
            let (a, b) = (other.a.min(other.b), other.a.max(other.b));
            (a, b)
                == (
                    correlation.a.min(correlation.b),
                    correlation.a.max(correlation.b),
                )
        };
        if all.iter().any(pair) {
            return Err(source.at(
                &table.get_ref().a.span(),
                "this pair of components is correlated twice",
                "keep one [[correlation]] for each pair",
            ));
        }
        all.push(correlation);
    }
    match first_negative_eigenvalue(components.len(), &all) {
        None => Ok(all),
        Some(lowest) => Err(source.at(
            &tables.last().map_or(0..0, |table| table.get_ref().r.span()),
            format!(
                "the correlation matrix is not positive semidefinite: \
                 smallest eigenvalue {lowest:.3}"
            ),
            "no quantities can be correlated like this; reduce the coefficients \
             or correct a sign",
        )),
    }
}

fn correlation(
    source: &Source,
    table: &CorrelationTable,
    components: &[Component],
) -> Result<Correlation> {
    let a = index_of(source, &table.a, components)?;
    let b = index_of(source, &table.b, components)?;
    if a == b {
        return Err(source.at(
            &table.b.span(),
            "a component is correlated with itself",
            "name two different components",
        ));
    }
    if let Value::String(text) = table.r.get_ref()
        && text == "unknown"
    {
        let coefficient = Coefficient::Unknown;
        return Ok(Correlation { a, b, coefficient });
    }
    let r = input::finite(source, "r", &table.r)?;
    if r.abs() > 1.0 {
        return Err(source.at(
            &table.r.span(),
            format!("r = {r} is outside -1 .. 1"),
            "write a correlation coefficient, or \"unknown\" for the bound of D.4",
        ));
    }
    let coefficient = Coefficient::Known(r);
    Ok(Correlation { a, b, coefficient })
}

fn index_of(source: &Source, key: &Spanned<Value>, components: &[Component]) -> Result<usize> {
    let found = match key.get_ref() {
        Value::String(label) => components
            .iter()
            .position(|component| component.label == label.trim()),
        Value::Integer(number) => usize::try_from(*number)
            .ok()
            .and_then(|number| number.checked_sub(1))
            .filter(|index| *index < components.len()),
        _ => None,
    };
    found.ok_or_else(|| {
        source.at(
            &key.span(),
            format!("no component is called {}", key.get_ref()),
            "write the label of a component, or its number from 1",
        )
    })
}
