//! Sealed sets: how often the diagnosis is right, by stratum. `bench_gap [STRATUM,... [CASES [SEED [CASE]]]]`
//!
//! The cases come from a generator that shares nothing with the engine: it
//! integrates nothing and balances nothing the way the engine does, but solves
//! the exciter by collocation in time (`tests/sealed`). A table goes to standard
//! output, the same numbers as JSON to the file named by `CALIB_BENCH_JSON`, one
//! line per case to the file named by `CALIB_BENCH_CASES`.

mod case;
mod records;
mod reliability;
#[path = "../../tests/sealed/mod.rs"]
#[allow(dead_code)]
mod sealed;
mod table;

use rayon::prelude::*;
use std::fmt::Write;

/// Strata and their sizes when nothing else is said.
const STRATA: [(&str, u64); 24] = [
    ("null", 300),
    ("off2u", 300),
    ("single", 336),
    ("ratio", 320),
    ("pairs", 300),
    ("triples", 120),
    ("opened", 120),
    ("beside", 120),
    ("withheld", 336),
    ("size", 420),
    ("noise_1.2", 60),
    ("noise_2", 60),
    ("misread", 60),
    ("memory", 90),
    ("unkind", 252),
    ("form", 84),
    ("later", 120),
    ("later_withheld", 120),
    ("weak", 120),
    ("weak_withheld", 120),
    ("record", 120),
    ("record_pairs", 60),
    ("record_form", 60),
    ("record_withheld", 60),
];
/// Not used while the engine was developed.
const SEED: u64 = 20261127;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let number = |at: usize| arguments.get(at).and_then(|a| a.parse::<u64>().ok());
    let wanted = arguments.first().map_or("all", String::as_str);
    let seed = number(2).unwrap_or(SEED);
    let mut lines = String::new();
    let mut all = Vec::new();
    for (stratum, usual) in STRATA {
        if wanted != "all" && !wanted.split(',').any(|w| w == stratum) {
            continue;
        }
        let indices: Vec<u64> = match number(3) {
            Some(only) => vec![only],
            None => (0..number(1).unwrap_or(usual)).collect(),
        };
        let results: Vec<case::Outcome> = indices
            .par_iter()
            .map(|index| match records::is_of_records(stratum) {
                true => records::run(stratum, *index, seed),
                false => case::run(stratum, *index, seed),
            })
            .collect::<Result<_, _>>()?;
        for outcome in &results {
            writeln!(lines, "{stratum} {outcome}")?;
        }
        let summary = table::summarise(stratum, &results);
        println!("{summary}");
        all.push((stratum, summary, results));
    }
    if let Some(area) = table::auroc(&all) {
        println!("none_of_these_p_value: AUROC {area:.4} (singles against withheld)");
    }
    let of_records = |(stratum, ..): &reliability::Stratum<'_>| records::is_of_records(stratum);
    let (records, points): (Vec<_>, Vec<_>) = all.into_iter().partition(of_records);
    for (of, strata) in [("points", &points), ("records", &records)] {
        if !strata.is_empty() {
            println!("{of}\n{}", reliability::text(strata));
        }
    }
    if let Ok(path) = std::env::var("CALIB_BENCH_CASES") {
        std::fs::write(path, lines)?;
    }
    if let Ok(path) = std::env::var("CALIB_BENCH_JSON") {
        std::fs::write(path, table::json(seed, &points, &records))?;
    }
    Ok(())
}
