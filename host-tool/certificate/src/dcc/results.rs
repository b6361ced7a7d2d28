//! Measurement results: method, equipment, conditions, and the lists.

use super::administrative::{identification, one_software, stated};
use super::xml::Xml;
use crate::decision::Conformity;
use crate::kind::SensorKind;
use crate::model::{Certificate, Deviation, Point, PointValues, Value};
use crate::present;
use crate::rounding::Rounded;
use crate::words::Language;
use calib_core::budget::coverage::PROBABILITY_K2;
use calib_core::quantity::MotionQuantity;
use calib_output::number::{fixed, shortened};

/// Values with their expanded uncertainties; all lists are equally long.
struct List<'a> {
    name: &'a str,
    ref_type: &'a str,
    unit: &'a str,
    values: Vec<String>,
    /// Expanded uncertainties and coverage factors, if the quantity has them.
    uncertainties: Option<(Vec<String>, Vec<String>)>,
    /// Conformity of each value, if the quantity is judged.
    conformity: Vec<&'static str>,
}

pub(super) fn write(xml: &mut Xml, certificate: &Certificate, language: Language) {
    xml.element("dcc:measurementResults", |xml| {
        xml.element("dcc:measurementResult", |xml| {
            let name = language.word("section.response");
            let name = match certificate.marked(language) {
                marks if marks.is_empty() => name.to_owned(),
                marks => format!("{marks}: {name}"),
            };
            xml.content("dcc:name", language.code(), &name);
            method(xml, certificate, language);
            let firmware = stated(certificate, "equipment", "firmware", Language::En);
            xml.element("dcc:usedSoftware", |xml| {
                one_software(xml, "calibrator firmware", &firmware, "firmware");
            });
            equipment(xml, certificate, language);
            conditions(xml, certificate, language);
            results(xml, certificate, language);
        });
    });
}

fn method(xml: &mut Xml, certificate: &Certificate, language: Language) {
    let method = stated(certificate, "calibration", "method", language);
    xml.element("dcc:usedMethods", |xml| {
        xml.with(
            "dcc:usedMethod",
            &[("refType", "basic_calibrationMethod")],
            |xml| {
                xml.content("dcc:name", language.code(), &method);
                xml.leaf("dcc:norm", "ISO 16063-21:2003");
            },
        );
    });
}

fn equipment(xml: &mut Xml, certificate: &Certificate, language: Language) {
    let said = |key| stated(certificate, "equipment", key, language);
    let serial = language.word("item.serial");
    xml.element("dcc:measuringEquipments", |xml| {
        for key in ["instrument", "reference"] {
            xml.element("dcc:measuringEquipment", |xml| {
                xml.content(
                    "dcc:name",
                    language.code(),
                    language.word(&format!("equipment.{key}")),
                );
                xml.element("dcc:identifications", |xml| {
                    identification(xml, "manufacturer", &said(key), serial, language);
                });
            });
        }
    });
}

/// Every statement on conditions, mounting and amplifier: a number as a real
/// with its unit, everything else in words.
fn conditions(xml: &mut Xml, certificate: &Certificate, language: Language) {
    let wanted = ["conditions", "mounting", "amplifier"];
    let sections = certificate
        .sections
        .iter()
        .filter(|s| wanted.contains(&s.key));
    xml.element("dcc:influenceConditions", |xml| {
        for (section, entry) in sections.flat_map(|s| s.entries.iter().map(move |e| (s, e))) {
            let label = format!("{}.{}", section.key, entry.key);
            let label = language.word(&label);
            let attributes = ref_type(section.key, entry.key);
            xml.with("dcc:influenceCondition", attributes, |xml| {
                xml.content("dcc:name", language.code(), label);
                xml.element("dcc:data", |xml| {
                    xml.element("dcc:quantity", |xml| {
                        condition(xml, entry.value.as_ref(), language)
                    });
                });
            });
        }
    });
}

fn ref_type(section: &str, key: &str) -> &'static [(&'static str, &'static str)] {
    match (section, key) {
        ("conditions", "ambient_temperature") => &[("refType", "basic_temperature")],
        ("conditions", "humidity") => &[("refType", "basic_humidityRelative")],
        _ => &[],
    }
}

