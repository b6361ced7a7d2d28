//! A run whose hosts are silent goes on or ends, as the laboratory chose; and a stop for one run ends no
//! other.

use calib_core::closing::Closing;
use calib_core::point::ExcitationKind;
use calib_core::point_state::{PointState, Reason};
use calib_link::session::{self, Progress};
use calib_protocol::message::{RunSpec, RunState};
use calib_protocol::record::{self, RunLabels};
use calib_tests::rigged::{Fault, Rigged, point};
use calib_twin::rig::Rig;
use std::ops::ControlFlow;
use std::time::Duration;

const SINE: ExcitationKind = ExcitationKind::SingleSine;
/// Granted quiet of the tests.
const LEASE_S: u16 = 2;
/// Longer, and shorter than the run.
const QUIET: Duration = Duration::from_millis(2_500);

/// A run of half a minute.
fn long_run() -> RunSpec {
    RunSpec {
        points: [point(160.0, 10.0); 20].into_iter().collect(),
        excitation: ExcitationKind::HeldSine,
        labels: RunLabels::default(),
    }
}

#[test]
fn a_run_whose_hosts_are_silent_goes_on_unless_the_lease_says_otherwise() -> Result<(), Fault> {
    let mut rigged = Rigged::with_rig(&Rig::standard())?;
    rigged.client.start(long_run())?;
    rigged.client.wait(QUIET)?;
    assert!(rigged.client.status()?.state.is_running(), "the default");
    rigged.client.stop()?;
    rigged.client.wait(Duration::from_secs(1))?;

    rigged.adjust(|settings| settings.lease_s = LEASE_S)?;
    rigged.client.start(long_run())?;
    // A word every second keeps it.
    for _ in 0..4 {
        rigged.client.wait(Duration::from_secs(1))?;
        assert!(rigged.client.status()?.state.is_running());
    }
    rigged.client.wait(QUIET)?;
    // Looked at before anything is asked: the supervisor looks every 20 ms, the drive rests a block later.
    let silent = rigged.board().silent_for();
    let since_lease = QUIET - Duration::from_secs(u64::from(LEASE_S));
    let earliest = since_lease - Duration::from_millis(60);
    assert!(
        silent.is_some_and(|silent| silent >= earliest),
        "{silent:?}"
    );
    let status = rigged.client.status()?;
    assert_eq!(status.state, RunState::Stopped);
    let last = rigged.client.point(status.point)?.ok_or("no result")?;
    assert_eq!(last.state, PointState::Refused(Reason::HostsSilent));
    Ok(())
}

#[test]
fn a_tap_on_the_button_starts_a_run_without_a_lease() -> Result<(), Fault> {
    let mut rigged = Rigged::with_rig(&Rig::standard())?;
    rigged.adjust(|settings| settings.lease_s = LEASE_S)?;
    rigged.under_a_hand(|_| Ok(()))?;
    rigged.client.wait(QUIET)?;
    assert!(rigged.client.status()?.state.is_running());
    Ok(())
}

#[test]
fn a_stop_for_one_run_ends_no_other() -> Result<(), Fault> {
    let mut rigged = Rigged::with_rig(&Rig::standard())?;
    let first = rigged.run(&[point(160.0, 10.0)])?.record_id;
    let second = rigged.client.start(long_run())?;
    rigged.client.wait(Duration::from_millis(500))?;
    // It comes late.
    rigged.client.stop_for(Some(first));
    rigged.client.stop()?;
    rigged.client.wait(Duration::from_millis(200))?;
    assert!(rigged.client.status()?.state.is_running());
    rigged.client.stop_for(Some(second));
    rigged.client.stop()?;
    rigged.expect_silence(Duration::from_millis(40))?;
    Ok(())
}

/// The record of the run before is being written then, and the calibrator busy.
#[test]
fn a_run_may_follow_a_stop_at_once() -> Result<(), Fault> {
    let mut rigged = Rigged::with_rig(&Rig::standard())?;
    for _ in 0..3 {
        rigged.client.start(long_run())?;
        rigged.client.wait(Duration::from_millis(700))?;
        // While the exciter moves, another is refused.
        let labels = RunLabels::default();
        let beside = session::begin(&mut rigged.client, &[point(80.0, 1.0)], SINE, labels);
        assert!(beside.is_err());
        rigged.client.stop()?;
        let run = rigged.run(&[point(160.0, 10.0)])?;
        assert_eq!(run.state, RunState::Finished);
    }
    Ok(())
}

/// Every point was measured by then: the record is complete, and says that nobody knows what changed.
#[test]
fn a_stop_while_the_first_point_is_repeated_is_a_stop() -> Result<(), Fault> {
    let mut rigged = Rigged::with_rig(&Rig::standard())?;
    let list = [point(160.0, 10.0), point(1000.0, 10.0)];
    let repeats = |progress: &Progress<'_>| match progress.status.point {
        2 => ControlFlow::Break(()),
        _ => ControlFlow::Continue(()),
    };
    let run = session::run(&mut rigged.client, &list, RunLabels::default(), repeats)?;
    assert_eq!((run.state, run.points.len()), (RunState::Stopped, 2));
    let record = record::decode(&rigged.record(run.record_id)?)?;
    assert!(record.complete);
    assert_eq!(record.closing, Closing::Refused(Reason::Stopped));
    Ok(())
}

/// Five samples: no zero crossing of a tone lasts so long, and an answer takes a hundred on the line.
const REST: Duration = Duration::from_micros(100);

#[test]
fn a_stop_is_confirmed_by_an_exciter_at_rest() -> Result<(), Fault> {
    let mut rigged = Rigged::with_rig(&Rig::standard())?;
    for after_ms in [250, 357, 464, 571, 678, 785, 892, 1000] {
        rigged.client.start(long_run())?;
        rigged.client.wait(Duration::from_millis(after_ms))?;
        rigged.client.stop()?;
        let silent = rigged.board().silent_for();
        assert!(
            silent.is_some_and(|silent| silent >= REST),
            "stopped after {after_ms} ms, confirmed, and at rest for {silent:?}"
        );
        rigged.client.wait(Duration::from_millis(300))?;
    }
    Ok(())
}
