//! `calib devices`: serial ports, the likely calibrators first.

use super::Context;
use calib_host::Result;
use calib_link::port;
use calib_metrology::text::Table;
use clap::Args;

/// `calib devices`.
#[derive(Debug, Args)]
pub(crate) struct Devices {}

impl Devices {
    /// Lists the ports.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let ports = port::list();
        if ports.is_empty() {
            context.remark("no serial port found; `--device emulated` needs none");
        }
        context.print(&ports, || {
            let mut table = Table::new(&["port", "likely", "description", "usb serial"]);
            for port in &ports {
                table.row([
                    port.name.clone(),
                    if port.likely { "yes" } else { "" }.to_owned(),
                    port.description.clone(),
                    port.usb_serial.clone().unwrap_or_default(),
                ]);
            }
            table.to_string()
        })
    }
}
