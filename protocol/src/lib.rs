//! Wire messages and stored records: one definition for firmware and host.
//!
//! | layer | form |
//! |---|---|
//! | message | [`message::Request`], [`message::Response`], postcard |
//! | frame | `COBS(sequence u16 LE, message, CRC-32 LE)`, ended by 0x00 |
//! | link | USART3 of the ST-LINK at 115 200 baud, or USB CDC-ACM |
//!
//! A host asks, the device answers with the same sequence number; the device
//! never speaks unasked, so a host that does not read blocks nobody.
#![cfg_attr(not(test), no_std)]
#![forbid(unsafe_code)]

pub mod calibration;
pub mod capture;
pub mod change;
pub mod clock;
mod envelope;
pub mod error;
pub mod form1;
pub mod frame;
pub mod head;
pub mod health;
pub mod kind;
pub mod lists;
pub mod message;
pub mod provenance;
pub mod record;
pub mod sections;
pub mod settings_form;
pub mod signature;
pub mod stored;
pub mod stored_point;
pub mod text;
pub mod update;
