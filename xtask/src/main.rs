//! The project's chores: build the image, run the demo, the tests, the benches.
//!
//! `./run` does the set-up of a fresh machine and then calls this program, so
//! both a person and CI go the same way.

mod bench;
mod browser;
mod demo;
mod deny;
mod elf;
mod fuzz;
mod hitl;
mod no_panic;
mod option_writes;
mod origin;
mod package;
mod packages;
mod program;
mod python;
mod sbom;
mod shell;
mod test;
mod update;
mod wheel;
mod windows;
mod wine;

use anyhow::{Result, bail};

const HELP: &str = "\
usage: ./run <command>

  demo [OPTIONS]    calibrate a simulated accelerometer with the shipping firmware
                    (options go to `calib demo`: --out DIR, --seed N, --json)
  test [FILTER]     format, lints and every test there is
  bench [NAME]      benchmark tables, also written to target/bench/NAME.json
  deny              licences, sources and known weaknesses of every dependency
  elf [BOARD]       build the firmware image, for one of firmware/boards
  reproduce         build the image a second time, in other folders, and compare every byte
  no-panic [BOARD]  look for panics in what calib-core became in the image
  program [BOARD]   build the image and put it on the board at the ST-LINK (needs probe-rs)
  update [BOARD]    build the update of the image, signed with CALIB_RELEASE_KEY or the development key
  loader            build the loader that starts images signed with the same key
  commission [BOARD]  put loader and image on the board at the ST-LINK, once in its life
  package [--check] what a user installs, into dist/: a Debian package, a tar, a wheel and a folder for
                    Windows, with the image inside; --check also reproduces the image, installs
                    and uses the package in an empty Debian, the wheel in an empty environment, and the rest
                    under wine
  brown-out         set the brown-out level of the board at the ST-LINK, once in its life
  hitl [ratio]      tests on the board at the ST-LINK, exciter unplugged; `hitl emulated` without one
  screenshots       every picture of docs/images, the moving one too (needs Chromium)
  size [BOARD]      flash and RAM used by the image
  setup             build everything and run nothing
";

fn main() -> Result<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let (command, rest) = match arguments.split_first() {
        Some((command, rest)) => (command.as_str(), rest),
        None => ("help", &[][..]),
    };
    let board = rest.first().map(String::as_str);
    match command {
        "demo" => demo::run(rest),
        "test" | "ci" => test::run(rest),
        "bench" => bench::run(rest),
        "deny" => deny::run_alone(),
        "elf" => elf::build_for(board).map(|path| println!("{}", path.display())),
        "update" => update::build(board).map(|path| println!("{}", path.display())),
        "loader" => update::build_loader().map(|path| println!("{}", path.display())),
        "commission" => update::commission(board),
        "program" => program::run(board),
        "hitl" => hitl::run(rest),
        "brown-out" => program::brown_out(),
        "no-panic" => elf::build_for(board).and_then(|image| no_panic::check(&image)),
        "package" => package::build(rest),
        "screenshots" => browser::screenshots(),
        "reproduce" => elf::build().and_then(|image| origin::check(&image, elf::build_elsewhere)),
        "size" => elf::print_size(board),
        "setup" => demo::build_all().map(|_| ()),
        "help" | "--help" | "-h" => {
            print!("{HELP}");
            Ok(())
        }
        other => bail!("unknown command `{other}`\n\n{HELP}"),
    }
}
