//! Library for every program that talks to a calibrator: link, session, capture.
//!
//! ```text
//!                 Address -> Transport (serial | tcp | any other)
//!                       |
//!                    Client: request -> answer with the same sequence number
//!                       |            retries, resynchronisation, typed errors
//!              session: run, follow, download
//!              capture: waveforms, and what is in them
//! ```
//!
//! The client never looks at a clock: a transport says when a timeout is over.
//! So the same code runs against hardware and in the virtual time of a twin.

#![forbid(unsafe_code)]

mod address;
pub mod capture;
mod client;
mod error;
mod exchange;
pub mod port;
mod serial;
pub mod session;
mod tcp;
mod transport;

pub use address::Address;
pub use client::{Chunk, Client, RetryPolicy};
pub use error::{Error, LinkError, ProtocolError, Refused, Result};
pub use serial::SerialTransport;
pub use tcp::TcpTransport;
pub use transport::{Transport, pause_as_nothing};
