//! Results drawn with characters, for a terminal of 80 columns; a record also for a narrower one.

mod capture;
mod change;
mod conformity_statement;
mod history;
mod record;
mod reference;

use std::io::IsTerminal;

/// Columns every terminal of a desk has.
const COLUMNS: usize = 80;
/// Fewest that a record is drawn in: a phone held upright.
const FEWEST: usize = 40;

/// Columns of the terminal on standard output, 40 to 80; 80 where it is none.
pub fn columns() -> usize {
    let terminal = std::io::stdout().is_terminal();
    let size = terminal.then(terminal_size::terminal_size).flatten();
    size.map_or(COLUMNS, |(width, _)| {
        usize::from(width.0).clamp(FEWEST, COLUMNS)
    })
}

pub use capture::show as show_capture;
pub use change::show_change;
pub use conformity_statement::show as conformity_statement;
pub use history::{show as show_history, show_changes};
pub use record::show;
pub use reference::show as reference;
