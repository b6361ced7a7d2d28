//! A certificate about to be entered, and what it is made of.

use super::signed_files::Signed;
use calib_certificate::Amendment;
use calib_protocol::record::Sha256Sum;

/// A certificate about to be entered.
#[derive(Clone, Copy, Debug)]
pub struct Issue<'a> {
    /// Number printed on it.
    pub certificate: &'a str,
    /// Its form.
    pub format: &'a str,
    /// File it was written to.
    pub file: &'a str,
    /// Content of the file, without a signature: what is issued under a number.
    pub content: &'a [u8],
    /// The file that is given out, where it is signed.
    pub signed: Option<Signed<'a>>,
    /// Sum of the record it is made of.
    pub record: Sha256Sum,
    /// Records it is made of beside that one.
    pub joined: &'a [Joined],
    /// The certificate whose place it takes, and why.
    pub replaces: Option<&'a Amendment>,
}

/// Role of a record in a certificate that is made of several.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Role {
    /// From before an adjustment.
    AsFound,
    /// Of the same device mounted again.
    Remounted,
    /// That measured again what had no result.
    Retried,
    /// Of the standard whose place the device took.
    Standard,
}

/// A record that a certificate is made of beside its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Joined {
    /// Its role in the certificate.
    pub role: Role,
    /// Its sum.
    pub record: Sha256Sum,
}

/// Everything a certificate is made of.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sources {
    /// Its record.
    pub record: Sha256Sum,
    /// Those beside it, sorted.
    pub joined: Vec<Joined>,
}

impl Role {
    pub(super) fn word(self) -> &'static str {
        match self {
            Self::AsFound => "as_found",
            Self::Remounted => "remounted",
            Self::Retried => "retried",
            Self::Standard => "standard",
        }
    }

    pub(super) fn of(word: &str) -> Self {
        match word {
            "as_found" => Self::AsFound,
            "retried" => Self::Retried,
            "standard" => Self::Standard,
            _ => Self::Remounted,
        }
    }
}
