//! The page of `calib serve` in a browser, with the shipping image behind it.
#![cfg(unix)]

mod everybody;
mod sensors;

use calib_signing::Kind;
use calib_tests::browser::{Browser, Tab, driver};
use calib_tests::live::Live;
use calib_tests::rigged::Fault;
use calib_tests::served::Served;
use calib_twin::rig::Rig;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// Particulars the page asks for: the day of issue and who authorises. The logo is another file.
const LEFT_OUT: [&str; 3] = ["issued", "approved_by", "logo"];

/// A laboratory that states all there is but this.
fn laboratory(folder: &Path, left_out: &[&str]) -> Result<String, Fault> {
    let example = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/certificate/laboratory.toml");
    let example = std::fs::read_to_string(example)?;
    let stated = |line: &&str| !left_out.iter().any(|key| line.starts_with(key));
    let lines: Vec<_> = example.lines().filter(stated).collect();
    let path = folder.join("laboratory.toml");
    std::fs::write(&path, lines.join("\n"))?;
    Ok(path.to_str().ok_or("no text")?.to_owned())
}

/// The laboratory's key, of the tests.
const SEAL: &str = concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/../host-tool/signing/test-keys/p256.p12"
);

/// The file of its password.
fn password(folder: &Path) -> Result<String, Fault> {
    let path = folder.join("password");
    std::fs::write(&path, "test\n")?;
    Ok(path.to_str().ok_or("no text")?.to_owned())
}

/// A serial number that no form may mistake for anything else.
const SERIAL: &str = "D'1 ⚡";

/// A board that keeps real time and a browser are all that two cores carry: one test after the other.
static TURN: Mutex<()> = Mutex::new(());

/// Calibrator, server and browser.
struct Setup {
    browser: Browser,
    server: Served,
    live: Live,
    folder: tempfile::TempDir,
    turn: MutexGuard<'static, ()>,
}

impl Setup {
    /// `None`, after saying so, without a browser.
    fn new() -> Result<Option<Self>, Fault> {
        Self::without(&LEFT_OUT)
    }

    /// With a laboratory that leaves this out of its statements.
    fn without(left_out: &[&str]) -> Result<Option<Self>, Fault> {
        let Some(driver) = driver() else {
            return Ok(None);
        };
        let turn = TURN.lock().unwrap_or_else(PoisonError::into_inner);
        let folder = tempfile::tempdir()?;
        Ok(Some(Self {
            live: Live::power_on(Rig::draw(2))?,
            server: Served::start(
                folder.path(),
                &[
                    ["--laboratory", &laboratory(folder.path(), left_out)?],
                    ["--sign", SEAL],
                    ["--password-file", &password(folder.path())?],
                ]
                .concat(),
            )?,
            browser: Browser::start(&driver)?,
            folder,
            turn,
        }))
    }

    /// Opens the page, and connects by it.
    fn connect(&self) -> Result<(), Fault> {
        self.browser.open(&self.server.url)?;
        self.browser.wait_for_text("#link", "not connected")?;
        self.browser.fill("#device", &self.live.address)?;
        self.browser.click("#connect button")?;
        self.browser.wait_for_text("#link", "connected to tcp:")
    }

    /// Types a list and a serial number, and starts.
    fn start(&self, frequencies: &str) -> Result<(), Fault> {
        self.browser.choose("#list", "typed")?;
        self.browser.fill("#frequencies", frequencies)?;
        self.browser.fill("#serial", SERIAL)?;
        self.browser.click("#start")
    }

    fn silent_within(&self, limit: Duration) -> bool {
        self.sees_within(limit, |silent_for| silent_for > Duration::from_millis(100))
    }

    /// The exciter moves: it rests between two points, for less than this.
    fn moves(&self) -> bool {
        self.sees_within(Duration::from_secs(10), |silent_for| silent_for.is_zero())
    }

    fn sees_within(&self, limit: Duration, wanted: impl Fn(Duration) -> bool) -> bool {
        let begun = Instant::now();
        while begun.elapsed() < limit {
            if wanted(self.live.silent_for()) {
                return true;
            }
            std::thread::sleep(Duration::from_millis(5));
        }
        false
    }
}

