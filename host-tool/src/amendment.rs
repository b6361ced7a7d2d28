//! A certificate made anew because something stated on it was wrong (ISO/IEC 17025, 7.8.8): from the records of
//! the old one, under a number of its own, saying what it replaces and why.

use crate::{Error, Result};
use calib_certificate::{Amendment, Options, Particulars, Standard};
use calib_logbook::{Logbook, Role, Sources};
use calib_protocol::record::{self, Sha256Sum};

/// Certificate wanted in place of another.
#[derive(Clone, Debug)]
pub struct Amended {
    /// Statement of the new one about the old one.
    pub replaces: Amendment,
    /// Number of the new one, unless the laboratory states another.
    number: String,
    sources: Sources,
}

impl Amended {
    /// Looks up the certificate of this number.
    ///
    /// # Errors
    /// [`Error::Usage`] without a reason, [`Error::Input`] when it was never issued here or was replaced already.
    pub fn find(logbook: &Logbook, certificate: &str, reason: &str) -> Result<Self> {
        let reason = reason.trim();
        if reason.is_empty() {
            return Err(Error::usage(
                "an amendment states its reason",
                "--reason TEXT, or the field beside it on the page; the certificate prints it",
            ));
        }
        let number = logbook.number_of_amendment(certificate, reason)?;
        let sources = logbook.sources(certificate)?;
        let sources = sources.ok_or_else(|| missing(certificate, "what it is made of"))?;
        Ok(Self {
            replaces: Amendment {
                certificate: certificate.to_owned(),
                reason: reason.to_owned(),
            },
            number,
            sources,
        })
    }

    /// States number and amendment. A number of the laboratory's own wins, unless it is the old one's.
    pub fn state(&self, particulars: &mut Particulars) {
        let calibration = &mut particulars.calibration;
        let own = calibration.number.take();
        let own = own.filter(|number| *number != self.replaces.certificate);
        calibration.number = Some(own.unwrap_or_else(|| self.number.clone()));
        calibration.replaces = Some(self.replaces.clone());
    }

    /// The record of the old certificate, as it was downloaded.
    ///
    /// # Errors
    /// [`Error::Input`] when the logbook does not keep it.
    pub fn record(&self, logbook: &Logbook) -> Result<Vec<u8>> {
        self.bytes(logbook, &self.sources.record)
    }

    /// Adds the records that the old certificate was made of beside its own, unless some were named.
    ///
    /// # Errors
    /// As [`Self::record`].
    pub fn join(&self, options: &mut Options, logbook: &Logbook) -> Result<()> {
        let beside = [&options.remounted, &options.retried];
        let named = options.as_found.is_some() || options.standard.is_some();
        if named || beside.iter().any(|records| !records.is_empty()) {
            return Ok(());
        }
        for joined in &self.sources.joined {
            let bytes = self.bytes(logbook, &joined.record)?;
            let record = record::decode(&bytes).map_err(|error| {
                let hint = "put the last backup of the logbook in its place";
                Error::input("record of the logbook", error.to_string(), hint)
            })?;
            match joined.role {
                Role::AsFound => options.as_found = Some(record),
                Role::Remounted => options.remounted.push(record),
                Role::Retried => options.retried.push(record),
                // What its certificate says is stated anew, with everything else that no record knows.
                Role::Standard => {
                    options.standard = Some(Standard {
                        record,
                        certified: Vec::new(),
                    });
                }
            }
        }
        Ok(())
    }

    fn bytes(&self, logbook: &Logbook, sum: &Sha256Sum) -> Result<Vec<u8>> {
        let bytes = logbook.record_of_sum(sum)?;
        bytes.ok_or_else(|| missing(&self.replaces.certificate, "a record it is made of"))
    }
}

fn missing(certificate: &str, what: &str) -> Error {
    Error::input(
        format!("certificate {certificate}"),
        format!("{what} is not in the logbook"),
        "`calib logbook add FILE` keeps the record; or name its file before --amend",
    )
}
