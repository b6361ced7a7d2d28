//! The truth of a sealed set, and the manifest that is published without it.
//!
//! ```text
//! OUT/challenge.json        names of the cases, names to leave out, SHA-256 of the truth
//! OUT/case-0001/            a dataset: rig.toml and points.csv
//! OUT-truth.json            what caused what: opened after the answers are in
//! ```

use calib_files::{Error, Result};
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};
use std::path::{Path, PathBuf};

/// Name of the manifest in the folder of a set.
pub const MANIFEST: &str = "challenge.json";

/// Facts of a case before the truth is opened.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct OpenCase {
    /// Name of its folder.
    pub name: String,
    /// Effects the diagnosis has to do without. In some cases they caused the gap, in some not.
    pub without: Vec<String>,
}

/// Published part of a sealed set.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Manifest {
    /// SHA-256 of the file with the truth, hexadecimal.
    pub truth_sha256: String,
    /// Cases in the order of their names.
    pub cases: Vec<OpenCase>,
}

/// The truth about one case.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct TrueCase {
    /// Name of its folder.
    pub name: String,
    /// Kind of case, as `strata` names it.
    pub stratum: String,
    /// Names of the effects, sorted; empty if there is no gap.
    pub names: Vec<String>,
    /// The effects with the values they had.
    pub effects: Vec<String>,
    /// Stage of each effect, in the order of `effects`.
    pub stages: Vec<String>,
    /// Effects the diagnosis has to do without.
    pub without: Vec<String>,
    /// Change by the effects beyond what nominal values, mounting and the measurand can do, in
    /// standard uncertainties of the whole dataset.
    pub size_sigma: f64,
    /// The smallest of the sizes that its effects have alone.
    pub least_sigma: f64,
    /// SHA-256 of rig.toml and points.csv, hexadecimal: the set was not changed since.
    pub dataset_sha256: String,
}

/// The truth about a sealed set.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Truth {
    /// Seed the whole set follows from.
    pub seed: u64,
    /// Cases in the order of their names.
    pub cases: Vec<TrueCase>,
}

impl TrueCase {
    /// Whether the diagnosis has to do without an effect of the case.
    pub fn is_withheld(&self) -> bool {
        self.names.iter().any(|name| self.without.contains(name))
    }
}

impl Manifest {
    /// The manifest of `folder`, if that is a sealed set.
    ///
    /// # Errors
    /// [`Error::File`], and [`Error::Input`] for a damaged manifest.
    pub fn find(folder: &Path) -> Result<Option<Self>> {
        let path = folder.join(MANIFEST);
        if !path.is_file() {
            return Ok(None);
        }
        read_json(&path).map(Some)
    }
}

impl Truth {
    /// Opens the truth if its SHA-256 is the published one.
    ///
    /// # Errors
    /// [`Error::Input`] when it is another file than the one that was sealed.
    pub fn open(path: &Path, published_sha256: &str) -> Result<Self> {
        let bytes = std::fs::read(path).map_err(|e| Error::file("read", path, e))?;
        let found = sha256(&bytes);
        if !found.eq_ignore_ascii_case(published_sha256.trim()) {
            return Err(Error::input(
                path.display().to_string(),
                format!("has SHA-256 {found}, but {published_sha256} was published"),
                "this is not the truth the set was sealed with: find the file that is",
            ));
        }
        parse(&bytes, path)
    }

    /// Where the truth of the set in `folder` is written: beside it, not in it.
    pub fn beside(folder: &Path) -> PathBuf {
        let name = folder.file_name().unwrap_or_default().to_string_lossy();
        folder.with_file_name(format!("{name}-truth.json"))
    }

    /// The folder of the set that a truth is beside, by its name.
    pub fn set_of(truth: &Path) -> Option<PathBuf> {
        let stem = truth.file_stem()?.to_string_lossy().into_owned();
        Some(truth.with_file_name(stem.strip_suffix("-truth")?))
    }
}

/// SHA-256 in hexadecimal.
pub fn sha256(bytes: &[u8]) -> String {
    hex::encode(Sha256::digest(bytes))
}

/// Reads a JSON document.
///
/// # Errors
/// [`Error::File`], and [`Error::Input`] with line and column.
pub(super) fn read_json<T: serde::de::DeserializeOwned>(path: &Path) -> Result<T> {
    let bytes = std::fs::read(path).map_err(|e| Error::file("read", path, e))?;
    parse(&bytes, path)
}

fn parse<T: serde::de::DeserializeOwned>(bytes: &[u8], path: &Path) -> Result<T> {
    serde_json::from_slice(bytes).map_err(|error| {
        let place = format!("{}:{}", path.display(), error.line());
        Error::input(place, error.to_string(), "take the file as it was written")
    })
}
