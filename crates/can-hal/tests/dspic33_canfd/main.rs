//! The dsPIC33 CAN FD module through the HAL: the manual's examples and procedures, each named after its place there.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod bench;
mod examples;
mod modes;
mod rx;
mod tx;
