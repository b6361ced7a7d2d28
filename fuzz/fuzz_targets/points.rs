//! See `calib_tests::hostile::files::points`.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| calib_tests::hostile::files::points(data));
