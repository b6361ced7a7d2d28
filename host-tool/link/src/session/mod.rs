//! Session with a calibrator over its link: run, follow, download.

mod broadband;
mod download;
mod labels;
mod points;
mod run;
pub mod update;

pub use broadband::on_lines;
pub use download::{
    Download, Fetched, Progress as DownloadProgress, download, download_with, evidence, fetch,
    stated_key, take,
};
pub use labels::{label, temperature_centi_c};
pub use points::{default_points, read_points};
pub use run::{Outcome, Progress, begin, follow, follow_beside, run, run_excited, time_left};
