//! From a click on STOP in a real browser to an exciter at rest: everything that ships is in between.
//!
//! Ten tabs of the page, the server, a TCP link, and the shipping image on the emulated board at the pace of
//! the wall. The click's instant is the browser's own, the rest's is the board's, by one clock. A computer with
//! too much to do falls behind with the emulated board, which no board of its own does: the time that it was
//! behind at that instant is taken off, and told.

use calib_tests::bench::Fault;
use calib_tests::browser::{Browser, Tab};
use calib_tests::live::Live;
use calib_tests::served::Served;
use calib_twin::rig::Rig;
use rand_chacha::ChaCha20Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use std::path::Path;
use std::time::{Duration, Instant};

/// Tabs that are open; a browser gives a host six connections.
const TABS: usize = 10;
/// Longest wait for an exciter to move, or to be told stopped.
const PATIENCE: Duration = Duration::from_secs(30);
/// Longer than any wait before a stop.
const LIST: &str = "20 25 31.5 40 50 63 80 100 125 160 200 250 315 400 500";

/// Notes when STOP was clicked, ms since 1970, and how often the alarm came up, or, where the page itself had no
/// time for that, was told with the confirmation.
const WATCH: &str = "(() => {
    window.clicked_ms = 0; window.alarms = 0; window.told = 0;
    const alarm = document.getElementById('alarm'), late = document.getElementById('late');
    new MutationObserver(() => { if (!late.hidden) window.told += 1; })
        .observe(late, { attributes: true, attributeFilter: ['hidden'] });
    document.getElementById('stop').addEventListener('click',
        (event) => { window.clicked_ms = performance.timeOrigin + event.timeStamp; }, true);
    new MutationObserver(() => { if (!alarm.hidden) window.alarms += 1; })
        .observe(alarm, { attributes: true, attributeFilter: ['hidden'] }); })()";

/// What became of the clicks.
#[derive(Default)]
pub(crate) struct Clicks {
    /// From the click to the beginning of rest, less what the board was behind.
    pub(crate) times: Vec<Duration>,
    /// The same with it.
    pub(crate) with_lag: Vec<Duration>,
    /// Full screen, at its time.
    pub(crate) alarms: u64,
    /// That it was late, with the confirmation.
    pub(crate) told: u64,
    /// Later than promised, and no alarm.
    pub(crate) silent_failures: usize,
}

/// `tries` clicks at random instants of settling and measuring.
pub(crate) fn clicks(driver: &Path, tries: usize, promised: Duration) -> Result<Clicks, Fault> {
    let folder = tempfile::tempdir()?;
    let live = Live::power_on(Rig::draw(2))?;
    let server = Served::start(folder.path(), &["--device", &live.address])?;
    let page = Browser::start(driver)?;
    let _tabs = open(&page, &server.url)?;
    let mut draws = ChaCha20Rng::seed_from_u64(18);
    let mut clicks = Clicks::default();
    for _ in 0..tries {
        begin(&page, &live)?;
        std::thread::sleep(Duration::from_millis(u64::from(draws.next_u32() % 1500)));
        let before = (clicks.alarms, clicks.told);
        let with_lag = stop(&page, &live)?;
        let time = with_lag.saturating_sub(live.behind_at_rest());
        clicks.alarms = page.value("window.alarms")?.as_u64().ok_or("no count")?;
        clicks.told = page.value("window.told")?.as_u64().ok_or("no count")?;
        let is_told = before != (clicks.alarms, clicks.told);
        clicks.silent_failures += usize::from(time > promised && !is_told);
        clicks.times.push(time);
        clicks.with_lag.push(with_lag);
    }
    Ok(clicks)
}

/// Opens the tabs; clicks go to the last.
fn open(page: &Browser, url: &str) -> Result<Vec<Tab>, Fault> {
    page.open(url)?;
    page.wait_for_text("#link", "connected to")?;
    let mut tabs = Vec::new();
    for _ in 1..TABS {
        tabs.push(page.open_tab(url)?);
        page.wait_for_text("#link", "connected to")?;
    }
    page.value(WATCH)?;
    page.choose("#list", "typed")?;
    page.fill("#frequencies", LIST)?;
    Ok(tabs)
}

fn begin(page: &Browser, live: &Live) -> Result<(), Fault> {
    let begun = Instant::now();
    while live.at_rest_since().is_some() {
        if begun.elapsed() > PATIENCE {
            return Err(format!("nothing moves: {}", page.text("#state")?).into());
        }
        // The button is dead until the page has heard of the end of the run before.
        if page.value("document.getElementById('start').disabled")? == false {
            page.click("#start")?;
        }
        std::thread::sleep(Duration::from_millis(50));
    }
    Ok(())
}

/// From the click to the rest that lasted until the page said stopped.
fn stop(page: &Browser, live: &Live) -> Result<Duration, Fault> {
    page.click("#stop")?;
    page.wait_for_text("#state", "stopped")?;
    // That it is stopped comes by the page's channel; what the page says of its own click may come after it.
    let begun = Instant::now();
    while page.value("document.getElementById('stop').classList.contains('sent')")? == true {
        if begun.elapsed() > PATIENCE {
            return Err("the page never says what became of the click".into());
        }
        std::thread::sleep(Duration::from_millis(5));
    }
    let clicked_ms = page.value("window.clicked_ms")?.as_f64();
    let clicked = Duration::from_secs_f64(clicked_ms.ok_or("no click")? / 1e3);
    let rest = live.at_rest_since().ok_or("told as stopped, and moves")?;
    // Between two points the exciter rests already.
    Ok(rest.saturating_sub(clicked))
}
