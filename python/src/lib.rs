//! `calib._calib`: the verbs of the tool for Python. What they are to a Python programmer is written in Python,
//! in `calib/`; this crate carries words in and documents out, and knows no verb by name.

// An extension module is linked by the interpreter that loads it, which a test of this crate is not: tests of
// the module are `tests/*.py`.
#[cfg(not(test))]
mod module;
mod work;
