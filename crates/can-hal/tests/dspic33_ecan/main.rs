//! The code examples and numbered procedures of the manual of dsPIC33F/PIC24H ECAN, DS70000185D, carried out with the HAL
//! on the model. Each test names its section; mistakes in print are corrected, and the correction is cited by its name in
//! the description's list of contradictions.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod bench;
mod configuration;
mod exchange;
mod filters;
mod interrupts;
mod modes;
mod receive;
mod transmit;
