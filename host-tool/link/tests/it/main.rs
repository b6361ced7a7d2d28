//! The library against links that live in a time of their own.

mod deadline;
mod files;
mod slow_link;
