//! Updates through the loader: the new image runs, or the old one does, wherever the supply fails.

use calib_boot::layout::Slot;
use calib_boot::trusted::DEVELOPMENT_SEED;
use calib_host::emulated::EmulatedUsbTransport;
use calib_link::session::update::{confirm, send, wait_for_start};
use calib_link::{Client, Error};
use calib_protocol::frame::{Frame, MAX_FRAME, encode};
use calib_protocol::message::{Refusal, Request, ResetCause, Response};
use calib_protocol::update::{ImageSigner, ImageSlot, RunningImage, UpdateStep};
use calib_tests::rigged::{Fault, Rigged, point};
use calib_tests::two_slots::{BOARD, TwoSlots, VERSION, release};
use calib_twin::plant::Plant;
use calib_twin::rig::Rig;
use calib_twin::rig_port::ShortedInputs;
use calib_twin::runner::{Emulator, Gap, Torn};
use std::time::Duration;

/// From power-on until requests are heard: the loader reads an image first.
const BOOT: Duration = Duration::from_millis(600);
/// Longest time of a step: three sectors erased, 1.1 s each.
const STEP: Duration = Duration::from_secs(6);
/// Time after which the firmware has seen the button go up or down.
const BUTTON_SEEN: Duration = Duration::from_millis(60);
/// An image of so many bytes has vectors and nothing they lead to.
const SHORT: usize = 2048;

fn rigged(slots: &TwoSlots) -> Result<Rigged, Fault> {
    let mut rigged = Rigged::of(slots.commissioned(Box::new(ShortedInputs))?);
    rigged.client.wait(BOOT)?;
    Ok(rigged)
}

/// An update of images that do not run.
fn short(slots: &TwoSlots, version: &str, board: &str, seed: &[u8; 32]) -> Vec<u8> {
    let images = Slot::ALL.map(|slot| slots.image(slot)[..SHORT].to_vec());
    release(&images, version, board, seed)
}

/// The whole way: sent while the watchdog waits 250 ms, tried, confirmed, and it measures from slot B. The
/// supply fails where the loader notes the start, and where the confirmation is written.
#[test]
fn an_update_runs_from_the_other_slot_and_is_confirmed() -> Result<(), Fault> {
    let slots = TwoSlots::read()?;
    let mut rigged = Rigged::of(slots.commissioned(Box::new(Plant::new(&Rig::standard())))?);
    rigged.client.wait(BOOT)?;
    let before = rigged.client.running_image()?;
    assert_eq!(before.slot, ImageSlot::A);
    assert_eq!(before.origin.signer, ImageSigner::Development);
    assert!(!before.on_trial && !before.rolled_back);
    let update = slots.another();
    let mut written = 0;
    // Over USB, which is faster; the serial line is another test's (tests/tests/tool/updates.rs).
    let usb = EmulatedUsbTransport::plug_in(rigged.shared())?;
    let sent = send(&mut Client::new(Box::new(usb)), &update, |progress| {
        written = progress.written
    })?;
    assert_eq!(
        (sent.slot, written),
        (ImageSlot::B, slots.image(Slot::B).len() + 32)
    );
    assert!(rigged.board().silent_for().is_some(), "the exciter moved");
    assert_eq!(
        rigged.board().resets()?,
        Vec::<String>::new(),
        "the watchdog was not fed"
    );
    let in_start = cut_in_next_operation(&mut rigged)?;
    assert!(matches!(in_start, Torn::Word { .. }), "{in_start:?}");
    rigged.client.wait(BOOT)?;
    let on_trial = rigged.client.running_image()?;
    assert!(
        on_trial.slot == ImageSlot::B && on_trial.on_trial,
        "{on_trial:?}"
    );
    let in_confirm = cut_in_confirm(&mut rigged)?;
    assert!(matches!(in_confirm, Torn::Word { .. }), "{in_confirm:?}");
    rigged.client.wait(BOOT)?;
    let running = confirm(&mut rigged.client, &sent)?;
    assert_eq!((running.slot, running.on_trial), (ImageSlot::B, false));
    assert_eq!(running.origin.sha256, sent.sha256);
    for _ in 0..4 {
        rigged.board().power_cycle()?;
        rigged.client.wait(BOOT)?;
        assert_eq!(rigged.client.running_image()?, running);
    }
    let outcome = rigged.run(&[point(160.0, 10.0)])?;
    assert_eq!(outcome.points.len(), 1, "it measures from slot B");
    // What clocks and power find odd in a supply that comes back is not of an update.
    let gaps = rigged.board().gaps()?;
    let of_an_update = |gap: &&Gap| gap.0.contains("Flash") || gap.0.contains("IWDG");
    assert_eq!(gaps.iter().find(of_an_update), None);
    Ok(())
}

