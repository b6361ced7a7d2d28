//! `./run bench hard-hostile [RESETS]`: hosts that do their worst on both links while the shipping
//! firmware measures. Fails when an answer takes longer than 100 ms, when a record is not, to the byte,
//! that of an undisturbed run, and when anything was changed that nobody was allowed to.

use calib_core::point::PointSpec;
use calib_tests::rigged::{Fault, point};
use calib_tests::siege::{Assault, End, Siege, Toll, run, run_resets};
use std::time::Instant;

/// Resets in the middle of a download when nothing else is said.
const RESETS: u32 = 1000;

fn main() -> Result<(), Fault> {
    let resets = std::env::args().nth(1).and_then(|text| text.parse().ok());
    let points = points();
    let start = Instant::now();
    let quiet = [
        Siege::quiet_record(End::Serial, &points)?,
        Siege::quiet_record(End::Usb, &points)?,
    ];
    println!(
        "{:<44} {:>6} {:>9} {:>7} {:>8} {:>5} {:>8}",
        "attack on a calibrator that measures", "blows", "kB", "asked", "slowest", "runs", "time"
    );
    let mut all = Vec::new();
    for assault in Assault::ALL {
        let of_holder = &quiet[usize::from(assault.holder() == End::Usb)];
        let toll = run(assault, &points, of_holder)
            .map_err(|fault| format!("{}: {fault}", assault.name()))?;
        all.push((assault.name(), toll));
        print(assault.name(), &toll);
    }
    let name = "both: a host that resets mid-download";
    let toll = run_resets(resets.unwrap_or(RESETS), &points, &quiet[0])?;
    all.push((name, toll));
    print(name, &toll);
    let seconds = start.elapsed().as_secs_f64();
    println!(
        "no other answer late, no record, setting or sample changed, no restart; {seconds:.0} s"
    );
    if let Some(path) = std::env::var_os("CALIB_BENCH_JSON") {
        let json = serde_json::json!({ "attacks": all, "seconds": seconds });
        std::fs::write(path, json.to_string())?;
    }
    Ok(())
}

/// A run long enough for some hundred attacks.
fn points() -> Vec<PointSpec> {
    let frequencies_hz = [
        20.0, 40.0, 80.0, 160.0, 315.0, 630.0, 1250.0, 2500.0, 5000.0, 8000.0,
    ];
    frequencies_hz
        .map(|frequency_hz| point(frequency_hz, 10.0))
        .to_vec()
}

fn print(name: &str, toll: &Toll) {
    println!(
        "{name:<44} {:>6} {:>9.1} {:>7} {:>5.1} ms {:>5} {:>6.1} s",
        toll.blows,
        toll.bytes as f64 / 1000.0,
        toll.asked,
        toll.slowest_ms,
        toll.runs,
        toll.virtual_s,
    );
}
