//! `calib records`: what is stored in the calibrator.

use super::Context;
use calib_host::Result;
use calib_metrology::text::Table;
use calib_output::RecordView;
use calib_protocol::record::RecordKind;
use clap::Args;

/// `calib records`.
#[derive(Debug, Args)]
pub(crate) struct Records {}

impl Records {
    /// Lists the stored records.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let records = context.connect()?.records()?;
        if records.is_empty() {
            context.remark("no record stored; `calib run` measures one");
        }
        let views: Vec<RecordView> = records.iter().map(RecordView::from).collect();
        context.print(&views, || {
            let mut table = Table::new(&["id", "measured", "sensor", "points", "refused", "bytes"]);
            for record in &records {
                table.row([
                    record.id.to_string(),
                    super::time::date_and_minute(record.unix_time_s),
                    match record.kind {
                        RecordKind::Calibration => record.dut_serial.to_string(),
                        RecordKind::ReferenceChange => "(settings changed)".to_owned(),
                    },
                    record.points.to_string(),
                    record.refused.to_string(),
                    record.bytes.to_string(),
                ]);
            }
            table.to_string()
        })
    }
}
