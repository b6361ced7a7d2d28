//! A rig that is watched: what the table really did.

use calib_twin::plant::Plant;
use calib_twin::rig::Rig;
use calib_twin::rig_port::{Conversions, DRIVE_MID_CODE, Dither, INPUT_CHANNELS, RigPort};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Sample pairs of a block: the converters' DMA interrupts with each (10 ms).
const BLOCK_PAIRS: u64 = 500;

/// Motion of the table as a witness saw it.
#[derive(Clone, Copy, Debug, Default)]
pub struct Seen {
    /// Highest magnitude of its acceleration, m/s2.
    pub highest_ms2: f64,
    /// From the first to the last instant above the bound, ms.
    pub above_for_ms: f64,
    /// From the end of the block in which it was decided to the last instant the
    /// exciter was driven, ms.
    pub driven_after_block_ms: f64,
    first_above_ns: Option<u64>,
    elapsed_ns: u64,
    pairs: u64,
    block_ns: u64,
}

/// Observations of a witness, shared with the test.
#[derive(Clone, Debug, Default)]
pub struct Sight(Arc<Mutex<Seen>>);

impl Sight {
    /// Observations so far.
    pub fn take(&self) -> Seen {
        *self.seen()
    }

    fn seen(&self) -> MutexGuard<'_, Seen> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn note(&self, acceleration_ms2: f64, duration_ns: u64, bound_ms2: f64) {
        let mut seen = self.seen();
        seen.elapsed_ns += duration_ns;
        seen.highest_ms2 = seen.highest_ms2.max(acceleration_ms2.abs());
        if acceleration_ms2.abs() > bound_ms2 {
            let now_ns = seen.elapsed_ns;
            let first_ns = *seen.first_above_ns.get_or_insert(now_ns);
            seen.above_for_ms = (now_ns - first_ns) as f64 * 1e-6;
        }
    }
}

impl Seen {
    /// Pairs come in blocks: with the last of one the instrument knows what it
    /// knows of it.
    fn note_pair(&mut self) {
        self.pairs += 1;
        if self.pairs.is_multiple_of(BLOCK_PAIRS) {
            self.block_ns = self.elapsed_ns;
        }
    }

    /// The exciter is driven: so far this is the last instant it is.
    fn note_drive(&mut self) {
        self.driven_after_block_ms = (self.elapsed_ns - self.block_ns) as f64 * 1e-6;
    }
}

/// A plant, and somebody who looks at its table.
pub struct Witness {
    plant: Plant,
    bound_ms2: f64,
    sight: Sight,
}

impl Witness {
    /// Watches `rig` for accelerations above `bound_ms2`, from `pairs` on that the
    /// instrument has taken since its start.
    pub fn new(rig: &Rig, bound_ms2: f64, pairs: u64) -> (Self, Sight) {
        let sight = Sight::default();
        sight.seen().pairs = pairs;
        let witness = Self {
            plant: Plant::new(rig),
            bound_ms2,
            sight: sight.clone(),
        };
        (witness, sight)
    }
}

impl RigPort for Witness {
    fn hold(&mut self, drive_code: u16, duration_ns: u64) {
        self.plant.hold(drive_code, duration_ns);
        let acceleration_ms2 = self.plant.acceleration_ms2();
        self.sight
            .note(acceleration_ms2, duration_ns, self.bound_ms2);
        if drive_code != DRIVE_MID_CODE {
            self.sight.seen().note_drive();
        }
    }

    fn set_conversions(&mut self, conversions: Conversions) {
        self.plant.set_conversions(conversions);
    }

    fn set_dither(&mut self, dither: Option<Dither>) {
        self.plant.set_dither(dither);
    }

    fn set_drive_buffer(&mut self, on: bool) {
        self.plant.set_drive_buffer(on);
    }

    fn sample(&mut self) -> [u16; INPUT_CHANNELS] {
        self.sight.seen().note_pair();
        self.plant.sample()
    }

    fn processor_c(&self) -> f64 {
        self.plant.processor_c()
    }
}
