//! See `calib_tests::hostile::files::rig`.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| calib_tests::hostile::files::rig(data));
