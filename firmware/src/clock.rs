//! Time of day, as hosts told it: counted since then, and gone with the next restart.

use calib_protocol::clock::ClockReading;

/// How far a count by the crystal may be off, ppm: tolerance, temperature and ageing of common ones add up to
/// 100 at most.
pub const CRYSTAL_PPM: u64 = 100;
/// Error of the internal oscillator, where there is no clock at OSC_IN: 5 %, about twice its error over all
/// temperatures.
pub const INTERNAL_PPM: u64 = 50_000;

/// The time a host told, and when; none before any did.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Clock(Option<Told>);

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Told {
    unix_time_s: u64,
    at_ms: u64,
}

impl Clock {
    /// Nobody told the time.
    pub const UNKNOWN: Self = Self(None);

    /// A host tells the time, `now_ms` since the start; 0 is none.
    pub fn tell(&mut self, unix_time_s: u64, now_ms: u64) {
        if unix_time_s > 0 {
            let at_ms = now_ms;
            self.0 = Some(Told { unix_time_s, at_ms });
        }
    }

    /// The count stood still: the time is not known any more.
    pub fn forget(&mut self) {
        self.0 = None;
    }

    /// Seconds since 1970-01-01 UTC, and where they come from, by a count that may be off by so many ppm; 0 and
    /// nothing where nobody told the time.
    pub fn read(&self, now_ms: u64, ppm: u64) -> (u64, ClockReading) {
        let Some(told) = self.0 else {
            return (0, ClockReading::NONE);
        };
        let counted_s = now_ms.saturating_sub(told.at_ms) / 1_000;
        let drift_s = counted_s.saturating_mul(ppm) / 1_000_000;
        let reading = ClockReading {
            told_unix_time_s: told.unix_time_s,
            // One second by the host's rounding, one by the way to here and the rounding of the count.
            uncertainty_s: u32::try_from(drift_s).unwrap_or(u32::MAX).saturating_add(2),
        };
        (told.unix_time_s.saturating_add(counted_s), reading)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_clock_nobody_set_has_no_time_and_one_that_stood_still_neither() {
        let mut clock = Clock::UNKNOWN;
        assert_eq!(clock.read(5_000, CRYSTAL_PPM), (0, ClockReading::NONE));
        clock.tell(0, 1_000);
        assert_eq!(clock.read(5_000, CRYSTAL_PPM), (0, ClockReading::NONE));
        clock.tell(1_800_000_000, 1_000);
        clock.forget();
        assert_eq!(clock.read(5_000, CRYSTAL_PPM), (0, ClockReading::NONE));
    }

    #[test]
    fn the_time_counts_on_and_its_uncertainty_grows_with_the_drift() {
        let mut clock = Clock::UNKNOWN;
        clock.tell(1_800_000_000, 1_500);
        // Ten days: 86.4 s at 100 ppm, 12 hours at 5 %.
        let ten_days_ms = 864_000_000 + 1_500;
        for (ppm, uncertainty_s) in [(CRYSTAL_PPM, 86 + 2), (INTERNAL_PPM, 43_200 + 2)] {
            let (time, reading) = clock.read(ten_days_ms, ppm);
            assert_eq!(time, 1_800_864_000);
            assert_eq!(reading.told_unix_time_s, 1_800_000_000);
            assert_eq!(reading.uncertainty_s, uncertainty_s);
        }
        // The next host tells it anew.
        clock.tell(1_800_900_000, ten_days_ms);
        assert_eq!(clock.read(ten_days_ms, CRYSTAL_PPM).0, 1_800_900_000);
        assert_eq!(clock.read(ten_days_ms, CRYSTAL_PPM).1.uncertainty_s, 2);
    }
}
