//! Searches calib-core as it is in the image, the code that silences the exciter, and
//! everything they call, contains no panic.
//!
//! Reads the image's functions and follows every branch from one to another
//! (ARM DDI 0403, A7.7.12 and A7.7.18). Functions of the core that the compiler
//! merged into a task are not seen: the task is not held to this.

use anyhow::{Context, Result, bail};
use object::{Object, ObjectSection, ObjectSymbol, SymbolKind};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// Names, as the linker has them, that only a panic calls.
const PANICS: [&str; 4] = [
    "panicking",
    "unwrap_failed",
    "expect_failed",
    "slice_index_fail",
];
/// Crate whose functions must not panic; other crates' generics that merely
/// name one of its types carry their own crate's name first.
const CRATE: &str = "calib_core";

/// Code that brings the exciter to rest, in a fault and in a run, as the linker has
/// it: the length of a name, and the name.
const SILENCE: [&str; 2] = ["11silence_now", "4hush"];

/// Prefix the linker gives the name of a function that is reached from afar, from tightly coupled memory
/// or into it, by a few instructions that load its address.
const FROM_AFAR: &str = "__Thumbv7ABSLongThunk_";

/// A function of the image.
struct Function<'a> {
    name: &'a str,
    code: &'a [u8],
}

/// Functions by address.
type Functions<'a> = BTreeMap<u32, Function<'a>>;

/// Fails with the way from a function of the core, or from one that silences the
/// exciter, to a panic, if there is one.
pub(crate) fn check(image: &Path) -> Result<()> {
    let elf = std::fs::read(image).with_context(|| format!("cannot read {}", image.display()))?;
    let functions = functions(&elf).context("the image is no ELF file with symbols")?;
    let mut roots = 0;
    let mut silencing: BTreeSet<&str> = BTreeSet::new();
    for (address, function) in &functions {
        let silences = SILENCE.iter().find(|name| function.name.ends_with(**name));
        silencing.extend(silences);
        if silences.is_none() && !is_of_core(function.name) {
            continue;
        }
        roots += 1;
        if let Some(way) = way_to_panic(&functions, *address) {
            bail!("this can panic: {}", way.join(" -> "));
        }
    }
    if silencing.len() < SILENCE.len() {
        bail!("of what silences the exciter only {silencing:?} is in the image");
    }
    if roots < 8 {
        bail!("only {roots} functions of calib-core in the image: nothing was shown");
    }
    eprintln!("no panic in {roots} functions of calib-core and the silencing, and what they call");
    Ok(())
}

/// The first path of a mangled name is the crate the function is from.
fn is_of_core(name: &str) -> bool {
    let first = [
        "calib_core",
        "calib_protocol",
        "calib_firmware",
        "embassy",
        "sequential_storage",
    ]
    .into_iter()
    .filter_map(|krate| name.find(krate).map(|at| (at, krate)))
    .min();
    name.starts_with("_") && first.is_some_and(|(_, krate)| krate == CRATE)
}

/// Names on the way from `root` to a panic.
fn way_to_panic<'a>(functions: &Functions<'a>, root: u32) -> Option<Vec<&'a str>> {
    let mut came_from = BTreeMap::from([(root, root)]);
    let mut open = vec![root];
    while let Some(address) = open.pop() {
        let function = functions.get(&address)?;
        if PANICS.iter().any(|panic| function.name.contains(panic)) {
            let mut way = vec![function.name];
            let mut at = address;
            while at != root {
                at = came_from[&at];
                way.insert(0, functions[&at].name);
            }
            return Some(way);
        }
        let near = branches(address, function.code).into_iter();
        for target in near.chain(reached_from_afar(functions, function.name)) {
            if functions.contains_key(&target) && !came_from.contains_key(&target) {
                came_from.insert(target, address);
                open.push(target);
            }
        }
    }
    None
}

/// The function behind a long way to it.
fn reached_from_afar(functions: &Functions<'_>, way: &str) -> Option<u32> {
    let name = way.strip_prefix(FROM_AFAR)?;
    let mut all = functions.iter();
    all.find(|(_, function)| function.name == name)
        .map(|(address, _)| *address)
}

