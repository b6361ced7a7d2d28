//! Coverage and detection of the check by reciprocity: `./run bench selfcheck [RIGS [FIRST_SEED]]`.

use calib_tests::bench::Fault;
use calib_tests::self_check::{BANDS_HZ, CHANGE_REL, DIFFERENCE_REL, FREQUENCIES_HZ, Tally, run};
use calib_twin::reciprocity::{Hold, distributions};

fn main() -> Result<(), Fault> {
    let mut numbers = std::env::args()
        .skip(1)
        .filter_map(|text| text.parse().ok());
    let rigs: u64 = numbers.next().unwrap_or(3000);
    let first_seed: u64 = numbers.next().unwrap_or(0);
    for drawn in distributions::TABLE {
        println!("{:<88} {:?}\n    {}", drawn.what, drawn.shape, drawn.basis);
    }
    let mut documents = Vec::new();
    for (name, hold) in [("held", Hold::Current), ("not held", Hold::None)] {
        let tally = run(rigs, first_seed, hold);
        println!(
            "\nposition {name}, {} calibrators, four checks each\n",
            tally.rigs
        );
        print(&tally);
        documents.push(document(name, &tally));
    }
    if let Some(path) = std::env::var_os("CALIB_BENCH_JSON") {
        std::fs::write(path, serde_json::to_string_pretty(&documents)?)?;
    }
    Ok(())
}

fn print(tally: &Tally) {
    println!(
        "{:>8} {:>10} {:>10} {:>10}",
        "f/Hz", "inside/%", "U/%", "U of 95 %"
    );
    for (index, hz) in FREQUENCIES_HZ.iter().enumerate() {
        let (inside, of) = tally.inside[index];
        println!(
            "{hz:>8} {:>10.2} {:>10.3} {:>10.3}",
            100.0 * inside as f64 / of as f64,
            100.0 * tally.expanded_quantile_rel(index, 0.5),
            100.0 * tally.expanded_quantile_rel(index, 0.95),
        );
    }
    for band in BANDS_HZ {
        println!(
            "{:>4} Hz to {:>4} Hz inside {:.2} %",
            band[0],
            band[1],
            tally.inside_percent(band)
        );
    }
    let percent = |(found, of): (u64, u64)| 100.0 * found as f64 / of as f64;
    for (against, by, [alarms, found]) in [
        ("baseline", CHANGE_REL, tally.baseline),
        ("certificate", DIFFERENCE_REL, tally.certificate),
    ] {
        println!(
            "against the {against}: {:.2} % found of {} changes of {:.2} %, {:.2} % of {} sound ones suspected",
            percent(found),
            found.1,
            100.0 * by,
            percent(alarms),
            alarms.1,
        );
    }
    println!(
        "sound against the baseline: error over u {:.2} r.m.s.",
        spread(tally)
    );
    println!(
        "refused: {} of {} checks",
        tally.refused.len(),
        4 * tally.rigs
    );
    for (seed, why) in tally.refused.iter().take(10) {
        println!("  calibrator {seed}: {why}");
    }
}

fn spread(tally: &Tally) -> f64 {
    (tally.baseline_chi2 / tally.baseline[0].1.max(1) as f64).sqrt()
}

fn document(name: &str, tally: &Tally) -> serde_json::Value {
    let points = FREQUENCIES_HZ.iter().enumerate().map(|(index, hz)| {
        serde_json::json!({
            "frequency_hz": hz,
            "inside": tally.inside[index].0,
            "of": tally.inside[index].1,
            "expanded_uncertainty_median_rel": tally.expanded_quantile_rel(index, 0.5),
            "expanded_uncertainty_of_95_rel": tally.expanded_quantile_rel(index, 0.95),
        })
    });
    serde_json::json!({
        "position": name,
        "rigs": tally.rigs,
        "refused": tally.refused.len(),
        "points": points.collect::<Vec<_>>(),
        "baseline_suspected": tally.baseline[0],
        "baseline_found": tally.baseline[1],
        "certificate_suspected": tally.certificate[0],
        "certificate_found": tally.certificate[1],
        "error_over_standard_rms": spread(tally),
    })
}
