//! `calib update`, the program, with a loader and the shipping image behind it.

use super::{folder, json, output, wait_for_answer};
use calib_host::emulated::EmulatedUsbTransport;
use calib_tests::rigged::Fault;
use calib_tests::two_slots::{TwoSlots, VERSION};
use calib_twin::rig_port::ShortedInputs;
use calib_twin::runner::{Door, HostLine, TcpDoor};
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::JoinHandle;
use std::time::Duration;

/// Board time between two looks at the line.
const STEP: Duration = Duration::from_millis(1);

/// A board as it leaves the workshop, behind a TCP port. Its time passes as fast as this computer lets it, so that an
/// update over 115 200 baud, 40 s, takes a few; switched off when it is dropped.
struct Commissioned {
    address: String,
    ended: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
}

impl Commissioned {
    fn power_on(by_usb: bool) -> Result<Self, Fault> {
        let ended = Arc::new(AtomicBool::new(false));
        let (ready, begun) = channel();
        let ends = Arc::clone(&ended);
        let thread = std::thread::spawn(move || {
            if let Err(fault) = run(by_usb, &ends, &ready) {
                // Nobody may be left to hear it.
                let _ = ready.send(Err(fault));
            }
        });
        Ok(Self {
            address: begun.recv()??,
            ended,
            thread: Some(thread),
        })
    }
}

impl Drop for Commissioned {
    fn drop(&mut self) {
        self.ended.store(true, Ordering::SeqCst);
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }
}

fn run(
    by_usb: bool,
    ended: &AtomicBool,
    ready: &Sender<Result<String, Fault>>,
) -> Result<(), Fault> {
    let board = TwoSlots::read()?.commissioned(Box::new(ShortedInputs))?;
    let board = Arc::new(Mutex::new(board));
    let device = || board.lock().unwrap_or_else(PoisonError::into_inner);
    let (serial, usb) = {
        let device = device();
        (device.serial().clone(), device.usb().clone())
    };
    let line: &dyn HostLine = if by_usb { &usb } else { &serial };
    let plug_in = || EmulatedUsbTransport::plug_in(Arc::clone(&board)).map(drop);
    if by_usb {
        plug_in()?;
    }
    let mut door = TcpDoor::listen(0)?;
    ready.send(Ok(door.address()))?;
    while !ended.load(Ordering::SeqCst) {
        device().run_for(STEP)?;
        door.serve(line, &line.receive())?;
        // Gone from the bus, as at a restart: the host sets it up again.
        if by_usb && usb.pipe_error().is_some() {
            plug_in()?;
        }
    }
    Ok(())
}

/// The image that an instrument says it runs.
fn image(folder: &Path, device: &str) -> serde_json::Value {
    wait_for_answer(folder, device);
    json(folder, &["--device", device, "info"])["image"].clone()
}

/// Sent, started, confirmed; what the instrument says of itself afterwards is the new image, in the other slot. The
/// same once more sends nothing.
fn is_updated(by_usb: bool) -> Result<(), Fault> {
    let folder = folder();
    let at = folder.path();
    std::fs::write(at.join("new.update"), TwoSlots::read()?.another())?;
    let device = Commissioned::power_on(by_usb)?;
    let before = image(at, &device.address);
    assert_eq!(
        (&before["slot"], &before["on_trial"]),
        (&"a".into(), &false.into())
    );

    let update = ["--device", &device.address, "update", "new.update"];
    let updated = json(at, &update);
    let after = image(at, &device.address);
    assert_eq!(
        (&after["slot"], &after["on_trial"]),
        (&"b".into(), &false.into())
    );
    assert_ne!(after["sha256"], before["sha256"]);
    assert_eq!(updated["image"], after);
    assert_eq!(updated["version"], VERSION);
    assert!(updated["sent_bytes"].as_u64() > Some(300_000), "{updated}");

    let again = output(at, &update);
    let said = String::from_utf8_lossy(&again.stdout);
    assert!(
        said.contains("ran already from slot b, confirmed"),
        "{said}"
    );
    Ok(())
}

#[test]
fn the_program_updates_an_instrument_over_the_serial_line() -> Result<(), Fault> {
    is_updated(false)
}

#[test]
fn the_program_updates_an_instrument_over_usb() -> Result<(), Fault> {
    is_updated(true)
}
