//! A small SCPI: the calibrator as other instruments are spoken to.
//!
//! Lines of ASCII ended by LF, as on every serial instrument. One point at a
//! time: configure, initiate, wait with `*OPC?`, fetch. Lists, settings and
//! records are the business of the binary protocol on the same link.
//!
//! | command | answer |
//! |---|---|
//! | `*IDN?` | maker, model, serial number, firmware |
//! | `*RST` | stops a run; 160 Hz, 10 m/s2 |
//! | `*CLS`, `*ESR?`, `SYSTem:ERRor?` | status and errors of IEEE 488.2 and SCPI-99 |
//! | `*OPC`, `*OPC?` | when no run is going on |
//! | `*TST?` | 0, or the number of the first line of the self-test that failed, or -1 if it was not carried out |
//! | `SYSTem:VERSion?` | 1999.0 |
//! | `CONFigure:FREQuency`, `CONFigure:ACCeleration`, and both with `?` | Hz; m/s2 r.m.s. |
//! | `INITiate` | begins the run |
//! | `ABORt` | ends it; the exciter is silent |
//! | `FETCh:SENSitivity?` | V/(m/s2); 9.91E37 when there is none |
//! | `FETCh:PHASe?` | degrees |
//! | `FETCh:UNCertainty?` | expanded uncertainty of the sensitivity, V/(m/s2) |
//! | `FETCh:VERDict?` | `PASS`, or `REFUSED` and the reason |
//! | `MMEMory:CATalog?` | bytes used, 0, and of each record number, kind, bytes |
//!
//! # Source
//! Command set and number forms of SCPI-99 and IEEE 488.2 as instruments of many
//! makers document them; the texts of the standards were not at hand.

mod console;
mod errors;
mod header;
mod session;
#[cfg(test)]
mod tests;

pub use console::Console;
pub use errors::ScpiError;
pub use session::{Answer, Session};
