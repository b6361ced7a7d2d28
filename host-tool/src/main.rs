//! `calib`: the command line tool of the calibrator. One file per verb in `cli/`.
mod cli;

use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments = match cli::Arguments::read() {
        Ok(arguments) => arguments,
        Err(said) => return cli::tell(said),
    };
    let context = cli::Context::new(&arguments.global);
    match arguments.command.run(&context) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            context.report(&error);
            ExitCode::from(error.exit_code())
        }
    }
}
