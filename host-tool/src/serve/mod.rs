//! The local web page: start, watch and stop a calibration from a browser.
//!
//! | file | idea |
//! |---|---|
//! | `calibrator_side` | the thread that alone speaks to the calibrator |
//! | `view` | what every page sees, and how it learns of changes |
//! | `waveforms` | what the inputs look like during a run |
//! | `access` | who may come in |
//! | `routes` | requests |
//! | `asked` | what a page asks to be measured |
//! | `documents` | certificates |
//! | `events` | the stream of changes |
//! | `assets`, `page/` | HTML, style and script, without a build step |
//!
//! Pages come and go; the calibration belongs to none of them. Two pages see the
//! same, and any of them stops it.

mod access;
mod asked;
mod assets;
mod calibrator_side;
mod documents;
mod events;
mod options;
mod routes;
mod view;
mod waveforms;

pub use access::Access;
pub use calibrator_side::Order;
pub use options::Options;
pub use view::{Link, RunView, Snapshot};
pub use waveforms::Waveforms;

use crate::{Error, Result};
use calibrator_side::CalibratorSide;
use std::net::TcpListener;
use std::time::Duration;

/// A page that is being listened for.
pub struct Server {
    listener: TcpListener,
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
        Ok(Self {
            listener,
            access: Access::new(address),
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
        if let Some(device) = self.options.device.clone() {
            side.order(Order::Connect { device });
        }
        let runtime = tokio::runtime::Builder::new_current_thread()
            .enable_all()
            .build()
            .map_err(failed)?;
        let app = routes::router(side.handle(), self.access, self.options);
        let served = runtime.block_on(async {
            let listener = tokio::net::TcpListener::from_std(self.listener)?;
            let end = async {
                while goes_on() {
                    tokio::time::sleep(Duration::from_millis(100)).await;
                }
            };
            // Open streams of events would keep a graceful end waiting for ever.
            tokio::select! {
                served = async { axum::serve(listener, app).await } => served,
                () = end => Ok(()),
            }
        });
        side.end();
        served.map_err(failed)
    }
}
