//! Pictures of the page for the documentation, made by `./run screenshots`: a whole
//! calibration of the emulated calibrator, in a browser.

use calib_tests::bench::Fault;
use calib_tests::browser::{Browser, driver};
use calib_tests::live::Live;
use calib_tests::served::Served;
use calib_twin::rig::Rig;
use std::path::Path;

fn main() -> Result<(), Fault> {
    let folder = std::env::args().nth(1).ok_or("usage: screenshots FOLDER")?;
    let folder = Path::new(&folder);
    let driver = driver().ok_or("CALIB_CHROMEDRIVER names no driver")?;
    let bench = tempfile::tempdir()?;
    let live = Live::power_on(Rig::draw(2))?;
    let server = Served::start(bench.path(), &["--device", &live.address])?;
    let page = Browser::start(&driver)?;
    page.screen(1280, 1000, 1.0, false)?;
    page.open(&server.url)?;
    page.wait_for_text("#link", "connected to")?;
    page.click("#registration summary")?;
    page.fill("#new-serial", "LW 12345")?;
    page.fill("#register [name=manufacturer]", "Examplia")?;
    page.fill("#register [name=model]", "352C33")?;
    page.fill("#register [name=sensitivity]", "95")?;
    page.choose("#register [name=unit]", "mV/g")?;
    page.fill("#register [name=tolerance]", "5:nominal:reference")?;
    page.click("#register button")?;
    page.wait_for_text("#sensor", "LW 12345")?;
    page.fill("#operator", "N. N.")?;
    page.fill("#temperature", "22.6")?;
    page.click("#start")?;
    page.wait_for_text("#state", "measuring point 20 of 28")?;
    take(&page, &folder.join("page.png"))?;
    page.wait_for_text("#verdict", "PASS")?;
    page.screen(390, 844, 1.5, true)?;
    take(&page, &folder.join("page-phone.png"))?;
    page.value("document.getElementById('points').scrollIntoView()")?;
    std::fs::write(folder.join("page-points.png"), page.screenshot()?)?;
    page.screen(1280, 800, 1.0, false)?;
    page.click("#enlarge")?;
    take(&page, &folder.join("page-large.png"))
}

fn take(page: &Browser, path: &Path) -> Result<(), Fault> {
    // Where the forms led is not where a reader begins.
    page.value("document.activeElement.blur()")?;
    page.value("document.getElementById('content').scrollTo(0, 0)")?;
    std::thread::sleep(std::time::Duration::from_millis(300));
    std::fs::write(path, page.screenshot()?)?;
    println!("{}", path.display());
    Ok(())
}
