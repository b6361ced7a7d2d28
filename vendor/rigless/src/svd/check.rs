// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! What must hold before anything is written: no overlaps but declared alternates, each sharing
//! addresses with the instance it names, and every name a distinct Rust identifier.

use std::collections::BTreeMap;

use crate::soc::Extent;
use crate::svd::Error;
use crate::svd::emit::{module_name, static_name, variant_name};
use crate::svd::model::{Instance, Model, Register};

const RESERVED_STATICS: [&str; 2] = ["CPU", "PERIPHERALS"];

pub(crate) fn check(model: &Model) -> Result<(), Error> {
    for instance in &model.instances {
        let Some(named) = &instance.alternate else {
            continue;
        };
        let shared = model
            .instances
            .iter()
            .any(|other| other.name == *named && extent(other).overlaps(&extent(instance)));
        if !shared {
            return Err(Error::UnsharedAlternate {
                instance: instance.name.clone(),
                alternate: named.clone(),
            });
        }
    }
    let exclusive: Vec<&Instance> = model
        .instances
        .iter()
        .filter(|instance| instance.alternate.is_none())
        .collect();
    for pair in exclusive.windows(2) {
        let (lower, upper) = (pair[0], pair[1]);
        if upper.base < lower.base.saturating_add(lower.size) {
            return Err(Error::OverlappingInstances {
                lower: lower.name.clone(),
                upper: upper.name.clone(),
            });
        }
    }
    for (layout, registers) in &model.layouts {
        if let Some((lower, upper)) = first_undeclared_overlap(registers) {
            return Err(Error::OverlappingRegisters {
                lower: format!("{layout}.{}", lower.name),
                upper: format!("{layout}.{}", upper.name),
            });
        }
    }
    distinct(
        model
            .layouts
            .keys()
            .map(|layout| (module_name(layout), layout.as_str())),
    )?;
    distinct(
        RESERVED_STATICS
            .into_iter()
            .map(|reserved| (reserved.to_owned(), reserved))
            .chain(
                model
                    .instances
                    .iter()
                    .map(|instance| (static_name(&instance.name), instance.name.as_str())),
            ),
    )?;
    for registers in model.layouts.values() {
        distinct(
            registers
                .iter()
                .map(|register| (variant_name(&register.name), register.name.as_str())),
        )?;
        distinct(
            registers
                .iter()
                .map(|register| (module_name(&register.name), register.name.as_str())),
        )?;
        for register in registers {
            distinct(
                register
                    .fields
                    .iter()
                    .map(|field| (static_name(&field.name), field.name.as_str())),
            )?;
        }
    }
    Ok(())
}

fn extent(instance: &Instance) -> Extent<&str> {
    Extent {
        name: &instance.name,
        base: instance.base,
        size: instance.size,
    }
}

/// Two registers that share bytes without either being declared an alternate, in a table sorted by offset.
fn first_undeclared_overlap(registers: &[Register]) -> Option<(&Register, &Register)> {
    let mut furthest: Option<&Register> = None;
    for register in registers.iter().filter(|register| !register.alternate) {
        if let Some(earlier) = furthest.filter(|earlier| register.offset < earlier.end()) {
            return Some((earlier, register));
        }
        if furthest.is_none_or(|earlier| register.end() > earlier.end()) {
            furthest = Some(register);
        }
    }
    None
}

/// Fails when two names in a scope fold to one identifier.
fn distinct<'a>(names: impl Iterator<Item = (String, &'a str)>) -> Result<(), Error> {
    let mut seen: BTreeMap<String, &str> = BTreeMap::new();
    for (identifier, name) in names {
        if let Some(first) = seen.insert(identifier, name) {
            return Err(Error::NameCollision {
                first: first.to_owned(),
                second: name.to_owned(),
            });
        }
    }
    Ok(())
}
