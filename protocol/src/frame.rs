//! Frames: COBS, sequence number, CRC-32.

/// Version of frames, messages and records together. Peers with another
/// number refuse each other instead of misreading bytes.
pub const PROTOCOL_VERSION: u16 = 1;

/// Longest message, in bytes, before sequence number, checksum and COBS.
pub const MAX_MESSAGE: usize = 4096;

/// Longest frame on the wire, with COBS overhead and terminator.
pub const MAX_FRAME: usize = cobs::max_encoding_length(MAX_MESSAGE + 6) + 1;
