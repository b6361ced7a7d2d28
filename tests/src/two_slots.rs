//! A board as it leaves the workshop: the loader in sector 0, image and manifest in slot A. And updates for it.

use crate::rigged::Fault;
use calib_boot::file::{self, Part};
use calib_boot::layout::Slot;
use calib_boot::manifest::{Manifest, Seed, Version, sign};
use calib_boot::trusted::DEVELOPMENT_SEED;
use calib_twin::board::Schematic;
use calib_twin::rig_port::RigPort;
use calib_twin::runner::{Emulator, Firmware};
use std::path::Path;

/// The board its images are for.
pub const BOARD: &str = "nucleo-h743zi2";
/// The version of this tree.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");

/// The shipping loader and update, as `./run loader` and `./run update` leave them beside the image.
pub struct TwoSlots {
    loader: Firmware,
    update: Vec<u8>,
}

impl TwoSlots {
    /// Reads both.
    ///
    /// # Errors
    /// One is missing, or the update is none.
    pub fn read() -> Result<Self, Fault> {
        let image = Firmware::shipping()?;
        let folder = image.path().parent().unwrap_or(Path::new("."));
        let path = folder.join(format!("calib-{VERSION}-{BOARD}.update"));
        let update = std::fs::read(&path);
        let update =
            update.map_err(|error| format!("{}: {error}: `./run update`", path.display()))?;
        file::parts(&update).ok_or_else(|| format!("{} is no update", path.display()))?;
        let loader = Firmware::read(&folder.join("calib-loader"))?;
        Ok(Self { loader, update })
    }

    /// The shipping image of a slot.
    pub fn image(&self, slot: Slot) -> &[u8] {
        self.part(slot).map_or(&[], |part| part.image)
    }

    fn part(&self, slot: Slot) -> Option<Part<'_>> {
        file::parts(&self.update).map(|parts| parts[slot as usize])
    }

    /// A new board with loader and slot A, switched on.
    ///
    /// # Errors
    /// The board cannot run it.
    pub fn commissioned(&self, port: Box<dyn RigPort>) -> Result<Emulator, Fault> {
        self.commissioned_with(&self.update, Schematic::nucleo_h743zi2(), port)
    }

    /// A commissioned board with slot A of another update, by this schematic.
    ///
    /// # Errors
    /// As there.
    pub fn commissioned_with(
        &self,
        update: &[u8],
        schematic: Schematic,
        port: Box<dyn RigPort>,
    ) -> Result<Emulator, Fault> {
        let [part, _] = file::parts(update).ok_or("no part for slot A")?;
        let mut board = Emulator::power_on(&self.loader.clone().on(schematic), port)?;
        board.load_flash(u64::from(Slot::A.start()), part.image)?;
        board.load_flash(u64::from(Slot::A.manifest()), part.manifest)?;
        Ok(board)
    }

    /// An update that works like the shipping one and is another: the images are a word longer.
    pub fn another(&self) -> Vec<u8> {
        let longer = |slot| [self.image(slot), &[0xFF; 32]].concat();
        release(
            &[longer(Slot::A), longer(Slot::B)],
            VERSION,
            BOARD,
            &DEVELOPMENT_SEED,
        )
    }
}

/// A file with these images for slots A and B.
pub fn release(images: &[Vec<u8>; 2], version: &str, board: &str, seed: &Seed) -> Vec<u8> {
    let mut update = file::MAGIC.to_vec();
    for (slot, image) in Slot::ALL.into_iter().zip(images) {
        let version = Version::parse(version).unwrap_or_default();
        let told = Manifest::of(image, slot, version, board);
        update.extend(told.map_or([0; 256], |told| sign(&told, seed)));
        update.extend(image);
    }
    update
}
