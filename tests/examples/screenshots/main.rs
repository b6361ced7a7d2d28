//! Pictures for the documentation, made by `./run screenshots` from what is there today: a whole calibration of
//! the emulated calibrator in a browser, its certificate, a report of the gap, and notebooks.

mod moving;
mod notebooks;

use calib_tests::browser::{Browser, driver};
use calib_tests::live::Live;
use calib_tests::rigged::Fault;
use calib_tests::served::{Served, tool};
use calib_twin::rig::Rig;
use std::path::Path;
use std::process::Command;
use std::time::Duration;

fn main() -> Result<(), Fault> {
    let folder = std::env::args().nth(1).ok_or("usage: screenshots FOLDER")?;
    let folder = Path::new(&folder);
    let driver = driver().ok_or("CALIB_CHROMEDRIVER names no driver")?;
    let page = Browser::start(&driver)?;
    gap(&page, folder)?;
    notebooks::pictures(&page, folder)?;
    let rigged = tempfile::tempdir()?;
    let live = Live::power_on(Rig::draw(2))?;
    let laboratory = laboratory(rigged.path())?;
    let server = Served::start(
        rigged.path(),
        &["--device", &live.address, "--laboratory", &laboratory],
    )?;
    page.screen(760, 700, 1.0, false)?;
    page.open(&server.url)?;
    page.wait_for_text("#link", "connected to")?;
    register(&page)?;
    moving::calibration(&page, &folder.join("page.gif"))?;
    page.wait_for_text("#conformity", "PASS")?;
    certificate(&page, folder)?;
    page.open(&server.url)?;
    page.wait_for_text("#conformity", "PASS")?;
    finished(&page, folder)?;
    running(&page, folder)
}

/// The laboratory of the documentation, which leaves the tolerance to the sensor.
fn laboratory(folder: &Path) -> Result<String, Fault> {
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/certificate");
    let stated = std::fs::read_to_string(docs.join("laboratory.toml"))?;
    let stated = stated.replace("specification = ", "# specification = ");
    let path = folder.join("laboratory.toml");
    std::fs::write(&path, stated)?;
    for logo in std::fs::read_dir(docs)?.flatten() {
        if logo
            .path()
            .extension()
            .is_some_and(|ending| ending == "svg")
        {
            std::fs::copy(logo.path(), folder.join(logo.file_name()))?;
        }
    }
    Ok(path.to_str().ok_or("no text")?.to_owned())
}

/// A sensor as a laboratory has them, with the limits of its kind at the reference point.
fn register(page: &Browser) -> Result<(), Fault> {
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
    page.fill("#temperature", "22.6")
}

/// First screen of a certificate.
fn certificate(page: &Browser, folder: &Path) -> Result<(), Fault> {
    page.value(
        "(() => { const issued = document.getElementById('issued');
        issued.value = new Date().toISOString().slice(0, 10);
        issued.dispatchEvent(new Event('change')); })()",
    )?;
    let link = page.value("document.querySelector('#certificates a[data-format=html]').href")?;
    page.screen(1000, 1000, 1.0, false)?;
    page.open(link.as_str().ok_or("no link")?)?;
    keep(page, &folder.join("certificate.png"))
}

/// The result on a phone, its points, and the large display.
fn finished(page: &Browser, folder: &Path) -> Result<(), Fault> {
    page.screen(390, 844, 1.5, true)?;
    keep(page, &folder.join("page-phone.png"))?;
    page.value("document.getElementById('points').scrollIntoView()")?;
    keep(page, &folder.join("page-points.png"))?;
    page.screen(1280, 700, 1.0, false)?;
    page.value("document.getElementById('content').scrollTo(0, 0)")?;
    page.click("#enlarge")?;
    keep(page, &folder.join("page-large.png"))?;
    page.click("#enlarge")
}

/// The page on a laptop while it measures.
fn running(page: &Browser, folder: &Path) -> Result<(), Fault> {
    page.screen(1280, 1000, 1.0, false)?;
    page.choose("#sensor", "LW 12345")?;
    page.click("#start")?;
    page.wait_for_text("#state", "measuring point 20 of 28")?;
    page.value("document.activeElement.blur()")?;
    page.value("document.getElementById('content').scrollTo(0, 0)")?;
    keep(page, &folder.join("page.png"))
}

/// First screen of the report of docs/gap.md's example.
fn gap(page: &Browser, folder: &Path) -> Result<(), Fault> {
    let work = tempfile::tempdir()?;
    let effect = "suspension_cubic=k3_n_per_m3:1e7";
    let simulate = [
        "gap", "simulate", "standard", "--effect", effect, "--seed", "7",
    ];
    let diagnose = ["gap", "diagnose", "ex", "--report", "gap.html"];
    for arguments in [
        [&simulate[..], &["--out", "ex"]].concat(),
        diagnose.to_vec(),
    ] {
        let status = Command::new(tool()?)
            .args(&arguments)
            .current_dir(work.path())
            .stdout(std::process::Stdio::null())
            .status()?;
        if !status.success() {
            return Err(format!("calib {}: {status}", arguments.join(" ")).into());
        }
    }
    page.screen(1200, 660, 1.0, false)?;
    page.open(&format!(
        "file://{}",
        work.path().join("gap.html").display()
    ))?;
    keep(page, &folder.join("gap.png"))
}

fn keep(page: &Browser, path: &Path) -> Result<(), Fault> {
    // A layout that has just changed settles.
    std::thread::sleep(Duration::from_millis(300));
    std::fs::write(path, page.screenshot()?)?;
    println!("{}", path.display());
    Ok(())
}
