//! Downloads over links that break anywhere.

use crate::device::{Device, read_back};
use crate::memory_link::{Direction, Fault, MemoryLink, client, shared};
use calib_link::Client;
use calib_link::Error;
use calib_link::session;
use calib_protocol::message::Request;
use std::fs;

/// Between two and three chunks.
const LONG: u16 = 64;

fn device() -> Device {
    let device = Device::with_record(3, LONG);
    assert!((2049..3073).contains(&device.records[&3].len()));
    device
}

/// Just over one chunk: every byte of it is tried, and each try is on disk.
const SHORT: u16 = 28;

fn short_device() -> Device {
    let device = Device::with_record(3, SHORT);
    assert!((1025..1500).contains(&device.records[&3].len()));
    device
}

#[test]
fn a_record_arrives_as_it_was_stored() {
    let directory = tempfile::tempdir().expect("directory");
    let device = shared(device());
    let mut seen = Vec::new();
    let download = session::download(&mut client(&device), 3, directory.path(), |progress| {
        seen.push(progress.done)
    })
    .expect("download");
    assert_eq!(download.record, read_back(3, LONG));
    let stored = device.lock().expect("device").records[&3].clone();
    assert_eq!(fs::read(&download.path).expect("file"), stored);
    assert_eq!(seen, [1024, 2048, stored.len() as u32]);
    let names: Vec<_> = fs::read_dir(directory.path()).expect("list").collect();
    assert_eq!(names.len(), 1, "nothing but the record is left");
    // Once more: the same file is no obstacle.
    session::download(&mut client(&device), 3, directory.path(), |_| ()).expect("again");
}

/// The connection is cut at every byte of the answers, one after the other, and
/// the next connection goes on: nothing whole is fetched twice.
#[test]
fn a_download_cut_at_any_byte_is_resumed() {
    let total = short_device().records[&3].len();
    for position in 0..total + 60 {
        let directory = tempfile::tempdir().expect("directory");
        let device = shared(short_device());
        let link = MemoryLink::with_fault(&device, Direction::ToHost, position, Fault::Cut);
        let mut first = Client::new(Box::new(link));
        let broken = session::download(&mut first, 3, directory.path(), |_| ());
        let kept = match broken {
            Ok(_) => continue,
            Err(error) => {
                assert_eq!(error.exit_code(), 3, "{error}");
                position / (RECORD_CHUNK_ON_WIRE) * 1024
            }
        };
        device.lock().expect("device").requests.clear();
        let download = session::download(&mut client(&device), 3, directory.path(), |_| ());
        let download = download.expect("resumed");
        assert_eq!(download.record, read_back(3, SHORT), "cut at {position}");
        assert!(download.resumed_at >= kept.min(total), "cut at {position}");
        let first = device.lock().expect("device").requests[0].clone();
        let offset = download.resumed_at as u32;
        assert_eq!(first, Request::ReadRecord { id: 3, offset });
    }
}

/// Sequence, checksum, head of the message, COBS and terminator add less than
/// this to the 1024 bytes of a chunk.
const RECORD_CHUNK_ON_WIRE: usize = 1024 + 32;

/// Resumes at any byte, also in the middle of a chunk.
#[test]
fn a_part_of_any_length_is_completed() {
    let stored = short_device().records[&3].clone();
    for length in 0..=stored.len() {
        let directory = tempfile::tempdir().expect("directory");
        let part = directory.path().join("record-00003.calibrec.part");
        fs::write(&part, &stored[..length]).expect("part");
        let device = shared(short_device());
        let download = session::download(&mut client(&device), 3, directory.path(), |_| ());
        let download = download.expect("completed");
        assert_eq!(download.resumed_at, length);
        assert_eq!(fs::read(&download.path).expect("file"), stored);
        assert!(!part.exists());
    }
}

/// A part of another instrument's record number 3, shorter, as long, longer.
#[test]
fn a_part_of_another_record_is_dropped() {
    let stored = device().records[&3].clone();
    for length in [1, 700, stored.len(), stored.len() + 1, 9000] {
        let directory = tempfile::tempdir().expect("directory");
        let part = directory.path().join("record-00003.calibrec.part");
        fs::write(&part, vec![0x5A; length]).expect("part");
        let device = shared(device());
        let download = session::download(&mut client(&device), 3, directory.path(), |_| ());
        assert_eq!(
            download.expect("from the start").record,
            read_back(3, LONG),
            "{length}"
        );
    }
}

#[test]
fn a_record_damaged_in_flash_is_refused_and_leaves_nothing() {
    let directory = tempfile::tempdir().expect("directory");
    let device = shared(device());
    device
        .lock()
        .expect("device")
        .records
        .get_mut(&3)
        .expect("record")[500] ^= 1;
    let error =
        session::download(&mut client(&device), 3, directory.path(), |_| ()).expect_err("damaged");
    assert_eq!(error.exit_code(), 6);
    assert!(error.to_string().contains("checksum"), "{error}");
    assert_eq!(fs::read_dir(directory.path()).expect("list").count(), 0);
}

#[test]
fn an_existing_file_with_another_content_is_kept() {
    let directory = tempfile::tempdir().expect("directory");
    let path = directory.path().join("record-00003.calibrec");
    fs::write(&path, b"mine").expect("file");
    let device = shared(device());
    let error = session::download(&mut client(&device), 3, directory.path(), |_| ())
        .expect_err("not overwritten");
    assert!(
        matches!(error, Error::Files(calib_files::Error::Input { .. })),
        "{error}"
    );
    assert_eq!(fs::read(&path).expect("file"), b"mine");
}

#[test]
fn a_record_that_is_not_there_leaves_nothing() {
    let directory = tempfile::tempdir().expect("directory");
    let device = shared(device());
    let error =
        session::download(&mut client(&device), 9, directory.path(), |_| ()).expect_err("no 9");
    assert_eq!(error.exit_code(), 5);
    assert_eq!(fs::read_dir(directory.path()).expect("list").count(), 0);
}
