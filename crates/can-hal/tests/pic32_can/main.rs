//! The HAL of PIC32MX CAN on its model: the examples and procedures of the manual, and what the common suite leaves out.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod bench;
mod examples;
mod fifos;
mod filters;
mod modes;
mod procedures;
mod status;
