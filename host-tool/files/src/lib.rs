//! Files that people give and get, and complaints with the way out.
//!
//! | module | idea |
//! |---|---|
//! | [`text`] | text that people write: what is wrong with it is named by its line |
//! | [`file`] | a file that is either there and whole, or not there |
//! | [`set`] | files of which all appear, or none |
//! | [`Error`] | what is wrong with a file, an input or a request, and what to do about it |
#![forbid(unsafe_code)]

mod error;
pub mod file;
pub mod set;
pub mod text;

pub use error::{Error, Result};
