//! Does U hold on a site? `./run bench reality [--core] [--runs N] [--seed N] [EFFECT ...]`.

use calib_tests::bench::Fault;
use calib_tests::reality::{self, BANDS_HZ, Sizes, Stratum, Tally, Through};

/// Runs of a stratum, unless said otherwise.
const RUNS: u64 = 20;

struct Arguments {
    runs: u64,
    seed: u64,
    strata: Vec<String>,
    through: Through,
}

fn main() -> Result<(), Fault> {
    let sizes = Sizes::read()?;
    let arguments = arguments(&sizes)?;
    println!(
        "{} runs of each effect, a point in each band; shares in percent of the points\n\n{:<24} {:>6} \
         {:>7} {:>6} {:>7} {:>7} {:>7} {:>7} {:>7} {:>6}",
        arguments.runs,
        "effect",
        "right",
        "refused",
        "told",
        "wrong S",
        "phase",
        "> 2 U",
        "worst S",
        "phase",
        "U, %"
    );
    let mut all = Vec::new();
    for (name, index) in arguments.strata.iter().zip(1_u64..) {
        // Other rigs for each effect.
        let first_seed = arguments.seed + 1_000_000 * index;
        let stratum = reality::run(&sizes, arguments.through, name, arguments.runs, first_seed)?;
        show(name, &stratum.pooled());
        all.push((name.clone(), stratum));
    }
    let mut pooled = Stratum::default();
    all.iter()
        .for_each(|(_, stratum)| pooled.merge(stratum.clone()));
    println!();
    for (band, [from, to]) in pooled.bands.iter().zip(BANDS_HZ) {
        show(&format!("{from:.0} to {to:.0} Hz"), band);
    }
    show("all", &pooled.pooled());
    for (name, stratum) in &all {
        println!("\n{name}: refused {:?}", stratum.reasons);
        stratum.wrong.iter().for_each(|line| println!("  {line}"));
    }
    write(&arguments, &all)
}

fn show(name: &str, tally: &Tally) {
    println!(
        "{name:<24} {:>6.1} {:>7.1} {:>6.1} {:>7.1} {:>7.1} {:>7.1} {:>7.2} {:>7.2} {:>6.2}",
        tally.percent(tally.right),
        tally.percent(tally.refused),
        tally.percent(tally.told),
        tally.percent(tally.wrong_magnitude),
        tally.percent(tally.wrong_phase),
        tally.percent(tally.beyond_2_u),
        tally.worst_magnitude,
        tally.worst_phase,
        tally.mean_expanded_percent(),
    );
}

fn arguments(sizes: &Sizes) -> Result<Arguments, Fault> {
    let mut read = Arguments {
        runs: RUNS,
        seed: 0,
        strata: Vec::new(),
        through: Through::Firmware,
    };
    let known = reality::strata(sizes);
    let mut given = std::env::args().skip(1);
    while let Some(word) = given.next() {
        let mut number = || -> Result<u64, Fault> {
            let text = given.next().unwrap_or_default();
            text.parse()
                .map_err(|_| format!("{word} {text}: a whole number is expected").into())
        };
        match word.as_str() {
            "--core" => read.through = Through::Core,
            "--runs" => read.runs = number()?,
            "--seed" => read.seed = number()?,
            _ if known.contains(&word) => read.strata.push(word),
            _ => {
                return Err(format!("{word} is no effect; there are: {}", known.join(", ")).into());
            }
        }
    }
    if read.strata.is_empty() {
        read.strata = known;
    }
    Ok(read)
}

fn write(arguments: &Arguments, all: &[(String, Stratum)]) -> Result<(), Fault> {
    let Some(path) = std::env::var_os("CALIB_BENCH_JSON") else {
        return Ok(());
    };
    let strata = all.iter().map(|(name, stratum)| {
        serde_json::json!({
            "effect": name,
            "bands": stratum.bands,
            "reasons": stratum.reasons,
            "wrong": stratum.wrong,
        })
    });
    let json = serde_json::json!({
        "runs": arguments.runs,
        "seed": arguments.seed,
        "bands_hz": BANDS_HZ,
        "strata": strata.collect::<Vec<_>>(),
    });
    std::fs::write(path, serde_json::to_string_pretty(&json)?)?;
    Ok(())
}
