//! One step of a diagnosis that adds a term at a time.

use super::fit::Fitted;
use super::left::Left;

/// The fit, what it leaves, and the sets of its size that were tried.
pub(super) struct Step {
    pub(super) fit: Fitted,
    pub(super) left: Left,
    pub(super) tried: Vec<Fitted>,
}
