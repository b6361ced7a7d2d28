//! A run without a host: a list kept on the instrument, measured by a tap, judged at the lamps.

use calib_core::conformity::{Conformity, judge};
use calib_core::point::PointSpec;
use calib_core::point_state::Reason;
use calib_core::stored_list::{Band, Base, ListTerms, Rule, StoredList};
use calib_host::emulated::EmulatedTransport;
use calib_link::{Client, Error};
use calib_protocol::clock::ClockReading;
use calib_protocol::lists::{KeptList, ListChange};
use calib_protocol::message::{Refusal, RunState};
use calib_protocol::record::{self, Record};
use calib_tests::rigged::{Fault, Rigged, point};
use calib_twin::board::Leds;
use calib_twin::rig::Rig;
use std::time::Duration;

/// A list of these points whose nominal sensitivity is that of the standard rig's device, V/(m/s2), over
/// `1 + deviation_rel`.
fn list(name: &str, points: &[PointSpec], deviation_rel: f32, tolerance_rel: f32) -> StoredList {
    let band = Band::everywhere(Base::Nominal, tolerance_rel);
    StoredList {
        terms: ListTerms {
            name: name.try_into().expect("short"),
            nominal_v_per_ms2: 0.01 / (1.0 + deviation_rel),
            unit: "mV/g".try_into().expect("short"),
            rule: Rule::Simple,
            bands: [band].into_iter().collect(),
        },
        points: points.iter().copied().collect(),
    }
}

fn choice(name: &str) -> ListChange {
    let name = name.try_into().expect("short");
    ListChange::Choose { name }
}

fn refusal<T: std::fmt::Debug>(answer: Result<T, Error>) -> Result<Refusal, Fault> {
    match answer {
        Err(Error::Refused(refused)) => Ok(refused.refusal),
        other => Err(format!("{other:?}").into()),
    }
}

#[test]
fn lists_change_under_a_hand_alone_and_are_kept_through_a_power_cut() -> Result<(), Fault> {
    let mut rigged = Rigged::with_rig(&Rig::standard())?;
    assert_eq!(rigged.client.lists()?, []);
    let long: Vec<PointSpec> = (0..40).map(|n| point(20.0 + n as f32, 10.0)).collect();
    let kept = [
        list("long", &long, 0.0, 0.05),
        list("short", &long[..1], 0.0, 0.05),
    ];
    let store = |list: &StoredList| ListChange::Store(list.clone());
    let stored = rigged.client.change_lists(&store(&kept[0]));
    assert_eq!(refusal(stored)?, Refusal::ButtonNotHeld);
    rigged.under_a_hand(|client| {
        for list in &kept {
            client.change_lists(&store(list))?;
        }
        assert_eq!(
            refusal(client.change_lists(&choice("none")))?,
            Refusal::ListUnknown
        );
        let mut useless = kept[0].clone();
        useless.terms.bands.clear();
        assert_eq!(
            refusal(client.change_lists(&store(&useless)))?,
            Refusal::List
        );
        let impossible = list("high", &[long[0], point(30_000.0, 10.0)], 0.0, 0.05);
        let reason = Reason::FrequencyUnavailable;
        assert_eq!(
            refusal(client.change_lists(&store(&impossible)))?,
            Refusal::PointImpossible { index: 1, reason }
        );
        Ok(client.change_lists(&choice("short"))?)
    })?;
    // What is so already needs no hand.
    rigged.client.change_lists(&store(&kept[0]))?;
    rigged.client.change_lists(&choice("short"))?;
    assert_eq!(
        refusal(rigged.client.change_lists(&choice("long")))?,
        Refusal::ButtonNotHeld
    );
    let [long, short] = kept;
    let expected = [(long, false), (short, true)].map(|(list, chosen)| KeptList { list, chosen });
    assert_eq!(rigged.client.lists()?, expected);
    rigged.board().power_cycle()?;
    rigged.client.wait(Duration::from_secs(1))?;
    assert_eq!(rigged.client.lists()?, expected);
    Ok(())
}

/// How often a lamp is lit, of ten looks, and how often it changes; in two seconds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Seen {
    lit: u32,
    changes: u32,
}

