//! Devices that lie and never end. What answers anything: `calib_tests::hostile::client`.

use crate::device::Device;
use crate::memory_link::{client, shared};
use calib_link::session;
use calib_link::{Client, Error, Transport};
use calib_protocol::frame::{Frame, MAX_FRAME, Receiver, encode};
use calib_protocol::message::{Refusal, Request, Response};
use calib_protocol::record::RecordSummary;
use std::collections::VecDeque;
use std::io::{self, Read};
use std::time::Duration;

/// Answers every request as it likes.
struct Liar {
    receiver: Receiver,
    answer: Box<dyn Fn(&Request) -> Response + Send>,
    inbox: VecDeque<u8>,
}

impl Liar {
    /// With the same.
    fn client(answer: Response) -> Client {
        Self::by(move |_| answer.clone())
    }

    fn by(answer: impl Fn(&Request) -> Response + Send + 'static) -> Client {
        Client::new(Box::new(Self {
            receiver: Receiver::new(),
            answer: Box::new(answer),
            inbox: VecDeque::new(),
        }))
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
                && let Ok(request) = frame.message::<Request>()
            {
                let mut buffer = vec![0; MAX_FRAME];
                let length =
                    encode(frame.sequence, &(self.answer)(&request), &mut buffer).expect("fits");
                self.inbox.extend(&buffer[..length]);
            }
        }
        Ok(())
    }
    fn now(&self) -> Duration {
        Duration::ZERO
    }
    fn receive(&mut self, buffer: &mut [u8], _: Duration) -> io::Result<usize> {
        self.inbox.read(buffer)
    }
    fn wait(&mut self, _: Duration) -> io::Result<()> {
        Ok(())
    }
}

#[test]
fn a_record_that_never_ends_is_given_up() {
    for (total, data) in [(1000, &[][..]), (u32::MAX, &[1, 2, 3][..])] {
        let answer = Response::RecordData {
            id: 1,
            offset: 0,
            total,
            data: data.try_into().expect("short"),
        };
        let directory = tempfile::tempdir().expect("directory");
        session::download(&mut Liar::client(answer), 1, directory.path(), |_| ())
            .expect_err("given up");
    }
}

#[test]
fn a_record_list_that_never_ends_is_given_up() {
    let answer = Response::Records {
        records: heapless::Vec::new(),
        more: true,
    };
    assert!(Liar::client(answer).records().expect("empty").is_empty());
    let device = Device::with_record(7, 0);
    let summary = client(&shared(device)).records().expect("list").remove(0);
    let answer = Response::Records {
        records: [summary].into_iter().collect(),
        more: true,
    };
    let error = Liar::client(answer).records().expect_err("the same again");
    assert_eq!(error.exit_code(), 4);
}

#[test]
fn a_list_that_rises_for_ever_ends() {
    let device = Device::with_record(7, 0);
    let summary = client(&shared(device)).records().expect("list").remove(0);
    let rising = move |request: &Request| {
        let Request::Records { from } = *request else {
            return Response::Done;
        };
        let record = |id| RecordSummary {
            id,
            ..summary.clone()
        };
        Response::Records {
            records: (from..).take(16).map(record).collect(),
            more: true,
        }
    };
    let failed = Liar::by(rising).records();
    assert!(matches!(failed, Err(Error::Protocol(_))), "{failed:?}");
}

#[test]
fn a_refusal_of_everything_reaches_the_caller() {
    let mut device = Device::new();
    device.refusal = Some(Refusal::StorageFailed);
    let error = client(&shared(device)).records().expect_err("refused");
    assert_eq!(error.exit_code(), 5);
}
