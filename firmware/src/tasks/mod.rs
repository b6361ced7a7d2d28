//! Tasks: they carry values from one place to the next and hold no metrology.
//!
//! | task | executor | from | to |
//! |---|---|---|---|
//! | acquire | converter | DMA ring of the ADCs | blocks |
//! | drive | converter | drive commands | DMA ring of the DAC |
//! | measure | metrology | blocks, orders | drive commands, results |
//! | store | thread | ended runs | archive |
//! | serial_link, usb_link | thread | bytes of a host | answers |
//! | thermometer | thread | sensor in the processor | status, orders |
//! | timebase | thread | frames of a USB host | deviation of the clock |
//! | supervise | thread | button, heartbeats | lamps, orders, watchdog |
//!
//! The converter executor interrupts the metrology executor, which interrupts
//! the thread: a slow answer to a host delays no block, and a hung measurement
//! still ends in silence.

pub(crate) mod acquire;
pub(crate) mod drive;
pub(crate) mod link;
pub(crate) mod measure;
pub(crate) mod store;
pub(crate) mod supervise;
pub(crate) mod thermometer;
pub(crate) mod timebase;
