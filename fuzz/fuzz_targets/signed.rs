//! See `calib_tests::hostile::files::signed`.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| calib_tests::hostile::files::signed(data));
