//! What calib-core became in the image, what silences the exciter, and
//! everything they call, contains no panic.
//!
//! Reads the image's functions and follows every branch from one to another
//! (ARM DDI 0403, A7.7.12 and A7.7.18). Functions of the core that the compiler
//! merged into a task are not seen: the task is not held to this.

use anyhow::{Context, Result, bail};
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

/// What brings the exciter to rest, in a fault and in a run, as the linker has
/// it: the length of a name, and the name.
const SILENCE: [&str; 2] = ["11silence_now", "4hush"];

/// A function of the image.
struct Function {
    name: String,
    size: u32,
}

/// Functions by address.
type Functions = BTreeMap<u32, Function>;

/// Fails with the way from a function of the core, or from one that silences the
/// exciter, to a panic, if there is one.
pub(crate) fn check(image: &Path) -> Result<()> {
    let elf = std::fs::read(image).with_context(|| format!("cannot read {}", image.display()))?;
    let malformed = "the image is no 32-bit little-endian ELF file with symbols";
    let functions = functions(&elf).context(malformed)?;
    let mut roots = 0;
    let mut silencing: BTreeSet<&str> = BTreeSet::new();
    for (address, function) in &functions {
        let silences = SILENCE.iter().find(|name| function.name.ends_with(**name));
        silencing.extend(silences);
        if silences.is_none() && !is_of_core(&function.name) {
            continue;
        }
        roots += 1;
        if let Some(way) = way_to_panic(&elf, &functions, *address) {
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
fn way_to_panic(elf: &[u8], functions: &Functions, root: u32) -> Option<Vec<String>> {
    let mut came_from = BTreeMap::from([(root, root)]);
    let mut open = vec![root];
    while let Some(address) = open.pop() {
        let function = functions.get(&address)?;
        if PANICS.iter().any(|panic| function.name.contains(panic)) {
            let mut way = vec![function.name.clone()];
            let mut at = address;
            while at != root {
                at = came_from[&at];
                way.insert(0, functions[&at].name.clone());
            }
            return Some(way);
        }
        for target in branches(elf, address, function.size) {
            if functions.contains_key(&target) && !came_from.contains_key(&target) {
                came_from.insert(target, address);
                open.push(target);
            }
        }
    }
    None
}

/// Targets of `BL` and wide `B` in a function. A constant between instructions
/// may look like one: then its target is hardly ever the start of a function.
fn branches(elf: &[u8], address: u32, size: u32) -> BTreeSet<u32> {
    let code = bytes_at(elf, address, size).unwrap_or_default();
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

fn word(elf: &[u8], at: usize) -> Option<u32> {
    Some(u32::from_le_bytes(elf.get(at..at + 4)?.try_into().ok()?))
}

/// Section headers: (type, address, offset, size, link).
fn sections(elf: &[u8]) -> Option<Vec<[u32; 5]>> {
    let half = |at: usize| Some(u16::from_le_bytes(elf.get(at..at + 2)?.try_into().ok()?));
    if elf.get(..6)? != b"\x7fELF\x01\x01" {
        return None;
    }
    let (table, entry, count) = (word(elf, 0x20)? as usize, half(0x2e)?, half(0x30)?);
    (0..usize::from(count))
        .map(|index| {
            let at = table + usize::from(entry) * index;
            let mut fields = [0; 5];
            for (field, offset) in fields.iter_mut().zip([4, 12, 16, 20, 24]) {
                *field = word(elf, at + offset)?;
            }
            Some(fields)
        })
        .collect()
}

/// Bytes of the image at an address of the board.
fn bytes_at(elf: &[u8], address: u32, size: u32) -> Option<&[u8]> {
    const PROGBITS: u32 = 1;
    sections(elf)?
        .into_iter()
        .find_map(|[kind, start, offset, length, _]| {
            let into = address.checked_sub(start)?;
            if kind != PROGBITS || start == 0 || into + size > length {
                return None;
            }
            let at = (offset + into) as usize;
            elf.get(at..at + size as usize)
        })
}

/// Functions by the symbol table.
fn functions(elf: &[u8]) -> Option<Functions> {
    const SYMBOLS: u32 = 2;
    const FUNCTION: u8 = 2;
    let sections = sections(elf)?;
    let [_, _, offset, length, link] = *sections.iter().find(|section| section[0] == SYMBOLS)?;
    let names = sections.get(link as usize)?[2];
    let mut found = Functions::new();
    for at in (offset as usize..(offset + length) as usize).step_by(16) {
        let (address, size) = (word(elf, at + 4)?, word(elf, at + 8)?);
        if elf.get(at + 12)? & 0xF != FUNCTION || size == 0 {
            continue;
        }
        let start = (names + word(elf, at)?) as usize;
        let name = elf.get(start..)?.split(|byte| *byte == 0).next()?;
        let name = String::from_utf8_lossy(name).into_owned();
        // The lowest bit of an address says that the code is Thumb.
        found.insert(address & !1, Function { name, size });
    }
    Some(found)
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

    #[test]
    fn a_function_belongs_to_the_crate_it_is_from() {
        assert!(is_of_core("_RNvMs_Cs1_10calib_core4tone3run"));
        assert!(!is_of_core("_RNvMs_Cs1_14calib_firmware4link10calib_core"));
        assert!(!is_of_core("memcpy"));
    }
}
