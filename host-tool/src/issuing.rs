//! Certificates given out: entered in the logbook with who signed them, whose journal the same key signs. The
//! verbs and the page ask here.

use crate::{Error, Result};
use calib_certificate::{Amendment, File, Options, Particulars, Prepared, Seal};
use calib_logbook::{Issue, Joined, Logbook, Role, Signed, SignedFile};
use calib_protocol::record::{Record, Sha256Sum, digest};
use calib_signing::{Kind, LaboratoryKey, verify};
use jiff::tz::TimeZone;
use jiff::{SignedDuration, Timestamp};
use std::path::{Path, PathBuf};

/// Data the logbook enters with every file of a certificate.
#[derive(Debug)]
pub struct Entries {
    record: Sha256Sum,
    joined: Vec<Joined>,
    replaces: Option<Amendment>,
}

impl Entries {
    /// Of the certificate of a record.
    pub fn of(record: &Record, options: &Options) -> Self {
        let joined = |role| {
            move |record: &Record| Joined {
                role,
                record: calib_certificate::digest(record),
            }
        };
        let found = options.as_found.iter().map(joined(Role::AsFound));
        let remounted = options.remounted.iter().map(joined(Role::Remounted));
        let retried = options.retried.iter().map(joined(Role::Retried));
        let standard = options.standard.iter().map(|standard| &standard.record);
        let standard = standard.map(joined(Role::Standard));
        let all = found.chain(remounted).chain(retried).chain(standard);
        Self {
            record: calib_certificate::digest(record),
            joined: all.collect(),
            replaces: options.particulars.calibration.replaces.clone(),
        }
    }

    /// One entry a file; `paths` are where they will be, `key` is what they are signed with.
    pub fn issues<'a>(
        &'a self,
        prepared: &'a Prepared,
        paths: &'a [PathBuf],
        key: Option<&'a LaboratoryKey>,
    ) -> Vec<Issue<'a>> {
        let signed = |file: &'a File| {
            let by = key.filter(|_| file.unsigned.is_some())?.certificate();
            let content = &file.content[..];
            Some(Signed { content, by })
        };
        let issue = |(file, path): (&'a File, &'a PathBuf)| Issue {
            certificate: &prepared.number,
            format: file.format.name(),
            file: path.to_str().unwrap_or_default(),
            content: file.unsigned.as_ref().unwrap_or(&file.content),
            signed: signed(file),
            record: self.record,
            joined: &self.joined,
            replaces: self.replaces.as_ref(),
        };
        prepared.files.iter().zip(paths).map(issue).collect()
    }
}

/// A day begins this long before it does in UTC, where it begins first.
const FIRST_ZONE: SignedDuration = SignedDuration::from_hours(14);

/// Refuses a date of issue that has come nowhere yet.
///
/// # Errors
/// [`Error::Input`] with that date and this computer's.
pub fn has_come(particulars: &Particulars, now: Timestamp) -> Result<()> {
    let today = |at: Timestamp| at.to_zoned(TimeZone::UTC).date();
    let latest = today(now.saturating_add(FIRST_ZONE).unwrap_or(now));
    match particulars.calibration.issued {
        Some(issued) if issued > latest => Err(Error::input(
            "certificate",
            format!(
                "would be issued on {issued}, which is still to come: this computer has {}",
                today(now)
            ),
            "correct `issued` under [calibration], or the computer's clock",
        )),
        _ => Ok(()),
    }
}

/// Has every signed file as it was given out before, if it was: a program that was killed between the logbook and
/// the last of its files is completed by the same request, and the same certificate twice is one file.
///
/// # Errors
/// Those of the logbook, and of a key that makes no signature.
pub fn resume(
    prepared: &mut Prepared,
    paths: &[PathBuf],
    seal: Option<&Seal>,
    logbook: Option<&Logbook>,
) -> Result<()> {
    let Some(seal) = seal else {
        return Ok(());
    };
    for (file, path) in prepared.files.iter_mut().zip(paths) {
        if file.unsigned.is_none() {
            continue;
        }
        let entered = logbook.map(|one| one.signed_files(&prepared.number, file.format.name()));
        let entered = entered.transpose()?.unwrap_or_default();
        let sign = |at| Ok(file.sealed(&at_time(seal, at))?);
        if let Some(before) = as_before(&entered, path, &seal.key, sign)? {
            file.content = before;
        }
    }
    Ok(())
}

fn at_time(seal: &Seal, at: Timestamp) -> Seal {
    let key = seal.key.clone();
    Seal { key, at }
}

/// Signature by `sign` at the time of one by this key that was `entered`, or is at `path`, where that is
/// the same to the byte.
///
/// # Errors
/// Those of `sign`.
pub fn as_before(
    entered: &[SignedFile],
    path: &Path,
    key: &LaboratoryKey,
    sign: impl Fn(Timestamp) -> Result<Vec<u8>>,
) -> Result<Option<Vec<u8>>> {
    let own = hex::encode(key.certificate().fingerprint());
    let ours = entered.iter();
    let ours = ours.filter(|file| file.signer_certificate_sha256 == own);
    let there = std::fs::read(path).ok();
    let stated = there.as_deref().and_then(|file| {
        let signature = verify(Kind::of(file)?, file).ok()?;
        // A DCC states none, and is the same at any.
        Some(signature.at.unwrap_or_default())
    });
    let times = ours.filter_map(|file| Timestamp::from_second(file.entered_s).ok());
    for at in times.chain(stated) {
        let made = sign(at)?;
        let sum = hex::encode(digest(&made));
        let is_entered = entered.iter().any(|file| file.sha256 == sum);
        if is_entered || there.as_ref() == Some(&made) {
            return Ok(Some(made));
        }
    }
    Ok(None)
}

/// How the journal stands after something was given out.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Journal {
    /// Every entry is signed.
    Signed,
    /// So many entries wait for a signature.
    Waits(i64),
    /// There was a key, and it could not sign; why, with the way out.
    Refused(String),
}

/// Signs the journal where there is a key, so that nothing waits unsigned. A journal that cannot be signed
/// takes back nothing that was given out.
///
/// # Errors
/// Those of the logbook's file.
pub fn sign_journal(logbook: &Logbook, seal: Option<&Seal>) -> Result<Journal> {
    let Some(seal) = seal else {
        let (all, signed) = logbook.signed_entries()?;
        return Ok(match all - signed {
            0 => Journal::Signed,
            waiting => Journal::Waits(waiting),
        });
    };
    Ok(match logbook.seal(&seal.key, seal.at, "") {
        Ok(_) => Journal::Signed,
        Err(error) => Journal::Refused(crate::Error::from(error).with_hint()),
    })
}

impl Journal {
    /// Remark about it; none about one that is signed.
    pub fn remark(&self) -> Option<String> {
        match self {
            Self::Signed => None,
            Self::Waits(1) => Some(
                "1 entry of the logbook is not signed: `calib logbook sign`, or give certificates out with --sign"
                    .to_owned(),
            ),
            Self::Waits(count) => Some(format!(
                "{count} entries of the logbook are not signed: `calib logbook sign`, or give certificates out \
                 with --sign"
            )),
            Self::Refused(why) => Some(format!(
                "given out and entered, but the logbook was not signed: {why}"
            )),
        }
    }
}
