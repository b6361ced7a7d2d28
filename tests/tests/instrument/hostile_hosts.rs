//! Hosts that send anything, on both links at once, to the shipping firmware.
//!
//! It goes on measuring, answers every good request within 100 ms of the last
//! bad byte, and changes nothing for a host that does not hold the session.

use calib_core::point::ExcitationKind;
use calib_core::point_state::PointState;
use calib_host::emulated::EmulatedUsbTransport;
use calib_link::Client;
use calib_protocol::frame::{Frame, MAX_FRAME, Receiver, SERIAL_BAUD};
use calib_protocol::message::{Request, Response, RunSpec, RunState};
use calib_protocol::record::RunLabels;
use calib_tests::rigged::{Fault, Rigged, point};
use calib_tests::siege::{AFTER_DAMAGE, Ammunition, PROMPT, frame};
use calib_twin::rig::Rig;
use calib_twin::rig_port::ShortedInputs;
use calib_twin::runner::SharedEmulator;
use std::time::Duration;

/// Fails unless a request of each kind is answered in time.
fn expect_answers(board: &SharedEmulator, client: &mut Client) -> Result<(), Fault> {
    let elapsed = || {
        board
            .lock()
            .map(|board| board.elapsed())
            .unwrap_or_default()
    };
    let mut last = elapsed();
    let mut in_time = |what: &str| -> Result<(), Fault> {
        let now = elapsed();
        let took = now - std::mem::replace(&mut last, now);
        match took <= PROMPT {
            true => Ok(()),
            false => Err(format!("{what} took {took:?}").into()),
        }
    };
    client.info()?;
    in_time("info")?;
    client.status()?;
    in_time("status")?;
    client.point(0)?;
    in_time("a point")?;
    client.records()?;
    in_time("the records")?;
    client.read_record(7777, 0).expect_err("no such record");
    in_time("a refusal")
}

#[test]
fn a_run_under_fire_from_the_other_link_is_measured_like_any_other() -> Result<(), Fault> {
    let mut rigged = Rigged::with_rig(&Rig::standard())?;
    let settings = rigged.client.settings()?;
    let _cable = EmulatedUsbTransport::plug_in(rigged.shared())?;
    let usb = rigged.board().usb().clone();
    let start = frame(
        7,
        &Request::Start(RunSpec {
            points: [point(160.0, 10.0)].into_iter().collect(),
            excitation: ExcitationKind::SingleSine,
            labels: RunLabels::default(),
        }),
    );
    let started = exchange(&mut rigged, &start)?;
    assert_eq!(started, Response::Started { record_id: 1 });

    let mut fire = Ammunition::new(2);
    let mut bytes = 0;
    let ended = loop {
        let salvo = fire.no_stop(10_000);
        bytes += salvo.len();
        usb.send(&salvo);
        rigged.client.wait(Duration::from_millis(50))?;
        let _ = usb.receive();
        let before = rigged.board().elapsed();
        let status = rigged.client.status()?;
        assert!(rigged.board().elapsed() - before <= PROMPT);
        if !status.state.is_running() {
            break status;
        }
    };
    println!("{bytes} bytes of fire");
    assert_eq!(ended.state, RunState::Finished);
    assert_eq!(ended.overruns, 0, "no sample was lost");
    let result = rigged.client.point(0)?.expect("measured");
    assert_eq!(result.state, PointState::Valid);
    assert_eq!(rigged.client.settings()?, settings);

    // The start again, as it was: recognised, and nothing moves.
    for _ in 0..3 {
        assert_eq!(exchange(&mut rigged, &start)?, started);
    }
    rigged.expect_silence(Duration::from_millis(200))?;
    assert_eq!(rigged.client.status()?.state, RunState::Finished);
    assert_eq!(rigged.client.records()?.len(), 1);
    Ok(())
}

/// Sends a frame as it is over the serial line; its answer.
fn exchange(rigged: &mut Rigged, frame: &[u8]) -> Result<Response, Fault> {
    rigged.board().write_serial(frame);
    rigged.client.wait(PROMPT)?;
    let bytes = rigged.board().read_serial();
    let mut receiver = Receiver::new();
    for byte in bytes {
        if let Some(raw) = receiver.push(byte) {
            return Ok(Frame::check(raw)?.message()?);
        }
    }
    Err("no answer".into())
}

