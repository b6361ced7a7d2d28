//! Captures over a link that may be bad.

use crate::command_line::{calib, json, serve, text};
use crate::device::{Device, FIRST_PAIR, codes};
use crate::memory_link::{Direction, Fault, MemoryLink, client, shared};
use calib_link::Client;
use calib_link::Error;
use calib_link::capture::{Capture, Inputs};
use calib_protocol::message::Refusal;

/// As the device in memory has it.
const VOLT_PER_CODE: f64 = 1.5e-4_f32 as f64;

fn expect(capture: &Capture, pairs: u16) {
    assert_eq!(capture.first_index, FIRST_PAIR);
    assert_eq!(capture.sample_rate_hz, 50_000.0);
    let volts = |channel: usize| -> Vec<f64> {
        let code = |index| f64::from(codes(index)[channel]);
        (0..pairs)
            .map(|i| (code(i) - 32_768.0) * VOLT_PER_CODE)
            .collect()
    };
    assert_eq!(capture.reference_v, volts(0));
    assert_eq!(capture.dut_v, volts(1));
}

#[test]
fn a_capture_comes_whole_and_in_volts() {
    let device = shared(Device::new());
    let mut client = client(&device);
    let inputs = Inputs::of(&mut client).expect("answers");
    for pairs in [1, 255, 256, 257, 16_384] {
        let capture = inputs.capture(&mut client, pairs).expect("captures");
        expect(&capture, pairs);
        // The first code of the reference is 0, the end of its range.
        assert_eq!(
            (capture.reference_clipped, capture.dut_clipped),
            (true, false)
        );
    }
}

#[test]
fn a_bad_link_takes_longer_and_changes_nothing() {
    let device = shared(Device::new());
    let link = MemoryLink::new(&device);
    let counter = link.counter();
    let mut sound = Client::new(Box::new(link));
    let inputs = Inputs::of(&mut sound).expect("answers");
    let before = *counter.lock().expect("counter");
    inputs.capture(&mut sound, 600).expect("captures");
    let after = *counter.lock().expect("counter");
    for direction in [Direction::ToDevice, Direction::ToHost] {
        let bytes = after[direction as usize] - before[direction as usize];
        // A prime step meets every part of the frames, in seconds.
        for position in (0..bytes).step_by(37) {
            for fault in [Fault::Flip, Fault::Lose, Fault::AddZero] {
                let device = shared(Device::new());
                let link = MemoryLink::with_fault(&device, direction, position, fault);
                let mut client = Client::new(Box::new(link));
                let capture = inputs.capture(&mut client, 600).expect("captures");
                expect(&capture, 600);
            }
        }
    }
}

#[test]
fn a_capture_that_another_host_replaces_is_noticed() {
    let mut device = Device::new();
    device.other_capture_at_look = Some(5);
    let mut client = client(&shared(device));
    let inputs = Inputs::of(&mut client).expect("answers");
    let error = inputs.capture(&mut client, 1000).expect_err("mixed");
    assert!(error.to_string().contains("another capture"), "{error}");
    assert_eq!(error.exit_code(), 6);
}

#[test]
fn a_standing_sample_clock_is_noticed() {
    let mut device = Device::new();
    device.clock_stands = true;
    let mut client = client(&shared(device));
    let inputs = Inputs::of(&mut client).expect("answers");
    let error = inputs.capture(&mut client, 10).expect_err("nothing comes");
    assert!(error.to_string().contains("no samples"), "{error}");
}

#[test]
fn lengths_out_of_range_are_refused() {
    let mut client = client(&shared(Device::new()));
    let inputs = Inputs::of(&mut client).expect("answers");
    for pairs in [0, 16_385] {
        let refused = inputs.capture(&mut client, pairs);
        assert!(
            matches!(&refused, Err(Error::Refused(refused)) if refused.refusal == Refusal::CaptureLength),
            "{refused:?}"
        );
    }
}

#[test]
fn the_verb_prints_writes_and_names_what_is_wrong() {
    let directory = tempfile::tempdir().expect("directory");
    let (_, address) = serve(Device::new());
    let go = |arguments: &[&str]| {
        let arguments = [&["capture"], arguments, &["--device", &address]].concat();
        calib(directory.path(), &arguments)
    };
    let shown = go(&["--pairs", "300", "--csv", "wave.csv"]);
    let shown = text(&shown.stdout);
    // Codes 0 to 299: the mean is 149.5 - 32 768 codes of 0.15 mV.
    assert!(shown.starts_with("300 samples of both channels, 6.0 ms from sample 7000000000 on\n"));
    assert!(shown.contains("-4892.77"), "{shown}");
    assert!(shown.contains("CLIPPED"), "{shown}");
    let csv = std::fs::read_to_string(directory.path().join("wave.csv")).expect("written");
    let lines: Vec<&str> = csv.lines().collect();
    assert_eq!(lines.len(), 301);
    assert_eq!(lines[0], "time_s,reference_v,dut_v");
    // (299 - 32 768) and (49 701 - 32 768) codes of 0.15 mV, 299 x 20 us.
    assert_eq!(lines[300], "0.005980000,-4.870350,2.539950");

    let report = json(&go(&["--pairs", "300", "--frequency", "1000", "--json"]));
    assert_eq!(report["first_index"], FIRST_PAIR);
    assert_eq!(report["reference"]["tone"]["frequency_hz"], 1000.0);
    let harmonics = report["dut"]["tone"]["harmonics"].as_array();
    assert_eq!(harmonics.expect("a list").len(), 4);
    assert_eq!(report["state"], serde_json::Value::Null);

    for (arguments, code, named) in [
        (&["--level", "10"][..], 2, "--frequency"),
        (&["--pairs", "16385"], 2, "16384"),
        (
            &["--pairs", "300", "--frequency", "100"],
            2,
            "one cycle at least",
        ),
        (&["--frequency", "30000"], 2, "sample rate"),
        (&["--frequency", "3", "--level", "10"], 6, "4.2 Hz"),
    ] {
        let output = go(arguments);
        let message = text(&output.stderr);
        assert_eq!(output.status.code(), Some(code), "{message}");
        assert!(message.contains(named), "{message}");
    }
}

#[test]
fn a_point_that_is_played_for_it_is_followed_to_its_end() {
    let directory = tempfile::tempdir().expect("directory");
    let (device, address) = serve(Device::new());
    let arguments = ["capture", "--frequency", "1000", "--level", "10", "--json"];
    let output = calib(
        directory.path(),
        &[&arguments[..], &["--device", &address]].concat(),
    );
    // This device never says it measures: it goes from settling to its end.
    let message = text(&output.stderr);
    assert_eq!(output.status.code(), Some(7), "{message}");
    assert!(message.contains("nothing captured"), "{message}");
    assert_eq!(device.lock().expect("device").records.len(), 1);
}
