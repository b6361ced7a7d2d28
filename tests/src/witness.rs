//! A rig that is watched: what the table really did.

use calib_twin::plant::Plant;
use calib_twin::rig::Rig;
use calib_twin::rig_port::{INPUT_CHANNELS, RigPort};
use std::sync::{Arc, Mutex, PoisonError};

/// What a witness has seen of the table.
#[derive(Clone, Copy, Debug, Default)]
pub struct Seen {
    /// Highest magnitude of its acceleration, m/s2.
    pub highest_ms2: f64,
    /// From the first to the last instant above the bound, ms.
    pub above_for_ms: f64,
    first_above_ns: Option<u64>,
    elapsed_ns: u64,
}

/// What a witness has seen, shared with the test.
#[derive(Clone, Debug, Default)]
pub struct Sight(Arc<Mutex<Seen>>);

impl Sight {
    /// What was seen so far.
    pub fn take(&self) -> Seen {
        *self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn note(&self, acceleration_ms2: f64, duration_ns: u64, bound_ms2: f64) {
        let mut seen = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        seen.elapsed_ns += duration_ns;
        seen.highest_ms2 = seen.highest_ms2.max(acceleration_ms2.abs());
        if acceleration_ms2.abs() > bound_ms2 {
            let now_ns = seen.elapsed_ns;
            let first_ns = *seen.first_above_ns.get_or_insert(now_ns);
            seen.above_for_ms = (now_ns - first_ns) as f64 * 1e-6;
        }
    }
}

/// A plant, and somebody who looks at its table.
pub struct Witness {
    plant: Plant,
    bound_ms2: f64,
    sight: Sight,
}

impl Witness {
    /// Watches `rig` for accelerations above `bound_ms2`.
    pub fn new(rig: &Rig, bound_ms2: f64) -> (Self, Sight) {
        let sight = Sight::default();
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
    }

    fn sample(&mut self) -> [u16; INPUT_CHANNELS] {
        self.plant.sample()
    }
}
