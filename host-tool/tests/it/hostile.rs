//! Devices that lie, babble and never end.

use crate::device::Device;
use crate::memory_link::{client, shared};
use calib_link::session;
use calib_link::{Client, RetryPolicy, Transport};
use calib_protocol::frame::{Frame, MAX_FRAME, Receiver, encode};
use calib_protocol::message::{Refusal, Response};
use proptest::prelude::*;
use std::io;
use std::time::Duration;

/// Answers every request with the next of its payloads, correctly framed.
struct Liar {
    receiver: Receiver,
    answers: Vec<Vec<u8>>,
    inbox: Vec<u8>,
    asked: usize,
}

impl Liar {
    fn client(answers: Vec<Vec<u8>>) -> Client {
        let policy = RetryPolicy {
            attempts: 2,
            ..RetryPolicy::default()
        };
        let liar = Self {
            receiver: Receiver::new(),
            answers,
            inbox: Vec::new(),
            asked: 0,
        };
        Client::with_policy(Box::new(liar), policy)
    }
}

/// Bytes that postcard writes as they are.
struct Raw<'a>(&'a [u8]);

impl serde::Serialize for Raw<'_> {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        use serde::ser::SerializeTuple;
        let mut tuple = serializer.serialize_tuple(self.0.len())?;
        self.0
            .iter()
            .try_for_each(|byte| tuple.serialize_element(byte))?;
        tuple.end()
    }
}

impl Transport for Liar {
    fn name(&self) -> String {
        "liar".to_owned()
    }
    fn send(&mut self, bytes: &[u8]) -> io::Result<()> {
        for byte in bytes {
            if let Some(raw) = self.receiver.push(*byte)
                && let Ok(frame) = Frame::check(raw)
                && !self.answers.is_empty()
            {
                let answer = &self.answers[self.asked % self.answers.len()];
                let mut buffer = vec![0; MAX_FRAME];
                let length = encode(frame.sequence, &Raw(answer), &mut buffer).expect("fits");
                self.inbox.extend(&buffer[..length]);
                self.asked += 1;
            }
        }
        Ok(())
    }
    fn now(&self) -> Duration {
        Duration::ZERO
    }
    fn receive(&mut self, buffer: &mut [u8], _: Duration) -> io::Result<usize> {
        let count = buffer.len().min(self.inbox.len());
        for (slot, byte) in buffer.iter_mut().zip(self.inbox.drain(..count)) {
            *slot = byte;
        }
        Ok(count)
    }
    fn wait(&mut self, _: Duration) -> io::Result<()> {
        Ok(())
    }
}

fn use_everything(client: &mut Client) {
    let directory = tempfile::tempdir().expect("directory");
    let _ = client.info();
    let _ = client.records();
    let _ = client.settings();
    let _ = session::download(client, 1, directory.path(), |_| ());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn any_payloads_end_in_an_error_or_a_result(
        answers in prop::collection::vec(prop::collection::vec(any::<u8>(), 0..80), 0..6),
    ) {
        use_everything(&mut Liar::client(answers));
    }
}

/// Answers every request with bytes that are no frame, or never stops.
struct Noise {
    bytes: Vec<u8>,
    inbox: Vec<u8>,
    endless: bool,
    handed_out: usize,
}

impl Noise {
    fn client(bytes: Vec<u8>, endless: bool) -> Client {
        Client::new(Box::new(Self {
            bytes,
            inbox: Vec::new(),
            endless,
            handed_out: 0,
        }))
    }
}

impl Transport for Noise {
    fn name(&self) -> String {
        "noise".to_owned()
    }
    fn send(&mut self, _: &[u8]) -> io::Result<()> {
        self.inbox.clone_from(&self.bytes);
        Ok(())
    }
    fn now(&self) -> Duration {
        Duration::ZERO
    }
    fn receive(&mut self, buffer: &mut [u8], _: Duration) -> io::Result<usize> {
        if self.endless && self.inbox.len() < buffer.len() {
            self.inbox
                .extend(self.bytes.iter().cycle().take(buffer.len()));
        }
        let count = buffer.len().min(self.inbox.len());
        for (slot, byte) in buffer.iter_mut().zip(self.inbox.drain(..count)) {
            *slot = byte;
        }
        // Four attempts of four frames' length, for each of some ten requests.
        self.handed_out += count;
        assert!(self.handed_out < 1_000_000, "read without an end");
        Ok(count)
    }
    fn wait(&mut self, _: Duration) -> io::Result<()> {
        Ok(())
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn any_bytes_end_in_an_error(
        bytes in prop::collection::vec(any::<u8>(), 1..300),
        endless: bool,
    ) {
        let mut client = Noise::client(bytes, endless);
        prop_assert!(client.info().is_err());
        use_everything(&mut client);
    }
}

fn message(response: &Response) -> Vec<u8> {
    let mut buffer = vec![0; 4096];
    postcard::to_slice(response, &mut buffer)
        .expect("fits")
        .to_vec()
}

#[test]
fn a_record_that_never_ends_is_given_up() {
    for (total, data) in [(1000, &[][..]), (u32::MAX, &[1, 2, 3][..])] {
        let answer = message(&Response::RecordData {
            id: 1,
            offset: 0,
            total,
            data: data.try_into().expect("short"),
        });
        let directory = tempfile::tempdir().expect("directory");
        session::download(&mut Liar::client(vec![answer]), 1, directory.path(), |_| ())
            .expect_err("given up");
    }
}

#[test]
fn a_record_list_that_never_ends_is_given_up() {
    let answer = message(&Response::Records {
        records: heapless::Vec::new(),
        more: true,
    });
    assert!(
        Liar::client(vec![answer])
            .records()
            .expect("empty")
            .is_empty()
    );
    let device = Device::with_record(7, 0);
    let summary = client(&shared(device)).records().expect("list").remove(0);
    let answer = message(&Response::Records {
        records: [summary].into_iter().collect(),
        more: true,
    });
    let error = Liar::client(vec![answer])
        .records()
        .expect_err("the same again");
    assert_eq!(error.exit_code(), 4);
}

#[test]
fn a_refusal_of_everything_reaches_the_caller() {
    let mut device = Device::new();
    device.refusal = Some(Refusal::StorageFailed);
    let error = client(&shared(device)).records().expect_err("refused");
    assert_eq!(error.exit_code(), 5);
}
