//! `calib certificate RECORD`: the certificate of a downloaded or stored record.

use super::{Context, source, time};
use calib_host::bench::{Bench, Issue};
use calib_host::certificate::{self, Certificate, Format, Particulars};
use calib_host::{Error, Result};
use calib_protocol::record::{self, Record, Sha256Sum};
use clap::Args;
use serde::Serialize;
use std::path::PathBuf;

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
    /// Writes the files; none appears when one of them cannot be written. With a
    /// bench of records they are entered there, and none is written if another
    /// one of that number was issued.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let record = source::find(context, &self.record, &self.out)?;
        let mut bench = context.bench_if_there()?;
        if let Some(bench) = &bench {
            self.may_issue(bench, &record)?;
        }
        let files = certificate::write(&record, &self.format, &self.out)?;
        if let Some(bench) = &mut bench {
            self.enter(bench, &record, &files)?;
        }
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

    /// The files are made in a folder of their own, to know their sums.
    fn may_issue(&self, bench: &Bench, record: &Record) -> Result<()> {
        let folder = tempfile::tempdir()
            .map_err(|error| Error::file("create", &std::env::temp_dir(), error))?;
        let files = certificate::write(record, &self.format, folder.path())?;
        let contents = contents(&files)?;
        let number = number(record);
        for issue in self.issues(&number, record, &files, &contents) {
            bench.may_issue(&issue)?;
        }
        Ok(())
    }

    fn enter(&self, bench: &mut Bench, record: &Record, files: &[PathBuf]) -> Result<()> {
        let contents = contents(files)?;
        let number = number(record);
        let issues: Vec<_> = self.issues(&number, record, files, &contents).collect();
        let now = i64::try_from(time::unix_time_s()).unwrap_or(0);
        bench.issue(&issues, now)
    }

    /// Files are in the order of the formats.
    fn issues<'a>(
        &'a self,
        number: &'a str,
        record: &Record,
        files: &'a [PathBuf],
        contents: &'a [Vec<u8>],
    ) -> impl Iterator<Item = Issue<'a>> {
        let record = digest(record);
        let files = files.iter().zip(contents);
        let issue = move |(format, (file, content)): (&Format, (&'a PathBuf, &'a Vec<u8>))| Issue {
            certificate: number,
            format: format.name(),
            file: file.to_str().unwrap_or_default(),
            content,
            record,
        };
        self.format.iter().zip(files).map(issue)
    }
}

fn contents(files: &[PathBuf]) -> Result<Vec<Vec<u8>>> {
    let read =
        |file: &PathBuf| std::fs::read(file).map_err(|error| Error::file("read", file, error));
    files.iter().map(read).collect()
}

fn number(record: &Record) -> String {
    Certificate::from_record(record, &Particulars::default()).number
}

/// Sum of the record's stored form, which is the same however it came here.
fn digest(record: &Record) -> Sha256Sum {
    let mut buffer = vec![0; 64 * 1024];
    let length = record::encode(record, &mut buffer).unwrap_or(0);
    record::digest(&buffer[..length])
}