/// Green, yellow, red, as somebody sees them who looks for two seconds.
fn seen(rigged: &mut Rigged) -> Result<[Seen; 3], Fault> {
    let lamps = |Leds { green, yellow, red }| [green, yellow, red];
    let (mut seen, mut before) = ([(0, 0); 3], lamps(rigged.board().leds()?));
    for _ in 0..100 {
        rigged.client.wait(Duration::from_millis(20))?;
        let now = lamps(rigged.board().leds()?);
        for (index, seen) in seen.iter_mut().enumerate() {
            seen.0 += u32::from(now[index]);
            seen.1 += u32::from(now[index] != before[index]);
        }
        before = now;
    }
    Ok(seen.map(|(lit, changes)| Seen {
        lit: (lit + 5) / 10,
        changes,
    }))
}

const DARK: Seen = Seen { lit: 0, changes: 0 };
const LIT: Seen = Seen {
    lit: 10,
    changes: 0,
};
/// Ready: green for a twentieth of the time.
const READY: [Seen; 3] = [Seen { lit: 1, changes: 2 }, DARK, DARK];
const PASS: [Seen; 3] = [LIT, DARK, DARK];
const NOT_JUDGEABLE: [Seen; 3] = [DARK, Seen { lit: 5, changes: 2 }, DARK];

fn expect_fail(seen: [Seen; 3]) {
    let [green, yellow, red] = seen;
    assert_eq!(green, DARK);
    // They take turns, eight changes a second.
    assert_eq!(yellow.lit + red.lit, 10, "{seen:?}");
    assert!((15..=18).contains(&red.changes), "{seen:?}");
    assert_eq!(red.changes, yellow.changes);
}

/// Stores the list, has it chosen, and measures it by a tap; its record.
fn tapped(rigged: &mut Rigged, list: &StoredList) -> Result<Record, Fault> {
    rigged.under_a_hand(|client| {
        client.change_lists(&ListChange::Store(list.clone()))?;
        Ok(client.change_lists(&choice(&list.terms.name))?)
    })?;
    let before = rigged.client.records()?.len();
    // Down for 60 ms and up again.
    rigged.under_a_hand(|_| Ok(()))?;
    let running = rigged.client.status()?;
    assert!(running.state.is_running(), "{running:?}");
    assert_eq!(
        usize::from(running.points),
        list.points.len(),
        "not the chosen list"
    );
    // It settles for longer than that.
    assert_eq!(running.block, 0, "a block of the run before");
    while rigged.client.status()?.state.is_running() {
        rigged.client.wait(Duration::from_millis(50))?;
    }
    let records = rigged.client.records()?;
    assert_eq!(records.len(), before + 1);
    let last = records.last().ok_or("no record")?.id;
    Ok(record::decode(&rigged.record(last)?)?)
}

#[test]
fn a_tap_measures_the_chosen_list_and_the_lamps_say_what_it_came_to() -> Result<(), Fault> {
    let mut rigged = Rigged::with_rig(&Rig::standard())?;
    rigged.adjust(|settings| settings.blocks = 3)?;
    assert_eq!(seen(&mut rigged)?, READY);
    let points = [point(160.0, 10.0), point(1_000.0, 10.0)];
    // The device is off by +5.9 %, by nothing, and by nothing with a tolerance below its U of 0.8 %.
    for (name, deviation_rel, tolerance_rel, expected) in [
        ("off", 0.059, 0.05, Conformity::Fail),
        ("tight", 0.0, 0.003, Conformity::NotJudgeable),
        ("good", 0.0, 0.05, Conformity::Pass),
    ] {
        let list = list(name, &points, deviation_rel, tolerance_rel);
        let record = tapped(&mut rigged, &list)?;
        assert_eq!(rigged.client.status()?.state, RunState::Finished);
        let point = record.points.first().ok_or("no point")?;
        let nominal = list.terms.nominal_v_per_ms2;
        println!(
            "{name}: {:+.2} % of nominal, U {:.2} %, limit {:.1} %",
            100.0 * (point.sensitivity_v_per_ms2 / nominal - 1.0),
            100.0 * point.expanded_uncertainty_rel,
            100.0 * tolerance_rel
        );
        assert_eq!(record.list, list.terms, "what it was judged by");
        assert_eq!(
            judge(
                &record.list,
                &record.points,
                record.complete,
                &record.closing
            ),
            expected,
            "{name}"
        );
        match (expected, seen(&mut rigged)?) {
            (Conformity::Fail, seen) => expect_fail(seen),
            (Conformity::Pass, seen) => assert_eq!(seen, PASS),
            (_, seen) => assert_eq!(seen, NOT_JUDGEABLE),
        }
    }
    // A press during the run stops it, wherever it comes: of what was left out nothing is said.
    let mut stopped = 0;
    for ms in (0..2_000).step_by(20) {
        rigged.under_a_hand(|_| Ok(()))?;
        rigged.client.wait(Duration::from_millis(ms))?;
        if !rigged.client.status()?.state.is_running() {
            break;
        }
        rigged.board().press_button(true)?;
        rigged.client.wait(Duration::from_millis(300))?;
        rigged.board().press_button(false)?;
        // In the silence behind the last one nothing is left to be stopped.
        let expected = match rigged.client.status()?.state {
            RunState::Stopped => NOT_JUDGEABLE,
            _ => PASS,
        };
        assert_eq!(seen(&mut rigged)?, expected, "{ms} ms");
        stopped += usize::from(expected == NOT_JUDGEABLE);
    }
    assert!((20..60).contains(&stopped), "stopped {stopped} times");
    // A host's run judges nothing, and takes the place of what was said.
    let record_id = rigged.run(&points[..1])?.record_id;
    assert_eq!(seen(&mut rigged)?, READY);
    assert!(record::decode(&rigged.record(record_id)?)?.list.is_none());
    Ok(())
}

