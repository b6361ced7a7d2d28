//! Requests and answers over good, bad and wrong links.

use crate::device::{Device, record, settings};
use crate::memory_link::{Direction, Fault, MemoryLink, SharedDevice, client, shared};
use calib_core::point::{ExcitationKind, PointSpec};
use calib_link::{Client, LinkError, ProtocolError, Transport};
use calib_link::{Error, Result};
use calib_protocol::frame::PROTOCOL_VERSION;
use calib_protocol::message::{Refusal, RunSpec};
use calib_protocol::record::RunLabels;
use std::io;
use std::time::Duration;

/// One of each request, as text, to compare conversations.
fn conversation(client: &mut Client) -> Result<String> {
    let point = PointSpec {
        frequency_hz: 160.0,
        acceleration_rms_ms2: 10.0,
    };
    let spec = RunSpec {
        points: [point, point].into_iter().collect(),
        excitation: ExcitationKind::SingleSine,
        labels: RunLabels::default(),
    };
    let mut heard = vec![
        format!("{:?}", client.info()?),
        format!("{:?}", client.settings()?),
        format!("{:?}", client.write_settings(settings())?),
        format!("{:?}", client.records()?),
        format!("{:?}", client.read_record(3, 0)?),
        format!("{:?}", client.start(spec)?),
    ];
    client.stop()?;
    heard.push(format!("{:?}", client.records()?.len()));
    heard.push(format!("{:?}", client.reset()?));
    Ok(heard.join("\n"))
}

fn device() -> SharedDevice {
    shared(Device::with_record(3, 2))
}

#[test]
fn a_good_link_needs_no_repetition() {
    let mut client = client(&device());
    conversation(&mut client).expect("conversation");
    assert_eq!(client.repetitions(), 0);
}

/// One byte damaged, lost or added, at every position of the conversation and
/// in both directions: the conversation comes out as on a good link, and the
/// run is started once.
#[test]
fn any_single_fault_at_any_byte_is_healed() {
    let good = MemoryLink::new(&device());
    let passed = good.counter();
    let wanted = conversation(&mut Client::new(Box::new(good))).expect("good link");
    let bytes = *passed.lock().expect("counter");
    assert!(bytes.iter().all(|count| *count > 150), "{bytes:?}");
    for direction in [Direction::ToDevice, Direction::ToHost] {
        for fault in [Fault::Flip, Fault::Lose, Fault::AddZero, Fault::AddOther] {
            for position in 0..bytes[direction as usize] {
                let device = device();
                let link = MemoryLink::with_fault(&device, direction, position, fault);
                let mut client = Client::new(Box::new(link));
                let heard = conversation(&mut client);
                let at = format!("{fault:?} at byte {position} {direction:?}");
                assert_eq!(heard.as_ref().ok(), Some(&wanted), "{at}: {heard:?}");
                assert!(client.repetitions() <= 1, "{at}");
                assert_eq!(device.lock().expect("device").starts, 1, "{at}");
            }
        }
    }
}

#[test]
fn answers_in_single_bytes_are_understood() {
    let mut link = MemoryLink::new(&device());
    link.read_size = 1;
    conversation(&mut Client::new(Box::new(link))).expect("conversation");
}

#[test]
fn a_device_of_another_version_is_named() {
    for version in [0, PROTOCOL_VERSION - 1, PROTOCOL_VERSION + 1, 200] {
        let device = device();
        device.lock().expect("device").protocol_version = version;
        let error = client(&device).info().expect_err("another version");
        assert!(
            matches!(error, Error::Protocol(ProtocolError::Version { device }) if device == version)
        );
        assert_eq!(error.exit_code(), 4);
        let way_out = if version > PROTOCOL_VERSION {
            "install the release"
        } else {
            "update the firmware"
        };
        assert!(error.hint().expect("hint").contains(way_out), "{version}");
    }
}

#[test]
fn a_refusal_is_no_link_failure() {
    let error = client(&device())
        .read_record(4, 0)
        .expect_err("no record 4");
    assert!(
        matches!(&error, Error::Refused(refused) if refused.refusal == Refusal::RecordNotFound)
    );
    assert_eq!(error.exit_code(), 5);
    assert!(error.hint().expect("hint").contains("calib records"));
}

#[test]
fn records_are_listed_beyond_one_answer() {
    let device = shared(Device::new());
    for id in 1..=40 {
        device.lock().expect("device").store(record(id, 0));
    }
    let ids: Vec<u32> = client(&device)
        .records()
        .expect("list")
        .iter()
        .map(|record| record.id)
        .collect();
    assert_eq!(ids, (1..=40).collect::<Vec<_>>());
}

/// Says the same over and over.
struct Parrot(&'static [u8]);

impl Transport for Parrot {
    fn name(&self) -> String {
        "parrot".to_owned()
    }
    fn send(&mut self, _: &[u8]) -> io::Result<()> {
        Ok(())
    }
    fn now(&self) -> Duration {
        Duration::ZERO
    }
    fn receive(&mut self, buffer: &mut [u8], _: Duration) -> io::Result<usize> {
        let count = buffer.len().min(self.0.len());
        buffer[..count].copy_from_slice(&self.0[..count]);
        Ok(count)
    }
}

#[test]
fn silence_noise_and_damage_are_told_apart() {
    let ask = |words| {
        Client::new(Box::new(Parrot(words)))
            .info()
            .expect_err("no calibrator")
    };
    assert!(matches!(
        ask(b""),
        Error::Link(LinkError::NoAnswer { attempts: 4, .. })
    ));
    // A GPS receiver: text, and never the zero that ends a frame.
    assert!(matches!(
        ask(b"$GPGGA,123519,4807.038,N\r\n"),
        Error::Link(LinkError::NotACalibrator { .. })
    ));
    assert!(matches!(
        ask(b"damaged\0"),
        Error::Link(LinkError::Damaged { .. })
    ));
    for words in [&b""[..], b"text", b"damaged\0"] {
        let error = ask(words);
        assert_eq!(error.exit_code(), 3);
        assert!(error.to_string().contains("parrot"), "{error}");
        assert!(!error.hint().expect("a way out").is_empty());
    }
}