/// Cuts the supply in the first operation of the next start, and restores it.
fn cut_in_next_operation(rigged: &mut Rigged) -> Result<Torn, Fault> {
    let mut board = rigged.board();
    board.power_cycle()?;
    let next = board.flash_watch().code_operations() + 1;
    board.run_for(Duration::from_micros(10))?;
    assert!(
        board.run_into_code_operation(next, 0.5, BOOT)?,
        "no start was noted"
    );
    let torn = board.cut_power()?;
    board.restore_power()?;
    Ok(torn)
}

/// Cuts the supply where the confirmation is written, and restores it.
fn cut_in_confirm(rigged: &mut Rigged) -> Result<Torn, Fault> {
    let mut board = rigged.board();
    let next = board.flash_watch().code_operations() + 1;
    ask(&mut board, &Request::Update(UpdateStep::Confirm))?;
    assert!(
        board.run_into_code_operation(next, 0.5, STEP)?,
        "nothing was confirmed"
    );
    let torn = board.cut_power()?;
    board.restore_power()?;
    Ok(torn)
}

/// The supply fails in each operation of an update but most words of the image, which are alike: every
/// time the old image starts.
#[test]
fn a_cut_in_any_operation_of_an_update_leaves_an_image_that_starts() -> Result<(), Fault> {
    let slots = TwoSlots::read()?;
    let update = short(&slots, VERSION, BOARD, &DEVELOPMENT_SEED);
    let mut board = slots.commissioned(Box::new(ShortedInputs))?;
    board.run_for(BOOT)?;
    let mut second = slots.commissioned(Box::new(ShortedInputs))?;
    let (mut words, mut sectors) = (0, 0);
    for step in steps(&update) {
        ask(&mut board, &Request::Update(step))?;
        loop {
            let next = board.flash_watch().code_operations() + 1;
            // Early, late, and in the middle, in turn.
            let fraction = [0.02, 0.5, 0.98][next as usize % 3];
            board.flash_watch().set_code_trap(next, fraction);
            if board.run_until_received(STEP)? {
                break;
            }
            let flash = board.flash_at_cut()?;
            let torn = flash.torn();
            match torn {
                Torn::Sector { .. } => sectors += 1,
                Torn::Word { .. } => words += 1,
                Torn::Nothing => return Err("it stopped where nothing was under way".into()),
            }
            // The image's words between its first and its last ones.
            if matches!(torn, Torn::Word { .. }) && (2..=62).contains(&words) && words != 31 {
                continue;
            }
            second.cut_power()?;
            second.fit_flash(&flash)?;
            second.restore_power()?;
            second.run_for(BOOT)?;
            let running = running(&mut second).map_err(|fault| format!("{torn:?}: {fault}"))?;
            assert_eq!(running.slot, ImageSlot::A, "{torn:?}");
        }
        assert_eq!(answer(&mut board)?, Response::Done);
    }
    // The image, its manifest and the journal.
    assert_eq!((words, sectors), (SHORT / 32 + 8 + 1, 3));
    Ok(())
}

