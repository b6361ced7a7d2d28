//! Bytes that are no usable TEDS.

/// Why bytes are no TEDS this tool can use.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum TedsError {
    /// It ends in the middle of a value.
    #[error("ends in the middle of a value")]
    Short,
    /// The manufacturer's number is reserved.
    #[error("has a manufacturer's number that the standard reserves: {0}")]
    Manufacturer(u32),
    /// No standard template follows the basic TEDS.
    #[error("has no standard template behind the basic TEDS")]
    NoTemplate,
    /// Another template.
    #[error("uses template {0}, only 25 (accelerometer, constant current) is known here")]
    Template(u32),
    /// Template 25 of a force transducer.
    #[error("describes a force transducer")]
    Force,
    /// A transducer with switchable sensitivity.
    #[error("describes a transducer with switchable sensitivity: enter the one in use by hand")]
    Switchable,
}
