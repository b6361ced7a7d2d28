//! The supply of an emulated board: cut it, at any instant and in any flash operation.

use std::time::Duration;

use super::{Emulator, Error, Torn, memory};

/// How long the supply stays away in a power cycle: nothing in the part remembers longer.
const OFF: Duration = Duration::from_millis(10);

impl Emulator {
    /// Cuts the supply at this instant. A flash operation under way leaves a torn word or sector.
    /// Time goes on while the board is off: the rig lives.
    ///
    /// # Errors
    ///
    /// [`Error::Ended`] when the emulator fails.
    pub fn cut_power(&mut self) -> Result<Torn, Error> {
        let cut = self.core.act(|session, _, stop| {
            let part = &mut session.board_mut().part;
            let under_way = part.flash_under_way(stop.at);
            part.power(stop.at, false);
            under_way
        })?;
        self.pins.serial.clear();
        self.run_for(Duration::from_nanos(1))?;
        Ok(cut.into())
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

    /// As [`Emulator::run_into_flash_operation`], of operations on the flash the code is in.
    ///
    /// # Errors
    ///
    /// [`Error::Ended`] when the emulator fails.
    pub fn run_into_code_operation(
        &mut self,
        ordinal: u64,
        fraction: f64,
        limit: Duration,
    ) -> Result<bool, Error> {
        self.pins.flash.set_code_trap(ordinal, fraction);
        self.stops_within(limit)
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
        self.stops_within(limit)
    }

    /// Runs for `limit`; answers whether a trap ended it before.
    fn stops_within(&mut self, limit: Duration) -> Result<bool, Error> {
        let goal = self.elapsed() + limit;
        self.run_for(limit)?;
        Ok(self.elapsed() < goal)
    }
}