#[test]
fn after_any_bytes_the_next_request_is_answered_and_nothing_is_changed() -> Result<(), Fault> {
    let mut rigged = Rigged::with_port(Box::new(ShortedInputs))?;
    let board = rigged.shared();
    let mut usb = Client::new(Box::new(EmulatedUsbTransport::plug_in(board.clone())?));
    let before = rigged.client.settings()?;
    let mut fire = Ammunition::new(3);
    let write = frame(1, &Request::SettingsWrite(before.clone().into()));
    // Whole frames would be answered, one after the other, at the speed of the line.
    let noise = fire.noise(3000);
    let noise = noise.iter().map(|byte| byte.wrapping_mul(151)).collect();
    let other_rate = [Ammunition::heard().concat(), fire.no_stop(30_000)].concat();
    for (what, baud, bytes) in [
        ("noise", SERIAL_BAUD, noise),
        ("no end", SERIAL_BAUD, vec![0x55; 2 * MAX_FRAME]),
        ("a line without an end", SERIAL_BAUD, vec![b'A'; 600]),
        (
            "half a frame",
            SERIAL_BAUD,
            write[..write.len() / 2].to_vec(),
        ),
        ("zeros", SERIAL_BAUD, vec![0; 2000]),
        (
            "frames of the other host",
            SERIAL_BAUD,
            Ammunition::heard().concat(),
        ),
        ("damaged frames", SERIAL_BAUD, fire.noise(3000)),
        ("frames at 3 Mbaud", 3_000_000, other_rate),
    ] {
        // From now on the host on the USB holds the session.
        usb.release(0)?;
        let line = rigged.board().serial().clone();
        line.send_at(&bytes, baud, SERIAL_BAUD);
        while rigged.board().serial().is_sending() {
            rigged.client.wait(Duration::from_millis(1))?;
        }
        if baud != SERIAL_BAUD {
            // Nothing of it is heard, and nothing that was heard before is heard again.
            rigged.client.wait(AFTER_DAMAGE)?;
            assert!(rigged.board().read_serial().is_empty());
        }
        expect_answers(&board, &mut rigged.client).map_err(|error| format!("{what}: {error}"))?;
    }
    expect_answers(&board, &mut usb)?;
    assert_eq!(rigged.client.settings()?, before);
    assert_eq!(rigged.client.records()?, []);
    assert_eq!(rigged.client.status()?.state, RunState::Idle);
    let board = rigged.board();
    assert_eq!(
        board.silent_for(),
        Some(board.uptime()),
        "nothing ever moved"
    );
    Ok(())
}

/// Bytes of the stack above the deepest answer and the deepest evaluation together: for a driver's
/// interrupt that comes on top, and what the panic path needs to say why.
const STACK_MARGIN: usize = 8 << 10;

/// The task that measures interrupts the ones that answer, wherever they are: both depths add up. A
/// host that asked for the list of records when a point was being evaluated once overran the stack.
#[test]
fn the_deepest_answer_and_the_deepest_evaluation_fit_on_the_stack_together() -> Result<(), Fault> {
    let mut rigged = Rigged::with_rig(&Rig::standard())?;
    // Faster than the serial line: the first to change something, so it holds the session.
    let mut usb = Client::new(Box::new(EmulatedUsbTransport::plug_in(rigged.shared())?));
    let settings = rigged.client.settings()?;
    let mut questions: Vec<Vec<u8>> = [
        Request::Info,
        Request::Status,
        Request::Point { index: 0 },
        Request::Records { from: 1 },
        Request::ReadRecord { id: 1, offset: 0 },
        Request::SettingsRead,
        Request::SettingsWrite(settings.into()),
        Request::Release { through: 1 },
        Request::Capture { pairs: 64 },
        Request::ReadCapture { offset: 0 },
        Request::SelfTest,
    ]
    .iter()
    .map(|request| frame(1, request))
    .collect();
    questions.push(b"MMEM:CAT?\n".to_vec());
    rigged.paint_stack()?;
    for question in &questions {
        rigged.board().write_serial(question);
        rigged.board().usb().send(question);
        // The longest answer takes the serial line 130 ms.
        rigged.client.wait(Duration::from_millis(150))?;
    }
    let stack = rigged.stack_bytes()?;
    let answering = stack - rigged.unused_stack_bytes()?;
    let _ = rigged.board().read_serial();

    let run = RunSpec {
        // Folds into as many places as there are samples: the longest evaluation. Some points are over while the
        // run goes on: a record on its way to the flash is no part of the depth of a measurement.
        points: [point(315.0, 10.0); 12].into_iter().collect(),
        excitation: ExcitationKind::SingleSine,
        labels: RunLabels::default(),
    };
    usb.start(run)?;
    rigged.paint_stack()?;
    // Nobody asks meanwhile.
    rigged.client.wait(Duration::from_secs(2))?;
    let measuring = stack - rigged.unused_stack_bytes()?;
    let status = rigged.client.status()?;
    assert!(status.state.is_running() && status.point > 0, "{status:?}");
    println!("answering {answering} bytes, measuring {measuring}, of {stack}");
    assert!(answering + measuring + STACK_MARGIN <= stack);
    Ok(())
}
