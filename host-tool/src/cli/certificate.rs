//! `calib certificate RECORD`: the certificate of a downloaded or stored record.

use super::Context;
use calib_host::certificate::{self, Format};
use calib_host::{Error, Result, session};
use calib_protocol::record::Record;
use clap::Args;
use serde::Serialize;
use std::path::{Path, PathBuf};

/// `calib certificate RECORD`.
#[derive(Debug, Args)]
pub(crate) struct CertificateVerb {
    /// File of a downloaded record, or the running number of one that is still
    /// in the calibrator (it is downloaded first).
    record: String,
    /// Directory for the files.
    #[arg(long, short, default_value = ".", value_name = "DIR")]
    out: PathBuf,
    /// Formats, separated by commas.
    #[arg(
        long,
        value_delimiter = ',',
        value_name = "FORMAT",
        default_value = "csv,json,html"
    )]
    format: Vec<Format>,
}

#[derive(Serialize)]
struct Written {
    files: Vec<PathBuf>,
}

impl CertificateVerb {
    /// Writes the files; none appears when one of them cannot be written.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let record = self.find(context)?;
        let files = certificate::write(&record, &self.format, &self.out)?;
        let text = || {
            files
                .iter()
                .map(|file| format!("{}\n", file.display()))
                .collect()
        };
        context.print(
            &Written {
                files: files.clone(),
            },
            text,
        )
    }

    fn find(&self, context: &Context) -> Result<Record> {
        let path = Path::new(&self.record);
        match self.record.parse::<u32>() {
            Ok(id) if !path.exists() => {
                let mut client = context.connect()?;
                client.info()?;
                Ok(session::download(&mut client, id, &self.out, |_| ())?.record)
            }
            _ => read(path),
        }
    }
}

/// Reads a downloaded record.
fn read(path: &Path) -> Result<Record> {
    let bytes = std::fs::read(path).map_err(|error| Error::file("read", path, error))?;
    calib_protocol::record::decode(&bytes).map_err(|error| {
        Error::input(
            path.display().to_string(),
            error.to_string(),
            "download it again with `calib download ID`",
        )
    })
}