/// The steps a host takes with a file, up to the restart.
fn steps(update: &[u8]) -> Vec<UpdateStep> {
    let parts = calib_boot::file::parts(update).expect("an update");
    let part = parts[Slot::B as usize];
    let mut steps = vec![UpdateStep::Begin {
        manifest: heapless::Vec::from_slice(part.manifest).expect("fits"),
    }];
    steps.extend(
        (0..)
            .step_by(1024)
            .zip(part.image.chunks(1024))
            .map(|(offset, data)| {
                let data = heapless::Vec::from_slice(data).expect("fits");
                UpdateStep::Block { offset, data }
            }),
    );
    steps.push(UpdateStep::Finish);
    steps
}

/// A new image that never comes so far as to start its own watchdog: the loader's ends each of three starts,
/// then the old one runs and says so.
#[test]
fn an_image_that_hangs_is_rolled_back() -> Result<(), Fault> {
    let slots = TwoSlots::read()?;
    let mut rigged = rigged(&slots)?;
    let update = short(&slots, VERSION, BOARD, &DEVELOPMENT_SEED);
    let sent = send(&mut rigged.client, &update, |_| ())?;
    rigged.client.reset()?;
    rigged.client.wait(Duration::from_secs(30))?;
    let running = rigged.client.running_image()?;
    assert!(running.slot == ImageSlot::A && running.rolled_back && !running.on_trial);
    let resets = rigged.board().resets()?;
    let by_watchdog = resets.iter().filter(|cause| cause.contains("IWDG")).count();
    assert_eq!(by_watchdog, 3, "{resets:?}");
    assert_eq!(rigged.client.info()?.reset_cause, ResetCause::Watchdog);
    let error = confirm(&mut rigged.client, &sent).expect_err("another image runs");
    assert!(
        error.to_string().contains("the image it had before"),
        "{error}"
    );
    Ok(())
}

#[test]
fn an_image_that_nobody_confirms_is_rolled_back() -> Result<(), Fault> {
    let slots = TwoSlots::read()?;
    let mut rigged = rigged(&slots)?;
    send(&mut rigged.client, &slots.another(), |_| ())?;
    for start in 1..=3 {
        rigged.board().power_cycle()?;
        wait_for_start(&mut rigged.client)?;
        let running = rigged.client.running_image()?;
        assert!(
            running.slot == ImageSlot::B && running.on_trial,
            "start {start}: {running:?}"
        );
        // What it may fall back to is not overwritten.
        let again = send(
            &mut rigged.client,
            &short(&slots, VERSION, BOARD, &DEVELOPMENT_SEED),
            |_| (),
        );
        assert_eq!(refusal(again), Some(Refusal::ImageOnTrial));
    }
    rigged.board().power_cycle()?;
    wait_for_start(&mut rigged.client)?;
    let running = rigged.client.running_image()?;
    assert!(
        running.slot == ImageSlot::A && running.rolled_back,
        "{running:?}"
    );
    Ok(())
}

