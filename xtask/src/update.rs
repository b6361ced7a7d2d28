//! Updates: the image linked for both slots, signed, in one file; and the loader that starts them.

use crate::shell::VERSION;
use crate::{elf, program};
use anyhow::{Context, Result, bail};
use calib_boot::file;
use calib_boot::layout::Slot;
use calib_boot::manifest::{Manifest, Seed, Version, public_key, sign};
use calib_boot::trusted::DEVELOPMENT_SEED;
use object::Endianness;
use object::elf::{FileHeader32, PT_LOAD};
use object::read::elf::{FileHeader, ProgramHeader};
use std::fs;
use std::path::{Path, PathBuf};

/// Names a file with the secret half of the key that signs: 64 hexadecimal digits.
const KEY: &str = "CALIB_RELEASE_KEY";

/// Builds the image of a board for both slots, and writes the update of both.
pub(crate) fn build(board: Option<&str>) -> Result<PathBuf> {
    let seed = seed()?;
    let images = [elf::build_for_slot_b(board)?, elf::build_for(board)?];
    let [b, a] = images.each_ref().map(|path| flashed(path));
    let board = board.unwrap_or(elf::DEFAULT_BOARD);
    let mut update = file::MAGIC.to_vec();
    for (slot, image) in [(Slot::A, a?), (Slot::B, b?)] {
        update.extend(manifest(&image, slot, board, &seed)?);
        update.extend(image);
    }
    let path = images[1].with_file_name(format!("calib-{VERSION}-{board}.update"));
    fs::write(&path, update).with_context(|| format!("cannot write {}", path.display()))?;
    Ok(path)
}

/// Builds the loader that trusts the key updates are signed with.
pub(crate) fn build_loader() -> Result<PathBuf> {
    let key = public_key(&seed()?);
    elf::build_loader(&hex::encode(key))
}

/// Puts the loader and slot A on the board that is plugged in: once for an instrument, by the debug probe.
pub(crate) fn commission(board: Option<&str>) -> Result<()> {
    let update = fs::read(build(board)?)?;
    let loader = build_loader()?;
    let [a, _] = file::parts(&update).context("the update that was just made is none")?;
    let (image, manifest) = (
        loader.with_extension("a.bin"),
        loader.with_extension("a.manifest"),
    );
    fs::write(&image, a.image)?;
    fs::write(&manifest, a.manifest)?;
    let parts = [(image, Slot::A.start()), (manifest, Slot::A.manifest())];
    program::commission(&loader, &parts)
}

/// The key to sign with: that of a release, or the one everybody has.
fn seed() -> Result<Seed> {
    let Some(path) = std::env::var_os(KEY) else {
        eprintln!("signed with the DEVELOPMENT key, which everybody has: {KEY}=FILE names another");
        return Ok(DEVELOPMENT_SEED);
    };
    let path = Path::new(&path);
    let text =
        fs::read_to_string(path).with_context(|| format!("cannot read {}", path.display()))?;
    let bytes = hex::decode(text.trim()).ok();
    match bytes.and_then(|bytes| bytes.try_into().ok()) {
        Some(seed) => Ok(seed),
        None => bail!(
            "{} is no key: 64 hexadecimal digits, as `openssl rand -hex 32` writes them",
            path.display()
        ),
    }
}

fn manifest(image: &[u8], slot: Slot, board: &str, seed: &Seed) -> Result<[u8; 256]> {
    let version = Version::parse(VERSION).context("the version is not three numbers")?;
    let told = Manifest::of(image, slot, version, board);
    let told = told.context("the image is too long for its slot, or its board's name is")?;
    Ok(sign(&told, seed))
}

/// Bytes of an image in its slot, up to its last; gaps in between are as erased.
fn flashed(path: &Path) -> Result<Vec<u8>> {
    let bytes = fs::read(path).with_context(|| format!("cannot read {}", path.display()))?;
    let header = FileHeader32::<Endianness>::parse(&*bytes)?;
    let endian = header.endian()?;
    let mut image = Vec::new();
    let mut slot = None;
    for part in header.program_headers(endian, &*bytes)? {
        let address = part.p_paddr(endian);
        let data = part.data(endian, &*bytes).unwrap_or_default();
        let of = Slot::around(address).filter(|_| part.p_type(endian) == PT_LOAD);
        let (Some(of), false) = (of, data.is_empty()) else {
            continue;
        };
        let start = *slot.get_or_insert(of);
        let offset = (address - start.start()) as usize;
        image.resize(image.len().max(offset + data.len()), 0xFF);
        image[offset..offset + data.len()].copy_from_slice(data);
    }
    match image.is_empty() {
        true => bail!("{} has nothing in a slot", path.display()),
        false => Ok(image),
    }
}
