//! Sizes of the record area and the form of its items.
//!
//! | bytes of an item | content |
//! |---|---|
//! | 2 | u16 LE: [`RECORD_ITEM`] or [`STATE_ITEM`] |
//! | n | [`stored`] record, of any version, or [`State`](super::State) |

use calib_protocol::stored;
use calib_protocol::stored_point::LONGEST_HEADINGS;

/// Sectors of the record area.
pub const SECTORS: usize = 8;
/// Longest item, and longest record as hosts get it: the most points with the
/// fullest settings.
pub const MAX_ITEM: usize = 24 * 1024;

/// Mark of a record in its stored form; its body says of which version it is.
pub(super) const RECORD_ITEM: u16 = 0x0001;
/// Mark of a [`State`](super::State), version 2.
pub(super) const STATE_ITEM: u16 = 0x8002;
/// Mark of a [`State`](super::State), version 1: read, and written no more.
pub(super) const STATE_ITEM_1: u16 = 0x8001;
/// Where the body of a record is put together: behind mark and head.
pub(super) const BODY_AT: usize = 2 + stored::MAX_HEAD;
/// Bytes of a record that are neither points nor settings, at most.
pub(super) const LONGEST_HEAD: usize = 960 + LONGEST_HEADINGS;
/// Bytes of an item that hold what the list says of a record, at most: mark, stored head, version and
/// head of the record.
pub(super) const LONGEST_LISTED: usize = 2 + stored::MAX_HEAD + 2 + 400;
