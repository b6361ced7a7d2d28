//! The firmware image: an ELF file, and the board it is for.

use std::num::NonZeroU64;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use object::{Object, ObjectSection, ObjectSymbol};
use rigless::cpu::armv7m::code_address;
use rigless::image::Image;
use rigless::symbols::Symbols;

use super::Error;
use crate::board::{INSTRUCTIONS_PER_S, Pins, Schematic, instructions_per_s};
use crate::rig_port::RigPort;

/// Environment variable that names the image to run.
const ELF_VARIABLE: &str = "CALIB_FIRMWARE_ELF";

/// Environment variable with the cycles the core takes for each instruction, for benches and tests as
/// they are: `3` for a core that waits for its flash. Without it, [`INSTRUCTIONS_PER_S`].
const CYCLES_VARIABLE: &str = "CALIB_CYCLES_PER_INSTRUCTION";

/// Where the image lies below the target directory once `cargo xtask elf` has built it.
const BUILT: &str = "thumbv7em-none-eabihf/firmware/calib-firmware";

/// A firmware image, read and checked.
#[derive(Debug, Clone)]
pub struct Firmware {
    path: PathBuf,
    image: Image,
    schematic: Arc<Schematic>,
    instructions_per_s: u64,
}

impl Firmware {
    /// Reads the image at `path`, which is for the NUCLEO-H743ZI2 until [`Firmware::on`] says otherwise.
    ///
    /// # Errors
    ///
    /// [`Error::NoImage`], [`Error::Unreadable`] or [`Error::NotAnImage`].
    pub fn read(path: &Path) -> Result<Self, Error> {
        if !path.is_file() {
            return Err(Error::NoImage {
                path: path.to_owned(),
            });
        }
        let bytes = std::fs::read(path).map_err(|source| Error::Unreadable {
            path: path.to_owned(),
            source,
        })?;
        Self::from_bytes(path, bytes)
    }

    /// An image that lies in memory already; `path` is what messages call it.
    ///
    /// # Errors
    ///
    /// [`Error::NotAnImage`].
    pub fn from_bytes(path: &Path, bytes: Vec<u8>) -> Result<Self, Error> {
        let image = Image::new(path, bytes, None).map_err(|error| Error::NotAnImage {
            path: path.to_owned(),
            reason: error.to_string(),
        })?;
        Ok(Self {
            path: path.to_owned(),
            image,
            schematic: Arc::new(Schematic::nucleo_h743zi2()),
            instructions_per_s: pace(),
        })
    }

    /// The image on another board.
    #[must_use]
    pub fn on(self, schematic: Schematic) -> Self {
        Self {
            schematic: Arc::new(schematic),
            ..self
        }
    }

    /// The image on a core that takes so many cycles for each instruction.
    #[must_use]
    pub fn at(self, cycles_per_instruction: NonZeroU64) -> Self {
        Self {
            instructions_per_s: instructions_per_s(cycles_per_instruction),
            ..self
        }
    }

    /// Pins of its board, with `rig` on the connectors.
    pub(super) fn pins(&self, rig: Box<dyn RigPort>) -> Pins {
        let mut pins = Pins::new(self.schematic(), rig);
        pins.instructions_per_s = self.instructions_per_s;
        pins
    }

    /// The board it is run on.
    #[must_use]
    pub fn schematic(&self) -> Arc<Schematic> {
        Arc::clone(&self.schematic)
    }

    /// The shipping image: what `CALIB_FIRMWARE_ELF` names, else where `cargo xtask elf` puts it.
    ///
    /// # Errors
    ///
    /// As [`Firmware::read`].
    pub fn shipping() -> Result<Self, Error> {
        Self::read(&shipping_path())
    }

    /// The file.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The file's bytes.
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        self.image.bytes()
    }

    /// Address of a function or variable.
    ///
    /// # Errors
    ///
    /// [`Error::NoSymbol`] when the image has no such name.
    pub fn symbol(&self, name: &str) -> Result<u64, Error> {
        Symbols::read(self.image.bytes(), code_address)
            .ok()
            .and_then(|symbols| symbols.get(name).ok())
            .ok_or_else(|| Error::NoSymbol(name.to_owned()))
    }

    /// Address of a function or variable of the Rust program by the end of its path, such as
    /// `["state", "MEASURE_ALIVE"]`.
    ///
    /// # Errors
    ///
    /// [`Error::NoSymbol`] when the image has no such name.
    pub fn symbol_at_path(&self, path: &[&str]) -> Result<u64, Error> {
        // In Rust's mangling (v0) each part of a path is its length and its name.
        let parts = path.iter().map(|part| format!("{}{part}", part.len()));
        let ending: String = parts.collect();
        let missing = || Error::NoSymbol(path.join("::"));
        let file = object::File::parse(self.image.bytes()).map_err(|_| missing())?;
        file.symbols()
            // What the linker adds to reach a function from afar has a name of its own before.
            .find(|symbol| {
                let named = |name: &str| name.starts_with("_R") && name.ends_with(&ending);
                symbol.name().is_ok_and(named)
            })
            .map(|symbol| code_address(symbol.address()))
            .ok_or_else(missing)
    }

    /// Size of a section of the file in bytes, and its content as far as the file has it.
    ///
    /// # Errors
    ///
    /// [`Error::NoSymbol`] when there is no such section.
    pub fn section(&self, name: &str) -> Result<(u64, Vec<u8>), Error> {
        let missing = || Error::NoSymbol(name.to_owned());
        let file = object::File::parse(self.image.bytes()).map_err(|_| missing())?;
        let section = file.section_by_name(name).ok_or_else(missing)?;
        let content = section.data().map_err(|_| missing())?;
        Ok((section.size(), content.to_vec()))
    }

    /// SHA-256 of the image and where it goes.
    pub(super) fn digest(&self) -> [u8; 32] {
        rigless::image::digest(std::slice::from_ref(&self.image), None)
    }

    pub(super) fn image(&self) -> &Image {
        &self.image
    }
}

/// Instructions of the core in a second.
fn pace() -> u64 {
    let cycles = std::env::var(CYCLES_VARIABLE).ok();
    let cycles = cycles.and_then(|cycles| cycles.parse().ok());
    cycles.map_or(INSTRUCTIONS_PER_S, instructions_per_s)
}

fn shipping_path() -> PathBuf {
    if let Some(path) = std::env::var_os(ELF_VARIABLE) {
        return PathBuf::from(path);
    }
    let target = std::env::var_os("CARGO_TARGET_DIR").map_or_else(
        || Path::new(env!("CARGO_MANIFEST_DIR")).join("../target"),
        PathBuf::from,
    );
    target.join(BUILT)
}
