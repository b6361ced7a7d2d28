//! Input of a diagnosis: the folder of `rig.toml` and one table.
//!
//! ```text
//! DATASET/
//!   rig.toml     what the simulation believes, each value with its standard uncertainty
//!   points.csv   steady-state sine points   (kind = "calibrator")
//!   record.csv   input and output over time (kind = "oscillator")
//! ```
//!
//! ```text
//! rig               content of rig.toml, and its reader; exciter: its parameters
//! points            reads points.csv: layout of its columns and their range, cells of a row
//! point             one row, and what is measured: points or a record
//! record            reads record.csv
//! contradiction     whether rig and table can belong together
//! ```

mod cells;
mod contradiction;
mod exciter;
mod layout;
mod point;
mod points;
mod record;
mod rig;

pub(crate) use exciter::{ExciterParameter, ExciterParameters, Quantity};
pub(crate) use point::{Harmonic, Measured, Point};
pub(crate) use record::Record;
pub(crate) use rig::{Kind, Measurand, Repeatability, Rig, Transducer};

use crate::error::GapError;
use sha2::{Digest, Sha256};
use std::path::Path;

/// One dataset: rig and measurement, and nothing about the cause of a difference.
#[derive(Debug, Clone)]
pub(crate) struct Dataset {
    /// Beliefs of the simulation.
    pub(crate) rig: Rig,
    /// Measured values.
    pub(crate) measured: Measured,
    /// SHA-256 over `rig.toml` and the table, in hexadecimal.
    pub(crate) sha256: String,
}

impl Dataset {
    /// Reads and checks a dataset folder.
    ///
    /// # Errors
    /// [`GapError`] names file, line and column of the first unusable value.
    pub(crate) fn read(folder: &Path) -> Result<Self, GapError> {
        if !folder.is_dir() {
            let problem =
                "is not a dataset folder (it must hold rig.toml and points.csv or record.csv)"
                    .into();
            return Err(GapError::Rig {
                path: folder.into(),
                problem,
            });
        }
        let rig_path = folder.join("rig.toml");
        let rig_text = std::fs::read_to_string(&rig_path).map_err(|e| without_rig(&rig_path, e))?;
        let rig = rig::parse(&rig_text, &rig_path)?;
        let mut hash = Sha256::new();
        hash.update(rig_text.as_bytes());
        let table = folder.join(match rig.kind {
            Kind::Calibrator => "points.csv",
            Kind::Oscillator => "record.csv",
        });
        let both = ["points.csv", "record.csv"].map(|name| folder.join(name).exists());
        if both == [true, true] {
            return Err(GapError::Rig {
                path: folder.into(),
                problem:
                    "holds points.csv and record.csv; a dataset has one table: move the other away"
                        .into(),
            });
        }
        let file = std::fs::File::open(&table).map_err(|e| without_table(&table, rig.kind, e))?;
        let input = UnixLines(HashingReader {
            inner: std::io::BufReader::new(file),
            hash: &mut hash,
        });
        let measured = match rig.kind {
            Kind::Calibrator => points::read(input)?,
            Kind::Oscillator => Measured::Record(record::read(input)?),
        };
        contradiction::check(&rig, &measured)?;
        let sha256 = hex::encode(hash.finalize());
        Ok(Self {
            rig,
            measured,
            sha256,
        })
    }
}

fn without_rig(path: &Path, source: std::io::Error) -> GapError {
    if source.kind() != std::io::ErrorKind::NotFound {
        return GapError::file(path, source);
    }
    GapError::Rig {
        path: path.into(),
        problem: "is not there; `calib gap simulate standard --out NEW` (of a record `oscillator`) writes one to copy"
            .into(),
    }
}

/// The table the rig speaks of is not there; perhaps the other one is.
fn without_table(table: &Path, kind: Kind, source: std::io::Error) -> GapError {
    let (kind, other) = match kind {
        Kind::Calibrator => ("calibrator", "record.csv"),
        Kind::Oscillator => ("oscillator", "points.csv"),
    };
    if table.with_file_name(other).exists() {
        return GapError::Rig {
            path: table.with_file_name("rig.toml"),
            problem: format!(
                "kind = \"{kind}\" contradicts the table {other} beside it; correct the kind"
            ),
        };
    }
    GapError::file(table, source)
}

/// Takes carriage returns away: a parser that meets them counts lines differently.
struct UnixLines<R>(R);

impl<R: std::io::Read> std::io::Read for UnixLines<R> {
    fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
        loop {
            let count = self.0.read(buffer)?;
            let mut kept = 0;
            for at in 0..count {
                if buffer[at] != b'\r' {
                    buffer[kept] = buffer[at];
                    kept += 1;
                }
            }
            if kept > 0 || count == 0 {
                return Ok(kept);
            }
        }
    }
}

/// Hashes a file while it is parsed, so that it is read once and never held whole.
struct HashingReader<'a, R> {
    inner: R,
    hash: &'a mut Sha256,
}

impl<R: std::io::Read> std::io::Read for HashingReader<'_, R> {
    fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
        let count = self.inner.read(buffer)?;
        self.hash.update(&buffer[..count]);
        Ok(count)
    }
}
