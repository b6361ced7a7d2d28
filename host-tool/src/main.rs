//! `calib`: the command line tool of the calibrator. One file per verb in `cli/` of the library.

use std::process::ExitCode;

fn main() -> ExitCode {
    calib_host::cli::main()
}
