//! A digital calibration certificate, PTB's DCC 3.x: whose it is, and its lists over frequency.
//!
//! Entities are not read (`roxmltree` refuses a document type), and no more than [`MOST_NODES`] elements.

use super::certified::{Certified, CertifiedPoint, Placed, Reading, checked, not_rising};
use super::dsi::{Kind, Unit};
use crate::input::Source;
use calib_files::{Error, Result};
use jiff::civil::Date;
use roxmltree::{Document, Node, ParsingOptions};

const DCC: &str = "https://ptb.de/dcc";
/// Words of this tool's own certificates where nothing was stated and the schema wants a word.
const NOT_STATED: [&str; 2] = ["not stated", "nicht angegeben"];
const MOST_NODES: u32 = 200_000;
const HINT: &str = "ask the laboratory for a DCC of schema 3 with one object, or write a CSV";

/// A list over frequency with its uncertainties.
struct List {
    values: Vec<Placed>,
    /// Expanded uncertainties, as large as the values, and coverage factors.
    expanded: Option<(Vec<f64>, Vec<f64>)>,
}

pub(super) fn read(source: &Source, reading: &Reading) -> Result<Certified> {
    let options = ParsingOptions {
        nodes_limit: MOST_NODES,
        ..ParsingOptions::default()
    };
    let document = Document::parse_with_options(&source.text, options).map_err(|error| {
        let line = usize::try_from(error.pos().row).unwrap_or(1);
        source.at_line(line, format!("no XML that can be read: {error}"), HINT)
    })?;
    let reader = Reader { source };
    let root = document.root_element();
    if root.tag_name().name() != "digitalCalibrationCertificate"
        || root.tag_name().namespace() != Some(DCC)
    {
        return Err(reader.at(root, "is XML, and no DCC"));
    }
    let item = reader.item(root)?;
    let (points, lines) = reader.points(root, reading)?;
    checked(source, &points, &lines)?;
    let core = only(root, &["administrativeData", "coreData"]);
    let said = |node: Option<Node<'_, '_>>, name| node.and_then(|node| words(node, &[name]));
    let calibrated = said(core, "endPerformanceDate");
    Ok(Certified {
        serial: serial(item),
        model: model(item),
        certificate: said(core, "uniqueIdentifier"),
        laboratory: words(
            root,
            &[
                "administrativeData",
                "calibrationLaboratory",
                "contact",
                "name",
                "content",
            ],
        ),
        calibrated: calibrated
            .map(|day| reader.day(core.unwrap_or(root), &day))
            .transpose()?,
        due: None,
        traceability: traceability(root),
        equipment: equipment(root),
        points,
    })
}

struct Reader<'a> {
    source: &'a Source,
}

