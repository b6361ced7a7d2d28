//! Does U hold on a site? `./run bench reality [--core [--exciter]] [--runs N] [--seed N] [EFFECT ...]`.

use calib_tests::reality::{self, BANDS_HZ, Sizes, Stratum, Tally, Through};
use calib_tests::rigged::Fault;

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
        "{} runs of each effect, a point in each band; shares in percent of the points, the worst band's of its runs\n\n{HEADING}",
        arguments.runs,
    );
    let mut all = Vec::new();
    for (name, index) in arguments.strata.iter().zip(1_u64..) {
        // Other rigs for each effect.
        let first_seed = arguments.seed + 1_000_000 * index;
        let stratum = reality::run(&sizes, arguments.through, name, arguments.runs, first_seed)?;
        show(name, &stratum.bands);
        all.push((name.clone(), stratum));
    }
    println!(
        "\nthe same runs, the certificates not told the mounted resonance of the data sheet\n"
    );
    for (name, stratum) in all.iter().filter(|(name, _)| has_mount(name)) {
        show(name, &stratum.without_data_sheet);
    }
    let mut pooled = Stratum::default();
    all.iter()
        .for_each(|(_, stratum)| pooled.merge(stratum.clone()));
    println!("\nall\n");
    for (band, [from, to]) in pooled.bands.iter().zip(BANDS_HZ) {
        show(
            &format!("{from:.0} to {to:.0} Hz"),
            std::slice::from_ref(band),
        );
    }
    show("all", &pooled.bands);
    judge(&arguments, &all);
    for (name, stratum) in &all {
        println!("\n{name}: refused {:?}", stratum.reasons);
        stratum.wrong.iter().for_each(|line| println!("  {line}"));
    }
    write(&arguments, &all)
}

/// Strata in which the data sheet may say something: nothing, and the mount.
fn has_mount(name: &str) -> bool {
    [reality::CLEAN, "mount_compliance"].contains(&name)
}

const HEADING: &str = "effect                    right refused   told warned wrong S   phase   > 2 U worst S   phase   U, %  U/inf  worst band";

fn show(name: &str, bands: &[Tally]) {
    let mut tally = Tally::default();
    bands.iter().for_each(|band| tally.merge(band));
    let worst = bands.iter().map(|band| band.percent(band.wrong()));
    println!(
        "{name:<24} {:>6.1} {:>7.1} {:>6.1} {:>6.1} {:>7.1} {:>7.1} {:>7.2} {:>7.2} {:>7.2} {:>6.2} {:>6.2} {:>11.1}",
        tally.percent(tally.right),
        tally.percent(tally.refused),
        tally.percent(tally.told),
        tally.percent(tally.warned),
        tally.percent(tally.wrong_magnitude),
        tally.percent(tally.wrong_phase),
        tally.percent(tally.beyond_2_u),
        tally.worst_magnitude,
        tally.worst_phase,
        tally.mean_expanded_percent(),
        reality::over_informed(bands),
        worst.fold(0.0, f64::max),
    );
}

/// Strata, an effect in a band, that are wrong in more runs than a true share of 4.55 % may show, and above 5 % pooled.
fn judge(arguments: &Arguments, all: &[(String, Stratum)]) {
    let most = reality::most_by_chance(arguments.runs as u32);
    println!(
        "\nof {} runs {most} may be wrong in one of some 200 strata where U holds in 95.45 %; more are in:",
        arguments.runs
    );
    let mut none = true;
    for (name, stratum) in all {
        let told = [
            ("", &stratum.bands),
            (", not told the data sheet", &stratum.without_data_sheet),
        ];
        for (how, bands) in told {
            for (band, [from, to]) in bands.iter().zip(BANDS_HZ) {
                if band.wrong() > most {
                    none = false;
                    println!("  {name}{how}, {from:.0} to {to:.0} Hz: {}", band.wrong());
                }
            }
        }
    }
    if none {
        println!("  none");
    }
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
            "--exciter" if read.through == Through::Core => {
                read.through = Through::CoreToldExciter;
            }
            "--exciter" => return Err("--exciter goes behind --core".into()),
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
            "without_data_sheet": stratum.without_data_sheet,
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
