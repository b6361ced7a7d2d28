//! The bill of materials against the netlists.

use super::folder;
use crate::rigged::Fault;
use std::collections::BTreeMap;

/// Netlists of the circuit itself.
const CIRCUIT: [&str; 4] = ["input.cir", "dither.cir", "drive.cir", "iepe.cir"];

fn read(file: &str) -> Result<String, Fault> {
    Ok(std::fs::read_to_string(folder().join(file))?)
}

/// Reference and value of every resistor and capacitor of a netlist.
fn parts(netlist: &str) -> Result<Vec<(String, String)>, Fault> {
    let text = read(netlist)?;
    let part = |line: &str| {
        let words: Vec<&str> = line.split_whitespace().collect();
        match words.as_slice() {
            // The contacts of the relay are `rk...`: no parts of their own.
            [name, _, _, value] if name.starts_with(['r', 'c']) && !name.starts_with("rk") => {
                Some((name.to_uppercase(), (*value).to_owned()))
            }
            _ => None,
        }
    };
    Ok(text.lines().filter_map(part).collect())
}

/// Lines of the bill by their reference: value and tolerance.
fn bill() -> Result<BTreeMap<String, (String, String)>, Fault> {
    let text = read("bom.csv")?;
    let line = |line: &str| {
        let columns: Vec<&str> = line.splitn(5, ',').collect();
        let [reference, _, value, tolerance, _] = columns.as_slice() else {
            return None;
        };
        let named = ((*value).to_owned(), (*tolerance).to_owned());
        Some(((*reference).to_owned(), named))
    };
    Ok(text.lines().skip(1).filter_map(line).collect())
}

#[test]
fn the_bill_of_materials_is_that_of_the_netlists() -> Result<(), Fault> {
    let bill = bill()?;
    let mut seen = Vec::new();
    for netlist in CIRCUIT {
        for (reference, value) in parts(netlist)? {
            let named = bill.get(&reference).map(|(value, _)| value);
            assert_eq!(named, Some(&value), "{reference} of {netlist}");
            seen.push(reference);
        }
    }
    // Nothing passive in the bill that no netlist has, but what blocks the supplies.
    let passive = |reference: &&String| reference.starts_with(['R', 'C']);
    let extra: Vec<_> = bill
        .keys()
        .filter(passive)
        .filter(|reference| !seen.contains(reference))
        .collect();
    assert_eq!(extra, ["C51", "C52"]);
    Ok(())
}

/// The tolerances `spread.cir` draws from are those that are ordered.
#[test]
fn what_is_drawn_is_what_is_ordered() -> Result<(), Fault> {
    for (reference, (_, tolerance)) in bill()? {
        let number = reference.get(1..).and_then(|digits| digits.parse().ok());
        let expected = match (reference.chars().next(), number) {
            (Some('R'), Some(1..=9 | 43)) => "0.1",
            (Some('C'), Some(1..=7)) => "1",
            (Some('C'), Some(41 | 61 | 62)) => "5",
            (Some('R'), Some(61 | 62)) => "1",
            _ => continue,
        };
        assert_eq!(tolerance, expected, "{reference}");
    }
    Ok(())
}

#[test]
fn the_drawing_shows_every_part_with_its_value() -> Result<(), Fault> {
    let drawing = read("front-end.svg")?;
    for netlist in CIRCUIT {
        for (reference, value) in parts(netlist)? {
            let value = value.replace("meg", "M");
            let together = drawing.contains(&format!(">{reference} {value}<"));
            let apart = drawing.contains(&format!(">{reference}<"))
                && drawing.contains(&format!(">{value}<"));
            assert!(together || apart, "{reference} {value}");
        }
    }
    Ok(())
}
