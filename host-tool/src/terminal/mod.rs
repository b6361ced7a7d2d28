//! Results drawn with characters, for a terminal of 80 columns.

mod capture;
mod change;
mod history;
mod plot;
mod record;

pub use capture::show as show_capture;
pub use change::show_change;
pub use history::show as show_history;
pub use plot::{Horizontal, Mark, draw};
pub use record::show;
