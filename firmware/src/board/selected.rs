//! The board this image is for. Each has a folder in `firmware/boards`, a line
//! here, and a feature of its name in `Cargo.toml`; `build.rs` sees to it that
//! exactly one is chosen.

#[cfg_attr(
    feature = "board-fictitious-carrier",
    path = "../../boards/fictitious-carrier/board.rs"
)]
#[cfg_attr(
    feature = "board-nucleo-h743zi",
    path = "../../boards/nucleo-h743zi/board.rs"
)]
#[cfg_attr(
    feature = "board-nucleo-h743zi2",
    path = "../../boards/nucleo-h743zi2/board.rs"
)]
mod file;

pub(crate) use file::*;
