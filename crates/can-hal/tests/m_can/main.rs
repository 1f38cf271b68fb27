//! The numbered procedures and printed examples of the M_CAN User's Manual, revision 3.3.1, carried out with the HAL on
//! the model. Each test names its section.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod bench;
mod examples;
mod modes;
mod rx;
mod timestamps;
mod tx;
