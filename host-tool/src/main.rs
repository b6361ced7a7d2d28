//! `calib`: the command line tool of the calibrator. One file per verb in `cli/`.
mod cli;

use calib_host::config::{self, Config};
use std::process::ExitCode;

fn main() -> ExitCode {
    // What is wrong with them is said in the form that was asked for, which the arguments tell.
    let (defaults, broken) = match Config::load(&config::path()) {
        Ok(defaults) => (defaults, None),
        Err(error) => (Config::default(), Some(error)),
    };
    let arguments = match cli::Arguments::read(&defaults) {
        Ok(arguments) => arguments,
        Err(said) => return cli::tell(said),
    };
    let context = cli::Context::new(&arguments.global, defaults);
    let done = broken.map_or_else(|| arguments.command.run(&context), Err);
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            context.report(&error);
            ExitCode::from(error.exit_code())
        }
    }
}
