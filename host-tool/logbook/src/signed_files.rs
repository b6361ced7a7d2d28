//! Signed files of certificates: their sums, and who signed.
//!
//! A certificate is entered by what it states; each signature of it makes a file of its own, with a sum of its own.

use super::Logbook;
use super::journal::{self, Subject};
use calib_files::Result;
use calib_signing::Certificate;
use rusqlite::{Connection, Row, params};
use schemars::JsonSchema;
use serde::Serialize;
use sha2::{Digest, Sha256};

/// A signed file that was given out.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct SignedFile {
    /// SHA-256 of the file, hexadecimal.
    pub sha256: String,
    /// Subject of the key's certificate.
    pub signed_by: String,
    /// SHA-256 of that certificate, hexadecimal.
    pub signer_certificate_sha256: String,
    /// When it was entered, s since 1970-01-01 UTC.
    #[serde(rename = "entered_unix_time_s")]
    pub entered_s: i64,
}

/// A signed file about to be entered.
#[derive(Clone, Copy, Debug)]
pub struct Signed<'a> {
    /// The file.
    pub content: &'a [u8],
    /// Certificate of the key.
    pub by: &'a Certificate,
}

const OF: &str = "SELECT lower(hex(sha256)), signed_by, lower(hex(signer_sha256)), entered_s
                  FROM signed_files WHERE certificate = ?1 AND format = ?2 ORDER BY entered_s, sha256";

impl SignedFile {
    fn from_row(row: &Row<'_>) -> rusqlite::Result<Self> {
        Ok(Self {
            sha256: row.get(0)?,
            signed_by: row.get(1)?,
            signer_certificate_sha256: row.get(2)?,
            entered_s: row.get(3)?,
        })
    }

    /// Entry for a file.
    pub(super) fn of(signed: &Signed<'_>, entered_s: i64) -> Self {
        Self {
            sha256: hex::encode(Sha256::digest(signed.content)),
            signed_by: signed.by.subject(),
            signer_certificate_sha256: hex::encode(signed.by.fingerprint()),
            entered_s,
        }
    }
}

/// Signed files of a certificate, the first first.
pub(super) fn of(
    connection: &Connection,
    certificate: &str,
    format: &str,
) -> rusqlite::Result<Vec<SignedFile>> {
    let mut statement = connection.prepare_cached(OF)?;
    let rows = statement.query_map([certificate, format], SignedFile::from_row)?;
    rows.collect()
}

/// Enters a file of a certificate, in the transaction of its caller; false when it is there already.
pub(super) fn enter(
    connection: &Connection,
    certificate: &str,
    format: &str,
    file: &SignedFile,
) -> rusqlite::Result<bool> {
    let enter = "INSERT INTO signed_files VALUES (unhex(?1), ?2, ?3, ?4, unhex(?5), ?6)
                 ON CONFLICT (sha256) DO NOTHING";
    let values = params![
        file.sha256,
        certificate,
        format,
        file.signed_by,
        file.signer_certificate_sha256,
        file.entered_s
    ];
    let is_new = connection.execute(enter, values)? == 1;
    if is_new {
        journal::enter(connection, Subject::SignedFile, &file.sha256)?;
    }
    Ok(is_new)
}

impl Logbook {
    /// Signed files of a certificate in this form, the first first.
    ///
    /// # Errors
    /// Those of the file.
    pub fn signed_files(&self, certificate: &str, format: &str) -> Result<Vec<SignedFile>> {
        of(&self.connection, certificate, format).map_err(|error| self.failure(error))
    }
}