impl Reader<'_> {
    fn line(&self, node: Node<'_, '_>) -> usize {
        let row = node.document().text_pos_at(node.range().start).row;
        usize::try_from(row).unwrap_or(1)
    }

    fn at(&self, node: Node<'_, '_>, problem: impl Into<String>) -> Error {
        self.source.at_line(self.line(node), problem, HINT)
    }

    fn day(&self, node: Node<'_, '_>, text: &str) -> Result<Date> {
        // A day of XML Schema may have a time zone.
        let day = text.get(..10).unwrap_or(text);
        day.parse()
            .map_err(|_| self.at(node, format!("'{text}' is no day")))
    }

    /// The one object it is about.
    fn item<'a, 'b>(&self, root: Node<'a, 'b>) -> Result<Node<'a, 'b>> {
        let items = only(root, &["administrativeData", "items"]);
        let items = items.ok_or_else(|| self.at(root, "names no object"))?;
        let mut all = items
            .children()
            .filter(|node| node.tag_name().name() == "item");
        match (all.next(), all.next()) {
            (Some(item), None) => Ok(item),
            (Some(_), Some(second)) => Err(self.at(
                second,
                "is about more than one object: nothing says which results are of which",
            )),
            _ => Err(self.at(items, "names no object")),
        }
    }

    /// Points of all results wanted, in rising frequency, and the lines they stand in.
    fn points(
        &self,
        root: Node<'_, '_>,
        reading: &Reading,
    ) -> Result<(Vec<CertifiedPoint>, Vec<usize>)> {
        let results = root
            .descendants()
            .filter(|node| node.tag_name().name() == "result");
        let wanted = |result: &Node<'_, '_>| {
            let name = words(*result, &["name", "content"]).unwrap_or_default();
            reading
                .result
                .as_ref()
                .is_none_or(|part| name.contains(part.as_str()))
        };
        let mut found: Vec<(CertifiedPoint, usize)> = Vec::new();
        for result in results.filter(wanted) {
            let lists = result
                .descendants()
                .filter(|node| node.tag_name().name() == "list");
            for list in lists {
                found.extend(self.of_list(list)?);
            }
        }
        if found.is_empty() {
            return Err(self.at(
                root,
                "has no list of sensitivities over frequency in V/(m/s2)",
            ));
        }
        // Of one list the order is as it stands; several lists are put together.
        found.sort_by(|(a, _), (b, _)| a.frequency_hz.total_cmp(&b.frequency_hz));
        Ok(found.into_iter().unzip())
    }

    /// Points of one list of quantities; none when it has no frequencies or no sensitivities.
    fn of_list(&self, list: Node<'_, '_>) -> Result<Vec<(CertifiedPoint, usize)>> {
        let mut quantities = Vec::new();
        for quantity in list
            .children()
            .filter(|node| node.tag_name().name() == "quantity")
        {
            quantities.extend(self.quantity(quantity)?);
        }
        let mut of = |kind: Kind, ref_type: &str| {
            let is = |(found, named, _): &(Kind, String, List)| {
                *found == kind && named.contains(ref_type)
            };
            let at = quantities.iter().position(is);
            let at = at.or_else(|| quantities.iter().position(|(found, ..)| *found == kind));
            at.map(|at| quantities.remove(at).2)
        };
        let (Some(frequencies), Some(magnitudes)) = (
            of(Kind::Frequency, "vib_frequency"),
            of(Kind::Sensitivity, "vib_sensitivityMagnitude"),
        ) else {
            return match quantities
                .iter()
                .find(|(kind, ..)| matches!(kind, Kind::Charge | Kind::OtherMotion))
            {
                Some((Kind::Charge, ..)) => Err(self.at(
                    list,
                    "is of charge: the settings hold reference and conditioner as one, in V/(m/s2)",
                )),
                Some(_) => Err(self.at(
                    list,
                    "is of a velocity or displacement: the reference measures acceleration",
                )),
                None => Ok(Vec::new()),
            };
        };
        let phases = of(Kind::Angle, "vib_sensitivityPhase");
        self.rising(&frequencies)?;
        self.same_length(list, &frequencies, &magnitudes)?;
        if let Some(phases) = &phases {
            self.same_length(list, &frequencies, phases)?;
        }
        let point = |at: usize| self.point(list, at, &frequencies, &magnitudes, phases.as_ref());
        (0..frequencies.values.len()).map(point).collect()
    }

    fn rising(&self, frequencies: &List) -> Result<()> {
        let mut pairs = frequencies.values.windows(2);
        match pairs.find(|pair| pair[1].value <= pair[0].value) {
            None => Ok(()),
            Some(pair) => {
                let both_hz = [pair[0].value, pair[1].value];
                Err(not_rising(self.source, pair[1].line, both_hz, HINT))
            }
        }
    }

    fn same_length(&self, node: Node<'_, '_>, frequencies: &List, list: &List) -> Result<()> {
        let (wanted, found) = (frequencies.values.len(), list.values.len());
        match wanted == found {
            true => Ok(()),
            false => Err(self.at(
                node,
                format!("{wanted} frequencies, and {found} values of one quantity"),
            )),
        }
    }

    fn point(
        &self,
        node: Node<'_, '_>,
        at: usize,
        frequencies: &List,
        magnitudes: &List,
        phases: Option<&List>,
    ) -> Result<(CertifiedPoint, usize)> {
        let (frequency, magnitude) = (frequencies.values[at], magnitudes.values[at]);
        let (u, k) = magnitudes.expanded.as_ref().ok_or_else(|| {
            self.at(
                node,
                "the sensitivities have no expanded uncertainties with coverage factors",
            )
        })?;
        let phase = phases.map(|list| {
            let (u, k) = list.expanded.as_ref().ok_or_else(|| {
                self.at(
                    node,
                    "the phases have no expanded uncertainties with coverage factors",
                )
            })?;
            Ok((list.values[at].value, u[at], k[at]))
        });
        let phase: Option<(f64, f64, f64)> = phase.transpose()?;
        let point = CertifiedPoint {
            frequency_hz: frequency.value,
            sensitivity_v_per_ms2: magnitude.value,
            expanded_uncertainty_rel: u[at] / magnitude.value,
            coverage_factor: k[at],
            phase_rad: phase.map(|(phase, ..)| phase),
            expanded_uncertainty_phase_rad: phase.map(|(_, u, _)| u),
            coverage_factor_phase: phase.map(|(.., k)| k),
        };
        Ok((point, frequency.line))
    }

    /// A quantity that is a list of numbers in a unit that is known: what it is, what it is called, its list.
    fn quantity(&self, quantity: Node<'_, '_>) -> Result<Option<(Kind, String, List)>> {
        let named = quantity.attribute("refType").unwrap_or_default().to_owned();
        let mut unknown = None;
        let lists = quantity
            .descendants()
            .filter(|node| node.tag_name().name() == "realListXMLList");
        for list in lists {
            let unit = words(list, &["unitXMLList"]).unwrap_or_default();
            match Unit::parse(&unit).and_then(|unit| Some((unit, unit.kind()?))) {
                Some((unit, kind)) => {
                    return Ok(Some((kind, named, self.list(list, unit.factor)?)));
                }
                None => unknown = Some((list, unit)),
            }
        }
        match unknown {
            Some((list, unit)) if named.contains("sensitivity") || named.contains("frequency") => {
                Err(self.at(
                    list,
                    format!("'{unit}' is no unit of {named} that is known"),
                ))
            }
            _ => Ok(None),
        }
    }

    fn list(&self, list: Node<'_, '_>, factor: f64) -> Result<List> {
        let values =
            only(list, &["valueXMLList"]).ok_or_else(|| self.at(list, "a list without values"))?;
        let line = self.line(values);
        let scaled = |numbers: Vec<f64>| {
            numbers
                .into_iter()
                .map(|value| value * factor)
                .collect::<Vec<_>>()
        };
        let values = scaled(self.numbers(values)?);
        let expanded = self.expanded(list, values.len())?;
        let values = values.into_iter().map(|value| Placed { value, line });
        Ok(List {
            values: values.collect(),
            expanded: expanded.map(|(u, k)| (scaled(u), k)),
        })
    }

    /// Expanded uncertainties and coverage factors, by the names of D-SI 2.2 or of those before.
    fn expanded(&self, list: Node<'_, '_>, count: usize) -> Result<Option<(Vec<f64>, Vec<f64>)>> {
        let find = |names: [&str; 2]| {
            let mut all = list.descendants();
            all.find(|node| names.contains(&node.tag_name().name()))
        };
        let Some(u) = find(["valueExpandedMUXMLList", "uncertaintyXMLList"]) else {
            return Ok(None);
        };
        let k = find(["coverageFactorXMLList", "kXMLList"]);
        let k = k.ok_or_else(|| self.at(u, "expanded uncertainties without a coverage factor"))?;
        let counted = |node: Node<'_, '_>, what: &str| {
            let numbers = self.numbers(node)?;
            match numbers[..] {
                [one] => Ok(vec![one; count]),
                _ if numbers.len() == count => Ok(numbers),
                _ => Err(self.at(node, format!("{} {what} for {count} values", numbers.len()))),
            }
        };
        Ok(Some((
            counted(u, "uncertainties")?,
            counted(k, "coverage factors")?,
        )))
    }

    fn numbers(&self, node: Node<'_, '_>) -> Result<Vec<f64>> {
        let number = |word: &str| {
            let value = word.parse().ok().filter(|value: &f64| value.is_finite());
            value.ok_or_else(|| {
                self.at(
                    node,
                    format!("'{word}' is no finite number with a decimal point"),
                )
            })
        };
        let numbers: Vec<f64> = node
            .text()
            .unwrap_or_default()
            .split_whitespace()
            .map(number)
            .collect::<Result<_>>()?;
        match numbers.is_empty() {
            true => Err(self.at(node, "a list without numbers")),
            false => Ok(numbers),
        }
    }
}

