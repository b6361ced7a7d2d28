//! `calib run --remount N`: one device, mounted again for every record.

use super::hand::done_by_hand;
use super::measure::Kept;
use calib_certificate::{
    Certificate, ConformityStatement, Language, MountingScatter, Particulars, mounting_scatter,
};
use calib_core::point::PointResult;
use calib_host::{Error, Result};
use calib_link::session::Outcome;
use calib_metrology::text::Table;
use calib_protocol::record::Record;
use schemars::JsonSchema;
use serde::Serialize;

/// Records of one device, mounted again for each, and what they show.
#[derive(Serialize, JsonSchema)]
pub(super) struct Remounting {
    /// Running numbers of the records, in the order measured.
    record_ids: Vec<u32>,
    /// Every point that is valid in all of them.
    points: Vec<MountingScatter>,
}

/// Mountings measured so far.
#[derive(Default)]
pub(super) struct Mountings {
    record_ids: Vec<u32>,
    runs: Vec<Vec<PointResult>>,
    /// Those of the logbook.
    records: Vec<Record>,
}

impl Mountings {
    pub(super) fn add(&mut self, outcome: &Outcome, kept: Option<&Kept>) {
        self.record_ids.push(outcome.record_id);
        self.runs.push(outcome.points.clone());
        self.records.extend(kept.map(|kept| kept.record.clone()));
    }

    pub(super) fn count(&self) -> usize {
        self.runs.len()
    }

    /// Asks for the device to be mounted again.
    pub(super) fn wait_for_the_next(&self, record_id: u32) -> Result<()> {
        wait_for(&format!(
            "Record {record_id}. Take the device off and mount it again, as before"
        ))
    }

    /// None where it was mounted once.
    pub(super) fn remounting(&self) -> Option<Remounting> {
        let runs: Vec<&[PointResult]> = self.runs.iter().map(Vec::as_slice).collect();
        (runs.len() > 1).then(|| Remounting {
            record_ids: self.record_ids.clone(),
            points: mounting_scatter(&runs),
        })
    }

    /// Conformity of the device by all its mountings, if a tolerance was stated.
    pub(super) fn conformity_statement(
        &self,
        particulars: &Particulars,
    ) -> Option<ConformityStatement> {
        let (first, others) = self.records.split_first()?;
        let language = particulars.language.unwrap_or(Language::En);
        let certificate = Certificate::from_records(first, others, particulars).ok()?;
        certificate.conformity_statement(language)
    }
}

/// Asks for something to be done by hand; a line on standard input says that it is.
pub(super) fn wait_for(what: &str) -> Result<()> {
    let left = Error::usage(
        "nobody says that it is done: what was measured is kept",
        "measure the next with `calib run`; `calib certificate RECORD --remounted RECORD,...` names all mountings",
    );
    done_by_hand(&format!("{what}; then press Enter."), left)
}

/// The scatter as a table, and how a certificate is made of all.
pub(super) fn text(remounting: &Remounting) -> String {
    let mut table = Table::new(&[
        "f/Hz",
        "mV/(m/s2)",
        "scatter/%",
        "u of mean/%",
        "scatter/deg",
    ]);
    for point in &remounting.points {
        table.row([
            point.frequency_hz.to_string(),
            format!("{:.5}", 1000.0 * point.sensitivity_v_per_ms2),
            format!("{:.3}", 100.0 * point.scatter_rel),
            format!("{:.3}", 100.0 * point.standard_uncertainty_rel),
            format!("{:.3}", point.scatter_phase_deg),
        ]);
    }
    let ids: Vec<String> = remounting.record_ids.iter().map(u32::to_string).collect();
    let others = ids.get(1..).unwrap_or_default().join(",");
    format!(
        "\n{} mountings, {} degrees of freedom\n{table}calib certificate {} --remounted {others}",
        ids.len(),
        ids.len().saturating_sub(1),
        ids.first().map_or("", String::as_str),
    )
}