fn condition(xml: &mut Xml, value: Option<&Value>, language: Language) {
    let number = match value {
        Some(Value::Number(number, decimals, unit)) => {
            unit_of(unit).map(|u| (fixed(*number, *decimals), u))
        }
        Some(Value::Exact(number, unit)) => unit_of(unit).map(|u| (number.to_string(), u)),
        _ => None,
    };
    match number {
        Some((number, unit)) => xml.element("si:real", |xml| {
            xml.leaf("si:value", &number);
            xml.leaf("si:unit", unit);
        }),
        None => {
            let words = value.map_or_else(
                || language.word("missing").to_owned(),
                |v| present::value(v, language),
            );
            xml.content("dcc:noQuantity", language.code(), &words);
        }
    }
}

/// D-SI units of the statements.
fn unit_of(unit: &str) -> Option<&'static str> {
    match unit {
        "°C" => Some(r"\degreecelsius"),
        "K" => Some(r"\kelvin"),
        "%" => Some(r"\percent"),
        "Hz" => Some(r"\hertz"),
        "N m" => Some(r"\newton\metre"),
        "µV" => Some(r"\micro\volt"),
        _ => None,
    }
}

/// A point that has a result.
type Measured<'a> = (&'a Point, &'a PointValues);

/// Results that are judged, results nothing is specified for, and what was
/// found before an adjustment: a list has either a conformity for every value
/// or none.
fn results(xml: &mut Xml, certificate: &Certificate, language: Language) {
    let title = language.word("section.table");
    xml.element("dcc:results", |xml| {
        result(xml, certificate, title, language);
        if let Some(found) = certificate.as_found.as_deref() {
            let number = format!("{} ({})", language.word("column.as_found"), found.number);
            result(xml, found, &number, language);
        }
    });
}

fn result(xml: &mut Xml, certificate: &Certificate, title: &str, language: Language) {
    // The schema has no word for what cannot be judged.
    let not_judgeable = Conformity::NotJudgeable;
    let judged = |(_, values): &Measured<'_>| {
        values
            .assessment
            .is_some_and(|judged| judged.conformity != not_judgeable)
    };
    let (judged, others): (Vec<_>, Vec<_>) = certificate.results().partition(judged);
    let empty = judged.is_empty() && others.is_empty();
    let refused = refused(certificate, language);
    if empty {
        return one_result(xml, certificate, title, refused, &[], language);
    }
    if !judged.is_empty() {
        one_result(xml, certificate, title, refused.clone(), &judged, language);
    }
    if !others.is_empty() {
        let only = judged.is_empty();
        let description = if only { refused } else { None };
        let why = not_judged(&others, language).filter(|_| certificate.decision.is_some());
        let texts: Vec<String> = description.into_iter().chain(why).collect();
        let description = (!texts.is_empty()).then(|| texts.join("; "));
        one_result(xml, certificate, title, description, &others, language);
    }
}

