//! Runs followed to every kind of end.

use crate::device::Device;
use crate::memory_link::{client, shared};
use calib_core::point::ExcitationKind;
use calib_host::Error;
use calib_link::session;
use calib_protocol::message::{Request, RunState};
use calib_protocol::record::RunLabels;
use std::ops::ControlFlow;

#[test]
fn a_run_is_followed_to_its_end_with_rising_progress() {
    let device = shared(Device::new());
    let points = session::default_points(10.0);
    let mut fractions = Vec::new();
    let outcome = session::run(
        &mut client(&device),
        &points,
        RunLabels::default(),
        |state| {
            fractions.push(state.fraction);
            ControlFlow::Continue(())
        },
    )
    .expect("run");
    assert_eq!(outcome.state, RunState::Finished);
    assert_eq!(outcome.record_id, 1);
    let measured: Vec<_> = outcome.points.iter().map(|point| point.spec).collect();
    assert_eq!(measured, points);
    assert!(fractions.is_sorted(), "{fractions:?}");
    assert_eq!(fractions.last(), Some(&1.0));
    // One step is one look at one of three per point: no jump over a point.
    assert!(
        fractions.windows(2).all(|pair| pair[1] - pair[0] < 0.2),
        "{fractions:?}"
    );
    assert_eq!(device.lock().expect("device").records.len(), 1);
}

#[test]
fn a_run_is_stopped_when_the_observer_says_so() {
    let device = shared(Device::new());
    let points = session::default_points(10.0);
    let outcome = session::run(
        &mut client(&device),
        &points,
        RunLabels::default(),
        |state| match state.points.len() {
            0..5 => ControlFlow::Continue(()),
            _ => ControlFlow::Break(()),
        },
    )
    .expect("run");
    assert_eq!(outcome.state, RunState::Stopped);
    assert_eq!(outcome.points.len(), 5);
}

#[test]
fn an_observer_that_fails_stops_the_run_and_keeps_its_error() {
    let device = shared(Device::new());
    let points = session::default_points(10.0);
    let mut client = client(&device);
    let kind = ExcitationKind::SingleSine;
    let id = session::begin(&mut client, &points, kind, RunLabels::default()).expect("begins");
    let error = session::follow_beside(&mut client, id, &points, |state, _| {
        match state.points.len() {
            0..3 => Ok(ControlFlow::Continue(())),
            _ => Err(Error::NotPassed("nothing to look at".to_owned())),
        }
    })
    .expect_err("the observer's");
    assert!(error.to_string().contains("nothing to look at"), "{error}");
    let device = device.lock().expect("device");
    // For this run and no other.
    let stop = Request::StopRun { record_id: id };
    assert_eq!(device.requests.last(), Some(&stop));
}

#[test]
fn a_board_that_is_reset_during_the_run_is_noticed() {
    let mut device = Device::new();
    device.reset_at_look = Some(7);
    let points = session::default_points(10.0);
    let error = session::run(
        &mut client(&shared(device)),
        &points,
        RunLabels::default(),
        |_| ControlFlow::Continue(()),
    )
    .expect_err("lost");
    assert!(
        error.to_string().contains("reset during the run"),
        "{error}"
    );
}

#[test]
fn results_are_there_even_if_the_record_could_not_be_stored() {
    let mut device = Device::new();
    device.flash_broken = true;
    let points = session::default_points(10.0);
    let outcome = session::run(
        &mut client(&shared(device)),
        &points,
        RunLabels::default(),
        |_| ControlFlow::Continue(()),
    )
    .expect("run");
    assert_eq!(outcome.state, RunState::Failed);
    assert_eq!(outcome.points.len(), points.len());
}

#[test]
fn a_list_longer_than_a_run_is_refused_before_anything_is_sent() {
    let device = shared(Device::new());
    let points = vec![session::default_points(10.0)[0]; 201];
    let error = session::run(&mut client(&device), &points, RunLabels::default(), |_| {
        ControlFlow::Continue(())
    })
    .expect_err("too long");
    assert_eq!(error.exit_code(), 6);
    assert!(device.lock().expect("device").requests.is_empty());
}
