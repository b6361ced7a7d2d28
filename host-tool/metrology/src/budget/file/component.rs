//! One `[[component]]` of a budget file.

use crate::budget::{Budget, Component, Distribution, Unit, evaluate};
use crate::input::{self, Number, Source, Text};
use calib_files::Result;
use serde::Deserialize;
use toml::Spanned;

/// Reads the budget that a component names.
pub(super) type ReadStage<'a> = dyn FnMut(&Text) -> Result<Budget> + 'a;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ComponentTable {
    pub(super) label: Text,
    pub(super) value: Option<Number>,
    pub(super) distribution: Option<Text>,
    pub(super) k: Option<Number>,
    pub(super) divisor: Option<Number>,
    pub(super) shape: Option<Text>,
    pub(super) sensitivity_coefficient: Option<Number>,
    pub(super) degrees_of_freedom: Option<Number>,
    pub(super) budget: Option<Text>,
}

pub(super) fn component(
    source: &Source,
    table: &Spanned<ComponentTable>,
    unit: Unit,
    read_stage: &mut ReadStage<'_>,
    remarks: &mut Vec<String>,
) -> Result<Component> {
    let fields = table.get_ref();
    let label = fields.label.get_ref().trim().to_owned();
    let sensitivity_coefficient = match &fields.sensitivity_coefficient {
        Some(number) => input::finite(source, "sensitivity_coefficient", number)?,
        None => 1.0,
    };
    if let Some(name) = &fields.budget {
        let mut component = staged(source, fields, name, unit, read_stage, remarks)?;
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
        value: possible(source, value, unit)?,
        distribution: distribution(source, fields, remarks)?,
        degrees_of_freedom: degrees_of_freedom(source, fields)?,
        sensitivity_coefficient,
        label,
    })
}

/// An uncertainty is never negative, nor larger than the quantity itself or half a turn.
fn possible(source: &Source, number: &Number, unit: Unit) -> Result<f64> {
    let value = input::finite(source, "value", number)?;
    let (most, words) = match unit {
        Unit::Percent => (100.0, "100 %"),
        Unit::Degree => (180.0, "180 degrees"),
    };
    if value < 0.0 {
        return Err(source.at(
            &number.span(),
            format!("value = {value}: an uncertainty is never negative"),
            "write its magnitude; a sign belongs to sensitivity_coefficient",
        ));
    }
    match value <= most {
        true => Ok(value),
        false => Err(source.at(
            &number.span(),
            format!("value = {value} is more than {words}"),
            "write the half-width in the unit of the budget",
        )),
    }
}

fn degrees_of_freedom(source: &Source, fields: &ComponentTable) -> Result<f64> {
    let Some(number) = &fields.degrees_of_freedom else {
        return Ok(f64::INFINITY);
    };
    let value = input::plain(source, "degrees_of_freedom", number)?;
    match value >= 1.0 {
        true => Ok(value),
        false => Err(source.at(
            &number.span(),
            format!("degrees_of_freedom = {value}: must be 1 or more"),
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
        Some(number) => Some(input::coverage_factor(source, "k", number)?),
        None => None,
    };
    let divisor = match &fields.divisor {
        Some(number) => Some((
            input::coverage_factor(source, "divisor", number)?,
            number.span(),
        )),
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

/// Two values have 1; the largest is that of a coverage factor.
const DIVISORS: std::ops::RangeInclusive<f64> = 1.0..=14.0;

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
    if !DIVISORS.contains(&divisor) {
        return Err(source.at(
            &number.span(),
            format!("divisor = {divisor} is none of a distribution: they lie between 1 and 14"),
            "it is value over standard uncertainty, which is never more than the half-width",
        ));
    }
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
    read_stage: &mut ReadStage<'_>,
    remarks: &mut Vec<String>,
) -> Result<Component> {
    if fields.value.is_some() || fields.distribution.is_some() {
        return Err(source.at(
            &name.span(),
            "a component with `budget` takes value and distribution from that file",
            "remove value and distribution, or budget",
        ));
    }
    let inner = read_stage(name)?;
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

pub(super) fn check_label(source: &Source, label: &Text, earlier: &[Component]) -> Result<()> {
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