/// The element at this path, the first at each step.
fn only<'a, 'b>(node: Node<'a, 'b>, path: &[&str]) -> Option<Node<'a, 'b>> {
    path.iter().try_fold(node, |node, name| {
        node.children()
            .find(|child| child.tag_name().name() == *name)
    })
}

/// Text of the element at this path.
fn words(node: Node<'_, '_>, path: &[&str]) -> Option<String> {
    let text = only(node, path)?.text()?.trim();
    let stated = !text.is_empty() && !NOT_STATED.contains(&text);
    stated.then(|| text.to_owned())
}

fn model(item: Node<'_, '_>) -> Option<String> {
    let parts = [
        words(item, &["manufacturer", "name", "content"]),
        words(item, &["model"]),
    ];
    let parts: Vec<String> = parts.into_iter().flatten().collect();
    (!parts.is_empty()).then(|| parts.join(" "))
}

/// The manufacturer's identification, else the first.
fn serial(item: Node<'_, '_>) -> Option<String> {
    let all = only(item, &["identifications"])?;
    let all: Vec<_> = all
        .children()
        .filter(|node| node.tag_name().name() == "identification")
        .collect();
    let of_maker = |node: &&Node<'_, '_>| {
        words(**node, &["issuer"]).is_some_and(|issuer| issuer == "manufacturer")
    };
    let one = all.iter().find(of_maker).or_else(|| all.first())?;
    words(*one, &["value"])
}

/// The declaration of the statement that says it is traceable.
fn traceability(root: Node<'_, '_>) -> Option<String> {
    let mut statements = root
        .descendants()
        .filter(|node| node.tag_name().name() == "statement");
    let stated = statements.find(|node| {
        words(*node, &["traceable"]).is_some_and(|said| said == "true" || said == "1")
    })?;
    Some(words(stated, &["declaration", "content"]).unwrap_or_else(|| "traceable".to_owned()))
}

fn equipment(root: Node<'_, '_>) -> Vec<String> {
    let all = root
        .descendants()
        .filter(|node| node.tag_name().name() == "measuringEquipment");
    all.filter_map(|one| words(one, &["identifications", "identification", "value"]))
        .collect()
}
