//! Boots the firmware image for some virtual seconds and prints what there is to see.
//!
//! `cargo run --release -p calib-twin --example boot [SECONDS] [TEXT TO SEND]`

use std::time::{Duration, Instant};

use calib_twin::plant::Plant;
use calib_twin::rig::Rig;
use calib_twin::runner::{Emulator, Error, Firmware};

fn main() -> Result<(), Error> {
    let mut arguments = std::env::args().skip(1);
    let seconds = arguments.next().and_then(|text| text.parse().ok());
    let duration = Duration::from_secs_f64(seconds.unwrap_or(1.0));
    let firmware = Firmware::shipping()?;
    let mut board = Emulator::power_on(&firmware, Box::new(Plant::new(&Rig::standard())))?;
    let start = Instant::now();
    board.run_for(duration / 2)?;
    if let Some(text) = arguments.next() {
        board.write_serial(text.as_bytes());
    }
    board.run_for(duration / 2)?;
    let wall = start.elapsed();
    println!(
        "serial:       {:?}",
        String::from_utf8_lossy(&board.read_serial())
    );
    for line in board.log().lines(&firmware) {
        println!("log:          {line}");
    }
    println!("lamps:        {:?}", board.leds()?);
    println!("drive code:   {}", board.drive_code());
    println!("sample pairs: {}", board.sample_pairs());
    println!("silent for:   {:?}", board.silent_for());
    println!("resets:       {:?}", board.resets()?);
    println!("instructions: {}", board.instructions());
    for gap in board.gaps()? {
        println!("gap:          {}", gap.0);
    }
    let speed = duration.as_secs_f64() / wall.as_secs_f64();
    println!("speed:        {speed:.2} times real time ({wall:.2?} of wall time)");
    Ok(())
}
