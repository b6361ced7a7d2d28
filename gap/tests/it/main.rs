//! The diagnosis as a whole: on sealed sets, and on measured data.

#[path = "../../examples/bench_gap/case.rs"]
#[allow(dead_code)]
mod case;
mod large;
mod oscillators;
mod real_data;
#[path = "../sealed/mod.rs"]
#[allow(dead_code)]
mod sealed;
mod sealed_rates;
mod shared_data;
mod short_tables;
