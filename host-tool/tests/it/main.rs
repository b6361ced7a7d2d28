//! The host tool against a calibrator in memory: a device that speaks the real
//! protocol over a link that can damage, lose and add any byte.

mod amended;
mod bad_input;
mod capture;
mod certificate;
mod command_line;
mod device;
mod documentation;
mod download;
mod forged;
mod gap;
mod hostile;
mod killed;
mod lake;
mod link;
mod logbook;
mod logbook_cut;
mod logbook_forged;
mod logbook_sealed;
mod memory_link;
mod odd_use;
mod python;
mod reference;
mod refusals;
mod run;
mod schema;
mod serve;
mod signed;

/// Arguments of a command line that has no quotes.
fn words(line: &str) -> Vec<&str> {
    line.split(' ').collect()
}
