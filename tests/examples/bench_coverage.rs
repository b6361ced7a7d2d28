//! The long coverage run: `./run bench coverage [DRAWS]`.

use calib_tests::coverage;

fn main() -> Result<(), calib_tests::rigged::Fault> {
    let draws = std::env::args()
        .nth(1)
        .and_then(|text| text.parse().ok())
        .unwrap_or(2000);
    let start = std::time::Instant::now();
    let tally = coverage::run(draws, 1_000_000, |done| {
        if done % 50 == 0 {
            eprintln!("{done} of {draws} draws");
        }
    })?;
    println!("{:<12} {:>8} {:>10}", "quantity", "points", "inside U");
    println!(
        "{:<12} {:>8} {:>8.2} %",
        "magnitude",
        tally.points,
        tally.magnitude_percent()
    );
    println!(
        "{:<12} {:>8} {:>8.2} %",
        "phase",
        tally.points,
        tally.phase_percent()
    );
    for (seed, frequency_hz, reason) in &tally.refused {
        println!("refused: draw {seed} at {frequency_hz} Hz, {reason:?}");
    }
    println!(
        "{} refused; {:.0} s",
        tally.refused.len(),
        start.elapsed().as_secs_f64()
    );
    if let Some(path) = std::env::var_os("CALIB_BENCH_JSON") {
        let json = serde_json::json!({
            "draws": draws,
            "points": tally.points,
            "refused": tally.refused.len(),
            "magnitude_percent": tally.magnitude_percent(),
            "phase_percent": tally.phase_percent(),
        });
        std::fs::write(path, serde_json::to_string_pretty(&json)?)?;
    }
    Ok(())
}