#[test]
fn a_calibration_from_the_first_look_to_the_certificate() -> Result<(), Fault> {
    let Some(setup) = Setup::new()? else {
        return Ok(());
    };
    let page = &setup.browser;
    everybody::begins_by_keyboard(&setup, "80 160 1000")?;
    assert!(page.text("#info")?.contains("firmware"));
    page.wait_for_text("#state", "point 1 of 3")?;
    page.wait_for_text("#target", "10.0")?;
    // Points appear one by one, on the plot as in the table.
    page.wait_for_text("#state", "point 2 of 3")?;
    assert_eq!(
        page.value("document.querySelectorAll('#plot .point').length")?,
        1
    );
    page.wait_for_text("#state", "finished")?;
    assert_eq!(
        page.value("document.querySelectorAll('#plot .point').length")?,
        3
    );
    let table = page.text("#points")?;
    assert_eq!(
        page.value("document.querySelectorAll('#points .refused').length")?,
        0,
        "{table}"
    );
    assert_eq!(table.lines().count(), 3, "{table}");
    // The transducer of this rig is 7 % below the nominal value that the laboratory wants within 5 %.
    page.wait_for_text("#conformity", "FAIL")?;
    page.wait_for_text("#points .failed", "160")?;
    everybody::can_use_it(page)?;
    everybody::ends_by_keyboard(page)?;
    inputs_are_drawn(page)?;
    let measured = sensitivity_at_160(page)?;
    page.wait_for_text("#kept", "kept in the logbook")?;
    page.wait_for_text("#records", "D'1 ⚡")?;
    certificates_hold(&setup, measured)?;
    history_is_drawn(page)?;
    everybody::fits_a_phone(&setup)?;
    everybody::speaks_german(&setup)
}

/// Waveforms and spectra of both inputs, as the last of them shows them.
fn inputs_are_drawn(page: &Browser) -> Result<(), Fault> {
    page.wait_for_text("#played", "Hz")?;
    for plot in ["waveform", "spectrum"] {
        let traces = format!("document.querySelectorAll('#{plot} polyline.trace').length");
        assert_eq!(page.value(&traces)?, 2, "{plot}");
    }
    Ok(())
}

/// S at 160 Hz as the page's table shows it.
fn sensitivity_at_160(page: &Browser) -> Result<String, Fault> {
    let cell = "document.querySelectorAll('#points tr')[1].children[2].textContent";
    Ok(page.value(cell)?.as_str().ok_or("no text")?.to_owned())
}

/// Viewed in its own tab with its style, downloaded in every other form.
fn certificates_hold(setup: &Setup, measured: String) -> Result<(), Fault> {
    let page = &setup.browser;
    let (own, certificate) = certificate_viewed(page)?;
    assert!(certificate.contains("DRAFT"), "{certificate}");
    page.switch_to(own)?;
    page.fill("#approved_by", "Dr A. Examiner")?;
    page.value(
        "(() => { const issued = document.getElementById('issued');
        issued.value = new Date().toISOString().slice(0, 10);
        issued.dispatchEvent(new Event('change')); })()",
    )?;
    let (own, certificate) = certificate_viewed(page)?;
    assert!(!certificate.contains("DRAFT"), "{certificate}");
    assert!(certificate.contains("Dr A. Examiner"), "{certificate}");
    // U has two digits, so the certificate rounds what the page shows.
    assert!(
        certificate.contains(&measured[..4]),
        "{measured}: {certificate}"
    );
    assert!(certificate.contains("D'1 ⚡"), "{certificate}");
    let styled = "document.styleSheets.length > 0 && document.styleSheets[0].cssRules.length > 5";
    assert_eq!(page.value(styled)?, true);
    page.switch_to(own)?;
    for (format, ending, begins) in [
        ("pdf", ".pdf", "%PDF-1.7"),
        ("dcc", ".dcc.xml", "<?xml"),
        ("csv", ".csv", "\u{feff}"),
        ("json", ".json", "{"),
        ("uff", ".uff", "    -1"),
    ] {
        page.click(&format!("#certificates a[data-format={format}]"))?;
        let content = downloaded(&page.downloads(), ending)?;
        assert!(content.len() > 500, "{ending}");
        assert!(content.starts_with(begins.as_bytes()), "{ending}");
        if let Some(kind) = Kind::of(&content) {
            let signature = calib_signing::verify(kind, &content)?;
            page.wait_for_text("#signer", &signature.by.subject())?;
        }
    }
    Ok(())
}

/// The certificate's own tab, with the page's and the text.
fn certificate_viewed(page: &Browser) -> Result<(Tab, String), Fault> {
    let link = page.value("document.querySelector('#certificates a[data-format=html]').href")?;
    let own = page.open_tab(link.as_str().ok_or("no link")?)?;
    Ok((own, page.text("body")?))
}

/// Waits for a download to be complete.
fn downloaded(folder: &Path, ending: &str) -> Result<Vec<u8>, Fault> {
    let begun = Instant::now();
    while begun.elapsed() < Duration::from_secs(20) {
        let files = std::fs::read_dir(folder).into_iter().flatten().flatten();
        let mut paths: Vec<PathBuf> = files.map(|file| file.path()).collect();
        paths.retain(|path| path.to_string_lossy().ends_with(ending));
        if let Some(path) = paths.first() {
            return Ok(std::fs::read(path)?);
        }
        std::thread::sleep(Duration::from_millis(50));
    }
    Err(format!("no {ending} was downloaded").into())
}

fn history_is_drawn(page: &Browser) -> Result<(), Fault> {
    page.click("#records td button")?;
    page.wait_for_text("#drift", "calibrated once")?;
    assert_eq!(
        page.value("document.querySelectorAll('#history-plot .point').length")?,
        1
    );
    Ok(())
}

