//! `./run bench stop [TRIES [PART [SITUATION [SEED]]]]`: how long a stop takes from the request of a page to the calibrator's
//! link, by what is in its way, from there to a drive at rest, and all the way from a click in a browser.
//!
//! The first part, `links`, is measured by the clock of this computer, the program as it ships with a
//! calibrator of this bench behind a TCP port; the second, `instrument`, in virtual time, with the shipping
//! image; the third, `browser`, by the clock of this computer with that image kept at its pace. SITUATION is a part of
//! the name of those that are wanted.

mod browser;
mod device;
mod host;
mod instrument;
mod relay;

use calib_tests::rigged::Fault;
use device::{Device, Way};
use host::{Host, Obstacles};
use rand_chacha::ChaCha20Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use std::path::Path;
use std::time::{Duration, Instant};

/// Stops of a situation, unless said otherwise.
const TRIES: usize = 100;
/// Of the instants of clicks, unless said otherwise.
const SEED: u64 = 18;
/// Longest wait for a run to begin.
const PATIENCE: Duration = Duration::from_secs(30);

/// Longest time on a link that works, without an alarm.
const PROMISED: Duration = Duration::from_millis(200);
/// Longest on one that does not.
const PROMISED_BAD: Duration = Duration::from_millis(500);

/// Obstacle in the way of a stop.
struct Situation {
    name: &'static str,
    way: Way,
    prepare: fn(&mut Obstacles, &Host, &Path) -> Result<(), Fault>,
}

impl Situation {
    /// Longest time to the link without an alarm.
    fn promised(&self) -> Duration {
        match self.way {
            Way::Plain => PROMISED,
            Way::Drip | Way::OldFrames => PROMISED_BAD,
        }
    }
}

const SITUATIONS: [Situation; 8] = [
    Situation {
        name: "nothing",
        way: Way::Plain,
        prepare: |_, _, _| Ok(()),
    },
    Situation {
        name: "ten pages, asleep",
        way: Way::Plain,
        prepare: |obstacles, host, _| obstacles.pages(host, 10),
    },
    Situation {
        name: "1 100 idle connections",
        way: Way::Plain,
        prepare: |obstacles, host, _| obstacles.idle(host, 1100),
    },
    Situation {
        name: "locked logbook",
        way: Way::Plain,
        prepare: |obstacles, _, logbook| obstacles.lock(logbook),
    },
    Situation {
        name: "busy computer",
        way: Way::Plain,
        prepare: |obstacles, _, _| {
            obstacles.load();
            Ok(())
        },
    },
    Situation {
        name: "all of these",
        way: Way::Plain,
        prepare: |obstacles, host, logbook| {
            obstacles.pages(host, 10)?;
            all(obstacles, host, logbook)
        },
    },
    Situation {
        name: "link drips, 0.6 s a byte",
        way: Way::Drip,
        prepare: |_, _, _| Ok(()),
    },
    Situation {
        name: "device repeats old answers",
        way: Way::OldFrames,
        prepare: |_, _, _| Ok(()),
    },
];

/// Obstacles in the way of a click beside ten tabs of the page.
const CLICKS: [Situation; 4] = [
    Situation {
        name: "ten tabs",
        way: Way::Plain,
        prepare: |_, _, _| Ok(()),
    },
    Situation {
        name: "all obstacles, link whole",
        way: Way::Plain,
        prepare: all,
    },
    Situation {
        name: "all obstacles, link drips",
        way: Way::Drip,
        prepare: all,
    },
    Situation {
        name: "all obstacles, old answers",
        way: Way::OldFrames,
        prepare: all,
    },
];

/// Everything but a bad link and pages.
fn all(obstacles: &mut Obstacles, host: &Host, logbook: &Path) -> Result<(), Fault> {
    obstacles.idle(host, 1100)?;
    obstacles.lock(logbook)?;
    obstacles.load();
    Ok(())
}

