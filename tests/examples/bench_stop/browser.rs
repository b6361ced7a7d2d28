//! From a click on STOP in a real browser to an exciter at rest: everything that ships is in between.
//!
//! Ten tabs of the page, the server, a TCP link, and the shipping image on the emulated board at the pace of
//! the wall. The click's instant is the browser's own, the rest's is the board's, by one clock. A computer with
//! too much to do falls behind with the emulated board, which no board of its own does: the time that it was
//! behind at that instant is taken off, and told.

use crate::device::Way;
use crate::host::{Host, Obstacles};
use crate::relay::Relay;
use crate::{Situation, until};
use calib_tests::browser::{Browser, Tab};
use calib_tests::live::Live;
use calib_tests::rigged::Fault;
use calib_twin::rig::Rig;
use rand_chacha::ChaCha20Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use std::path::Path;
use std::time::{Duration, Instant};

/// Tabs that are open; a browser gives a host six connections.
const TABS: usize = 10;
/// Longest wait for an exciter to move.
const PATIENCE: Duration = Duration::from_secs(30);
/// Longest wait for the page's word about a click, and for the rest, on a link that does not answer.
const WORD: Duration = Duration::from_secs(5);
/// Longer than any wait before a stop.
const LIST: &str = "20 25 31.5 40 50 63 80 100 125 160 200 250 315 400 500";

/// Notes when STOP was clicked, ms since 1970, how often the alarm came up and how long after its click at most, or,
/// where the page itself had no time for that, was told with the confirmation.
const WATCH: &str = "(() => {
    window.clicked_ms = 0; window.alarms = 0; window.told = 0; window.alarm_ms = 0;
    const alarm = document.getElementById('alarm'), late = document.getElementById('late');
    const now = () => performance.timeOrigin + performance.now();
    new MutationObserver(() => { if (!late.hidden) window.told += 1; })
        .observe(late, { attributes: true, attributeFilter: ['hidden'] });
    document.getElementById('stop').addEventListener('click',
        (event) => { window.clicked_ms = performance.timeOrigin + event.timeStamp; }, true);
    new MutationObserver(() => { if (!alarm.hidden) {
        window.alarms += 1; window.alarm_ms = Math.max(window.alarm_ms, now() - window.clicked_ms); } })
        .observe(alarm, { attributes: true, attributeFilter: ['hidden'] }); })()";

/// Outcomes of the clicks.
#[derive(Default)]
pub(crate) struct Clicks {
    /// From the click to the beginning of rest, less what the board was behind.
    pub(crate) times: Vec<Duration>,
    /// Times with that lag.
    pub(crate) with_lag: Vec<Duration>,
    /// Full screen, at its time.
    pub(crate) alarms: u64,
    /// Longest from a click to its alarm, ms.
    pub(crate) latest_alarm_ms: f64,
    /// That it was late, with the confirmation.
    pub(crate) told: u64,
    /// Later than promised, and no alarm.
    pub(crate) silent_failures: usize,
}

/// A page with its tabs, and what is behind it.
struct Rigged {
    page: Browser,
    _tabs: Vec<Tab>,
    _obstacles: Obstacles,
    _host: Host,
    relay: Relay,
    live: Live,
    _folder: tempfile::TempDir,
}

impl Rigged {
    fn begin(driver: &Path, situation: &Situation) -> Result<Self, Fault> {
        let folder = tempfile::tempdir()?;
        let live = Live::power_on(Rig::draw(2))?;
        let relay = Relay::before(&live.address)?;
        let host = Host::start(folder.path(), &relay.address)?;
        let page = Browser::start(driver)?;
        let tabs = open(&page, &format!("http://{}/", host.page))?;
        let mut obstacles = Obstacles::default();
        let logbook = folder.path().join("logbook.sqlite");
        (situation.prepare)(&mut obstacles, &host, &logbook)?;
        Ok(Self {
            page,
            _tabs: tabs,
            _obstacles: obstacles,
            _host: host,
            relay,
            live,
            _folder: folder,
        })
    }
}

/// `tries` clicks at random instants of settling and measuring.
pub(crate) fn clicks(
    driver: &Path,
    situation: &Situation,
    tries: usize,
    seed: u64,
) -> Result<Clicks, Fault> {
    let rigged = Rigged::begin(driver, situation)?;
    let mut draws = ChaCha20Rng::seed_from_u64(seed);
    let mut clicks = Clicks::default();
    for _ in 0..tries {
        rigged.move_exciter()?;
        std::thread::sleep(Duration::from_millis(u64::from(draws.next_u32() % 1500)));
        let before = (clicks.alarms, clicks.told);
        rigged.relay.behave(situation.way);
        let with_lag = rigged.stop(situation.way)?;
        let time = with_lag.saturating_sub(rigged.live.behind_at_rest());
        rigged.relay.behave(Way::Plain);
        rigged.settle()?;
        let number = |name: &str| rigged.page.value(&format!("window.{name}"));
        clicks.alarms = number("alarms")?.as_u64().ok_or("no count")?;
        clicks.told = number("told")?.as_u64().ok_or("no count")?;
        clicks.latest_alarm_ms = number("alarm_ms")?.as_f64().ok_or("no time")?;
        let is_told = before != (clicks.alarms, clicks.told);
        clicks.silent_failures += usize::from(time > situation.promised() && !is_told);
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

impl Rigged {
    fn move_exciter(&self) -> Result<(), Fault> {
        let begun = Instant::now();
        while self.live.at_rest_since().is_some() {
            if begun.elapsed() > PATIENCE {
                return Err(format!("nothing moves: {}", self.page.text("#state")?).into());
            }
            // The button is dead until the page has heard of the end of the run before.
            if self
                .page
                .value("document.getElementById('start').disabled")?
                == false
            {
                self.page.click("#start")?;
            }
            std::thread::sleep(Duration::from_millis(50));
        }
        Ok(())
    }

    /// From the click to the rest that lasted until the page had said what became of it.
    fn stop(&self, way: Way) -> Result<Duration, Fault> {
        self.page.click("#stop")?;
        match way {
            Way::Plain => self.page.wait_for_text("#state", "stopped")?,
            // Nobody hears that it is stopped.
            Way::Drip | Way::OldFrames => self.at_rest_with_an_alarm()?,
        }
        let clicked_ms = self.page.value("window.clicked_ms")?.as_f64();
        let clicked = Duration::from_secs_f64(clicked_ms.ok_or("no click")? / 1e3);
        let rest = self.live.at_rest_since();
        let rest = rest.ok_or("told as stopped, and moves")?;
        // Between two points the exciter rests already.
        Ok(rest.saturating_sub(clicked))
    }

    /// Waits for the rest and for the page's word; without one of them it is told as what it is.
    fn at_rest_with_an_alarm(&self) -> Result<(), Fault> {
        let begun = Instant::now();
        while begun.elapsed() < WORD {
            std::thread::sleep(Duration::from_millis(50));
            let alarm = self
                .page
                .value("!document.getElementById('alarm').hidden")?;
            if alarm == true && self.live.silent_for() > Duration::from_millis(500) {
                break;
            }
        }
        Ok(())
    }

    /// Waits until the link is whole and the page says what became of its click: that may come after the word of the
    /// page's channel.
    fn settle(&self) -> Result<(), Fault> {
        let over = "!document.getElementById('stop').classList.contains('sent')
            && document.getElementById('alarm').hidden && document.getElementById('link').dataset.link === 'connected'";
        until("told", || Ok(self.page.value(over)? == true))
    }
}
