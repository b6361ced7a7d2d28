//! Speed on this computer, size of the image, and how fast levels settle:
//! `./run bench speed`.

mod emulator;
mod twin;

use calib_core::converter::Width;
use calib_core::correlation::{Block, Correlator, FoldMemory};
use calib_core::point::PointResult;
use calib_core::tone::Tone;
use calib_tests::rigged::Fault;
use serde_json::{Value, json};
use std::hint::black_box;
use std::time::{Duration, Instant};

/// Pairs the throughput is measured with.
const PAIRS: usize = 50_000_000;
/// Pairs handed over at once, as on the device.
const BUFFER: usize = 500;

fn main() -> Result<(), Fault> {
    let throughput = correlation_msamples_per_s();
    println!("correlation on this computer {throughput:>8.0} Msamples/s");
    let size = image_size()?;
    println!(
        "image: text {}, data {}, bss {} bytes",
        size["text"], size["data"], size["bss"]
    );
    let (emulator, points) = emulator::measure()?;
    let rig = twin::measure()?;
    println!(
        "\n{:>9} {:>10} {:>10} {:>11}",
        "Hz", "settled s", "cycles", "overshoot %"
    );
    for point in &points {
        print_point(point);
    }
    if let Some(path) = std::env::var_os("CALIB_BENCH_JSON") {
        let json = json!({
            "correlation_msamples_per_s": throughput,
            "image_bytes": size,
            "emulator": emulator,
            "twin": rig,
            "settling": points.iter().map(settling).collect::<Vec<_>>(),
        });
        std::fs::write(path, serde_json::to_string_pretty(&json)?)?;
    }
    Ok(())
}

/// Samples of both channels that one core of this computer correlates, with the
/// evaluation of every block of 0.1 s.
fn correlation_msamples_per_s() -> f64 {
    let tone = Tone {
        cycles: 2,
        period_samples: 625,
    };
    let block = Block::measuring(tone, 5_000);
    let mut memory = Box::new(FoldMemory::new());
    let mut correlator = Correlator::new(&mut memory, Width::of_bits(16), block, 0);
    let pairs: Vec<u32> = (0..BUFFER as u32)
        .map(|n| n.wrapping_mul(0x0101_0101))
        .collect();
    let start = Instant::now();
    let mut done = 0;
    while done < PAIRS {
        done += correlator.push(black_box(&pairs));
        if correlator.is_complete() {
            black_box(correlator.estimate());
            correlator.start(block, 0);
        }
    }
    2.0 * done as f64 / 1.0e6 / start.elapsed().max(Duration::from_nanos(1)).as_secs_f64()
}

/// Text, data and bss of the image, as `xtask` counted them.
fn image_size() -> Result<Value, Fault> {
    let sizes = std::env::var("CALIB_IMAGE_BYTES")?;
    let bytes: Vec<u64> = sizes.split(' ').map(str::parse).collect::<Result<_, _>>()?;
    match bytes[..] {
        [text, data, bss] => Ok(json!({ "text": text, "data": data, "bss": bss })),
        _ => Err(format!("CALIB_IMAGE_BYTES is `{sizes}`, not three numbers").into()),
    }
}

fn cycles(point: &PointResult) -> f32 {
    point.settling_s * point.spec.frequency_hz
}

fn print_point(point: &PointResult) {
    println!(
        "{:>9} {:>10.3} {:>10.1} {:>11.2}",
        point.spec.frequency_hz,
        point.settling_s,
        cycles(point),
        100.0 * point.overshoot_rel
    );
}

fn settling(point: &PointResult) -> Value {
    json!({
        "frequency_hz": point.spec.frequency_hz,
        "settling_s": point.settling_s,
        "settling_cycles": cycles(point),
        "overshoot_rel": point.overshoot_rel,
    })
}