/// Times of a situation.
#[derive(Default)]
struct Times {
    /// To the calibrator's link.
    arrived: Vec<Duration>,
    /// To what the page is told.
    told: Vec<Duration>,
    confirmed: usize,
    alarms: usize,
    /// Neither stopped nor an alarm.
    silent_failures: usize,
}

fn main() -> Result<(), Fault> {
    let tries = std::env::args().nth(1).map(|text| text.parse());
    let tries = tries.transpose()?.unwrap_or(TRIES);
    let part = std::env::args().nth(2);
    let situation = std::env::args().nth(3).unwrap_or_default();
    let seed = std::env::args().nth(4).map(|text| text.parse());
    let seed = seed.transpose()?.unwrap_or(SEED);
    let wanted = |name| part.as_deref().is_none_or(|part| part == name);
    let named = |one: &&Situation| one.name.contains(&situation);
    println!("{tries} stops each, ms\n");
    let mut rows = Vec::new();
    if wanted("links") {
        rows.extend(links(SITUATIONS.iter().filter(named), tries)?);
    }
    if wanted("instrument") {
        rows.push(instrument(tries)?);
    }
    if wanted("browser") {
        rows.extend(browser(CLICKS.iter().filter(named), tries, seed)?);
    }
    if let Some(path) = std::env::var_os("CALIB_BENCH_JSON") {
        std::fs::write(path, serde_json::to_string_pretty(&rows)?)?;
    }
    Ok(())
}

/// From the request of a page to the calibrator's link, situation by situation.
fn links<'a>(
    situations: impl Iterator<Item = &'a Situation>,
    tries: usize,
) -> Result<Vec<serde_json::Value>, Fault> {
    println!(
        "{:<28}{:>9}{:>9}{:>11}{:>9}{:>11}{:>8}",
        "in the way", "median", "worst", "told in", "worst", "confirmed", "alarms"
    );
    situations
        .map(|situation| row(situation, measure(situation, tries)?))
        .collect()
}

/// From there to a drive at rest.
fn instrument(tries: usize) -> Result<serde_json::Value, Fault> {
    let [median, worst] = spread(&mut instrument::times(tries)?);
    println!("\nfrom the line to a drive at rest: median {median:.1} ms, worst {worst:.1} ms");
    Ok(serde_json::json!({
        "situation": "instrument", "median_ms": median, "worst_ms": worst,
    }))
}

/// From a click to a drive at rest; nothing without a browser. A click that is late without a word fails it, when all
/// are told.
fn browser<'a>(
    situations: impl Iterator<Item = &'a Situation>,
    tries: usize,
    seed: u64,
) -> Result<Vec<serde_json::Value>, Fault> {
    let Some(driver) = calib_tests::browser::driver() else {
        return Ok(Vec::new());
    };
    println!("\nfrom a click to a drive at rest\n");
    println!(
        "{:<28}{:>9}{:>9}{:>11}{:>8}{:>11}{:>11}{:>10}",
        "in the way", "median", "worst", "with lag", "alarms", "latest", "told late", "no word"
    );
    let (mut rows, mut silent) = (Vec::new(), 0);
    for situation in situations {
        let clicks = browser::clicks(&driver, situation, tries, seed)?;
        silent += clicks.silent_failures;
        rows.push(clicked(situation, clicks));
    }
    match silent {
        0 => Ok(rows),
        late => Err(format!("{late} clicks came later than promised without an alarm").into()),
    }
}

fn clicked(situation: &Situation, mut clicks: browser::Clicks) -> serde_json::Value {
    let [median, worst] = spread(&mut clicks.times);
    let [_, lagging] = spread(&mut clicks.with_lag);
    let (alarms, latest, told) = (clicks.alarms, clicks.latest_alarm_ms, clicks.told);
    println!(
        "{:<28}{median:>9.1}{worst:>9.1}{lagging:>11.1}{alarms:>8}{latest:>11.1}{told:>11}{:>10}",
        situation.name, clicks.silent_failures
    );
    serde_json::json!({
        "situation": situation.name, "median_ms": median, "worst_ms": worst, "worst_with_lag_ms": lagging,
        "alarms": alarms, "latest_alarm_ms": latest, "told_late": told, "no_word": clicks.silent_failures,
    })
}

