//! Constants that turn one unit into another.

/// Standard acceleration of free fall, m/s2 (ISO 80000-3): a sensitivity per g over one per m/s2.
pub(crate) const STANDARD_GRAVITY_MS2: f64 = 9.806_65;
