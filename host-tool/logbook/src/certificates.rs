//! Certificates that were issued: numbered, with their sums, never changed.

use super::Logbook;
use super::amendments;
use super::issue::Issue;
use super::journal::{self, Subject};
use super::signed_files::{self, Signed, SignedFile};
use calib_files::{Error, Result};
use rusqlite::{OptionalExtension, Params, params};
use schemars::JsonSchema;
use serde::Serialize;
use sha2::{Digest, Sha256};

/// A certificate that was issued.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Issued {
    /// Running number in the logbook, from 1, without gaps.
    pub number: i64,
    /// Number printed on it.
    pub certificate: String,
    /// Its form: `pdf`, `csv`, ...
    pub format: String,
    /// Time of issue, s since 1970-01-01 UTC.
    #[serde(rename = "issued_unix_time_s")]
    pub issued_s: i64,
    /// File it was written to.
    pub file: String,
    /// SHA-256 of the file without a signature, hexadecimal.
    pub sha256: String,
    /// SHA-256 of the record it is made of, hexadecimal.
    pub record_sha256: String,
    /// Signed files of it, and by whom.
    pub signed: Vec<SignedFile>,
    /// Number of the certificate whose place it took.
    pub replaces: Option<String>,
    /// Number of the certificate that took its place: it is no longer valid.
    pub replaced_by: Option<String>,
    /// Why it was replaced.
    pub replaced_because: Option<String>,
}

impl Logbook {
    /// Says whether a certificate may be issued: not if one of the same number
    /// and form, with other content, was; not if it was replaced; and in place of
    /// another only if that is made of the same records and was not replaced yet.
    ///
    /// # Errors
    /// [`Error::Input`] when it may not.
    pub fn may_issue(&self, issue: &Issue<'_>) -> Result<()> {
        let issued = self.issued_sum(issue)?;
        self.may_replace(issue, issued.is_some())?;
        match issued {
            Some(sum) if sum[..] != Sha256::digest(issue.content)[..] => Err(Error::input(
                format!("certificate {}", issue.certificate),
                format!("was issued as {} with another content", issue.format),
                format!(
                    "`calib certificate --amend {} --reason TEXT` makes one that says what it replaces; \
                     or give this one a number of its own: `number` under [calibration]",
                    issue.certificate
                ),
            )),
            _ => Ok(()),
        }
    }

    /// Enters certificates that were issued at `issued_s`, all or none. One that
    /// is there already with the same content is no second one.
    ///
    /// # Errors
    /// As [`Self::may_issue`].
    pub fn issue(&mut self, issues: &[Issue<'_>], issued_s: i64) -> Result<()> {
        let failed = |error| self.failure(error);
        let transaction = self.writing().map_err(failed)?;
        for issue in issues {
            self.may_issue(issue)?;
        }
        for issue in issues {
            // A row that is ignored would use up a number; one that is not made does not.
            let enter = "INSERT INTO certificates
                (certificate, format, record_sha256, issued_s, file, sha256)
                SELECT ?1,?2,?3,?4,?5,?6 WHERE NOT EXISTS
                (SELECT 1 FROM certificates WHERE certificate = ?1 AND format = ?2)";
            let sum = Sha256::digest(issue.content);
            let values = params![
                issue.certificate,
                issue.format,
                &issue.record[..],
                issued_s,
                issue.file,
                &sum[..]
            ];
            if transaction.execute(enter, values).map_err(failed)? == 1 {
                let number = transaction.last_insert_rowid().to_string();
                journal::enter(&transaction, Subject::Certificate, &number).map_err(failed)?;
            }
            if let Some(signed) = &issue.signed {
                let file = SignedFile::of(signed, issued_s);
                signed_files::enter(&transaction, issue.certificate, issue.format, &file)
                    .map_err(failed)?;
            }
            amendments::enter(&transaction, issue).map_err(failed)?;
        }
        transaction.commit().map_err(failed)
    }

    /// Enters a file that was signed after `unsigned` was issued. Returns the certificate it is of; none when
    /// the logbook knows none with this content, and nothing is entered.
    ///
    /// # Errors
    /// Those of the file.
    pub fn enter_signed(
        &self,
        unsigned: &[u8],
        signed: &Signed<'_>,
        entered_s: i64,
    ) -> Result<Option<Issued>> {
        let Some(issued) = self.issued_as(unsigned)? else {
            return Ok(None);
        };
        let file = SignedFile::of(signed, entered_s);
        self.in_one_turn(|connection| {
            signed_files::enter(connection, &issued.certificate, &issued.format, &file)
        })?;
        self.issued_as(unsigned)
    }

    /// The certificate whose file this is, signed or as it was before.
    ///
    /// # Errors
    /// Those of the file.
    pub fn issued_as(&self, content: &[u8]) -> Result<Option<Issued>> {
        let sum = Sha256::digest(content).to_vec();
        let find = "SELECT number FROM certificates WHERE sha256 = ?1 UNION ALL
                    SELECT number FROM certificates JOIN signed_files USING (certificate, format)
                    WHERE signed_files.sha256 = ?1 LIMIT 1";
        let number = self.connection.query_row(find, [sum], |row| row.get(0));
        let number: Option<i64> = number.optional().map_err(|error| self.failure(error))?;
        let all = number.map(|number| self.certificates_where("number = ?1", [number]));
        Ok(all.transpose()?.and_then(|mut all| all.pop()))
    }

    fn issued_sum(&self, issue: &Issue<'_>) -> Result<Option<Vec<u8>>> {
        let find = "SELECT sha256 FROM certificates WHERE certificate = ?1 AND format = ?2";
        self.connection
            .query_row(find, [issue.certificate, issue.format], |row| row.get(0))
            .optional()
            .map_err(|error| self.failure(error))
    }

    /// All certificates, in the order they were issued.
    ///
    /// # Errors
    /// Those of the file.
    pub fn certificates(&self) -> Result<Vec<Issued>> {
        self.certificates_where("1", [])
    }

    /// Those of which this is true.
    pub(super) fn certificates_where(
        &self,
        what: &str,
        values: impl Params,
    ) -> Result<Vec<Issued>> {
        let sql = format!(
            "SELECT number, issued.certificate, format, issued_s, file, lower(hex(sha256)),
             lower(hex(record_sha256)), old.replaces, new.certificate, new.reason
             FROM certificates issued
             LEFT JOIN amendments old ON old.certificate = issued.certificate
             LEFT JOIN amendments new ON new.replaces = issued.certificate
             WHERE {what} ORDER BY number"
        );
        self.all(&sql, values, |row| {
            let (certificate, format): (String, String) = (row.get(1)?, row.get(2)?);
            Ok(Issued {
                number: row.get(0)?,
                signed: signed_files::of(&self.connection, &certificate, &format)?,
                certificate,
                format,
                issued_s: row.get(3)?,
                file: row.get(4)?,
                sha256: row.get(5)?,
                record_sha256: row.get(6)?,
                replaces: row.get(7)?,
                replaced_by: row.get(8)?,
                replaced_because: row.get(9)?,
            })
        })
    }
}
