//! Linked comparisons and judged tables as text.

use super::doe::{Degree, Judgement};
use super::file::{LinkFile, LinkedFrequency};
use super::reference::ReferenceValue;
use crate::text::{significant, table, wrap};

/// The linked comparison, frequency by frequency.
pub fn link_report(file: &LinkFile, linked: &[LinkedFrequency], pairs: bool) -> String {
    let mut text = format!("{}\n", file.title);
    for entry in linked {
        let link = &entry.linked;
        if let Some(frequency_hz) = entry.frequency_hz {
            text.push_str(&format!("\nAt {frequency_hz} Hz\n"));
        }
        text.push_str(&mean_line("reference value x", &link.reference_value));
        text.push_str(&mean_line("linking mean y", &link.linking_mean));
        text.push_str(&format!(
            "  linking coefficient r = {}, u = {}\n\n",
            significant(link.linking_coefficient, 8),
            significant(link.u_linking_coefficient, 2)
        ));
        let rows: Vec<Vec<String>> = link
            .laboratories
            .iter()
            .map(|laboratory| {
                vec![
                    match laboratory.linking {
                        true => format!("{} *", laboratory.laboratory),
                        false => laboratory.laboratory.clone(),
                    },
                    significant(laboratory.value, 7),
                    significant(laboratory.standard_uncertainty, 2),
                    significant(laboratory.d, 3),
                    significant(laboratory.u_expanded, 2),
                    e_n(laboratory.e_n),
                    agreement(laboratory.d, laboratory.u_expanded).into(),
                ]
            })
            .collect();
        text.push_str(&table(
            &["laboratory", "linked", "u", "d", "U(d)", "E_n", ""],
            &rows,
        ));
        if pairs {
            text.push_str(&pair_table(entry));
        }
    }
    text.push_str("\n  * linking laboratory\n");
    text
}

fn mean_line(name: &str, mean: &ReferenceValue) -> String {
    let mut line = format!(
        "{name} = {}, u = {}; chi-squared {} for {} degrees of freedom",
        significant(mean.value, 8),
        significant(mean.standard_uncertainty, 2),
        significant(mean.chi2, 3),
        mean.degrees_of_freedom
    );
    if !mean.consistent {
        line += &format!(": NOT consistent (p = {})", significant(mean.p_value, 2));
    }
    if mean.between_laboratories > 0.0 {
        line += &format!(
            ", weights of Mandel and Paule with {} between laboratories",
            significant(mean.between_laboratories, 2)
        );
    }
    wrap(&line, 2)
}

fn pair_table(entry: &LinkedFrequency) -> String {
    let rows: Vec<Vec<String>> = entry
        .linked
        .pairs
        .iter()
        .map(|pair| {
            vec![
                format!("{} - {}", pair.a, pair.b),
                significant(pair.d, 3),
                significant(pair.u_expanded, 2),
                e_n(pair.e_n),
                agreement(pair.d, pair.u_expanded).into(),
            ]
        })
        .collect();
    format!("\n{}", table(&["pair", "d", "U(d)", "E_n", ""], &rows))
}

fn agreement(d: f64, u_expanded: f64) -> &'static str {
    match d.abs() > u_expanded {
        true => "NOT consistent",
        false => "",
    }
}

/// The judged table.
pub fn doe_report(judgement: &Judgement) -> String {
    let mut text = format!("{} degrees of equivalence\n\n", judgement.rows);
    text.push_str(&list("Not consistent", &judgement.inconsistent));
    text.push_str(&list("Exactly on the limit", &judgement.on_limit));
    text.push_str(&wrap(&format!("Rule: {}.", judgement.rule), 2));
    text
}

fn list(title: &str, degrees: &[Degree]) -> String {
    if degrees.is_empty() {
        return format!("{title}: none\n\n");
    }
    let rows: Vec<Vec<String>> = degrees
        .iter()
        .map(|degree| {
            vec![
                degree.laboratory.clone(),
                degree.frequency_hz.map_or("-".into(), |f| format!("{f}")),
                format!("{}", degree.d),
                format!("{}", degree.u_expanded),
                format!("{:.2}", degree.d / degree.u_expanded),
            ]
        })
        .collect();
    let header = ["laboratory", "f/Hz", "d", "U(d)", "E_n"];
    format!("{title}\n{}\n", table(&header, &rows))
}

/// A result compared with nothing but itself has no uncertainty and no E_n.
fn e_n(value: f64) -> String {
    match value.is_finite() {
        true => format!("{value:.2}"),
        false => "-".into(),
    }
}
