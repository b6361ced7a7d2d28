//! A record as named on the command line: a file, or one in the calibrator.

use super::Context;
use calib_host::{Error, Result, session};
use calib_protocol::record::{self, RECORD_VERSION, Record, RecordError};
use std::path::Path;

/// The record of this file or, when the name is a number and no file, the one of
/// this running number in the calibrator, which is downloaded into `out` first.
pub(super) fn find(context: &Context, name: &str, out: &Path) -> Result<Record> {
    let path = Path::new(name);
    match name.parse::<u32>() {
        Ok(id) if !path.exists() => {
            let mut client = context.connect()?;
            client.info()?;
            Ok(session::download(&mut client, id, out, |_| ())?.record)
        }
        _ => read(path),
    }
}

/// Reads a downloaded record.
pub(super) fn read(path: &Path) -> Result<Record> {
    let bytes = std::fs::read(path).map_err(|error| Error::file("read", path, error))?;
    record::decode(&bytes).map_err(|error| {
        let hint = match error {
            RecordError::Version { found } if found > RECORD_VERSION => {
                "install a newer calib: this one is older than the record"
            }
            _ => "download it again with `calib download ID`",
        };
        Error::input(path.display().to_string(), error.to_string(), hint)
    })
}
