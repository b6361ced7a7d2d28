//! Throughput of the Monte Carlo engine on one core, for a 17-component
//! product model, beside the same budget in Python with numpy.
//!
//! `./run bench monte-carlo` runs it; `CALIB_PYTHON` names an interpreter with
//! numpy, `CALIB_BENCH_JSON` a file for the numbers.
#![expect(clippy::print_stdout, reason = "a benchmark prints its table")]

use calib_metrology::budget::{self, Budget};
use calib_metrology::input::Source;
use calib_metrology::monte_carlo::{self, BATCH, Lanes, Options, Plan};
use serde_json::{Value, json};
use std::error::Error;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

/// Table D.1 of ISO 16063-21 as shipped in the documentation.
const TABLE_D1: &str = include_str!("../../../docs/metrology/examples/table-d1.toml");
/// Trials per measurement: long against the clock, short against patience.
const TRIALS: usize = 4000 * BATCH;

fn main() -> Result<(), Box<dyn Error>> {
    let d1 = read(TABLE_D1)?;
    let normal = read(&seventeen_normal())?;
    let mut rows = vec![
        ("Table D.1, draws only", draws_per_second(&d1)),
        (
            "17 normal components, draws only",
            draws_per_second(&normal),
        ),
        ("Table D.1, with intervals (GUM-S1)", whole_per_second(&d1)),
    ];
    if let Some(rate) = python_per_second() {
        rows.push(("Table D.1 in numpy, draws only", rate));
    }
    println!("{:<38} million draws per second and core", "");
    for (name, rate) in &rows {
        println!("{name:<38} {:>8.1}", rate / 1.0e6);
    }
    if let Some(path) = std::env::var_os("CALIB_BENCH_JSON") {
        let fields: Vec<Value> = rows
            .iter()
            .map(|(name, rate)| json!({ "case": name, "draws_per_second": rate }))
            .collect();
        std::fs::write(path, serde_json::to_string_pretty(&fields)?)?;
    }
    Ok(())
}

fn read(text: &str) -> calib_files::Result<Budget> {
    budget::parse(&Source::from_text(Path::new("bench.toml"), text)?)
}

fn seventeen_normal() -> String {
    (0..17)
        .map(|n| {
            format!("[[component]]\nlabel = 'c{n}'\nvalue = 0.1\ndistribution = 'normal'\nk = 1\n")
        })
        .collect()
}

/// Best of five runs: other work on the machine only ever slows a run down.
fn best(mut run: impl FnMut() -> usize) -> f64 {
    (0..5)
        .map(|_| {
            let start = Instant::now();
            let trials = run();
            trials as f64 / start.elapsed().as_secs_f64()
        })
        .fold(0.0, f64::max)
}

fn draws_per_second(budget: &Budget) -> f64 {
    let plan = Plan::new(budget);
    let mut lanes = Lanes::new(1, 0);
    let mut values = vec![0.0; 100 * BATCH];
    best(|| {
        for _ in 0..TRIALS / values.len() {
            plan.fill(&mut lanes, &mut values);
        }
        std::hint::black_box(&values);
        TRIALS
    })
}

fn whole_per_second(budget: &Budget) -> f64 {
    let plan = Plan::new(budget);
    let options = Options {
        threads: 1,
        ..Options::default()
    };
    best(|| monte_carlo::propagate(&plan, &options).trials)
}

/// Draws per second of numpy for this budget, if there is an interpreter that has it.
fn python_per_second() -> Option<f64> {
    let interpreter = std::env::var_os("CALIB_PYTHON").unwrap_or_else(|| "python3".into());
    let script =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../../xtask/bench/monte_carlo_numpy.py");
    let output = Command::new(interpreter).arg(script).output().ok()?;
    if !output.status.success() {
        println!("(numpy is not installed: no comparison)");
        return None;
    }
    let result: Value = serde_json::from_slice(&output.stdout).ok()?;
    result["draws_per_second"].as_f64()
}
