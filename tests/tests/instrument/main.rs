//! The shipping image on the emulated board, behaviour by behaviour; and the images of the other
//! boards, as far as a board decides.
//!
//! One program, so that it is linked once and its tests share the cores; what waits in real time, for
//! a process or a browser, is in programs of its own beside it.

mod adjust;
mod alignment;
mod board;
mod board_faults;
mod boards;
mod broadband;
mod capture;
mod coverage;
mod degraded;
mod execution;
mod first_light;
mod fuzz_smoke;
mod gap_loop;
mod healthy_rigs;
mod hitl;
mod hostile_hosts;
mod hum;
mod image;
mod kinds;
mod lease;
mod lone;
mod power_cut;
mod reality;
mod reference_change;
mod refusals;
mod selfcheck;
mod selftest;
mod settings_hand;
mod signature;
mod site_faults;
mod torn_flash;
mod update;
mod usb;
