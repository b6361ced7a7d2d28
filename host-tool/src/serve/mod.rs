//! The local web page: start, watch and stop a calibration from a browser.
//!
//! | file | idea |
//! |---|---|
//! | `calibrator_side` | the thread that alone speaks to the calibrator |
//! | `handle` | what requests hold of it |
//! | `stops` | a stop: for which run, and what became of it |
//! | `keeper` | the thread that enters records into the logbook |
//! | `view` | what every page sees, and how it learns of changes |
//! | `waveforms` | what the inputs look like during a run |
//! | `access` | who may come in |
//! | `routes` | requests |
//! | `asked` | what a page asks to be measured |
//! | `documents` | certificates |
//! | `live` | the one channel of each page: changes to it, stops from it |
//! | `connections` | how many, and for how long |
//! | `assets`, `page/` | HTML, style and script, without a build step |
//!
//! Stops have a port and a thread of their own, which do nothing else: a page's other
//! requests, a flood of connections or a locked logbook are in nobody's way there.
//!
//! Pages come and go; the calibration belongs to none of them. Two pages see the
//! same, and any of them stops it.

mod access;
mod asked;
mod assets;
mod calibrator_side;
mod connections;
mod documents;
mod handle;
mod keeper;
mod live;
mod options;
mod routes;
mod stops;
mod view;
mod waveforms;

pub use access::Access;
pub use handle::Order;
pub use options::Options;
pub use stops::{StopState, StopView};
pub use view::{Connection, KeptListView, RunView, Snapshot};
pub use waveforms::Waveforms;

use crate::{Error, Result};
use calibrator_side::CalibratorSide;
use std::net::{SocketAddr, TcpListener};
use std::time::Duration;

/// A page that is being listened for.
pub struct Server {
    listener: TcpListener,
    /// For stops alone.
    stops: TcpListener,
    access: Access,
    options: Options,
}

impl Server {
    /// Listens.
    ///
    /// # Errors
    /// [`Error::Usage`] when the address cannot be listened on.
    pub fn listen(options: Options) -> Result<Self> {
        let refused = |error: std::io::Error| {
            Error::usage(
                format!("cannot listen on {}: {error}", options.listen),
                "choose another with --listen ADDRESS:PORT; port 0 takes any free one",
            )
        };
        let listener = TcpListener::bind(options.listen).map_err(refused)?;
        listener.set_nonblocking(true).map_err(refused)?;
        let address = listener.local_addr().map_err(refused)?;
        let stops = next_port(address).map_err(refused)?;
        stops.set_nonblocking(true).map_err(refused)?;
        let stop_port = stops.local_addr().map_err(refused)?.port();
        Ok(Self {
            listener,
            stops,
            access: Access::new(address, stop_port),
            options,
        })
    }

    /// Address for a browser; it holds the token, if one is asked for.
    pub fn url(&self) -> String {
        self.access.url()
    }

    /// Serves until `goes_on` says no; then a run is stopped, and its exciter is
    /// silent when this returns.
    ///
    /// # Errors
    /// [`Error::File`] when the system gives no more connections.
    pub fn serve(self, goes_on: impl Fn() -> bool) -> Result<()> {
        let failed = |error| Error::file("serve", "page".as_ref(), error);
        let side = CalibratorSide::start(self.options.logbook.clone());
        let handle = side.handle();
        let stop_port = self.access.stop_port();
        let key = self.options.key.as_ref();
        let signer = key.map(|key| key.certificate().subject());
        handle.shared.change(|view| {
            view.stop_port = stop_port;
            view.signer = signer;
        });
        if let Some(device) = self.options.device.clone() {
            side.order(Order::Connect { device });
        }
        let stops = routes::stops(handle.clone(), self.access.clone());
        std::thread::spawn(move || connections::serve(self.stops, stops, std::future::pending()));
        let app = routes::router(handle, self.access, self.options);
        let served = connections::serve(self.listener, app, async {
            while goes_on() {
                tokio::time::sleep(Duration::from_millis(100)).await;
            }
        });
        side.end();
        served.map_err(failed)
    }
}

/// The port after the page's, which a firewall's rule can name, or any that is free.
fn next_port(page: SocketAddr) -> std::io::Result<TcpListener> {
    let next = page.port().checked_add(1).unwrap_or(0);
    TcpListener::bind((page.ip(), next)).or_else(|_| TcpListener::bind((page.ip(), 0)))
}