#[test]
fn a_lost_link_two_tabs_and_a_stop_that_silences() -> Result<(), Fault> {
    let Some(setup) = Setup::new()? else {
        return Ok(());
    };
    let page = &setup.browser;
    setup.connect()?;
    setup.start("80 160 315")?;
    page.wait_for_text("#state", "point 1 of 3")?;
    setup.live.unplug(true);
    page.wait_for_text("#link", "link lost")?;
    page.wait_for_text("#trouble", "use the button on the instrument")?;
    setup.live.unplug(false);
    page.wait_for_text("#state", "finished")?;
    assert_eq!(
        page.value("document.querySelectorAll('#points tr').length")?,
        3
    );
    assert_eq!(
        page.value("document.getElementById('trouble').hidden")?,
        true
    );

    // Another tab sees the next run, and stops it.
    setup.start("20 40 80 160 315 630 1250")?;
    page.wait_for_text("#state", "point 1 of 7")?;
    let first = page.open_tab(&setup.server.url)?;
    page.wait_for_text("#state", "of 7")?;
    assert_eq!(
        page.value("document.getElementById('start').disabled")?,
        true
    );
    assert!(setup.moves(), "the exciter is silent");
    page.click("#stop")?;
    // Two looks of a tenth of a second each, the answers, and a loaded computer.
    assert!(setup.silent_within(Duration::from_secs(2)), "it goes on");
    page.wait_for_text("#state", "stopped, the exciter is silent")?;
    let second = page.switch_to(first)?;
    page.wait_for_text("#state", "stopped, the exciter is silent")?;
    assert_eq!(
        page.value("document.getElementById('start').disabled")?,
        false
    );
    drop(second);
    ctrl_c_ends_it(setup)
}

/// A browser gives a host six connections: six pages with a stream each left none for a stop, which was
/// delivered when a tab closed, to the next run.
#[test]
fn ten_tabs_leave_room_for_a_stop_and_one_that_fails_fills_the_screen() -> Result<(), Fault> {
    let Some(setup) = Setup::new()? else {
        return Ok(());
    };
    let page = &setup.browser;
    setup.connect()?;
    // Twenty seconds: longer than ten tabs take to open on a loaded computer.
    let slow: Vec<String> = (20..50).map(|hz: u32| hz.to_string()).collect();
    setup.start(&slow.join(" "))?;
    page.wait_for_text("#state", "point 1 of 30")?;
    for _ in 1..10 {
        page.open_tab(&setup.server.url)?;
        page.wait_for_text("#state", "of 30")?;
    }
    assert!(setup.moves(), "the exciter is silent");
    page.click("#stop")?;
    assert!(setup.silent_within(Duration::from_secs(2)), "it goes on");
    page.wait_for_text("#state", "stopped, the exciter is silent")?;

    // Nobody confirms a stop over a link that is cut: that is all there is to see.
    setup.start("20 40 80 160 315 630 1250")?;
    page.wait_for_text("#state", "point 1 of 7")?;
    setup.live.unplug(true);
    page.wait_for_text("#link", "link lost")?;
    page.click("#stop")?;
    page.wait_for_text("#alarm", "NOT STOPPED")?;
    page.wait_for_text("#alarm", "button on the instrument")?;
    let covers = "(() => { const r = document.getElementById('alarm').getBoundingClientRect();
        return r.width >= innerWidth && r.height >= innerHeight; })()";
    assert_eq!(page.value(covers)?, true);
    // The stop is delivered with the link, to the run it was for, and the alarm ends.
    setup.live.unplug(false);
    page.wait_for_text("#state", "stopped, the exciter is silent")?;
    let hidden = "document.getElementById('alarm').hidden";
    page.wait_for_text("#link", "connected")?;
    let begun = Instant::now();
    while page.value(hidden)? != true {
        assert!(begun.elapsed() < Duration::from_secs(10), "the alarm stays");
        std::thread::sleep(Duration::from_millis(50));
    }
    assert!(setup.silent_within(Duration::from_secs(2)));
    Ok(())
}

/// Ctrl-C during a run, with the pages' channels open.
fn ctrl_c_ends_it(setup: Setup) -> Result<(), Fault> {
    // Two points end sooner than a browser looks twice.
    setup.start("20 40 80 160 315 630 1250")?;
    setup.browser.wait_for_text("#state", "of 7")?;
    let begun = Instant::now();
    let Setup {
        server,
        live,
        browser,
        folder,
        turn: _turn,
    } = setup;
    let status = server.interrupt()?;
    assert!(status.success(), "{status}");
    // A second, and another for a loaded computer.
    assert!(
        begun.elapsed() < Duration::from_secs(2),
        "{:?}",
        begun.elapsed()
    );
    // It is silent when the tool has ended, not some time later, and stays so.
    for _ in 0..20 {
        assert!(!live.silent_for().is_zero(), "the exciter moves");
        std::thread::sleep(Duration::from_millis(5));
    }
    browser.wait_for_text("#trouble", "the server does not answer")?;
    assert!(folder.path().join("logbook.sqlite").exists());
    Ok(())
}