fn measure(situation: &Situation, tries: usize) -> Result<Times, Fault> {
    let folder = tempfile::tempdir()?;
    let device = Device::listen()?;
    let host = Host::start(folder.path(), &device.address)?;
    until("connected", || Ok(host.state()?["link"] == "connected"))?;
    let mut obstacles = Obstacles::default();
    (situation.prepare)(&mut obstacles, &host, &folder.path().join("logbook.sqlite"))?;
    let mut draws = ChaCha20Rng::seed_from_u64(18);
    let mut times = Times::default();
    for _ in 0..tries {
        device.behave(Way::Plain);
        until("running", || begun(&host, &device))?;
        device.behave(situation.way);
        std::thread::sleep(Duration::from_millis(u64::from(draws.next_u32() % 300)));
        times.stop(&host, &device, situation.promised())?;
    }
    device.behave(Way::Plain);
    Ok(times)
}

/// Asks for a run; a link that was lost in the try before may not be there again yet.
fn begun(host: &Host, device: &Device) -> Result<bool, Fault> {
    let start = r#"{"frequencies_hz": [160]}"#;
    let asked = host.ask(&host.page, "POST /api/run", start)?.0 == 202;
    for _ in 0..100 {
        if device.is_running() {
            return Ok(true);
        }
        if !asked {
            return Ok(false);
        }
        std::thread::sleep(Duration::from_millis(2));
    }
    Ok(false)
}

impl Times {
    fn stop(&mut self, host: &Host, device: &Device, promised: Duration) -> Result<(), Fault> {
        let begun = Instant::now();
        let (status, _) = host.ask(&host.stops, "POST /api/stop", "{}")?;
        self.told.push(begun.elapsed());
        match status {
            200 => self.confirmed += 1,
            504 => self.alarms += 1,
            _ => {}
        }
        // An alarm does not mean that it never comes.
        until("stopped", || Ok(device.stopped_at().is_some()))?;
        let stopped = device.stopped_at().ok_or("never stopped")?;
        let arrived = stopped.saturating_duration_since(begun);
        let late = arrived > promised && status != 504;
        self.silent_failures += usize::from(late || ![200, 504].contains(&status));
        self.arrived.push(arrived);
        Ok(())
    }
}

fn row(situation: &Situation, mut times: Times) -> Result<serde_json::Value, Fault> {
    let [median, worst] = spread(&mut times.arrived);
    let [told, told_worst] = spread(&mut times.told);
    println!(
        "{:<28}{median:>9.1}{worst:>9.1}{told:>11.1}{told_worst:>9.1}{:>11}{:>8}",
        situation.name, times.confirmed, times.alarms
    );
    let most = situation.promised();
    if times.silent_failures > 0 {
        return Err(format!(
            "{}: {} stops came later than {most:?} without an alarm",
            situation.name, times.silent_failures
        )
        .into());
    }
    Ok(serde_json::json!({
        "situation": situation.name, "median_ms": median, "worst_ms": worst,
        "told_median_ms": told, "told_worst_ms": told_worst,
        "confirmed": times.confirmed, "alarms": times.alarms,
    }))
}

/// Median and worst, ms.
fn spread(times: &mut [Duration]) -> [f64; 2] {
    times.sort_unstable();
    let ms = |time: Option<&Duration>| time.map_or(f64::NAN, |time| 1e3 * time.as_secs_f64());
    [ms(times.get(times.len() / 2)), ms(times.last())]
}

fn until(what: &str, is: impl Fn() -> Result<bool, Fault>) -> Result<(), Fault> {
    let begun = Instant::now();
    while !is()? {
        if begun.elapsed() > PATIENCE {
            return Err(format!("not {what} within {PATIENCE:?}").into());
        }
        std::thread::sleep(Duration::from_millis(2));
    }
    Ok(())
}
