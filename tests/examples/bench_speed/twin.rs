//! Cost of the rig without the processor: a sample of the plant, a steady state, a data set.

use calib_tests::rigged::Fault;
use calib_twin::dataset::{Nominal, Options, generate, standard_design};
use calib_twin::effects::ActiveEffect;
use calib_twin::plant::Plant;
use calib_twin::rig::Rig;
use calib_twin::rig_port::RigPort;
use serde_json::{Value, json};
use std::hint::black_box;
use std::time::Instant;

/// Time between two samples, ns.
const TICK_NS: u64 = 20_000;
/// Samples the plant is timed with: a virtual second.
const SAMPLES: u16 = 50_000;
/// A linear rig, one with two effects of the exciter, and one whose converter and amplifier bend.
const DATASETS: [&[&str]; 3] = [
    &["dut_resonance"],
    &["suspension_cubic", "coulomb_friction"],
    &["adc_cubic", "amplifier_clipping"],
];

/// Prints the rows and hands them over.
///
/// # Errors
/// An effect nobody knows.
pub(crate) fn measure() -> Result<Value, Fault> {
    let sample_ns = plant_sample_ns();
    println!("plant alone                {sample_ns:>8.0} ns a sample of {TICK_NS}");
    let mut datasets = serde_json::Map::new();
    for effects in DATASETS {
        let names = effects.join(" + ");
        let milliseconds = dataset_ms(effects)?;
        println!("data set of 214 rows       {milliseconds:>8.0} ms, {names}");
        datasets.insert(names, json!(milliseconds));
    }
    Ok(json!({ "plant_sample_ns": sample_ns, "dataset_ms": datasets }))
}

fn plant_sample_ns() -> f64 {
    let mut plant = Plant::new(&Rig::standard());
    let start = Instant::now();
    for index in 0..SAMPLES {
        plant.hold(2048 + index % 64, TICK_NS);
        black_box(plant.sample());
    }
    start.elapsed().as_secs_f64() * 1e9 / f64::from(SAMPLES)
}

fn dataset_ms(effects: &[&str]) -> Result<f64, Fault> {
    let nominal = Nominal::standard();
    let effects: Vec<ActiveEffect> = effects
        .iter()
        .map(|text| text.parse())
        .collect::<Result<_, _>>()?;
    let start = Instant::now();
    let design = standard_design(&nominal);
    black_box(generate(&nominal, &design, &effects, &Options::default()));
    Ok(start.elapsed().as_secs_f64() * 1e3)
}