/// Limits that were lowered since the list was stored: its first point could still be measured.
#[test]
fn a_tap_of_a_list_that_can_no_longer_be_measured_moves_nothing() -> Result<(), Fault> {
    let mut rigged = Rigged::with_rig(&Rig::standard())?;
    let list = list("pump", &[point(160.0, 5.0), point(160.0, 10.0)], 0.0, 0.05);
    rigged.under_a_hand(|client| {
        client.change_lists(&ListChange::Store(list.clone()))?;
        Ok(client.change_lists(&choice("pump"))?)
    })?;
    // 10 m/s2 r.m.s. are 14.1 m/s2 peak.
    rigged.adjust(|settings| settings.limits.acceleration_peak_ms2 = 10.0)?;
    a_tap_moves_nothing(&mut rigged)
}

fn a_tap_moves_nothing(rigged: &mut Rigged) -> Result<(), Fault> {
    let before = rigged.client.records()?.len();
    rigged.under_a_hand(|_| Ok(()))?;
    rigged.client.wait(Duration::from_millis(300))?;
    assert!(!rigged.client.status()?.state.is_running());
    assert_eq!(seen(rigged)?, NOT_JUDGEABLE);
    assert_eq!(rigged.client.records()?.len(), before);
    Ok(())
}

/// The list of an instrument nobody chose one on begins at a point that could be measured, and has others that cannot.
#[test]
fn a_tap_looks_through_the_list_nobody_chose_too() -> Result<(), Fault> {
    let mut rigged = Rigged::with_rig(&Rig::standard())?;
    // 10 m/s2 r.m.s. are 0.9 mm peak at 20 Hz and 14 um at 160 Hz.
    rigged.adjust(|settings| settings.limits.displacement_peak_m = 0.5e-3)?;
    a_tap_moves_nothing(&mut rigged)
}

#[test]
fn a_run_without_a_host_has_the_time_a_host_told_or_none() -> Result<(), Fault> {
    const TOLD: u64 = 1_795_269_900;
    let mut rigged = Rigged::with_rig(&Rig::standard())?;
    rigged.adjust(|settings| settings.blocks = 3)?;
    let list = list("one", &[point(160.0, 10.0)], 0.0, 0.05);
    let dated = |record: &Record| (record.head.labels.unix_time_s, record.clock);
    // Nobody told it the time.
    let without = tapped(&mut rigged, &list)?;
    assert_eq!(dated(&without), (0, ClockReading::NONE));
    let link = EmulatedTransport::new(rigged.shared());
    let mut host = Client::new(Box::new(link)).telling(TOLD);
    host.info()?;
    drop(host);
    rigged.client.wait(Duration::from_secs(7))?;
    let (time, clock) = dated(&tapped(&mut rigged, &list)?);
    assert!((TOLD + 7..TOLD + 10).contains(&time), "{time}");
    // A second of the host's and one of the count; the drift of seconds is none.
    let expected = ClockReading {
        told_unix_time_s: TOLD,
        uncertainty_s: 2,
    };
    assert_eq!(clock, expected);
    // Without supply it does not count, and says no wrong time.
    rigged.board().power_cycle()?;
    rigged.client.wait(Duration::from_secs(1))?;
    assert_eq!(dated(&tapped(&mut rigged, &list)?), (0, ClockReading::NONE));
    Ok(())
}
