//! `./run bench front-end [--accept]`: the analogue front end by ngspice. Response, images, noise, charge of
//! the converter, overload, and what 500 pairs of channels differ by. Compared with
//! `hardware/response.csv`, which `--accept` writes anew.

mod tables;

use calib_tests::front_end::{folder, ngspice, response, spread};
use calib_tests::rigged::Fault;
use ngspice::Run;
use serde_json::{Value, json};

fn run(deck: &str) -> Result<Run, Fault> {
    let missing = "ngspice is missing: apt-get install ngspice, or name it in CALIB_NGSPICE";
    ngspice::run(deck)?.ok_or_else(|| missing.into())
}

fn main() -> Result<(), Fault> {
    let accept = std::env::args().any(|argument| argument == "--accept");
    let response_run = run("response.cir")?;
    let lines = response::of(&response_run)?;
    let response = tables::response(&lines)?;
    let images = tables::images(&response_run)?;
    let noise = tables::printed("noise, uV r.m.s.", &run("noise.cir")?, &tables::NOISE)?;
    let charge = tables::printed(
        "charge of the converter",
        &run("charge.cir")?,
        &tables::CHARGE,
    )?;
    let faults = tables::printed("what must not hurt", &run("faults.cir")?, &tables::FAULTS)?;
    let spread_run = run("spread.cir")?;
    let spread = tables::spreads(&spread_run)?;
    write_json(&json!({
        "response": response, "images": images, "noise": noise, "charge": charge,
        "faults": faults, "spread": spread, "pairs": spread::PAIRS,
    }))?;
    settle(&lines, accept)
}

fn write_json(document: &Value) -> Result<(), Fault> {
    if let Some(path) = std::env::var_os("CALIB_BENCH_JSON") {
        std::fs::write(path, document.to_string())?;
    }
    Ok(())
}

/// The response is the committed one, or becomes it.
fn settle(lines: &[response::Line], accept: bool) -> Result<(), Fault> {
    let file = folder().join("response.csv");
    if accept {
        std::fs::write(&file, response::to_csv(lines))?;
        println!("\nhardware/response.csv is written anew");
        return Ok(());
    }
    let committed = response::from_csv(&std::fs::read_to_string(&file)?)?;
    match response::difference(&committed, lines) {
        None => println!("\nhardware/response.csv is what ngspice gives"),
        Some(difference) => {
            return Err(format!("hardware/response.csv differs {difference}: --accept").into());
        }
    }
    Ok(())
}
