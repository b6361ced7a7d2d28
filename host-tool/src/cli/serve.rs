//! `calib serve`: the page for the bench laptop or a tablet.

use super::laboratory_key::{self, Password};
use super::{Context, certificate, measure};
use calib_certificate::Particulars;
use calib_host::Result;
use calib_host::serve::{Options, Server};
use clap::Args;
use jiff::Timestamp;
use schemars::JsonSchema;
use serde::Serialize;
use std::io::IsTerminal;
use std::net::SocketAddr;
use std::path::PathBuf;
use std::sync::Arc;

/// `calib serve`.
#[derive(Debug, Args)]
pub(crate) struct Serve {
    /// Address to listen on. Beyond loopback the page asks for a token, which is part
    /// of the printed address.
    #[arg(long, value_name = "ADDRESS:PORT", default_value = "127.0.0.1:8160")]
    listen: SocketAddr,
    /// TOML file of the laboratory, for certificates [default:
    /// calib/laboratory.toml in the user's configuration directory, if there].
    #[arg(long, env = "CALIB_LABORATORY", value_name = "FILE")]
    laboratory: Option<PathBuf>,
    /// Signs the PDF and DCC that the page gives out, and the logbook's journal, with the laboratory's key, a
    /// PKCS#12 file [default: that of `calib config key`].
    #[arg(long, env = "CALIB_LABORATORY_KEY", value_name = "FILE")]
    sign: Option<PathBuf>,
    #[command(flatten)]
    password: Password,
    /// Does not open the browser. Without this it is opened when a person starts this in a terminal.
    #[arg(long)]
    no_browser: bool,
}

#[derive(Serialize, JsonSchema)]
pub(super) struct Listening {
    url: String,
}

impl Serve {
    /// Serves the page until Ctrl-C, which stops a run.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let laboratory = certificate::laboratory_file(self.laboratory);
        let particulars = Vec::from_iter(laboratory);
        // A mistake in it is told now, not when a certificate is wanted.
        Particulars::read(&particulars)?;
        let key = laboratory_key::file(self.sign.as_deref(), context)
            .map(|path| self.password.open(&path, Timestamp::now()).map(Arc::new));
        let server = Server::listen(Options {
            listen: self.listen,
            device: context.device.clone(),
            logbook: context.logbook_path(),
            particulars,
            key: key.transpose()?,
        })?;
        let listening = Listening { url: server.url() };
        context.print(&listening, || listening.url.clone())?;
        let opens = !self.no_browser && std::io::stdout().is_terminal();
        if !opens || opener::open_browser(&listening.url).is_err() {
            context.remark("open this address in a browser");
        }
        context.remark("Ctrl-C ends it and stops a run");
        let stop = measure::stop_on_interrupt(context);
        server.serve(|| stop().is_continue())
    }
}
