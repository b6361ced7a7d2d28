//! `calib serve`: the page for the bench laptop or a tablet.

use super::{Context, run};
use calib_host::Result;
use calib_host::serve::{Options, Server};
use clap::Args;
use serde::Serialize;
use std::net::SocketAddr;

/// `calib serve`.
#[derive(Debug, Args)]
pub(crate) struct Serve {
    /// Where to listen. Anything but loopback is asked for a token, which is part
    /// of the address that is printed.
    #[arg(long, value_name = "ADDRESS:PORT", default_value = "127.0.0.1:8160")]
    listen: SocketAddr,
}

#[derive(Serialize)]
struct Listening {
    url: String,
}

impl Serve {
    /// Serves the page until Ctrl-C, which stops a run.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let server = Server::listen(Options {
            listen: self.listen,
            device: context.device.clone(),
            bench: context.bench_path(),
        })?;
        let listening = Listening { url: server.url() };
        context.print(&listening, || listening.url.clone())?;
        context.remark("open this address in a browser; Ctrl-C ends it and stops a run");
        let stop = run::stop_on_interrupt();
        server.serve(|| stop().is_continue())
    }
}
