//! Questions to the instrument about itself: name, key, health, records.

use super::Answering;
use super::errors::ScpiError;
use crate::command::{self, Instrument, RecordPage};
use calib_protocol::message::{Request, Response};
use core::fmt::Write;

pub(super) fn identify(instrument: &mut impl Instrument, out: &mut impl Write) {
    let info = instrument.info();
    let _ = write!(
        out,
        "calib,Field Vibration Calibrator,{},{}",
        info.serial, info.firmware_version
    );
}

/// The public key: its first 64 bits as people compare them, the whole, and the number of the first record
/// it signed; empty and 0 where there is none.
pub(super) async fn key(
    instrument: &mut impl Instrument,
    out: &mut impl Write,
) -> Result<(), ScpiError> {
    let Response::Key(key) = command::answer(Request::Key, instrument).await else {
        let _ = out.write_str("\"\",\"\",0");
        return Err(ScpiError::StorageFault);
    };
    let public = key.map(|key| key.public);
    let _ = out.write_str("\"");
    for (index, byte) in public.iter().flatten().take(8).enumerate() {
        let separator = if index > 0 && index % 2 == 0 { " " } else { "" };
        let _ = write!(out, "{separator}{byte:02x}");
    }
    let _ = out.write_str("\",\"");
    for byte in public.iter().flatten() {
        let _ = write!(out, "{byte:02x}");
    }
    let _ = write!(out, "\",{}", key.map_or(0, |key| key.since));
    Ok(())
}

/// 0, or the number of the first line that failed, from 1; -1 where the test was not carried out.
pub(super) async fn self_test(
    instrument: &mut impl Instrument,
    out: &mut impl Write,
) -> Result<(), ScpiError> {
    // The same road a frame takes, with the same rule who may test.
    let response = command::answer(Request::SelfTest, instrument).await;
    let refused = match response {
        Response::SelfTest { lines } => {
            let failed = lines.iter().find(|line| !line.passed());
            let number = failed.map_or(0, |line| line.check as u8 + 1);
            let _ = write!(out, "{number}");
            return Ok(());
        }
        Response::Refused(refusal) => refusal.into(),
        _ => ScpiError::InitIgnored,
    };
    let _ = out.write_str("-1");
    Err(refused)
}

/// Names of what does not work, as strings; an empty one when all is well.
pub(super) fn defects(instrument: &mut impl Instrument, out: &mut impl Write) {
    let defects = instrument.health().defects;
    let _ = out.write_str("\"");
    for (index, defect) in defects.iter().enumerate() {
        let separator = if index == 0 { "" } else { "," };
        let _ = write!(out, "{separator}{defect:?}");
    }
    let _ = out.write_str("\"");
}

/// Bytes used, bytes free (not known: 0), and every record. What does not fit is left out, and
/// an error says so.
pub(super) async fn catalog(
    instrument: &mut impl Instrument,
    out: &mut impl Write,
) -> Result<(), ScpiError> {
    let (mut used, mut from) = (0_u32, 0);
    let mut page = page_of(instrument, from).await?;
    // Twice through the list: its sum comes before its lines.
    loop {
        let bytes = page.records.iter().map(|record| record.bytes);
        used = bytes.fold(used, u32::saturating_add);
        match (page.more, page.records.last()) {
            (true, Some(last)) => from = last.id.saturating_add(1),
            _ => break,
        }
        page = page_of(instrument, from).await?;
    }
    let _ = write!(out, "{used},0");
    from = 0;
    loop {
        page = page_of(instrument, from).await?;
        for record in &page.records {
            let mut entry = heapless::String::<48>::new();
            let _ = write!(entry, ",\"{},BIN,{}\"", record.id, record.bytes);
            out.write_str(&entry).map_err(|_| ScpiError::TooMuchData)?;
        }
        match (page.more, page.records.last()) {
            (true, Some(last)) => from = last.id.saturating_add(1),
            _ => return Ok(()),
        }
    }
}

/// Most digits of a block's length.
const BLOCK_HEADER: usize = 2 + 4;

/// Bytes of a record from an offset on, as a block of definite length: as many as there is room for. What is left is
/// asked for with the next offset.
pub(super) async fn data(
    parameter: &str,
    instrument: &mut impl Instrument,
    out: &mut impl Answering,
) -> Result<(), ScpiError> {
    let (id, offset) = parameter.split_once(',').unwrap_or((parameter, "0"));
    let whole = |text: &str| match text.trim() {
        "" => Err(ScpiError::MissingParameter),
        text => text.parse::<u32>().map_err(|_| ScpiError::DataType),
    };
    let (id, mut offset) = match (whole(id), whole(offset)) {
        (Ok(id), Ok(offset)) => (id, offset),
        (Err(error), _) | (_, Err(error)) => return nothing(out, error),
    };
    let Ok(part) = instrument.read_record(id, offset).await else {
        return nothing(out, ScpiError::IllegalRecord);
    };
    let left = part.total.saturating_sub(offset) as usize;
    let length = left.min(out.room().saturating_sub(BLOCK_HEADER)).min(9_999);
    let _ = write!(out, "#4{length:04}");
    let mut part = part.data;
    let mut missing = length;
    while missing > 0 {
        let piece = part.get(..missing.min(part.len())).unwrap_or_default();
        let written = out.write_bytes(piece);
        written.map_err(|_| ScpiError::TooMuchData)?;
        (missing, offset) = (missing - piece.len(), offset + piece.len() as u32);
        if missing > 0 {
            let next = instrument.read_record(id, offset).await;
            part = next.map_err(|_| ScpiError::StorageFault)?.data;
        }
        if part.is_empty() {
            return Err(ScpiError::StorageFault);
        }
    }
    Ok(())
}

/// An empty block for who waits for one, and why it is empty.
fn nothing(out: &mut impl Write, error: ScpiError) -> Result<(), ScpiError> {
    let _ = out.write_str("#10");
    Err(error)
}

async fn page_of(instrument: &mut impl Instrument, from: u32) -> Result<RecordPage, ScpiError> {
    let page = instrument.records(from).await;
    page.map_err(|_| ScpiError::StorageFault)
}
