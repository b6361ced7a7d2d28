//! Records from a damaged flash, a broken link or a doubtful file.

use calib_protocol::{record, stored};

/// Checks that a record reads back as it says, and that its list line agrees.
pub fn records(data: &[u8]) {
    let decoded = record::decode(data);
    let inspected = record::inspect(data);
    if let Ok(record) = &decoded {
        let (summary, settings) = inspected.expect("what can be read can be listed");
        assert_eq!(summary.id, record.head.id);
        assert_eq!(usize::from(summary.points), record.points.len());
        assert_eq!(summary.dut_serial, record.head.labels.dut_serial);
        assert!(settings.end <= data.len());
    }
    if let Ok((head, body)) = stored::head(data) {
        let _ = head.summary(body);
        let mut room = vec![0; 1 << 17];
        let length = body.len().min(room.len());
        room[..length].copy_from_slice(&body[..length]);
        let _ = stored::open_up(&head, &mut room);
    }
}
