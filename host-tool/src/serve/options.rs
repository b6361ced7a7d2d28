//! How the page is served.

use calib_signing::LaboratoryKey;
use std::net::SocketAddr;
use std::path::PathBuf;
use std::sync::Arc;

/// How the page is served.
#[derive(Clone, Debug)]
pub struct Options {
    /// Where to listen; a token is asked for unless this is loopback.
    pub listen: SocketAddr,
    /// The calibrator to connect to at once.
    pub device: Option<String>,
    /// The logbook; the first run makes it.
    pub logbook: PathBuf,
    /// Statements of laboratory and job for certificates, as TOML files.
    pub particulars: Vec<PathBuf>,
    /// The laboratory's key: certificates that are given out, and the logbook's journal, are signed.
    pub key: Option<Arc<LaboratoryKey>>,
}
