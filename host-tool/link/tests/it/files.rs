//! What a device or a file of the same name can do to this computer's disk and time.

use crate::slow_link::{SlowLink, Way};
use calib_link::{Client, Error, Transport, session};
use calib_protocol::frame::{Frame, MAX_FRAME, Receiver, encode};
use calib_protocol::message::{Request, Response};
use calib_protocol::record::{RecordKind, RecordSummary};
use std::io;
use std::time::Duration;

fn silent() -> Client {
    Client::new(Box::new(SlowLink::new(Way::Silent)))
}

#[cfg(unix)]
#[test]
fn a_part_is_never_written_through_a_link() {
    let folder = tempfile::tempdir().expect("folder");
    let precious = folder.path().join("precious");
    std::fs::write(&precious, "mine").expect("written");
    let part = folder.path().join("record-00005.calibrec.part");
    std::os::unix::fs::symlink(&precious, &part).expect("a link");
    let refused = session::download(&mut silent(), 5, folder.path(), |_| ());
    let error = refused.expect_err("a link").to_string();
    assert!(error.contains("record-00005.calibrec.part"), "{error}");
    assert_eq!(std::fs::read(&precious).expect("read"), b"mine");
}

#[test]
fn one_download_at_a_time_has_a_part() {
    let folder = tempfile::tempdir().expect("folder");
    let part = folder.path().join("record-00005.calibrec.part");
    let held = std::fs::File::create(&part).expect("created");
    held.try_lock().expect("free");
    let refused = session::download(&mut silent(), 5, folder.path(), |_| ());
    let error = refused.expect_err("in use").to_string();
    assert!(error.contains("another program"), "{error}");
}

/// Lists records in rising numbers for ever.
struct Endless {
    receiver: Receiver,
    inbox: Vec<u8>,
}

impl Transport for Endless {
    fn name(&self) -> String {
        "endless".to_owned()
    }

    fn send(&mut self, bytes: &[u8]) -> io::Result<()> {
        for byte in bytes {
            let Some(raw) = self.receiver.push(*byte) else {
                continue;
            };
            let Ok(frame) = Frame::check(raw) else {
                continue;
            };
            let Ok(Request::Records { from }) = frame.message() else {
                continue;
            };
            let records = (from..).take(16).map(|id| RecordSummary {
                id,
                bytes: 1,
                unix_time_s: 0,
                dut_serial: heapless::String::new(),
                points: 0,
                refused: 0,
                sha256: [0; 32],
                kind: RecordKind::Calibration,
            });
            let list = Response::Records {
                records: records.collect(),
                more: true,
            };
            let mut buffer = vec![0; MAX_FRAME];
            let length = encode(frame.sequence, &list, &mut buffer).expect("fits");
            self.inbox = buffer[..length].to_vec();
        }
        Ok(())
    }

    fn receive(&mut self, buffer: &mut [u8], _: Duration) -> io::Result<usize> {
        let count = buffer.len().min(self.inbox.len());
        for (place, byte) in buffer.iter_mut().zip(self.inbox.drain(..count)) {
            *place = byte;
        }
        Ok(count)
    }

    fn now(&self) -> Duration {
        Duration::ZERO
    }
}

#[test]
fn a_list_that_rises_for_ever_ends() {
    let endless = Endless {
        receiver: Receiver::new(),
        inbox: Vec::new(),
    };
    let failed = Client::new(Box::new(endless)).records();
    assert!(matches!(failed, Err(Error::Protocol(_))), "{failed:?}");
}
