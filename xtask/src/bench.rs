//! Benchmarks: programs that print a table and write `target/bench/NAME.json`.

use crate::shell::{self, cargo, target_dir};
use crate::{browser, demo, elf, fuzz, packages, python, wheel};
use anyhow::{Result, bail};
use std::path::PathBuf;
use std::process::Command;

/// Name of the one that is built in another way.
const FUZZ: &str = "fuzz";

/// Benchmarks by name, each an example program of some crate, and what they show.
const BENCHES: &str = "\
converters: what the converters' errors do to S, by how they are set; assumed errors halved, doubled
coverage: share of simulated calibrations whose U (k = 2) contains the truth
frozen: diagnoses and certificates are what they were: [--accept REASON]
front-end: the analogue front end by ngspice: response, images, noise, spread: [--accept]
gap: sealed sets: how often the diagnosis is right, by stratum
measured: measured sets of known cause: leading cause, closed, verdict, first stage: [DIR]
hard-hostile: hosts that flood, babble, reset and race while it measures: [RESETS]
hard-long: virtual hours of calibrating, storing and downloading: [MINUTES [faults] [resume]]
hard-power: power cuts of the whole board in a session: [CUTS [SEED]]
hard-storage: records that fit, wear over 100 000 records, 2000 random power cuts
gap-speed: time for a diagnosis on one core, and for 1000 in one call, beside numpy and scipy
monte-carlo: propagation of distributions on one core, beside numpy
reality: does U hold on a site? every effect and fault at its site sizes: [--core] [--runs N] [EFFECT ...]
records: 10 000 records in the logbook listed and filtered; start of the tool
selfcheck: the reference checked by reciprocity: coverage of U, changes found, false alarms: [RIGS [SEED [IMAGE_RIGS]]]
speed: emulator, rig, correlation on this computer, image size, settling
stop: from STOP to the calibrator's link, by what is in the way, and from a click to a drive at rest: [TRIES [PART [SITUATION [SEED]]]]
target: instructions and times on the Cortex-M7, beside idsp and the limits
certificate: time for the certificate set of a record with 31 points";

#[derive(Clone, Copy)]
struct Bench {
    name: &'static str,
    what: &'static str,
}

impl Bench {
    fn all() -> impl Iterator<Item = Self> {
        let named = BENCHES.lines().filter_map(|line| line.split_once(": "));
        named.map(|(name, what)| Self { name, what })
    }

    fn example(self) -> String {
        format!("bench_{}", self.name.replace('-', "_"))
    }

    /// Its name, or the first word of it: `hard` is all of `hard-...`.
    fn goes_by(self, name: &str) -> bool {
        let first = self.name.split_once('-').map(|(first, _)| first);
        self.name == name || first == Some(name)
    }
}

/// Programs in Python, over the wheel: name, file, what it needs beside the tests' packages, what it shows.
const IN_PYTHON: [(&str, &str, &str, &str); 2] = [
    (
        "fleet",
        "fleet/bench.py",
        python::SPARK,
        "questions and diagnoses of a fleet on Spark, beside DuckDB and the plain tool: [--records N ...] [--datasets N]",
    ),
    (
        "own-model",
        "python/tests/sealed.py",
        "",
        "effects planted on top of simulations that are not ours, found by the diagnosis: [--cases N]",
    ),
];

/// Runs one over the wheel; Spark wants a Java, of Debian.
fn in_python(
    (name, file, packages, what): &(&str, &str, &str, &str),
    rest: &[String],
) -> Result<()> {
    println!("\n== {name}: {what}\n");
    let interpreter = wheel::interpreter()?;
    if !packages.is_empty() {
        python::with(&interpreter, packages)?;
    }
    if *name == "fleet" {
        packages::installed("java")?;
    }
    wheel::installed(&interpreter)?;
    let mut bench = Command::new(&interpreter);
    bench.arg(shell::root().join(file)).args(rest);
    bench
        .arg("--json")
        .arg(target_dir().join(format!("bench/{name}.json")));
    shell::run(bench.current_dir(target_dir()))
}

