//! Cost of the work on the target: `./run bench target`.
//!
//! Instructions are counted in the emulator, which knows neither caches, wait
//! states nor dual issue. Shares and times at 480 MHz take one cycle for each
//! instruction: the Cortex-M7 issues up to two, and waits for memory now and then. Deadlines are
//! met with three as well ([`waiting`]).

mod device;
mod kernels;
mod row;
mod waiting;

use calib_tests::rigged::Fault;
use row::Row;

fn main() -> Result<(), Fault> {
    let mut rows = kernels::measure()?;
    rows.extend(device::measure()?);
    rows.extend(waiting::measure()?);
    Row::print(&rows);
    if let Some(path) = std::env::var_os("CALIB_BENCH_JSON") {
        std::fs::write(path, serde_json::to_string_pretty(&Row::json(&rows))?)?;
    }
    Ok(())
}