/// Why points have no conformity: nothing is specified there, or U is too large.
fn not_judged(points: &[Measured<'_>], language: Language) -> Option<String> {
    let (not_judgeable, not_specified): (Vec<Measured<'_>>, Vec<Measured<'_>>) = points
        .iter()
        .copied()
        .partition(|(_, values)| values.assessment.is_some());
    let of = |key: &str, points: &[Measured<'_>]| {
        let hz = points
            .iter()
            .map(|(p, _)| language.shortest(p.nominal_frequency_hz));
        let hz: Vec<String> = hz.collect();
        (!hz.is_empty()).then(|| format!("{}: {} Hz", language.word(key), hz.join(", ")))
    };
    let texts = [
        of("conformity.notJudgeable", &not_judgeable),
        of("conformity.not_specified", &not_specified),
    ];
    let texts: Vec<String> = texts.into_iter().flatten().collect();
    (!texts.is_empty()).then(|| texts.join("; "))
}

fn one_result(
    xml: &mut Xml,
    certificate: &Certificate,
    title: &str,
    description: Option<String>,
    points: &[Measured<'_>],
    language: Language,
) {
    xml.element("dcc:result", |xml| {
        xml.content("dcc:name", language.code(), title);
        if let Some(description) = description {
            xml.content("dcc:description", language.code(), &description);
        }
        xml.element("dcc:data", |xml| {
            if points.is_empty() {
                let words = language.word("result.none");
                xml.element("dcc:quantity", |xml| {
                    xml.content("dcc:noQuantity", language.code(), words)
                });
            } else {
                xml.element("dcc:list", |xml| lists(xml, certificate, points, language));
            }
        });
    });
}

/// Refused points, with their reasons.
fn refused(certificate: &Certificate, language: Language) -> Option<String> {
    let reason = |point: &Point| {
        let refusal = point.outcome.as_ref().err()?;
        let reason = language.word(&format!("reason.{}", refusal.0)).to_owned();
        Some(format!(
            "{} Hz: {reason}",
            language.shortest(point.nominal_frequency_hz)
        ))
    };
    let refused: Vec<String> = certificate.points.iter().filter_map(reason).collect();
    (!refused.is_empty())
        .then(|| format!("{}: {}", language.word("state.refused"), refused.join("; ")))
}

fn lists(xml: &mut Xml, certificate: &Certificate, points: &[Measured<'_>], language: Language) {
    let frequencies = plain(
        language.word("column.frequency"),
        "vib_frequency",
        r"\hertz",
        points,
        |p| p.frequency_hz.to_string(),
    );
    let accelerations = plain(
        language.word("calibration.acceleration_rms"),
        "vib_acceleration",
        r"\metre\second\tothe{-2}",
        points,
        |p| p.acceleration_ms2.to_string(),
    );
    let motions = motions(certificate.kind, points, language);
    let magnitudes = magnitudes(certificate.kind, points, language);
    let lists = [frequencies, accelerations].into_iter().chain(motions);
    let lists = lists.chain([magnitudes]).chain(phases(points, language));
    for list in lists.chain(deviations(points, language)) {
        write_list(xml, certificate, language, &list);
    }
}

/// Velocities or displacements of a sensor to them.
fn motions<'a>(kind: SensorKind, points: &[Measured<'_>], language: Language) -> Option<List<'a>> {
    // Motions are in mm/s and um.
    let (ref_type, unit, per_si) = match kind.quantity() {
        MotionQuantity::Acceleration => return None,
        MotionQuantity::Velocity => ("vib_velocity", r"\metre\second\tothe{-1}", 1.0e-3),
        MotionQuantity::Displacement => ("vib_displacement", r"\metre", 1.0e-6),
    };
    let name = language.word("column.amplitude");
    let si = |point: &Point| shortened(per_si * point.amplitude_rms, 7).to_string();
    Some(plain(name, ref_type, unit, points, si))
}

fn magnitudes<'a>(kind: SensorKind, points: &[Measured<'_>], language: Language) -> List<'a> {
    let printed = |number: fn(&Rounded) -> f64| -> Vec<String> {
        let of_point = points.iter().map(|(_, values)| &values.printed);
        of_point
            .map(|rounded| fixed(number(rounded), rounded.decimals))
            .collect()
    };
    let factors = points.iter().map(|(_, v)| factor(v.coverage_factor));
    let judged = points.iter().filter_map(|(_, v)| v.assessment);
    List {
        name: language.word("result.sensitivity"),
        ref_type: "vib_sensitivityMagnitude",
        // Every kind has a unit of D-SI among those alike.
        unit: kind.stated_unit().d_si().unwrap_or_default(),
        values: printed(|r| r.value),
        uncertainties: Some((printed(|r| r.uncertainty), factors.collect())),
        conformity: judged.map(|a| spelled(a.conformity)).collect(),
    }
}

/// Phase shifts, where every point has one.
fn phases<'a>(points: &[Measured<'_>], language: Language) -> Option<List<'a>> {
    let phases: Option<Vec<Rounded>> = points.iter().map(|(_, v)| v.printed_phase_deg).collect();
    let phases = phases?;
    let printed = |number: fn(&Rounded) -> f64| {
        let numbers = phases.iter().map(|r| fixed(number(r), r.decimals));
        numbers.collect::<Vec<_>>()
    };
    let factors = points
        .iter()
        .map(|(_, v)| factor(v.coverage_factor_phase.unwrap_or(2.0)));
    Some(List {
        name: language.word("result.phase"),
        ref_type: "vib_sensitivityPhase",
        unit: r"\degree",
        values: printed(|r| r.value),
        uncertainties: Some((printed(|r| r.uncertainty), factors.collect())),
        conformity: Vec::new(),
    })
}

