//! Correlations side by side, in one run of one program.

use crate::row::Row;
use calib_tests::rigged::Fault;
use calib_twin::plant::Plant;
use calib_twin::rig::Rig;
use calib_twin::runner::{Emulator, Firmware, Mark};
use std::path::Path;
use std::time::Duration;

/// Pairs of the buffer every kernel takes.
const PAIRS: f64 = 500.0;
/// Places of the fold whose evaluation is counted.
const FOLD: f64 = 625.0;
/// Pairs of the block.
const BLOCK: f64 = 5000.0;
/// Cycles between two pairs: 480 MHz over 50 kHz.
const BUDGET_CYCLES: f64 = 9600.0;
/// Fewest instructions for adding a pair to two sums: two additions, and one to
/// move its five words: LDM of 3 pairs, LDM of their 6 sums and STM of them take
/// nearly all registers there are.
const LEAST_FOLD: f64 = 3.0;
/// Fewest for the direct way: two conversions, four multiply-accumulates.
const LEAST_DIRECT: f64 = 6.0;

/// Counts them all.
pub(crate) fn measure() -> Result<Vec<Row>, Fault> {
    let image = std::env::var_os("CALIB_KERNELS_ELF")
        .ok_or("CALIB_KERNELS_ELF names no image: run `./run bench target`")?;
    let firmware = Firmware::read(Path::new(&image))?;
    let rig = Box::new(Plant::new(&Rig::standard()));
    let mut board = Emulator::power_on(&firmware, rig)?;
    // Start-up, and tables.
    board.run_for(Duration::from_millis(20))?;
    let end = Mark::Arrival(firmware.symbol("kernel_done")?);
    let mut count = |kernel: &str| -> Result<f64, Fault> {
        let start = Mark::Arrival(firmware.symbol(kernel)?);
        let passages = board.watch_passages(start, end, Duration::from_millis(20))?;
        if passages.count == 0 {
            return Err(format!("{kernel} was never called").into());
        }
        Ok(passages.mean_instructions())
    };
    let fold = count("kernel_fold")? / PAIRS;
    let table = count("kernel_table")? / PAIRS;
    let lock_in = count("kernel_lock_in")? / PAIRS;
    let estimate = count("kernel_estimate")? / FOLD;
    let [sines, libm, micromath] = [
        count("kernel_sines")?,
        count("kernel_sines_libm")?,
        count("kernel_sines_micromath")?,
    ]
    .map(|instructions| instructions / PAIRS);
    let evaluated = fold + estimate * FOLD / BLOCK;
    let unit = "instr/pair";
    Ok(vec![
        Row::new("correlation that ships, every pair", fold, unit)
            .limit(LEAST_FOLD, "two additions, LDM and STM of three pairs"),
        Row::new("f32 table multiply-accumulate", table, unit)
            .limit(LEAST_DIRECT, "two conversions, four VFMA"),
        Row::new("idsp 0.23 lock-in, first order", lock_in, unit)
            .note("no mean, harmonics, noise or clipping"),
        Row::new(
            "evaluation of a block, every place",
            estimate,
            "instr/place",
        )
        .note("harmonics 1 to 5, mean, residual of both channels"),
        Row::new("correlation with evaluation, 0.1 s", evaluated, unit)
            .note("160 Hz: 5000 pairs in 8 folds of 625 places"),
        Row::new("the same, share of the 20 us", percent(evaluated), "%")
            .note("9600 cycles at 480 MHz, an instruction in each"),
        Row::new("lock-in, share of the 20 us", percent(lock_in), "%"),
        Row::new("cosine and sine, ours", sines, "instructions").note("1.2e-7 absolute"),
        Row::new("the same by libm", libm, "instructions").note("half a unit in the last place"),
        Row::new("the same by micromath", micromath, "instructions").note("1.1e-3"),
    ])
}

fn percent(instructions: f64) -> f64 {
    100.0 * instructions / BUDGET_CYCLES
}
