//! A calibration as a moving picture.

use calib_tests::browser::Browser;
use calib_tests::rigged::Fault;
use image::codecs::gif::{GifEncoder, Repeat};
use image::{Delay, Frame, ImageFormat};
use std::fs::File;
use std::path::Path;
use std::time::{Duration, Instant};

/// Time that a point is shown, and the conformity at the end.
const POINT: Duration = Duration::from_millis(300);
const CONFORMITY: Duration = Duration::from_secs(4);
/// Effort of the encoder, 1 to 30: the colours of the page are few.
const SPEED: i32 = 10;
/// A default list takes a minute and a half on an emulated calibrator beside a browser.
const LONGEST: Duration = Duration::from_secs(300);

/// Starts a calibration, and takes a picture of each point and of the conformity.
///
/// # Errors
/// The page does not do what it should, or the file cannot be written.
pub(crate) fn calibration(page: &Browser, path: &Path) -> Result<(), Fault> {
    let mut encoder = GifEncoder::new_with_speed(File::create(path)?, SPEED);
    encoder.set_repeat(Repeat::Infinite)?;
    page.click("#start")?;
    page.wait_for_text("#state", "point 1 of")?;
    top(page)?;
    let (begun, mut shown) = (Instant::now(), 0);
    while page.text("#state")? != "finished" {
        if begun.elapsed() > LONGEST {
            return Err("the calibration does not end".into());
        }
        let points = page.value("document.querySelectorAll('#plot .point').length")?;
        let points = points.as_u64().unwrap_or(0);
        if points > shown {
            shown = points;
            encoder.encode_frame(frame(page, POINT)?)?;
        }
        std::thread::sleep(Duration::from_millis(100));
    }
    page.wait_for_text("#conformity", "PASS")?;
    top(page)?;
    encoder.encode_frame(frame(page, CONFORMITY)?)?;
    println!("{}", path.display());
    Ok(())
}

fn top(page: &Browser) -> Result<(), Fault> {
    page.value("document.activeElement.blur()")?;
    page.value("document.getElementById('content').scrollTo(0, 0)")?;
    Ok(())
}

fn frame(page: &Browser, shown: Duration) -> Result<Frame, Fault> {
    let picture = image::load_from_memory_with_format(&page.screenshot()?, ImageFormat::Png)?;
    let delay = Delay::from_saturating_duration(shown);
    Ok(Frame::from_parts(picture.into_rgba8(), 0, 0, delay))
}