/// Runs one benchmark, or all of them.
pub(crate) fn run(arguments: &[String]) -> Result<()> {
    if let Some((name, rest)) = arguments.split_first()
        && name == FUZZ
    {
        return fuzz::run(rest);
    }
    if let Some((name, rest)) = arguments.split_first()
        && let Some(bench) = IN_PYTHON.iter().find(|bench| bench.0 == name)
    {
        return in_python(bench, rest);
    }
    let chosen = choose(arguments.first())?;
    let prepared = Prepared::new()?;
    for bench in chosen {
        println!("\n== {}: {}\n", bench.name, bench.what);
        let mut command = prepared.command(bench)?;
        shell::run(command.args(arguments.iter().skip(1)))?;
    }
    match arguments.is_empty() {
        true => fuzz::run(&[]),
        false => Ok(()),
    }
}

/// The benchmarks that go by `name`; all when there is none.
fn choose(name: Option<&String>) -> Result<Vec<Bench>> {
    let Some(name) = name else {
        return Ok(Bench::all().collect());
    };
    let chosen: Vec<Bench> = Bench::all().filter(|bench| bench.goes_by(name)).collect();
    if chosen.is_empty() {
        let fuzz = (
            FUZZ,
            "the fuzz targets, 10 minutes each: [MINUTES [TARGET ...]]",
        );
        let benches = Bench::all().map(|bench| (bench.name, bench.what));
        let known: Vec<_> = benches
            .chain(IN_PYTHON.iter().map(|(name, _, _, what)| (*name, *what)))
            .chain([fuzz])
            .map(|(name, what)| format!("  {name:<12} {what}"))
            .collect();
        bail!("no such benchmark; there are\n{}", known.join("\n"));
    }
    Ok(chosen)
}

/// Programs the benchmarks measure, built, and the folder for their numbers.
struct Prepared {
    image: PathBuf,
    /// Bytes of the image, as `CALIB_IMAGE_BYTES` states them.
    sizes: String,
    kernels: PathBuf,
    interpreter: Option<PathBuf>,
    folder: PathBuf,
}

impl Prepared {
    fn new() -> Result<Self> {
        let image = elf::build()?;
        let sizes = elf::totals(&image)?.map(|size| size.to_string()).join(" ");
        let kernels = elf::build_package("calib-kernels", &[])?;
        demo::build_tool()?;
        let interpreter = python::interpreter()?;
        let folder = target_dir().join("bench");
        std::fs::create_dir_all(&folder)?;
        Ok(Self {
            image,
            sizes,
            kernels,
            interpreter,
            folder,
        })
    }

    /// The call of `bench`, without arguments of its own.
    fn command(&self, bench: Bench) -> Result<Command> {
        let mut build = cargo("build");
        build.args(["--release", "--quiet", "--workspace"]);
        shell::run(build.args(["--example", &bench.example()]))?;
        let examples = target_dir().join("release").join("examples");
        let mut command = Command::new(examples.join(bench.example()));
        command.current_dir(shell::root());
        let json = self.folder.join(format!("{}.json", bench.name));
        command
            .env("CALIB_FIRMWARE_ELF", &self.image)
            .env("CALIB_KERNELS_ELF", &self.kernels)
            .env("CALIB_IMAGE_BYTES", &self.sizes)
            .env("CALIB_TOOL", demo::tool())
            .env("CALIB_BENCH_JSON", json);
        // Watched places hold up a run that takes shortcuts.
        if bench.name == "target" {
            command.env("CALIB_EMULATOR", "plain");
        }
        if bench.name == "front-end" {
            command.env("CALIB_NGSPICE", packages::installed("ngspice")?);
        }
        if bench.name == "stop"
            && let Some(driver) = browser::driver()?
        {
            command.env("CALIB_CHROMEDRIVER", driver);
        }
        if let Some(interpreter) = &self.interpreter {
            command.env("CALIB_PYTHON", interpreter);
        }
        Ok(command)
    }
}