/// Deviations from the reference point, where every point has one; at that point it is nothing, and has
/// no uncertainty.
fn deviations<'a>(points: &[Measured<'_>], language: Language) -> Option<List<'a>> {
    let deviations: Option<Vec<Deviation>> = points.iter().map(|(_, v)| v.deviation).collect();
    let deviations = deviations?;
    let values = deviations.iter().map(|d| fixed(d.percent, d.decimals));
    let expanded = deviations.iter().map(|d| {
        let printed = d.uncertainty.map_or(0.0, |u| u.printed_percent);
        fixed(printed, d.decimals)
    });
    let factors = deviations
        .iter()
        .map(|d| factor(d.uncertainty.map_or(2.0, |u| u.coverage_factor)));
    Some(List {
        name: language.word("column.deviation"),
        ref_type: "vib_sensitivityMagnitudeDeviation",
        unit: r"\percent",
        values: values.collect(),
        uncertainties: Some((expanded.collect(), factors.collect())),
        conformity: Vec::new(),
    })
}

fn factor(coverage_factor: f64) -> String {
    format!("{coverage_factor:.2}")
}

/// A list without uncertainties: what was set, not what was measured.
fn plain<'a>(
    name: &'a str,
    ref_type: &'a str,
    unit: &'a str,
    points: &[Measured<'_>],
    value: impl Fn(&Point) -> String,
) -> List<'a> {
    List {
        name,
        ref_type,
        unit,
        values: points.iter().map(|(point, _)| value(point)).collect(),
        uncertainties: None,
        conformity: Vec::new(),
    }
}

fn write_list(xml: &mut Xml, certificate: &Certificate, language: Language, list: &List<'_>) {
    xml.with("dcc:quantity", &[("refType", list.ref_type)], |xml| {
        xml.content("dcc:name", language.code(), list.name);
        xml.element("si:realListXMLList", |xml| {
            xml.leaf("si:valueXMLList", &list.values.join(" "));
            xml.leaf("si:unitXMLList", list.unit);
            if let Some((expanded, factors)) = &list.uncertainties {
                uncertainties(xml, expanded, factors);
            }
        });
        if !list.conformity.is_empty() {
            conformity(xml, certificate, &list.conformity, language);
        }
    });
}

fn uncertainties(xml: &mut Xml, expanded: &[String], factors: &[String]) {
    let probability = format!("{PROBABILITY_K2:.4}");
    xml.element("si:measurementUncertaintyUnivariateXMLList", |xml| {
        xml.element("si:expandedMUXMLList", |xml| {
            xml.leaf("si:valueExpandedMUXMLList", &expanded.join(" "));
            xml.leaf("si:coverageFactorXMLList", &factors.join(" "));
            xml.leaf(
                "si:coverageProbabilityXMLList",
                &vec![probability; expanded.len()].join(" "),
            );
        });
    });
}

/// Conformity per point.
fn conformity(xml: &mut Xml, certificate: &Certificate, statuses: &[&str], language: Language) {
    let said = |key| stated(certificate, "decision", key, language);
    let text = format!("{}; {}", said("specification"), said("rule"));
    xml.element("dcc:measurementMetaData", |xml| {
        xml.with("dcc:metaData", &[("refType", "basic_conformity")], |xml| {
            xml.content("dcc:declaration", language.code(), &text);
            xml.leaf("dcc:conformityXMLList", &statuses.join(" "));
        });
    });
}

/// A conformity as the digital calibration certificate spells it.
fn spelled(conformity: Conformity) -> &'static str {
    match conformity {
        Conformity::Pass => "pass",
        Conformity::ConditionalPass => "conditionalPass",
        Conformity::ConditionalFail => "conditionalFail",
        Conformity::NotJudgeable => "notJudgeable",
        Conformity::Fail => "fail",
    }
}
