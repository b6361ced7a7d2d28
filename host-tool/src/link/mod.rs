//! The link to a calibrator: transport, requests and answers.
//!
//! ```text
//!                 Transport (serial | tcp | emulated, over either link | any other)
//!                       |
//!                    Client: request -> answer with the same sequence number
//!                       |            retries, resynchronisation, typed errors
//!                    session, download, command line
//! ```
//!
//! The client never looks at a clock: a transport says when a timeout is over.
//! So the same code runs against hardware and in the virtual time of a twin.

mod client;
mod emulated;
mod emulated_usb;
mod error;
mod exchange;
pub mod port;
mod serial;
mod tcp;
mod transport;

pub use client::{Chunk, Client, RetryPolicy};
pub use emulated::EmulatedTransport;
pub use emulated_usb::EmulatedUsbTransport;
pub use error::{LinkError, ProtocolError, Refused};
pub use serial::SerialTransport;
pub use tcp::TcpTransport;
pub use transport::Transport;
