//! The boards of `firmware/boards` with the images built for them, each on its own schematic. The one
//! of the shipping image is what all other tests are on.

use super::board::unmodelled;
use calib_boot::layout::{LONGEST_IMAGE, Slot, WORD};
use calib_boot::trusted::DEVELOPMENT_SEED;
use calib_core::point_state::PointState;
use calib_link::session::update::send;
use calib_protocol::message::{Refusal, RunState};
use calib_protocol::record::digest;
use calib_protocol::update::{ImageSigner, ImageSlot};
use calib_tests::judge::deviation;
use calib_tests::rigged::{Fault, Rigged, point, true_certificate};
use calib_tests::two_slots::{TwoSlots, VERSION, release};
use calib_twin::board::{Leds, Schematic};
use calib_twin::plant::Plant;
use calib_twin::rig::Rig;
use calib_twin::rig_port::ShortedInputs;
use calib_twin::runner::{Emulator, Firmware};
use std::path::Path;
use std::time::Duration;

const BOARDS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../firmware/boards");
/// The board of the shipping image.
const SHIPPING: &str = "nucleo-h743zi2";
/// Longer than the firmware takes from a look at the button to its lamps.
const SEEN: Duration = Duration::from_millis(100);

const MEASURING: Leds = Leds {
    green: false,
    yellow: true,
    red: false,
};
const REFUSED: Leds = Leds {
    green: false,
    yellow: false,
    red: true,
};

/// The other boards by the names of their folders.
fn boards() -> Result<Vec<String>, Fault> {
    let mut names = Vec::new();
    for folder in std::fs::read_dir(BOARDS)? {
        names.push(folder?.file_name().to_string_lossy().into_owned());
    }
    names.retain(|name| name != SHIPPING);
    Ok(names)
}

fn schematic(board: &str) -> Result<Schematic, Fault> {
    let folder = Path::new(BOARDS).join(board);
    Ok(Schematic::read(&folder.join("schematic.toml"))?)
}

/// The image of a board, beside the shipping one.
fn image(board: &str) -> Result<Firmware, Fault> {
    let shipping = Firmware::shipping()?;
    let path = shipping.path().with_file_name("boards").join(board);
    Firmware::read(&path).map_err(|error| format!("{error}; `./run elf {board}` builds it").into())
}

/// A calibrator of that board on a rig with the board's front end.
fn calibrator(board: &str) -> Result<(Rigged, Rig), Fault> {
    let schematic = schematic(board)?;
    let mut rig = Rig::standard();
    schematic.fit(&mut rig);
    let firmware = image(board)?.on(schematic);
    let rigged = Rigged::with_image(&firmware, Box::new(Plant::new(&rig)))?;
    Ok((rigged, rig))
}

#[test]
fn every_board_calibrates_with_its_own_pins_clocks_and_scales() -> Result<(), Fault> {
    let boards = boards()?;
    assert!(boards.len() >= 2, "{boards:?}");
    for board in boards {
        let (mut rigged, rig) = calibrator(&board)?;
        // With a hand on the button of the board.
        rigged.certify_reference(&true_certificate(&rig))?;
        rigged.adjust(|settings| settings.blocks = 3)?;
        let outcome = rigged.run(&[point(160.0, 10.0), point(5_000.0, 10.0)])?;
        assert_eq!(outcome.state, RunState::Finished, "{board}");
        let sample_rate_hz = rigged.client.info()?.sample_rate_hz;
        for result in &outcome.points {
            let off = deviation(result, &rig, sample_rate_hz).magnitude_rel;
            let budget = result.expanded_uncertainty_rel;
            println!(
                "{board}: {} Hz, {off:+.1e}, U {budget:.1e}",
                result.spec.frequency_hz
            );
            assert_eq!(result.state, PointState::Valid, "{board}");
            assert!(off.abs() <= f64::from(budget), "{board}: {off}");
        }
        rigged.expect_silence(SEEN)?;
        tap_and_stop(&board, &mut rigged.board())?;
    }
    Ok(())
}

/// The green lamp alone winks, within two seconds.
fn is_ready(device: &mut Emulator) -> Result<bool, Fault> {
    let mut winks = false;
    for _ in 0..45 {
        device.run_for(Duration::from_millis(50))?;
        let Leds { green, yellow, red } = device.leds()?;
        winks |= green;
        if yellow || red {
            return Ok(false);
        }
    }
    Ok(winks)
}

/// Starts the default list with a tap, stops it with a press, and looks at the lamps.
fn tap_and_stop(board: &str, device: &mut Emulator) -> Result<(), Fault> {
    assert!(is_ready(device)?, "{board}");
    for pressed in [true, false] {
        device.press_button(pressed)?;
        device.run_for(SEEN)?;
        assert_eq!(device.leds()? == MEASURING, !pressed, "{board}");
    }
    device.press_button(true)?;
    // Until the exciter is silent and the record stored.
    device.run_for(Duration::from_secs(1))?;
    assert_eq!(device.leds()?, REFUSED, "{board}");
    assert!(device.silent_for().is_some(), "{board}");
    assert_eq!(unmodelled(device)?, [""; 0], "{board}");
    Ok(())
}

/// Otherwise the test above would show nothing.
#[test]
fn an_image_on_a_board_it_is_not_for_answers_nothing() -> Result<(), Fault> {
    let carrier = schematic("fictitious-carrier")?;
    let firmware = Firmware::shipping()?.on(carrier);
    let rig = Box::new(Plant::new(&Rig::standard()));
    assert!(Rigged::with_image(&firmware, rig).is_err());
    Ok(())
}

/// The loader takes no pin, no clock and no part of a board: the one there is starts every board's image, from the
/// slot, whole and signed. What is for another board is refused.
#[test]
fn one_loader_starts_the_image_of_every_board() -> Result<(), Fault> {
    let slots = TwoSlots::read()?;
    for board in boards()? {
        let image = flashed(&board)?;
        let update = |board: &str, image: &[u8]| {
            let images = [image.to_vec(), image.to_vec()];
            release(&images, VERSION, board, &DEVELOPMENT_SEED)
        };
        let own = update(&board, &image);
        let on = schematic(&board)?;
        let device = slots.commissioned_with(&own, on, Box::new(ShortedInputs))?;
        let mut rigged = Rigged::of(device);
        // The loader reads an image first.
        rigged.client.wait(Duration::from_millis(600))?;
        let running = rigged.client.running_image()?;
        assert_eq!(running.slot, ImageSlot::A, "{board}");
        assert_eq!(running.origin.signer, ImageSigner::Development, "{board}");
        assert_eq!(running.origin.sha256, digest(&image), "{board}");
        let other = [&image[..], &[0xFF; WORD]].concat();
        let refused = send(&mut rigged.client, &update(SHIPPING, &other), |_| ());
        let error = refused.expect_err("for another board");
        assert!(
            matches!(&error, calib_link::Error::Refused(refused) if refused.refusal == Refusal::ImageNotForHere),
            "{board}: {error}"
        );
    }
    Ok(())
}

/// The image of a board in slot A, up to its last word that is not as erased.
fn flashed(board: &str) -> Result<Vec<u8>, Fault> {
    let firmware = image(board)?.on(schematic(board)?);
    let mut device = Emulator::power_on(&firmware, Box::new(ShortedInputs))?;
    let slot = device.read_memory(u64::from(Slot::A.start()), LONGEST_IMAGE as usize)?;
    let last = slot.iter().rposition(|byte| *byte != 0xFF);
    let words = last.ok_or("the slot is empty")? / WORD + 1;
    Ok(slot[..words * WORD].to_vec())
}
