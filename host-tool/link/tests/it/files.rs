//! A device, or a file of the same name, against this computer's disk and time.

use crate::slow_link::{SlowLink, Way};
use calib_link::{Client, session};

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