#[test]
fn what_is_not_for_this_instrument_is_refused_and_named() -> Result<(), Fault> {
    let slots = TwoSlots::read()?;
    let mut rigged = rigged(&slots)?;
    let whole = short(&slots, VERSION, BOARD, &DEVELOPMENT_SEED);
    let mut refused = |update: &[u8]| refusal(send(&mut rigged.client, update, |_| ()));
    let other_key = short(&slots, VERSION, BOARD, &[1; 32]);
    assert_eq!(refused(&other_key), Some(Refusal::ImageSignature));
    let other_board = short(&slots, VERSION, "fictitious-carrier", &DEVELOPMENT_SEED);
    assert_eq!(refused(&other_board), Some(Refusal::ImageNotForHere));
    let older = short(&slots, "0.0.9", BOARD, &DEVELOPMENT_SEED);
    assert_eq!(refused(&older), Some(Refusal::ImageOlder));
    // A bit of the image for slot B, which comes last.
    let mut flipped = whole.clone();
    *flipped.last_mut().expect("not empty") ^= 1;
    assert_eq!(refused(&flipped), Some(Refusal::ImageDamaged));
    // A bit of its manifest: in the digest.
    let mut flipped = whole.clone();
    let manifest = whole.len() - SHORT - 256;
    flipped[manifest + 50] ^= 1;
    assert_eq!(refused(&flipped), Some(Refusal::ImageSignature));
    let shorter = send(&mut rigged.client, &whole[..whole.len() - 1], |_| ());
    let error = shorter.expect_err("not all of it");
    assert!(error.to_string().contains("not all of one"), "{error}");
    let skipped = rigged.client.update(&UpdateStep::Block {
        offset: 4096,
        data: heapless::Vec::from_slice(&[0; 32]).expect("fits"),
    });
    assert_eq!(refusal(skipped), Some(Refusal::UpdateOrder));
    rigged.board().power_cycle()?;
    wait_for_start(&mut rigged.client)?;
    assert_eq!(rigged.client.running_image()?.slot, ImageSlot::A);
    // The older one under a hand.
    rigged.board().press_button(true)?;
    rigged.client.wait(BUTTON_SEEN)?;
    assert_eq!(refusal(send(&mut rigged.client, &older, |_| ())), None);
    Ok(())
}

/// Without a loader there is nobody to start the new image, and the exciter is not at rest in a run.
#[test]
fn an_update_is_refused_without_a_loader_and_in_a_run() -> Result<(), Fault> {
    let slots = TwoSlots::read()?;
    let update = short(&slots, VERSION, BOARD, &DEVELOPMENT_SEED);
    let mut bare = Rigged::with_port(Box::new(ShortedInputs))?;
    assert_eq!(bare.client.image()?, None);
    let refused = send(&mut bare.client, &update, |_| ());
    assert_eq!(refusal(refused), Some(Refusal::NoLoader));
    assert_eq!(
        refusal(bare.client.update(&UpdateStep::Confirm)),
        Some(Refusal::NoLoader)
    );

    let mut rigged = Rigged::of(slots.commissioned(Box::new(Plant::new(&Rig::standard())))?);
    rigged.client.wait(BOOT)?;
    rigged.client.start(calib_protocol::message::RunSpec {
        points: [point(160.0, 10.0)].into_iter().collect(),
        excitation: calib_core::point::ExcitationKind::SingleSine,
        labels: calib_protocol::record::RunLabels::default(),
    })?;
    let refused = send(&mut rigged.client, &update, |_| ());
    assert_eq!(refusal(refused), Some(Refusal::Busy));
    assert_eq!(rigged.board().flash_watch().code_operations(), 0);
    Ok(())
}

/// Why an instrument refused; none where it did not.
fn refusal<T: std::fmt::Debug>(done: Result<T, Error>) -> Option<Refusal> {
    match done {
        Ok(_) => None,
        Err(Error::Refused(refused)) => Some(refused.refusal),
        Err(other) => panic!("no refusal: {other}"),
    }
}

fn running(board: &mut Emulator) -> Result<RunningImage, Fault> {
    drop(board.read_serial());
    ask(board, &Request::Image)?;
    if !board.run_until_received(Duration::from_secs(1))? {
        return Err("nothing answers".into());
    }
    match answer(board)? {
        Response::Image(Some(running)) => Ok(running),
        other => Err(format!("{other:?}").into()),
    }
}

/// Puts a request on the line.
fn ask(board: &mut Emulator, request: &Request) -> Result<(), Fault> {
    let mut frame = vec![0; 1 + MAX_FRAME];
    let length = encode(0x7000, request, &mut frame[1..]).map_err(|_| "too long a frame")?;
    board.write_serial(&frame[..=length]);
    Ok(())
}

/// The answer that has begun to come.
fn answer(board: &mut Emulator) -> Result<Response, Fault> {
    board.run_for(Duration::from_millis(30))?;
    let mut bytes = board.read_serial();
    bytes.pop();
    Ok(Frame::check(&mut bytes)?.message()?)
}
