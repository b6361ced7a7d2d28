//! A waveform for other programs.

use super::Capture;
use calib_files::Result;
use calib_files::file;
use std::fmt::Write;
use std::path::Path;

/// Writes `time_s,reference_v,dut_v`, one line per pair, time from the first one
/// on. An existing file is replaced as a whole or not at all.
///
/// # Errors
/// [`crate::Error::File`].
pub fn write_csv(capture: &Capture, path: &Path) -> Result<()> {
    file::replace(path, text(capture).as_bytes())
}

fn text(capture: &Capture) -> String {
    let mut text = "time_s,reference_v,dut_v\n".to_owned();
    let pairs = capture.reference_v.iter().zip(&capture.dut_v);
    for (index, (reference_v, dut_v)) in pairs.enumerate() {
        let time_s = index as f64 / capture.sample_rate_hz;
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{time_s:.9},{reference_v:.6},{dut_v:.6}");
    }
    text
}
