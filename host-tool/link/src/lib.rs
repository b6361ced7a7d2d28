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
//! The client never looks at a clock but the one of its transport, which has the time of the link. So the
//! same code runs against hardware and in the virtual time of a twin, and every request ends: whatever
//! comes, by one deadline. A [`StopSwitch`] is heeded ahead of any answer that is waited for.

#![forbid(unsafe_code)]

mod address;
pub mod capture;
mod client;
mod error;
mod exchange;
pub mod port;
mod serial;
pub mod session;
mod stop_switch;
mod tcp;
mod transport;

pub use address::Address;
pub use client::{Chunk, Client, RetryPolicy};
pub use error::{Error, LinkError, ProtocolError, Refused, Result};
pub use serial::SerialTransport;
pub use stop_switch::{STOP_ALARM, StopSwitch};
pub use tcp::TcpTransport;
pub use transport::{Transport, since_start};
