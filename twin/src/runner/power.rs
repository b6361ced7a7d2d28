//! The supply of an emulated board: cut it, at any instant and in any flash operation.

use std::time::Duration;

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use rigless::emulator::{Error as EmulatorError, Host};

use super::{Emulator, Error, memory};
use crate::board::{Operation, SECTOR_BYTES, WORD_BYTES, torn_sector, torn_word};

/// How long the supply stays away in a power cycle: nothing in the part remembers longer.
const OFF: Duration = Duration::from_millis(10);

/// State of the record flash after a power cut.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Torn {
    /// No operation was under way.
    Nothing,
    /// A word was half programmed.
    Word {
        /// Its address.
        address: u64,
        /// How far its programming was, from 0 to 1.
        progress: f64,
    },
    /// A sector was half erased.
    Sector {
        /// Its address.
        address: u64,
        /// How far its erase was, from 0 to 1.
        progress: f64,
    },
}

impl Emulator {
    /// Cuts the supply at this instant. A flash operation under way leaves a torn word or sector.
    /// Time goes on while the board is off: the rig lives.
    ///
    /// # Errors
    ///
    /// [`Error::Ended`] when the emulator fails.
    pub fn cut_power(&mut self) -> Result<Torn, Error> {
        let flash = self.pins.flash.clone();
        let seed = self.power_ons ^ self.elapsed().as_nanos() as u64;
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let torn = self.core.act(move |session, host, stop| {
            let under_way = flash.under_way(stop.at);
            let torn = match under_way {
                Some((operation, progress)) => tear(host, operation, progress, &mut random)?,
                None => Torn::Nothing,
            };
            session.board_mut().part.power(stop.at, false);
            Ok::<_, EmulatorError>(torn)
        })?;
        self.pins.serial.clear();
        self.run_for(Duration::from_nanos(1))?;
        torn.map_err(|error| Error::Ended(error.to_string()))
    }

    /// Gives the supply back: RAM comes up with other content, flash as it was left.
    ///
    /// # Errors
    ///
    /// [`Error::Ended`] when the emulator fails.
    pub fn restore_power(&mut self) -> Result<(), Error> {
        let seed = self.power_ons;
        let buffer = self.pins.write_buffer.clone();
        let scrambled = self.core.act(move |session, host, stop| {
            session.board_mut().part.power(stop.at, true);
            let scrambled = memory::scramble(host, seed);
            memory::note_kept(host, &buffer);
            scrambled
        })?;
        scrambled.map_err(|error| Error::Ended(error.to_string()))?;
        self.pins.serial.clear();
        self.power_ons += 1;
        self.powered_at = self.elapsed();
        Ok(())
    }

    /// Switches the board off and on again.
    ///
    /// # Errors
    ///
    /// [`Error::Ended`] when the emulator fails.
    pub fn power_cycle(&mut self) -> Result<Torn, Error> {
        let torn = self.cut_power()?;
        self.run_for(OFF)?;
        self.restore_power()?;
        Ok(torn)
    }

    /// The rail of the part becomes `millivolts`, 3300 otherwise: what its voltage detector sees. The
    /// converters' own reference does not follow, and the part stops only when the supply is cut.
    ///
    /// # Errors
    ///
    /// [`Error::Ended`] when the emulator fails.
    pub fn set_supply(&mut self, millivolts: u32) -> Result<(), Error> {
        self.core.act(move |session, _, stop| {
            session.board_mut().part.set_supply(stop.at, millivolts);
        })
    }

    /// Runs until operation number `ordinal` on the record flash, counted from 1 at the first
    /// power-on, is at `fraction` (0 to 1) of its time, at most for `limit`; answers whether it is.
    ///
    /// # Errors
    ///
    /// [`Error::Ended`] when the emulator fails.
    pub fn run_into_flash_operation(
        &mut self,
        ordinal: u64,
        fraction: f64,
        limit: Duration,
    ) -> Result<bool, Error> {
        self.pins.flash.set_trap(ordinal, fraction);
        let goal = self.elapsed() + limit;
        self.run_for(limit)?;
        Ok(self.elapsed() < goal)
    }
}

/// Leaves in flash what `operation` has done so far.
fn tear(
    host: &mut dyn Host,
    operation: Operation,
    progress: f64,
    random: &mut ChaCha8Rng,
) -> Result<Torn, EmulatorError> {
    let draw = || random.next_u64();
    match operation {
        Operation::Program { address, data } => {
            let mut old = [0; WORD_BYTES];
            old.copy_from_slice(&memory::read(host, address, WORD_BYTES)?);
            memory::program(host, address, &torn_word(old, data, progress, draw))?;
            Ok(Torn::Word { address, progress })
        }
        Operation::Erase { address } => {
            let mut sector = memory::read(host, address, SECTOR_BYTES as usize)?;
            torn_sector(&mut sector, progress, draw);
            memory::program(host, address, &sector)?;
            Ok(Torn::Sector { address, progress })
        }
    }
}
