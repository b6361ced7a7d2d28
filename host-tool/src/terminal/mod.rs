//! Results drawn with characters, for a terminal of 80 columns.

mod capture;
mod change;
mod history;
mod record;
mod reference;
mod verdict;

pub use capture::show as show_capture;
pub use change::show_change;
pub use history::{show as show_history, show_changes};
pub use record::show;
pub use reference::show as reference;
pub use verdict::show as verdict;
