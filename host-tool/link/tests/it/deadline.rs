//! However a link misbehaves, a request ends, and a stop does not wait for it.

use crate::slow_link::{SlowLink, Way};
use calib_core::point::ExcitationKind;
use calib_link::{Client, Error, LinkError, StopSwitch};
use calib_protocol::message::{Request, RunSpec};
use calib_protocol::record::RunLabels;
use rand_chacha::ChaCha20Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use std::time::Duration;

const MS: Duration = Duration::from_millis(1);

/// Four attempts of a second: what a request is promised to end within.
const DEADLINE: Duration = Duration::from_secs(4);

#[test]
fn a_request_ends_within_its_deadline_on_every_link() {
    for way in [
        Way::Drip(600 * MS),
        Way::Drip(999 * MS),
        Way::OldFrames(10 * MS),
        Way::OldFrames(999 * MS),
        Way::Silent,
    ] {
        let link = SlowLink::new(way);
        let seen = link.seen();
        let failed = Client::new(Box::new(link)).info();
        assert!(matches!(failed, Err(Error::Link(_))), "{way:?}: {failed:?}");
        let took = seen.lock().expect("one thread").clock;
        assert!(took <= DEADLINE, "{way:?}: {took:?}");
    }
}

/// Ways to be kept waiting, each with the pauses of a bad link.
fn ways(draws: &mut ChaCha20Rng) -> [Way; 3] {
    let pause = Duration::from_millis(u64::from(draws.next_u32() % 999) + 1);
    [Way::Drip(pause), Way::OldFrames(pause), Way::Silent]
}

/// 1 000 times a stop falls into a request that never ends well.
#[test]
fn a_stop_goes_ahead_of_every_answer_that_is_waited_for() {
    let mut draws = ChaCha20Rng::seed_from_u64(18);
    for try_ in 0..1000 {
        for way in ways(&mut draws) {
            let asked = Duration::from_millis(u64::from(draws.next_u32() % 3900));
            let switch = StopSwitch::default();
            let mut link = SlowLink::new(way);
            let press = switch.clone();
            link.at(asked, move || {
                press.ask();
            });
            let seen = link.seen();
            let mut client = Client::new(Box::new(link)).heeding(switch.clone());
            let _ = client.info();
            // Asked for while the last bytes were read: the next request passes it on.
            let _ = client.pass_stop();
            let stopped = seen
                .lock()
                .expect("one thread")
                .first(|r| *r == Request::Stop);
            let late = stopped.expect("a stop").saturating_sub(asked);
            // A look, and no pause of the link.
            assert!(late <= 10 * MS, "{try_}, {way:?}: {late:?} late");
            assert!(switch.is_confirmed(1), "{way:?}");
        }
    }
}

/// 1 000 times on each link, asked for before a request or within one: the stop leaves at once, and after half a second
/// without its confirmation it is said that there is none.
#[test]
fn a_stop_that_is_not_confirmed_says_so_within_half_a_second() {
    let mut draws = ChaCha20Rng::seed_from_u64(19);
    for try_ in 0..1000 {
        for way in ways(&mut draws) {
            let asked = Duration::from_millis(u64::from(draws.next_u32() % 900));
            let mut link = SlowLink::new(way);
            link.confirms = false;
            let (seen, switch) = (link.seen(), StopSwitch::default());
            let press = switch.clone();
            match try_ % 2 {
                0 => link.at(asked, move || {
                    press.ask();
                }),
                _ => {
                    press.ask();
                }
            }
            let asked = asked * (1 - try_ % 2);
            let mut client = Client::new(Box::new(link)).heeding(switch.clone());
            let failed = client.status().expect_err("nobody confirms");
            let is_alarm = matches!(&failed, Error::Link(LinkError::StopUnconfirmed { .. }));
            let words = failed.to_string();
            assert!(is_alarm && words.starts_with("NOT STOPPED"), "{failed}");
            assert!(failed.hint().expect("a way out").contains("button"));
            let seen = seen.lock().expect("one thread");
            let left = seen.first(|r| *r == Request::Stop).expect("a stop");
            // A look, and no pause of the link.
            assert!(left <= asked + 10 * MS, "{try_}, {way:?}: {left:?}");
            let told = seen.clock.saturating_sub(asked);
            assert!(told <= 510 * MS, "{try_}, {way:?}: {told:?}");
            assert!(!switch.is_confirmed(1));
        }
    }
}

/// A calibrator that is slow is no other device.
#[test]
fn answers_that_come_too_late_are_called_so() {
    let link = SlowLink::new(Way::OldFrames(100 * MS));
    let failed = Client::new(Box::new(link)).status().expect_err("too late");
    let Error::Link(LinkError::Late { late, .. }) = failed else {
        panic!("{failed}");
    };
    assert!(late > 4, "{late}");
}

/// Of a computer that is busy, the first part of each answer is here when its time is over.
#[test]
fn answers_that_are_never_whole_are_no_other_device() {
    let link = SlowLink::new(Way::Begun);
    let failed = Client::new(Box::new(link)).status().expect_err("too late");
    let late = |error: &Error| matches!(error, Error::Link(LinkError::Late { .. }));
    assert!(late(&failed), "{failed}");
}

#[test]
fn no_run_begins_past_a_stop_and_the_next_one_does() {
    let spec = || RunSpec {
        points: heapless::Vec::new(),
        excitation: ExcitationKind::SingleSine,
        labels: RunLabels::default(),
    };
    let begun = |request: &Request| matches!(request, Request::Start(_));
    // Asked for before the start.
    let link = SlowLink::new(Way::Silent);
    let (seen, switch) = (link.seen(), StopSwitch::default());
    let mut client = Client::new(Box::new(link)).heeding(switch.clone());
    switch.ask();
    assert!(matches!(client.start(spec()), Err(Error::Stopped)));
    assert_eq!(seen.lock().expect("one thread").first(begun), None);
    // It was for that one: the next is asked for.
    assert!(matches!(
        client.start(spec()),
        Err(Error::Link(LinkError::NoAnswer { .. }))
    ));
    assert!(seen.lock().expect("one thread").first(begun).is_some());
    // Asked for while the answer to the start is waited for: stopped, and not begun once more.
    let mut link = SlowLink::new(Way::Silent);
    let (seen, switch) = (link.seen(), StopSwitch::default());
    let press = switch.clone();
    link.at(500 * MS, move || {
        press.ask();
    });
    let mut client = Client::new(Box::new(link)).heeding(switch);
    assert!(matches!(client.start(spec()), Err(Error::Stopped)));
    let seen = seen.lock().expect("one thread");
    let last = seen.requests.last().map(|(_, request)| request);
    assert_eq!(last, Some(&Request::Stop));
}

#[test]
fn a_stop_ends_a_wait() {
    let mut link = SlowLink::new(Way::Silent);
    let (seen, switch) = (link.seen(), StopSwitch::default());
    let press = switch.clone();
    link.at(30 * MS, move || {
        press.ask();
    });
    let mut client = Client::new(Box::new(link)).heeding(switch.clone());
    client.wait(100 * MS).expect("a link");
    let stopped = seen
        .lock()
        .expect("one thread")
        .first(|r| *r == Request::Stop);
    assert!(stopped.expect("a stop") <= 40 * MS);
    assert!(switch.is_confirmed(1));
}
