//! Results drawn with characters, for a terminal of 80 columns.

mod plot;
mod record;

pub use plot::{Horizontal, Mark, draw};
pub use record::show;
