//! A row of any table as bytes, the same for the same values whatever SQLite's text of them is.

use rusqlite::types::ValueRef;
use rusqlite::{Connection, Row};

/// The values of a row: a letter for the type, the length, the bytes.
pub(super) fn bytes(row: &Row<'_>) -> rusqlite::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    for column in 0..row.as_ref().column_count() {
        let (kind, value) = match row.get_ref(column)? {
            ValueRef::Null => (b'n', Vec::new()),
            ValueRef::Integer(value) => (b'i', value.to_le_bytes().to_vec()),
            ValueRef::Real(value) => (b'r', value.to_bits().to_le_bytes().to_vec()),
            ValueRef::Text(value) => (b't', value.to_vec()),
            ValueRef::Blob(value) => (b'b', value.to_vec()),
        };
        bytes.push(kind);
        bytes.extend((value.len() as u64).to_le_bytes());
        bytes.extend(value);
    }
    Ok(bytes)
}

/// Name and bytes of every row; the first column names it.
pub(super) fn all(connection: &Connection, sql: &str) -> rusqlite::Result<Vec<(String, Vec<u8>)>> {
    let mut statement = connection.prepare(sql)?;
    let rows = statement.query_map([], |row| Ok((row.get(0)?, bytes(row)?)))?;
    rows.collect()
}