/// Targets of `BL` and wide `B` in a function. A constant between instructions
/// may look like one: then its target is hardly ever the start of a function.
fn branches(address: u32, code: &[u8]) -> BTreeSet<u32> {
    let (halfwords, _) = code.as_chunks::<2>();
    let halfwords: Vec<u32> = halfwords
        .iter()
        .map(|bytes| u32::from(u16::from_le_bytes(*bytes)))
        .collect();
    let mut targets = BTreeSet::new();
    let mut place = 0;
    while place < halfwords.len() {
        let first = halfwords[place];
        if first >> 11 < 0b11101 {
            place += 1;
            continue;
        }
        if let Some(second) = halfwords.get(place + 1) {
            let here = address + 2 * place as u32;
            targets.extend(branch(here, first, *second));
        }
        place += 2;
    }
    targets
}

/// Target of the 32-bit instruction at `here` if it is `BL` or `B` (encoding T4).
fn branch(here: u32, first: u32, second: u32) -> Option<u32> {
    if first >> 11 != 0b11110 || second & 0x9000 != 0x9000 {
        return None;
    }
    let bit = |value: u32, at: u32| value >> at & 1;
    let sign = bit(first, 10);
    let (i1, i2) = (1 ^ bit(second, 13) ^ sign, 1 ^ bit(second, 11) ^ sign);
    let offset = sign << 24 | i1 << 23 | i2 << 22 | (first & 0x3FF) << 12 | (second & 0x7FF) << 1;
    // Sign extension from 25 bits.
    let offset = (offset << 7) as i32 >> 7;
    Some(here.wrapping_add(4).wrapping_add_signed(offset))
}

/// Functions by the symbol table, with their instructions.
fn functions(elf: &[u8]) -> object::Result<Functions<'_>> {
    let file = object::File::parse(elf)?;
    let mut found = Functions::new();
    for symbol in file.symbols() {
        if symbol.kind() != SymbolKind::Text || symbol.size() == 0 {
            continue;
        }
        // The lowest bit of an address says that the code is Thumb.
        let address = symbol.address() & !1;
        let code = match symbol.section_index() {
            Some(section) => file
                .section_by_index(section)?
                .data_range(address, symbol.size())?,
            None => None,
        };
        let function = Function {
            name: symbol.name()?,
            code: code.unwrap_or_default(),
        };
        found.insert(address as u32, function);
    }
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn branches_go_where_the_manual_says() {
        // By hand: BL with offset 0 is F000 F800 and goes to the next instruction but one half.
        assert_eq!(branch(0x100, 0xF000, 0xF800), Some(0x104));
        assert_eq!(branch(0x100, 0xF000, 0xF802), Some(0x108));
        // Offset -4: the instruction itself.
        assert_eq!(branch(0x100, 0xF7FF, 0xFFFE), Some(0x100));
        // B.W, and a load, which is no branch.
        assert_eq!(branch(0x100, 0xF000, 0xB802), Some(0x108));
        assert_eq!(branch(0x100, 0xF8DF, 0x0004), None);
    }

    /// From 0x100 by BL to the long way at 0x104, which leads to a function that panics.
    #[test]
    fn a_long_way_is_followed() {
        let call = [0x00, 0xF0, 0x00, 0xF8];
        let function = |name, code| Function { name, code };
        let functions = Functions::from([
            (0x100, function("_Rcaller", call.as_slice())),
            (0x104, function("__Thumbv7ABSLongThunk__Rcallee", &[])),
            (0x800_0100, function("_Rcallee", call.as_slice())),
            (0x800_0104, function("_Rpanicking", &[])),
        ]);
        let way = way_to_panic(&functions, 0x100).map(|way| way.len());
        assert_eq!(way, Some(4));
    }

    #[test]
    fn a_function_belongs_to_the_crate_it_is_from() {
        assert!(is_of_core("_RNvMs_Cs1_10calib_core4tone3run"));
        assert!(!is_of_core("_RNvMs_Cs1_14calib_firmware4link10calib_core"));
        assert!(!is_of_core("memcpy"));
    }
}
