//! The logbook: what a laboratory keeps, in one SQLite file.
//!
//! | file | idea |
//! |---|---|
//! | `store` | opening, versions of the form, errors in words |
//! | `schema.sql` | the tables, form 1 |
//! | `form2.sql` ... | what makes a later form of the one before |
//! | `sensors` | devices under test: what nobody wants to type twice |
//! | `records` | records as downloaded, with what lists and drift need |
//! | `issue` | a certificate about to be entered, and what it is made of |
//! | `certificates` | what was issued: numbered, never changed |
//! | `signed_files` | signed files of them, and who signed |
//! | `amendments` | which certificate took the place of which, and of what records they are |
//! | `check_standards` | sensors that are measured to watch the calibrator |
//! | `self_checks` | checks of an instrument's reference by reciprocity |
//! | `people` | operators and instruments, as records name them |
//! | `history` | drift of one sensor with its uncertainty |
//! | `waiting` | records that wait while another program holds the file |
//! | `keys` | keys of instruments, and what speaks against a new record |
//! | `journal` | sums of what was entered, chained |
//! | `seals` | the laboratory's signatures on them |
//! | `merge` | copies, and two logbooks made one |
//! | `inspect` | every sum and number checked again |
//! | `row` | a row of any table as bytes |
//! | `table`, `parquet` | the whole logbook for other programs |
//! | `lake`, `lake_tables` | what it adds to a lake of many laboratories |

mod amendments;
mod certificates;
mod check_standards;
mod history;
mod inspect;
mod issue;
mod journal;
mod keys;
mod lake;
mod lake_tables;
mod merge;
mod parquet;
mod people;
mod records;
mod row;
mod seals;
mod self_checks;
mod sensors;
mod signed_files;
mod store;
mod table;
pub mod waiting;

pub use certificates::Issued;
pub use check_standards::{Certified, CheckStandard};
pub use history::{History, Result as HistoryResult};
pub use issue::{Issue, Joined, Role, Sources};
pub use keys::{InstrumentKey, Series};
pub use lake::{Addition, add_to_lake};
pub use merge::Merged;
pub use parquet::export;
pub use people::{Instrument, Operator};
pub use records::{Filter, Kept, Listed};
pub use seals::Seal;
pub use self_checks::SelfCheck;
pub use sensors::{Sensor, TWICE};
pub use signed_files::{Signed, SignedFile};
pub use store::{Logbook, default_path};
